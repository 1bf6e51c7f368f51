// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_CONNECTIVITY_LIMIT_H
#define CGAL_HEX_MESH_OPTIMIZATION_CONNECTIVITY_LIMIT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What no vertex position can repair: hexahedra whose quality is limited by the
// connectivity of the mesh, and why.

#include <cstddef>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * Why the connectivity limits the quality of a hexahedron. Of several reasons with the same limit, the first one of
 * this list is named.
 */
enum class Connectivity_limit_reason {
  FLAT_EDGE,       ///< Two of its boundary faces meet at an edge within the smooth surface: limit 0.
  FLAT_CURVE,      ///< Two edges at one of its corners continue each other along a feature curve: limit 0.
  INTERIOR_EDGE,   ///< An interior edge has `n` hexahedra around it, not 4: limit sin(360°/`n`), and 0 for `n` < 3.
  INTERIOR_VERTEX, ///< An interior vertex has `n` hexahedra around it, not 8: the limit is that of `n` equal corners.
  CURVE_VERTEX,    ///< A vertex on a feature curve has `n` > 2 boundary faces on one side of it: limit sin(180°/`n`).
  SMOOTH_EDGE,     ///< A boundary edge within the smooth surface has `n` > 2 hexahedra: limit sin(180°/`n`).
  SMOOTH_VERTEX ///< A vertex on the smooth surface has `n` ≠ 4 boundary faces: limit sin(360°/`n`), and 0 for `n` < 3.
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * A hexahedron whose scaled Jacobian is bounded by the connectivity of the mesh, wherever its vertices are. Only other
 * connectivity, or a boundary that leaves the surface, makes it better.
 *
 * A limit that several hexahedra share, such as those around an edge, is reported for each of them. It means that
 * not all of them can be better than this at once; one can, at the expense of its neighbors.
 *
 * The limits of interior edges and vertices hold in every mesh that does not overlap itself. The other ones suppose
 * that the boundary stays on a surface with a tangent plane everywhere but on its features, and that feature curves
 * turn at corners only. They are the limits for edges that are short against the radii of curvature: where the surface
 * or the curve turns by a large angle from one edge to the next, more is possible, and a hexahedron may well be better
 * than its limit. Nothing is claimed about corners of the surface and fixed vertices, nor about the angle between
 * the faces on either side of a feature curve.
 */
struct Connectivity_limit
{
  std::size_t hexahedron;           ///< Its index.
  Connectivity_limit_reason reason; ///< The strictest one.

  /// Upper bound, at least 0 and less than 1, of `scaled_jacobian()`. At 0, the hexahedron is flat at best.
  double largest_scaled_jacobian;

  double scaled_jacobian = -1; ///< What the hexahedron has come to.

  /// Whether that is the limit but for .01: no position can raise it by more.
  bool is_reached() const { return scaled_jacobian >= largest_scaled_jacobian - .01; }
};

/*!
 * \ingroup PkgHexMeshOptimizationResults
 * returns the reason in words that continue "The quality of this hexahedron is limited because".
 */
inline const char* description(Connectivity_limit_reason reason)
{
  switch (reason) {
  case Connectivity_limit_reason::FLAT_EDGE:
    return "two of its boundary faces meet at an edge within the smooth surface";
  case Connectivity_limit_reason::FLAT_CURVE:
    return "two edges at one of its corners continue each other along a feature curve";
  case Connectivity_limit_reason::INTERIOR_EDGE:
    return "one of its interior edges does not have four hexahedra around it";
  case Connectivity_limit_reason::INTERIOR_VERTEX:
    return "one of its interior vertices does not have eight hexahedra around it";
  case Connectivity_limit_reason::CURVE_VERTEX:
    return "one of its vertices on a feature curve has more than two boundary faces on one side of the curve";
  case Connectivity_limit_reason::SMOOTH_EDGE:
    return "one of its boundary edges within the smooth surface has more than two hexahedra";
  case Connectivity_limit_reason::SMOOTH_VERTEX:
    return "one of its vertices on the smooth surface does not have four boundary faces";
  }
  return "";
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_CONNECTIVITY_LIMIT_H
