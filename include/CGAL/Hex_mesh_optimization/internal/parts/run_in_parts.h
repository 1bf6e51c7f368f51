// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The optimization of a mesh part by part. It is no template, and compiled apart where the engine is.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/separate_compilation.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Mesh_slices.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Parts_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>

namespace CGAL::Hex_mesh_optimization::internal {

// Writes the points, or throws Input_error and does not. Collective; the status is the same on all ranks, but for times.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
Status run_in_parts(Mesh_slices& slices, Ranks& ranks, const Chosen_parameters& chosen, const Parts_parameters& parts);

} // namespace CGAL::Hex_mesh_optimization::internal

#ifndef CGAL_HEX_MESH_OPTIMIZATION_SEPARATE_ENGINE
#include <CGAL/Hex_mesh_optimization/internal/parts/run_in_parts_impl.h>
#endif

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_H
