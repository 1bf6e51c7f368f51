// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_HEXAHEDRA_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_HEXAHEDRA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The inside cells of a grid as hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// In the order of the cells; nodes in the order in which they are first used. O(cells of the grid).
inline Hexahedra voxel_hexahedra(const Voxel_grid& grid)
{
  // of the corners, in the numbering of a hexahedron
  constexpr int offsets[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  Hexahedra result;
  std::vector<int> number(grid.is_inside.size(), -1); // of a node, which has the index of the cell at its upper side
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell) {
    if (!grid.is_inside[cell])
      continue;
    const std::array<int, 3> place = grid.place(cell);
    Hexahedron hexahedron;
    for (int c = 0; c < 8; ++c) {
      const std::array<int, 3> node = {place[0] + offsets[c][0], place[1] + offsets[c][1], place[2] + offsets[c][2]};
      int& v = number[grid.index(node[0], node[1], node[2])];
      if (v < 0) {
        v = static_cast<int>(result.points.size());
        result.points.push_back(grid.node(node));
      }
      hexahedron[c] = v;
    }
    result.hexahedra.push_back(hexahedron);
  }
  result.label.assign(6 * result.hexahedra.size(), Hexahedra::no_label);
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_HEXAHEDRA_H
