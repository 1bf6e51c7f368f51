// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_LIMIT_OF_HELD_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_LIMIT_OF_HELD_VERTICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What no hexahedron is better than while some of its vertices do not move.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Of the corners at these places: the least scaled Jacobian of those whose vertices are all held, and the least sine of the
// angles between two edges of held vertices.
inline double limit_of_held_vertices(const std::array<Vector_3, 8>& places, const std::array<char, 8>& is_held)
{
  double least = 1;
  for (int c = 0; c < 8; ++c) {
    if (!is_held[c])
      continue;
    Vector_3 edges[3];
    std::size_t held = 0;
    for (int n : corner_neighbors[c])
      if (is_held[n])
        edges[held++] = (places[n] - places[c]).normalized();
    if (held == 3)
      least = (std::min)(least, edges[0].dot(edges[1].cross(edges[2])));
    for (std::size_t i = 0; i < held; ++i)
      for (std::size_t k = 0; k < i; ++k)
        least = (std::min)(least, edges[i].cross(edges[k]).norm());
  }
  return least;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_LIMIT_OF_HELD_VERTICES_H
