// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the data arrays of a legacy VTK file.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/data_values.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/percent_encoding.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// The type of the numbers, by its name in lower case.
inline Number_type legacy_vtk_number_type(const std::string& name)
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
  if (name == "long" || name == "long_long" || name == "vtktypeint64")
    return {Number_kind::SIGNED, 8};
  if (name == "unsigned_long" || name == "unsigned_long_long" || name == "vtktypeuint64")
    return {Number_kind::UNSIGNED, 8};
  return {};
}

// Where the scanner stands in the file, arrays are read from there on. Errors are the scanner's.
class Legacy_vtk_arrays
{
public:
  using Array = CGAL::IO::Hex_mesh_data_array;
  using Role = Array::Role;

  Legacy_vtk_arrays(Text_scanner& scanner, bool is_binary) : scanner_(scanner), is_binary_(is_binary) {}

  // So many bytes, after the line of the keyword.
  const char* binary_data(std::size_t size)
  {
    scanner_.rest_of_line();
    return binary_data_here(size);
  }

  // The text of a METADATA block, which ends with an empty line; the keyword has been read.
  std::string metadata()
  {
    scanner_.rest_of_line();
    const std::size_t begin = scanner_.position();
    std::size_t end = begin;
    while (scanner_.position() < scanner_.text().size()) {
      if (scanner_.rest_of_line().empty())
        break;
      end = scanner_.position();
    }
    std::string text(scanner_.text().substr(begin, end - begin));
    if (!text.empty() && text.back() != '\n') // the file ends here
      text += '\n';
    return text;
  }

  // The arrays of a field; the keyword has been read.
  void read_field(std::vector<Array>& arrays)
  {
    scanner_.word(); // the name of the field
    const std::size_t number_of_arrays = scanner_.count("the number of arrays", 1);
    for (std::size_t a = 0; a < number_of_arrays; ++a) {
      std::string_view name = scanner_.word();
      for (; lowered(name) == "metadata"; name = scanner_.word()) {
        const std::string text = metadata();
        if (a > 0)
          arrays.back().metadata = text;
      }
      Array array;
      array.name = percent_decoded(name);
      array.number_of_components = scanner_.natural("the number of components");
      const std::uint64_t tuples = scanner_.natural("the number of tuples");
      read_values(array, scanner_.word(), tuples, false);
      arrays.push_back(std::move(array));
    }
  }

  // An attribute of points or cells, by its keyword in lower case, which has been read; false if it is none.
  bool read_attribute(const std::string& keyword, std::uint64_t tuples, std::vector<Array>& arrays)
  {
    struct Attribute
    {
      const char* keyword;
      Role role;
      std::size_t number_of_components; // 0: a number in the file
    };
    static const Attribute attributes[] = {
      {"scalars", Role::SCALARS, 1},          {"vectors", Role::VECTORS, 3},
      {"normals", Role::NORMALS, 3},          {"tensors", Role::TENSORS, 9},
      {"tensors6", Role::TENSORS, 6},         {"texture_coordinates", Role::TEXTURE_COORDINATES, 0},
      {"global_ids", Role::GLOBAL_IDS, 1},    {"pedigree_ids", Role::PEDIGREE_IDS, 1},
      {"edge_flags", Role::EDGE_FLAGS, 1},    {"color_scalars", Role::COLOR_SCALARS, 0},
      {"lookup_table", Role::LOOKUP_TABLE, 4}};
    const Attribute* attribute = nullptr;
    for (const Attribute& a : attributes)
      if (keyword == a.keyword)
        attribute = &a;
    if (attribute == nullptr)
      return false;

    Array array;
    array.role = attribute->role;
    array.name = percent_decoded(scanner_.word());
    array.number_of_components = attribute->number_of_components;
    if (array.number_of_components == 0)
      array.number_of_components = scanner_.natural("the number of components");
    std::string_view type = is_binary_ ? "unsigned_char" : "float"; // of colors
    bool is_at_line_start = false;
    if (array.role == Role::LOOKUP_TABLE)
      tuples = scanner_.natural("the number of colors");
    else if (array.role != Role::COLOR_SCALARS)
      type = scanner_.word();
    if (array.role == Role::SCALARS) {
      Text_scanner line(scanner_.filename(), scanner_.rest_of_line(), '\0', scanner_.line());
      if (!line.at_end())
        array.number_of_components = line.natural("the number of components");
      const Text_scanner before = scanner_;
      if (lowered(scanner_.word()) == "lookup_table")
        array.lookup_table = std::string(scanner_.word());
      else {
        scanner_ = before;
        is_at_line_start = true;
      }
    }
    read_values(array, type, tuples, is_at_line_start);
    arrays.push_back(std::move(array));
    return true;
  }

private:
  const char* binary_data_here(std::size_t size)
  {
    scanner_.stop_naming_lines();
    if (size > scanner_.text().size() - scanner_.position())
      scanner_.fail("the file ends within the data");
    const char* data = scanner_.text().data() + scanner_.position();
    scanner_.skip(size);
    return data;
  }

  void read_values(Array& array, std::string_view type, std::uint64_t tuples, bool is_at_line_start)
  {
    // a bit is the least that a value takes; the product below does not overflow
    const std::size_t left = scanner_.text().size() - scanner_.position();
    if (tuples / 8 > left || (tuples != 0 && array.number_of_components / 8 > left / tuples))
      scanner_.fail("the array is larger than the rest of the file");
    const std::size_t size = array.number_of_components * static_cast<std::size_t>(tuples);
    const std::string name = lowered(type);
    array.type_name = std::string(type);
    if (name == "string")
      array.values = strings(size, is_at_line_start);
    else if (name == "bit")
      array.values = std::vector<bool>();
    else if (name == "vtkidtype" && !is_binary_)
      array.values = std::vector<std::int64_t>(); // as text they may have more digits
    else {
      const Number_type number_type = legacy_vtk_number_type(name);
      if (number_type.size == 0)
        scanner_.fail("arrays of type \"" + Text_scanner::printable(type) + "\" cannot be read");
      array.values = empty_values(number_type);
    }
    std::visit(
      [&](auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (!is_string<Value>) {
          if (is_binary_) {
            const std::size_t bytes = byte_count<Value>(size);
            const char* data = is_at_line_start ? binary_data_here(bytes) : binary_data(bytes);
            read_binary_values(data, size, is_little_endian_machine(), values);
          }
          else {
            if (size > (left + 1) / 2)
              scanner_.fail(std::to_string(size) + " numbers are more than the rest of the file can hold");
            read_text_values(scanner_, size, values);
          }
        }
      },
      array.values);
  }

  // One a line, or each with its length before it.
  std::vector<std::string> strings(std::size_t count, bool is_at_line_start)
  {
    std::vector<std::string> result;
    if (!is_at_line_start)
      scanner_.rest_of_line();
    const std::string_view text = scanner_.text();
    if (is_binary_)
      scanner_.stop_naming_lines();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t left = text.size() - scanner_.position();
      if (left == 0)
        scanner_.fail("the file ends within the strings");
      if (!is_binary_) {
        result.push_back(percent_decoded(scanner_.rest_of_line()));
        continue;
      }
      // The first two bits tell in how many bytes the length is written.
      const unsigned char head = static_cast<unsigned char>(text[scanner_.position()]);
      const std::size_t bytes = std::size_t(8) >> (head >> 6);
      if (bytes > left)
        scanner_.fail("the file ends within a string");
      std::uint64_t length = head & 0x3f;
      for (std::size_t b = 1; b < bytes; ++b)
        length = length << 8 | static_cast<unsigned char>(text[scanner_.position() + b]);
      if (length > left - bytes)
        scanner_.fail("the file ends within a string");
      scanner_.skip(bytes);
      result.emplace_back(text.substr(scanner_.position(), static_cast<std::size_t>(length)));
      scanner_.skip(static_cast<std::size_t>(length));
    }
    return result;
  }

  Text_scanner& scanner_;
  const bool is_binary_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_H
