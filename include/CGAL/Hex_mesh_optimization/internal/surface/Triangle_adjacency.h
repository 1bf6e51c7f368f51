// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_ADJACENCY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_ADJACENCY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which triangles of a surface share an edge, of any surface: none of them need be
// oriented alike, and an edge may have any number of them.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Triangle_adjacency
{
public:
  struct Side
  {
    std::array<int, 2> edge; // its vertices, the smaller index first
    int triangle;
    int corner; // of the triangle, from which the side runs to the next one

    bool operator<(const Side& other) const
    {
      return std::tie(edge, triangle, corner) < std::tie(other.edge, other.triangle, other.corner);
    }
  };

  // The sides on one edge, in increasing order of the triangles.
  struct Sides
  {
    const Side *first, *past;

    const Side* begin() const { return first; }
    const Side* end() const { return past; }
    std::size_t size() const { return past - first; }
    const Side& operator[](std::size_t i) const { return first[i]; }
  };

  explicit Triangle_adjacency(const std::vector<Triangle_indices>& triangles)
  {
    sides_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        sides_.push_back({ordered({triangles[t][k], triangles[t][(k + 1) % 3]}), static_cast<int>(t), k});
    std::sort(sides_.begin(), sides_.end());
  }

  static std::array<int, 2> ordered(const std::array<int, 2>& edge)
  {
    return {(std::min)(edge[0], edge[1]), (std::max)(edge[0], edge[1])};
  }

  // Calls visit(sides) for each edge, in increasing order.
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    const Side* const past = sides_.data() + sides_.size();
    for (const Side* first = sides_.data(); first != past;) {
      const Sides sides{first, end_of_edge(first)};
      visit(sides);
      first = sides.past;
    }
  }

  // Those on an edge, given in either direction; none if there is no such edge. O(log triangles).
  Sides sides(const std::array<int, 2>& edge) const
  {
    const Side wanted{ordered(edge), 0, 0};
    const Side* const first = std::lower_bound(sides_.data(), sides_.data() + sides_.size(), wanted);
    return first != sides_.data() + sides_.size() && first->edge == wanted.edge ? Sides{first, end_of_edge(first)}
                                                                                : Sides{first, first};
  }

private:
  const Side* end_of_edge(const Side* side) const
  {
    const Side* const past = sides_.data() + sides_.size();
    const Side* end = side + 1;
    while (end != past && end->edge == side->edge)
      ++end;
    return end;
  }

  std::vector<Side> sides_; // sorted
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_ADJACENCY_H
