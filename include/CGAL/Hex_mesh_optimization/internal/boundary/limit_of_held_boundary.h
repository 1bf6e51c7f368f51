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

#include <algorithm>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// No minimum of the scaled Jacobian is higher while the boundary does not move: the least one of corners whose vertices are
// all on it, and the least sine of the angles between two edges there. O(hexahedra).
inline double limit_of_held_boundary(const Hexahedral_complex& complex, const Positions& points)
{
  double least = 1;
  for (const Hexahedron& h : complex.hexahedra)
    for (int c = 0; c < 8; ++c) {
      if (!complex.is_on_boundary[h[c]])
        continue;
      Vector_3 edges[3];
      std::size_t held = 0;
      for (int n : corner_neighbors[c])
        if (complex.is_on_boundary[h[n]])
          edges[held++] = (points[h[n]] - points[h[c]]).normalized();
      if (held == 3)
        least = (std::min)(least, edges[0].dot(edges[1].cross(edges[2])));
      for (std::size_t i = 0; i < held; ++i)
        for (std::size_t k = 0; k < i; ++k)
          least = (std::min)(least, edges[i].cross(edges[k]).norm());
    }
  return least;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_LIMIT_OF_HELD_BOUNDARY_H
