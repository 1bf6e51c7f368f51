// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_MANIFOLD_BOUNDARY_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_MANIFOLD_BOUNDARY_H

// Whether the boundary of hexahedra is a manifold, whatever the engine makes of others.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace test {

// Every edge of it has two faces, and those around a vertex hang together by edges there.
inline bool has_manifold_boundary(const CGAL::Hex_mesh_optimization::internal::Hexahedra& mesh)
{
  using namespace CGAL::Hex_mesh_optimization::internal;
  std::vector<std::array<int, 4>> faces;
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  for (std::size_t side = 0; side < opposite.size(); ++side)
    if (opposite[side] < 0)
      faces.push_back(mesh.face(side));
  std::map<std::array<int, 2>, std::vector<std::size_t>> faces_of_edge;
  std::map<int, std::vector<std::size_t>> corners_of_vertex; // 4f + k
  const auto corner = [&](std::size_t f, int v) {
    return 4 * f + std::size_t(std::find(faces[f].begin(), faces[f].end(), v) - faces[f].begin());
  };
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const int a = faces[f][k], b = faces[f][(k + 1) % 4];
      faces_of_edge[{(std::min)(a, b), (std::max)(a, b)}].push_back(f);
      corners_of_vertex[a].push_back(4 * f + k);
    }
  Disjoint_sets fans(4 * faces.size());
  for (const auto& [edge, around] : faces_of_edge) {
    if (around.size() != 2)
      return false;
    for (int v : edge)
      fans.unite(corner(around[0], v), corner(around[1], v));
  }
  for (const auto& [vertex, corners] : corners_of_vertex) {
    std::set<std::size_t> distinct;
    for (std::size_t c : corners)
      distinct.insert(fans.find(c));
    if (distinct.size() != 1)
      return false;
  }
  return true;
}

} // namespace test

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_MANIFOLD_BOUNDARY_H
