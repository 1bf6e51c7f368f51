// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SPLIT_FIELDS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SPLIT_FIELDS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Lines of files that have fields.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline std::string_view trimmed(std::string_view text)
{
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

// At least one field.
inline std::vector<std::string_view> split(std::string_view line, char separator)
{
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(separator, begin);
    fields.push_back(line.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos)
      return fields;
    begin = end + 1;
  }
}

// The words between blanks.
inline std::vector<std::string_view> words(std::string_view line)
{
  std::vector<std::string_view> result;
  std::size_t i = 0;
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (i < line.size()) {
    while (i < line.size() && is_blank(line[i]))
      ++i;
    const std::size_t begin = i;
    while (i < line.size() && !is_blank(line[i]))
      ++i;
    if (i > begin)
      result.push_back(line.substr(begin, i - begin));
  }
  return result;
}

inline std::string unquoted(std::string_view text)
{
  if (text.size() > 1 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
    text = text.substr(1, text.size() - 2);
  return std::string(text);
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SPLIT_FIELDS_H
