// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_FEATURE_CURVES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_FEATURE_CURVES_H

// From sharp edges of the reference surface to feature curves and corners, with
// the chance creases of a bumpy surface told from real features.

#include <CGAL/Hex_mesh_optimization/internal/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

struct Feature_parameters
{
  // Dihedral deviation from flat, in degrees, that makes an edge sharp. 40 to 45
  // is where polycube and voxel boundaries start to show chance creases.
  double angle_bound = 45;
  // A curve turning by more than this at a vertex has a corner there, in degrees.
  double corner_turn = 60;
  // Curves that end in the middle of a smooth region are features only from this many edges on.
  std::size_t persistence = 6;
};

using Edge_list = std::vector<std::array<int, 2>>;

// Traces maximal curves of a graph of sharp edges, split at every vertex that is
// not simply passed. `keep_all`: the edges were named by the user, none is noise.
class Feature_curve_tracer
{
public:
  Feature_curve_tracer(const Positions& points, Edge_list sharp, bool keep_all, const Feature_parameters& parameters)
    : points_(points)
    , edges_(std::move(sharp))
    , cos_corner_(std::cos(parameters.corner_turn * 3.14159265358979323846 / 180))
  {
    trace();
    while (!keep_all && drop_dangling(parameters.persistence))
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
    const Vector_3 in = points_[v] - points_[other(incident_[v][0], v)], out = points_[other(incident_[v][1], v)] - points_[v];
    return in.dot(out) >= cos_corner_ * in.norm() * out.norm();
  }

  void trace()
  {
    incident_ = Grouped_array(points_.size(), 2 * edges_.size(), [this](std::size_t k) { return edges_[k / 2][k % 2]; },
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

  bool drop_dangling(std::size_t persistence)
  {
    std::vector<char> drop(edges_.size(), false);
    bool any = false;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const bool dangling = incident_[curves_[c].front()].size() == 1 || incident_[curves_[c].back()].size() == 1;
      const bool tiny_loop = curves_[c].front() == curves_[c].back() && curve_edges_[c].size() < 4;
      if ((dangling && curve_edges_[c].size() < persistence) || tiny_loop)
        for (int e : curve_edges_[c])
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
  double cos_corner_;
  Grouped_array incident_;
  std::vector<std::vector<int>> curves_, curve_edges_;
};

inline void trace_feature_curves(Reference_surface& surface, Edge_list sharp, bool keep_all, const Feature_parameters& parameters)
{
  const Feature_curve_tracer tracer(surface.points, std::move(sharp), keep_all, parameters);
  for (const std::vector<int>& curve : tracer.curves())
    surface.curves.push_back(std::make_unique<Feature_curve>(curve, surface.points));
  surface.corners = tracer.corners();
  surface.smooth_normals();
}

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_FEATURE_CURVES_H
