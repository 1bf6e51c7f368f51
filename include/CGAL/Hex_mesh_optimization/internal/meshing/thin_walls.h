// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_THIN_WALLS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_THIN_WALLS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Parts that are thinner than the cells of a grid: which of them it does not represent, and how to keep them.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The cells inside that the way from a place to the opposite wall passes, in their order.
inline std::vector<std::size_t> cells_behind(const Wall_distance& p, const Voxel_grid& grid)
{
  const int steps = static_cast<int>(std::ceil(4 * p.distance / grid.least_spacing())) + 1;
  std::vector<std::size_t> result;
  for (int i = 0; i < steps; ++i) {
    const std::size_t cell = grid.cell_of(p.place + (i + .5) / steps * p.distance * p.inward);
    if (grid.is_inside[cell] && (result.empty() || result.back() != cell))
      result.push_back(cell);
  }
  return result;
}

// The triangles of a surface that have fewer cells of the grid behind them, up to the opposite wall, than wanted; sorted.
inline std::vector<std::size_t> thin_triangles(const std::vector<Wall_distance>& places, const Voxel_grid& grid,
                                               std::size_t minimum_cells_across)
{
  std::vector<std::size_t> result;
  for (const Wall_distance& p : places)
    if (p.distance < 2 * double(minimum_cells_across) * grid.mean_spacing() &&
        cells_behind(p, grid).size() < minimum_cells_across)
      result.push_back(p.triangle);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// The part of the surface with no cell behind it, up to the opposite wall.
inline double lost_part(const std::vector<Wall_distance>& places, const Voxel_grid& grid)
{
  double lost = 0, total = 0;
  for (const Wall_distance& p : places) {
    total += p.area;
    if (p.distance < 2 * grid.mean_spacing() && cells_behind(p, grid).empty())
      lost += p.area;
  }
  return lost / total;
}

// The part of the surface whose opposite wall is closer than that.
inline double thin_part(const std::vector<Wall_distance>& places, double distance)
{
  double thin = 0, total = 0;
  for (const Wall_distance& p : places) {
    total += p.area;
    if (p.distance < distance)
      thin += p.area;
  }
  return thin / total;
}

// Walls that fit between the centers of cells keep the cells in their middle, unless they are thinner than `least` cells.
inline void keep_thin_walls(const std::vector<Wall_distance>& places, double least, Voxel_grid& grid)
{
  for (const Wall_distance& p : places) {
    if (p.distance > 2 * grid.mean_spacing() || p.distance < least * grid.mean_spacing() ||
        !cells_behind(p, grid).empty())
      continue;
    const std::size_t cell = grid.cell_of(p.place + p.distance / 2 * p.inward);
    if (grid.is_in_box(cell))
      grid.is_inside[cell] = true;
  }
}

// Whether no cell between a place and the opposite one, across a gap, is outside.
inline bool is_gap_closed(const Wall_distance& p, const Voxel_grid& grid)
{
  const int steps = static_cast<int>(std::ceil(4 * p.distance / grid.least_spacing())) + 1;
  for (int i = 0; i < steps; ++i)
    if (!grid.is_inside[grid.cell_of(p.place + (i + .5) / steps * p.distance * p.inward)])
      return false;
  return true;
}

// Gaps that fit between the centers of cells keep the cells in their middle outside, unless they are narrower than `least`
// cells. gaps: from places of the surface through what is outside.
inline void keep_gaps(const std::vector<Wall_distance>& gaps, double least, Voxel_grid& grid)
{
  for (const Wall_distance& p : gaps) {
    if (p.distance > 2 * grid.mean_spacing() || p.distance < least * grid.mean_spacing() || !is_gap_closed(p, grid))
      continue;
    const std::size_t cell = grid.cell_of(p.place + p.distance / 2 * p.inward);
    if (grid.is_in_box(cell))
      grid.is_inside[cell] = false;
  }
}

// Walls thinner than a cell get all cells that their middle passes: they hang together by faces, one cell thick. Places are
// denser than cells.
inline void fill_thin_walls(const std::vector<Wall_distance>& places, Voxel_grid& grid)
{
  for (const Wall_distance& p : places) {
    const std::size_t cell = grid.cell_of(p.place + p.distance / 2 * p.inward);
    if (p.distance < grid.mean_spacing() && grid.is_in_box(cell))
      grid.is_inside[cell] = true;
  }
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_THIN_WALLS_H
