// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAYS_OUTPUT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAYS_OUTPUT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Writes the data arrays of a .vtu file.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Vtu_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/data_values.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/vtu_roles.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline std::string xml_escaped(std::string_view text)
{
  std::string result;
  for (const char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

inline void write_vtu_array(Atomic_file& file, const CGAL::IO::Hex_mesh_data_array& array, bool is_binary,
                            bool has_number_of_tuples)
{
  std::string attributes = "Name=\"" + xml_escaped(array.name) + '"';
  if (array.number_of_components != 1)
    attributes += " NumberOfComponents=\"" + std::to_string(array.number_of_components) + '"';
  if (has_number_of_tuples)
    attributes += " NumberOfTuples=\"" + std::to_string(array.number_of_tuples()) + '"';
  for (const auto& [name, value] : array.attributes)
    attributes += ' ' + name + "=\"" + xml_escaped(value) + '"';

  std::visit(
    [&](const auto& values) {
      using Value = typename std::decay_t<decltype(values)>::value_type;
      constexpr bool are_bits = is_bit<Value>;
      if constexpr (is_string<Value>) {
        std::size_t size = 0;
        for (const std::string& value : values)
          size += value.size() + 1;
        Vtu_array<std::uint8_t> output(file, "String", attributes.c_str(), size, is_binary);
        for (const std::string& value : values) {
          for (const char c : value)
            output.append(static_cast<std::uint8_t>(c), ' ');
          output.append(0, '\n');
        }
        output.close();
      }
      else if (are_bits && is_binary) {
        if constexpr (are_bits) {
          const std::string bytes = packed_bits(values);
          Vtu_array<std::uint8_t> output(file, "Bit", attributes.c_str(), bytes.size(), true);
          for (const char byte : bytes)
            output.append(static_cast<std::uint8_t>(byte), ' ');
          output.close();
        }
      }
      else {
        using Number = std::conditional_t<are_bits, std::uint8_t, Value>;
        const std::string type = are_bits ? "Bit"
                                 : std::is_floating_point<Number>::value
                                   ? "Float" + std::to_string(8 * sizeof(Number))
                                   : (std::is_signed<Number>::value ? "Int" : "UInt") +
                                       std::to_string(8 * sizeof(Number));
        Vtu_array<Number> output(file, type.c_str(), attributes.c_str(), values.size(), is_binary);
        const std::size_t in_line = array.number_of_components == 0 ? 1 : array.number_of_components;
        for (std::size_t i = 0; i < values.size(); ++i)
          output.append(static_cast<Number>(values[i]), (i + 1) % in_line == 0 ? '\n' : ' ');
        output.close();
      }
    },
    array.values);
}

// PointData or CellData. The first array with a role is the active one.
inline void write_vtu_data(Atomic_file& file, const std::string& element,
                           const std::vector<const CGAL::IO::Hex_mesh_data_array*>& arrays, bool is_binary)
{
  using Role = CGAL::IO::Hex_mesh_data_array::Role;
  if (arrays.empty())
    return;
  file.text() += '<' + element;
  for (const auto& [attribute, role] : vtu_roles)
    for (const auto* array : arrays)
      if (array->role == role) {
        file.text() += std::string(" ") + attribute + "=\"" + xml_escaped(array->name) + '"';
        break;
      }
  file.text() += ">\n";
  for (const auto* array : arrays)
    if (array->role != Role::LOOKUP_TABLE)
      write_vtu_array(file, *array, is_binary, false);
  file.text() += "</" + element + ">\n";
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_VTU_ARRAYS_OUTPUT_H
