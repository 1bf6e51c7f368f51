// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_IMPL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_IMPL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The definition of run_in_parts().

#include <CGAL/Hex_mesh_optimization/internal/parts/Parts_optimizer.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/run_in_parts.h>

namespace CGAL::Hex_mesh_optimization::internal {

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Status run_in_parts(Mesh_slices& slices, Ranks& ranks, const Chosen_parameters& chosen, const Parts_parameters& parts)
{
  return Parts_optimizer(slices, ranks, chosen, parts).run();
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_RUN_IN_PARTS_IMPL_H
