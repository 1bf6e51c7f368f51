// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_ERROR_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_ERROR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The exception of the file readers and writers: which file, which line, why.

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::IO {

/*!
 * \ingroup PkgHexMeshOptimizationIO
 *
 * Thrown when a file cannot be read or written. `what()` reads "file:line: reason".
 */
class Hex_mesh_file_error : public std::runtime_error
{
public:
  /// line: 0 if none can be named.
  Hex_mesh_file_error(const std::string& file, std::size_t line, const std::string& reason)
    : std::runtime_error(file + (line == 0 ? std::string() : ":" + std::to_string(line)) + ": " + reason)
    , file_(file)
    , line_(line)
  {}

  /// the name of the file as it was passed.
  const std::string& file() const { return file_; }

  /// the line at fault, counted from 1; 0 if no line can be named, as in a binary file.
  std::size_t line() const { return line_; }

private:
  std::string file_;
  std::size_t line_;
};

} // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_HEX_MESH_FILE_ERROR_H
