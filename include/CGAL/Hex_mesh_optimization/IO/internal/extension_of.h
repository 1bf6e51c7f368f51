// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXTENSION_OF_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXTENSION_OF_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What tells the format of a file: the extension of its name.

#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>

#include <cstddef>
#include <string>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// The extension of a file name without its dot, in lower case.
inline std::string extension_of(const std::string& filename)
{
  const std::size_t dot = filename.find_last_of("./\\");
  return dot == std::string::npos || filename[dot] != '.' ? std::string() : lowered(filename.substr(dot + 1));
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_EXTENSION_OF_H
