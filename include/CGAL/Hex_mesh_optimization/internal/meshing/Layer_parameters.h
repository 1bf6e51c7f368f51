// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_LAYER_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_LAYER_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where layers are inserted behind patches of the boundary, and how thick.

namespace CGAL::Hex_mesh_optimization::internal {

struct Layer_parameters
{
  // Two layers that cross leave one hexahedron at the edge between their patches, a layer that goes on around it two: the
  // largest angle, in degrees, with one; the sines of the angles of one and of two are the same there.
  double largest_crossing = 120;
  // The smallest angle of a hexahedron at an edge that is left as it is, in degrees.
  double smallest_angle = 46;
  double thickness = .4; // of a layer when it is inserted, in edges
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_LAYER_PARAMETERS_H
