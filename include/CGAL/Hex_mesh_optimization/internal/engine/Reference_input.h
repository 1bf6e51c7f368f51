// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_INPUT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_INPUT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The reference as the engine takes it: a triangle surface on flat arrays.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <array>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// `sharp` are edges between its points.
struct Reference_input
{
  static constexpr int no_label = (std::numeric_limits<int>::max)(); // of what is outside

  Positions points;
  std::vector<Triangle_indices> triangles;
  Edge_list sharp;
  bool sharp_is_given = false; // by the user: no detection, nothing dropped
  // Of each triangle, what is behind and in front of it, the lower one first; none: it is that of all of the outer boundary.
  std::vector<std::array<int, 2>> labels = {};
};

// In the place of the interface between two labels, the lower one first, as it came in.
struct Interface_reference
{
  std::array<int, 2> labels;
  Reference_input surface;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_INPUT_H
