// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_ANNEALING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_ANNEALING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Cells whose centers are near the surface change sides where the boundary of the voxels gets fewer irregular vertices,
// by simulated annealing. Each of these limits the scaled Jacobian of the hexahedra around it, and the steps of a grid
// across an oblique surface have about twice as many as they need.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Annealing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Node_patterns.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The boundary is a manifold, and stays so, with the same topology. Walls and gaps of one cell that are more than a step
// on something wider stay as they are. Deterministic. O(n) for n cells near the boundary, times the number of sweeps.
class Voxel_annealing
{
public:
  // distance(cell): of the center of a cell from the surface.
  template <class Distance>
  Voxel_annealing(Voxel_grid& grid, const Distance& distance, const Annealing_parameters& parameters)
    : grid_(grid)
    , weight_(parameters.weight_of_distance)
  {
    find_candidates(distance, parameters.most_distance);
    const double cooling = std::pow(parameters.last_temperature / parameters.first_temperature, 1. / parameters.sweeps);
    double temperature = parameters.first_temperature;
    for (int sweep = 0; sweep < parameters.sweeps; ++sweep, temperature *= cooling)
      for (Candidate& c : candidates_)
        try_to_change(c, temperature);
    for (bool any = true; any;) { // what is left of it goes downhill only
      any = false;
      for (Candidate& c : candidates_)
        any = try_to_change(c, 0) || any;
    }
  }

private:
  struct Candidate
  {
    std::size_t cell;
    double cost; // of its change: negative once it has changed
  };

  // The cells near the boundary that may change.
  template <class Distance>
  void find_candidates(const Distance& distance, double most_distance)
  {
    const double spacing = grid_.mean_spacing();
    for (int k = 0; k < grid_.cells(2); ++k)
      for (int j = 0; j < grid_.cells(1); ++j)
        for (int i = 0; i < grid_.cells(0); ++i) {
          const std::size_t cell = grid_.index(i, j, k);
          if (!is_near_boundary(cell))
            continue;
          const double d = distance(cell) / spacing;
          if (d <= most_distance)
            candidates_.push_back({cell, weight_ * d * d});
        }
  }

  bool is_near_boundary(std::size_t cell) const
  {
    for (int c = 0; c < 8; ++c) {
      const unsigned pattern = pattern_at(grid_, node_of(grid_, cell, c));
      if (pattern != 0 && pattern != 255)
        return true;
    }
    return false;
  }

  // At a temperature, or, where that is 0, if it lowers the cost. Tells whether it changed.
  bool try_to_change(Candidate& c, double temperature)
  {
    if (!is_simple(c.cell))
      return false;
    const int before = irregularity_around(c.cell);
    flip(c.cell);
    const double cost = c.cost + irregularity_around(c.cell) - before;
    const bool is_taken = temperature > 0 ? cost <= 0 || std::exp(-cost / temperature) > random() : cost < -rounding;
    if (!is_taken || !is_manifold_around(c.cell)) {
      flip(c.cell);
      return false;
    }
    c.cost = -c.cost;
    return true;
  }

  // With a manifold before and after, the change of the cell does not change the topology: its faces that are of the
  // boundary hang together, and the others do. Where two opposite ones are, it is a step on something wider.
  bool is_simple(std::size_t cell) const
  {
    int pairs = 0, none = 0; // axes across which both faces are of the boundary, or none
    for (int axis = 0; axis < 3; ++axis) {
      const bool below = is_different(cell, cell - grid_.stride(axis)),
                 above = is_different(cell, cell + grid_.stride(axis));
      pairs += below && above;
      none += !below && !above;
      if (below && above && !is_on_something_wider(cell, axis))
        return false;
    }
    const bool is_whole = none < 3 && !(pairs == 1 && none == 2),
               leaves_whole = pairs < 3 && !(pairs == 2 && none == 1);
    return is_whole && leaves_whole;
  }

  // Across the axis, than the cell.
  bool is_on_something_wider(std::size_t cell, int axis) const
  {
    for (int other = 0; other < 3; ++other)
      if (other != axis)
        for (const std::size_t base : {cell - grid_.stride(other), cell + grid_.stride(other)}) {
          const std::size_t opposite = 2 * cell - base;
          if (!is_different(cell, base) && is_different(cell, opposite) &&
              !is_different(base, base - grid_.stride(axis)) && !is_different(base, base + grid_.stride(axis)))
            return true;
        }
    return false;
  }

  bool is_different(std::size_t a, std::size_t b) const
  {
    return (grid_.is_inside[a] != 0) != (grid_.is_inside[b] != 0);
  }

  int irregularity_around(std::size_t cell) const
  {
    int sum = 0;
    for (int c = 0; c < 8; ++c)
      sum += patterns_.irregularity(pattern_at(grid_, node_of(grid_, cell, c)));
    return sum;
  }

  bool is_manifold_around(std::size_t cell) const
  {
    for (int c = 0; c < 8; ++c)
      if (!patterns_.is_manifold(pattern_at(grid_, node_of(grid_, cell, c))))
        return false;
    return true;
  }

  void flip(std::size_t cell) { grid_.is_inside[cell] = !grid_.is_inside[cell]; }

  // From 0 to 1; the distributions of the standard library differ between its implementations.
  double random() { return double(engine_()) / double(std::mt19937::max()); }

  static constexpr double rounding = 1e-9; // of costs

  Voxel_grid& grid_;
  const double weight_;
  const Node_patterns patterns_;
  std::vector<Candidate> candidates_;
  std::mt19937 engine_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_ANNEALING_H
