// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_SURFACE_REPAIR_H
#define CGAL_HEX_MESH_OPTIMIZATION_SURFACE_REPAIR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a repair of a surface changed.

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * The result of `repair_surface()` of a triangle soup.
 */
struct Surface_repair
{
  std::size_t number_of_filled_holes = 0; ///< Of any size.
  double largest_filled_hole = 0;         ///< The diagonal of its box, a length.

  std::size_t number_of_skipped_vertices = 0;          ///< That were pulled through the opposite side.
  std::vector<std::array<double, 3>> skipped_vertices; ///< Where they were.
  double farthest = 0;                                 ///< How far these were from the surface as it is now, a length.

  double volume_before = 0; ///< That the surface bounded, its holes closed.
  double volume_after = 0;  ///< That it bounds now.
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_SURFACE_REPAIR_H
