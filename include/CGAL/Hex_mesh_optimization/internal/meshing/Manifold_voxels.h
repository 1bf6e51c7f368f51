// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MANIFOLD_VOXELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MANIFOLD_VOXELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Makes the boundary of the inside cells of a grid a manifold, by adding and removing few cells.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Node_patterns.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Manifold_voxels
{
public:
  // cost(cell): of the change of a cell of the box, not negative; of two changes that mend as much the cheaper is made.
  // Ends: a step leaves fewer contacts than there were, and when none does, those that are left
  // are filled; the whole box has none.
  // only_by_adding: no cell is removed.
  template <class Cost>
  Manifold_voxels(Voxel_grid& grid, const Cost& cost, bool only_by_adding = false) : grid_(grid)
  {
    std::vector<std::size_t> bad = bad_nodes();
    for (bool only_adds : {only_by_adding, true})
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
  bool is_manifold(std::size_t node) const { return patterns_.is_manifold(pattern_at(grid_, node)); }

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
      result += !is_manifold(node_of(grid_, cell, c));
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
      const std::size_t first = cell_around(grid_, node, c);
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
        const std::size_t second = cell_around(grid_, node, d);
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
