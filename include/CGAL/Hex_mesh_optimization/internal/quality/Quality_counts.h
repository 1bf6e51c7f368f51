// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_COUNTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_COUNTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What is counted over the hexahedra of a mesh, wherever that is done: hexahedron
// by hexahedron in the order given, or part by part.

#include <algorithm>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

struct Quality_counts
{
  std::size_t inverted = 0;    // with a scaled Jacobian ≤ 0
  std::size_t invalid = 0;     // not certified
  double minimum = 1, sum = 0; // of the scaled Jacobians

  void add(double scaled_jacobian, bool is_valid)
  {
    inverted += scaled_jacobian <= 0;
    invalid += !is_valid;
    minimum = (std::min)(minimum, scaled_jacobian);
    sum += scaled_jacobian;
  }

  void add(const Quality_counts& part)
  {
    inverted += part.inverted;
    invalid += part.invalid;
    minimum = (std::min)(minimum, part.minimum);
    sum += part.sum;
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_COUNTS_H
