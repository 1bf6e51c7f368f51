// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_CORNERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_CORNERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which cells of a VTK file a Medit file can hold beside hexahedra.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// The corners of a line, a triangle or a quadrilateral, in order around it; of any other cell none.
inline std::vector<std::size_t> medit_corners(const CGAL::IO::Hex_mesh_cell& cell)
{
  const std::vector<std::size_t>& v = cell.vertices;
  if ((cell.type == 3 && v.size() == 2) || (cell.type == 5 && v.size() == 3) || (cell.type == 9 && v.size() == 4))
    return v;
  if (cell.type == 8 && v.size() == 4) // a pixel: in lexicographic order
    return {v[0], v[1], v[3], v[2]};
  return {};
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_CORNERS_H
