// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_MESH_SLICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_MESH_SLICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where a mesh comes from, and where its points go: slice by slice.

#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>

#include <algorithm>
#include <array>

namespace CGAL::Hex_mesh_optimization::internal {

class Mesh_slices
{
public:
  virtual ~Mesh_slices() = default;

  virtual Global_index number_of_vertices() const = 0;
  virtual Global_index number_of_hexahedra() const = 0;
  virtual bool has_labels() const { return false; }

  virtual void read_hexahedra(Global_index first, Global_index last, std::array<Global_index, 8>* hexahedra) = 0;
  virtual void read_points(Global_index first, Global_index last, std::array<double, 3>* points) = 0;
  virtual void read_labels(Global_index, Global_index, int*) {}
  // Of the vertices, whether they must not move.
  virtual void read_fixed(Global_index first, Global_index last, char* is_fixed)
  {
    std::fill(is_fixed, is_fixed + (last - first), char(false));
  }

  virtual void write_points(Global_index first, Global_index last, const std::array<double, 3>* points) = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_MESH_SLICES_H
