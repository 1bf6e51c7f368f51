// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_COINCIDENT_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_COINCIDENT_VERTICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Vertices that were probably meant to be one: those at the same corner of
// boundary faces that coincide.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Numbers the places of the vertices: those in one place have the same number. Places within part · e of each other are
// equal, e the shorter of the shortest edges at both; with a part of 0 those with equal coordinates. vertices: that count.
inline std::vector<int> places_of_vertices(const Positions& points, const std::vector<double>& shortest_edge,
                                           double part, const std::vector<int>& vertices)
{
  double largest = 0;
  for (int v : vertices)
    largest = (std::max)(largest, part * shortest_edge[v]);
  const auto cell = [&](int v, int k, double offset) {
    return largest > 0 ? std::floor(points[v][k] / (2 * largest) + offset) : points[v][k] + 0.0; // -0 equals 0
  };
  Disjoint_sets sets(points.size());
  // Two places that are near are in one cell of one of eight grids, each half a cell aside of another.
  for (int grid = 0; grid < (largest > 0 ? 8 : 1); ++grid) {
    std::vector<std::pair<std::array<double, 3>, int>> order;
    for (int v : vertices)
      order.push_back({{cell(v, 0, .5 * (grid & 1)), cell(v, 1, .25 * (grid & 2)), cell(v, 2, .125 * (grid & 4))}, v});
    std::sort(order.begin(), order.end());
    for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
      for (end = begin; end < order.size() && order[end].first == order[begin].first; ++end)
        for (std::size_t i = begin; i < end; ++i) {
          const int a = order[i].second, b = order[end].second;
          if ((points[a] - points[b]).norm() <= part * (std::min)(shortest_edge[a], shortest_edge[b])) {
            sets.unite(a, b);
            break;
          }
        }
    }
  }
  std::vector<int> result(points.size(), -1);
  for (int v : vertices)
    result[v] = static_cast<int>(sets.find(v));
  return result;
}

// Of the edges of all hexahedra at each vertex; those without a length do not count.
inline std::vector<double> shortest_edges(const Positions& points, const Face_neighbors& neighbors)
{
  std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
  for (int side = 0; side < neighbors.number_of_sides(); ++side) {
    const auto corners = neighbors.vertices(side);
    for (int k = 0; k < 4; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 4];
      const double length = (points[a] - points[b]).norm();
      for (int v : {a, b})
        if (length > 0)
          result[v] = (std::min)(result[v], length);
    }
  }
  for (double& length : result)
    length = std::isfinite(length) ? length : 0;
  return result;
}

// For each vertex the first, by number, of those that it coincides with: mostly itself. part: 0, where coordinates are to
// be equal, as a generator writes the same node twice with the same digits; or of the shortest edge, for nodes that differ
// by rounding. That vertices without a face in common are in one place means nothing: a hexahedron may have collapsed.
// O(n log n) for n vertices and faces.
inline std::vector<int> coincident_vertices(const Positions& points, const Face_neighbors& neighbors, double part = 0)
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
  const std::vector<int> place = places_of_vertices(points, shortest_edges(points, neighbors), part, vertices);

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
