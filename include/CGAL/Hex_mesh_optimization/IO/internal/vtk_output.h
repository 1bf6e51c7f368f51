// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTK_OUTPUT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTK_OUTPUT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What both formats of VTK have in common when they are written: the order of
// the cells, and the arrays on points and cells.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/complete_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/data_values.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/integer_labels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Calls on_hexahedron(h) and on_other(cell) in the order of the file.
template <class On_hexahedron, class On_other>
void for_each_cell(std::size_t number_of_hexahedra, const CGAL::IO::Hex_mesh_data& mesh_data,
                   const On_hexahedron& on_hexahedron, const On_other& on_other)
{
  auto other = mesh_data.other_cells.begin();
  const auto end = mesh_data.other_cells.end();
  for (std::size_t h = 0; h < number_of_hexahedra; ++h) {
    for (; other != end && other->number_of_hexahedra_before <= h; ++other)
      on_other(*other);
    on_hexahedron(h);
  }
  for (; other != end; ++other)
    on_other(*other);
}

// The arrays on points and cells as they are to be written: those of the mesh_data, with the labels in them, or
// beside them where they come from another format.
class Arrays_to_write
{
public:
  using Array = CGAL::IO::Hex_mesh_data_array;

  // Throws Hex_mesh_file_error if the mesh_data do not fit to the mesh.
  Arrays_to_write(const std::string& filename, std::size_t number_of_points, std::size_t number_of_hexahedra,
                  const CGAL::IO::Hex_mesh_data& mesh_data)
  {
    const std::size_t number_of_cells = number_of_hexahedra + mesh_data.other_cells.size();
    const auto check = [&](bool holds, const char* reason) {
      if (!holds)
        throw CGAL::IO::Hex_mesh_file_error(filename, 0, reason);
    };
    for (const auto& cell : mesh_data.other_cells)
      for (const std::size_t v : cell.vertices)
        check(v < number_of_points, "a cell refers to a point that does not exist");
    check(mesh_data.vertex_labels.empty() || mesh_data.vertex_labels.size() == number_of_points,
          "the number of labels is not the number of elements");
    check(mesh_data.hexahedron_labels.empty() || mesh_data.hexahedron_labels.size() == number_of_hexahedra,
          "the number of labels is not the number of elements");
    for (const Array& array : mesh_data.point_data)
      check(has_tuples(array, number_of_points), "the size of an array is not the number of points");
    for (const Array& array : mesh_data.cell_data)
      check(has_tuples(array, number_of_cells), "the size of an array is not the number of cells");

    set_arrays(mesh_data.point_data, medit_label_name, mesh_data.vertex_labels, point_label_storage_, point_data);
    std::vector<std::int64_t> labels;
    const auto has_label = [](const CGAL::IO::Hex_mesh_cell& cell) { return cell.label != 0; };
    const bool has_labels = !mesh_data.hexahedron_labels.empty() ||
                            std::any_of(mesh_data.other_cells.begin(), mesh_data.other_cells.end(), has_label);
    if (has_labels)
      for_each_cell(
        number_of_hexahedra, mesh_data,
        [&](std::size_t h) {
          labels.push_back(mesh_data.hexahedron_labels.empty() ? 0 : mesh_data.hexahedron_labels[h]);
        },
        [&](const CGAL::IO::Hex_mesh_cell& cell) { labels.push_back(cell.label); });
    set_arrays(mesh_data.cell_data, mesh_data.label_array.empty() ? medit_label_name : mesh_data.label_array, labels,
               cell_label_storage_, cell_data);
  }

  Arrays_to_write(const Arrays_to_write&) = delete;
  Arrays_to_write& operator=(const Arrays_to_write&) = delete;

  std::vector<const Array*> point_data, cell_data;

private:
  static void set_arrays(const std::vector<Array>& arrays, const std::string& label_name,
                         const std::vector<std::int64_t>& labels, Array& storage, std::vector<const Array*>& result)
  {
    bool is_there = labels.empty();
    for (const Array& array : arrays) {
      result.push_back(&array);
      std::vector<std::int64_t> present;
      if (is_there || array.name != label_name || array.number_of_components != 1 || array.size() != labels.size() ||
          !integer_labels(array, present))
        continue;
      is_there = true;
      if (present == labels)
        continue;
      storage = array;
      std::visit(
        [&](auto& values) {
          using Value = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (!is_string<Value>)
            for (std::size_t i = 0; i < values.size(); ++i)
              values[i] = static_cast<Value>(labels[i]);
        },
        storage.values);
      result.back() = &storage;
    }
    // Where all are 0, nobody has set any.
    if (is_there || std::all_of(labels.begin(), labels.end(), [](std::int64_t label) { return label == 0; }))
      return;
    const auto [least, most] = std::minmax_element(labels.begin(), labels.end());
    storage.name = label_name;
    if (*least >= (std::numeric_limits<std::int32_t>::min)() && *most <= (std::numeric_limits<std::int32_t>::max)())
      storage.values = std::vector<std::int32_t>(labels.begin(), labels.end());
    else
      storage.values = labels;
    result.push_back(&storage);
  }

  Array point_label_storage_, cell_label_storage_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTK_OUTPUT_H
