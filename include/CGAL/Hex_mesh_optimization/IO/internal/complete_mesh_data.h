// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COMPLETE_MESH_DATA_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COMPLETE_MESH_DATA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The last step of reading a VTK file: arrays that do not fit are left out,
// labels are found.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/integer_labels.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Whether the array has a tuple for each of so many elements.
inline bool has_tuples(const CGAL::IO::Hex_mesh_data_array& array, std::size_t count)
{
  return array.role == CGAL::IO::Hex_mesh_data_array::Role::LOOKUP_TABLE ||
         array.size() == array.number_of_components * count;
}

inline void complete_mesh_data(Mesh_file_content& content)
{
  using Array = CGAL::IO::Hex_mesh_data_array;
  CGAL::IO::Hex_mesh_data& mesh_data = content.mesh_data;
  const auto leave_out = [&](std::vector<Array>& arrays, std::size_t count, const std::string& of) {
    const auto is_unfit = [&](const Array& array) {
      if (has_tuples(array, count))
        return false;
      mesh_data.skipped.push_back("the array \"" + array.name + "\" of the " + of + ": it has " +
                                  std::to_string(array.size()) + " values, not " +
                                  std::to_string(array.number_of_components * count));
      return true;
    };
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(), is_unfit), arrays.end());
  };
  leave_out(mesh_data.point_data, content.points.size(), "points");
  leave_out(mesh_data.cell_data, content.hexahedra.size() + mesh_data.other_cells.size(), "cells");
  for (const Array& array : mesh_data.point_data)
    if (array.name == medit_label_name && array.number_of_components == 1 &&
        integer_labels(array, mesh_data.vertex_labels))
      break;
    else
      mesh_data.vertex_labels.clear();
  mesh_data.find_label_array();
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_COMPLETE_MESH_DATA_H
