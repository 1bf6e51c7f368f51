// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the templates on the caller's types hand over to the engine, which has no template parameters.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/separate_compilation.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Moves the points, or throws Input_error and leaves them.
// reference: null when the boundary of the mesh is its own reference.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
Status run_engine(Positions& points, const std::vector<Hexahedron>& hexahedra, const Regions& regions,
                  const Reference_input* reference, const std::vector<char>& is_frozen,
                  const Chosen_parameters& parameters);

} // namespace CGAL::Hex_mesh_optimization::internal

#ifndef CGAL_HEX_MESH_OPTIMIZATION_SEPARATE_ENGINE
#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine_impl.h>
#endif

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_H
