// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_ELEMENTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_ELEMENTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The types of elements in files of Gmsh, by their numbers there.

#include <cstddef>
#include <cstdint>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// 0 if the type is not known.
inline std::size_t gmsh_number_of_nodes(std::int64_t type)
{
  constexpr std::uint16_t numbers[] = {
    0,  2,   3,   4,   4,   8,   6,   5,   3,   6,   9,   10,  27,  18,  14,  1,   8,   20,  15,   13, // 0 to 19
    9,  10,  12,  15,  15,  21,  4,   5,   6,   20,  35,  56,  22,  28,  0,   0,   16,  25,  36,   12, // 20 to 39
    16, 20,  28,  36,  45,  55,  66,  49,  64,  81,  100, 121, 18,  21,  24,  27,  30,  24,  28,   32, // 40 to 59
    36, 40,  7,   8,   9,   10,  11,  0,   0,   0,   0,   84,  120, 165, 220, 286, 0,   0,   0,    34, // 60 to 79
    40, 46,  52,  58,  1,   1,   1,   1,   0,   1,   40,  75,  64,  125, 216, 343, 512, 729, 1000, 32, // 80 to 99
    44, 56,  68,  80,  92,  104, 126, 196, 288, 405, 550, 24,  33,  42,  51,  60,  69,  78,  30,   55, // 100 to 119
    91, 140, 204, 285, 385, 21,  29,  37,  45,  53,  61,  69,  1,   0,   0,   0,   0,   4,   5};       // 120 to 138
  constexpr std::int64_t size = sizeof(numbers) / sizeof(numbers[0]);
  return type > 0 && type < size ? numbers[type] : 0;
}

inline bool gmsh_is_hexahedron(std::int64_t type)
{
  return type == 5 || type == 12 || type == 17 || (type >= 92 && type <= 105);
}

// Of what is not known: 3.
inline int gmsh_dimension(std::int64_t type)
{
  if (type == 15)
    return 0;
  for (std::int64_t line : {1, 8, 26, 27, 28, 62, 63, 64, 65, 66, 84})
    if (type == line)
      return 1;
  if ((type >= 20 && type <= 25) || (type >= 36 && type <= 61))
    return 2;
  for (std::int64_t face : {2, 3, 9, 10, 16, 34, 85, 86, 138})
    if (type == face)
      return 2;
  return 3;
}

// 0 if there is none with the same order of nodes.
inline int gmsh_vtk_type(std::int64_t type)
{
  constexpr int types[] = {0, 3, 5, 9, 10, 12, 13, 14, 21, 22, 28, 0, 12, 0, 0, 1, 23, 12};
  if (gmsh_is_hexahedron(type))
    return 12;
  return type > 0 && type < 18 ? types[type] : 0;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_ELEMENTS_H
