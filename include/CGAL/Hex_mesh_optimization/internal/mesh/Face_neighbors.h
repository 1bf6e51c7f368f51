// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_FACE_NEIGHBORS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_FACE_NEIGHBORS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which hexahedra share faces, whatever their orientation: what can be known
// of a mesh before it is known to be sound.

#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// hexahedra: of eight different vertices each; must outlive the object. A side is 6h + f: face f of hexahedron h.
// O(n log n) for n hexahedra.
class Face_neighbors
{
public:
  enum : int { ALONE = -1, UNSOUND = -2 };

  explicit Face_neighbors(const std::vector<Hexahedron>& hexahedra)
    : hexahedra_(hexahedra)
    , opposite_(6 * hexahedra.size(), ALONE)
  {
    std::vector<std::pair<std::array<int, 4>, int>> keyed; // (sorted vertices, side)
    keyed.reserve(opposite_.size());
    for (int side = 0; side < number_of_sides(); ++side) {
      keyed.emplace_back(vertices(side), side);
      std::sort(keyed.back().first.begin(), keyed.back().first.end());
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t i = 0; i < keyed.size();) {
      std::size_t end = i + 1;
      while (end < keyed.size() && keyed[end].first == keyed[i].first)
        ++end;
      if (end - i == 2 && turn(keyed[i].second, keyed[i + 1].second) != 0) {
        opposite_[keyed[i].second] = keyed[i + 1].second;
        opposite_[keyed[i + 1].second] = keyed[i].second;
      }
      else if (end - i > 1)
        for (std::size_t k = i; k < end; ++k)
          opposite_[keyed[k].second] = UNSOUND;
      i = end;
    }
  }

  int number_of_sides() const { return static_cast<int>(opposite_.size()); }

  // The other side of the face; ALONE on the boundary; UNSOUND where three hexahedra meet, or two that share four
  // vertices and no face: Hexahedral_complex refuses them.
  int opposite(int side) const { return opposite_[side]; }

  // All sides with the vertices of this one, in increasing order. O(hexahedra): to say what is wrong.
  std::vector<int> sides_with_vertices_of(int side) const
  {
    std::array<int, 4> key = vertices(side);
    std::sort(key.begin(), key.end());
    std::vector<int> result;
    for (int other = 0; other < number_of_sides(); ++other) {
      std::array<int, 4> of_other = vertices(other);
      std::sort(of_other.begin(), of_other.end());
      if (of_other == key)
        result.push_back(other);
    }
    return result;
  }

  // Whether the two hexahedra of a face agree which is its outer side: both run around it in opposite directions.
  bool is_agreed(int side) const { return turn(side, opposite_[side]) < 0; }

  std::array<int, 4> vertices(int side) const
  {
    const Hexahedron& h = hexahedra_[side / 6];
    const auto& f = hexahedron_faces[side % 6];
    return {h[f[0]], h[f[1]], h[f[2]], h[f[3]]};
  }

private:
  // 1 and -1: they run around the same face in the same and in opposite directions. 0: it is not the same face.
  int turn(int side, int other) const
  {
    const std::array<int, 4> a = vertices(side), b = vertices(other);
    const std::size_t k = std::find(b.begin(), b.end(), a[0]) - b.begin();
    for (const int direction : {1, 3})
      if (a[1] == b[(k + direction) % 4] && a[2] == b[(k + 2) % 4] && a[3] == b[(k + 3 * direction) % 4])
        return direction == 1 ? 1 : -1;
    return 0;
  }

  const std::vector<Hexahedron>& hexahedra_;
  std::vector<int> opposite_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_FACE_NEIGHBORS_H
