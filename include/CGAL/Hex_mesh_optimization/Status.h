// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_STATUS_H
#define CGAL_HEX_MESH_OPTIMIZATION_STATUS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What an optimization reports: why it stopped, and what the mesh was and is.

#include <CGAL/Hex_mesh_optimization/Connectivity_limit.h>
#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/enum.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The volume of all hexahedra with one label.
 */
struct Region_volume
{
  int label;     ///< Of the hexahedra.
  double before; ///< Of the mesh that came in; as trilinear maps, where they fold with their signs.
  double after;  ///< Of the mesh as it is now.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * A piece of the mesh whose volume has changed by more than one percent: hexahedra with one label that are connected
 * through faces.
 */
struct Volume_change
{
  int label;                        ///< Of the hexahedra.
  std::size_t hexahedron;           ///< The first of them.
  std::size_t number_of_hexahedra;  ///< Of this piece.
  double before;                    ///< The volume that came in; as trilinear maps, where they fold with their signs.
  double after;                     ///< The volume now.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * What became of the faces between the hexahedra of two labels, or of the internal faces within one.
 */
struct Interface_statistics
{
  std::array<int, 2> labels;   ///< In increasing order.
  std::size_t number_of_faces; ///< Quadrangles between the two labels.
  Deviation deviation;         ///< Two-sided, from where the faces were.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * One way that was taken from the best mesh so far to a better one, of those that the manual lists.
 */
struct Attempt
{
  std::string name;               ///< As in the manual.
  bool is_taken;                  ///< Whether what it has led to is the best mesh since then.
  std::size_t iterations;         ///< Over all stages of this attempt.
  double seconds;                 ///< Wall-clock time.
  std::size_t number_of_inverted; ///< Of the hexahedra that it has led to.
  double minimum;                 ///< Of their scaled Jacobians.
  double average;                 ///< Of their scaled Jacobians.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * The result of `CGAL::optimize_hex_mesh()`. Hexahedra and vertices are listed by their indices; those of a linear cell
 * complex are the ones that `linear_cell_complex_to_hexahedra()` gives them.
 */
struct Status
{
  Return_code return_code = Return_code::NO_IMPROVEMENT; ///< Why it stopped.

  Quality_statistics before; ///< Of the mesh that came in.
  Quality_statistics after;  ///< Of the mesh as it is now.
  Deviation deviation;       ///< Of the mesh as it is now; of its interfaces too.

  std::vector<Region_volume> regions;           ///< One for each label, in increasing order.
  std::vector<Interface_statistics> interfaces; ///< One for each pair of labels that has one, in increasing order.

  double volume_before =
    0; ///< Of all hexahedra of the mesh that came in, as trilinear maps; where they fold, with their signs.
  double volume_after = 0; ///< Of the mesh as it is now.

  /// The pieces whose volume has changed by more than one percent, by their first hexahedra. A reference has its own
  /// volume; without one, no piece that comes in with a sound boundary should be here.
  std::vector<Volume_change> volume_changes;

  double deviation_bound = std::numeric_limits<double>::infinity(); ///< `maximum_deviation` as it was given, a length.

  std::size_t iterations = 0;    ///< Over all stages.
  std::vector<Attempt> attempts; ///< In the order in which they were made.

  double rectification_seconds = 0; ///< Wall-clock time of edge-cone rectification.
  double untangling_seconds = 0;    ///< Wall-clock time of untangling.
  double maximization_seconds = 0;  ///< Wall-clock time of quality maximization.
  /// Wall-clock time of everything: also of set-up, of a smooth interior to start from, and of final measurements.
  double total_seconds = 0;

  /// The hexahedra whose trilinear map is not certified to be valid, in increasing order.
  std::vector<std::size_t> invalid_hexahedra;

  /// Those of them with an inverted corner whose four vertices are all fixed: only the boundary could resolve them.
  std::vector<std::size_t> locked_hexahedra;

  /// The vertices that do not stand exactly where they are to stand, on a corner of the reference or, with
  /// `Boundary_placement::ON_SURFACE`, on its curves and faces, in increasing order: hexahedra that have them would
  /// have been ruined, or the run ended before they arrived. With `Boundary_placement::ON_SURFACE`, those that belong to
  /// corners and curves stand on the surface all the same, if hexahedra can hold them there.
  std::vector<std::size_t> vertices_off_reference;

  /// The hexahedra that are no better than a limit that the connectivity sets, whether they reach it or not, in
  /// increasing order.
  std::vector<Connectivity_limit> connectivity_limits;

  /// The hexahedra that were numbered inside out, in increasing order: they were taken with their bottom and top
  /// exchanged (the first four vertices with the last four), and the statistics refer to that numbering. The hexahedra
  /// that are connected through faces agree with each other, and the volume that their boundary encloses is positive.
  std::vector<std::size_t> reoriented_hexahedra;

  /// The number of `reoriented_hexahedra`.
  std::size_t number_of_reoriented_hexahedra() const { return reoriented_hexahedra.size(); }

  /// How many vertices would be gone if those were merged that faces of the boundary have in the same places: hexahedra
  /// with vertices of their own there are no neighbors. See `coincident_vertices()`.
  std::size_t number_of_coincident_vertices = 0;

  /// `true` if the trilinear map of every hexahedron is certified to be valid (see `is_valid_hexahedron()`).
  bool valid_mesh() const { return invalid_hexahedra.empty(); }

  /// `true` if the maximum deviation is certified to be at most `deviation_bound`, or if no bound was given. That the
  /// measured maximum is below the bound is not enough.
  bool is_within_deviation_bound() const { return deviation.certified <= deviation_bound; }
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_STATUS_H
