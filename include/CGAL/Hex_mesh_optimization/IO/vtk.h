// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H

// Reads and writes hexahedral meshes in the legacy format of VTK (.vtk, text and binary).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Legacy_vtk_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

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
 * \ingroup PkgHexMeshOptimizationRef
 *
 * reads a hexahedral mesh from a legacy VTK file (`.vtk`), text or binary, versions 1 to 5.
 *
 * The dataset must be an unstructured grid. All points are read, also those no hexahedron refers to. Voxels are read
 * as hexahedra; cells of dimension two and less, and data on points and cells, are skipped.
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
 * \throws Hex_mesh_file_error naming the line (not in a binary file) if the file cannot be read, is malformed or
 *         truncated, has a coordinate that is not finite, an index out of range, or a cell of dimension three that is
 *         not a hexahedron. The parameters are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_vtk_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  io::copy_hex_mesh(io::Legacy_vtk_reader(filename, io::Wanted_cells::HEXAHEDRA).read(), points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * writes a hexahedral mesh to a legacy VTK file (`.vtk`), version 3.0.
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
 *     \cgalParamDescription{whether the numbers are written in binary form}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_file_error if the file cannot be written
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters>
void write_vtk_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                        const NamedParameters& np = parameters::default_values())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const bool binary = parameters::choose_parameter(parameters::get_parameter(np, internal_np::use_binary_mode), false);
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

  text = std::string("# vtk DataFile Version 3.0\nhexahedral mesh\n") + (binary ? "BINARY" : "ASCII") +
         "\nDATASET UNSTRUCTURED_GRID\nPOINTS " + std::to_string(points.size()) + " double\n";
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
  text += (binary ? "\nCELLS " : "CELLS ") + std::to_string(hexahedra.size()) + " " +
          std::to_string(9 * hexahedra.size()) + "\n";
  for (const auto& hexahedron : hexahedra) {
    append_integer(8, ' ');
    int c = 0;
    for (const auto& v : hexahedron)
      append_integer(static_cast<std::size_t>(v), ++c == 8 ? '\n' : ' ');
    file.write_if_large();
  }
  text += (binary ? "\nCELL_TYPES " : "CELL_TYPES ") + std::to_string(hexahedra.size()) + "\n";
  for (std::size_t h = 0; h < hexahedra.size(); ++h) {
    append_integer(12, '\n');
    file.write_if_large();
  }
  if (binary)
    text += '\n';
  file.commit();
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_VTK_H
