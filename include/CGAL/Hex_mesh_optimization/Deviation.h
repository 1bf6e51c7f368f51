// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How far the boundary of a mesh and the reference surface are from each other.

#include <limits>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * Two-sided distance between the boundary of the mesh and the reference surface, measured at the vertices of both and
 * at points spread evenly over both. Average and maximum are each the larger one of both directions.
 *
 * Between those points the surfaces may be a little farther apart than the measured maximum; they are nowhere farther
 * apart than the certified one. Both are about the surface of triangles that each quad of the boundary makes when split
 * from its first corner.
 */
struct Deviation
{
  double average = 0;          ///< In units of length.
  double maximum = 0;          ///< In units of length; measured, not more than the true one.
  double average_relative = 0; ///< Over the diagonal of the bounding box of the reference.
  double maximum_relative = 0; ///< Over the diagonal of the bounding box of the reference.

  /// In units of length, an upper bound of the maximum, shown; infinite where none was asked for. It is no tighter than
  /// it takes to show that `maximum_deviation` is obeyed; where that is not so, it is within a percent of the true
  /// maximum unless the surfaces are too entangled.
  double certified = std::numeric_limits<double>::infinity();

  /// In units of length, an upper bound of how far a quad of the boundary, taken for bilinear, is from its two
  /// triangles.
  double bilinear = 0;
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H
