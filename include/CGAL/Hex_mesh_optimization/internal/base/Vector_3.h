// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_VECTOR_3_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_VECTOR_3_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The engine's vector: points of any kernel are brought to doubles on entry.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

using Vector_3 = Eigen::Vector3d;
using Matrix_3 = Eigen::Matrix3d;
using Positions = std::vector<Vector_3>;

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_VECTOR_3_H
