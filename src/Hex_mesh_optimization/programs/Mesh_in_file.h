// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PROGRAMS_MESH_IN_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_PROGRAMS_MESH_IN_FILE_H

// What a report shows of a mesh that stays in its file.

#include "files.h"

#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_slices.h>

#include <array>
#include <cstddef>
#include <string>

class Mesh_in_file
{
public:
  explicit Mesh_in_file(const std::string& name) : slices_(name, name) {}

  static constexpr bool is_copied = true;
  std::size_t number_of_merged() const { return 0; }

  Kernel::Point_3 center(std::size_t h) const
  {
    namespace internal = CGAL::Hex_mesh_optimization::internal;
    std::array<internal::Global_index, 8> vertices;
    const auto first = static_cast<internal::Global_index>(h);
    slices_.read_hexahedra(first, first + 1, &vertices);
    Kernel::Vector_3 sum(0, 0, 0);
    for (internal::Global_index v : vertices) {
      std::array<double, 3> p;
      slices_.read_points(v, v + 1, &p);
      sum = sum + Kernel::Vector_3(p[0], p[1], p[2]) / 8;
    }
    return CGAL::ORIGIN + sum;
  }

private:
  mutable CGAL::Hex_mesh_optimization::internal::IO::Vtu_slices slices_;
};

#endif // CGAL_HEX_MESH_OPTIMIZATION_PROGRAMS_MESH_IN_FILE_H
