// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_POINT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_POINT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A point of a triangle surface that a search has found.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <array>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

struct Surface_point
{
  static constexpr std::size_t no_triangle = static_cast<std::size_t>(-1);

  Vector_3 point = Vector_3::Zero();
  std::array<double, 3> coordinates{}; // barycentric, in the triangle
  std::size_t triangle = no_triangle;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_POINT_H
