// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PAD_HEX_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_PAD_HEX_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A layer of hexahedra behind the boundary of a hexahedral mesh, and on both sides of the interfaces between labels.

#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Layer_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Hex_mesh_optimization {
namespace internal {

// labels: of the hexahedra, or empty
template <class PointRange, class HexahedronRange, class NamedParameters>
std::vector<std::size_t> pad(PointRange& points, HexahedronRange& hexahedra, const std::vector<int>& labels,
                             const NamedParameters& np)
{
  const double thickness = parameters::choose_parameter(parameters::get_parameter(np, internal_np::hex_layer_thickness),
                                                        Layer_parameters().thickness);
  require(thickness > 0 && thickness < 1, "layer_thickness");
  Padded_mesh mesh = pad_mesh(engine_positions(points), engine_hexahedra(hexahedra), labels, thickness);
  assign_index_ranges(mesh.points, mesh.hexahedra, points, hexahedra);
  return std::move(mesh.source);
}

} // namespace internal
} // namespace Hex_mesh_optimization

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * inserts a layer of hexahedra behind the boundary of a mesh: each face of the boundary gets a hexahedron of its own, so
 * that no hexahedron needs to be flat to lie on a smooth surface with two faces. With labels, it inserts one on each side
 * of the faces between different labels as well.
 *
 * This changes the connectivity, which `CGAL::optimize_hex_mesh()` never does. The vertices keep their places and their
 * numbers, and those of the boundary stay on it; copies of them, behind, are appended. The hexahedra keep their
 * numbers, those of the layer are appended, one for each face in the order of the hexahedra that had them. Where faces meet
 * in a concave or convex edge the layer goes on around it. Where parts touch in an edge or a vertex each has a layer of its
 * own. Where the boundary touches itself in a vertex around which the hexahedra hang together, as where two opposite ones of
 * eight are missing, no place is behind all of its faces: hexahedra of the layer are inverted there, and stay so.
 *
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type is a model of
 *         `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param points the vertices
 * \param hexahedra the indices of the eight vertices of each hexahedron
 * \param np optional named parameters among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{layer_thickness}
 *     \cgalParamDescription{the thickness of the layer, in lengths of the edges of the faces that it is behind}
 *     \cgalParamType{`double`, between 0 and 1}
 *     \cgalParamDefault{.4}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{hexahedron_label_map}
 *     \cgalParamDescription{the labels of the hexahedra}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the number of a hexahedron, `std::size_t`, as key (with the
 *     first dart of a hexahedron for a linear cell complex) and an integer as value}
 *     \cgalParamDefault{all are the same}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return for each hexahedron of the layer the one that had its face, of which it takes the label
 *
 * \throws Hex_mesh_optimization::Input_error if a hexahedron does not have eight different vertices, if an index is out of
 *         range, if three hexahedra share a face or two do with the same orientation, or if the thickness is not usable.
 *         `points` and `hexahedra` are unchanged then.
 *
 * Complexity: \f$ O(n \log n) \f$ in the number of hexahedra.
 */
template <class PointRange, class HexahedronRange, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!Hex_mesh_optimization::internal::Is_linear_cell_complex<PointRange>::value, int> = 0
#endif
          >
std::vector<std::size_t> pad_hex_mesh(PointRange& points, HexahedronRange& hexahedra,
                                      const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  std::vector<std::size_t> source;
  if constexpr (accepts_cells_of_points<PointRange, HexahedronRange>() &&
                accepts_new_mesh<PointRange, HexahedronRange>() && accepts_labels<NamedParameters, std::size_t>()) {
    std::vector<std::size_t> indices(hexahedra.size());
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    source = pad(points, hexahedra, regions(np, indices).labels, np);
  }
  return source;
}

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * does the same to a linear cell complex. It is built anew: attributes other than the points are lost. Hexahedra are
 * numbered as `Hex_mesh_optimization::linear_cell_complex_to_hexahedra()` does.
 *
 * \param lcc an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *        `Linear_cell_complex_for_generalized_map<3,3,...>`
 * \param np optional named parameters among those listed above
 */
template <class LCC, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<Hex_mesh_optimization::internal::Is_linear_cell_complex<LCC>::value, int> = 0
#endif
          >
std::vector<std::size_t> pad_hex_mesh(LCC& lcc, const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  Hex_mesh_optimization::linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  std::vector<typename Linear_cell_complex_types<LCC>::Dart> darts;
  if constexpr (is_given<NamedParameters, internal_np::hexahedron_label_map_t>) {
    const Hexahedra_of_linear_cell_complex<LCC> volumes(lcc);
    for (std::size_t h = 0; h < volumes.size(); ++h)
      darts.push_back(volumes.corners(h)[0]);
  }
  std::vector<std::size_t> source = pad(points, hexahedra, regions(np, darts).labels, np);
  lcc.clear();
  Hex_mesh_optimization::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);
  return source;
}

} // namespace CGAL

#endif // CGAL_HEX_MESH_OPTIMIZATION_PAD_HEX_MESH_H
