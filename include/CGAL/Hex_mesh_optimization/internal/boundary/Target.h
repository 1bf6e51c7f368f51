// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_TARGET_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_TARGET_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where a point of the mesh should be, and in which directions it matters.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

namespace CGAL::Hex_mesh_optimization::internal {

struct Target
{
  static constexpr double coincidence = 1e-7; // below this a distance has no direction

  Vector_3 place = Vector_3::Zero();
  Matrix_3 projector = Matrix_3::Zero(); // removes the directions in which all places are as good

  // The part of the way to p that counts.
  Vector_3 offset(const Vector_3& p) const { return projector * (p - place); }

  static Target at(const Vector_3& place) { return {place, Matrix_3::Identity()}; }

  // Anywhere on a curve.
  static Target on_line(const Vector_3& place, const Vector_3& tangent)
  {
    return {place, Matrix_3::Identity() - tangent * tangent.transpose()};
  }

  // Anywhere on a surface: what counts is the direction from the place to p, or the normal where they coincide.
  static Target on_plane(const Vector_3& place, const Vector_3& p, const Vector_3& normal)
  {
    const Vector_3 offset = p - place;
    const double distance = offset.norm();
    return in_direction(place, distance > coincidence ? Vector_3(offset / distance) : normal);
  }

  static Target in_direction(const Vector_3& place, const Vector_3& direction)
  {
    return {place, direction * direction.transpose()};
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_TARGET_H
