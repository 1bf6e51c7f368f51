// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_AS_TEXT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_AS_TEXT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Numbers from text and back, bit by bit and independent of the locale.

#include <charconv>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Reads a whole word as a double. An underflow reads as zero.
inline bool parse_number(std::string_view word, double& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
#if defined(__cpp_lib_to_chars)
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ptr != word.data() + word.size())
    return false;
  if (result.ec == std::errc::result_out_of_range) {
    const std::size_t e = word.find_first_of("eE");
    const bool small = e == std::string_view::npos ? word.find_first_of("123456789") > word.find('.')
                                                   : e + 1 < word.size() && word[e + 1] == '-';
    value = small ? 0. : std::numeric_limits<double>::infinity();
    return true;
  }
  return result.ec == std::errc();
#else
  std::istringstream in{std::string(word)};
  in.imbue(std::locale::classic());
  in >> value;
  return !in.fail() && in.peek() == std::istringstream::traits_type::eof();
#endif
}

template <class Integer, std::enable_if_t<std::is_integral<Integer>::value, int> = 0>
bool parse_number(std::string_view word, Integer& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

// Appends the shortest decimal number that reads back as the same number: at
// most 17 significant digits for a double, 9 for a float.
template <class Real, std::enable_if_t<std::is_floating_point<Real>::value, int> = 0>
void append_number(std::string& text, Real value)
{
#if defined(__cpp_lib_to_chars)
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
#else
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<Real>::max_digits10);
  out << value;
  text += out.str();
#endif
}

template <class Integer, std::enable_if_t<std::is_integral<Integer>::value, int> = 0>
void append_number(std::string& text, Integer value)
{
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_AS_TEXT_H
