// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MANIFOLD_VOXELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MANIFOLD_VOXELS_H

// Makes the boundary of the inside cells of a grid a manifold, by adding and removing few cells.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Bit c of the pattern: cell c of the eight around a node is inside, c = i + 2 j + 4 k. The boundary is a disk at the node
// if and only if the cells inside are connected by faces, and the cells outside are.
class Node_patterns
{
public:
  Node_patterns()
  {
    for (unsigned pattern = 0; pattern < 256; ++pattern)
      is_manifold_[pattern] = is_connected(pattern) && is_connected(~pattern & 255u);
  }

  bool is_manifold(unsigned pattern) const { return is_manifold_[pattern]; }

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

  std::bitset<256> is_manifold_;
};

class Manifold_voxels
{
public:
  // cost(cell): of the change of a cell of the box, not negative; of two changes that mend as much the cheaper is made.
  // Ends: a step leaves fewer contacts than there were, and when none does, those that are left
  // are filled; the whole box has none.
  template <class Cost>
  Manifold_voxels(Voxel_grid& grid, const Cost& cost) : grid_(grid)
  {
    std::vector<std::size_t> bad = bad_nodes();
    for (bool only_adds : {false, true})
      while (!bad.empty()) {
        bool any = false;
        for (const std::size_t node : bad)
          if (!is_manifold(node))
            any = mend(node, only_adds, cost) || any;
        bad = bad_nodes();
        if (!any)
          break;
      }
  }

  std::size_t added() const { return added_; }
  std::size_t removed() const { return removed_; }

private:
  // A node has the index of the cell at its upper side; the cells around it are this and those before it.
  std::size_t cell_at(std::size_t node, int c) const
  {
    return node - (c & 1 ? 0 : grid_.stride(0)) - (c & 2 ? 0 : grid_.stride(1)) - (c & 4 ? 0 : grid_.stride(2));
  }

  bool is_manifold(std::size_t node) const
  {
    unsigned pattern = 0;
    for (int c = 0; c < 8; ++c)
      pattern |= unsigned(grid_.is_inside[cell_at(node, c)] != 0) << c;
    return patterns_.is_manifold(pattern);
  }

  std::vector<std::size_t> bad_nodes() const
  {
    std::vector<std::size_t> result;
    for (int k = 0; k <= grid_.cells(2); ++k)
      for (int j = 0; j <= grid_.cells(1); ++j)
        for (int i = 0; i <= grid_.cells(0); ++i)
          if (!is_manifold(grid_.index(i, j, k)))
            result.push_back(grid_.index(i, j, k));
    return result;
  }

  int bad_nodes_around(std::size_t cell) const
  {
    int result = 0;
    for (int c = 0; c < 8; ++c)
      result += !is_manifold(cell + (c & 1 ? grid_.stride(0) : 0) + (c & 2 ? grid_.stride(1) : 0) +
                             (c & 4 ? grid_.stride(2) : 0));
    return result;
  }

  // Changes the one or two cells around the node that leave the fewest bad nodes, if these become fewer; or, if it may
  // add cells only, adds the cell that leaves the fewest, whatever that does.
  template <class Cost>
  bool mend(std::size_t node, bool only_adds, const Cost& cost)
  {
    constexpr double least = std::numeric_limits<double>::infinity();
    std::pair<int, double> best(only_adds ? 9 : 0, least); // change of the number of bad nodes, cost
    std::array<std::size_t, 2> chosen{};
    const std::size_t none = 0;
    const auto may_change = [&](std::size_t cell) {
      return grid_.is_in_box(cell) && !(only_adds && grid_.is_inside[cell]);
    };
    for (int c = 0; c < 8; ++c) {
      const std::size_t first = cell_at(node, c);
      if (!may_change(first))
        continue;
      const int before_first = bad_nodes_around(first);
      flip(first);
      const int gain = bad_nodes_around(first) - before_first;
      const std::pair<int, double> of_one(gain, cost(first));
      if (of_one < best) {
        best = of_one;
        chosen = {first, none};
      }
      for (int d = c + 1; d < 8 && !only_adds; ++d) {
        const std::size_t second = cell_at(node, d);
        if (!may_change(second))
          continue;
        const int before_second = bad_nodes_around(second);
        flip(second);
        // one bad node mended is worth a cell changed
        const std::pair<int, double> of_two(gain + bad_nodes_around(second) - before_second + 1,
                                            cost(first) + cost(second));
        flip(second);
        if (of_two < best) {
          best = of_two;
          chosen = {first, second};
        }
      }
      flip(first);
    }
    if (chosen[0] == none)
      return false;
    for (const std::size_t cell : chosen)
      if (cell != none) {
        flip(cell);
        ++(grid_.is_inside[cell] ? added_ : removed_);
      }
    return true;
  }

  void flip(std::size_t cell) { grid_.is_inside[cell] = !grid_.is_inside[cell]; }

  Voxel_grid& grid_;
  const Node_patterns patterns_;
  std::size_t added_ = 0, removed_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MANIFOLD_VOXELS_H
