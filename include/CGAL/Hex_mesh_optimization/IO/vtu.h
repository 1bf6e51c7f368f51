// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H

// Reads and writes hexahedral meshes in the XML format of VTK (.vtu).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_reader.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * reads a hexahedral mesh from an unstructured grid in the XML format of VTK (`.vtu`).
 *
 * The numbers may be text, base64, or appended, raw or base64. Arrays compressed with zlib can be read if the macro
 * `CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB` is defined and the program is linked with zlib. Several pieces are read one
 * after the other. All points are read, also those no hexahedron refers to. Voxels are read as hexahedra; cells of
 * dimension two and less, and data on points and cells, are skipped.
 *
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type can be constructed from
 *         three `double`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 *
 * \param filename the name of the file
 * \param points the points, replaced
 * \param hexahedra the hexahedra, replaced
 *
 * \throws Hex_mesh_file_error if the file cannot be read, is malformed or truncated, has a coordinate that is not
 *         finite, an index out of range, or a cell of dimension three that is not a hexahedron. The error names
 *         the cell or the point, and the line if the file is not well-formed XML. The parameters are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_vtu_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  io::copy_hex_mesh(io::Vtu_reader(filename, io::Wanted_cells::HEXAHEDRA).read(), points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
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
 * \param np optional \ref bgl_namedparameters "Named Parameters" described below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{use_binary_mode}
 *     \cgalParamDescription{whether the numbers are written in binary form, as base64}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_file_error if the file cannot be written
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtu_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const NamedParameters& np = parameters::default_values())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const bool binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), false);
  io::Atomic_file file(filename);
  file.text() = "<?xml version=\"1.0\"?>\n"
                "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n"
                "<UnstructuredGrid>\n"
                "<Piece NumberOfPoints=\"" +
                std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(hexahedra.size()) +
                "\">\n<Points>\n";
  io::Vtu_array<double> coordinates(file, "Float64", "Name=\"Points\" NumberOfComponents=\"3\"", 3 * points.size(),
                                    binary);
  for (const auto& p : points) {
    const std::array<double, 3> x = io::coordinates(p);
    for (int i = 0; i < 3; ++i)
      coordinates.append(x[i], i == 2 ? '\n' : ' ');
  }
  coordinates.close();
  file.text() += "</Points>\n<Cells>\n";
  io::Vtu_array<std::int64_t> connectivity(file, "Int64", "Name=\"connectivity\"", 8 * hexahedra.size(), binary);
  for (const auto& hexahedron : hexahedra) {
    int c = 0;
    for (const auto& v : hexahedron)
      connectivity.append(static_cast<std::int64_t>(v), ++c == 8 ? '\n' : ' ');
  }
  connectivity.close();
  io::Vtu_array<std::int64_t> offsets(file, "Int64", "Name=\"offsets\"", hexahedra.size(), binary);
  for (std::size_t h = 1; h <= hexahedra.size(); ++h)
    offsets.append(static_cast<std::int64_t>(8 * h), '\n');
  offsets.close();
  io::Vtu_array<std::uint8_t> types(file, "UInt8", "Name=\"types\"", hexahedra.size(), binary);
  for (std::size_t h = 0; h < hexahedra.size(); ++h)
    types.append(12, '\n');
  types.close();
  file.text() += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  file.commit();
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_VTU_H
