// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_IMPL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_IMPL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The definition of run_engine().

#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Hex_mesh_optimizer.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine.h>

#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Status run_engine(Positions& points, const std::vector<Hexahedron>& hexahedra, const Regions& regions,
                  const Reference_input* reference, const std::vector<char>& is_frozen, const Chosen_parameters& chosen)
{
  Optimization_parameters parameters;
  static_cast<Chosen_parameters&>(parameters) = chosen;
  Status status;
  run_concurrently(parameters.is_parallel, [&] {
    Hex_mesh_optimizer optimizer(points, hexahedra, regions, reference, is_frozen, parameters);
    status = optimizer.run();
    points = optimizer.positions();
  });
  return status;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_RUN_ENGINE_IMPL_H
