// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXODUS_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXODUS_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads a mesh of Exodus II through netCDF, and writes its coordinates in place, in a copy.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF
#include <netcdf.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

#ifndef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF

inline CGAL::IO::Hex_mesh_file read_exodus(const std::string& filename)
{
  throw CGAL::IO::Hex_mesh_file_error(
    filename, 0, "this is a file of Exodus, and this program was built without netCDF (Debian: libnetcdf-dev)");
}

#else

class Netcdf_file
{
public:
  Netcdf_file(const std::string& filename, bool is_written) : filename_(filename)
  {
    check(nc_open(filename.c_str(), is_written ? NC_WRITE : NC_NOWRITE, &id_), "cannot open the file");
  }
  Netcdf_file(const Netcdf_file&) = delete;
  Netcdf_file& operator=(const Netcdf_file&) = delete;
  ~Netcdf_file()
  {
    if (id_ >= 0)
      nc_close(id_);
  }

  void close()
  {
    const int id = id_;
    id_ = -1;
    check(nc_close(id), "cannot write the file");
  }

  // -1 if there is none
  int variable(const std::string& name) const
  {
    int v = -1;
    return nc_inq_varid(id_, name.c_str(), &v) == NC_NOERR ? v : -1;
  }

  // 0 if there is none
  std::size_t dimension(const std::string& name) const
  {
    int d = -1;
    std::size_t length = 0;
    return nc_inq_dimid(id_, name.c_str(), &d) == NC_NOERR && nc_inq_dimlen(id_, d, &length) == NC_NOERR ? length : 0;
  }

  std::vector<std::size_t> shape(int v) const
  {
    int n = 0;
    check(nc_inq_varndims(id_, v, &n), "the variable cannot be read");
    std::vector<int> dimensions(static_cast<std::size_t>(n));
    if (n > 0)
      check(nc_inq_vardimid(id_, v, dimensions.data()), "the variable cannot be read");
    std::vector<std::size_t> result;
    for (int d : dimensions) {
      std::size_t length = 0;
      check(nc_inq_dimlen(id_, d, &length), "the variable cannot be read");
      result.push_back(length);
    }
    return result;
  }

  std::size_t size(int v) const
  {
    std::size_t result = 1;
    for (std::size_t n : shape(v)) {
      if (n > 0 && result > most_numbers / n)
        fail("the variable is larger than can be read", v);
      result *= n;
    }
    return result;
  }

  std::vector<double> reals(int v) const
  {
    std::vector<double> result(size(v));
    if (!result.empty())
      check(nc_get_var_double(id_, v, result.data()), "the variable cannot be read", v);
    return result;
  }

  std::vector<std::int64_t> integers(const std::string& name) const
  {
    const int v = variable(name);
    if (v < 0)
      return {};
    std::vector<long long> numbers(size(v));
    if (!numbers.empty())
      check(nc_get_var_longlong(id_, v, numbers.data()), "the variable cannot be read", v);
    return std::vector<std::int64_t>(numbers.begin(), numbers.end());
  }

  // The rows of an array of characters
  std::vector<std::string> names(const std::string& name) const
  {
    const int v = variable(name);
    std::vector<std::string> result;
    if (v < 0 || shape(v).size() != 2 || type(v) != NC_CHAR)
      return result;
    const std::size_t rows = shape(v)[0], columns = shape(v)[1];
    std::string text(size(v), '\0');
    if (!text.empty())
      check(nc_get_var_text(id_, v, &text[0]), "the variable cannot be read", v);
    for (std::size_t r = 0; r < rows; ++r) {
      std::string row = text.substr(r * columns, columns);
      row.erase(std::min(row.find('\0'), row.size()));
      row.erase(row.find_last_not_of(' ') + 1);
      result.push_back(row);
    }
    return result;
  }

  std::string text_attribute(int v, const char* name) const
  {
    std::size_t length = 0;
    nc_type type = NC_NAT;
    if (nc_inq_att(id_, v, name, &type, &length) != NC_NOERR || type != NC_CHAR)
      return std::string();
    std::string text(length, '\0');
    if (length > 0 && nc_get_att_text(id_, v, name, &text[0]) != NC_NOERR)
      return std::string();
    text.erase(std::min(text.find('\0'), text.size()));
    return text;
  }

  nc_type type(int v) const
  {
    nc_type result = NC_NAT;
    check(nc_inq_vartype(id_, v, &result), "the variable cannot be read", v);
    return result;
  }

  // `first`, `count`: in each dimension
  void write(int v, const std::vector<std::size_t>& first, const std::vector<std::size_t>& count,
             const std::vector<double>& values)
  {
    check(nc_put_vara_double(id_, v, first.data(), count.data(), values.data()), "cannot write the variable", v);
  }

  [[noreturn]] void fail(const std::string& reason, int v = -1) const
  {
    char name[NC_MAX_NAME + 1] = "";
    std::string of_variable;
    if (v >= 0 && nc_inq_varname(id_, v, name) == NC_NOERR)
      of_variable = std::string("variable ") + name + ": ";
    throw CGAL::IO::Hex_mesh_file_error(filename_, 0, of_variable + reason);
  }

private:
  static constexpr std::size_t most_numbers = std::size_t(1) << 36;

  void check(int code, const std::string& reason, int v = -1) const
  {
    if (code != NC_NOERR)
      fail(reason + ": " + nc_strerror(code), v);
  }

  std::string filename_;
  int id_ = -1;
};

class Netcdf_places : public Coordinate_places
{
public:
  Netcdf_places(const std::string& filename, const std::vector<std::string>& variables, bool is_single)
    : filename_(filename)
    , variables_(variables)
    , is_single_(is_single)
  {}

  Triple rounded(std::size_t, const Triple& before, const Triple& after) const override
  {
    Triple result = after;
    for (int i = 0; i < 3; ++i)
      if (is_single_ && before[i] != after[i])
        result[i] = static_cast<float>(after[i]);
    return result;
  }

  double resolution(std::size_t, const Triple& p) const override
  {
    return is_single_ ? 1.2e-7 * std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) : 0;
  }

  void check_output(const std::string&, const std::vector<char>&) const override {}

  void write(const std::string& output, const std::vector<Triple>& before,
             const std::vector<Triple>& after) const override
  {
    std::error_code ignored;
    if (before == after && std::filesystem::equivalent(filename_, output, ignored))
      return;
    Temporary_copy copy(filename_, output);
    if (before != after) {
      Netcdf_file file(copy.name(), true);
      std::vector<double> values(after.size());
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t v = 0; v < after.size(); ++v)
          values[v] = after[v][i];
        const bool are_together = variables_.size() == 1;
        const int variable = file.variable(variables_[are_together ? 0 : i]);
        if (variable < 0)
          file.fail("the coordinates are gone");
        if (are_together)
          file.write(variable, {i, 0}, {1, values.size()}, values);
        else
          file.write(variable, {0}, {values.size()}, values);
      }
      file.close();
    }
    copy.commit();
  }

private:
  std::string filename_;
  std::vector<std::string> variables_; // one for each coordinate, or one for all
  bool is_single_;
};

class Exodus_reader
{
public:
  explicit Exodus_reader(const std::string& filename) : filename_(filename), file_(filename, false) {}

  CGAL::IO::Hex_mesh_file read()
  {
    mesh_.format = "Exodus II";
    read_points();
    const std::size_t blocks = file_.dimension("num_el_blk");
    const std::vector<std::int64_t> ids = file_.integers("eb_prop1");
    const std::vector<std::string> names = file_.names("eb_names");
    for (std::size_t b = 0; b < blocks; ++b)
      read_block(b, b < ids.size() ? ids[b] : static_cast<std::int64_t>(b) + 1,
                 b < names.size() ? names[b] : std::string());
    read_node_sets();
    read_side_sets();
    return mesh_.finish(places_);
  }

private:
  void read_points()
  {
    std::vector<std::string> variables = {"coordx", "coordy", "coordz"};
    std::vector<double> all;
    std::size_t n = 0;
    bool is_single = false;
    if (file_.variable("coord") >= 0) {
      variables = {"coord"};
      const int v = file_.variable("coord");
      const std::vector<std::size_t> shape = file_.shape(v);
      if (shape.size() != 2 || shape[0] != 3)
        file_.fail("three coordinates of each node are expected", v);
      all = file_.reals(v);
      n = shape[1];
      is_single = file_.type(v) == NC_FLOAT;
    }
    else
      for (const std::string& name : variables) {
        const int v = file_.variable(name);
        if (v < 0)
          file_.fail("there is no variable " + name + ": this is no mesh of Exodus in three dimensions");
        const std::vector<double> values = file_.reals(v);
        if (file_.shape(v).size() != 1 || (!all.empty() && values.size() != n))
          file_.fail("one number for each node is expected", v);
        n = values.size();
        all.insert(all.end(), values.begin(), values.end());
        is_single = is_single || file_.type(v) == NC_FLOAT;
      }
    mesh_.points.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t i = 0; i < 3; ++i) {
        mesh_.points[p][i] = all[i * n + p];
        if (!std::isfinite(all[i * n + p]))
          file_.fail("a coordinate of node " + std::to_string(p + 1) + " is not finite");
      }
    places_ = std::make_shared<Netcdf_places>(filename_, variables, is_single);
  }

  void read_block(std::size_t b, std::int64_t id, const std::string& name)
  {
    const std::string number = std::to_string(b + 1);
    const int v = file_.variable("connect" + number);
    const std::string title = name.empty() ? "block " + std::to_string(id) : name;
    if (v < 0) {
      hold_polyhedra(number);
      count_without_nodes(number);
      return;
    }
    const std::vector<std::size_t> shape = file_.shape(v);
    if (shape.size() != 2)
      file_.fail("a row for each element is expected", v);
    const std::string type = lowered(file_.text_attribute(v, "elem_type"));
    const std::vector<std::int64_t> nodes = file_.integers("connect" + number);
    const std::size_t per_element = shape[1];
    int vtk_type = 0;
    const Cell_kind kind = kind_of(type, per_element, vtk_type);
    std::vector<std::size_t> of_element(per_element), members;
    for (std::size_t e = 0; e < shape[0]; ++e) {
      for (std::size_t i = 0; i < per_element; ++i) {
        const std::int64_t node = nodes[e * per_element + i];
        if (node < 1 || static_cast<std::size_t>(node) > mesh_.points.size())
          file_.fail("element " + std::to_string(e + 1) + " refers to node " + std::to_string(node) +
                       ", which does not exist",
                     v);
        of_element[i] = static_cast<std::size_t>(node) - 1;
      }
      members.push_back(mesh_.add_cell(kind, vtk_type, id, of_element));
    }
    mesh_.label_names[id] = title;
    mesh_.add_set_of_cells(title, members);
    if (kind == Cell_kind::HEXAHEDRON)
      mesh_.sets.back().kind = CGAL::IO::Hex_mesh_set::Kind::CELLS;
  }

  static bool begins(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

  static Cell_kind kind_of(const std::string& type, std::size_t nodes, int& vtk_type)
  {
    vtk_type = 0;
    if (begins(type, "hex") && nodes >= 8) {
      vtk_type = 12;
      return Cell_kind::HEXAHEDRON;
    }
    if (begins(type, "tet"))
      vtk_type = nodes == 4 ? 10 : 0;
    else if (begins(type, "wed") || begins(type, "pri"))
      vtk_type = nodes == 6 ? 13 : 0;
    else if (begins(type, "pyr"))
      vtk_type = nodes == 5 ? 14 : 0;
    else {
      for (const char* lower : {"shell", "quad", "tri", "bar", "beam", "truss", "rod", "spring", "sphere", "circle",
                                "edge", "nsided", "line", "point", "node", "particle"})
        if (begins(type, lower)) {
          const bool is_triangle = begins(type, "tri") || type.find("shell3") != std::string::npos;
          vtk_type = nodes == 4 ? 9 : nodes == 3 && is_triangle ? 5 : nodes == 2 ? 3 : nodes == 1 ? 1 : 0;
          return Cell_kind::OTHER;
        }
    }
    return Cell_kind::SOLID;
  }

  // A block of polyhedra names faces, and those name nodes.
  void hold_polyhedra(const std::string& number)
  {
    if (file_.variable("facconn" + number) < 0)
      return;
    for (std::size_t b = 1; b <= file_.dimension("num_fa_blk"); ++b)
      for (std::int64_t node : file_.integers("fbconn" + std::to_string(b)))
        if (node >= 1 && static_cast<std::size_t>(node) <= mesh_.points.size())
          mesh_.held.push_back(static_cast<std::size_t>(node) - 1);
    mesh_.notes.push_back("polyhedra are held");
  }

  // Side sets count all elements.
  void count_without_nodes(const std::string& number)
  {
    const std::size_t n = file_.dimension("num_el_in_blk" + number);
    if (n > mesh_.points.size() * 100 + 1000)
      file_.fail("block " + number + " has more elements than there can be");
    for (std::size_t e = 0; e < n; ++e)
      mesh_.add_cell(Cell_kind::OTHER, 0, 0, {});
  }

  std::string title(const char* kind, std::size_t s, const std::vector<std::int64_t>& ids,
                    const std::vector<std::string>& names) const
  {
    if (s < names.size() && !names[s].empty())
      return names[s];
    return kind + std::to_string(s < ids.size() ? ids[s] : static_cast<std::int64_t>(s) + 1);
  }

  void read_node_sets()
  {
    const std::vector<std::int64_t> ids = file_.integers("ns_prop1");
    const std::vector<std::string> names = file_.names("ns_names");
    for (std::size_t s = 0; s < file_.dimension("num_node_sets"); ++s) {
      CGAL::IO::Hex_mesh_set& set = mesh_.add_set(CGAL::IO::Hex_mesh_set::Kind::VERTICES,
                                                  title("node set ", s, ids, names));
      for (std::int64_t node : file_.integers("node_ns" + std::to_string(s + 1)))
        if (node >= 1 && static_cast<std::size_t>(node) <= mesh_.points.size())
          set.vertices.push_back(static_cast<std::size_t>(node) - 1);
    }
  }

  void read_side_sets()
  {
    static const int sides[6][4] = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}};
    const std::vector<std::int64_t> ids = file_.integers("ss_prop1");
    const std::vector<std::string> names = file_.names("ss_names");
    for (std::size_t s = 0; s < file_.dimension("num_side_sets"); ++s) {
      const std::vector<std::int64_t> elements = file_.integers("elem_ss" + std::to_string(s + 1)),
                                      numbers = file_.integers("side_ss" + std::to_string(s + 1));
      CGAL::IO::Hex_mesh_set& set = mesh_.add_set(CGAL::IO::Hex_mesh_set::Kind::FACES,
                                                  title("side set ", s, ids, names));
      set.size = elements.size();
      for (std::size_t i = 0; i < std::min(elements.size(), numbers.size()); ++i) {
        if (elements[i] < 1 || static_cast<std::size_t>(elements[i]) > mesh_.cells.size())
          continue;
        const std::size_t cell = static_cast<std::size_t>(elements[i]) - 1;
        const Solver_mesh::Cell& of_side = mesh_.cells[cell];
        if (of_side.kind == Cell_kind::HEXAHEDRON && numbers[i] >= 1 && numbers[i] <= 6)
          set.faces.push_back(mesh_.side(cell, sides[numbers[i] - 1]));
        else if (of_side.vtk_type == 9 && numbers[i] <= 2)
          set.faces.push_back(mesh_.side(cell, {0, 1, 2, 3}));
      }
    }
  }

  std::string filename_;
  Netcdf_file file_;
  Solver_mesh mesh_;
  std::shared_ptr<Netcdf_places> places_;
};

inline CGAL::IO::Hex_mesh_file read_exodus(const std::string& filename) { return Exodus_reader(filename).read(); }

#endif

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXODUS_READER_H
