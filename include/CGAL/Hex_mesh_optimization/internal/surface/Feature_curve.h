// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// One curve of the features of a surface behind a tree: closest point and tangent.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>

#include <CGAL/AABB_tree.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Curve_point
{
  Vector_3 point;
  Vector_3 tangent; // unit length
};

// A polyline of feature edges between two corners, or closed. Not copyable: the
// tree points into the segments.
class Feature_curve
{
public:
  Feature_curve(std::vector<int> reference_vertices, const Positions& points)
    : vertices(std::move(reference_vertices))
    , place_(points[vertices.front()])
  {
    std::vector<Vector_3> directions;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const Vector_3 &a = points[vertices[i]], &b = points[vertices[i + 1]];
      length += (b - a).norm();
      if (a != b) {
        segments_.emplace_back(aabb::point(a), aabb::point(b));
        directions.push_back((b - a).normalized());
      }
    }
    // a point between two segments has one tangent, whichever of them the search returns
    const std::size_t n = directions.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool first = i == 0 && !is_closed(), last = i + 1 == n && !is_closed();
      tangents_.push_back({first ? directions[i] : Vector_3(directions[i] + directions[(i + n - 1) % n]).normalized(),
                           last ? directions[i] : Vector_3(directions[i] + directions[(i + 1) % n]).normalized()});
    }
    tree_.insert(segments_.begin(), segments_.end());
    tree_.build();
  }

  Feature_curve(const Feature_curve&) = delete;
  Feature_curve& operator=(const Feature_curve&) = delete;

  bool is_closed() const { return vertices.front() == vertices.back(); }

  // A curve that is shrunk to a point has no direction.
  Curve_point closest_point(const Vector_3& query) const
  {
    if (segments_.empty())
      return {place_, Vector_3::Zero()};
    const auto found = tree_.closest_point_and_primitive(aabb::point(query));
    const Vector_3 a = aabb::vector(found.second->source()), b = aabb::vector(found.second->target());
    const Vector_3 p = aabb::vector(found.first);
    const std::array<Vector_3, 2>& ends = tangents_[found.second - segments_.begin()];
    const double t = (p - a).norm() / (b - a).norm();
    const Vector_3 tangent = (1 - t) * ends[0] + t * ends[1];
    return {p, tangent.norm() > 1e-6 ? Vector_3(tangent.normalized()) : Vector_3((b - a).normalized())};
  }

  std::vector<int> vertices; // of the reference, in order; first equals last on a closed curve
  double length = 0;

private:
  Vector_3 place_;                                // of its first vertex
  std::vector<aabb::Kernel::Segment_3> segments_; // without those of no length
  std::vector<std::array<Vector_3, 2>> tangents_; // at both ends of each
  CGAL::AABB_tree<aabb::Segment_traits> tree_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_CURVE_H
