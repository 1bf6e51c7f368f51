// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_VERTEX_COUPLINGS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_VERTEX_COUPLINGS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which vertices the energies of corners and of faces couple: the pattern of the
// matrix of Newton's method.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// The pairs of corners of a hexahedron that share a face. Opposite corners of the hexahedron are not coupled, as no
// corner has both among its neighbors.
struct Hexahedron_couplings
{
  static constexpr int number = 24;
  int first[number] = {}, second[number] = {}; // corners, first < second
  int of[8][8] = {};                           // number of the pair; -1 if not coupled

  constexpr Hexahedron_couplings()
  {
    constexpr int opposite[8] = {6, 7, 4, 5, 2, 3, 0, 1};
    int n = 0;
    for (int i = 0; i < 8; ++i)
      for (int j = i; j < 8; ++j) {
        of[i][j] = of[j][i] = -1;
        if (j == i || j == opposite[i])
          continue;
        first[n] = i;
        second[n] = j;
        of[i][j] = of[j][i] = n++;
      }
  }
};

inline constexpr Hexahedron_couplings hexahedron_couplings;

// For each vertex those that share a face with it, once for every hexahedron in which they do.
inline Grouped_array vertex_couplings(const Hexahedral_complex& complex)
{
  constexpr std::size_t sides = 2 * Hexahedron_couplings::number; // pair and end
  const auto vertex = [&](std::size_t item, bool is_other) {
    const std::size_t side = item % sides, pair = side / 2;
    return complex.hexahedra[item / sides][(side % 2 == 1) == is_other ? hexahedron_couplings.first[pair]
                                                                       : hexahedron_couplings.second[pair]];
  };
  return Grouped_array(
    complex.number_of_vertices(), sides * complex.hexahedra.size(), [&](std::size_t i) { return vertex(i, false); },
    [&](std::size_t i) { return vertex(i, true); });
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_VERTEX_COUPLINGS_H
