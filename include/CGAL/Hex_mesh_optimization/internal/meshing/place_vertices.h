// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PLACE_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PLACE_VERTICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where an optimization starts well: boundary vertices on the patches, curves and corners that their faces stand for,
// others between their neighbors.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_fans.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Rounds of smoothing: each vertex goes to the mean of its neighbors, and if it is of a patch then to the nearest place that
// is its own. patches: of each vertex, sorted; vertices: those that have any. O(n) for each round, and a search for each of
// the vertices.
inline void place_vertices(Hexahedra& mesh, const std::vector<std::vector<int>>& patches,
                           const std::vector<int>& vertices, const Surface_partition& partition, int rounds)
{
  const std::size_t n = mesh.points.size();
  // Of the vertices that could stand at a corner, the nearest one does.
  std::vector<char> is_at_corner(n, false);
  std::map<std::array<double, 3>, int> of_corner;
  for (int v : vertices)
    if (patches[v].size() > 2)
      if (const std::optional<Vector_3> corner = partition.nearest(patches[v], mesh.points[v])) {
        const auto inserted = of_corner.emplace(std::array<double, 3>{(*corner)[0], (*corner)[1], (*corner)[2]}, v);
        int& holder = inserted.first->second;
        if ((mesh.points[v] - *corner).norm() < (mesh.points[holder] - *corner).norm())
          holder = v;
      }
  for (const auto& [corner, v] : of_corner) {
    mesh.points[v] = Vector_3(corner[0], corner[1], corner[2]);
    is_at_corner[v] = true;
  }

  const auto to_own_place = [&](int v) {
    Vector_3& p = mesh.points[v];
    std::optional<Vector_3> best;
    if (patches[v].size() <= 2)
      best = partition.nearest(patches[v], p);
    else
      for (std::size_t i = 0; i < patches[v].size(); ++i)
        for (std::size_t j = i + 1; j < patches[v].size(); ++j)
          if (const std::optional<Vector_3> q = partition.nearest({patches[v][i], patches[v][j]}, p))
            if (!best || (*q - p).norm() < (*best - p).norm())
              best = q;
    p = best ? *best : partition.closest_point(patches[v][0], p);
  };

  // Along a curve, the neighbors on it count; on the boundary, those on the boundary.
  std::vector<std::array<int, 2>> directed;
  for (const Hexahedron& h : mesh.hexahedra)
    for (const auto& e : hexahedron_edges) {
      const std::array<int, 2> ends = {h[e[0]], h[e[1]]};
      for (int end = 0; end < 2; ++end) {
        const int v = ends[end], u = ends[1 - end];
        if (std::includes(patches[u].begin(), patches[u].end(), patches[v].begin(), patches[v].end()))
          directed.push_back({v, u});
      }
    }
  std::sort(directed.begin(), directed.end());
  directed.erase(std::unique(directed.begin(), directed.end()), directed.end());
  const Grouped_array neighbors(
    n, directed.size(), [&](std::size_t i) { return directed[i][0]; }, [&](std::size_t i) { return directed[i][1]; });

  for (int v : vertices)
    if (!is_at_corner[v])
      to_own_place(v);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t v = 0; v < n; ++v) {
      if (is_at_corner[v] || neighbors[v].size() < 2)
        continue;
      Vector_3 sum = Vector_3::Zero();
      for (int u : neighbors[v])
        sum += mesh.points[u];
      Vector_3 step = sum / double(neighbors[v].size()) - mesh.points[v];
      if (patches[v].size() == 1) { // along the surface: a thin part does not shrink
        const Vector_3 normal = partition.foot_point(patches[v][0], mesh.points[v]).normal;
        step -= normal.dot(step) * normal;
      }
      mesh.points[v] += step;
      if (!patches[v].empty())
        to_own_place(static_cast<int>(v));
    }
}

// Of the boundary: mesh.label are patches.
inline void place_vertices(Hexahedra& mesh, const Surface_partition& partition, int rounds)
{
  const Boundary_fans fans(mesh, opposite_sides(mesh));
  std::vector<std::vector<int>> patches(mesh.points.size());
  for (std::size_t i = 0; i < fans.vertices.size(); ++i) {
    std::vector<int>& of_vertex = patches[fans.vertices[i]];
    for (int f : fans.fans[i])
      of_vertex.push_back(mesh.label[fans.sides[f]]);
    std::sort(of_vertex.begin(), of_vertex.end());
    of_vertex.erase(std::unique(of_vertex.begin(), of_vertex.end()), of_vertex.end());
  }
  place_vertices(mesh, patches, fans.vertices, partition, rounds);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PLACE_VERTICES_H
