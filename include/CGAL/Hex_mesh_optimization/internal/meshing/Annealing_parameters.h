// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_ANNEALING_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_ANNEALING_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How much the steps of voxels may yield to a boundary with fewer irregular vertices.

namespace CGAL::Hex_mesh_optimization::internal {

// Chosen with surfaces meshed with 8,000 hexahedra.
struct Annealing_parameters
{
  // A vertex of the boundary costs 1 for each face that it has more or less than four; a cell that changes sides costs this
  // times the square of the distance of its center from the surface, in cells.
  double weight_of_distance = 20;
  // Centers that are farther from the surface stay on their side: what the steps leave out shows in maximum deviations.
  double most_distance = .25;
  // All cells that may change are tried so often, while the temperature, in the unit of the costs, falls geometrically to
  // where nothing that costs 1 is taken.
  int sweeps = 300;
  double first_temperature = .6;
  double last_temperature = .05;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_ANNEALING_PARAMETERS_H
