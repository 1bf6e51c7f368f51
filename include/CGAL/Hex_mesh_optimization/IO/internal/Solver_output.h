// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
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
#include <system_error>
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
                const std::vector<CGAL::IO::Hex_mesh_data::Labelled_quadrilateral>& faces)
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
class Gmsh_output
{
public:
  Gmsh_output(const std::string& filename, const Solver_output& mesh)
    : mesh_(mesh)
    , file_(filename)
    , text_(file_.text())
  {
    for (const auto& [label, sides] : mesh.surfaces)
      surfaces_.emplace_back(label, sides);
    for (const auto& [label, hexahedra] : mesh.blocks)
      blocks_.emplace_back(label, hexahedra);
  }

  void write()
  {
    text_ += "$MeshFormat\n4.1 1 8\n";
    integer(1); // tells the order of bytes
    text_ += "\n$EndMeshFormat\n";
    write_names();
    write_entities();
    write_nodes();
    write_elements();
    file_.commit();
  }

private:
  template <class Value>
  void add(Value value)
  {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    text_.append(bytes, sizeof(value));
  }
  void count(std::size_t value) { add(static_cast<std::uint64_t>(value)); }
  void integer(std::size_t value) { add(static_cast<std::int32_t>(value)); }

  void write_names()
  {
    text_ += "$PhysicalNames\n" + std::to_string(surfaces_.size() + blocks_.size()) + '\n';
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      text_ += "2 " + std::to_string(i + 1) + " \"surface_" + std::to_string(surfaces_[i].first) + "\"\n";
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      text_ += "3 " + std::to_string(i + 1) + " \"block_" + std::to_string(blocks_[i].first) + "\"\n";
    text_ += "$EndPhysicalNames\n";
  }

  void write_entities()
  {
    std::array<double, 6> box{{0, 0, 0, 0, 0, 0}};
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i) {
        box[i] = v == 0 ? mesh_.points[v][i] : std::min(box[i], mesh_.points[v][i]);
        box[i + 3] = v == 0 ? mesh_.points[v][i] : std::max(box[i + 3], mesh_.points[v][i]);
      }
    text_ += "$Entities\n";
    for (std::size_t n : {std::size_t(0), std::size_t(0), surfaces_.size(), blocks_.size()})
      count(n);
    for (std::size_t number_of : {surfaces_.size(), blocks_.size()})
      for (std::size_t i = 0; i < number_of; ++i) {
        integer(i + 1);
        for (double x : box)
          add(x);
        count(1);
        integer(i + 1); // the physical group
        count(0);
      }
    text_ += "\n$EndEntities\n";
  }

  void write_nodes()
  {
    const std::size_t n = mesh_.points.size();
    text_ += "$Nodes\n";
    for (std::size_t number : {std::size_t(1), n, std::size_t(1), n})
      count(number);
    for (std::size_t number : {3, 1, 0}) // of the first volume, without parameters
      integer(number);
    count(n);
    for (std::size_t v = 0; v < n; ++v)
      count(v + 1);
    for (const auto& p : mesh_.points) {
      for (double x : p)
        add(x);
      file_.write_if_large();
    }
    text_ += "\n$EndNodes\n";
  }

  void write_elements()
  {
    std::size_t n = mesh_.hexahedra.size();
    for (const auto& [label, sides] : surfaces_)
      n += sides.size();
    text_ += "$Elements\n";
    for (std::size_t number : {surfaces_.size() + blocks_.size(), n, std::size_t(1), n})
      count(number);
    std::size_t element = mesh_.hexahedra.size();
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      begin_block(2, i + 1, 3, surfaces_[i].second.size());
      for (const Hexahedron_side& side : surfaces_[i].second)
        write_element(++element, mesh_.side(side.hexahedron, side.side));
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      begin_block(3, i + 1, 5, blocks_[i].second.size());
      for (std::size_t h : blocks_[i].second)
        write_element(h + 1, mesh_.hexahedra[h]);
    }
    text_ += "\n$EndElements\n";
  }

  void begin_block(std::size_t dimension, std::size_t entity, std::size_t type, std::size_t size)
  {
    for (std::size_t number : {dimension, entity, type})
      integer(number);
    count(size);
  }

  template <class Vertices>
  void write_element(std::size_t number, const Vertices& vertices)
  {
    count(number);
    for (std::size_t v : vertices)
      count(v + 1);
    file_.write_if_large();
  }

  const Solver_output& mesh_;
  Atomic_file file_;
  std::string& text_;
  std::vector<std::pair<std::int64_t, std::vector<Hexahedron_side>>> surfaces_;
  std::vector<std::pair<std::int64_t, std::vector<std::size_t>>> blocks_;
};

inline void write_gmsh(const std::string& filename, const Solver_output& mesh) { Gmsh_output(filename, mesh).write(); }

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

// Hexahedra are ordered by their blocks. Each surface is a side set.
class Exodus_output
{
public:
  Exodus_output(const std::string& filename, const Solver_output& mesh) : mesh_(mesh), file_(filename) {}

  void write()
  {
    define_mesh();
    define_blocks();
    if (!mesh_.surfaces.empty())
      define_sets();
    file_.end_definitions();
    put_points();
    put_blocks();
    if (!mesh_.surfaces.empty())
      put_sets();
    file_.commit();
  }

private:
  static constexpr std::size_t length = 33; // of names

  // Numbers from 1 on, the state and the names of blocks or sets
  struct Properties
  {
    int numbers = -1, states = -1, names = -1;
    std::vector<std::string> values;
  };

  void define_mesh()
  {
    file_.attribute("api_version", 5.1f);
    file_.attribute("version", 5.1f);
    file_.attribute("floating_point_word_size", 8);
    file_.attribute("file_size", 1);
    file_.attribute(NC_GLOBAL, "title", "Hexahedral mesh");
    string_length_ = file_.dimension("len_string", length);
    file_.dimension("len_line", 81);
    file_.dimension("num_dim", 3);
    const int nodes = file_.dimension("num_nodes", mesh_.points.size());
    file_.dimension("num_elem", mesh_.hexahedra.size());
    file_.dimension("time_step", NC_UNLIMITED);
    for (const char* name : {"coordx", "coordy", "coordz"})
      coordinates_.push_back(file_.variable(name, NC_DOUBLE, {nodes}));
  }

  Properties defined(const std::string& prefix, int dimension)
  {
    Properties result;
    result.numbers = file_.variable(prefix + "_prop1", NC_INT, {dimension});
    file_.attribute(result.numbers, "name", "ID");
    result.states = file_.variable(prefix + "_status", NC_INT, {dimension});
    result.names = file_.variable(prefix + "_names", NC_CHAR, {dimension, string_length_});
    return result;
  }

  void put(const Properties& properties)
  {
    std::vector<int> numbers;
    std::string rows;
    for (std::string name : properties.values) {
      numbers.push_back(static_cast<int>(numbers.size()) + 1);
      name.resize(length, '\0');
      rows += name;
    }
    file_.put(properties.numbers, numbers);
    file_.put(properties.states, std::vector<int>(numbers.size(), 1));
    file_.put(properties.names, rows);
  }

  void define_blocks()
  {
    blocks_ = defined("eb", file_.dimension("num_el_blk", mesh_.blocks.size()));
    for (const auto& [label, hexahedra] : mesh_.blocks) {
      blocks_.values.push_back("block_" + std::to_string(label));
      const std::string number = std::to_string(blocks_.values.size());
      connectivity_.push_back(file_.variable("connect" + number, NC_INT,
                                             {file_.dimension("num_el_in_blk" + number, hexahedra.size()),
                                              file_.dimension("num_nod_per_el" + number, 8)}));
      file_.attribute(connectivity_.back(), "elem_type", "HEX8");
    }
  }

  void define_sets()
  {
    sets_ = defined("ss", file_.dimension("num_side_sets", mesh_.surfaces.size()));
    for (const auto& [label, sides] : mesh_.surfaces) {
      sets_.values.push_back("surface_" + std::to_string(label));
      const std::string number = std::to_string(sets_.values.size());
      const int size = file_.dimension("num_side_ss" + number, sides.size());
      elements_.push_back(file_.variable("elem_ss" + number, NC_INT, {size}));
      sides_.push_back(file_.variable("side_ss" + number, NC_INT, {size}));
    }
  }

  void put_points()
  {
    std::vector<double> values(mesh_.points.size());
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t v = 0; v < values.size(); ++v)
        values[v] = mesh_.points[v][i];
      file_.put(coordinates_[i], values);
    }
  }

  void put_blocks()
  {
    number_of_.resize(mesh_.hexahedra.size());
    std::size_t b = 0;
    int next = 0;
    for (const auto& [label, hexahedra] : mesh_.blocks) {
      std::vector<int> corners;
      for (std::size_t h : hexahedra) {
        number_of_[h] = ++next;
        for (std::size_t v : mesh_.hexahedra[h])
          corners.push_back(static_cast<int>(v) + 1);
      }
      file_.put(connectivity_[b++], corners);
    }
    put(blocks_);
  }

  void put_sets()
  {
    static const int side_number[6] = {4, 2, 1, 3, 5, 6}; // of Exodus, for each of `hexahedron_faces`
    std::size_t s = 0;
    for (const auto& [label, sides] : mesh_.surfaces) {
      std::vector<int> elements, numbers;
      for (const Hexahedron_side& side : sides) {
        elements.push_back(number_of_[side.hexahedron]);
        numbers.push_back(side_number[side.side]);
      }
      file_.put(elements_[s], elements);
      file_.put(sides_[s++], numbers);
    }
    put(sets_);
  }

  const Solver_output& mesh_;
  New_exodus_file file_;
  int string_length_ = -1;
  Properties blocks_, sets_;
  std::vector<int> coordinates_, connectivity_, elements_, sides_; // variables
  std::vector<int> number_of_;                                     // of hexahedra, in the order of the blocks
};

inline void write_exodus(const std::string& filename, const Solver_output& mesh)
{
  Exodus_output(filename, mesh).write();
}

#endif

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_OUTPUT_H
