// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_NAMED_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Named parameters of the caller's as the parameters of the engine.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/interface_references.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/requirements.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

inline void require(bool condition, const char* name)
{
  if (!condition)
    throw Input_error(Input_error::Element::PARAMETER, 0,
                      std::string("the parameter ") + name + " has no usable value");
}

// The vertices' keys, by which the maps of the caller are asked, must outlive the result.
template <class NamedParameters, class Key>
Chosen_parameters chosen_parameters(const NamedParameters& np, const std::vector<Key>& keys)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Chosen_parameters p;
  Rectification_parameters& r = p.rectification;
  p.method = choose_parameter(get_parameter(np, internal_np::hex_optimization_method), p.method);
  p.fixed_boundary = choose_parameter(get_parameter(np, internal_np::hex_fixed_boundary), p.fixed_boundary);
  p.boundary_placement = choose_parameter(get_parameter(np, internal_np::hex_boundary_placement), p.boundary_placement);
  p.target_quality = choose_parameter(get_parameter(np, internal_np::hex_target_quality), p.target_quality);
  p.maximum_deviation = choose_parameter(get_parameter(np, internal_np::hex_maximum_deviation), p.maximum_deviation);
  p.maximum_running_time = choose_parameter(get_parameter(np, internal_np::maximum_running_time),
                                            p.maximum_running_time);
  p.target_edge_lengths = choose_parameter(get_parameter(np, internal_np::hex_target_edge_lengths),
                                           p.target_edge_lengths);
  p.features.angle_bound = choose_parameter(get_parameter(np, internal_np::features_angle_bound),
                                            p.features.angle_bound);
  r.iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations), r.iterations);
  r.restarts = choose_parameter(get_parameter(np, internal_np::hex_number_of_restarts), r.restarts);
  r.length_update = choose_parameter(get_parameter(np, internal_np::hex_length_update), r.length_update);
  r.surface_weight = choose_parameter(get_parameter(np, internal_np::hex_surface_weight), r.surface_weight);
  r.feature_weight = choose_parameter(get_parameter(np, internal_np::hex_feature_weight), r.feature_weight);
  r.regularization_weight = choose_parameter(get_parameter(np, internal_np::hex_regularization_weight),
                                             r.regularization_weight);
  r.cone_angle_bound = choose_parameter(get_parameter(np, internal_np::hex_cone_angle_bound), r.cone_angle_bound);
  r.maximize_minimum_quality = choose_parameter(get_parameter(np, internal_np::hex_maximize_minimum_quality),
                                                r.maximize_minimum_quality);
  require(p.target_quality == p.target_quality, "target_quality");
  require(p.maximum_deviation > 0, "maximum_deviation");
  require(p.maximum_running_time >= 0, "maximum_running_time");
  require(p.features.angle_bound >= 0 && p.features.angle_bound <= 180, "features_angle_bound");
  require(r.surface_weight > 0 && std::isfinite(r.surface_weight), "surface_weight");
  require(r.feature_weight > 0 && std::isfinite(r.feature_weight), "feature_weight");
  require(r.regularization_weight >= 0 && std::isfinite(r.regularization_weight), "regularization_weight");
  require(r.cone_angle_bound > 0 && r.cone_angle_bound < 90, "cone_angle_bound");

  if constexpr (is_given<NamedParameters, internal_np::hex_target_edge_length_map_t>) {
    const auto map = get_parameter(np, internal_np::hex_target_edge_length_map);
    p.target_length = [map, &keys](std::size_t a, std::size_t b) {
      return CGAL::to_double(get(map, std::make_pair(keys[a], keys[b])));
    };
  }

  p.interface_references = interface_references(np);

  const bool verbose = choose_parameter(get_parameter(np, internal_np::verbose), false);
  if (verbose)
    p.on_iteration = [](const Iteration& i) {
      std::cerr << name(i.stage) << ' ' << i.iteration << ": energy " << i.energy << ", " << i.number_of_inverted
                << " inverted, minimum " << i.minimum << ", average " << i.average << '\n';
      return true;
    };
  if constexpr (is_given<NamedParameters, internal_np::visitor_t>) {
    p.on_iteration = [visitor = get_parameter(np, internal_np::visitor),
                      print = p.on_iteration](const Iteration& i) mutable {
      if (print)
        print(i);
      return unwrapped(visitor).on_iteration(i);
    };
  }
  return p;
}

// keys: of the hexahedra, by which the map of the caller is asked. Throws Input_error for a face without four vertices.
template <class NamedParameters, class Key>
Regions regions(const NamedParameters& np, const std::vector<Key>& keys)
{
  Regions result;
  if constexpr (is_given<NamedParameters, internal_np::hexahedron_label_map_t>) {
    const auto map = parameters::get_parameter(np, internal_np::hexahedron_label_map);
    for (const Key& key : keys)
      result.labels.push_back(static_cast<int>(get(map, key)));
  }
  if constexpr (is_given<NamedParameters, internal_np::hex_internal_faces_t>)
    for (const auto& face : parameters::get_parameter(np, internal_np::hex_internal_faces)) {
      const auto count = std::distance(std::begin(face), std::end(face));
      if (count != 4)
        throw Input_error(Input_error::Element::PARAMETER, result.faces.size(),
                          "internal face " + std::to_string(result.faces.size()) + " has " + std::to_string(count) +
                            " vertices");
      result.faces.push_back(engine_indices<4>(face));
    }
  if constexpr (is_given<NamedParameters, internal_np::hex_periodic_vertices_t>)
    for (const auto& [vertex, partner, translation] :
         parameters::get_parameter(np, internal_np::hex_periodic_vertices)) {
      const auto [a, b] = engine_indices<2>(std::array<unsigned long long, 2>{
        {static_cast<unsigned long long>(vertex), static_cast<unsigned long long>(partner)}});
      result.ties.push_back({a, b,
                             Vector_3(CGAL::to_double(translation.x()), CGAL::to_double(translation.y()),
                                      CGAL::to_double(translation.z()))});
    }
  return result;
}

// To the faces within regions. A hexahedron with an index that cannot be one is refused elsewhere.
template <class NamedParameters>
void add_constrained_facets([[maybe_unused]] const NamedParameters& np,
                            [[maybe_unused]] const std::vector<Hexahedron>& hexahedra, [[maybe_unused]] Regions& regions)
{
  if constexpr (is_given<NamedParameters, internal_np::facet_is_constrained_t>) {
    const auto map = parameters::get_parameter(np, internal_np::facet_is_constrained);
    std::set<std::array<std::size_t, 4>> facets;
    for (const Hexahedron& h : hexahedra)
      for (const auto& corners : hexahedron_faces) {
        std::array<std::size_t, 4> facet;
        for (std::size_t i = 0; i < 4; ++i)
          facet[i] = static_cast<std::size_t>(h[corners[i]]);
        std::sort(facet.begin(), facet.end());
        if (facet[3] <= 0x7fffffff && get(map, facet))
          facets.insert(facet);
      }
    for (const auto& facet : facets)
      regions.faces.push_back(engine_indices<4>(facet));
  }
}

template <class NamedParameters, class Key>
std::vector<char> constrained_vertices(const NamedParameters& np, const std::vector<Key>& keys)
{
  std::vector<char> is_frozen(keys.size(), false);
  if constexpr (is_given<NamedParameters, internal_np::vertex_is_constrained_t>) {
    const auto map = parameters::get_parameter(np, internal_np::vertex_is_constrained);
    for (std::size_t v = 0; v < keys.size(); ++v)
      is_frozen[v] = get(map, keys[v]);
  }
  return is_frozen;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_NAMED_PARAMETERS_H
