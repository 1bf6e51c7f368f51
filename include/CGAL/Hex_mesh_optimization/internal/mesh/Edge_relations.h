// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_EDGE_RELATIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_EDGE_RELATIONS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The edges that should resemble each other: topologically parallel ones of a
// hexahedron and consecutive ones across a face (Figure 5 of the paper).

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Edge_pair
{
  int first, second; // directed edges that run the same way; first is even
};

class Edge_relations
{
public:
  explicit Edge_relations(const Hexahedral_complex& complex)
    : parallel_degree(complex.edges.size(), 0)
    , consecutive_degree(complex.edges.size(), 0)
  {
    for (const std::array<int, 12>& edges : complex.hexahedron_edges)
      for (int axis = 0; axis < 12; axis += 4)
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < i; ++j)
            add(parallel, edges[axis + i], edges[axis + j]);
    make_unique(parallel, parallel_degree);

    for (const auto& face : complex.interior_faces)
      for (int corner : hexahedron_faces[face[0].second]) {
        const int here = leaving_edge(complex, face[0], corner);
        const int v = complex.hexahedra[face[0].first][corner];
        const Hexahedron& other = complex.hexahedra[face[1].first];
        const int other_corner = static_cast<int>(std::find(other.begin(), other.end(), v) - other.begin());
        add(consecutive, opposite_edge(here), leaving_edge(complex, face[1], other_corner));
      }
    make_unique(consecutive, consecutive_degree);
  }

  std::vector<Edge_pair> parallel, consecutive;
  std::vector<int> parallel_degree, consecutive_degree; // |P(e)|, |C(e)|

private:
  static void add(std::vector<Edge_pair>& pairs, int a, int b)
  {
    if (a / 2 == b / 2)
      return; // a sheet that closes on itself
    if (a > b)
      std::swap(a, b);
    if (a & 1) {
      a = opposite_edge(a);
      b = opposite_edge(b);
    }
    pairs.push_back({a, b});
  }

  static void make_unique(std::vector<Edge_pair>& pairs, std::vector<int>& degree)
  {
    const auto key = [](const Edge_pair& p) { return std::uint64_t(p.first) << 32 | std::uint32_t(p.second); };
    std::sort(pairs.begin(), pairs.end(), [&](const Edge_pair& p, const Edge_pair& q) { return key(p) < key(q); });
    pairs.erase(std::unique(pairs.begin(), pairs.end(),
                            [&](const Edge_pair& p, const Edge_pair& q) { return key(p) == key(q); }),
                pairs.end());
    for (const Edge_pair& p : pairs) {
      ++degree[p.first / 2];
      ++degree[p.second / 2];
    }
  }

  // The edge of a hexahedron that leaves a corner of one of its faces away from that face.
  static int leaving_edge(const Hexahedral_complex& complex, const std::pair<int, int>& side, int corner)
  {
    const auto& face = hexahedron_faces[side.second];
    int k = 0;
    while (std::find(std::begin(face), std::end(face), corner_neighbors[corner][k]) != std::end(face))
      ++k;
    const int local = corner_edges[corner][k];
    return complex.hexahedron_edges[side.first][local / 2] ^ (local & 1);
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_EDGE_RELATIONS_H
