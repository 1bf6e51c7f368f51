// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LOWERED_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LOWERED_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Words to be compared without regard to case.

#include <algorithm>
#include <string>
#include <string_view>

namespace CGAL::Hex_mesh_optimization::internal::IO {

inline char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

inline std::string lowered(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_LOWERED_H
