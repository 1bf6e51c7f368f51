// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads and writes hexahedral meshes in the XML format of VTK (.vtu).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/vtk_output.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/vtu_arrays_output.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh from an unstructured grid in the XML format of VTK (`.vtu`).
 *
 * The numbers may be text, base64, or appended, raw or base64. Arrays compressed with zlib can be read if the macro
 * `CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB` is defined and the program is linked with zlib. Several pieces are read one
 * after the other. All points are read, also those no hexahedron refers to. Voxels are read as hexahedra. Cells of
 * dimension two and less, and data on points, cells and the mesh as a whole, go to `mesh_data`; data that are
 * damaged, or that not all pieces have, are named in `Hex_mesh_data::skipped`.
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
 * \throws Hex_mesh_file_error if the file cannot be read, is malformed or truncated, has a coordinate that is not
 *         finite, an index out of range, or a cell of dimension three that is not a hexahedron. The error names
 *         the cell or the point, and the line if the file is not well-formed XML. The parameters are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_vtu_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                       Hex_mesh_data& mesh_data)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  io::read_hex_mesh_with<io::Vtu_reader>(filename, points, hexahedra, mesh_data);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange>
void read_vtu_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra)
{
  Hex_mesh_data ignored;
  read_vtu_hex_mesh(filename, points, hexahedra, ignored);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh as an unstructured grid in the XML format of VTK (`.vtu`).
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
 *     \cgalParamDescription{whether the numbers are written in binary form, as base64}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`mesh_data.is_binary`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_file_error if the file cannot be written, or if the mesh_data do not fit to the mesh: labels or
 *         tuples of an array that are not one per element, or a cell that refers to a point that does not exist
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtu_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const Hex_mesh_data& mesh_data, const NamedParameters& np = parameters::default_values())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const bool binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode),
                                                   mesh_data.is_binary);
  const io::Arrays_to_write arrays(filename, points.size(), hexahedra.size(), mesh_data);
  std::size_t number_of_cells = hexahedra.size(), size = 8 * hexahedra.size();
  for (const Hex_mesh_cell& cell : mesh_data.other_cells) {
    ++number_of_cells;
    size += cell.vertices.size();
  }
  io::Atomic_file file(filename);
  file.text() = "<?xml version=\"1.0\"?>\n"
                "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n"
                "<UnstructuredGrid>\n";
  if (!mesh_data.field_data.empty()) {
    file.text() += "<FieldData>\n";
    for (const Hex_mesh_data_array& array : mesh_data.field_data)
      io::write_vtu_array(file, array, binary, true);
    file.text() += "</FieldData>\n";
  }
  file.text() += "<Piece NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" +
                 std::to_string(number_of_cells) + "\">\n";
  io::write_vtu_data(file, "PointData", arrays.point_data, binary);
  io::write_vtu_data(file, "CellData", arrays.cell_data, binary);
  file.text() += "<Points>\n";
  io::Vtu_array<double> coordinates(file, "Float64", "Name=\"Points\" NumberOfComponents=\"3\"", 3 * points.size(),
                                    binary);
  for (const auto& p : points) {
    const std::array<double, 3> x = io::coordinates(p);
    for (int i = 0; i < 3; ++i)
      coordinates.append(x[i], i == 2 ? '\n' : ' ');
  }
  coordinates.close();
  file.text() += "</Points>\n<Cells>\n";
  io::Vtu_array<std::int64_t> connectivity(file, "Int64", "Name=\"connectivity\"", size, binary);
  const auto append_vertices = [&](std::size_t number_of_vertices, const auto& vertices) {
    std::size_t c = 0;
    for (const auto& v : vertices)
      connectivity.append(static_cast<std::int64_t>(v), ++c == number_of_vertices ? '\n' : ' ');
  };
  io::for_each_cell(
    hexahedra.size(), mesh_data, [&](std::size_t h) { append_vertices(8, *(std::begin(hexahedra) + h)); },
    [&](const Hex_mesh_cell& cell) { append_vertices(cell.vertices.size(), cell.vertices); });
  connectivity.close();
  io::Vtu_array<std::int64_t> offsets(file, "Int64", "Name=\"offsets\"", number_of_cells, binary);
  std::size_t end = 0;
  io::for_each_cell(
    hexahedra.size(), mesh_data, [&](std::size_t) { offsets.append(static_cast<std::int64_t>(end += 8), '\n'); },
    [&](const Hex_mesh_cell& cell) { offsets.append(static_cast<std::int64_t>(end += cell.vertices.size()), '\n'); });
  offsets.close();
  io::Vtu_array<std::uint8_t> types(file, "UInt8", "Name=\"types\"", number_of_cells, binary);
  io::for_each_cell(
    hexahedra.size(), mesh_data, [&](std::size_t) { types.append(12, '\n'); },
    [&](const Hex_mesh_cell& cell) { types.append(static_cast<std::uint8_t>(cell.type), '\n'); });
  types.close();
  file.text() += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  file.commit();
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtu_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const NamedParameters& np = parameters::default_values())
{
  write_vtu_hex_mesh(filename, points, hexahedra, Hex_mesh_data(), np);
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H
