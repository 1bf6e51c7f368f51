// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a mesh file holds beside points and hexahedra, carried from the reader
// to the writer.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/integer_labels.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * A cell of a mesh file that is no hexahedron: a vertex, a line, a polygon.
 */
struct Hex_mesh_cell
{
  int type = 0; ///< in the numbering of VTK: 1 for a vertex, 3 for a line, 5 for a triangle, 9 for a quadrilateral, ...
  std::vector<std::size_t> vertices; ///< in the order of VTK

  /// from a Medit file, or from the array that the labels of the hexahedra are from; else 0
  std::int64_t label = 0;

  /// its place among the cells of a VTK file
  std::size_t number_of_hexahedra_before = 0;
};

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * What a file holds beside points and hexahedra. Readers replace all members. Writers write all that their format can
 * hold; `CGAL::IO::unsupported_data()` tells what it cannot.
 */
struct Hex_mesh_data
{
  /// A quadrilateral of the file with its label.
  struct Labelled_quadrilateral
  {
    std::array<std::size_t, 4> vertices; ///< in order around it
    std::int64_t label;                  ///< 0 if it has none
  };

  /// one label per point, or empty: the last number of a vertex in a Medit file, the array `medit:ref` in a VTK file
  std::vector<std::int64_t> vertex_labels;

  /// one label per hexahedron, or empty if the file has none: the last number of a hexahedron in a Medit file; in a
  /// VTK file, `label_array`. A `.mesh` file is written with 0 if there are none.
  std::vector<std::int64_t> hexahedron_labels;

  /// the name of the array of `cell_data` that the labels are from; empty if there is none
  std::string label_array;

  /// the cells that are no hexahedra, in the order of the file: those of other kinds in a VTK file; quadrilaterals,
  /// triangles and edges of a Medit file
  std::vector<Hex_mesh_cell> other_cells;

  std::vector<Hex_mesh_data_array> point_data; ///< arrays of a VTK file with a tuple for each point
  /// arrays of a VTK file with a tuple for each cell: hexahedra and `other_cells` together, in the order of the file
  std::vector<Hex_mesh_data_array> cell_data;
  std::vector<Hex_mesh_data_array> field_data; ///< arrays of a VTK file on the mesh as a whole

  /// all other sections of a Medit file (`Corners`, `RequiredVertices`, ...), verbatim, in the order of the file
  std::string other_sections;

  std::string title;      ///< the second line of a `.vtk` file
  bool is_binary = false; ///< whether the numbers of a VTK file were binary

  /// what the reader has skipped, because it is damaged or of a kind that is not known: one line for each
  std::vector<std::string> skipped;

  /// the quadrilaterals among `other_cells`
  std::vector<Labelled_quadrilateral> labelled_quadrilaterals() const
  {
    std::vector<Labelled_quadrilateral> result;
    for (const Hex_mesh_cell& cell : other_cells)
      if ((cell.type == 8 || cell.type == 9) && cell.vertices.size() == 4) {
        const std::vector<std::size_t>& v = cell.vertices;
        const bool is_pixel = cell.type == 8; // corners in lexicographic order
        result.push_back({{v[0], v[1], v[is_pixel ? 3 : 2], v[is_pixel ? 2 : 3]}, cell.label});
      }
    return result;
  }

  /// takes the labels of hexahedra and other cells from the array of `cell_data` with this name, exactly; returns
  /// `false` and changes nothing if there is none, or if it is not of one integral number for each cell.
  bool use_label_array(const std::string& name)
  {
    for (const Hex_mesh_data_array& array : cell_data)
      if (array.name == name && use_labels(array))
        return true;
    return false;
  }

  /// takes the labels from the first array of `cell_data`, if any, that has a name which is usual for labels (see the
  /// manual) and one integral number for each cell.
  void find_label_array()
  {
    namespace io = Hex_mesh_optimization::internal::IO;
    for (const char* usual : io::usual_label_names)
      for (const Hex_mesh_data_array& array : cell_data)
        if (io::plain_name(array.name) == usual && use_labels(array))
          return;
  }

private:
  bool use_labels(const Hex_mesh_data_array& array)
  {
    std::vector<std::int64_t> labels;
    if (array.number_of_components != 1 || array.size() < other_cells.size() ||
        !Hex_mesh_optimization::internal::IO::integer_labels(array, labels))
      return false;
    hexahedron_labels.clear();
    std::size_t next = 0; // of the other cells
    for (std::size_t c = 0; c < labels.size(); ++c)
      if (next < other_cells.size() && other_cells[next].number_of_hexahedra_before <= hexahedron_labels.size())
        other_cells[next++].label = labels[c];
      else
        hexahedron_labels.push_back(labels[c]);
    label_array = array.name;
    return true;
  }
};

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_DATA_H
