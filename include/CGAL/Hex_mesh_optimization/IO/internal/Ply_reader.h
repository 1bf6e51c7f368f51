// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLY_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLY_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the points and polygons of a PLY file, text or binary. What a file announces is never
// believed before its size allows for it.

#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Not CGAL's reader: it allocates what each list announces, follows a null pointer where coordinates are integers,
// wants the format in the second line, and names no line.
class Ply_reader
{
public:
  explicit Ply_reader(const std::string& filename) : text_(read_whole_file(filename)), scanner_(filename, text_) {}

  Mesh_file_content read()
  {
    read_header();
    for (const Element& element : elements_) {
      // every property takes at least one byte, as text two
      const std::size_t least = element.properties.size() * (is_binary_ ? 1 : 2);
      if (least > 0 && element.count > (text_.size() - scanner_.position() + 1) / least)
        scanner_.fail("there are fewer elements " + Text_scanner::printable(element.name) + " than the header says");
      for (std::uint64_t i = 0; least > 0 && i < element.count; ++i)
        read_element(element);
    }
    check_polygons();
    return std::move(content_);
  }

private:
  enum class Role { IGNORED, X, Y, Z, VERTICES };

  struct Property
  {
    Number_type type;
    Number_type size_type; // of a list
    bool is_list = false;
    Role role = Role::IGNORED;
  };

  struct Element
  {
    std::string name;
    std::uint64_t count;
    std::vector<Property> properties;
  };

  void read_header()
  {
    if (scanner_.rest_of_line() != "ply")
      scanner_.fail(1, "this is no PLY file: it does not begin with \"ply\"");
    bool has_format = false;
    for (;;) {
      if (scanner_.position() == text_.size())
        scanner_.fail("the header does not end");
      const std::size_t line_number = scanner_.line();
      const std::string line(scanner_.rest_of_line());
      Text_scanner words(scanner_.filename(), line, '\0', line_number);
      const std::string_view keyword = words.word();
      if (keyword == "end_header")
        break;
      if (keyword == "format") {
        const std::string_view format = words.word();
        is_binary_ = format != "ascii";
        reverse_ = (format == "binary_little_endian") != is_little_endian_machine();
        has_format = !is_binary_ || format == "binary_little_endian" || format == "binary_big_endian";
      }
      else if (keyword == "element") {
        const std::string name(words.word());
        const std::int64_t count = words.integer("the number of elements");
        if (count < 0)
          words.fail("the number of elements is negative");
        elements_.push_back({name, static_cast<std::uint64_t>(count), {}});
      }
      else if (keyword == "property")
        read_property(words);
      else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
        words.fail("unknown keyword \"" + Text_scanner::printable(keyword) + "\"");
    }
    if (!has_format)
      scanner_.fail(0, "the format is none of ascii, binary_little_endian and binary_big_endian");
    if (is_binary_)
      scanner_.stop_naming_lines();
  }

  void read_property(Text_scanner& words)
  {
    if (elements_.empty())
      words.fail("a property comes before all elements");
    Element& element = elements_.back();
    Property property;
    std::string_view type = words.word();
    if (type == "list") {
      property.is_list = true;
      property.size_type = number_type(words, words.word());
      if (property.size_type.kind == Number_kind::FLOATING)
        words.fail("the size of a list is not an integer");
      type = words.word();
    }
    property.type = number_type(words, type);
    const std::string_view name = words.word();
    if (element.name == "vertex" && !property.is_list)
      property.role = name == "x" ? Role::X : name == "y" ? Role::Y : name == "z" ? Role::Z : Role::IGNORED;
    else if (element.name == "face" && property.is_list && (name == "vertex_indices" || name == "vertex_index")) {
      property.role = Role::VERTICES;
      if (property.type.kind == Number_kind::FLOATING)
        words.fail("the vertices of faces are not integers");
    }
    element.properties.push_back(property);
  }

  static Number_type number_type(const Text_scanner& words, std::string_view name)
  {
    if (name == "char" || name == "int8")
      return {Number_kind::SIGNED, 1};
    if (name == "uchar" || name == "uint8")
      return {Number_kind::UNSIGNED, 1};
    if (name == "short" || name == "int16")
      return {Number_kind::SIGNED, 2};
    if (name == "ushort" || name == "uint16")
      return {Number_kind::UNSIGNED, 2};
    if (name == "int" || name == "int32")
      return {Number_kind::SIGNED, 4};
    if (name == "uint" || name == "uint32")
      return {Number_kind::UNSIGNED, 4};
    if (name == "float" || name == "float32")
      return {Number_kind::FLOATING, 4};
    if (name == "double" || name == "float64")
      return {Number_kind::FLOATING, 8};
    words.fail("numbers of type \"" + Text_scanner::printable(name) + "\" are unknown");
  }

  template <class Value>
  Value number(Number_type type, const char* what)
  {
    if (is_binary_) {
      if (type.size > text_.size() - scanner_.position())
        scanner_.fail("the file ends within the data");
      const char* const bytes = text_.data() + scanner_.position();
      scanner_.skip(type.size);
      return decode_number<Value>(bytes, type, reverse_);
    }
    if constexpr (std::is_integral<Value>::value)
      return scanner_.integer(what);
    else
      return scanner_.coordinate(what);
  }

  void ignore(Number_type type)
  {
    if (is_binary_)
      number<double>(type, "");
    else if (scanner_.word().empty())
      scanner_.fail("the file ends within the data");
  }

  void read_element(const Element& element)
  {
    std::array<double, 3> point = {{0, 0, 0}};
    std::vector<std::size_t> polygon;
    for (const Property& property : element.properties) {
      std::int64_t size = 1;
      if (property.is_list) {
        size = number<std::int64_t>(property.size_type, "the size of a list");
        const std::size_t least = is_binary_ ? property.type.size : 2;
        if (size < 0 || static_cast<std::uint64_t>(size) > (text_.size() - scanner_.position() + 1) / least)
          scanner_.fail("a list cannot have " + std::to_string(size) + " numbers");
      }
      for (std::int64_t i = 0; i < size; ++i)
        if (property.role == Role::IGNORED)
          ignore(property.type);
        else if (property.role == Role::VERTICES) // negative ones become huge
          polygon.push_back(static_cast<std::size_t>(number<std::int64_t>(property.type, "the number of a vertex")));
        else {
          double& x = point[static_cast<std::size_t>(property.role) - 1];
          x = number<double>(property.type, "a coordinate");
          if (!std::isfinite(x))
            scanner_.fail("vertex " + std::to_string(content_.points.size()) + " has a coordinate that is not finite");
        }
    }
    if (element.name == "vertex")
      content_.points.push_back(point);
    else if (element.name == "face")
      content_.polygons.push_back(std::move(polygon));
  }

  // Faces may come before vertices.
  void check_polygons() const
  {
    for (std::size_t i = 0; i < content_.polygons.size(); ++i)
      for (const std::size_t v : content_.polygons[i])
        if (v >= content_.points.size())
          scanner_.fail(0, "face " + std::to_string(i) + " refers to vertex " +
                             std::to_string(static_cast<std::int64_t>(v)) + ", there are " +
                             std::to_string(content_.points.size()) + " vertices");
  }

  std::string text_;
  Text_scanner scanner_;
  bool is_binary_ = false;
  bool reverse_ = false;
  std::vector<Element> elements_;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLY_READER_H
