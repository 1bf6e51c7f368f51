// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How a grid suits the flat parts of a surface.

#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

struct Grid_parameters
{
  double flatness = 2e-3;   // normals that differ by less are those of one flat part, in radians
  double aligned_angle = 3; // parts whose normals are closer to an axis lie along the grid, in degrees
  double least_gain = .05;  // part of the surface that has to lie along turned axes and does not along those of space
  std::size_t number_of_candidates = 24; // for axes: flat parts, the largest first
  // Planes of the grid, in cells: parts at one level, the least area of one, and the least distance of two.
  double same_level = .02;
  double least_flat_area = 2;
  double least_gap = .3;
  // From this distance of two planes on, in cells, there is another one between them: with one row of cells, steps of walls
  // that run across the grid have nowhere to go between two edges.
  double least_width_of_two = .9;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PARAMETERS_H
