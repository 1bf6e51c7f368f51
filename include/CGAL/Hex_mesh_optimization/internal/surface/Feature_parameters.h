// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What of the sharp edges of a surface is a feature.

namespace CGAL::Hex_mesh_optimization::internal {

struct Feature_parameters
{
  // Dihedral deviation from flat, in degrees, that makes an edge sharp. 40 to 45
  // is where polycube and voxel boundaries start to show chance creases.
  double angle_bound = 45;
  // A curve turning by more than this at a vertex has a corner there, in degrees.
  double corner_turn = 60;
  // The turn has to be there when it is measured over so many mean boundary edges too: a jagged curve zigzags, it has
  // no corners.
  double turn_length = 2.5;
  // A feature separates two patches of the surface. Curves that do not, with the same patch on either side, are
  // features only from this length on, and patches smaller than the area are none; in units of mean boundary edges.
  double persistence = 15;
  double least_patch_area = 6;
  // Nor is a patch smaller than this part of the whole surface required: coarse meshes have patches of few faces.
  double least_patch_part = .02;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_FEATURE_PARAMETERS_H
