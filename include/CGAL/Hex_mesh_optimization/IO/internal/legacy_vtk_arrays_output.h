// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_OUTPUT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_OUTPUT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Writes the data arrays of a legacy VTK file.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Legacy_vtk_arrays.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/data_values.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/percent_encoding.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Legacy_vtk_arrays_output
{
public:
  using Array = CGAL::IO::Hex_mesh_data_array;
  using Role = Array::Role;

  Legacy_vtk_arrays_output(Atomic_file& file, bool is_binary) : file_(file), is_binary_(is_binary) {}

  void write_field(const std::vector<const Array*>& arrays)
  {
    if (arrays.empty())
      return;
    file_.text() += "FIELD FieldData " + std::to_string(arrays.size()) + "\n";
    for (const Array* array : arrays) {
      file_.text() += name(*array) + " " + std::to_string(array->number_of_components) + " " +
                      std::to_string(array->number_of_tuples()) + " " + type_name(*array) + "\n";
      write_values(*array);
    }
  }

  // POINT_DATA or CELL_DATA. Consecutive arrays without a keyword of their own share a field.
  void write_attributes(const std::string& keyword, std::size_t tuples, const std::vector<const Array*>& arrays)
  {
    if (arrays.empty())
      return;
    file_.text() += keyword + " " + std::to_string(tuples) + "\n";
    std::vector<const Array*> field;
    for (const Array* array : arrays) {
      const std::string line = attribute_line(*array);
      if (line.empty()) {
        field.push_back(array);
        continue;
      }
      write_field(field);
      field.clear();
      file_.text() += line;
      if (array->role == Role::COLOR_SCALARS || array->role == Role::LOOKUP_TABLE)
        write_colors(*array);
      else
        write_values(*array);
    }
    write_field(field);
  }

private:
  static std::string name(const Array& array) { return array.name.empty() ? "unnamed" : percent_encoded(array.name); }

  std::string type_name(const Array& array) const
  {
    return std::visit(
      [&](const auto& values) -> std::string {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (is_string<Value>)
          return "string";
        else if constexpr (is_bit<Value>)
          return "bit";
        else {
          // The names of later versions of the format are not known to all readers of this one.
          const std::string given = lowered(array.type_name);
          const Number_type type = number_type_of<Value>(), named = legacy_vtk_number_type(given);
          const bool is_text_id = !is_binary_ && given == "vtkidtype";
          if (is_text_id || (given.compare(0, 7, "vtktype") != 0 && named.kind == type.kind && named.size == type.size))
            return array.type_name;
          if (type.kind == Number_kind::FLOATING)
            return type.size == 4 ? "float" : "double";
          const std::string sign = type.kind == Number_kind::UNSIGNED ? "unsigned_" : "";
          return sign + (type.size == 1 ? "char" : type.size == 2 ? "short" : type.size == 4 ? "int" : "long");
        }
      },
      array.values);
  }

  // The line, or lines, before the values; empty if the array can only be in a field.
  std::string attribute_line(const Array& array) const
  {
    const std::size_t n = array.number_of_components;
    const std::string text = ' ' + name(array) + ' ', type = type_name(array) + '\n';
    const bool is_text = std::holds_alternative<std::vector<std::string>>(array.values);
    const bool is_color = std::holds_alternative<std::vector<float>>(array.values) ||
                          std::holds_alternative<std::vector<std::uint8_t>>(array.values);
    if (is_text)
      return array.role == Role::PEDIGREE_IDS && n == 1 ? "PEDIGREE_IDS" + text + type : std::string();
    switch (array.role) {
    case Role::SCALARS:
      if (n < 1 || n > 4)
        return {};
      return "SCALARS" + text + type_name(array) + (n == 1 ? "" : " " + std::to_string(n)) + "\nLOOKUP_TABLE " +
             (array.lookup_table.empty() ? "default" : array.lookup_table) + '\n';
    case Role::VECTORS:
      return n == 3 ? "VECTORS" + text + type : std::string();
    case Role::NORMALS:
      return n == 3 ? "NORMALS" + text + type : std::string();
    case Role::TENSORS:
      return n == 9 ? "TENSORS" + text + type : n == 6 ? "TENSORS6" + text + type : std::string();
    case Role::TEXTURE_COORDINATES:
      return n >= 1 && n <= 3 ? "TEXTURE_COORDINATES" + text + std::to_string(n) + ' ' + type : std::string();
    case Role::GLOBAL_IDS:
      return n == 1 ? "GLOBAL_IDS" + text + type : std::string();
    case Role::PEDIGREE_IDS:
      return n == 1 ? "PEDIGREE_IDS" + text + type : std::string();
    case Role::EDGE_FLAGS:
      return n == 1 ? "EDGE_FLAGS" + text + type : std::string();
    case Role::COLOR_SCALARS:
      return is_color ? "COLOR_SCALARS" + text + std::to_string(n) + '\n' : std::string();
    case Role::LOOKUP_TABLE:
      return is_color && n == 4 ? "LOOKUP_TABLE" + text + std::to_string(array.number_of_tuples()) + '\n'
                                : std::string();
    case Role::NONE:
      break;
    }
    return {};
  }

  // Colors are bytes in a binary file and between 0 and 1 as text.
  void write_colors(const Array& array)
  {
    Array converted;
    converted.number_of_components = array.number_of_components;
    converted.metadata = array.metadata;
    if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&array.values); bytes != nullptr && !is_binary_) {
      std::vector<float> values;
      for (const std::uint8_t byte : *bytes)
        values.push_back(float(byte) / 255);
      converted.values = values;
      return write_values(converted);
    }
    if (const auto* numbers = std::get_if<std::vector<float>>(&array.values); numbers != nullptr && is_binary_) {
      std::vector<std::uint8_t> values;
      for (const float number : *numbers)
        values.push_back(static_cast<std::uint8_t>(255 * (std::min)((std::max)(0.f, number), 1.f) + .5f));
      converted.values = values;
      return write_values(converted);
    }
    write_values(array);
  }

  void write_values(const Array& array)
  {
    std::string& text = file_.text();
    std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (is_string<Value>) {
          for (const std::string& value : values) {
            if (is_binary_)
              append_string(value);
            else
              text += percent_encoded(value) + '\n';
            file_.write_if_large();
          }
          if (is_binary_)
            text += '\n';
        }
        else if (is_binary_) {
          if constexpr (is_bit<Value>)
            text += packed_bits(values);
          else
            for (const Value value : values) {
              append_binary(text, value, false);
              file_.write_if_large();
            }
          text += '\n';
        }
        else {
          // no line much longer than others
          const std::size_t in_line = (std::min)(std::max<std::size_t>(array.number_of_components, 1), std::size_t(9));
          for (std::size_t i = 0; i < values.size(); ++i) {
            append_text_value<Value>(text, values[i]);
            text += (i + 1) % in_line == 0 || i + 1 == values.size() ? '\n' : ' ';
            file_.write_if_large();
          }
        }
      },
      array.values);
    if (!array.metadata.empty())
      text += "METADATA\n" + array.metadata + '\n';
  }

  // The length of a string is written in the last bits of 1, 2, 4 or 8 bytes; the first two tell of how many.
  void append_string(const std::string& value)
  {
    const std::uint64_t length = value.size();
    int size = 1;
    std::uint64_t kind = 3;
    for (; size < 8 && length >> (8 * size - 2) != 0; size *= 2)
      --kind;
    const std::uint64_t head = kind << (8 * size - 2) | length;
    for (int b = size - 1; b >= 0; --b)
      file_.text() += static_cast<char>(head >> 8 * b & 0xff);
    file_.text() += value;
  }

  Atomic_file& file_;
  const bool is_binary_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LEGACY_VTK_ARRAYS_OUTPUT_H
