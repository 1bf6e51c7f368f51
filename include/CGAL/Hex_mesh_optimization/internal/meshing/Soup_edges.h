// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_EDGES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_EDGES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The edges of a triangle soup, and the triangles around each, however many there are.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// A triangle at an edge, which runs from the lower to the higher vertex.
struct Soup_side
{
  std::array<int, 2> edge;
  int triangle;
  bool is_reversed; // the triangle has the edge the other way
};

// Calls visit(first, last) for each edge with the range of its sides. O(n log n).
template <class Visit>
void for_soup_edges(const std::vector<Triangle_indices>& triangles, const Visit& visit)
{
  std::vector<Soup_side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({{(std::min)(a, b), (std::max)(a, b)}, static_cast<int>(t), b < a});
    }
  std::sort(sides.begin(), sides.end(), [](const Soup_side& a, const Soup_side& b) {
    return std::tie(a.edge, a.triangle) < std::tie(b.edge, b.triangle);
  });
  for (auto first = sides.cbegin(); first != sides.cend();) {
    auto last = first;
    while (last != sides.cend() && last->edge == first->edge)
      ++last;
    visit(first, last);
    first = last;
  }
}

// A closed surface that has no more than two triangles at an edge: at each, one in either direction.
inline bool is_closed_and_oriented(const std::vector<Triangle_indices>& triangles)
{
  bool result = true;
  for_soup_edges(triangles, [&](auto first, auto last) {
    result = result && last - first == 2 && first->is_reversed != (first + 1)->is_reversed;
  });
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_EDGES_H
