// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H

// Attachment to a reference of its own: every corner takes the nearest boundary
// vertex, every curve the shortest path of boundary edges that follows it.

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
    std::vector<int> ends;
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      ends.push_back(complex.edges[e.edge][0]);
      ends.push_back(complex.edges[e.edge][1]);
    }
    neighbors_ = Grouped_array(
      complex.number_of_vertices(), ends.size(), [&](std::size_t k) { return ends[k]; },
      [&](std::size_t k) { return ends[k ^ 1]; });
    std::vector<int> vertex_of(surface.points.size(), -1);
    for (int corner : surface.corners) {
      if (corner >= end)
        continue;
      const int v = nearest_free_vertex(surface.points[corner]);
      if (v < 0)
        continue;
      vertex_of[corner] = v;
      attachment.to_corner(v, surface, corner);
    }
    for (std::size_t c = 0; c < surface.curves.size(); ++c)
      if (surface.curves[c]->vertices.front() < end)
        match(static_cast<int>(c), vertex_of);
  }

  Boundary_attachment attachment;

private:
  // A path and its curve differ in length by no more than this factor.
  static constexpr double most_detour = 2;
  // No edge of a path is farther from the curve, in its own lengths.
  static constexpr double farthest = 2;
  // What an edge costs more, in its own lengths, when it is its own length away from the curve.
  static constexpr double cost_of_leaving = 10;

  double mean_edge_around(int v) const
  {
    double sum = 0;
    for (int u : neighbors_[v])
      sum += (points_[u] - points_[v]).norm();
    return neighbors_[v].size() ? sum / double(neighbors_[v].size()) : 0;
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

  void match(int c, const std::vector<int>& vertex_of)
  {
    const Feature_curve& curve = *surface_.curves[c];
    // A closed curve is followed from a third of its length to the next.
    std::vector<int> stations;
    if (curve.is_closed()) {
      const std::size_t n = curve.vertices.size() - 1;
      for (std::size_t k = 0; k < 3; ++k)
        stations.push_back(nearest_free_vertex(surface_.points[curve.vertices[k * n / 3]]));
      stations.push_back(stations.front());
    }
    else
      stations = {vertex_of[curve.vertices.front()], vertex_of[curve.vertices.back()]};
    std::vector<int> path;
    double length = 0;
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
      if (stations[k] < 0 || stations[k + 1] < 0 || stations[k] == stations[k + 1])
        return;
      const std::vector<int> part = follow(curve, stations[k], stations[k + 1]);
      if (part.empty())
        return;
      for (std::size_t i = 0; i + 1 < part.size(); ++i)
        length += (points_[part[i + 1]] - points_[part[i]]).norm();
      path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
    }
    // a path that takes another way round is no match
    if (length > most_detour * curve.length || most_detour * length < curve.length)
      return;
    attachment.to_curve(complex_, path, c);
  }

  // Dijkstra over boundary edges; leaving the curve by an edge's length makes it longer.
  std::vector<int> follow(const Feature_curve& curve, int from, int to) const
  {
    using Entry = std::pair<double, int>;
    std::vector<double> cost(points_.size(), std::numeric_limits<double>::infinity());
    std::vector<int> previous(points_.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    cost[from] = 0;
    queue.emplace(0.0, from);
    while (!queue.empty() && queue.top().second != to) {
      const Entry top = queue.top();
      queue.pop();
      const int v = top.second;
      if (top.first > cost[v])
        continue;
      for (int u : neighbors_[v]) {
        if (attachment.kind[u] != Vertex_kind::SURFACE && u != to)
          continue;
        const double h = (points_[u] - points_[v]).norm();
        if (h == 0)
          continue;
        const double off =
          (curve.closest_point((points_[u] + points_[v]) / 2).point - (points_[u] + points_[v]) / 2).norm() / h;
        if (off > farthest)
          continue;
        const double next = top.first + h * (1 + cost_of_leaving * off * off);
        if (next < cost[u]) {
          cost[u] = next;
          previous[u] = v;
          queue.emplace(next, u);
        }
      }
    }
    std::vector<int> path;
    if (!std::isfinite(cost[to]))
      return path;
    for (int v = to; v != -1; v = previous[v])
      path.push_back(v);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Hexahedral_complex& complex_;
  const Positions& points_;
  const Reference_surface& surface_;
  Grouped_array neighbors_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_ATTACHMENT_BY_MATCHING_H
