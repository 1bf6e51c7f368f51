// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// From sharp edges of the reference surface to feature curves and corners, with
// the chance creases of a bumpy surface told from real features.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_patches.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Traces maximal curves of a graph of sharp edges, split at every vertex that is
// not simply passed. `keep_all`: the edges were named by the user, none is noise.
class Feature_curve_tracer
{
public:
  Feature_curve_tracer(const Positions& points, const std::vector<Triangle_indices>& triangles, Edge_list sharp,
                       bool keep_all, const Feature_parameters& parameters)
    : points_(points)
    , edges_(std::move(sharp))
    , cos_corner_(std::cos(parameters.corner_turn * CGAL_PI / 180))
    , turn_length_(parameters.turn_length)
  {
    trace();
    if (keep_all || edges_.empty())
      return;
    const Triangle_adjacency adjacency(triangles);
    while (drop_chance_creases(triangles, adjacency, parameters))
      trace();
  }

  const std::vector<std::vector<int>>& curves() const { return curves_; }

  std::vector<int> corners() const
  {
    std::vector<int> result;
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (incident_[v].size() > 0 && !is_passed(static_cast<int>(v)))
        result.push_back(static_cast<int>(v));
    return result;
  }

private:
  int other(int edge, int v) const { return edges_[edge][0] == v ? edges_[edge][1] : edges_[edge][0]; }

  bool is_passed(int v) const
  {
    if (incident_[v].size() != 2)
      return false;
    const Vector_3 in = points_[v] - points_[other(incident_[v][0], v)],
                   out = points_[other(incident_[v][1], v)] - points_[v];
    return makes_no_corner(in, out) ||
           makes_no_corner(points_[v] - ahead(v, incident_[v][0]), ahead(v, incident_[v][1]) - points_[v]);
  }

  bool makes_no_corner(const Vector_3& in, const Vector_3& out) const
  {
    return in.dot(out) >= cos_corner_ * in.norm() * out.norm();
  }

  // Where the chain that leaves v by an edge has gone the length over which turns are measured, or ends.
  const Vector_3& ahead(int v, int edge) const
  {
    int u = v;
    for (double length = 0;;) {
      const int next = other(edge, u);
      length += (points_[next] - points_[u]).norm();
      u = next;
      if (length >= turn_length_ || incident_[u].size() != 2 || u == v)
        return points_[u];
      edge = incident_[u][0] == edge ? incident_[u][1] : incident_[u][0];
    }
  }

  void trace()
  {
    incident_ = Grouped_array(
      points_.size(), 2 * edges_.size(), [this](std::size_t k) { return edges_[k / 2][k % 2]; },
      [](std::size_t k) { return static_cast<int>(k / 2); });
    curves_.clear();
    curve_edges_.clear();
    std::vector<char> done(edges_.size(), false);
    for (int pass = 0; pass < 2; ++pass) // curves with ends first, then the closed ones
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (int end = 0; end < 2 && !done[e]; ++end)
          if (pass == 1 || !is_passed(edges_[e][end]))
            follow(static_cast<int>(e), edges_[e][end], done);
  }

  void follow(int edge, int start, std::vector<char>& done)
  {
    std::vector<int> vertices{start}, edges;
    int v = start;
    for (;;) {
      done[edge] = true;
      edges.push_back(edge);
      v = other(edge, v);
      vertices.push_back(v);
      if (v == start || !is_passed(v))
        break;
      edge = incident_[v][0] == edge ? incident_[v][1] : incident_[v][0];
    }
    curves_.push_back(std::move(vertices));
    curve_edges_.push_back(std::move(edges));
  }

  bool drop_chance_creases(const std::vector<Triangle_indices>& triangles, const Triangle_adjacency& adjacency,
                           const Feature_parameters& parameters)
  {
    Edge_list barriers = edges_;
    for (std::array<int, 2>& e : barriers)
      e = Triangle_adjacency::ordered(e);
    std::sort(barriers.begin(), barriers.end());
    Surface_patches patches(points_, triangles, adjacency, barriers);
    const double least_area = (std::min)(parameters.least_patch_area,
                                         parameters.least_patch_part * patches.total_area());
    std::vector<char> drop(edges_.size(), false);
    bool any = false;
    for (const std::vector<int>& curve : curve_edges_) {
      double length = 0, separating = 0;
      for (int e : curve) {
        const double l = (points_[edges_[e][1]] - points_[edges_[e][0]]).norm();
        length += l;
        if (patches.separates(edges_[e], least_area))
          separating += l;
      }
      if (length < parameters.persistence && 2 * separating < length)
        for (int e : curve)
          drop[e] = any = true;
    }
    Edge_list kept;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (!drop[e])
        kept.push_back(edges_[e]);
    edges_ = std::move(kept);
    return any;
  }

  const Positions& points_;
  Edge_list edges_;
  const double cos_corner_, turn_length_;
  Grouped_array incident_;
  std::vector<std::vector<int>> curves_, curve_edges_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H
