// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_COPY_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_COPY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the files of solvers, and copies them with points that have moved and
// nothing else changed.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Abaqus_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Exodus_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Gmsh_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Med_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Nastran_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Openfoam_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Placed_points.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Ucd_reader.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/extension_of.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

enum class Solver_format { NONE, ABAQUS, GMSH, NASTRAN, EXODUS, MED, OPENFOAM };

inline Solver_format solver_format(const std::string& filename)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(filename, ignored))
    return Solver_format::OPENFOAM;
  const std::string extension = extension_of(filename);
  const auto is_one_of = [&](std::initializer_list<const char*> extensions) {
    for (const char* e : extensions)
      if (extension == e)
        return true;
    return false;
  };
  if (extension == "inp")
    return Solver_format::ABAQUS;
  if (extension == "msh")
    return Solver_format::GMSH;
  if (is_one_of({"bdf", "nas", "dat", "blk", "fem", "bulk"}))
    return Solver_format::NASTRAN;
  if (is_one_of({"e", "exo", "g", "gen", "ex2", "exoii", "ncdf", "nc"}))
    return Solver_format::EXODUS;
  if (is_one_of({"med", "rmed", "mmed"}))
    return Solver_format::MED;
  return Solver_format::NONE;
}

// Whether the first line that is no comment is a keyword.
inline bool is_abaqus(std::string_view text)
{
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.substr(0, 2) != "**")
      return line[0] == '*';
  }
  return false;
}

// What of a file is left out where it is written in a format of another kind.
inline CGAL::IO::Hex_mesh_data mesh_data_of(const CGAL::IO::Hex_mesh_file& file)
{
  CGAL::IO::Hex_mesh_data result;
  result.other_cells = file.other_cells;
  for (std::int64_t label : file.labels)
    if (label != 0) {
      result.hexahedron_labels = file.labels;
      break;
    }
  for (const CGAL::IO::Hex_mesh_set& set : file.sets)
    result.skipped.push_back("the set \"" + set.name + '"');
  result.skipped.push_back("what else is in a file of " + file.format);
  if (!file.followers.empty())
    result.skipped.push_back("the nodes of hexahedra that are no corners, as such");
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * returns whether `read_hex_mesh_file()` knows the format of a file by its name: `.inp` (Abaqus, CalculiX, AVS UCD),
 * `.msh` (Gmsh), `.bdf`, `.nas`, `.dat` (Nastran), `.e`, `.exo`, `.g`, `.ex2` (Exodus II), `.med` (MED), or a folder
 * (a case of OpenFOAM).
 */
inline bool is_hex_mesh_file(const std::string& filename)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  return io::solver_format(filename) != io::Solver_format::NONE;
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * reads a file of a solver, see `is_hex_mesh_file()`, with the files that it includes.
 *
 * Exodus II needs netCDF, with the macro `CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF`; MED needs HDF5, with
 * `CGAL_HEX_MESH_OPTIMIZATION_USE_HDF5`; compressed files of OpenFOAM need zlib. The others need no library.
 *
 * \throws Hex_mesh_file_error naming the line, or the variable, if the file cannot be read
 */
inline Hex_mesh_file read_hex_mesh_file(const std::string& filename)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  std::error_code ignored;
  if (!std::filesystem::exists(filename, ignored))
    throw Hex_mesh_file_error(filename, 0, "cannot open the file for reading");
  switch (io::solver_format(filename)) {
  case io::Solver_format::ABAQUS:
    if (io::is_ucd(io::read_whole_file(filename)))
      return io::Ucd_reader(filename).read();
    return io::Abaqus_reader(filename).read();
  case io::Solver_format::GMSH:
    if (io::is_abaqus(io::read_whole_file(filename))) // CalculiX' own mesher names its meshes so
      return io::Abaqus_reader(filename).read();
    return io::Gmsh_reader(filename).read();
  case io::Solver_format::NASTRAN:
    return io::Nastran_reader(filename).read();
  case io::Solver_format::EXODUS:
    return io::read_exodus(filename);
  case io::Solver_format::MED:
    return io::read_med(filename);
  case io::Solver_format::OPENFOAM:
    return io::Openfoam_reader(filename).read();
  default:
    throw Hex_mesh_file_error(filename, 0, "the format is unknown");
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a copy of a file in which the numbers of coordinates that have changed are replaced, with all digits or what
 * the width of a field allows, and not a byte more is changed; where no point has moved, the copy equals the file.
 * Nodes of hexahedra that are no corners go along with the corners. What was written is read again and compared.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type has coordinates `x()`, `y()` and `z()`
 *
 * \param file what `read_hex_mesh_file()` returned
 * \param output the name of the copy: that of the input, or another one. Files that are included and have changed are
 *        written beside it, those that have not as well if there are none with their names.
 * \param points one for each of `file.points`
 * \returns the points as they are in the copy
 *
 * \throws Hex_mesh_file_error if the copy cannot be written, or would overwrite an included file of the input
 */
template <class PointRange>
std::vector<std::array<double, 3>> copy_hex_mesh_file(const Hex_mesh_file& file, const std::string& output,
                                                      const PointRange& points)
{
  namespace io = Hex_mesh_optimization::internal::IO;
  std::vector<std::array<double, 3>> moved;
  moved.reserve(file.points.size());
  std::vector<char> may_move;
  for (const auto& p : points) {
    moved.push_back({{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}});
    may_move.push_back(moved.size() <= file.points.size() && moved.back() != file.points[moved.size() - 1]);
  }
  if (moved.size() != file.points.size())
    throw Hex_mesh_file_error(output, 0,
                              "there are " + std::to_string(moved.size()) + " points, and " +
                                std::to_string(file.points.size()) + " in the file");
  file.places->check_output(output, may_move);
  std::vector<std::array<double, 3>> placed = io::Placed_points(file, moved).points();
  file.places->write(output, file.points, placed);
  const Hex_mesh_file back = read_hex_mesh_file(output);
  if (back.hexahedra != file.hexahedra || back.points.size() != placed.size())
    throw Hex_mesh_file_error(output, 0, "what was written does not read back as the same mesh");
  return back.points;
}

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * writes a copy of the file `input` as above.
 */
template <class PointRange>
std::vector<std::array<double, 3>> copy_hex_mesh_file(const std::string& input, const std::string& output,
                                                      const PointRange& points)
{
  return copy_hex_mesh_file(read_hex_mesh_file(input), output, points);
}

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_COPY_H
