// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_MAKE_HEX_MESH_H
#define CGAL_MAKE_HEX_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// From a triangle surface to a hexahedral mesh of the volume that it bounds.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/named_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Joined_status.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Hex_mesh_optimization {
namespace internal {

template <class NamedParameters>
Meshing_parameters meshing_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Meshing_parameters p;
  p.spacing = choose_parameter(get_parameter(np, internal_np::grid_spacing), p.spacing);
  p.number_of_hexahedra = choose_parameter(get_parameter(np, internal_np::hex_number_of_hexahedra),
                                           p.number_of_hexahedra);
  p.minimum_cells_across = choose_parameter(get_parameter(np, internal_np::hex_minimum_cells_across),
                                            p.minimum_cells_across);
  p.features.angle_bound = choose_parameter(get_parameter(np, internal_np::features_angle_bound),
                                            p.features.angle_bound);
  require(p.spacing >= 0 && std::isfinite(p.spacing), "grid_spacing");
  require(p.number_of_hexahedra > 0, "number_of_hexahedra");
  require(p.minimum_cells_across > 0, "minimum_cells_across");
  return p;
}

// Of the faces of the surface, if they are given.
template <class NamedParameters, class FaceRange>
std::vector<int> labels_of_faces([[maybe_unused]] const NamedParameters& np, [[maybe_unused]] const FaceRange& faces)
{
  std::vector<int> result;
  if constexpr (is_given<NamedParameters, internal_np::hex_face_label_map_t>) {
    const auto map = parameters::get_parameter(np, internal_np::hex_face_label_map);
    for (const auto& f : faces)
      result.push_back(static_cast<int>(get(map, f)));
  }
  return result;
}

template <class PointRange, class HexahedronRange>
struct Optimized_body
{
  PointRange points;
  HexahedronRange hexahedra;
  Status status;

  bool is_good() const { return status.valid_mesh() && status.after.minimum >= good_minimum; }
  bool is_worse_than(const Optimized_body& other) const
  {
    return status.valid_mesh() != other.status.valid_mesh() ? other.status.valid_mesh()
                                                            : status.after.minimum < other.status.after.minimum;
  }

  static constexpr double good_minimum = .5;
};

template <class ConcurrencyTag, class PointRange, class HexahedronRange, class NamedParameters>
Optimized_body<PointRange, HexahedronRange> optimized(const Meshed_body& body, double seconds,
                                                      const NamedParameters& np)
{
  Optimized_body<PointRange, HexahedronRange> result;
  assign_index_ranges(body.points, body.hexahedra, result.points, result.hexahedra);
  const auto of_body = np.maximum_running_time((std::max)(0., seconds));
  if (body.labels.empty())
    result.status = optimize_ranges<ConcurrencyTag>(result.points, result.hexahedra, &body.surface, of_body);
  else
    result.status = optimize_ranges<ConcurrencyTag>(result.points, result.hexahedra, &body.surface,
                                                    of_body.hexahedron_label_map(make_property_map(body.labels)));
  return result;
}

// With other numbers of cells the same surface has other irregular places: where the result is poor, a few more may do. A
// spacing that was given stays.
template <class ConcurrencyTag, class PointRange, class HexahedronRange, class NamedParameters>
Optimized_body<PointRange, HexahedronRange> best_of_several(Meshed_body& body, double seconds,
                                                            const NamedParameters& np)
{
  auto best = optimized<ConcurrencyTag, PointRange, HexahedronRange>(body, seconds, np);
  const Meshed_body first = body;
  double spent = best.status.total_seconds;
  for (double factor : {1.1, 1.2}) {
    if (best.is_good() || body.parameters.spacing > 0 || spent >= seconds ||
        best.status.return_code == Return_code::STOPPED_BY_VISITOR)
      break;
    std::optional<Meshed_body> other = mesh_again(first, factor);
    if (!other)
      continue;
    auto result = optimized<ConcurrencyTag, PointRange, HexahedronRange>(*other, seconds - spent, np);
    spent += result.status.total_seconds;
    if (best.is_worse_than(result)) {
      best = std::move(result);
      body = std::move(*other);
    }
  }
  best.status.total_seconds = spent;
  return best;
}

// Sets what the mesh has of each part, and its number of bodies.
inline void describe_parts(const std::vector<Hexahedron>& hexahedra, Meshing_status& status)
{
  for (Material_report& part : status.materials) {
    for (const auto& region : status.regions)
      if (region.label == part.label)
        part.volume_after = region.after;
    part.number_of_hexahedra = std::size_t(std::count(status.labels.begin(), status.labels.end(), part.label));
  }
  status.number_of_bodies = number_of_pieces(hexahedra);
}

// Bodies are optimized one after the other, each with its own surface for a reference: what is near is not mistaken for it.
template <class ConcurrencyTag, class PointRange, class HexahedronRange, class NamedParameters>
Meshing_status make_mesh(const Reference_input& surface, const std::vector<int>& parts,
                         const Meshing_parameters& meshing, PointRange& points, HexahedronRange& hexahedra,
                         const NamedParameters& np)
{
  const double seconds = parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_running_time),
                                                      Chosen_parameters().maximum_running_time);
  Meshed_solid solid = mesh_solid(surface, meshing, parts);
  Meshing_status status;
  status.surface = solid.report;
  status.number_of_bodies = solid.bodies.size();
  status.number_of_hexahedra_wanted = meshing.spacing > 0 ? 0 : meshing.number_of_hexahedra;
  Joined_status joined(solid.diagonal);
  for (Meshed_body& body : solid.bodies) {
    auto best = best_of_several<ConcurrencyTag, PointRange, HexahedronRange>(body,
                                                                             seconds - joined.status.total_seconds, np);
    joined.add(std::move(best.status), std::move(body.status), engine_positions(best.points),
               engine_hexahedra(best.hexahedra), body.area);
    status.euler_characteristic += body.euler_characteristic;
    status.labels.insert(status.labels.end(), body.labels.begin(), body.labels.end());
    status.materials.insert(status.materials.end(), body.materials.begin(), body.materials.end());
  }
  joined.finish();
  static_cast<Status&>(status) = std::move(joined.status);
  static_cast<Voxel_status&>(status) = std::move(joined.of_grids);
  if (!parts.empty()) {
    std::sort(status.materials.begin(), status.materials.end(),
              [](const Material_report& a, const Material_report& b) { return a.label < b.label; });
    describe_parts(joined.hexahedra, status);
  }
  assign_index_ranges(joined.points, joined.hexahedra, points, hexahedra);
  return status;
}

// They tell the overloads apart.
template <class PointRange, class HexahedronRange>
using Enable_for_new_ranges =
  std::enable_if_t<!Is_linear_cell_complex<PointRange>::value && !Is_linear_cell_complex<HexahedronRange>::value &&
                     !Is_named_parameters<HexahedronRange>::value,
                   int>;

} // namespace internal
} // namespace Hex_mesh_optimization

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * makes a hexahedral mesh of the volume that a triangle surface bounds: the cells inside it of a grid that lies along its
 * flat parts, layers of hexahedra behind the patches of its boundary, and `CGAL::optimize_hex_mesh()` with the surface as
 * reference.
 *
 * Faces of the boundary are told to which patch between the feature curves of the surface they belong. A layer is inserted
 * behind patches whose faces need it; at a sharp convex edge the layers of both patches cross, so that one hexahedron
 * has faces on both of them, at others a layer goes on around the edge.
 *
 * \tparam ConcurrencyTag as of `CGAL::optimize_hex_mesh()`
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam PointRange a model of `BackInsertionSequence` and `RandomAccessContainer` with `reserve()` whose value type is a
 *         model of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a model of `BackInsertionSequence` and `RandomAccessContainer` with `reserve()` whose value type
 *         is a random access container of indices of an integral type, either an array of size 8 or resizable
 * \tparam NamedParameters a sequence of named parameters
 *
 * \param tmesh the surface, see `Hex_mesh_optimization::check_surface()`
 * \param points the vertices, replaced
 * \param hexahedra the indices of the eight vertices of each hexahedron, replaced
 * \param np optional named parameters among those listed below, and both lists of `CGAL::optimize_hex_mesh()` with `tmesh`
 *        as the reference, but for those that need a mesh that exists: `vertex_is_constrained_map()`,
 *        `facet_is_constrained_map()`, `hexahedron_label_map()`, `internal_faces()`, `interface_references()`, `periodic_vertices()` and
 *        `target_edge_length_map()` are refused when the call is compiled
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_hexahedra}
 *     \cgalParamDescription{how many hexahedra the mesh has, within about a tenth. It has more where thin parts need them:
 *                           up to eight times as many if more than a hundredth of the surface would have less than
 *                           `minimum_cells_across` cells behind it}
 *     \cgalParamType{`std::size_t`, larger than 0}
 *     \cgalParamDefault{8000}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{grid_spacing}
 *     \cgalParamDescription{the length of the cells of the grid, in the place of `number_of_hexahedra`: it is not changed
 *                           for thin parts. Between flat parts it is what divides their distance evenly}
 *     \cgalParamType{`double`, a length in the unit of the points, larger than 0 and finite}
 *     \cgalParamDefault{what makes the number of hexahedra}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{minimum_cells_across}
 *     \cgalParamDescription{the number of cells that are wanted between opposite walls, not counting layers; see
 *                           `Voxel_status::thin_faces`}
 *     \cgalParamType{`std::size_t`, larger than 0}
 *     \cgalParamDefault{1}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{the feature edges of `tmesh`, for the layers and for the optimization}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key
 *     and `bool` as value}
 *     \cgalParamDefault{edges are detected, see `features_angle_bound`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_label_map}
 *     \cgalParamDescription{the part of `tmesh` that each face belongs to. The faces of one label bound a part of the volume
 *                           that stays apart from the others: it gets hexahedra with its label, see
 *                           `Meshing_status::labels`, and interfaces to those that touch it. Parts may overlap: what is
 *                           in several is of that with the highest label}
 *     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key and
 *                    `int` as value}
 *     \cgalParamDefault{all parts are united}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return what the optimization reports, and where parts are thinner than the grid resolves
 *
 * \throws Hex_mesh_optimization::Input_error if the surface does not bound a volume, or if a parameter has no usable value.
 *         `points` and `hexahedra` are unchanged then.
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh, class PointRange, class HexahedronRange,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_new_ranges<PointRange, HexahedronRange> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters> = 0
#endif
          >
Hex_mesh_optimization::Meshing_status make_hex_mesh(const TriangleMesh& tmesh, PointRange& points,
                                                    HexahedronRange& hexahedra,
                                                    const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Meshing_status status;
  if constexpr (accepts_surface<TriangleMesh, NamedParameters>() &&
                accepts_labels_of_faces<NamedParameters, Face_of<TriangleMesh>>() &&
                accepts_new_mesh<PointRange, HexahedronRange>() && accepts_parameters_of_new_mesh<NamedParameters>()) {
    status = make_mesh<ConcurrencyTag>(triangle_mesh_to_reference(tmesh, np), labels_of_faces(np, faces(tmesh)),
                                       meshing_parameters(np), points, hexahedra, np);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * makes a mesh as above of the volume that a triangle soup bounds. Triangles that are neighbors have indices in common and are
 * oriented alike.
 *
 * \tparam SurfacePointRange a range of models of `HexMeshOptimizationPoint_3`
 * \tparam TriangleRange a range of ranges of three integers
 *
 * \param surface_points the points of the soup
 * \param surface_triangles the indices of the three vertices of each triangle
 * \param points the vertices, replaced
 * \param hexahedra the indices of the eight vertices of each hexahedron, replaced
 * \param np optional named parameters as above; the key of `edge_is_constrained_map()` is a
 *        `std::pair<std::size_t, std::size_t>`, an edge by the lower and the higher of its indices, that of
 *        `face_label_map()` the index of a triangle, a `std::size_t`
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class SurfacePointRange, class TriangleRange, class PointRange,
          class HexahedronRange, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_new_ranges<PointRange, HexahedronRange> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters> = 0
#endif
          >
Hex_mesh_optimization::Meshing_status
make_hex_mesh(const SurfacePointRange& surface_points, const TriangleRange& surface_triangles, PointRange& points,
              HexahedronRange& hexahedra, const NamedParameters& np = parameters::default_values())
{
  using namespace Hex_mesh_optimization::internal;
  Hex_mesh_optimization::Meshing_status status;
  if constexpr (accepts_soup<SurfacePointRange, TriangleRange>() && accepts_edges_of_soup<NamedParameters>() &&
                accepts_labels_of_faces<NamedParameters, std::size_t>() &&
                accepts_new_mesh<PointRange, HexahedronRange>() && accepts_parameters_of_new_mesh<NamedParameters>()) {
    std::vector<std::size_t> indices(
      std::size_t(std::distance(std::begin(surface_triangles), std::end(surface_triangles))));
    std::iota(indices.begin(), indices.end(), std::size_t(0));
    status = make_mesh<ConcurrencyTag>(any_triangles_to_reference(surface_points, surface_triangles, np),
                                       labels_of_faces(np, indices), meshing_parameters(np), points, hexahedra, np);
  }
  return status;
}

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * makes the same mesh as a linear cell complex.
 *
 * \param tmesh the surface, see `Hex_mesh_optimization::check_surface()`
 * \param lcc an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *        `Linear_cell_complex_for_generalized_map<3,3,...>`, cleared first; unchanged if the function throws
 * \param np optional named parameters among those listed above
 */
template <class ConcurrencyTag = CGAL::Sequential_tag, class TriangleMesh, class LCC,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          Hex_mesh_optimization::internal::Enable_for_linear_cell_complex<LCC> = 0,
          Hex_mesh_optimization::internal::Enable_for_parameters<NamedParameters> = 0
#endif
          >
Hex_mesh_optimization::Meshing_status make_hex_mesh(const TriangleMesh& tmesh, LCC& lcc,
                                                    const NamedParameters& np = parameters::default_values())
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  Hex_mesh_optimization::Meshing_status status = make_hex_mesh<ConcurrencyTag>(tmesh, points, hexahedra, np);
  lcc.clear();
  Hex_mesh_optimization::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);
  return status;
}

} // namespace CGAL

#endif // CGAL_MAKE_HEX_MESH_H
