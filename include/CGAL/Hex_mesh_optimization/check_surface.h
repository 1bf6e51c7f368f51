// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_CHECK_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_CHECK_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Whether a triangle surface bounds a volume that can be meshed, and if not, what is wrong and where.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * throws unless a triangle surface bounds a volume: if it is closed, has no face without an area, does not intersect
 * itself, and is oriented outwards. It may have several components, also within each other.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param tmesh the surface
 * \param np `vertex_point_map`: the points of `tmesh`
 *
 * \throws Input_error saying what is wrong, how often, and where first: `Input_error::element_index()` is the number of
 *         a face or vertex of the surface.
 *
 * Complexity: that of `CGAL::Polygon_mesh_processing::self_intersections()`.
 */
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
void check_surface(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
{
  if constexpr (internal::accepts_surface<TriangleMesh, NamedParameters>())
    internal::require_volume(internal::triangle_mesh_to_reference(tmesh, np));
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_CHECK_SURFACE_H
