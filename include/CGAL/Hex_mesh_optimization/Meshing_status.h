// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H
#define CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the functions that make a mesh from a surface report.

#include <CGAL/Hex_mesh_optimization/Status.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * The result of `CGAL::voxel_mesh()`.
 */
struct Voxel_status
{
  double spacing = 0; ///< The length of the cells, the geometric mean of the three axes.

  /// `false` if the boundary of the cells and the surface have different Euler characteristics: holes are closed, walls
  /// have holes, or components are lost.
  bool has_topology_of_surface = true;

  /// The faces of the surface, in increasing order, that have fewer cells between them and the opposite wall than
  /// `cells_across` asks for: there thin parts are coarser than wanted, or lost.
  std::vector<std::size_t> thin_faces;
};

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * The result of `CGAL::make_hex_mesh()`: that of the optimization, where `Status::before` is the mesh that it started
 * from, and that of the grid.
 */
struct Meshing_status : Status, Voxel_status
{};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H
