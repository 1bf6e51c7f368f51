// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_TARGETS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_TARGETS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// For points of the mesh the nearest places of the reference, asked for again and
// again while little moves.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Target.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Reference_targets
{
public:
  // For so many points. surface must outlive the object.
  Reference_targets(const Reference_surface& surface, std::size_t points)
    : surface_(surface)
    , queried_at_(points, Vector_3::Constant(std::numeric_limits<double>::infinity()))
    , triangles_(points, Surface_point::no_triangle)
  {
    nearby_.reset(points);
  }

  // Further points.
  void add(std::size_t points)
  {
    queried_at_.resize(queried_at_.size() + points, Vector_3::Constant(std::numeric_limits<double>::infinity()));
    triangles_.resize(triangles_.size() + points, Surface_point::no_triangle);
    nearby_.add(points);
  }

  // Whether point i, now at p, is as far as `still` from where this last was true: only then its target has to be found
  // anew.
  bool has_moved(std::size_t i, const Vector_3& p, double still)
  {
    if ((p - queried_at_[i]).squaredNorm() < still * still)
      return false;
    queried_at_[i] = p;
    return true;
  }

  Target on_curve(int curve, const Vector_3& p) const
  {
    const Curve_point c = surface_.curves[curve]->closest_point(p);
    return Target::on_line(c.point, c.tangent);
  }

  // Of point i, now at p, which belongs to a sheet of the surface: always the same one.
  Target on_surface(std::size_t i, const Vector_3& p, int sheet)
  {
    const Surface_point q = closest_point(i, p, sheet);
    triangles_[i] = q.triangle;
    const int at_rim = surface_.rims.triangle_at(q);
    if (at_rim != Rims::none)
      return Target::in_direction(q.point, surface_.plane_normal(at_rim));
    return Target::on_plane(q.point, p, surface_.normal(q.triangle, q.coordinates));
  }

  // How far point i would be from its sheet if it were at p.
  double distance(std::size_t i, const Vector_3& p, int sheet)
  {
    return surface_.way(p, closest_point(i, p, sheet)).norm();
  }

  // Whether point i would be no farther than `most` from its sheet if it were at p. Mostly the triangle that was the closest
  // before tells, which takes much less time than the distance.
  bool is_within(std::size_t i, const Vector_3& p, int sheet, double most)
  {
    const std::size_t before = triangles_[i];
    const auto from_before = [&] {
      return (closest_point_of_triangle(p, before, surface_.points, surface_.triangles).point - p).norm();
    };
    return (before != Surface_point::no_triangle && from_before() <= most) || distance(i, p, sheet) <= most;
  }

private:
  Surface_point closest_point(std::size_t i, const Vector_3& p, int sheet)
  {
    const std::size_t before = triangles_[i];
    if (before != Surface_point::no_triangle)
      if (const std::optional<Surface_point> q = nearby_.closest(i, p, before, surface_.points, surface_, 0))
        return *q;
    return surface_.closest_point(p, before, sheet);
  }

  const Reference_surface& surface_;
  Positions queried_at_;               // where each point was
  std::vector<std::size_t> triangles_; // that was the closest to each point
  Nearby_triangles nearby_;            // to each point
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_TARGETS_H
