// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H

// Reads hexahedra or polygons in the legacy format of VTK (.vtk, text and binary).

#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/add_vtk_cell.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

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
    if (!has_points_)
      scanner_.fail("there are no POINTS");
    if (is_poly_data_)
      return std::move(content_);
    if (!cells_)
      scanner_.fail("there are no CELLS");
    if (!has_types_)
      scanner_.fail("there are no CELL_TYPES");
    add_cells(*cells_, [this](std::size_t i) { return types_[i]; });
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
    scanner_.rest_of_line(); // the title
    const std::string encoding = lowered(scanner_.word());
    if (encoding != "ascii" && encoding != "binary")
      scanner_.fail("ASCII or BINARY is expected");
    is_binary_ = encoding == "binary";
  }

  bool read_section()
  {
    const std::string keyword = lowered(scanner_.word());
    // Everything after the mesh itself is data on it.
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data")
      return false;
    if (keyword == "dataset") {
      const std::string type = lowered(scanner_.word());
      is_poly_data_ = type == "polydata" && wanted_ == Wanted_cells::POLYGONS;
      if (type != "unstructured_grid" && !is_poly_data_)
        scanner_.fail("the dataset is " + Text_scanner::printable(type) + ", not UNSTRUCTURED_GRID");
      has_dataset_ = true;
    }
    else if (keyword == "field")
      skip_field();
    else if (keyword == "metadata")
      skip_metadata();
    else if (!has_dataset_)
      scanner_.fail("DATASET is expected, not \"" + Text_scanner::printable(keyword) + "\"");
    else if (keyword == "points")
      read_points();
    else if (keyword == "cells" && !is_poly_data_)
      cells_ = read_cells();
    else if (keyword == "cell_types" && !is_poly_data_) {
      const std::size_t count = scanner_.count("the number of cell types", is_binary_ ? 4 : 2);
      types_ = read_values<std::int64_t>("int", count, "a cell type");
      has_types_ = true;
    }
    else if (is_poly_data_ && (keyword == "vertices" || keyword == "lines"))
      read_cells();
    else if (is_poly_data_ && keyword == "polygons")
      add_cells(read_cells(), [](std::size_t) { return 7; });
    else if (is_poly_data_ && keyword == "triangle_strips")
      add_cells(read_cells(), [](std::size_t) { return 6; });
    else
      scanner_.fail("unknown keyword \"" + Text_scanner::printable(keyword) + "\"");
    return true;
  }

  static Number_type number_type(const std::string& name)
  {
    if (name == "float")
      return {Number_kind::FLOATING, 4};
    if (name == "double")
      return {Number_kind::FLOATING, 8};
    if (name == "char" || name == "signed_char" || name == "vtktypeint8")
      return {Number_kind::SIGNED, 1};
    if (name == "unsigned_char" || name == "vtktypeuint8")
      return {Number_kind::UNSIGNED, 1};
    if (name == "short" || name == "vtktypeint16")
      return {Number_kind::SIGNED, 2};
    if (name == "unsigned_short" || name == "vtktypeuint16")
      return {Number_kind::UNSIGNED, 2};
    if (name == "int" || name == "vtkidtype" || name == "vtktypeint32")
      return {Number_kind::SIGNED, 4};
    if (name == "unsigned_int" || name == "vtktypeuint32")
      return {Number_kind::UNSIGNED, 4};
    if (name == "long" || name == "vtktypeint64")
      return {Number_kind::SIGNED, 8};
    if (name == "unsigned_long" || name == "vtktypeuint64")
      return {Number_kind::UNSIGNED, 8};
    return {};
  }

  // The bytes of `count` numbers of the given type, after the line of the keyword.
  const char* binary_data(Number_type type, std::size_t count)
  {
    scanner_.rest_of_line();
    scanner_.stop_naming_lines();
    if (count > (text_.size() - scanner_.position()) / type.size)
      scanner_.fail("the file ends within the data");
    const char* data = text_.data() + scanner_.position();
    scanner_.skip(count * type.size);
    return data;
  }

  template <class Value>
  std::vector<Value> read_values(const std::string& type_name, std::size_t count, const char* what,
                                 std::vector<std::size_t>* lines = nullptr)
  {
    const Number_type type = number_type(type_name);
    if (type.size == 0 || (type.kind == Number_kind::FLOATING && std::is_integral<Value>::value))
      scanner_.fail("numbers of type \"" + Text_scanner::printable(type_name) + "\" cannot be read here");
    std::vector<Value> values;
    if (is_binary_) {
      const char* data = binary_data(type, count);
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

  // Ends with an empty line.
  void skip_metadata()
  {
    scanner_.rest_of_line();
    while (scanner_.position() < text_.size() && !scanner_.rest_of_line().empty()) {
    }
  }

  void skip_field()
  {
    scanner_.word(); // the name of the field
    const std::size_t number_of_arrays = scanner_.count("the number of arrays", 1);
    for (std::size_t a = 0; a < number_of_arrays; ++a) {
      while (lowered(scanner_.word()) == "metadata")
        skip_metadata();
      const std::size_t components = scanner_.count("the number of components", 1);
      const std::size_t tuples = scanner_.count("the number of tuples", 1);
      const std::string type = lowered(scanner_.word());
      if (tuples != 0 && components > text_.size() / tuples)
        scanner_.fail("the array is larger than the file");
      const std::size_t size = components * tuples;
      if (type == "string")
        skip_strings(size);
      else if (is_binary_) {
        if (number_type(type).size == 0)
          scanner_.fail("arrays of type \"" + Text_scanner::printable(type) + "\" cannot be read");
        binary_data(number_type(type), size);
      }
      else
        for (std::size_t i = 0; i < size; ++i)
          scanner_.word();
    }
  }

  void skip_strings(std::size_t count)
  {
    scanner_.rest_of_line();
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_binary_) {
        scanner_.rest_of_line();
        continue;
      }
      // The first two bits tell in how many bytes the length is written.
      scanner_.stop_naming_lines();
      const std::size_t left = text_.size() - scanner_.position();
      const unsigned char head = left == 0 ? 0 : static_cast<unsigned char>(text_[scanner_.position()]);
      const std::size_t bytes = std::size_t(8) >> (head >> 6);
      if (bytes > left)
        scanner_.fail("the file ends within a string");
      std::uint64_t length = head & (bytes == 8 ? 0xff : 0x3f);
      for (std::size_t b = 1; b < bytes; ++b)
        length = length << 8 | static_cast<unsigned char>(text_[scanner_.position() + b]);
      if (length > left - bytes)
        scanner_.fail("the file ends within a string");
      scanner_.skip(bytes + static_cast<std::size_t>(length));
    }
  }

  std::string text_;
  Text_scanner scanner_;
  Wanted_cells wanted_;
  bool has_offsets_ = false;
  bool is_binary_ = false;
  bool is_poly_data_ = false;
  bool has_dataset_ = false;
  bool has_points_ = false;
  bool has_types_ = false;
  std::optional<Cells> cells_;
  std::vector<std::int64_t> types_;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_READER_H
