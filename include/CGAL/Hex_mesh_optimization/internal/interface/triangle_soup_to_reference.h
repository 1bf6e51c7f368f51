// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_SOUP_TO_REFERENCE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_SOUP_TO_REFERENCE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Points and triples of indices of the caller's as the flat reference surface of the engine.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/parameter_lists.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// An edge of a triangle, from its lower to its higher vertex.
struct Soup_edge
{
  std::array<int, 2> vertices;
  bool is_reversed; // in the triangle
  int triangle;
};

// In increasing order.
inline std::vector<Soup_edge> edges_of_triangles(const std::vector<Triangle_indices>& triangles)
{
  std::vector<Soup_edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      edges.push_back({{(std::min)(a, b), (std::max)(a, b)}, b < a, static_cast<int>(t)});
    }
  const auto key = [](const Soup_edge& e) { return std::tie(e.vertices, e.is_reversed, e.triangle); };
  std::sort(edges.begin(), edges.end(), [&](const Soup_edge& a, const Soup_edge& b) { return key(a) < key(b); });
  return edges;
}

// Throws Input_error where a face graph could not be made of the triangles.
inline std::vector<Soup_edge> edges_of_oriented_triangles(const std::vector<Triangle_indices>& triangles)
{
  std::vector<Soup_edge> edges = edges_of_triangles(triangles);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    if (edges[i].vertices == edges[i + 1].vertices && edges[i].is_reversed == edges[i + 1].is_reversed)
      throw Input_error(Input_error::Element::REFERENCE_FACE, static_cast<std::size_t>(edges[i + 1].triangle),
                        "triangle " + std::to_string(edges[i + 1].triangle) +
                          " of the reference surface has an edge in the same direction as triangle " +
                          std::to_string(edges[i].triangle) +
                          ": neighbors must be oriented alike, and no more than two");
  return edges;
}

// However they are oriented, and however many meet in an edge.
template <class PointRange, class TriangleRange>
Reference_input triangles_to_reference(const PointRange& points, const TriangleRange& triangles)
{
  const auto refuse = [](std::size_t t, const std::string& what) {
    throw Input_error(Input_error::Element::REFERENCE_FACE, t,
                      "triangle " + std::to_string(t) + " of the reference surface has " + what);
  };
  Reference_input result;
  result.points = engine_positions(points);
  for (const auto& triangle : triangles) {
    const std::size_t t = result.triangles.size();
    const auto count = std::distance(std::begin(triangle), std::end(triangle));
    if (count != 3)
      refuse(t, std::to_string(count) + " vertices");
    const Triangle_indices vertices = engine_indices<3>(triangle);
    for (const int v : vertices)
      if (v < 0 || static_cast<std::size_t>(v) >= result.points.size())
        refuse(t, "a vertex that is not one of its " + std::to_string(result.points.size()) + " points");
    result.triangles.push_back(vertices);
  }
  return result;
}

template <class NamedParameters>
void set_sharp_edges([[maybe_unused]] Reference_input& result, [[maybe_unused]] const std::vector<Soup_edge>& edges,
                     [[maybe_unused]] const NamedParameters& np)
{
  if constexpr (is_given<NamedParameters, internal_np::edge_is_constrained_t>) {
    const auto is_constrained = parameters::get_parameter(np, internal_np::edge_is_constrained);
    result.sharp_is_given = true;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [a, b] = edges[i].vertices;
      const bool is_first = i == 0 || edges[i].vertices != edges[i - 1].vertices;
      if (is_first && get(is_constrained, std::make_pair(static_cast<std::size_t>(a), static_cast<std::size_t>(b))))
        result.sharp.push_back(edges[i].vertices);
    }
  }
}

template <class PointRange, class TriangleRange, class NamedParameters>
Reference_input triangle_soup_to_reference(const PointRange& points, const TriangleRange& triangles,
                                           const NamedParameters& np)
{
  Reference_input result = triangles_to_reference(points, triangles);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const Triangle_indices& v = result.triangles[t];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      throw Input_error(Input_error::Element::REFERENCE_FACE, t,
                        "triangle " + std::to_string(t) + " of the reference surface has a vertex twice");
  }
  const std::vector<Soup_edge> edges = edges_of_oriented_triangles(result.triangles);
  set_sharp_edges(result, edges, np);
  return result;
}

template <class PointRange, class TriangleRange, class NamedParameters>
Reference_input any_triangles_to_reference(const PointRange& points, const TriangleRange& triangles,
                                           const NamedParameters& np)
{
  Reference_input result = triangles_to_reference(points, triangles);
  set_sharp_edges(result, edges_of_triangles(result.triangles), np);
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_TRIANGLE_SOUP_TO_REFERENCE_H
