// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_IN_WIDTH_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_IN_WIDTH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The decimal number nearest to a double that a field of a file can hold.

#include <CGAL/Hex_mesh_optimization/IO/internal/number_as_text.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

enum class Number_style {
  GENERAL, // 1.5e-7
  NASTRAN  // 1.5-7, with a point always
};

// Reads a number in either style, with the letter of an exponent in Fortran; blanks around it are skipped, and nothing but
// blanks is 0.
inline bool parse_solver_number(std::string_view field, double& value)
{
  while (!field.empty() && (field.front() == ' ' || field.front() == '\t'))
    field.remove_prefix(1);
  while (!field.empty() && (field.back() == ' ' || field.back() == '\t' || field.back() == '\r'))
    field.remove_suffix(1);
  value = 0;
  if (field.empty() || parse_number(field, value))
    return true;
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const char c = field[i];
    const bool is_sign = c == '+' || c == '-';
    if (c == 'd' || c == 'D')
      text += 'e';
    else if (is_sign && i > 0 && text.back() != 'e' && text.back() != 'E')
      (text += 'e') += c;
    else if (!(c == '+' && i == 0))
      text += c;
  }
  if (!text.empty() && text.back() == '.' && text.find_first_of("eE") == std::string::npos)
    text.pop_back();
  return parse_number(text, value);
}

// The exponent without what the style does not need.
inline std::string with_short_exponent(const std::string& number, Number_style style)
{
  const std::size_t e = number.find('e');
  if (e == std::string::npos)
    return number;
  std::string mantissa = number.substr(0, e);
  std::size_t digits = e + 2; // behind the sign
  while (digits + 1 < number.size() && number[digits] == '0')
    ++digits;
  const std::string exponent = number.substr(digits);
  const bool is_negative = number[e + 1] == '-';
  if (style == Number_style::NASTRAN) {
    if (mantissa.find('.') == std::string::npos)
      mantissa += '.';
    return mantissa + (is_negative ? '-' : '+') + exponent;
  }
  return mantissa + 'e' + (is_negative ? "-" : "") + exponent;
}

// Without the zero before the point where there is no room for it, and without zeros at the end.
inline std::string shortened(std::string number)
{
  if (number.find('.') != std::string::npos && number.find('e') == std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    const std::size_t sign = number[0] == '-';
    if (number.size() > sign + 2 && number[sign] == '0' && number[sign + 1] == '.')
      number.erase(sign, 1);
  }
  return number;
}

// `width`: the most characters; at least 7.
inline std::string number_in_width(double value, std::size_t width, Number_style style)
{
  std::string best;
  append_number(best, value);
  best = with_short_exponent(best, style);
  if (style == Number_style::NASTRAN && best.find('.') == std::string::npos)
    best += '.';
  if (best.size() <= width)
    return best;
  best.clear();
  double error = 0;
  const auto consider = [&](const std::string& text) {
    double back;
    if (text.size() > width || !parse_solver_number(text, back))
      return;
    if (best.empty() || std::abs(back - value) < error) {
      best = text;
      error = std::abs(back - value);
    }
  };
  char buffer[400];
  const int room = static_cast<int>(width);
  if (std::abs(value) < 1e16) {
    // a digit may come with rounding
    const int before_point = std::max(1, static_cast<int>(std::snprintf(buffer, sizeof(buffer), "%.0f", value)));
    for (int decimals = std::max(0, room - before_point - 2); decimals <= room; ++decimals) {
      char* const end = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::fixed, decimals).ptr;
      std::string text = shortened(std::string(static_cast<char*>(buffer), end));
      if (text.find('.') == std::string::npos)
        text += '.';
      consider(text);
    }
  }
  for (int digits = std::max(0, room - 10); digits <= std::min(room, 17); ++digits) {
    char* const end = std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::scientific, digits).ptr;
    consider(with_short_exponent(std::string(static_cast<char*>(buffer), end), style));
  }
  return best;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NUMBER_IN_WIDTH_H
