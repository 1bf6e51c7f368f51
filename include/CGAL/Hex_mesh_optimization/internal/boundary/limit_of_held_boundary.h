// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_LIMIT_OF_HELD_BOUNDARY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_LIMIT_OF_HELD_BOUNDARY_H

#include <CGAL/license/Hex_mesh_optimization.h>

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/limit_of_held_vertices.h>

#include <algorithm>
#include <array>

namespace CGAL::Hex_mesh_optimization::internal {

// No minimum of the scaled Jacobian is higher while the boundary does not move: the least one of corners whose vertices are
// all on it, and the least sine of the angles between two edges there. O(hexahedra).
inline double limit_of_held_boundary(const Hexahedral_complex& complex, const Positions& points)
{
  double least = 1;
  for (const Hexahedron& h : complex.hexahedra) {
    std::array<Vector_3, 8> places;
    std::array<char, 8> is_held;
    for (int i = 0; i < 8; ++i) {
      places[i] = points[h[i]];
      is_held[i] = complex.is_on_boundary[h[i]];
    }
    least = (std::min)(least, limit_of_held_vertices(places, is_held));
  }
  return least;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_LIMIT_OF_HELD_BOUNDARY_H
