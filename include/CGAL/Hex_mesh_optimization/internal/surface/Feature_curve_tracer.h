// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H

// From sharp edges of the reference surface to feature curves and corners, with
// the chance creases of a bumpy surface told from real features.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
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
  // A feature separates two patches of the surface. Curves that do not, with the same patch on either side, are features
  // only from this length on, and patches smaller than the area are none; in units of mean boundary edges.
  double persistence = 15;
  double least_patch_area = 6;
  // Nor is a patch smaller than this part of the whole surface required: coarse meshes have patches of few faces.
  double least_patch_part = .02;
};

using Edge_list = std::vector<std::array<int, 2>>;

// The patches that a set of edges cuts a triangle surface into.
class Surface_patches
{
public:
  // barriers: sorted, the smaller index first
  Surface_patches(const Positions& points, const std::vector<Triangle_indices>& triangles, const Edge_list& barriers)
    : parent_(triangles.size())
    , area_(triangles.size(), 0.0)
  {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
        sides_.push_back({(std::min)(a, b), (std::max)(a, b), static_cast<int>(t)});
      }
    std::sort(sides_.begin(), sides_.end());
    for (std::size_t i = 1; i < sides_.size(); ++i)
      if (sides_[i][0] == sides_[i - 1][0] && sides_[i][1] == sides_[i - 1][1] &&
          !std::binary_search(barriers.begin(), barriers.end(), std::array<int, 2>{sides_[i][0], sides_[i][1]}))
        parent_[root(sides_[i][2])] = root(sides_[i - 1][2]);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Vector_3& a = points[triangles[t][0]];
      area_[root(static_cast<int>(t))] += (points[triangles[t][1]] - a).cross(points[triangles[t][2]] - a).norm() / 2;
    }
  }

  double total_area() const
  {
    double sum = 0;
    for (double area : area_)
      sum += area;
    return sum;
  }

  // Whether an edge lies between different patches none of which is smaller than the area. The rim of an open surface
  // and edges with more than two triangles do.
  bool separates(const std::array<int, 2>& edge, double least_area)
  {
    const auto first = std::lower_bound(sides_.begin(), sides_.end(),
                                        std::array<int, 3>{(std::min)(edge[0], edge[1]), (std::max)(edge[0], edge[1]), 0});
    const auto second = first + 1;
    const bool has_two = second != sides_.end() && (*second)[0] == (*first)[0] && (*second)[1] == (*first)[1] &&
                         (second + 1 == sides_.end() || (*(second + 1))[0] != (*first)[0] || (*(second + 1))[1] != (*first)[1]);
    if (!has_two)
      return true;
    const int left = root((*first)[2]), right = root((*second)[2]);
    return left != right && area_[left] >= least_area && area_[right] >= least_area;
  }

private:
  int root(int t)
  {
    while (parent_[t] != t)
      t = parent_[t] = parent_[parent_[t]];
    return t;
  }

  std::vector<int> parent_;
  std::vector<double> area_; // at roots
  std::vector<std::array<int, 3>> sides_; // low, high, triangle
};

// Traces maximal curves of a graph of sharp edges, split at every vertex that is
// not simply passed. `keep_all`: the edges were named by the user, none is noise.
class Feature_curve_tracer
{
public:
  Feature_curve_tracer(const Positions& points, const std::vector<Triangle_indices>& triangles, Edge_list sharp, bool keep_all,
                       const Feature_parameters& parameters)
    : points_(points)
    , edges_(std::move(sharp))
    , cos_corner_(std::cos(parameters.corner_turn * 3.14159265358979323846 / 180))
  {
    trace();
    while (!keep_all && drop_chance_creases(triangles, parameters))
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

  bool drop_chance_creases(const std::vector<Triangle_indices>& triangles, const Feature_parameters& parameters)
  {
    Edge_list barriers = edges_;
    for (std::array<int, 2>& e : barriers)
      std::sort(e.begin(), e.end());
    std::sort(barriers.begin(), barriers.end());
    Surface_patches patches(points_, triangles, barriers);
    const double least_area = (std::min)(parameters.least_patch_area, parameters.least_patch_part * patches.total_area());
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
  double cos_corner_;
  Grouped_array incident_;
  std::vector<std::vector<int>> curves_, curve_edges_;
};

inline void trace_feature_curves(Reference_surface& surface, Edge_list sharp, bool keep_all, const Feature_parameters& parameters)
{
  const Feature_curve_tracer tracer(surface.points, surface.triangles, std::move(sharp), keep_all, parameters);
  for (const std::vector<int>& curve : tracer.curves())
    surface.curves.push_back(std::make_unique<Feature_curve>(curve, surface.points));
  surface.corners = tracer.corners();
  surface.smooth_normals();
}

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_TRACER_H
