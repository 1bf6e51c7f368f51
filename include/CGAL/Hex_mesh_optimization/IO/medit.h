// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads and writes hexahedral meshes in the Medit format (.mesh, text).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Medit_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/medit_corners.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh from a Medit file (`.mesh`, text).
 *
 * The order of the sections is free. All vertices are read, also those no hexahedron refers to. All other sections are
 * kept in `mesh_data`: `Edges`, `Triangles` and `Quadrilaterals` as cells, the rest verbatim.
 *
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type can be constructed from
 *         three `double`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 *
 * \param filename the name of the file
 * \param points the points, replaced
 * \param hexahedra the hexahedra, replaced
 * \param mesh_data what else is in the file, replaced
 *
 * \throws Hex_mesh_file_error naming the line if the file cannot be read, is malformed or truncated, has a coordinate
 *         that is not finite, an index out of range, or a cell that is not a hexahedron. The parameters
 *         are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_medit_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                         Hex_mesh_data& mesh_data)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  io::read_hex_mesh_with<io::Medit_reader>(filename, points, hexahedra, mesh_data);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh to a Medit file (`.mesh`, text).
 *
 * Coordinates are written with as many digits, up to 17, as it takes to read back the same `double`. The file appears
 * complete or not at all.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type has coordinates `x()`, `y()` and `z()`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices of an
 *         integral type
 *
 * \param filename the name of the file
 * \param points the points
 * \param hexahedra the hexahedra
 * \param mesh_data what else to write: labels, lines, triangles, quadrilaterals, and `other_sections`, which must be
 *        a sequence of sections in the Medit format
 *
 * \throws Hex_mesh_file_error if the file cannot be written, if there are labels but not one per element, or if a cell
 *         refers to a point that does not exist
 */
template <class PointRange, class HexahedronRange>
void write_medit_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                          const Hex_mesh_data& mesh_data = Hex_mesh_data())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const auto fits = [](const std::vector<std::int64_t>& labels, std::size_t size) {
    return labels.empty() || labels.size() == size;
  };
  if (!fits(mesh_data.vertex_labels, points.size()) || !fits(mesh_data.hexahedron_labels, hexahedra.size()))
    throw Hex_mesh_file_error(filename, 0, "the number of labels is not the number of elements");

  io::Atomic_file file(filename);
  std::string& text = file.text();
  const auto append_label = [&](const std::vector<std::int64_t>& labels, std::size_t i) {
    io::append_number(text, labels.empty() ? std::int64_t(0) : labels[i]);
    text += '\n';
  };
  // Version 2 stands for coordinates in double precision.
  text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(points.size()) + "\n";
  std::size_t i = 0;
  for (const auto& p : points) {
    for (const double x : io::coordinates(p)) {
      io::append_number(text, x);
      text += ' ';
    }
    append_label(mesh_data.vertex_labels, i++);
    file.write_if_large();
  }
  text += "Hexahedra\n" + std::to_string(hexahedra.size()) + "\n";
  i = 0;
  for (const auto& hexahedron : hexahedra) {
    for (const auto& v : hexahedron) {
      io::append_number(text, static_cast<std::size_t>(v) + 1);
      text += ' ';
    }
    append_label(mesh_data.hexahedron_labels, i++);
    file.write_if_large();
  }
  for (const auto& [name, size] :
       {std::pair<const char*, std::size_t>("Quadrilaterals", 4), {"Triangles", 3}, {"Edges", 2}}) {
    std::size_t count = 0;
    for (const Hex_mesh_cell& cell : mesh_data.other_cells)
      count += io::medit_corners(cell).size() == size;
    if (count == 0)
      continue;
    text += std::string(name) + "\n" + std::to_string(count) + "\n";
    for (const Hex_mesh_cell& cell : mesh_data.other_cells) {
      const std::vector<std::size_t> corners = io::medit_corners(cell);
      if (corners.size() != size)
        continue;
      for (const std::size_t v : corners) {
        if (v >= points.size())
          throw Hex_mesh_file_error(filename, 0, "a cell refers to a point that does not exist");
        io::append_number(text, v + 1);
        text += ' ';
      }
      io::append_number(text, cell.label);
      text += '\n';
      file.write_if_large();
    }
  }
  text += mesh_data.other_sections;
  if (!mesh_data.other_sections.empty() && mesh_data.other_sections.back() != '\n')
    text += '\n';
  text += "End\n";
  file.commit();
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H
