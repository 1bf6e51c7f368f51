// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_VOXEL_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_VOXEL_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The cells of a regular grid that are inside a surface, as a hexahedral mesh.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * makes a hexahedral mesh of the cells of a regular grid whose centers are inside a closed triangle surface.
 *
 * The grid divides the bounding box of the surface evenly along each axis, into cells that are about as long as the
 * spacing. Cells are added and removed, as few as possible, until the boundary is a manifold: no two cells touch in an
 * edge or a vertex alone. Walls that are thinner than a cell and have no center inside keep the cells in their middle, unless
 * they are thinner than a quarter of one. Cells that a thin part leaves apart from the others are dropped; where fewer
 * cells than asked for are left across a part of the volume, the result says so.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type is a model of
 *         `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param tmesh the surface, see `Hex_mesh_optimization::check_surface()`
 * \param spacing the length of the cells
 * \param points the vertices, replaced
 * \param hexahedra the indices of the eight vertices of each hexahedron, replaced
 * \param np optional named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of `tmesh`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
 *     key}
 *     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{minimum_cells_across}
 *     \cgalParamDescription{the number of cells that are wanted between opposite walls; see `Voxel_status::thin_faces`}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{1}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Hex_mesh_optimization::Input_error if the surface does not bound a volume, if the spacing is not positive, or so
 *         large that no cell is inside, or so small that there would be more than \f$ 2^{31} \f$ cells. `points` and
 *         `hexahedra` are unchanged then.
 *
 * Complexity: linear in the number of cells of the grid and of rows of cells that faces cross, and that of
 * `Hex_mesh_optimization::check_surface()`.
 */
template <class TriangleMesh, class PointRange, class HexahedronRange,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!Hex_mesh_optimization::internal::Is_linear_cell_complex<PointRange>::value, int> = 0
#endif
          >
Hex_mesh_optimization::Voxel_status voxel_mesh(const TriangleMesh& tmesh, double spacing, PointRange& points,
                                               HexahedronRange& hexahedra,
                                               const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Voxel_status status;
  if constexpr (accepts_surface<TriangleMesh, NamedParameters>() && accepts_new_mesh<PointRange, HexahedronRange>()) {
    const std::size_t minimum_cells_across = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::hex_minimum_cells_across), Meshing_parameters().minimum_cells_across);
    require(spacing > 0 && std::isfinite(spacing), "spacing");
    Meshed_surface mesh = voxelize_surface(triangle_mesh_to_reference(tmesh, np), spacing, minimum_cells_across);
    assign_index_ranges(mesh.points, mesh.hexahedra, points, hexahedra);
    status = std::move(mesh.status);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * makes the same mesh as a linear cell complex.
 *
 * \param tmesh the surface, see `Hex_mesh_optimization::check_surface()`
 * \param spacing the length of the cells
 * \param lcc an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *        `Linear_cell_complex_for_generalized_map<3,3,...>`, cleared first; unchanged if the function throws
 * \param np optional named parameters among those listed above
 */
template <class TriangleMesh, class LCC, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<Hex_mesh_optimization::internal::Is_linear_cell_complex<LCC>::value, int> = 0
#endif
          >
Hex_mesh_optimization::Voxel_status voxel_mesh(const TriangleMesh& tmesh, double spacing, LCC& lcc,
                                               const NamedParameters& np = parameters::default_values())
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  Hex_mesh_optimization::Voxel_status status = voxel_mesh(tmesh, spacing, points, hexahedra, np);
  lcc.clear();
  Hex_mesh_optimization::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);
  return status;
}

} // namespace CGAL

#endif // CGAL_HEX_MESH_OPTIMIZATION_VOXEL_MESH_H
