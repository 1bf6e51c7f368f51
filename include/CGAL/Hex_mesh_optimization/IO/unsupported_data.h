// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_UNSUPPORTED_DATA_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_UNSUPPORTED_DATA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What of a mesh file another format cannot hold.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/extension_of.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/integer_labels.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/medit_corners.h>

#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * returns what of `mesh_data` is not in a file with the extension of `filename` (`.mesh`, `.vtk`, `.vtu`) after it
 * has been written with `write_hex_mesh()`: one line for each, in words for the user.
 */
inline std::vector<std::string> unsupported_data(const std::string& filename, const Hex_mesh_data& mesh_data)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  using Array = Hex_mesh_data_array;
  std::vector<std::string> lost;
  const auto quoted = [](const Array& array) { return " \"" + array.name + '"'; };
  const std::string extension = io::extension_of(filename);
  if (extension != "mesh" && extension != "vtk" &&
      extension != "vtu") { // of a solver: labels of cells and faces remain
    for (const auto* arrays : {&mesh_data.point_data, &mesh_data.cell_data, &mesh_data.field_data})
      for (const Array& array : *arrays)
        if (array.name != mesh_data.label_array || array.name.empty())
          lost.push_back("the array" + quoted(array));
    std::size_t other_cells = mesh_data.other_cells.size();
    for (const auto& quadrilateral : mesh_data.labelled_quadrilaterals())
      other_cells -= quadrilateral.label != 0;
    if (other_cells > 0)
      lost.push_back(std::to_string(other_cells) + " cells that are neither hexahedra nor quadrilaterals with a label");
    if (!mesh_data.other_sections.empty())
      lost.push_back("the other sections of the file");
    return lost;
  }
  if (extension == "mesh") {
    for (const Array& array : mesh_data.point_data)
      if (array.name != io::medit_label_name || mesh_data.vertex_labels.empty())
        lost.push_back("the array" + quoted(array) + " of the points");
    for (const Array& array : mesh_data.cell_data)
      if (array.name != mesh_data.label_array || mesh_data.label_array.empty())
        lost.push_back("the array" + quoted(array) + " of the cells");
    for (const Array& array : mesh_data.field_data)
      lost.push_back("the array" + quoted(array) + " of the mesh");
    std::map<int, std::size_t> counts;
    for (const Hex_mesh_cell& cell : mesh_data.other_cells)
      if (io::medit_corners(cell).empty())
        ++counts[cell.type];
    for (const auto& [type, count] : counts)
      lost.push_back(std::to_string(count) + " cells of VTK type " + std::to_string(type));
    return lost;
  }

  // The keywords of Medit begin with a capital letter.
  std::istringstream lines(mesh_data.other_sections);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;)
      if (word[0] >= 'A' && word[0] <= 'Z' && io::lowered(word) != "nan" && io::lowered(word) != "inf" &&
          io::lowered(word) != "infinity")
        lost.push_back("the section " + word);
  }
  const bool is_vtu = extension == "vtu";
  for (const auto* arrays : {&mesh_data.point_data, &mesh_data.cell_data, &mesh_data.field_data})
    for (const Array& array : *arrays) {
      if (is_vtu && array.role == Array::Role::LOOKUP_TABLE)
        lost.push_back("the lookup table" + quoted(array));
      else if (is_vtu && !array.metadata.empty())
        lost.push_back("the metadata of the array" + quoted(array));
      for (const auto& [name, value] : array.attributes)
        if (!is_vtu)
          lost.push_back("the attribute " + name + "=\"" + value + "\" of the array" + quoted(array));
    }
  return lost;
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_UNSUPPORTED_DATA_H
