// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_MESH_DIVISION_H
#define CGAL_HEX_MESH_OPTIMIZATION_MESH_DIVISION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How a mesh in a file is divided into parts that are optimized apart from each other.

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 * How `CGAL::optimize_hex_mesh_file()` divides a mesh.
 */
struct Mesh_division
{
  int number_of_parts = 0;        ///< As many; 0: as many as `maximum_memory` asks for, or one.
  std::size_t maximum_memory = 0; ///< In bytes, of the process; 0: as much as it takes.
  int layers = 4;                 ///< Of hexahedra around what parts have held, which those of the next round have.
  std::string label_array;        ///< Of the cells, with their labels; empty: one with a usual name, if there is one.

  /// How many parts a mesh of so many hexahedra has.
  int number_of_parts_of(std::size_t number_of_hexahedra) const
  {
    // measured: what a part takes, and what is there before and beside it
    constexpr std::size_t of_hexahedron = 3000, of_process = std::size_t(200) << 20;
    if (number_of_parts > 0)
      return number_of_parts;
    if (maximum_memory == 0)
      return 1;
    const std::size_t of_part = (std::max)(maximum_memory, of_process + (std::size_t(50) << 20)) - of_process;
    return static_cast<int>(1 + number_of_hexahedra * of_hexahedron / of_part);
  }
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_MESH_DIVISION_H
