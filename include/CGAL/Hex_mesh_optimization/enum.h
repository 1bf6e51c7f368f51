// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_ENUM_H
#define CGAL_HEX_MESH_OPTIMIZATION_ENUM_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The enumerations of the package: what a caller can choose, and the answers that
// are one of a few words.

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * How to optimize.
 */
enum class Method {
  FULL, ///< Removal of inverted hexahedra, by edge-cone rectification where they cannot be untangled where they
        ///< are, then quality maximization.
  RECTIFICATION, ///< Edge-cone rectification alone: the method of the paper.
  MAXIMIZATION   ///< Quality maximization alone, after the removal of inverted hexahedra: for nearly valid meshes.
};

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * Where target edge lengths come from when no map gives them.
 */
enum class Target_edge_lengths {
  /// From the lengths of the boundary edges, smoothly into the interior (eq. 22 of the paper); a valid mesh on its
  /// reference keeps its own where they are meant, as in layers, and a tangled one the thickness of thin parts whose
  /// boundary is sound.
  ESTIMATED,
  /// The lengths in the input, closely: for meshes that are graded on purpose and not tangled.
  INPUT
};

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * Where the vertices of the boundary have to be.
 */
enum class Boundary_placement {
  WITHIN_TOLERANCE, ///< Off the reference where that buys quality, but no farther than is tolerated. Corners are exact.
  ON_SURFACE        ///< On the reference exactly, sliding in it, and along its feature curves; corners do not move.
};

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * What becomes of the target edge lengths once the local-global iterations have settled.
 */
enum class Edge_length_update {
  NONE,      ///< They stay.
  SELECTIVE, ///< They move to the reached lengths where the quality is low (eq. 23 and 24 of the paper).
  FULL       ///< The reached lengths are the new targets (first option of Section 3.4 of the paper).
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The parts an optimization consists of.
 */
enum class Stage {
  RECTIFICATION, ///< Edge-cone rectification: local and global steps in turn.
  UNTANGLING,    ///< Removal of inverted hexahedra where they are, or of those that rectification leaves.
  MAXIMIZATION   ///< Maximization of the worst and the average quality.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * returns the name of a stage, in lower case.
 */
inline const char* name(Stage stage)
{
  switch (stage) {
  case Stage::RECTIFICATION:
    return "rectification";
  case Stage::UNTANGLING:
    return "untangling";
  case Stage::MAXIMIZATION:
    return "maximization";
  }
  return "";
}

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * Why an optimization stopped. None of these says that the mesh is valid: ask `Status::valid_mesh()`.
 */
enum class Return_code {
  CONVERGED, ///< Further iterations would not improve the mesh: the last stage ended as nothing was gained any more.
  TARGET_QUALITY_REACHED,  ///< The minimum scaled Jacobian reached `target_quality`, on the reference.
  ITERATION_LIMIT,         ///< The number of iterations of the last stage was used up while the mesh still changed.
  TIME_LIMIT,              ///< `maximum_running_time` was over.
  STOPPED_BY_VISITOR,      ///< The visitor asked to stop.
  DEVIATION_BOUND_NOT_MET, ///< The boundary and the reference are not certified to be as close as `maximum_deviation`.
  NO_IMPROVEMENT           ///< Nothing better than the input was found: all positions are as they were.
};

/// \ingroup PkgHexMeshOptimizationQuality
/// The answer of `hexahedron_validity()`.
enum class Validity {
  VALID,    ///< The Jacobian determinant is positive everywhere in the hexahedron: proven.
  INVALID,  ///< The Jacobian determinant is zero or negative somewhere: proven.
  UNDECIDED ///< Neither was proven within the limit on the subdivision.
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_ENUM_H
