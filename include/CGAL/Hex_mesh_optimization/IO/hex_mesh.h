// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads and writes hexahedral meshes, as indices or as a linear cell complex,
// in the format that the extension of the file name tells.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/hex_mesh_copy.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_output.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/extension_of.h>
#include <CGAL/Hex_mesh_optimization/IO/unsupported_data.h>
#include <CGAL/Hex_mesh_optimization/IO/medit.h>
#include <CGAL/Hex_mesh_optimization/IO/vtk.h>
#include <CGAL/Hex_mesh_optimization/IO/vtu.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

template <class Type>
using Linear_cell_complex_only = std::enable_if_t<Is_linear_cell_complex<Type>::value, int>;

template <class Type>
using No_linear_cell_complex = std::enable_if_t<!Is_linear_cell_complex<Type>::value, int>;

[[noreturn]] inline void refuse_extension(const std::string& filename)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "the format is unknown: the name must end in .mesh, .vtk, .vtu, .inp, .msh, .e, .exo, .g or .ex2");
}

// Whether write_hex_mesh() knows the format.
inline bool is_output_format(const std::string& filename)
{
  const std::string extension = extension_of(filename);
  for (const char* known : {"mesh", "vtk", "vtu", "inp", "msh", "e", "exo", "g", "ex2"})
    if (extension == known)
      return true;
  return false;
}

template <class PointRange, class HexahedronRange>
void write_for_solver(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                      const CGAL::IO::Hex_mesh_data& mesh_data)
{
  std::vector<std::array<double, 3>> coordinates_of;
  for (const auto& p : points)
    coordinates_of.push_back(coordinates(p));
  std::vector<std::array<std::size_t, 8>> corners;
  for (const auto& h : hexahedra) {
    corners.emplace_back();
    for (std::size_t c = 0; c < 8; ++c)
      corners.back()[c] = static_cast<std::size_t>(h[c]);
  }
  if (!mesh_data.hexahedron_labels.empty() && mesh_data.hexahedron_labels.size() != corners.size())
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "there is not one label for each hexahedron");
  const Solver_output output(std::move(coordinates_of), std::move(corners), mesh_data.hexahedron_labels,
                             mesh_data.labelled_quadrilaterals());
  const std::string extension = extension_of(filename);
  if (extension == "inp")
    write_abaqus(filename, output);
  else if (extension == "msh")
    write_gmsh(filename, output);
  else
    write_exodus(filename, output);
}

[[noreturn]] inline void refuse_input(const std::string& filename)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0,
    "the format is unknown: the name must end in .mesh, .vtk, .vtu, .inp, .msh, .bdf, "
    ".nas, .dat, .e, .exo, .g, .ex2 or .med, or be a case of OpenFOAM");
}

template <class PointRange, class HexahedronRange>
void read_solver_file(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                      CGAL::IO::Hex_mesh_data& mesh_data)
{
  const CGAL::IO::Hex_mesh_file file = CGAL::IO::read_hex_mesh_file(filename);
  Mesh_file_content content;
  content.points = file.points;
  content.hexahedra = file.hexahedra;
  copy_hex_mesh(content, points, hexahedra);
  mesh_data = mesh_data_of(file);
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh in the format told by the extension of the file name, in upper or lower case:
 * `.mesh` (`read_medit_hex_mesh()`), `.vtk` (`read_vtk_hex_mesh()`), `.vtu` (`read_vtu_hex_mesh()`), or the file of a
 * solver (`read_hex_mesh_file()`, which keeps what is needed to write such a file again).
 *
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type can be constructed from
 *         three `double`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 *
 * \param filename the name of the file
 * \param points all points of the file in its order, replaced
 * \param hexahedra the hexahedra of the file in its order, replaced
 * \param mesh_data what else is in the file, replaced
 *
 * \throws Hex_mesh_file_error naming the line if the file cannot be read; the parameters are unchanged then
 */
template <class PointRange, class HexahedronRange,
          Hex_mesh_optimization::internal::IO::No_linear_cell_complex<PointRange> = 0>
void read_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                   Hex_mesh_data& mesh_data)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const std::string extension = io::extension_of(filename);
  if (extension == "mesh")
    return read_medit_hex_mesh(filename, points, hexahedra, mesh_data);
  if (extension == "vtk")
    return read_vtk_hex_mesh(filename, points, hexahedra, mesh_data);
  if (extension == "vtu")
    return read_vtu_hex_mesh(filename, points, hexahedra, mesh_data);
  if (is_hex_mesh_file(filename))
    return io::read_solver_file(filename, points, hexahedra, mesh_data);
  io::refuse_input(filename);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange,
          Hex_mesh_optimization::internal::IO::No_linear_cell_complex<PointRange> = 0>
void read_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra)
{
  Hex_mesh_data ignored;
  read_hex_mesh(filename, points, hexahedra, ignored);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh as above into a linear cell complex, as
 * `Hex_mesh_optimization::hexahedra_to_linear_cell_complex()` does.
 *
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 *
 * \param filename the name of the file
 * \param lcc the linear cell complex, cleared first
 * \param mesh_data what else is in the file, replaced
 *
 * \throws Hex_mesh_file_error if the file cannot be read, or if a linear cell complex cannot carry
 *         the mesh, naming the hexahedron. `lcc` is unchanged then.
 */
template <class LCC, Hex_mesh_optimization::internal::IO::Linear_cell_complex_only<LCC> = 0>
void read_hex_mesh(const std::string& filename, LCC& lcc, Hex_mesh_data& mesh_data)
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  Hex_mesh_data read_mesh_data;
  read_hex_mesh(filename, points, hexahedra, read_mesh_data);
  try {
    // Everything that can go wrong does so here.
    const Hex_mesh_optimization::internal::Hexahedra_sewing sewing(points.size(), hexahedra);
    lcc.clear();
    Hex_mesh_optimization::internal::make_volumes(points, sewing, lcc);
  }
  catch (const Hex_mesh_optimization::Input_error& error) {
    throw Hex_mesh_file_error(filename, 0, error.message());
  }
  mesh_data = std::move(read_mesh_data);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a hexahedral mesh into a linear cell complex as above, without mesh_data.
 */
template <class LCC, Hex_mesh_optimization::internal::IO::Linear_cell_complex_only<LCC> = 0>
void read_hex_mesh(const std::string& filename, LCC& lcc)
{
  Hex_mesh_data ignored;
  read_hex_mesh(filename, lcc, ignored);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh in the format told by the extension of the file name, in upper or lower case:
 * `.mesh` (`write_medit_hex_mesh()`), `.vtk` (`write_vtk_hex_mesh()`) or `.vtu` (`write_vtu_hex_mesh()`); `.inp`
 * (Abaqus, CalculiX), `.msh` (Gmsh 4.1) or `.e`, `.exo`, `.g`, `.ex2` (Exodus II), where each label of hexahedra is a
 * block, each label other than 0 of quadrilaterals a set of faces, hexahedra of Exodus are ordered by their blocks, and
 * the rest of the mesh_data is lost.
 *
 * Reading the file gives back the same points, bit by bit, and the same hexahedra in the same order. The file appears
 * complete or not at all.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type has coordinates `x()`, `y()` and `z()`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices of an
 *         integral type
 * \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * \param filename the name of the file
 * \param points the points
 * \param hexahedra the hexahedra
 * \param mesh_data what else to write, as far as the format can hold it: see `unsupported_data()`
 * \param np optional \ref bgl_namedparameters "Named Parameters" described below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{use_binary_mode}
 *     \cgalParamDescription{whether the numbers of a `.vtk` or `.vtu` file are written in binary form}
 *     \cgalParamType{Boolean}
 *     \cgalParamDefault{`mesh_data.is_binary`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_file_error if the file cannot be written, or if the mesh_data do not fit to the mesh
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters,
          Hex_mesh_optimization::internal::IO::No_linear_cell_complex<PointRange> = 0>
void write_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                    const Hex_mesh_data& mesh_data, const NamedParameters& np = parameters::default_values())
{
  namespace io = Hex_mesh_optimization::internal::IO;
  const std::string extension = io::extension_of(filename);
  if (extension == "mesh")
    write_medit_hex_mesh(filename, points, hexahedra, mesh_data);
  else if (extension == "vtk")
    write_vtk_hex_mesh(filename, points, hexahedra, mesh_data, np);
  else if (extension == "vtu")
    write_vtu_hex_mesh(filename, points, hexahedra, mesh_data, np);
  else if (io::is_output_format(filename))
    io::write_for_solver(filename, points, hexahedra, mesh_data);
  else
    io::refuse_extension(filename);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a hexahedral mesh as above, without mesh_data.
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters,
          Hex_mesh_optimization::internal::IO::No_linear_cell_complex<PointRange> = 0>
void write_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                    const NamedParameters& np = parameters::default_values())
{
  write_hex_mesh(filename, points, hexahedra, Hex_mesh_data(), np);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a linear cell complex of hexahedra as above, in the order of
 * `Hex_mesh_optimization::linear_cell_complex_to_hexahedra()`.
 *
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 *
 * \throws Hex_mesh_optimization::Input_error naming the volume if one is not a hexahedron
 */
template <class LCC, class NamedParameters = parameters::Default_named_parameters,
          Hex_mesh_optimization::internal::IO::Linear_cell_complex_only<LCC> = 0>
void write_hex_mesh(const std::string& filename, const LCC& lcc, const Hex_mesh_data& mesh_data,
                    const NamedParameters& np = parameters::default_values())
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  Hex_mesh_optimization::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  write_hex_mesh(filename, points, hexahedra, mesh_data, np);
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a linear cell complex of hexahedra as above, without mesh_data.
 */
template <class LCC, class NamedParameters = parameters::Default_named_parameters,
          Hex_mesh_optimization::internal::IO::Linear_cell_complex_only<LCC> = 0>
void write_hex_mesh(const std::string& filename, const LCC& lcc,
                    const NamedParameters& np = parameters::default_values())
{
  write_hex_mesh(filename, lcc, Hex_mesh_data(), np);
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_H
