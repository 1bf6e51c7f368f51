// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_OUTPUT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_OUTPUT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Writes a mesh for solvers: blocks of hexahedra by their labels, and named sets of faces.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_in_width.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF
#include <netcdf.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// A side of a hexahedron, by its number in `hexahedron_faces`.
struct Hexahedron_side
{
  std::size_t hexahedron;
  int side;
};

struct Solver_output
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::map<std::int64_t, std::vector<std::size_t>> blocks;       // hexahedra by labels
  std::map<std::int64_t, std::vector<Hexahedron_side>> surfaces; // sides by labels of faces

  // `labels` may be empty. Faces with a label other than 0 that no hexahedron has are left out.
  Solver_output(std::vector<std::array<double, 3>> all_points, std::vector<std::array<std::size_t, 8>> all_hexahedra,
                const std::vector<std::int64_t>& labels,
                const std::vector<CGAL::IO::Hex_mesh_attachments::Labelled_quadrilateral>& faces)
    : points(std::move(all_points))
    , hexahedra(std::move(all_hexahedra))
  {
    for (std::size_t h = 0; h < hexahedra.size(); ++h)
      blocks[labels.empty() ? 0 : labels[h]].push_back(h);
    std::map<std::array<std::size_t, 4>, std::int64_t> label_of;
    for (const auto& face : faces) {
      std::array<std::size_t, 4> sorted = face.vertices;
      std::sort(sorted.begin(), sorted.end());
      if (face.label != 0)
        label_of[sorted] = face.label;
    }
    for (std::size_t h = 0; h < hexahedra.size() && !label_of.empty(); ++h)
      for (int f = 0; f < 6; ++f) {
        const auto found = label_of.find(sorted_side(h, f));
        if (found == label_of.end())
          continue;
        surfaces[found->second].push_back({h, f});
        label_of.erase(found);
      }
  }

  std::array<std::size_t, 4> side(std::size_t h, int f) const
  {
    std::array<std::size_t, 4> result{};
    for (int i = 0; i < 4; ++i)
      result[i] = hexahedra[h][static_cast<std::size_t>(hexahedron_faces[f][i])];
    return result;
  }

  std::array<std::size_t, 4> sorted_side(std::size_t h, int f) const
  {
    std::array<std::size_t, 4> result = side(h, f);
    std::sort(result.begin(), result.end());
    return result;
  }
};

// Elements in the order of the input; each block and each surface has a name.
inline void write_abaqus(const std::string& filename, const Solver_output& mesh)
{
  Atomic_file file(filename);
  std::string& text = file.text();
  constexpr std::size_t most_digits = 20;
  text += "*HEADING\nHexahedral mesh\n*NODE, NSET=NALL\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    text += std::to_string(v + 1);
    for (double x : mesh.points[v])
      (text += ", ") += number_in_width(x, most_digits, Number_style::GENERAL);
    text += '\n';
    file.write_if_large();
  }
  // The number of a hexahedron is its place; consecutive ones of a block stand together.
  std::vector<std::int64_t> labels(mesh.hexahedra.size());
  for (const auto& [label, hexahedra] : mesh.blocks)
    for (std::size_t h : hexahedra)
      labels[h] = label;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (h == 0 || labels[h] != labels[h - 1])
      text += "*ELEMENT, TYPE=C3D8, ELSET=BLOCK_" + std::to_string(labels[h]) + '\n';
    text += std::to_string(h + 1);
    for (std::size_t v : mesh.hexahedra[h])
      (text += ", ") += std::to_string(v + 1);
    text += '\n';
    file.write_if_large();
  }
  static const int side_number[6] = {6, 4, 3, 5, 1, 2}; // of Abaqus, for each of `hexahedron_faces`
  for (const auto& [label, sides] : mesh.surfaces) {
    text += "*SURFACE, NAME=SURFACE_" + std::to_string(label) + ", TYPE=ELEMENT\n";
    for (const Hexahedron_side& side : sides)
      text += std::to_string(side.hexahedron + 1) + ", S" + std::to_string(side_number[side.side]) + '\n';
    file.write_if_large();
  }
  file.commit();
}

// Version 4.1, binary. Each block is a volume and each surface a surface, with a physical group of that name.
inline void write_gmsh(const std::string& filename, const Solver_output& mesh)
{
  Atomic_file file(filename);
  std::string& text = file.text();
  const auto add = [&text](auto value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    text.append(bytes, sizeof(value));
  };
  const auto count = [&add](std::size_t value) { add(static_cast<std::uint64_t>(value)); };
  const auto integer = [&add](std::int64_t value) { add(static_cast<std::int32_t>(value)); };

  text += "$MeshFormat\n4.1 1 8\n";
  integer(1);
  text += "\n$EndMeshFormat\n$PhysicalNames\n" + std::to_string(mesh.blocks.size() + mesh.surfaces.size()) + '\n';
  std::map<std::int64_t, std::int64_t> volume, surface; // numbers from 1, as Gmsh wants them
  for (const auto& [label, sides] : mesh.surfaces) {
    surface[label] = static_cast<std::int64_t>(surface.size()) + 1;
    text += "2 " + std::to_string(surface[label]) + " \"surface_" + std::to_string(label) + "\"\n";
  }
  for (const auto& [label, hexahedra] : mesh.blocks) {
    volume[label] = static_cast<std::int64_t>(volume.size()) + 1;
    text += "3 " + std::to_string(volume[label]) + " \"block_" + std::to_string(label) + "\"\n";
  }
  text += "$EndPhysicalNames\n$Entities\n";
  std::array<double, 6> box{{0, 0, 0, 0, 0, 0}};
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) {
      box[i] = v == 0 ? mesh.points[v][i] : std::min(box[i], mesh.points[v][i]);
      box[i + 3] = v == 0 ? mesh.points[v][i] : std::max(box[i + 3], mesh.points[v][i]);
    }
  for (std::size_t n : {std::size_t(0), std::size_t(0), surface.size(), volume.size()})
    count(n);
  for (const auto* entities : {&surface, &volume})
    for (const auto& [label, number] : *entities) {
      integer(number);
      for (double x : box)
        add(x);
      count(1);
      integer(number);
      count(0);
    }
  text += "\n$EndEntities\n$Nodes\n";
  for (std::size_t n : {std::size_t(1), mesh.points.size(), std::size_t(1), mesh.points.size()})
    count(n);
  integer(3);
  integer(1);
  integer(0);
  count(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    count(v + 1);
  for (const auto& p : mesh.points) {
    for (double x : p)
      add(x);
    file.write_if_large();
  }
  std::size_t number_of_sides = 0;
  for (const auto& [label, sides] : mesh.surfaces)
    number_of_sides += sides.size();
  text += "\n$EndNodes\n$Elements\n";
  const std::size_t elements = mesh.hexahedra.size() + number_of_sides;
  for (std::size_t n : {mesh.blocks.size() + mesh.surfaces.size(), elements, std::size_t(1), elements})
    count(n);
  std::size_t number = mesh.hexahedra.size();
  for (const auto& [label, sides] : mesh.surfaces) {
    for (std::int64_t n : {std::int64_t(2), surface[label], std::int64_t(3)})
      integer(n);
    count(sides.size());
    for (const Hexahedron_side& side : sides) {
      count(++number);
      for (std::size_t v : mesh.side(side.hexahedron, side.side))
        count(v + 1);
      file.write_if_large();
    }
  }
  for (const auto& [label, hexahedra] : mesh.blocks) {
    for (std::int64_t n : {std::int64_t(3), volume[label], std::int64_t(5)})
      integer(n);
    count(hexahedra.size());
    for (std::size_t h : hexahedra) {
      count(h + 1);
      for (std::size_t v : mesh.hexahedra[h])
        count(v + 1);
      file.write_if_large();
    }
  }
  text += "\n$EndElements\n";
  file.commit();
}

#ifndef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF

inline void write_exodus(const std::string& filename, const Solver_output&)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "this is a file of Exodus, and this program was built without netCDF (Debian: libnetcdf-dev)");
}

#else

// The calls of netCDF for one new file, which is made beside the target.
class New_exodus_file
{
public:
  explicit New_exodus_file(const std::string& filename) : filename_(filename), temporary_(filename + ".new.tmp")
  {
    check(nc_create(temporary_.c_str(), NC_CLOBBER | NC_64BIT_OFFSET, &id_));
  }
  New_exodus_file(const New_exodus_file&) = delete;
  New_exodus_file& operator=(const New_exodus_file&) = delete;
  ~New_exodus_file()
  {
    std::error_code ignored;
    if (id_ >= 0)
      nc_close(id_);
    if (!temporary_.empty())
      std::filesystem::remove(temporary_, ignored);
  }

  int dimension(const std::string& name, std::size_t length)
  {
    int d = -1;
    check(nc_def_dim(id_, name.c_str(), length, &d));
    return d;
  }

  int variable(const std::string& name, nc_type type, const std::vector<int>& dimensions)
  {
    int v = -1;
    check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(), &v));
    return v;
  }

  void attribute(int v, const char* name, const std::string& value)
  {
    check(nc_put_att_text(id_, v, name, value.size(), value.c_str()));
  }
  void attribute(const char* name, int value) { check(nc_put_att_int(id_, NC_GLOBAL, name, NC_INT, 1, &value)); }
  void attribute(const char* name, float value) { check(nc_put_att_float(id_, NC_GLOBAL, name, NC_FLOAT, 1, &value)); }

  void end_definitions() { check(nc_enddef(id_)); }
  void put(int v, const std::vector<double>& values) { check(nc_put_var_double(id_, v, values.data())); }
  void put(int v, const std::vector<int>& values) { check(nc_put_var_int(id_, v, values.data())); }
  void put(int v, const std::string& values) { check(nc_put_var_text(id_, v, values.data())); }

  void commit()
  {
    const int id = id_;
    id_ = -1;
    check(nc_close(id));
    std::error_code error;
    std::filesystem::rename(temporary_, filename_, error);
    if (error)
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, "cannot write the file: " + error.message());
    temporary_.clear();
  }

private:
  void check(int code) const
  {
    if (code != NC_NOERR)
      throw CGAL::IO::Hex_mesh_file_error(filename_, 0, std::string("cannot write the file: ") + nc_strerror(code));
  }

  std::string filename_, temporary_;
  int id_ = -1;
};

// Names in rows of equal length
inline std::string exodus_names(const std::vector<std::string>& names, std::size_t length)
{
  std::string result;
  for (std::string name : names) {
    name.resize(length, '\0');
    result += name;
  }
  return result;
}

// Hexahedra are ordered by their blocks. Each surface is a side set.
inline void write_exodus(const std::string& filename, const Solver_output& mesh)
{
  constexpr std::size_t length = 33;
  New_exodus_file file(filename);
  file.attribute("api_version", 5.1f);
  file.attribute("version", 5.1f);
  file.attribute("floating_point_word_size", 8);
  file.attribute("file_size", 1);
  file.attribute(NC_GLOBAL, "title", "Hexahedral mesh");
  const int string_length = file.dimension("len_string", length);
  file.dimension("len_line", 81);
  file.dimension("num_dim", 3);
  const int nodes = file.dimension("num_nodes", mesh.points.size());
  file.dimension("num_elem", mesh.hexahedra.size());
  const int blocks = file.dimension("num_el_blk", mesh.blocks.size());
  file.dimension("time_step", NC_UNLIMITED);
  std::vector<int> coordinates, connectivity, elements_of, sides_of, ids, statuses;
  std::vector<std::string> block_names, set_names;
  for (const char* name : {"coordx", "coordy", "coordz"})
    coordinates.push_back(file.variable(name, NC_DOUBLE, {nodes}));
  for (const auto& [label, hexahedra] : mesh.blocks) {
    block_names.push_back("block_" + std::to_string(label));
    const std::string number = std::to_string(block_names.size());
    connectivity.push_back(file.variable("connect" + number, NC_INT,
                                         {file.dimension("num_el_in_blk" + number, hexahedra.size()),
                                          file.dimension("num_nod_per_el" + number, 8)}));
    file.attribute(connectivity.back(), "elem_type", "HEX8");
    ids.push_back(static_cast<int>(ids.size()) + 1);
    statuses.push_back(1);
  }
  const int block_ids = file.variable("eb_prop1", NC_INT, {blocks});
  file.attribute(block_ids, "name", "ID");
  const int block_status = file.variable("eb_status", NC_INT, {blocks});
  const int names_of_blocks = file.variable("eb_names", NC_CHAR, {blocks, string_length});
  int set_ids = -1, set_status = -1, names_of_sets = -1;
  if (!mesh.surfaces.empty()) {
    const int sets = file.dimension("num_side_sets", mesh.surfaces.size());
    set_ids = file.variable("ss_prop1", NC_INT, {sets});
    file.attribute(set_ids, "name", "ID");
    set_status = file.variable("ss_status", NC_INT, {sets});
    names_of_sets = file.variable("ss_names", NC_CHAR, {sets, string_length});
    for (const auto& [label, sides] : mesh.surfaces) {
      set_names.push_back("surface_" + std::to_string(label));
      const std::string number = std::to_string(set_names.size());
      const int size = file.dimension("num_side_ss" + number, sides.size());
      elements_of.push_back(file.variable("elem_ss" + number, NC_INT, {size}));
      sides_of.push_back(file.variable("side_ss" + number, NC_INT, {size}));
    }
  }
  file.end_definitions();

  std::vector<double> values(mesh.points.size());
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t v = 0; v < values.size(); ++v)
      values[v] = mesh.points[v][i];
    file.put(coordinates[i], values);
  }
  std::vector<int> number_of(mesh.hexahedra.size()); // in the order of the blocks
  std::size_t b = 0;
  int next = 0;
  for (const auto& [label, hexahedra] : mesh.blocks) {
    std::vector<int> corners;
    for (std::size_t h : hexahedra) {
      number_of[h] = ++next;
      for (std::size_t v : mesh.hexahedra[h])
        corners.push_back(static_cast<int>(v) + 1);
    }
    file.put(connectivity[b++], corners);
  }
  file.put(block_ids, ids);
  file.put(block_status, statuses);
  file.put(names_of_blocks, exodus_names(block_names, length));
  static const int side_number[6] = {4, 2, 1, 3, 5, 6}; // of Exodus, for each of `hexahedron_faces`
  std::size_t s = 0;
  for (const auto& [label, sides] : mesh.surfaces) {
    std::vector<int> elements, numbers;
    for (const Hexahedron_side& side : sides) {
      elements.push_back(number_of[side.hexahedron]);
      numbers.push_back(side_number[side.side]);
    }
    file.put(elements_of[s], elements);
    file.put(sides_of[s++], numbers);
  }
  if (!mesh.surfaces.empty()) {
    ids.resize(mesh.surfaces.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
      ids[i] = static_cast<int>(i) + 1;
    file.put(set_ids, ids);
    file.put(set_status, std::vector<int>(ids.size(), 1));
    file.put(names_of_sets, exodus_names(set_names, length));
  }
  file.commit();
}

#endif

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_OUTPUT_H
