// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MED_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MED_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads meshes of MED, the format of Salome and Code_Aster, through HDF5, and writes their coordinates in place, in a copy.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_HDF5
#include <hdf5.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

#ifndef CGAL_HEX_MESH_OPTIMIZATION_USE_HDF5

inline CGAL::IO::Hex_mesh_file read_med(const std::string& filename)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "this is a file of HDF5, and this program was built without HDF5 (Debian: libhdf5-dev)");
}

#else

// The identifier of something of HDF5, closed at the end.
class Hdf5_handle
{
public:
  Hdf5_handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Hdf5_handle(const Hdf5_handle&) = delete;
  Hdf5_handle& operator=(const Hdf5_handle&) = delete;
  ~Hdf5_handle()
  {
    if (id_ >= 0)
      close_(id_);
  }
  operator hid_t() const { return id_; }
  bool is_valid() const { return id_ >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

class Hdf5_file
{
public:
  Hdf5_file(const std::string& filename, bool is_written)
    : filename_(filename)
    , is_silent_(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr))
    , file_(H5Fopen(filename.c_str(), is_written ? H5F_ACC_RDWR : H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)
  {
    if (!file_.is_valid())
      fail("", "cannot open the file as HDF5");
  }

  bool exists(const std::string& path) const
  {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        return false;
      if (end == std::string::npos)
        return true;
    }
  }

  std::vector<std::string> members(const std::string& path) const
  {
    std::vector<std::string> result;
    if (!exists(path))
      return result;
    const Hdf5_handle group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose);
    if (!group.is_valid())
      return result;
    hsize_t position = 0;
    H5Literate(
      group, H5_INDEX_NAME, H5_ITER_INC, &position,
      [](hid_t, const char* name, const H5L_info_t*, void* names) -> herr_t {
        static_cast<std::vector<std::string>*>(names)->push_back(name);
        return 0;
      },
      &result);
    return result;
  }

  std::vector<double> reals(const std::string& path) const { return numbers<double>(path, H5T_NATIVE_DOUBLE); }
  std::vector<std::int64_t> integers(const std::string& path) const
  {
    return numbers<std::int64_t>(path, H5T_NATIVE_INT64);
  }

  // 0 if there is none
  std::int64_t integer_attribute(const std::string& path, const char* name) const
  {
    const Hdf5_handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
    std::int64_t value = 0;
    if (!object.is_valid() || H5Aexists(object, name) <= 0)
      return 0;
    const Hdf5_handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5_handle space(H5Aget_space(attribute), H5Sclose), type(H5Aget_type(attribute), H5Tclose);
    if (H5Sget_simple_extent_npoints(space) != 1 || H5Tget_class(type) != H5T_INTEGER ||
        H5Aread(attribute, H5T_NATIVE_INT64, &value) < 0)
      return 0;
    return value;
  }

  // The bytes of an array of characters, row by row
  std::vector<std::string> names(const std::string& path) const
  {
    std::vector<std::string> result;
    const Hdf5_handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.is_valid())
      return result;
    const Hdf5_handle type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    const std::size_t size = H5Tget_size(type);
    if (n <= 0 || n > most_names || size == 0 || size > most_names || H5Tget_class(type) == H5T_VLEN)
      return result;
    if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0)
      return result;
    std::string bytes(static_cast<std::size_t>(n) * size, '\0');
    if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &bytes[0]) < 0)
      return result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      std::string row = bytes.substr(i * size, size);
      row.erase(std::min(row.find('\0'), row.size()));
      row.erase(row.find_last_not_of(' ') + 1);
      result.push_back(row);
    }
    return result;
  }

  bool is_single(const std::string& path) const
  {
    const Hdf5_handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    const Hdf5_handle type(H5Dget_type(set), H5Tclose);
    return H5Tget_size(type) < 8;
  }

  void write(const std::string& path, const std::vector<double>& values)
  {
    const Hdf5_handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.is_valid() || H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0 ||
        H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0)
      fail(path, "cannot be written");
  }

  [[noreturn]] void fail(const std::string& path, const std::string& reason) const
  {
    throw CGAL::IO::Hex_mesh_file_error(filename_, 0, path.empty() ? reason : path + ": " + reason);
  }

private:
  static constexpr hssize_t most_numbers = hssize_t(1) << 34;
  static constexpr hssize_t most_names = 1 << 22;

  template <class Number>
  std::vector<Number> numbers(const std::string& path, hid_t type) const
  {
    std::vector<Number> result;
    if (!exists(path))
      return result;
    const Hdf5_handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.is_valid())
      fail(path, "is no array");
    const Hdf5_handle space(H5Dget_space(set), H5Sclose), of_file(H5Dget_type(set), H5Tclose);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    const H5T_class_t kind = H5Tget_class(of_file);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
      fail(path, "is no array of numbers");
    if (n < 0 || n > most_numbers)
      fail(path, "is larger than can be read");
    result.resize(static_cast<std::size_t>(n));
    if (n > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) < 0)
      fail(path, "cannot be read");
    return result;
  }

  std::string filename_;
  herr_t is_silent_;
  Hdf5_handle file_;
};

class Med_places : public Coordinate_places
{
public:
  struct Part // the points of one mesh: all x, all y, all z
  {
    std::string path;
    std::size_t first, size;
    bool is_single;
  };

  explicit Med_places(const std::string& filename) : filename_(filename) {}

  std::vector<Part> parts;

  Triple rounded(std::size_t point, const Triple& before, const Triple& after) const override
  {
    Triple result = after;
    for (int i = 0; i < 3; ++i)
      if (is_single(point) && before[i] != after[i])
        result[i] = static_cast<float>(after[i]);
    return result;
  }

  double resolution(std::size_t point, const Triple& p) const override
  {
    return is_single(point) ? 1.2e-7 * std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) : 0;
  }

  void check_output(const std::string&, const std::vector<char>&) const override {}

  void write(const std::string& output, const std::vector<Triple>& before,
             const std::vector<Triple>& after) const override
  {
    std::error_code ignored;
    if (before == after && std::filesystem::equivalent(filename_, output, ignored))
      return;
    Temporary_copy copy(filename_, output);
    if (before != after)
      write_parts(copy.name(), before, after);
    copy.commit();
  }

private:
  void write_parts(const std::string& copy, const std::vector<Triple>& before, const std::vector<Triple>& after) const
  {
    Hdf5_file file(copy, true);
    for (const Part& part : parts) {
      std::vector<double> values = file.reals(part.path);
      bool has_moved = false;
      for (std::size_t v = 0; v < part.size; ++v)
        for (std::size_t i = 0; i < 3; ++i)
          if (before[part.first + v][i] != after[part.first + v][i]) {
            values[i * part.size + v] = after[part.first + v][i];
            has_moved = true;
          }
      if (has_moved)
        file.write(part.path, values);
    }
  }

  bool is_single(std::size_t point) const
  {
    for (const Part& part : parts)
      if (point >= part.first && point < part.first + part.size)
        return part.is_single;
    return false;
  }

  std::string filename_;
};

class Med_reader
{
public:
  explicit Med_reader(const std::string& filename)
    : filename_(filename)
    , file_(filename, false)
    , places_(std::make_shared<Med_places>(filename))
  {}

  CGAL::IO::Hex_mesh_file read()
  {
    if (!file_.exists("/ENS_MAA"))
      file_.fail("", "there is no group ENS_MAA: this is no file of MED");
    mesh_.format = "MED";
    const std::vector<std::string> meshes = file_.members("/ENS_MAA");
    for (const std::string& name : meshes) {
      const std::string path = "/ENS_MAA/" + name;
      std::vector<std::string> steps;
      if (file_.exists(path + "/NOE"))
        steps.push_back(path);
      else // since version 3
        for (const std::string& step : file_.members(path))
          if (file_.exists(path + "/" + step + "/NOE/COO"))
            steps.push_back(path + "/" + step);
      if (steps.size() > 1)
        mesh_.notes.push_back("mesh " + name + ": the coordinates of later steps stay as they are");
      if (!steps.empty() && file_.exists(steps[0] + "/NOE/COO"))
        read_mesh(name, steps[0], meshes.size() > 1 ? name + "/" : std::string());
    }
    return mesh_.finish(places_);
  }

private:
  struct Kind
  {
    const char* name;
    std::size_t nodes;
    Cell_kind kind;
    int vtk_type;
  };

  static const Kind* kind_of(const std::string& name)
  {
    static const Kind kinds[] = {{"HE8", 8, Cell_kind::HEXAHEDRON, 12},  {"H20", 20, Cell_kind::HEXAHEDRON, 12},
                                 {"H27", 27, Cell_kind::HEXAHEDRON, 12}, {"HEXA8", 8, Cell_kind::HEXAHEDRON, 12},
                                 {"TE4", 4, Cell_kind::SOLID, 10},       {"T10", 10, Cell_kind::SOLID, 0},
                                 {"PE6", 6, Cell_kind::SOLID, 13},       {"P15", 15, Cell_kind::SOLID, 0},
                                 {"P18", 18, Cell_kind::SOLID, 0},       {"PY5", 5, Cell_kind::SOLID, 14},
                                 {"P13", 13, Cell_kind::SOLID, 0},       {"O12", 12, Cell_kind::SOLID, 0},
                                 {"QU4", 4, Cell_kind::OTHER, 9},        {"QU8", 8, Cell_kind::OTHER, 23},
                                 {"QU9", 9, Cell_kind::OTHER, 28},       {"TR3", 3, Cell_kind::OTHER, 5},
                                 {"TR6", 6, Cell_kind::OTHER, 22},       {"TR7", 7, Cell_kind::OTHER, 0},
                                 {"SE2", 2, Cell_kind::OTHER, 3},        {"SE3", 3, Cell_kind::OTHER, 21},
                                 {"SE4", 4, Cell_kind::OTHER, 0},        {"PO1", 1, Cell_kind::OTHER, 1}};
    for (const Kind& kind : kinds)
      if (name == kind.name)
        return &kind;
    return nullptr;
  }

  void read_mesh(const std::string& name, const std::string& path, const std::string& prefix)
  {
    const std::string coordinates = path + "/NOE/COO";
    const std::vector<double> all = file_.reals(coordinates);
    const std::int64_t announced = file_.integer_attribute(coordinates, "NBR");
    const std::size_t n = announced > 0 ? static_cast<std::size_t>(announced) : all.size() / 3;
    if (n == 0 || all.size() != 3 * n) {
      mesh_.notes.push_back("mesh " + name + " is not of three dimensions: it stays as it is");
      return;
    }
    const std::size_t first = mesh_.points.size();
    places_->parts.push_back({coordinates, first, n, file_.is_single(coordinates)});
    mesh_.points.resize(first + n);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t i = 0; i < 3; ++i) {
        mesh_.points[first + v][i] = all[i * n + v];
        if (!std::isfinite(all[i * n + v]))
          file_.fail(coordinates, "a coordinate of node " + std::to_string(v + 1) + " is not finite");
      }
    std::map<std::int64_t, std::vector<std::size_t>> points_of, cells_of; // by families
    const std::vector<std::int64_t> families = file_.integers(path + "/NOE/FAM");
    for (std::size_t v = 0; v < std::min(n, families.size()); ++v)
      if (families[v] != 0)
        points_of[families[v]].push_back(first + v);
    for (const std::string& type : file_.members(path + "/MAI"))
      read_cells(path + "/MAI/" + type, type, first, n, cells_of);
    add_groups("/FAS/" + name, prefix, points_of, cells_of);
  }

  void read_cells(const std::string& path, const std::string& type, std::size_t first, std::size_t n,
                  std::map<std::int64_t, std::vector<std::size_t>>& cells_of)
  {
    const Kind* kind = kind_of(type);
    const std::vector<std::int64_t> nodes = file_.integers(path + "/NOD");
    if (kind == nullptr) {
      if (type != "POG" && type != "PG2") // polygons go along
        for (std::int64_t node : nodes)
          if (node >= 1 && static_cast<std::size_t>(node) <= n)
            mesh_.held.push_back(first + static_cast<std::size_t>(node) - 1);
      return;
    }
    const std::size_t size = nodes.size() / kind->nodes;
    if (nodes.size() != size * kind->nodes)
      file_.fail(path + "/NOD", std::to_string(kind->nodes) + " nodes for each element are expected");
    const std::vector<std::int64_t> families = file_.integers(path + "/FAM");
    std::vector<std::size_t> of_cell(kind->nodes);
    for (std::size_t e = 0; e < size; ++e) {
      for (std::size_t i = 0; i < kind->nodes; ++i) {
        const std::int64_t node = nodes[i * size + e];
        if (node < 1 || static_cast<std::size_t>(node) > n)
          file_.fail(path + "/NOD", "element " + std::to_string(e + 1) + " refers to node " + std::to_string(node) +
                                      ", which does not exist");
        of_cell[i] = first + static_cast<std::size_t>(node) - 1;
      }
      const std::int64_t family = e < families.size() ? families[e] : 0;
      cells_of[family].push_back(mesh_.add_cell(kind->kind, kind->vtk_type, family, of_cell));
    }
  }

  // A family belongs to groups; a group is what its families have.
  void add_groups(const std::string& path, const std::string& prefix,
                  const std::map<std::int64_t, std::vector<std::size_t>>& points_of,
                  const std::map<std::int64_t, std::vector<std::size_t>>& cells_of)
  {
    std::map<std::string, std::vector<std::size_t>> points, cells;
    for (const char* kind : {"NOEUD", "ELEME"})
      for (const std::string& family : file_.members(path + "/" + kind)) {
        const std::string of_family = path + "/" + kind + "/" + family;
        const std::int64_t number = file_.integer_attribute(of_family, "NUM");
        const bool is_of_points = kind[0] == 'N';
        const auto& members = is_of_points ? points_of : cells_of;
        const auto found = members.find(number);
        if (!file_.exists(of_family + "/GRO/NOM"))
          continue;
        for (const std::string& group : file_.names(of_family + "/GRO/NOM")) {
          if (!is_of_points && number != 0) {
            std::string& label = mesh_.label_names[number];
            label += (label.empty() ? "" : ", ") + prefix + group;
          }
          auto& of_group = (is_of_points ? points : cells)[prefix + group];
          if (found != members.end())
            of_group.insert(of_group.end(), found->second.begin(), found->second.end());
        }
      }
    for (const auto& [group, of_group] : points)
      mesh_.add_set(CGAL::IO::Hex_mesh_set::Kind::VERTICES, group).vertices = of_group;
    for (const auto& [group, of_group] : cells)
      mesh_.add_set_of_cells(group, of_group);
  }

  std::string filename_;
  Hdf5_file file_;
  Solver_mesh mesh_;
  std::shared_ptr<Med_places> places_;
};

inline CGAL::IO::Hex_mesh_file read_med(const std::string& filename) { return Med_reader(filename).read(); }

#endif

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MED_READER_H
