// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESHING_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESHING_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a caller can choose of a mesh that is made from a surface, and what else decides about it.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Annealing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Grid_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Layer_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

struct Meshing_parameters
{
  double spacing = 0;                     // length of the cells; 0: what makes the number of hexahedra
  std::size_t number_of_hexahedra = 8000; // wanted
  std::size_t minimum_cells_across = 1;   // wanted between opposite walls
  Feature_parameters features;
  Grid_parameters grid;
  Annealing_parameters annealing;
  Layer_parameters layers;

  // Where parts are thin, the spacing is made smaller until no more than this part of the surface has too few cells
  // behind it, or there are so many times more hexahedra than wanted.
  double tolerated_thin_area = .01;
  double most_excess = 8;
  // Where more of the surface has its opposite wall closer than this part of a cell, the solid is a shell: its walls get one
  // layer of cells, however thin they are.
  double least_shell_area = .5;
  double shell_thickness = .9;
  // The number of hexahedra is met within this part of it, if that many attempts find it.
  double number_tolerance = .1;
  int most_attempts = 4;
  // After the projection, with steps along the surface: a few rounds take the folds out of it, more gain nothing.
  int smoothing_rounds = 5;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESHING_PARAMETERS_H
