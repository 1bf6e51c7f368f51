// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_FANS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_FANS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The boundary of a hexahedral mesh whose boundary is a manifold: the sides around each vertex in cyclic order, and beside
// each side.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Boundary_fans
{
public:
  // opposite: of the mesh. O(n).
  Boundary_fans(const Hexahedra& mesh, const std::vector<std::ptrdiff_t>& opposite)
  {
    std::unordered_map<std::uint64_t, std::size_t> side_of_edge; // directed
    for (std::size_t side = 0; side < opposite.size(); ++side)
      if (opposite[side] < 0) {
        sides.push_back(side);
        corners.push_back(mesh.face(side));
      }
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (int k = 0; k < 4; ++k)
        side_of_edge[key(corners[i][k], corners[i][(k + 1) % 4])] = i;
    neighbors.resize(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (int k = 0; k < 4; ++k)
        neighbors[i][k] = static_cast<int>(side_of_edge.at(key(corners[i][(k + 1) % 4], corners[i][k])));

    std::vector<char> is_done(mesh.points.size(), false);
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const int v = corners[i][k];
        if (is_done[v])
          continue;
        is_done[v] = true;
        vertices.push_back(v);
        fans.emplace_back();
        // across the edge that enters v is the next side around it
        int f = static_cast<int>(i);
        do {
          fans.back().push_back(f);
          int corner = 0;
          while (corners[f][corner] != v)
            ++corner;
          f = neighbors[f][(corner + 3) % 4];
        } while (f != static_cast<int>(i));
      }
  }

  // The faces of the boundary, in increasing order of sides: side, vertices counter-clockwise seen from outside, and the
  // face across the edge from corner k to the next one.
  std::vector<std::size_t> sides;
  std::vector<std::array<int, 4>> corners;
  std::vector<std::array<int, 4>> neighbors;

  // The vertices of the boundary, and the faces around each, in cyclic order.
  std::vector<int> vertices;
  std::vector<std::vector<int>> fans;

private:
  static std::uint64_t key(int a, int b) { return std::uint64_t(std::uint32_t(a)) << 32 | std::uint32_t(b); }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_FANS_H
