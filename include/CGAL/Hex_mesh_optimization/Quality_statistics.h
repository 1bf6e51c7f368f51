// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_QUALITY_STATISTICS_H
#define CGAL_HEX_MESH_OPTIMIZATION_QUALITY_STATISTICS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The qualities of a hexahedral mesh in a few numbers, which quality_statistics()
// computes.

#include <cstddef>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The quality of a hexahedral mesh in a few numbers. All qualities are free of a unit. In a mesh without
 * hexahedra, every number is 0.
 */
struct Quality_statistics
{
  /// The number of hexahedra of the mesh.
  std::size_t number_of_hexahedra = 0;

  /// The number of hexahedra with a scaled Jacobian of 0 or less.
  std::size_t number_of_inverted = 0;

  /// The number of hexahedra not certified by `is_valid_hexahedron()`: but for rounding at a scaled
  /// Jacobian of 0, the inverted ones and those that are folded between their corners.
  std::size_t number_of_invalid = 0;

  /// The minimum over the hexahedra of `scaled_jacobian()`.
  double minimum = 0;

  /// The average over the hexahedra of `scaled_jacobian()`.
  double average = 0;

  /// The standard deviation over the hexahedra of `scaled_jacobian()`; the divisor is the number of hexahedra.
  double standard_deviation = 0;

  /// The minimum over the hexahedra of `scaled_jacobian_with_center()`.
  double minimum_with_center = 0;

  /// The average over the hexahedra of `scaled_jacobian_with_center()`.
  double average_with_center = 0;

  /// The maximum over the hexahedra of `edge_ratio()`.
  double maximum_edge_ratio = 0;

  /// The median of `edge_ratio()`: entry `n / 2` of the `n` sorted values.
  double median_edge_ratio = 0;

  /// The 99th percentile of `edge_ratio()`: entry `n * 99 / 100` of the `n` sorted values.
  double edge_ratio_99 = 0;
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_QUALITY_STATISTICS_H
