// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads hexahedra or polygons in the legacy format of VTK (.vtk, text and binary).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Legacy_vtk_arrays.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/add_vtk_cell.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/complete_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Legacy_vtk_reader
{
public:
  Legacy_vtk_reader(const std::string& filename, Wanted_cells wanted)
    : text_(read_whole_file(filename))
    , scanner_(filename, text_)
    , wanted_(wanted)
  {}

  Mesh_file_content read()
  {
    read_header();
    while (read_section()) {
    }
    content_.mesh_data.is_binary = is_binary_;
    if (grid_ != Grid::UNSTRUCTURED) {
      make_grid();
      complete_mesh_data(content_);
      return std::move(content_);
    }
    if (!has_points_)
      scanner_.fail("there are no POINTS");
    if (is_poly_data_)
      return std::move(content_);
    if (!cells_)
      scanner_.fail("there are no CELLS");
    if (!has_types_)
      scanner_.fail("there are no CELL_TYPES");
    add_cells(*cells_, [this](std::size_t i) { return types_[i]; });
    complete_mesh_data(content_);
    return std::move(content_);
  }

private:
  struct Cells
  {
    std::vector<std::int64_t> offsets; // one more than there are cells
    std::vector<std::int64_t> vertices;
    std::vector<std::size_t> lines; // of the vertices, 0 where none can be named
    std::size_t line;
    std::size_t size() const { return offsets.size() - 1; }
  };

  void read_header()
  {
    const std::string first = lowered(scanner_.rest_of_line());
    const std::string magic = "# vtk datafile version ";
    if (first.compare(0, magic.size(), magic) != 0)
      scanner_.fail(1, "this is no legacy VTK file: it does not begin with \"# vtk DataFile Version\"");
    double version = 0;
    std::string number = first.substr(magic.size());
    number.erase(number.find_last_not_of(" \t") + 1);
    if (!parse_number(number, version) || !(version >= 1 && version < 6))
      scanner_.fail(1, "version " + Text_scanner::printable(number) + " of the format is unknown");
    has_offsets_ = version >= 5;
    content_.mesh_data.title = std::string(scanner_.rest_of_line());
    const std::string encoding = lowered(scanner_.word());
    if (encoding != "ascii" && encoding != "binary")
      scanner_.fail("ASCII or BINARY is expected");
    is_binary_ = encoding == "binary";
  }

  bool read_section()
  {
    const std::string keyword = lowered(scanner_.word());
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data") {
      if (wanted_ == Wanted_cells::HEXAHEDRA)
        read_data(keyword);
      return false;
    }
    if (keyword == "dataset")
      read_dataset(lowered(scanner_.word()));
    else if (keyword == "field")
      arrays().read_field(content_.mesh_data.field_data);
    else if (keyword == "metadata") {
      // of the points, or of the last array of the field before them
      const std::string text = arrays().metadata();
      if (!has_points_ && !content_.mesh_data.field_data.empty())
        content_.mesh_data.field_data.back().metadata = text;
    }
    else if (!has_dataset_)
      scanner_.fail("DATASET is expected, not \"" + Text_scanner::printable(keyword) + "\"");
    else if (keyword == "points")
      read_points();
    else if (!(is_poly_data_                 ? read_polygon_section(keyword)
               : grid_ == Grid::UNSTRUCTURED ? read_cell_section(keyword)
                                             : read_grid_section(keyword)))
      scanner_.fail("unknown keyword \"" + Text_scanner::printable(keyword) + "\"");
    return true;
  }

  void read_dataset(const std::string& type)
  {
    if (wanted_ == Wanted_cells::POLYGONS)
      is_poly_data_ = type == "polydata";
    else
      grid_ = type == "structured_grid"     ? Grid::CURVILINEAR
              : type == "rectilinear_grid"  ? Grid::RECTILINEAR
              : type == "structured_points" ? Grid::UNIFORM
                                            : Grid::UNSTRUCTURED;
    if (type != "unstructured_grid" && !is_poly_data_ && grid_ == Grid::UNSTRUCTURED)
      scanner_.fail("the dataset is " + Text_scanner::printable(type) + ", not UNSTRUCTURED_GRID");
    has_dataset_ = true;
  }

  bool read_polygon_section(const std::string& keyword)
  {
    if (keyword == "vertices" || keyword == "lines")
      read_cells();
    else if (keyword == "polygons")
      add_cells(read_cells(), [](std::size_t) { return 7; });
    else if (keyword == "triangle_strips")
      add_cells(read_cells(), [](std::size_t) { return 6; });
    else
      return false;
    return true;
  }

  bool read_cell_section(const std::string& keyword)
  {
    if (keyword == "cells")
      cells_ = read_cells();
    else if (keyword == "cell_types") {
      const std::size_t count = scanner_.count("the number of cell types", is_binary_ ? 4 : 2);
      types_ = read_values<std::int64_t>("int", count, "a cell type");
      has_types_ = true;
    }
    else
      return false;
    return true;
  }

  bool read_grid_section(const std::string& keyword)
  {
    if (keyword == "dimensions")
      read_dimensions();
    else if (grid_ == Grid::UNIFORM && keyword == "origin")
      origin_ = read_three("a coordinate of the origin");
    else if (grid_ == Grid::UNIFORM && (keyword == "spacing" || keyword == "aspect_ratio"))
      spacing_ = read_three("a spacing");
    else if (grid_ == Grid::RECTILINEAR && keyword == "x_coordinates")
      read_coordinates(0);
    else if (grid_ == Grid::RECTILINEAR && keyword == "y_coordinates")
      read_coordinates(1);
    else if (grid_ == Grid::RECTILINEAR && keyword == "z_coordinates")
      read_coordinates(2);
    else
      return false;
    return true;
  }

  template <class Value>
  std::vector<Value> read_values(const std::string& type_name, std::size_t count, const char* what,
                                 std::vector<std::size_t>* lines = nullptr)
  {
    const Number_type type = legacy_vtk_number_type(type_name);
    if (type.size == 0 || (type.kind == Number_kind::FLOATING && std::is_integral<Value>::value))
      scanner_.fail("numbers of type \"" + Text_scanner::printable(type_name) + "\" cannot be read here");
    std::vector<Value> values;
    if (is_binary_) {
      if (count > text_.size() / type.size)
        scanner_.fail("the file ends within the data");
      const char* data = arrays().binary_data(count * type.size);
      values.reserve(count);
      for (std::size_t i = 0; i < count; ++i) {
        values.push_back(decode_number<Value>(data + i * type.size, type, is_little_endian_machine()));
        if constexpr (std::is_floating_point<Value>::value)
          if (!std::isfinite(values.back()))
            scanner_.fail(std::string(what) + " is not a finite number: number " + std::to_string(i));
      }
      return values;
    }
    if (count > (text_.size() - scanner_.position() + 1) / 2)
      scanner_.fail(std::to_string(count) + " numbers are more than the rest of the file can hold");
    values.reserve(count);
    if (lines != nullptr)
      lines->reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (std::is_floating_point<Value>::value)
        values.push_back(scanner_.coordinate(what));
      else
        values.push_back(scanner_.integer(what));
      if (lines != nullptr)
        lines->push_back(scanner_.line());
    }
    return values;
  }

  void read_points()
  {
    if (has_points_)
      scanner_.fail("there are POINTS a second time");
    has_points_ = true;
    const std::size_t count = scanner_.count("the number of points", is_binary_ ? 3 : 6);
    const std::string type = lowered(scanner_.word());
    const std::vector<double> values = read_values<double>(type, 3 * count, "a coordinate");
    content_.points.resize(count);
    for (std::size_t i = 0; i < values.size(); ++i)
      content_.points[i / 3][i % 3] = values[i];
  }

  Cells read_cells()
  {
    Cells cells;
    cells.line = scanner_.line();
    const std::size_t count = scanner_.count("the number of cells", is_binary_ ? 4 : 2);
    const std::size_t size = scanner_.count("the size of the cells", is_binary_ ? 4 : 2);
    if (has_offsets_) {
      if (count > 0) {
        expect("offsets");
        cells.offsets = read_values<std::int64_t>(lowered(scanner_.word()), count, "an offset");
        expect("connectivity");
        cells.vertices = read_values<std::int64_t>(lowered(scanner_.word()), size, "the number of a point",
                                                   &cells.lines);
      }
      if (cells.offsets.empty())
        cells.offsets.push_back(0);
      bool ascending = cells.offsets.front() == 0 &&
                       cells.offsets.back() == static_cast<std::int64_t>(cells.vertices.size());
      for (std::size_t i = 1; i < cells.offsets.size(); ++i)
        ascending = ascending && cells.offsets[i - 1] <= cells.offsets[i];
      if (!ascending)
        scanner_.fail(cells.line, "the offsets do not ascend from 0 to the size of the connectivity");
      return cells;
    }

    // The size of each cell stands before its vertices.
    std::vector<std::size_t> lines;
    const std::vector<std::int64_t> values = read_values<std::int64_t>("int", size, "the number of a point", &lines);
    cells.offsets.push_back(0);
    std::size_t i = 0;
    for (std::size_t c = 0; c < count; ++c) {
      if (i == size)
        scanner_.fail("the size of the cells is too small for " + std::to_string(count) + " cells");
      const std::int64_t n = values[i];
      if (n < 0 || static_cast<std::uint64_t>(n) > size - i - 1)
        scanner_.fail(lines.empty() ? 0 : lines[i],
                      "cell " + std::to_string(c) + " cannot have " + std::to_string(n) + " vertices");
      ++i;
      for (const std::size_t end = i + static_cast<std::size_t>(n); i < end; ++i) {
        cells.vertices.push_back(values[i]);
        if (!lines.empty())
          cells.lines.push_back(lines[i]);
      }
      cells.offsets.push_back(static_cast<std::int64_t>(cells.vertices.size()));
    }
    if (i != size)
      scanner_.fail("the size of the cells is too large for " + std::to_string(count) + " cells");
    return cells;
  }

  void expect(const char* keyword)
  {
    if (lowered(scanner_.word()) != keyword)
      scanner_.fail(std::string("the keyword ") + keyword + " is expected");
  }

  template <class Type_of>
  void add_cells(const Cells& cells, const Type_of& type_of)
  {
    if (!is_poly_data_ && types_.size() != cells.size())
      scanner_.fail("there are " + std::to_string(cells.size()) + " cells and " + std::to_string(types_.size()) +
                    " cell types");
    std::vector<std::size_t> vertices;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::size_t begin = static_cast<std::size_t>(cells.offsets[c]);
      const std::size_t end = static_cast<std::size_t>(cells.offsets[c + 1]);
      const auto line = [&](std::size_t i) { return cells.lines.empty() ? 0 : cells.lines[i]; };
      vertices.clear();
      for (std::size_t i = begin; i < end; ++i) {
        const std::int64_t v = cells.vertices[i];
        if (v < 0 || static_cast<std::uint64_t>(v) >= content_.points.size())
          scanner_.fail(line(i), "cell " + std::to_string(c) + ": point " + std::to_string(v) +
                                   " does not exist, there are " + std::to_string(content_.points.size()) + " points");
        vertices.push_back(static_cast<std::size_t>(v));
      }
      const std::string wrong = add_vtk_cell(content_, wanted_, type_of(c), vertices.data(), vertices.size());
      if (!wrong.empty())
        scanner_.fail(begin < end ? line(begin) : 0, "cell " + std::to_string(c) + ": " + wrong);
    }
  }

  Legacy_vtk_arrays arrays() { return {scanner_, is_binary_}; }

  // Everything after the mesh itself is data on it. The mesh is read even if they are damaged.
  void read_data(std::string keyword)
  {
    std::vector<CGAL::IO::Hex_mesh_data_array>* target = nullptr;
    std::uint64_t tuples = 0;
    try {
      for (; !keyword.empty(); keyword = lowered(scanner_.word()))
        if (keyword == "point_data" || keyword == "cell_data") {
          target = keyword == "point_data" ? &content_.mesh_data.point_data : &content_.mesh_data.cell_data;
          tuples = scanner_.natural("the number of tuples");
        }
        else if (keyword == "field")
          arrays().read_field(*target);
        else if (keyword == "metadata") {
          const std::string text = arrays().metadata();
          if (!target->empty())
            target->back().metadata = text;
        }
        else if (!arrays().read_attribute(keyword, tuples, *target))
          scanner_.fail("unknown keyword \"" + Text_scanner::printable(keyword) + "\"");
    }
    catch (const CGAL::IO::Hex_mesh_file_error& error) {
      content_.mesh_data.skipped.push_back("the data from here on: " + std::string(error.what()));
    }
  }

  // The number of points in each direction.
  void read_dimensions()
  {
    for (std::size_t& d : dimensions_)
      d = scanner_.natural("a number of points");
    has_dimensions_ = true;
  }

  std::array<double, 3> read_three(const char* what)
  {
    std::array<double, 3> x;
    for (double& x_i : x)
      x_i = scanner_.coordinate(what);
    return x;
  }

  void read_coordinates(int axis)
  {
    const std::size_t count = scanner_.count("the number of coordinates", is_binary_ ? 1 : 2);
    const std::string type = lowered(scanner_.word());
    coordinates_[axis] = read_values<double>(type, count, "a coordinate");
  }

  // The points of a grid whose file does not list them, and the hexahedra between the points of any grid.
  void make_grid()
  {
    const auto& n = dimensions_;
    if (!has_dimensions_)
      scanner_.fail("there are no DIMENSIONS");
    if (n[0] < 2 || n[1] < 2 || n[2] < 2)
      scanner_.fail("a grid of " + printed_dimensions() + " points has no hexahedra");
    // A grid in a file that lists neither points nor data may be large, but not out of all proportion.
    const std::size_t most = has_points_ ? content_.points.size() : (std::max)(std::size_t(1) << 22, text_.size());
    if (n[0] > most / n[1] || n[0] * n[1] > most / n[2])
      scanner_.fail("a grid of " + printed_dimensions() + " points is more than " +
                    (has_points_ ? "the POINTS of the file" : "a file of this size can hold"));
    const std::size_t count = n[0] * n[1] * n[2];
    if (grid_ == Grid::CURVILINEAR) {
      if (!has_points_)
        scanner_.fail("there are no POINTS");
      if (content_.points.size() != count)
        scanner_.fail("there are " + std::to_string(content_.points.size()) + " points, not " + printed_dimensions());
    }
    else {
      if (grid_ == Grid::RECTILINEAR)
        for (int axis = 0; axis < 3; ++axis)
          if (coordinates_[axis].size() != n[axis])
            scanner_.fail("there are " + std::to_string(coordinates_[axis].size()) + ' ' + "XYZ"[axis] +
                          "_COORDINATES, not " + std::to_string(n[axis]));
      content_.points.reserve(count);
      const auto coordinate = [&](int axis, std::size_t i) {
        return grid_ == Grid::RECTILINEAR ? coordinates_[axis][i] : origin_[axis] + double(i) * spacing_[axis];
      };
      for (std::size_t k = 0; k < n[2]; ++k)
        for (std::size_t j = 0; j < n[1]; ++j)
          for (std::size_t i = 0; i < n[0]; ++i) {
            content_.points.push_back({coordinate(0, i), coordinate(1, j), coordinate(2, k)});
            for (const double x : content_.points.back())
              if (!std::isfinite(x))
                scanner_.fail("a coordinate of the grid is not a finite number");
          }
    }
    content_.hexahedra.reserve((n[0] - 1) * (n[1] - 1) * (n[2] - 1));
    for (std::size_t k = 0; k + 1 < n[2]; ++k)
      for (std::size_t j = 0; j + 1 < n[1]; ++j)
        for (std::size_t i = 0; i + 1 < n[0]; ++i) {
          const std::size_t v = i + n[0] * (j + n[1] * k), y = n[0], z = n[0] * n[1];
          content_.hexahedra.push_back({v, v + 1, v + y + 1, v + y, v + z, v + z + 1, v + z + y + 1, v + z + y});
        }
    content_.mesh_data.skipped.push_back("the dimensions " + printed_dimensions() +
                                         " of the grid: it is an unstructured one from here on");
  }

  std::string printed_dimensions() const
  {
    return std::to_string(dimensions_[0]) + " x " + std::to_string(dimensions_[1]) + " x " +
           std::to_string(dimensions_[2]);
  }

  enum class Grid { UNSTRUCTURED, CURVILINEAR, RECTILINEAR, UNIFORM };

  std::string text_;
  Text_scanner scanner_;
  Wanted_cells wanted_;
  bool has_offsets_ = false;
  bool is_binary_ = false;
  bool is_poly_data_ = false;
  bool has_dataset_ = false;
  bool has_points_ = false;
  bool has_types_ = false;
  Grid grid_ = Grid::UNSTRUCTURED;
  bool has_dimensions_ = false;
  std::array<std::size_t, 3> dimensions_{};
  std::array<double, 3> origin_{}, spacing_{{1, 1, 1}};
  std::array<std::vector<double>, 3> coordinates_; // of a rectilinear grid
  std::optional<Cells> cells_;
  std::vector<std::int64_t> types_;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H
