// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEXAHEDRA_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEXAHEDRA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A hexahedral mesh while its connectivity changes: points, the indices of the vertices of each hexahedron, and labels of
// the faces of the boundary.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Hexahedra
{
  static constexpr int no_label = -1;

  // A side is face f of hexahedron h, as 6h + f.
  std::array<int, 4> face(std::size_t side) const
  {
    const Hexahedron& h = hexahedra[side / 6];
    const auto& f = hexahedron_faces[side % 6];
    return {h[f[0]], h[f[1]], h[f[2]], h[f[3]]};
  }

  Positions points;
  std::vector<Hexahedron> hexahedra;
  std::vector<int> label; // of each side on the boundary
};

// Throws Input_error unless all have eight different vertices.
inline void check_hexahedra(const Hexahedra& mesh)
{
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h) {
    Hexahedron sorted = mesh.hexahedra[h];
    std::sort(sorted.begin(), sorted.end());
    const auto refuse = [&](const std::string& what) {
      throw Input_error(Input_error::Element::HEXAHEDRON, h, "hexahedron " + std::to_string(h) + " has " + what);
    };
    if (sorted.front() < 0 || static_cast<std::size_t>(sorted.back()) >= mesh.points.size())
      refuse("a vertex that is not one of the " + std::to_string(mesh.points.size()) + " points");
    const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
    if (repeated != sorted.end())
      refuse("vertex " + std::to_string(*repeated) + " twice");
  }
}

// The other side of the same hexahedron that has the edge between a and b.
inline std::size_t side_beside(const Hexahedra& mesh, std::size_t side, int a, int b)
{
  std::size_t result = side;
  for (std::size_t other = side / 6 * 6; other < side / 6 * 6 + 6; ++other) {
    const std::array<int, 4> q = mesh.face(other);
    if (other != side && std::find(q.begin(), q.end(), a) != q.end() && std::find(q.begin(), q.end(), b) != q.end())
      result = other;
  }
  return result;
}

// Of each side the other one of its face, or -1 on the boundary. Throws Input_error if a face has three sides.
// O(n log n).
inline std::vector<std::ptrdiff_t> opposite_sides(const Hexahedra& mesh)
{
  struct Keyed_side
  {
    std::array<int, 4> key;
    std::ptrdiff_t side;
    bool operator<(const Keyed_side& other) const { return std::tie(key, side) < std::tie(other.key, other.side); }
  };
  std::vector<Keyed_side> sides;
  sides.reserve(6 * mesh.hexahedra.size());
  for (std::size_t side = 0; side < 6 * mesh.hexahedra.size(); ++side) {
    sides.push_back({mesh.face(side), static_cast<std::ptrdiff_t>(side)});
    std::sort(sides.back().key.begin(), sides.back().key.end());
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::ptrdiff_t> result(sides.size(), -1);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].key == sides[i + 1].key) {
      if (i + 2 < sides.size() && sides[i + 2].key == sides[i].key)
        throw Input_error(Input_error::Element::HEXAHEDRON, sides[i + 2].side / 6,
                          "hexahedron " + std::to_string(sides[i + 2].side / 6) +
                            " is the third one on a face that hexahedra " + std::to_string(sides[i].side / 6) +
                            " and " + std::to_string(sides[i + 1].side / 6) + " already share");
      result[sides[i].side] = sides[i + 1].side;
      result[sides[i + 1].side] = sides[i].side;
    }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEXAHEDRA_H
