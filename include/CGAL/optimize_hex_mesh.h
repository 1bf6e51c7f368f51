// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_OPTIMIZE_HEX_MESH_H
#define CGAL_OPTIMIZE_HEX_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The function of the package: moves the vertices of a hexahedral mesh until it
// is valid and as good as its connectivity allows.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/projector_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Hex_mesh_optimization {
namespace internal {

// They tell the overloads apart: a linear cell complex or ranges, followed by named parameters or something else.
template <class LCC, class... Others>
using Enable_for_linear_cell_complex =
  std::enable_if_t<Is_linear_cell_complex<LCC>::value && !(Is_named_parameters<Others>::value || ...), int>;
template <class PointRange, class... Others>
using Enable_for_ranges =
  std::enable_if_t<!Is_linear_cell_complex<PointRange>::value && !(Is_named_parameters<Others>::value || ...), int>;
template <class... Lists>
using Enable_for_parameters = std::enable_if_t<(Is_named_parameters<Lists>::value && ...), int>;

template <class LCC, class NamedParameters>
constexpr bool accepts_parameters_of_linear_cell_complex()
{
  using Types = Linear_cell_complex_types<LCC>;
  return accepts_parameters_of_mesh<NamedParameters, typename Types::Vertex, typename Types::Dart>();
}

// void if it is no range.
template <class Range, class = void>
struct Point_of_range
{
  using type = void;
};
template <class Range>
struct Point_of_range<Range, std::enable_if_t<Is_range<const Range>::value>>
{
  using type = std::remove_cv_t<Value_of<const Range>>;
};
template <class Range>
using Point_of = typename Point_of_range<Range>::type;

template <class Point, class Reference, class NamedParameters>
constexpr bool accepts_reference()
{
  if constexpr (Is_projector<Reference, Point>::value)
    return true;
  else
    return accepts_surface<Reference, NamedParameters>();
}

// Of a mesh in index form, with the lists of the mesh and of the reference.
template <class PointRange, class HexahedronRange, class Reference, class NamedParameters1, class NamedParameters2>
Reference_input reference_of(const PointRange& points, const HexahedronRange& hexahedra, const Reference& reference,
                             const NamedParameters1& np1, const NamedParameters2& np2)
{
  using Point = Point_of<PointRange>;
  if constexpr (Is_projector<Reference, Point>::value) {
    const double angle_bound = parameters::choose_parameter(
      parameters::get_parameter(np1, internal_np::features_angle_bound), Chosen_parameters().features.angle_bound);
    return projector_to_reference<Point>(reference, engine_positions(points), engine_hexahedra(hexahedra), angle_bound);
  }
  else
    return triangle_mesh_to_reference(reference, np2);
}

template <class LCC, class Reference, class NamedParameters1, class NamedParameters2>
Reference_input reference_of_linear_cell_complex(const LCC& lcc, const Reference& reference,
                                                 const NamedParameters1& np1, const NamedParameters2& np2)
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  if constexpr (Is_projector<Reference, typename LCC::Point>::value)
    linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  return reference_of(points, hexahedra, reference, np1, np2);
}

// point(v) is the place of the v-th point. Assigns only what moved, and nothing unless all went well.
template <class ConcurrencyTag, class Points, class Hexahedra, class Key, class NamedParameters, class PointOf>
Status optimize(const Points& points, const Hexahedra& hexahedra, const std::vector<Key>& keys, Regions regions,
                const Reference_input* reference, const NamedParameters& np, PointOf point)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel,
                "CGAL::Parallel_tag needs TBB: link with CGAL::TBB_support, or use CGAL::Parallel_if_available_tag");
#endif
  const Positions before = engine_positions(points);
  Positions after = before;
  Chosen_parameters parameters = chosen_parameters(np, keys);
  parameters.is_parallel = is_parallel;
  const std::vector<Hexahedron> corners = engine_hexahedra(hexahedra);
  add_constrained_facets(np, corners, regions);
  Status status = run_engine(after, corners, regions, reference, constrained_vertices(np, keys), parameters);
  // points may allocate memory: all of them are made before the first is assigned
  using Point = typename std::iterator_traits<decltype(std::begin(points))>::value_type;
  std::vector<std::pair<std::size_t, Point>> moved;
  for (std::size_t v = 0; v < after.size(); ++v)
    if (before[v] != after[v])
      moved.emplace_back(v, Point(after[v][0], after[v][1], after[v][2]));
  for (auto& [v, p] : moved)
    point(v) = std::move(p);
  return status;
}

template <class ConcurrencyTag, class PointRange, class HexahedronRange, class NamedParameters>
Status optimize_ranges(PointRange& points, const HexahedronRange& hexahedra, const Reference_input* reference,
                       const NamedParameters& np)
{
  std::vector<std::size_t> keys(points.size());
  std::iota(keys.begin(), keys.end(), std::size_t(0));
  std::vector<std::size_t> indices(hexahedra.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  return optimize<ConcurrencyTag>(
    points, hexahedra, keys, regions(np, indices), reference,
    np, [&](std::size_t v) -> auto& { return *(std::begin(points) + v); });
}

template <class ConcurrencyTag, class LCC, class NamedParameters>
Status optimize_linear_cell_complex(LCC& lcc, const Reference_input* reference, const NamedParameters& np)
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::vector<typename Linear_cell_complex_types<LCC>::Vertex> vertices;
  linear_cell_complex_to_hexahedra(lcc, points, hexahedra, vertices);
  std::vector<typename Linear_cell_complex_types<LCC>::Dart> darts;
  if constexpr (is_given<NamedParameters, internal_np::hexahedron_label_map_t>) {
    const Hexahedra_of_linear_cell_complex<LCC> volumes(lcc);
    for (std::size_t h = 0; h < volumes.size(); ++h)
      darts.push_back(volumes.corners(h)[0]);
  }
  return optimize<ConcurrencyTag>(
    points, hexahedra, vertices, regions(np, darts), reference,
    np, [&](std::size_t v) -> auto& { return lcc.point_of_vertex_attribute(vertices[v]); });
}

} // namespace internal
} // namespace Hex_mesh_optimization

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * moves the vertices of a hexahedral mesh so that no hexahedron is inverted, the worst and the average scaled Jacobian
 * become as high as the connectivity allows, and the boundary stays on a reference surface with its features. The
 * connectivity does not change. Vertices of the mesh boundary are attached to corners, feature curves and the smooth
 * part of the reference.
 *
 * What the call guarantees for every input it accepts:
 * - the number of inverted hexahedra does not rise, a valid mesh stays valid, and if its boundary is within the tolerance,
 *   that stays so and its minimum scaled Jacobian does not fall: if the optimization finds nothing better in the
 *   \ref HexMeshOptimizationOrder "order of goals", all positions stay;
 * - constrained vertices, and all boundary vertices if the boundary is fixed, keep their coordinates bit for bit;
 * - if it throws, no vertex has moved;
 * - the result does not depend on the unit of length, up to rounding.
 *
 * That the result is valid is no guarantee but is certified where it holds: `Status::valid_mesh()`.
 *
 * \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are `Sequential_tag`,
 *         `Parallel_tag`, and `Parallel_if_available_tag`. Parallel, it runs in the TBB task arena of the caller. The result is the
 *         same, bit for bit, whatever the number of threads.
 * \tparam LCC `Linear_cell_complex_for_combinatorial_map` or `Linear_cell_complex_for_generalized_map` of dimension 3
 *         and ambient dimension 3, with any items and storage
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, or of `HexMeshOptimizationProjector`
 * \tparam NamedParameters1 a sequence of named parameters
 * \tparam NamedParameters2 a sequence of named parameters
 *
 * \param lcc the mesh; all its volumes are combinatorial hexahedra. The indices of hexahedra and vertices in the result are
 *        those that `Hex_mesh_optimization::linear_cell_complex_to_hexahedra()` gives them.
 * \param reference the surface that the boundary of the mesh represents
 * \param np1 optional named parameters of the mesh and of the optimization, among those listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{features_angle_bound}
 *     \cgalParamDescription{an edge of the reference is sharp if the normals of its faces differ by more than this
 *                           angle in degrees. Short curves that do not separate two patches of the surface are
 *                           ignored.}
 *     \cgalParamType{`double`, degrees from 0 to 180}
 *     \cgalParamDefault{45}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{the vertices of the mesh that must not move}
 *     \cgalParamType{a model of `ReadablePropertyMap` with the descriptor of a vertex attribute of `LCC` as key
 *                    (`std::size_t` for index ranges) and `bool` as value}
 *     \cgalParamDefault{no vertex is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{hexahedron_label_map}
 *     \cgalParamDescription{the label of each hexahedron, such as its material. Faces between hexahedra of different
 *                           labels are kept as the boundary is, the curves and corners where they meet each other
 *                           or the boundary included; vertices slide within them. See
 *                           \ref HexMeshOptimizationRegions.}
 *     \cgalParamType{a model of `ReadablePropertyMap` with a dart of the hexahedron as key
 *                    (`LCC::Dart_const_descriptor` or, before CGAL 5.6, `LCC::Dart_const_handle`; the index of the
 *                    hexahedron as `std::size_t` for index ranges) and a value that can be converted to `int`}
 *     \cgalParamDefault{all hexahedra have the same label}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{facet_is_constrained_map}
 *     \cgalParamDescription{faces between hexahedra of one label that are kept in the same way, such as baffles: it is
 *                           asked for the faces of all hexahedra; those of the boundary are kept anyway}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `std::array<std::size_t, 4>`, the indices of the vertices of a
 *                    face in increasing order, as key (for a linear cell complex, those of
 *                    `linear_cell_complex_to_hexahedra()`) and `bool` as value}
 *     \cgalParamDefault{no face is constrained}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{internal_faces}
 *     \cgalParamDescription{the same faces as a list; what is not between two hexahedra does not matter}
 *     \cgalParamType{a range of ranges of four integers, the indices of the vertices of a face in any order; for a
 *                    linear cell complex, in the order of `linear_cell_complex_to_hexahedra()`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{interface_references}
 *     \cgalParamDescription{surfaces that interfaces between two labels are brought to, in the place of the interfaces as
 *                           they came in. Where such a surface ends within the mesh it is taken to go on in its plane;
 *                           it may reach out of the mesh, and be oriented either way. It has no feature curves: vertices
 *                           slide on all of it. See \ref HexMeshOptimizationRegions.}
 *     \cgalParamType{a range of pairs, such as a `std::map`, of two labels (`std::pair<int, int>` or
 *                    `std::array<int, 2>`, in any order) and a surface: a model of `FaceListGraph` and
 *                    `HalfedgeListGraph` with an internal property map of points, or a `std::pair` of points and
 *                    triples of indices}
 *     \cgalParamDefault{none: interfaces are kept where they are}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{periodic_vertices}
 *     \cgalParamDescription{pairs of vertices that move together, such as those on opposite sides of a periodic cell: the
 *                           second is where the translation takes the first, exactly unless both stay. A vertex may be
 *                           in several pairs. If one of those that move together is constrained, all are. A pair that is
 *                           not that far apart when it comes in, up to a millionth of the mean edge of the boundary, is
 *                           refused.}
 *     \cgalParamType{a range of `std::tuple` of the indices of two vertices (for a linear cell complex, in the order of
 *                    `linear_cell_complex_to_hexahedra()`) and a translation with `x()`, `y()` and `z()`, which
 *                    `CGAL::to_double()` converts}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{fixed_boundary}
 *     \cgalParamDescription{whether no vertex of the outer boundary may move; those within interfaces may}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{boundary_placement}
 *     \cgalParamDescription{where the vertices of the boundary have to be: within the tolerance, corners on the corners of the
 *                           reference; or all of them on the corner, curve or face that they are attached to, exactly, sliding
 *                           along the surface and its feature curves}
 *     \cgalParamType{`Hex_mesh_optimization::Boundary_placement`}
 *     \cgalParamDefault{`Hex_mesh_optimization::Boundary_placement::WITHIN_TOLERANCE`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{optimization_method}
 *     \cgalParamDescription{which stages are run}
 *     \cgalParamType{`Hex_mesh_optimization::Method`}
 *     \cgalParamDefault{`Hex_mesh_optimization::Method::FULL`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_quality}
 *     \cgalParamDescription{the optimization ends as soon as the mesh is valid, its boundary within the tolerance or bound,
 *                           and its minimum scaled Jacobian at least this}
 *     \cgalParamType{`double`, a scaled Jacobian, which has no unit and is at most 1; not NaN}
 *     \cgalParamDefault{none: it goes on while the mesh improves}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_deviation}
 *     \cgalParamDescription{how far the boundary of the mesh and the reference may be from each other, in both directions. The
 *                           bound comes before the quality, but after validity. Whether the result obeys it is certified:
 *                           `Status::is_within_deviation_bound()`; where it does not, the return code is
 *                           `Return_code::DEVIATION_BOUND_NOT_MET`.}
 *     \cgalParamType{`double`, a length in the unit of the points, larger than 0}
 *     \cgalParamDefault{none: a given reference has a tolerance of .3 of the local edge, interfaces a twelfth; the boundary
 *                       of the mesh itself may be left for quality, at a price that grows steeply from about a sixth of
 *                       an edge on}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_edge_lengths}
 *     \cgalParamDescription{where the target lengths of the edges come from}
 *     \cgalParamType{`Hex_mesh_optimization::Target_edge_lengths`}
 *     \cgalParamDefault{`Hex_mesh_optimization::Target_edge_lengths::ESTIMATED`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{target_edge_length_map}
 *     \cgalParamDescription{the target length of every edge, in place of `target_edge_lengths`: lengths in the unit of the points,
 *                           larger than 0 and finite}
 *     \cgalParamType{a model of `ReadablePropertyMap` with a `std::pair` of two keys of `vertex_is_constrained_map` as
 *                    key, in any order, and a number as value}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_length_update}
 *     \cgalParamDescription{what becomes of the target lengths when the iterations have settled}
 *     \cgalParamType{`Hex_mesh_optimization::Edge_length_update`}
 *     \cgalParamDefault{`Hex_mesh_optimization::Edge_length_update::FULL`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{how many iterations, of a local and a global step each, rectification has at most before the target
 *                           lengths are updated; those of untangling and maximization are not counted, nor limited by it}
 *     \cgalParamType{`std::size_t`, 0 or more}
 *     \cgalParamDefault{20}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_restarts}
 *     \cgalParamDescription{how often rectification starts again with updated target lengths, after its first start}
 *     \cgalParamType{`std::size_t`, 0 or more}
 *     \cgalParamDefault{2}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{surface_weight}
 *     \cgalParamDescription{\f$ \beta \f$ of the paper, eq. 21: the weight that holds vertices on the smooth surface, in
 *                           a mesh whose boundary edges have mean length 1; adapted at each vertex}
 *     \cgalParamType{`double`, larger than 0 and finite, without a unit}
 *     \cgalParamDefault{100}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{feature_weight}
 *     \cgalParamDescription{\f$ \alpha \f$ of the paper, eq. 21: the same for feature curves and corners}
 *     \cgalParamType{`double`, larger than 0 and finite, without a unit}
 *     \cgalParamDefault{200}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{regularization_weight}
 *     \cgalParamDescription{factor of the regularization, eq. 19 of the paper}
 *     \cgalParamType{`double`, 0 or more and finite, without a unit}
 *     \cgalParamDefault{1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{cone_angle_bound}
 *     \cgalParamDescription{the largest angle in degrees between the axis of a cone and its base normals that the local
 *                           step accepts, \f$ \arccos \varepsilon \f$ in eq. 10 of the paper}
 *     \cgalParamType{`double`, degrees larger than 0 and less than 90}
 *     \cgalParamDefault{85}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximize_minimum_quality}
 *     \cgalParamDescription{whether rectification raises the worst cones once all are valid, Section 3.6 of the paper}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_running_time}
 *     \cgalParamDescription{wall-clock time from the call on, after which no iteration starts and the best state so far is returned}
 *     \cgalParamType{`double`, seconds, 0 or more}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{sees every iteration and can end the optimization, see
 *                           `Hex_mesh_optimization::Default_visitor`; pass `std::ref(visitor)` to keep what it collects}
 *     \cgalParamType{a model of `HexMeshOptimizationVisitor`}
 *     \cgalParamDefault{`Hex_mesh_optimization::Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{verbose}
 *     \cgalParamDescription{whether a line per iteration goes to `std::cerr`}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \param np2 optional named parameters of the reference, among those listed below. They are refused in `np1`, and those of
 *        the mesh in `np2`, when the call is compiled.
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of `reference`}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as
 *     key}
 *     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, reference)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{the feature edges of `reference`; takes the place of their detection by angle}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key
 *     and `bool` as value}
 *     \cgalParamDefault{edges are detected, see `features_angle_bound`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return why the optimization stopped, the quality before and after, the deviation from the reference, the volume of
 *         each label and the deviation of each interface, the hexahedra that are not valid, and those whose quality the
 *         connectivity limits
 *
 * \throws Hex_mesh_optimization::Input_error if the mesh is empty, has a cell that is no hexahedron, a hexahedron with
 *         a repeated vertex, a face of three hexahedra, a coordinate that is not finite, or no boundary or orientation; if
 *         the reference is
 *         empty, not triangulated, has a coordinate that is not finite, or has a size or a place that cannot belong to
 *         the mesh; or if a parameter has no usable value
 *
 * Source: Marco Livesu, Alla Sheffer, Nicholas Vining, Marco Tarini, <em>Practical Hex-Mesh Optimization via Edge-Cone
 * Rectification</em>, ACM Transactions on Graphics 34(4), 2015.
 *
 * Each iteration solves sparse linear systems by conjugate gradients and queries AABB trees: its time grows slightly
 * faster than linearly in the number of hexahedra, its memory linearly.
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class LCC, class TriangleMesh,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_linear_cell_complex<LCC, TriangleMesh> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters1, NamedParameters2> = 0
#endif
          >
Hex_mesh_optimization::Status optimize_hex_mesh(LCC& lcc, const TriangleMesh& reference,
                                                const NamedParameters1& np1 = parameters::default_values(),
                                                const NamedParameters2& np2 = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_linear_cell_complex<LCC>() &&
                accepts_parameters_of_linear_cell_complex<LCC, NamedParameters1>() &&
                accepts_parameters_of_reference<NamedParameters2>() &&
                accepts_reference<typename LCC::Point, TriangleMesh, NamedParameters2>()) {
    const Reference_input surface = reference_of_linear_cell_complex(lcc, reference, np1, np2);
    status = optimize_linear_cell_complex<ConcurrencyTag>(lcc, &surface, np1);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes as above with a triangle soup as the reference surface. Triangles that are neighbors have indices in common and
 * are oriented alike; no edge is in more than two of them.
 *
 * \tparam ReferencePointRange a range of models of `HexMeshOptimizationPoint_3`
 * \tparam TriangleRange a range of ranges of three integers
 * \tparam NamedParameters1 a sequence of named parameters
 * \tparam NamedParameters2 a sequence of named parameters
 *
 * \param lcc the mesh
 * \param reference_points the points of the soup
 * \param reference_triangles the indices of the three vertices of each triangle
 * \param np1 optional named parameters, those of the mesh above
 * \param np2 optional named parameters of the reference: `edge_is_constrained_map()`, a model of `ReadablePropertyMap`
 *        whose key is a `std::pair<std::size_t, std::size_t>`, an edge by the lower and the higher of its indices, and whose
 *        value converts to `bool`
 *
 * \throws Hex_mesh_optimization::Input_error as above, and naming a triangle that does not have three different vertices
 *         that exist, or is not oriented as a neighbor
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class LCC, class ReferencePointRange, class TriangleRange,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_linear_cell_complex<LCC, ReferencePointRange, TriangleRange> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters1, NamedParameters2> = 0
#endif
          >
Hex_mesh_optimization::Status optimize_hex_mesh(LCC& lcc, const ReferencePointRange& reference_points,
                                                const TriangleRange& reference_triangles,
                                                const NamedParameters1& np1 = parameters::default_values(),
                                                const NamedParameters2& np2 = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_linear_cell_complex<LCC>() &&
                accepts_parameters_of_linear_cell_complex<LCC, NamedParameters1>() &&
                accepts_soup<ReferencePointRange, TriangleRange>() && accepts_parameters_of_soup<NamedParameters2>()) {
    const Reference_input surface = triangle_soup_to_reference(reference_points, reference_triangles, np2);
    status = optimize_linear_cell_complex<ConcurrencyTag>(lcc, &surface, np1);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes as above with the boundary of the mesh, as given, in the place of the reference surface. Its quadrangles
 * are split into triangles from their first corners. `features_angle_bound` applies to the quadrangles.
 *
 * \param lcc the mesh
 * \param np optional named parameters, those of the mesh above
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class LCC,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_linear_cell_complex<LCC> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters> = 0
#endif
          >
Hex_mesh_optimization::Status optimize_hex_mesh(LCC& lcc, const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_linear_cell_complex<LCC>() && accepts_parameters_of_linear_cell_complex<LCC, NamedParameters>())
    status = optimize_linear_cell_complex<ConcurrencyTag>(lcc, nullptr, np);
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes as above a mesh given by its points and, for each hexahedron, the indices of its eight vertices: the first
 * four around the bottom, counter-clockwise seen from inside, the other four above them (the numbering of VTK and
 * Medit). Points that no hexahedron uses are kept. Hexahedra that are numbered inside out, some or all, are accepted:
 * those that are connected through faces are made to agree. `hexahedra` itself is not changed;
 * `Status::reoriented_hexahedra` lists those whose first four vertices are to be exchanged with the last four.
 *
 * \tparam PointRange a model of `RandomAccessContainer` of models of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight integers
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class PointRange, class HexahedronRange, class TriangleMesh,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_ranges<PointRange, HexahedronRange, TriangleMesh> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters1, NamedParameters2> = 0
#endif
          >
Hex_mesh_optimization::Status optimize_hex_mesh(PointRange& points, const HexahedronRange& hexahedra,
                                                const TriangleMesh& reference,
                                                const NamedParameters1& np1 = parameters::default_values(),
                                                const NamedParameters2& np2 = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_mesh<PointRange, HexahedronRange>() &&
                accepts_parameters_of_mesh<NamedParameters1, std::size_t, std::size_t>() &&
                accepts_parameters_of_reference<NamedParameters2>() &&
                accepts_reference<Point_of<PointRange>, TriangleMesh, NamedParameters2>()) {
    const Reference_input surface = reference_of(points, hexahedra, reference, np1, np2);
    status = optimize_ranges<ConcurrencyTag>(points, hexahedra, &surface, np1);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes as above a mesh of points and indices with a triangle soup as the reference surface.
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class PointRange, class HexahedronRange,
          class ReferencePointRange, class TriangleRange, class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_ranges<PointRange, HexahedronRange, ReferencePointRange,
                                                             TriangleRange> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters1, NamedParameters2> = 0
#endif
          >
Hex_mesh_optimization::Status
optimize_hex_mesh(PointRange& points, const HexahedronRange& hexahedra, const ReferencePointRange& reference_points,
                  const TriangleRange& reference_triangles, const NamedParameters1& np1 = parameters::default_values(),
                  const NamedParameters2& np2 = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_mesh<PointRange, HexahedronRange>() &&
                accepts_parameters_of_mesh<NamedParameters1, std::size_t, std::size_t>() &&
                accepts_soup<ReferencePointRange, TriangleRange>() && accepts_parameters_of_soup<NamedParameters2>()) {
    const Reference_input surface = triangle_soup_to_reference(reference_points, reference_triangles, np2);
    status = optimize_ranges<ConcurrencyTag>(points, hexahedra, &surface, np1);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * optimizes as above a mesh of points and indices with its boundary, as given, in the place of the reference surface.
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class PointRange, class HexahedronRange,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_ranges<PointRange, HexahedronRange> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters> = 0
#endif
          >
Hex_mesh_optimization::Status optimize_hex_mesh(PointRange& points, const HexahedronRange& hexahedra,
                                                const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Status status;
  if constexpr (accepts_mesh<PointRange, HexahedronRange>() &&
                accepts_parameters_of_mesh<NamedParameters, std::size_t, std::size_t>())
    status = optimize_ranges<ConcurrencyTag>(points, hexahedra, nullptr, np);
  return status;
}

} // namespace CGAL

#endif // CGAL_OPTIMIZE_HEX_MESH_H
