// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ADD_VTK_CELL_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ADD_VTK_CELL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the cell types of VTK mean, in its legacy and its XML format.

#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Sorts a cell of an unstructured grid into the content. Returns an empty
// string, or what is wrong with the cell.
inline std::string add_vtk_cell(Mesh_file_content& content, Wanted_cells wanted, std::int64_t type,
                                const std::size_t* vertices, std::size_t size)
{
  const auto has_other_size_than = [&](std::size_t expected) {
    return "it has " + std::to_string(size) + " vertices, not " + std::to_string(expected);
  };
  const auto add_polygon = [&](std::initializer_list<std::size_t> corners) {
    content.polygons.emplace_back();
    for (const std::size_t c : corners)
      content.polygons.back().push_back(vertices[c]);
  };

  const auto add_hexahedron = [&] {
    content.hexahedra.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) // a voxel has the corners of a box in lexicographic order
      content.hexahedra.back()[c] = vertices[type == 11 && c % 4 > 1 ? 5 - c % 4 + (c & 4) : c];
  };

  if (wanted == Wanted_cells::HEXAHEDRA) {
    switch (type) {
    case 11:
    case 12:
      if (size != 8)
        return has_other_size_than(8);
      add_hexahedron();
      return std::string();
    // Cells of lower dimension, from the empty cell to the polygon on a Bezier surface.
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
    case 8:
    case 9:
    case 21:
    case 22:
    case 23:
    case 28:
    case 30:
    case 34:
    case 35:
    case 36:
    case 51:
    case 52:
    case 53:
    case 54:
    case 60:
    case 61:
    case 62:
    case 63:
    case 68:
    case 69:
    case 70:
    case 75:
    case 76:
    case 77:
      content.mesh_data.other_cells.push_back(
        {static_cast<int>(type), std::vector<std::size_t>(vertices, vertices + size), 0, content.hexahedra.size()});
      return std::string();
    case 10:
      return "it is a tetrahedron, not a hexahedron";
    case 13:
      return "it is a wedge, not a hexahedron";
    case 14:
      return "it is a pyramid, not a hexahedron";
    case 25:
    case 29:
    case 33:
    case 72:
    case 79:
      return "it is a hexahedron of higher order (type " + std::to_string(type) + ", " + std::to_string(size) +
             " nodes): only hexahedra with eight vertices can be optimized";
    default:
      return "it has type " + std::to_string(type) + ", which is no hexahedron with eight vertices";
    }
  }

  switch (type) {
  case 5:
    if (size != 3)
      return has_other_size_than(3);
    add_polygon({0, 1, 2});
    return std::string();
  case 8:
    if (size != 4)
      return has_other_size_than(4);
    add_polygon({0, 1, 3, 2});
    return std::string();
  case 9:
    if (size != 4)
      return has_other_size_than(4);
    add_polygon({0, 1, 2, 3});
    return std::string();
  case 6:
    for (std::size_t i = 2; i < size; ++i)
      add_polygon({i - 2 + i % 2, i - 1 - i % 2, i});
    return std::string();
  case 7:
    content.polygons.emplace_back(vertices, vertices + size);
    return std::string();
  case 11:
  case 12: // they tell which polygons are within
    if (size == 8)
      add_hexahedron();
    return std::string();
  default:
    return std::string();
  }
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ADD_VTK_CELL_H
