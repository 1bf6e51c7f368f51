// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BINARY_NUMBER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BINARY_NUMBER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Numbers from the bytes of a file and back, in either order of bytes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

enum class Number_kind { SIGNED, UNSIGNED, FLOATING };

// The type of the numbers of an array in a file; size 0: unknown.
struct Number_type
{
  Number_kind kind = Number_kind::SIGNED;
  std::size_t size = 0;
};

// Decodes one number from `from`; `reverse` if the bytes are in the other order.
template <class Value>
Value decode_number(const char* from, Number_type type, bool reverse)
{
  char bytes[8];
  std::copy(from, from + type.size, bytes);
  if (reverse)
    std::reverse(bytes, bytes + type.size);
  const auto as = [&](auto number) {
    std::memcpy(&number, bytes, sizeof(number));
    return static_cast<Value>(number);
  };
  switch (type.kind) {
  case Number_kind::FLOATING:
    return type.size == 4 ? as(float()) : as(double());
  case Number_kind::SIGNED:
    return type.size == 1   ? as(std::int8_t())
           : type.size == 2 ? as(std::int16_t())
           : type.size == 4 ? as(std::int32_t())
                            : as(std::int64_t());
  default:
    return type.size == 1   ? as(std::uint8_t())
           : type.size == 2 ? as(std::uint16_t())
           : type.size == 4 ? as(std::uint32_t())
                            : as(std::uint64_t());
  }
}

template <class Number>
void append_binary(std::string& text, Number number, bool little_endian)
{
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &number, sizeof(Number));
  if (little_endian != is_little_endian_machine())
    std::reverse(bytes, bytes + sizeof(Number));
  text.append(bytes, sizeof(Number));
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_BINARY_NUMBER_H
