// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_VOXELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_VOXELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The cells of a grid that stand for what a closed surface bounds: those with their centers inside, in one piece for each
// piece of the surface at most, with a boundary that is a manifold.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Manifold_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/inside_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/thin_walls.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Pieces of cells that hang together by faces are dropped, unless one is the largest near some piece of the surface: what
// is thinner than a cell leaves crumbs. O(cells), and a search for each cell at a face between inside and outside if there
// are several pieces.
inline void drop_crumbs(Voxel_grid& grid, const Triangle_surface& surface)
{
  Disjoint_sets pieces(grid.is_inside.size());
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
    for (int axis = 0; axis < 3; ++axis)
      if (grid.is_inside[cell] && grid.is_inside[cell + grid.stride(axis)])
        pieces.unite(cell, cell + grid.stride(axis));
  std::map<std::size_t, std::size_t> size; // of each piece
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
    if (grid.is_inside[cell])
      ++size[pieces.find(cell)];
  if (size.size() < 2)
    return;

  Disjoint_sets of_surface(surface.points.size());
  for (const Triangle_indices& t : surface.triangles) {
    of_surface.unite(t[0], t[1]);
    of_surface.unite(t[0], t[2]);
  }
  std::map<std::size_t, std::size_t> largest; // piece of cells near each of the surface
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell) {
    if (!grid.is_inside[cell])
      continue;
    bool is_at_boundary = false;
    for (int axis = 0; axis < 3; ++axis)
      is_at_boundary = is_at_boundary || !grid.is_inside[cell + grid.stride(axis)] ||
                       !grid.is_inside[cell - grid.stride(axis)];
    if (!is_at_boundary)
      continue;
    const std::size_t near = of_surface.find(surface.triangles[surface.closest_point(grid.center(cell)).triangle][0]);
    const auto inserted = largest.emplace(near, pieces.find(cell));
    if (size[pieces.find(cell)] > size[inserted.first->second])
      inserted.first->second = pieces.find(cell);
  }
  std::set<std::size_t> kept;
  for (const auto& entry : largest)
    kept.insert(entry.second);
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
    if (grid.is_inside[cell] && !kept.count(pieces.find(cell)))
      grid.is_inside[cell] = false;
}

// Vertices minus edges plus faces of a closed surface.
inline std::ptrdiff_t euler_characteristic(const std::vector<Triangle_indices>& triangles)
{
  std::set<int> vertices;
  for (const Triangle_indices& t : triangles)
    vertices.insert(t.begin(), t.end());
  return static_cast<std::ptrdiff_t>(vertices.size()) - static_cast<std::ptrdiff_t>(triangles.size() / 2);
}

// Of the boundary of the cells inside, which is a manifold. O(cells).
inline std::ptrdiff_t euler_characteristic(const Voxel_grid& grid)
{
  std::ptrdiff_t vertices = 0, faces = 0;
  for (int k = 0; k <= grid.cells(2); ++k)
    for (int j = 0; j <= grid.cells(1); ++j)
      for (int i = 0; i <= grid.cells(0); ++i) {
        const std::size_t node = grid.index(i, j, k);
        int inside = 0;
        for (int c = 0; c < 8; ++c)
          inside += grid.is_inside[node - (c & 1 ? grid.stride(0) : 0) - (c & 2 ? grid.stride(1) : 0) -
                                   (c & 4 ? grid.stride(2) : 0)];
        vertices += inside > 0 && inside < 8;
        for (int axis = 0; axis < 3; ++axis)
          faces += grid.is_inside[node] != grid.is_inside[node - grid.stride(axis)];
      }
  return vertices - faces;
}

inline void require_cells_inside(const Voxel_grid& grid, double spacing)
{
  if (grid.number_inside() == 0)
    throw Input_error(Input_error::Element::PARAMETER, 0,
                      "no cell of the grid is inside the surface: the spacing, " + std::to_string(spacing) +
                        ", is too large");
}

// Throws Input_error where a grid in the box would have too many cells.
inline void require_countable_cells(const Eigen::AlignedBox3d& box, double spacing)
{
  const double number = (box.sizes() / spacing).array().max(1).prod();
  if (number > double((std::numeric_limits<int>::max)()))
    throw Input_error(Input_error::Element::PARAMETER, 0,
                      "the spacing, " + std::to_string(spacing) + ", is too small: the grid would have " +
                        std::to_string(number) + " cells");
}

inline Eigen::AlignedBox3d bounding_box(const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  Eigen::AlignedBox3d box;
  for (const Triangle_indices& t : triangles)
    for (int v : t)
      box.extend(points[v]);
  return box;
}

// Of the box around the surface, evenly divided, with no cell inside.
inline Voxel_grid even_grid(const Triangle_surface& surface, double spacing)
{
  const Eigen::AlignedBox3d box = bounding_box(surface.points, surface.triangles);
  require_countable_cells(box, spacing);
  return Voxel_grid(box, spacing);
}

inline double distance_from(const Triangle_surface& surface, const Vector_3& p)
{
  return (surface.closest_point(p).point - p).norm();
}

// Closed, oriented outwards, in the box of the grid. What is returned may have no cell inside.
// walls: those of the surface, about as dense as the cells; is_shell: denser, all that are thin get a layer of cells.
// gaps: that stay open where cells can keep them.
inline Voxel_grid solid_voxels(const Triangle_surface& surface, const std::vector<Wall_distance>& walls,
                               Voxel_grid grid, bool is_shell = false, const std::vector<Wall_distance>& gaps = {})
{
  const double thinnest = .25; // wall or gap that is kept, in cells
  fill_inside(surface.points, surface.triangles, grid);
  if (is_shell)
    fill_thin_walls(walls, grid);
  else
    keep_thin_walls(walls, thinnest, grid);
  keep_gaps(gaps, thinnest, grid);
  drop_crumbs(grid, surface);
  Manifold_voxels(
    grid, [&](std::size_t cell) { return distance_from(surface, grid.center(cell)); }, is_shell);
  drop_crumbs(grid, surface);
  return grid;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_VOXELS_H
