// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_MESH_TO_REFERENCE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_MESH_TO_REFERENCE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A face graph of the caller's as the flat reference surface of the engine.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <unordered_map>

namespace CGAL::Hex_mesh_optimization::internal {

template <class TriangleMesh, class NamedParameters>
Reference_input triangle_mesh_to_reference(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, tmesh));
  Reference_input result;
  std::unordered_map<Vertex, int> index;
  for (const Vertex v : vertices(tmesh)) {
    const auto& p = get(point_map, v);
    index.emplace(v, static_cast<int>(result.points.size()));
    result.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  for (const auto f : faces(tmesh)) {
    Triangle_indices triangle;
    int k = 0;
    for (const Vertex v : CGAL::vertices_around_face(halfedge(f, tmesh), tmesh)) {
      if (k < 3)
        triangle[k] = index[v];
      ++k;
    }
    if (k != 3)
      throw Input_error(Input_error::Element::REFERENCE_FACE, result.triangles.size(),
                        "face " + std::to_string(result.triangles.size()) + " of the reference surface has " +
                          std::to_string(k) + " vertices: the surface is not triangulated");
    result.triangles.push_back(triangle);
  }
  if constexpr (is_given<NamedParameters, internal_np::edge_is_constrained_t>) {
    const auto is_constrained = get_parameter(np, internal_np::edge_is_constrained);
    result.sharp_is_given = true;
    for (const auto e : edges(tmesh))
      if (get(is_constrained, e))
        result.sharp.push_back({index[source(e, tmesh)], index[target(e, tmesh)]});
  }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_MESH_TO_REFERENCE_H
