// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_ARRANGEMENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_ARRANGEMENT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Cuts the triangles of a soup where they cross, touch or overlap each other, in exact arithmetic: what is left meets only in
// common edges and vertices.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/meeting_pairs.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Soup_arrangement
{
public:
  // A triangle of the soup that a face is a piece of; not turned: with the same normal.
  struct Source
  {
    int triangle;
    bool is_turned;
  };

  // Each triangle has an area, and three vertices at different places; equal places have equal indices.
  // O(n log n + pairs log pairs), with exact numbers for the triangles that meet others.
  // places: of vertices that are meant to be elsewhere.
  Soup_arrangement(const Positions& its_points, const std::vector<Triangle_indices>& triangles,
                   std::map<int, CGAL::Exact_predicates_exact_constructions_kernel::Point_3> places = {})
    : points(its_points)
    , triangles_(triangles)
    , places_(std::move(places))
    , plane_sets_(triangles.size())
  {
    const std::vector<Soup_pair> pairs = places_.empty() ? meeting_pairs(Predicate_points{points}, triangles)
                                                         : meeting_pairs(exact_points(), triangles);
    for (const auto& [v, place] : places_)
      points[v] = rounded(place);
    is_cut_.assign(triangles.size(), false);
    for (const Soup_pair& pair : pairs) {
      is_cut_[pair.first] = is_cut_[pair.second] = true;
      if (pair.is_coplanar)
        plane_sets_.unite(pair.first, pair.second);
    }
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (!is_cut_[t])
        add(triangles[t], {static_cast<int>(t), false});
    if (pairs.empty())
      return;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (is_cut_[t])
        for (int v : triangles[t])
          index_.emplace(exact(v), v);
    intersect(pairs);
    cut();
  }

  Positions points;                         // those of the soup, and places where triangles meet, rounded
  std::vector<Triangle_indices> faces;      // no two of the same three vertices
  std::vector<std::vector<Source>> sources; // of each face

private:
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_point = Exact::Point_3;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Default, CGAL::Exact_intersections_tag>;

  struct Less
  {
    bool operator()(const Exact_point& a, const Exact_point& b) const { return CGAL::compare_xyz(a, b) < 0; }
  };

  struct Exact_points
  {
    using Kernel = Exact;

    const Exact_point& operator()(int v) const { return points[v]; }

    std::vector<Exact_point> points;
  };

  Exact_points exact_points() const
  {
    Exact_points result;
    for (std::size_t v = 0; v < points.size(); ++v)
      result.points.push_back(exact(static_cast<int>(v)));
    return result;
  }

  static Vector_3 rounded(const Exact_point& p)
  {
    return Vector_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  Exact_point exact(int v) const
  {
    const auto found = places_.find(v);
    return found == places_.end() ? Exact_point(points[v][0], points[v][1], points[v][2]) : found->second;
  }

  Exact::Triangle_3 exact_triangle(int t) const
  {
    const Triangle_indices& v = triangles_[t];
    return Exact::Triangle_3(exact(v[0]), exact(v[1]), exact(v[2]));
  }

  void intersect(const std::vector<Soup_pair>& pairs)
  {
    for (const Soup_pair& pair : pairs) {
      if (pair.is_coplanar)
        continue;
      const auto found = CGAL::intersection(exact_triangle(pair.first), exact_triangle(pair.second));
      if (!found)
        continue;
      std::array<Exact_point, 2> ends;
      if (const auto* segment = aabb::get_if<Exact::Segment_3>(&*found))
        ends = {segment->source(), segment->target()};
      else if (const auto* single = aabb::get_if<Exact_point>(&*found))
        ends = {*single, *single};
      else
        continue;
      for (int t : {pair.first, pair.second})
        cuts_[plane_sets_.find(t)].push_back(ends);
    }
  }

  // All that lies in one plane and overlaps is cut together, so that pieces that coincide are the same.
  void cut()
  {
    std::map<std::size_t, std::vector<int>> groups;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_cut_[t])
        groups[plane_sets_.find(t)].push_back(static_cast<int>(t));
    for (const auto& [set, group] : groups)
      cut(group, cuts_[set]);
  }

  void cut(const std::vector<int>& group, const std::vector<std::array<Exact_point, 2>>& cuts)
  {
    const Triangle_indices& first = triangles_[group[0]];
    const Vector_3 n = (points[first[1]] - points[first[0]]).cross(points[first[2]] - points[first[0]]);
    const Exact::Plane_3 plane(exact(first[0]), exact(first[1]), exact(first[2]));
    const std::array<Exact::FT, 3> normal = {plane.a(), plane.b(), plane.c()};
    int axis = 0; // that is dropped
    n.cwiseAbs().maxCoeff(&axis);
    if (CGAL::is_zero(normal[axis])) // the triangle is so thin that rounding has its normal
      for (int d = 0; d < 3; ++d)
        if (!CGAL::is_zero(normal[d]))
          axis = d;
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    const auto flat = [&](const Exact_point& p) { return Exact::Point_2(p[x], p[y]); };
    const auto lifted = [&](const Exact::Point_2& p) {
      std::array<Exact::FT, 3> c;
      c[x] = p.x();
      c[y] = p.y();
      c[axis] = -(normal[x] * p.x() + normal[y] * p.y() + plane.d()) / normal[axis];
      return Exact_point(c[0], c[1], c[2]);
    };
    Triangulation cdt;
    std::vector<Exact::Triangle_2> of_group;
    for (int t : group) {
      const Triangle_indices& v = triangles_[t];
      const std::array<Exact::Point_2, 3> p = {flat(exact(v[0])), flat(exact(v[1])), flat(exact(v[2]))};
      for (int k = 0; k < 3; ++k)
        cdt.insert_constraint(p[k], p[(k + 1) % 3]);
      of_group.emplace_back(p[0], p[1], p[2]);
    }
    for (const auto& ends : cuts)
      if (ends[0] == ends[1])
        cdt.insert(flat(ends[0]));
      else
        cdt.insert_constraint(flat(ends[0]), flat(ends[1]));
    std::map<Triangulation::Vertex_handle, int> number;
    for (auto v : cdt.finite_vertex_handles())
      number[v] = index_of(lifted(v->point()));
    for (auto f : cdt.finite_face_handles()) {
      // positive in the plane of x and y
      const Triangle_indices face = {number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]};
      const Exact::Point_2 middle = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
      for (std::size_t i = 0; i < group.size(); ++i)
        if (of_group[i].has_on_bounded_side(middle))
          add(face, {group[i], of_group[i].orientation() == CGAL::CLOCKWISE});
    }
  }

  int index_of(const Exact_point& p)
  {
    const auto inserted = index_.emplace(p, static_cast<int>(points.size()));
    if (inserted.second)
      points.push_back(rounded(p));
    return inserted.first->second;
  }

  void add(const Triangle_indices& face, const Source& source)
  {
    if (!is_cut_[source.triangle]) { // nothing coincides with it
      faces.push_back(face);
      sources.push_back({source});
      return;
    }
    Triangle_indices key = face;
    std::sort(key.begin(), key.end());
    const auto inserted = of_vertices_.emplace(key, faces.size());
    if (inserted.second) {
      faces.push_back(face);
      sources.emplace_back();
    }
    const std::size_t f = inserted.first->second;
    sources[f].push_back({source.triangle, source.is_turned != !is_rotation(face, faces[f])});
  }

  static bool is_rotation(const Triangle_indices& a, const Triangle_indices& b)
  {
    const int k = static_cast<int>(std::find(b.begin(), b.end(), a[0]) - b.begin());
    return b[(k + 1) % 3] == a[1];
  }

  const std::vector<Triangle_indices>& triangles_;
  const std::map<int, Exact_point> places_;
  Disjoint_sets plane_sets_; // of triangles that overlap in a plane
  std::vector<char> is_cut_;
  std::map<std::size_t, std::vector<std::array<Exact_point, 2>>> cuts_; // of each set
  std::map<Exact_point, int, Less> index_;
  std::map<Triangle_indices, std::size_t> of_vertices_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_ARRANGEMENT_H
