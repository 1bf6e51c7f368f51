// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_STITCHING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_STITCHING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Makes one surface of triangles that nearly meet: borders that coincide but for rounding are merged, vertices on the
// borders of others divide these, copies go, and small holes are filled. What is closed does not change.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Soup_stitching
{
public:
  struct Hole
  {
    std::vector<int> vertices; // around it
    double size;               // diagonal of its box
    bool is_filled;
  };

  // tolerance: how far apart borders that belong together may be. largest_hole: size of holes that are filled.
  Soup_stitching(const Positions& its_points, const std::vector<Triangle_indices>& its_triangles, double tolerance,
                 double largest_hole)
    : points(its_points)
    , triangles(its_triangles)
    , origin(its_triangles.size())
    , tolerance_(tolerance)
  {
    for (std::size_t t = 0; t < origin.size(); ++t)
      origin[t] = static_cast<int>(t);
    merge_equal_points();
    clean();
    number_of_copies = copies_;
    number_without_area = without_area_;
    for (int round = 0; tolerance > 0 && round < most_rounds && !borders().empty(); ++round)
      if (!merge_borders() && !divide_borders())
        break;
    fill_holes(largest_hole);
  }

  Positions points;
  std::vector<Triangle_indices> triangles; // no two of the same vertices, each with an area
  std::vector<int> origin;                 // of each, the triangle as given; none: it fills a hole
  std::vector<Hole> holes;                 // that stitching left
  std::size_t number_of_copies = 0, number_without_area = 0, number_of_stitched = 0; // of triangles; vertices
  double farthest = 0; // that a vertex has moved, or is from an edge that it divides

  static constexpr int none = -1;

private:
  static constexpr int most_rounds = 12;

  static std::array<double, 3> key(const Vector_3& p) { return {p[0] + 0., p[1] + 0., p[2] + 0.}; } // -0 is 0

  void merge_equal_points()
  {
    std::map<std::array<double, 3>, int> first;
    std::vector<int> of(points.size());
    for (std::size_t v = 0; v < points.size(); ++v)
      of[v] = first.emplace(key(points[v]), static_cast<int>(v)).first->second;
    for (Triangle_indices& t : triangles)
      for (int& v : t)
        v = of[v];
  }

  bool has_area(const Triangle_indices& t) const
  {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    const auto p = [&](int v) { return Point(points[v][0], points[v][1], points[v][2]); };
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && !CGAL::collinear(p(t[0]), p(t[1]), p(t[2]));
  }

  // Triangles without an area go, and all but one of those with the same vertices.
  void clean()
  {
    std::vector<std::pair<Triangle_indices, std::size_t>> sorted;
    std::vector<char> is_kept(triangles.size(), true);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      is_kept[t] = has_area(triangles[t]);
      without_area_ += !is_kept[t];
      Triangle_indices vertices = triangles[t];
      std::sort(vertices.begin(), vertices.end());
      if (is_kept[t])
        sorted.emplace_back(vertices, t);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first) {
        is_kept[sorted[i].second] = false;
        ++copies_;
      }
    std::size_t n = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (is_kept[t]) {
        triangles[n] = triangles[t];
        origin[n++] = origin[t];
      }
    triangles.resize(n);
    origin.resize(n);
  }

  // Edges with one triangle.
  std::vector<Soup_side> borders() const
  {
    std::vector<Soup_side> result;
    for_soup_edges(triangles, [&](auto first, auto last) {
      if (last - first == 1)
        result.push_back(*first);
    });
    return result;
  }

  static std::vector<int> vertices_of(const std::vector<Soup_side>& sides)
  {
    std::vector<int> result;
    for (const Soup_side& s : sides)
      result.insert(result.end(), s.edge.begin(), s.edge.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<int> used_vertices() const
  {
    std::vector<int> result;
    for (const Triangle_indices& t : triangles)
      result.insert(result.end(), t.begin(), t.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  using Bin = std::array<long, 3>;
  Bin bin(const Vector_3& p, double size) const
  {
    return {std::lround(p[0] / size), std::lround(p[1] / size), std::lround(p[2] / size)};
  }

  // A vertex of a border and another one that are no farther apart than the tolerance become one. Whether there are any.
  bool merge_borders()
  {
    const std::vector<int> vertices = vertices_of(borders());
    std::map<Bin, std::vector<int>> bins;
    for (int v : used_vertices())
      bins[bin(points[v], tolerance_)].push_back(v);
    Disjoint_sets sets(points.size());
    bool any = false;
    for (int v : vertices) {
      const Bin middle = bin(points[v], tolerance_);
      for (long i = -1; i <= 1; ++i)
        for (long j = -1; j <= 1; ++j)
          for (long k = -1; k <= 1; ++k) {
            const auto found = bins.find({middle[0] + i, middle[1] + j, middle[2] + k});
            if (found == bins.end())
              continue;
            for (int u : found->second)
              if ((points[u] - points[v]).norm() <= tolerance_ && sets.find(u) != sets.find(v)) {
                farthest = (std::max)(farthest, (points[u] - points[v]).norm());
                sets.unite(u, v);
                ++number_of_stitched;
                any = true;
              }
          }
    }
    if (!any)
      return false;
    for (Triangle_indices& t : triangles)
      for (int& v : t)
        v = static_cast<int>(sets.find(v));
    clean();
    return true;
  }

  // A vertex of a border on an edge, and any vertex on an edge of a border, divides that with all of its triangles. Whether
  // there are any.
  bool divide_borders()
  {
    const std::vector<std::pair<double, int>> of_borders = along_x(vertices_of(borders())),
                                              all = along_x(used_vertices());
    std::map<int, std::map<std::array<int, 2>, std::vector<std::pair<double, int>>>> on_edges; // of each triangle
    for_soup_edges(triangles, [&](auto first, auto last) {
      const std::vector<std::pair<double, int>> inner = vertices_on(first->edge, last - first == 1 ? all : of_borders);
      number_of_stitched += inner.size();
      for (auto side = first; side != last && !inner.empty(); ++side)
        on_edges[side->triangle][side->edge] = inner;
    });
    for (const auto& [triangle, of_edges] : on_edges)
      divide(triangle, *of_edges.begin()); // other edges of the same triangle: in the next round
    clean();
    return !on_edges.empty();
  }

  std::vector<std::pair<double, int>> along_x(const std::vector<int>& vertices) const
  {
    std::vector<std::pair<double, int>> result;
    for (int v : vertices)
      result.emplace_back(points[v][0], v);
    std::sort(result.begin(), result.end());
    return result;
  }

  // With their places along it.
  std::vector<std::pair<double, int>> vertices_on(const std::array<int, 2>& edge,
                                                  const std::vector<std::pair<double, int>>& vertices)
  {
    std::vector<std::pair<double, int>> result;
    const Vector_3 &a = points[edge[0]], &b = points[edge[1]];
    const double length = (b - a).norm();
    const auto low = std::lower_bound(vertices.begin(), vertices.end(),
                                      std::make_pair((std::min)(a[0], b[0]) - tolerance_, -1));
    for (auto it = low; it != vertices.end() && it->first <= (std::max)(a[0], b[0]) + tolerance_; ++it) {
      const double s = (points[it->second] - a).dot(b - a) / (length * length);
      const double away = (points[it->second] - a - s * (b - a)).norm();
      if (s * length <= tolerance_ || (1 - s) * length <= tolerance_ || away > tolerance_)
        continue;
      result.emplace_back(s, it->second);
      farthest = (std::max)(farthest, away);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  void divide(int triangle, const std::pair<const std::array<int, 2>, std::vector<std::pair<double, int>>>& edge)
  {
    const Triangle_indices whole = triangles[triangle];
    int k = 0;
    while (whole[k] == edge.first[0] || whole[k] == edge.first[1])
      ++k;
    std::vector<int> chain = {edge.first[0]};
    for (const auto& inner : edge.second)
      chain.push_back(inner.second);
    chain.push_back(edge.first[1]);
    if (whole[(k + 1) % 3] != edge.first[0])
      std::reverse(chain.begin(), chain.end());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const Triangle_indices part = {whole[k], chain[i], chain[i + 1]};
      if (i == 0) {
        triangles[triangle] = part;
        continue;
      }
      triangles.push_back(part);
      origin.push_back(origin[triangle]);
    }
  }

  void fill_holes(double largest)
  {
    std::map<int, std::vector<int>> next;
    for (const Soup_side& s : borders()) {
      next[s.edge[0]].push_back(s.edge[1]);
      next[s.edge[1]].push_back(s.edge[0]);
    }
    const auto remove = [&](int from, int to) {
      std::vector<int>& list = next[from];
      list.erase(std::find(list.begin(), list.end(), to));
    };
    for (auto& entry : next)
      while (!entry.second.empty()) {
        std::vector<int> loop = {entry.first};
        while (
          !next[loop.back()].empty()) { // every vertex has an even number of them, or a crossing of borders is here
          const int to = next[loop.back()].back(), from = loop.back();
          remove(from, to);
          remove(to, from);
          if (to == loop.front())
            break;
          const auto seen = std::find(loop.begin(), loop.end(), to);
          if (seen != loop.end()) { // a loop within
            fill(std::vector<int>(seen, loop.end()), largest);
            loop.erase(seen + 1, loop.end());
          }
          else
            loop.push_back(to);
        }
        fill(loop, largest);
      }
  }

  void fill(const std::vector<int>& loop, double largest)
  {
    Eigen::AlignedBox3d box;
    for (int v : loop)
      box.extend(points[v]);
    holes.push_back({loop, box.diagonal().norm(), false});
    if (loop.size() < 3 || holes.back().size > largest)
      return;
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::vector<Point> polyline;
    for (int v : loop)
      polyline.emplace_back(points[v][0], points[v][1], points[v][2]);
    polyline.push_back(polyline.front());
    std::vector<CGAL::Triple<int, int, int>> patch;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(patch));
    for (const auto& t : patch) {
      triangles.push_back({loop[t.first], loop[t.second], loop[t.third]});
      origin.push_back(none);
    }
    holes.back().is_filled = !patch.empty();
  }

  const double tolerance_;
  std::size_t copies_ = 0, without_area_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_STITCHING_H
