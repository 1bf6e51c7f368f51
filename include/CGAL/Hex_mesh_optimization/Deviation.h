// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H

// How far the boundary of a mesh and the reference surface are from each other.

namespace CGAL {
namespace Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * Two-sided distance between the boundary of the mesh and the reference surface, measured at the vertices of both and
 * at points spread evenly over both. Average and maximum are each the larger one of both directions.
 */
struct Deviation
{
  double average = 0;          ///< In units of length.
  double maximum = 0;          ///< In units of length.
  double average_relative = 0; ///< Over the diagonal of the bounding box of the reference.
  double maximum_relative = 0; ///< Over the diagonal of the bounding box of the reference.
};

} } // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_DEVIATION_H
