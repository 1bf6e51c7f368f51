// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads and writes hexahedral meshes in the legacy format of VTK (.vtk, text and binary).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Legacy_vtk_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/legacy_vtk_arrays_output.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/vtk_output.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh from a legacy VTK file (`.vtk`), text or binary, versions 1 to 5.
 *
 * The dataset must be a grid, unstructured, structured, rectilinear or of structured points. All points are read, also
 * those no hexahedron refers to. Voxels are read as hexahedra. Cells of dimension two and less, and data on points,
 * cells and the mesh as a whole, go to `mesh_data`; data that are damaged or of an unknown kind are named in
 * `Hex_mesh_data::skipped`.
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
 * \throws Hex_mesh_file_error naming the line (not in a binary file) if the file cannot be read, is malformed or
 *         truncated, has a coordinate that is not finite, an index out of range, or a cell of dimension three that is
 *         not a hexahedron. The parameters are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_vtk_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                       Hex_mesh_data& mesh_data)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  io::read_hex_mesh_with<io::Legacy_vtk_reader>(filename, points, hexahedra, mesh_data);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange>
void read_vtk_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra)
{
  Hex_mesh_data ignored;
  read_vtk_hex_mesh(filename, points, hexahedra, ignored);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh to a legacy VTK file (`.vtk`), version 3.0, as an unstructured grid.
 *
 * As text, coordinates are written with as many digits, up to 17, as it takes to read back the same `double`. The
 * file appears complete or not at all.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type has coordinates `x()`, `y()` and `z()`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices of an
 *         integral type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param filename the name of the file
 * \param points the points
 * \param hexahedra the hexahedra
 * \param mesh_data what else to write
 * \param np optional \ref bgl_namedparameters "Named Parameters" described below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{use_binary_mode}
 *     \cgalParamDescription{whether the numbers are written in binary form}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`mesh_data.is_binary`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_file_error if the file cannot be written, or if the mesh_data do not fit to the mesh: labels or
 *         tuples of an array that are not one per element, or a cell that refers to a point that does not exist
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtk_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const Hex_mesh_data& mesh_data, const NamedParameters& np = parameters::default_values())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const bool binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode),
                                                   mesh_data.is_binary);
  const io::Arrays_to_write arrays(filename, points.size(), hexahedra.size(), mesh_data);
  io::Atomic_file file(filename);
  std::string& text = file.text();
  const auto append_integer = [&](std::size_t i, char separator) {
    if (binary)
      io::append_binary(text, static_cast<std::int32_t>(i), false);
    else {
      io::append_number(text, i);
      text += separator;
    }
  };
  // The numbers of this format have 32 bits.
  if (binary && points.size() > std::size_t(0x7fffffff))
    throw Hex_mesh_file_error(filename, 0, "the mesh has too many points for this format");

  io::Legacy_vtk_arrays_output output(file, binary);
  text = "# vtk DataFile Version 3.0\n" + (mesh_data.title.empty() ? "hexahedral mesh" : mesh_data.title) +
         (binary ? "\nBINARY" : "\nASCII") + "\nDATASET UNSTRUCTURED_GRID\n";
  std::vector<const Hex_mesh_data_array*> field;
  for (const Hex_mesh_data_array& array : mesh_data.field_data)
    field.push_back(&array);
  output.write_field(field);
  text += "POINTS " + std::to_string(points.size()) + " double\n";
  for (const auto& p : points) {
    const std::array<double, 3> x = io::coordinates(p);
    for (int i = 0; i < 3; ++i) {
      if (binary)
        io::append_binary(text, x[i], false);
      else {
        io::append_number(text, x[i]);
        text += i == 2 ? '\n' : ' ';
      }
    }
    file.write_if_large();
  }
  std::size_t number_of_cells = hexahedra.size(), size = 9 * hexahedra.size();
  for (const Hex_mesh_cell& cell : mesh_data.other_cells) {
    ++number_of_cells;
    size += 1 + cell.vertices.size();
  }
  if (binary && size > std::size_t(0x7fffffff))
    throw Hex_mesh_file_error(filename, 0, "the mesh has too many cells for this format");
  text += (binary ? "\nCELLS " : "CELLS ") + std::to_string(number_of_cells) + " " + std::to_string(size) + "\n";
  const auto append_cell = [&](std::size_t number_of_vertices, const auto& vertices) {
    append_integer(number_of_vertices, number_of_vertices == 0 ? '\n' : ' ');
    std::size_t c = 0;
    for (const auto& v : vertices)
      append_integer(static_cast<std::size_t>(v), ++c == number_of_vertices ? '\n' : ' ');
    file.write_if_large();
  };
  io::for_each_cell(
    hexahedra.size(), mesh_data, [&](std::size_t h) { append_cell(8, *(std::begin(hexahedra) + h)); },
    [&](const Hex_mesh_cell& cell) { append_cell(cell.vertices.size(), cell.vertices); });
  text += (binary ? "\nCELL_TYPES " : "CELL_TYPES ") + std::to_string(number_of_cells) + "\n";
  const auto append_type = [&](int type) {
    append_integer(static_cast<std::size_t>(type), '\n');
    file.write_if_large();
  };
  io::for_each_cell(
    hexahedra.size(), mesh_data, [&](std::size_t) { append_type(12); },
    [&](const Hex_mesh_cell& cell) { append_type(cell.type); });
  if (binary)
    text += '\n';
  output.write_attributes("POINT_DATA", points.size(), arrays.point_data);
  output.write_attributes("CELL_DATA", number_of_cells, arrays.cell_data);
  file.commit();
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtk_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const NamedParameters& np = parameters::default_values())
{
  write_vtk_hex_mesh(filename, points, hexahedra, Hex_mesh_data(), np);
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H
