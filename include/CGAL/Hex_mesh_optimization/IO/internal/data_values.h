// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_DATA_VALUES_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_DATA_VALUES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The values of a data array, from text and bytes and back.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data_array.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/binary_number.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

using Data_values = CGAL::IO::Hex_mesh_data_array::Values;

// Empty, of numbers of this type, which must have a size.
inline Data_values empty_values(Number_type type)
{
  if (type.kind == Number_kind::FLOATING) {
    if (type.size == 4)
      return std::vector<float>();
    return std::vector<double>();
  }
  const bool is_signed = type.kind == Number_kind::SIGNED;
  switch (type.size) {
  case 1:
    return is_signed ? Data_values(std::vector<std::int8_t>()) : std::vector<std::uint8_t>();
  case 2:
    return is_signed ? Data_values(std::vector<std::int16_t>()) : std::vector<std::uint16_t>();
  case 4:
    return is_signed ? Data_values(std::vector<std::int32_t>()) : std::vector<std::uint32_t>();
  default:
    return is_signed ? Data_values(std::vector<std::int64_t>()) : std::vector<std::uint64_t>();
  }
}

template <class Value>
constexpr bool is_bit = std::is_same<Value, bool>::value;
template <class Value>
constexpr bool is_string = std::is_same<Value, std::string>::value;

// The type of numbers that a vector of the values has; bits and strings have none.
template <class Value>
constexpr Number_type number_type_of()
{
  if constexpr (is_bit<Value> || is_string<Value>)
    return {};
  else
    return {std::is_floating_point<Value>::value ? Number_kind::FLOATING
            : std::is_signed<Value>::value       ? Number_kind::SIGNED
                                                 : Number_kind::UNSIGNED,
            sizeof(Value)};
}

// Reads a word as a number of an array: any floating point number, or an integer that the type can hold.
template <class Value>
bool parse_value(std::string_view word, Value& value)
{
  double real = 0;
  if constexpr (std::is_floating_point<Value>::value) {
    if (!parse_number(word, real))
      return false;
    value = static_cast<Value>(real);
    return true;
  }
  else {
    if (parse_number(word, value))
      return true;
    // 2.0 or 1e6
    if (!parse_number(word, real) || real != std::floor(real) || std::abs(real) > double(std::int64_t(1) << 53) ||
        real < double((std::numeric_limits<Value>::lowest)()) || real > double((std::numeric_limits<Value>::max)()))
      return false;
    value = static_cast<Value>(real);
    return true;
  }
}

// Appends the next `count` numbers of a text; the caller has checked that the text can hold so many.
template <class Value>
void read_text_values(Text_scanner& scanner, std::size_t count, std::vector<Value>& values)
{
  values.reserve(values.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = scanner.word();
    if (word.empty())
      scanner.fail("a number is expected, but the data end here");
    bool is_number;
    if constexpr (is_bit<Value>) {
      int bit = 0;
      is_number = parse_value(word, bit) && (bit == 0 || bit == 1);
      values.push_back(bit != 0);
    }
    else {
      Value value{};
      is_number = parse_value(word, value);
      values.push_back(value);
    }
    if (!is_number)
      scanner.fail("a number of the array is expected, not \"" + Text_scanner::printable(word) + "\"");
  }
}

// How many bytes `count` values take.
template <class Value>
std::size_t byte_count(std::size_t count)
{
  return is_bit<Value> ? count / 8 + (count % 8 != 0) : count * sizeof(Value);
}

// Appends `count` values from so many bytes; the bits of a byte begin with the highest.
template <class Value>
void read_binary_values(const char* bytes, std::size_t count, bool reverse, std::vector<Value>& values)
{
  values.reserve(values.size() + count);
  for (std::size_t i = 0; i < count; ++i)
    if constexpr (is_bit<Value>)
      values.push_back((static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1) != 0);
    else
      values.push_back(decode_number<Value>(bytes + i * sizeof(Value), number_type_of<Value>(), reverse));
}

template <class Value>
void append_text_value(std::string& text, Value value)
{
  if constexpr (is_bit<Value>)
    text += value ? '1' : '0';
  else
    append_number(text, value);
}

// The bits of a vector as bytes.
inline std::string packed_bits(const std::vector<bool>& bits)
{
  std::string bytes(byte_count<bool>(bits.size()), '\0');
  for (std::size_t i = 0; i < bits.size(); ++i)
    if (bits[i])
      bytes[i / 8] = static_cast<char>(static_cast<unsigned char>(bytes[i / 8]) | 0x80u >> i % 8);
  return bytes;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_DATA_VALUES_H
