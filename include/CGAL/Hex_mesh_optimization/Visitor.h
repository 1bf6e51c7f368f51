// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_VISITOR_H
#define CGAL_HEX_MESH_OPTIMIZATION_VISITOR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How a caller watches an optimization, and stops it.

#include <CGAL/Hex_mesh_optimization/enum.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The best state of the run after one iteration, in the order of goals: what the mesh becomes if the run is stopped then.
 */
struct Iteration
{
  Stage stage;           ///< The part of the optimization that it belongs to.
  std::size_t iteration; ///< Counted from 0 within the stage.
  double energy; ///< Of the stage, in the state of the iteration (eq. 25 of the paper for rectification); scale-free.
  std::size_t number_of_inverted; ///< Hexahedra with a corner of scaled Jacobian at most 0.
  double minimum;                 ///< Least scaled Jacobian over the hexahedra (8 corners).
  double average;                 ///< Mean of the scaled Jacobians of the hexahedra.
  double seconds;                 ///< Wall-clock time since the call.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The visitor that does nothing.
 *
 * \cgalModels{HexMeshOptimizationVisitor}
 */
struct Default_visitor
{
  /// Called after each iteration. The optimization goes on if it returns `true`; on `false` the mesh takes the best
  /// positions so far. An exception passes through and leaves the mesh as it was before the call.
  bool on_iteration(const Iteration&) { return true; }
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_VISITOR_H
