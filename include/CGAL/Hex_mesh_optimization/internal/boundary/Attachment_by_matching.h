// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Attachment to a reference of its own: every corner takes the nearest boundary
// vertex, every curve the shortest path of boundary edges that follows it, and
// curves that want the same vertices come to terms.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Attachment_by_matching
{
public:
  // end: only vertices of the surface before it, and curves through them, are matched
  Attachment_by_matching(const Hexahedral_complex& complex, const Positions& points, const Reference_surface& surface,
                         int end = (std::numeric_limits<int>::max)())
    : attachment(complex)
    , complex_(complex)
    , points_(points)
    , surface_(surface)
  {
    std::vector<int> directed; // edges of the boundary
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      directed.push_back(2 * e.edge);
      directed.push_back(2 * e.edge + 1);
    }
    leaving_ = Grouped_array(
      complex.number_of_vertices(), directed.size(), [&](std::size_t k) { return head(directed[k] ^ 1); },
      [&](std::size_t k) { return directed[k]; });
    for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
      for (int k = 0; k < 4; ++k)
        turns_.push_back(turn(complex.find_edge(f.vertices[k], f.vertices[(k + 1) % 4]),
                              complex.find_edge(f.vertices[(k + 1) % 4], f.vertices[(k + 2) % 4])));
    std::sort(turns_.begin(), turns_.end());
    std::vector<int> vertex_of(surface.points.size(), -1);
    attach_corners(end, vertex_of);
    std::vector<Path> paths;
    for (std::size_t c = 0; c < surface.curves.size(); ++c)
      if (surface.curves[c]->vertices.front() < end) {
        std::vector<int> stations = stations_of(*surface.curves[c], vertex_of);
        if (!stations.empty())
          paths.push_back({static_cast<int>(c), std::move(stations), {}});
      }
    users_.resize(points.size(), 0);
    disputes_.resize(points.size(), 0);
    cost_.resize(2 * complex.edges.size(), std::numeric_limits<double>::infinity());
    previous_.resize(2 * complex.edges.size(), -1);
    negotiate(paths);
    attach(paths);
  }

  Boundary_attachment attachment;

private:
  struct Path
  {
    int curve;
    std::vector<int> stations, vertices; // no vertices: none was found
  };

  // A path and its curve differ in length by no more than this factor.
  static constexpr double most_detour = 2;
  // No edge of a path is farther from the curve, in its own lengths.
  static constexpr double farthest = 2;
  // What an edge costs more, in its own lengths, when it is its own length away from the curve.
  static constexpr double cost_of_leaving = 10;
  // An open curve that is so much longer than its ends are apart is followed by way of others of its places: the
  // shortest path between its ends is another way round.
  static constexpr double bent = 3;
  // What an edge costs more, in its own lengths, when it goes on from the one before within one face while the curve goes
  // straight on: the corner of this face would be flat (measured on a CAD part with all on its reference: its minimum is
  // .40 instead of .18, and of 3 as of 0; at 30, detours cost the average .01 in the default).
  static constexpr double cost_of_flat_corner = 10;
  // What an edge costs more, in its own lengths, when another curve uses the vertex that it leads to: in each round by
  // a factor more; and for each round in which that was so before.
  static constexpr int rounds = 20;
  static constexpr double cost_of_sharing = 1;
  static constexpr double growth_of_cost = 1.3;
  static constexpr double cost_of_dispute = .5;

  double mean_edge_around(int v) const
  {
    double sum = 0;
    for (int e : leaving_[v])
      sum += length(e);
    return leaving_[v].size() ? sum / double(leaving_[v].size()) : 0;
  }

  // Farther than its own edges a vertex does not represent a corner.
  int nearest_free_vertex(const Vector_3& place) const
  {
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (attachment.kind[v] == Vertex_kind::SURFACE && (points_[v] - place).squaredNorm() < nearest) {
        nearest = (points_[v] - place).squaredNorm();
        best = static_cast<int>(v);
      }
    return best >= 0 && std::sqrt(nearest) <= mean_edge_around(best) ? best : -1;
  }

  // The nearest pairs first: a vertex that two corners want goes to the one that it is nearer to. O(corners · vertices).
  void attach_corners(int end, std::vector<int>& vertex_of)
  {
    using Pair = std::tuple<double, int, int>; // distance, corner, vertex
    std::priority_queue<Pair, std::vector<Pair>, std::greater<Pair>> pairs;
    const auto propose = [&](int corner) {
      const int v = nearest_free_vertex(surface_.points[corner]);
      if (v >= 0)
        pairs.emplace((points_[v] - surface_.points[corner]).norm(), corner, v);
    };
    for (int corner : surface_.corners)
      if (corner < end)
        propose(corner);
    while (!pairs.empty()) {
      const auto [distance, corner, v] = pairs.top();
      pairs.pop();
      if (attachment.kind[v] != Vertex_kind::SURFACE)
        propose(corner);
      else {
        vertex_of[corner] = v;
        attachment.to_corner(v, surface_, corner);
      }
    }
  }

  // The vertices that a path along the curve has to pass, the ends among them; none if they cannot be told. A closed
  // curve is followed from a third of its length to the next.
  std::vector<int> stations_of(const Feature_curve& curve, const std::vector<int>& vertex_of) const
  {
    const std::vector<int>& v = curve.vertices;
    const std::size_t n = v.size() - 1;
    std::vector<int> stations;
    const auto add_nearest = [&](std::size_t k) {
      stations.push_back(nearest_free_vertex(surface_.points[v[k * n / 3]]));
    };
    if (curve.is_closed()) {
      for (std::size_t k = 0; k < 3; ++k)
        add_nearest(k);
      stations.push_back(stations.front());
    }
    else {
      stations.push_back(vertex_of[v.front()]);
      if (curve.length > bent * (surface_.points[v.front()] - surface_.points[v.back()]).norm())
        for (std::size_t k = 1; k < 3; ++k)
          add_nearest(k);
      stations.push_back(vertex_of[v.back()]);
    }
    for (std::size_t k = 0; k + 1 < stations.size(); ++k)
      if (stations[k] < 0 || stations[k + 1] < 0 || stations[k] == stations[k + 1])
        return {};
    return stations;
  }

  // Each time that paths share vertices, those that do look for others, as what is in demand gets more expensive: it is
  // left to the curve that has no other way (L. McMurchie, C. Ebeling, PathFinder, 1995). O(rounds · paths · edges near
  // a curve · log) at the worst; where no two meet, once.
  void negotiate(std::vector<Path>& paths)
  {
    for (int round = 0; round < rounds; ++round) {
      bool any = false;
      for (Path& path : paths)
        if (round == 0 || is_shared(path)) {
          any = true;
          find(path);
        }
      if (!any)
        return;
      for (std::size_t v = 0; v < users_.size(); ++v)
        if (users_[v] > 1)
          ++disputes_[v];
      sharing_ *= growth_of_cost;
    }
  }

  // Those that agree first; each of the others takes what is left.
  void attach(std::vector<Path>& paths)
  {
    std::vector<Path*> others;
    for (Path& path : paths)
      if (is_shared(path))
        others.push_back(&path);
      else
        attachment.to_curve(complex_, path.vertices, path.curve);
    for (Path* path : others) {
      find(*path);
      attachment.to_curve(complex_, path->vertices, path->curve);
    }
  }

  // Calls visit(vertex) for those that are the path's alone: all but the corners at its ends. Where a closed one begins
  // it ends too, which is once.
  template <class Visit>
  void for_own_vertices(const Path& path, const Visit& visit) const
  {
    for (std::size_t i = 0; i < path.vertices.size(); ++i)
      if (attachment.kind[path.vertices[i]] != Vertex_kind::CORNER &&
          (i == 0 || path.vertices[i] != path.vertices.front()))
        visit(path.vertices[i]);
  }

  bool is_shared(const Path& path) const
  {
    bool result = false;
    for_own_vertices(path, [&](int v) { result = result || users_[v] > 1; });
    return result;
  }

  // Looks for a new way past the stations.
  void find(Path& path)
  {
    for_own_vertices(path, [&](int v) { --users_[v]; });
    path.vertices = path_of(*surface_.curves[path.curve], path.stations);
    for_own_vertices(path, [&](int v) { ++users_[v]; });
  }

  std::vector<int> path_of(const Feature_curve& curve, const std::vector<int>& stations)
  {
    std::vector<int> path;
    double length = 0;
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
      const std::vector<int> part = follow(curve, stations[k], stations[k + 1]);
      if (part.empty())
        return part;
      for (std::size_t i = 0; i + 1 < part.size(); ++i)
        length += (points_[part[i + 1]] - points_[part[i]]).norm();
      path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
    }
    // a path that takes another way round is no match
    if (length > most_detour * curve.length || most_detour * length < curve.length)
      path.clear();
    return path;
  }

  // Dijkstra's algorithm from edge to edge of the boundary: what one costs depends on the one before.
  std::vector<int> follow(const Feature_curve& curve, int from, int to)
  {
    using Entry = std::pair<double, int>; // cost, directed edge
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<int> reached;
    const auto go_on = [&](int before, double cost) {
      for (int e : leaving_[before < 0 ? from : head(before)]) {
        const int u = head(e);
        if (e == (before ^ 1) || (attachment.kind[u] != Vertex_kind::SURFACE && u != to) || length(e) == 0)
          continue;
        const Curve_point q = curve.closest_point(middle(e));
        const double off = (q.point - middle(e)).norm() / length(e);
        if (off > farthest)
          continue;
        const double disputed = u == to ? 0 : sharing_ * users_[u] + cost_of_dispute * disputes_[u];
        const double flat = before >= 0 && is_turn(before, e)
                              ? std::abs(curve.closest_point(middle(before)).tangent.dot(q.tangent))
                              : 0;
        const double next = cost +
                            length(e) * (1 + cost_of_leaving * off * off + disputed + cost_of_flat_corner * flat);
        if (next < cost_[e]) {
          reached.push_back(e);
          cost_[e] = next;
          previous_[e] = before;
          queue.emplace(next, e);
        }
      }
    };
    go_on(-1, 0);
    while (!queue.empty() && head(queue.top().second) != to) {
      const auto [cost, e] = queue.top();
      queue.pop();
      if (!(cost > cost_[e]))
        go_on(e, cost);
    }
    std::vector<int> path;
    if (!queue.empty()) {
      for (int e = queue.top().second; e != -1; e = previous_[e])
        path.push_back(head(e));
      path.push_back(from);
    }
    std::reverse(path.begin(), path.end());
    for (int e : reached) {
      cost_[e] = std::numeric_limits<double>::infinity();
      previous_[e] = -1;
    }
    return path;
  }

  int head(int directed) const { return complex_.edges[directed / 2][1 - directed % 2]; }

  double length(int directed) const { return (points_[head(directed)] - points_[head(directed ^ 1)]).norm(); }

  Vector_3 middle(int directed) const { return (points_[head(directed)] + points_[head(directed ^ 1)]) / 2; }

  // The ways round a corner of a face, in both directions the same.
  static std::pair<int, int> turn(int directed, int next) { return std::minmax(directed / 2, next / 2); }

  bool is_turn(int directed, int next) const
  {
    return std::binary_search(turns_.begin(), turns_.end(), turn(directed, next));
  }

  const Hexahedral_complex& complex_;
  const Positions& points_;
  const Reference_surface& surface_;
  Grouped_array leaving_;                  // directed edges of the boundary, by the vertex that they leave
  std::vector<std::pair<int, int>> turns_; // pairs of edges with a corner of a face between them
  std::vector<int> users_, disputes_;      // of each vertex: paths, and rounds in which there were several
  double sharing_ = cost_of_sharing;
  std::vector<double> cost_; // of the way up to each directed edge, and along it; infinite between searches
  std::vector<int> previous_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H
