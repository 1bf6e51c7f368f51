// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PERCENT_ENCODING_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PERCENT_ENCODING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Names and strings as words of a legacy VTK file: %20 stands for a space.

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline std::string percent_encoded(std::string_view text)
{
  const char* const digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text)
    if (c <= ' ' || c > '~' || c == '"' || c == '%') {
      const unsigned char byte = static_cast<unsigned char>(c);
      result += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    else
      result += c;
  return result;
}

// A percent sign without two digits after it stands for itself.
inline std::string percent_decoded(std::string_view text)
{
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                  : -1;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
      i += 2;
    }
    else
      result += text[i];
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PERCENT_ENCODING_H
