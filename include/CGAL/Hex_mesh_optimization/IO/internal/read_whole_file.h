// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_READ_WHOLE_FILE_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_READ_WHOLE_FILE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The bytes of a file, or of a pipe, in memory.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>

#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <system_error>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline std::string read_whole_file(const std::string& filename)
{
  std::ifstream in(filename, std::ios::binary);
  std::error_code ignored;
  if (!in || std::filesystem::is_directory(filename, ignored))
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot open the file for reading");
  std::string content;
  // A pipe has no size.
  in.seekg(0, std::ios::end);
  const std::streamoff size = in.tellg();
  if (!in || size < 0) {
    in.clear();
    content.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  else {
    in.seekg(0);
    content.resize(static_cast<std::size_t>(size));
    in.read(&content[0], size);
    content.resize(static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad())
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot read the file");
  return content;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_READ_WHOLE_FILE_H
