// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_COINCIDENT_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_COINCIDENT_VERTICES_H

// Vertices that were probably meant to be one: those at the same corner of
// boundary faces that coincide.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// For each vertex the first, by number, of those that it coincides with: mostly itself. Places are equal if all
// coordinates are, exactly: nodes that a generator writes twice have the same digits, and no tolerance is right for all
// sizes of hexahedra. That vertices without a face in common are in one place means nothing: a hexahedron may have
// collapsed. O(n log n) for n vertices and faces.
inline std::vector<int> coincident_vertices(const Positions& points, const Face_neighbors& neighbors)
{
  std::vector<int> sides, vertices;
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    if (neighbors.opposite(side) == Face_neighbors::ALONE) {
      sides.push_back(side);
      for (int v : neighbors.vertices(side))
        vertices.push_back(v);
    }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  const auto coordinates = [&](int v) {
    return std::array<double, 3>{points[v][0], points[v][1], points[v][2]}; // -0 equals 0
  };
  std::sort(vertices.begin(), vertices.end(), [&](int a, int b) {
    const auto p = coordinates(a), q = coordinates(b);
    return p != q ? p < q : a < b;
  });
  std::vector<int> place(points.size(), -1);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    place[vertices[i]] = i > 0 && coordinates(vertices[i]) == coordinates(vertices[i - 1]) ? place[vertices[i - 1]]
                                                                                           : static_cast<int>(i);

  using Corners = std::array<std::pair<int, int>, 4>; // (place, vertex)
  std::vector<Corners> faces;
  for (int side : sides) {
    Corners corners;
    std::size_t i = 0;
    for (int v : neighbors.vertices(side))
      corners[i++] = {place[v], v};
    std::sort(corners.begin(), corners.end());
    bool has_collapsed = false;
    for (i = 1; i < 4; ++i)
      has_collapsed = has_collapsed || corners[i - 1].first == corners[i].first;
    if (!has_collapsed)
      faces.push_back(corners);
  }
  const auto places = [](const Corners& c) {
    return std::array<int, 4>{c[0].first, c[1].first, c[2].first, c[3].first};
  };
  std::sort(faces.begin(), faces.end(), [&](const Corners& a, const Corners& b) {
    const auto p = places(a), q = places(b);
    return p != q ? p < q : a < b;
  });
  Disjoint_sets sets(points.size());
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (places(faces[i]) == places(faces[i - 1]))
      for (int k = 0; k < 4; ++k)
        sets.unite(faces[i][k].second, faces[i - 1][k].second);

  std::vector<int> first(points.size(), -1), result(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    int& of_set = first[sets.find(static_cast<int>(v))];
    if (of_set < 0)
      of_set = static_cast<int>(v);
    result[v] = of_set;
  }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_COINCIDENT_VERTICES_H
