// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_NODE_PATTERNS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_NODE_PATTERNS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which of the eight cells around a node of a grid are inside, and what that means for the boundary there.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>

#include <array>
#include <cstddef>
#include <cstdlib>

namespace CGAL::Hex_mesh_optimization::internal {

// A node has the index of the cell at its upper side. Cell c of those around it, c = i + 2 j + 4 k, is that cell or one
// before it.
inline std::size_t cell_around(const Voxel_grid& grid, std::size_t node, int c)
{
  return node - (c & 1 ? 0 : grid.stride(0)) - (c & 2 ? 0 : grid.stride(1)) - (c & 4 ? 0 : grid.stride(2));
}

// Node c of a cell.
inline std::size_t node_of(const Voxel_grid& grid, std::size_t cell, int c)
{
  return cell + (c & 1 ? grid.stride(0) : 0) + (c & 2 ? grid.stride(1) : 0) + (c & 4 ? grid.stride(2) : 0);
}

// Bit c: cell c around the node is inside.
inline unsigned pattern_at(const Voxel_grid& grid, std::size_t node)
{
  unsigned pattern = 0;
  for (int c = 0; c < 8; ++c)
    pattern |= unsigned(grid.is_inside[cell_around(grid, node, c)] != 0) << c;
  return pattern;
}

class Node_patterns
{
public:
  Node_patterns()
  {
    for (unsigned pattern = 0; pattern < 256; ++pattern) {
      is_manifold_[pattern] = is_connected(pattern) && is_connected(~pattern & 255u);
      int faces = 0;
      for (int c = 0; c < 8; ++c)
        for (int axis = 0; axis < 3; ++axis)
          if (!(c >> axis & 1))
            faces += (pattern >> c & 1u) != (pattern >> (c | 1 << axis) & 1u);
      irregularity_[pattern] = faces == 0 ? 0 : std::abs(faces - 4);
    }
  }

  // The boundary is a disk at the node, or not there at all: the cells inside are connected by faces, and the cells
  // outside are.
  bool is_manifold(unsigned pattern) const { return is_manifold_[pattern]; }
  // How many faces more or less than four the boundary has around the node; none where it is not there.
  int irregularity(unsigned pattern) const { return irregularity_[pattern]; }

private:
  static bool is_connected(unsigned cells)
  {
    unsigned reached = cells & (~cells + 1); // the lowest
    for (unsigned last = 0; last != reached;) {
      last = reached;
      for (int c = 0; c < 8; ++c)
        if (reached >> c & 1u)
          for (int axis = 0; axis < 3; ++axis)
            reached |= cells & 1u << (c ^ 1 << axis);
    }
    return reached == cells;
  }

  std::array<bool, 256> is_manifold_;
  std::array<int, 256> irregularity_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_NODE_PATTERNS_H
