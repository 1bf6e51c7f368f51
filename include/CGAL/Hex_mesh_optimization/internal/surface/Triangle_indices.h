// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_INDICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_INDICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How triangle surfaces are given: by indices into points.

#include <array>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

using Triangle_indices = std::array<int, 3>;

using Edge_list = std::vector<std::array<int, 2>>;

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_INDICES_H
