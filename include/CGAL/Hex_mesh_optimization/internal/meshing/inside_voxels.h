// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSIDE_VOXELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSIDE_VOXELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which cells of a grid have their centers inside a closed surface: along each row of cells, the triangles that its
// line of centers crosses.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// On which side of the edge from a to b, seen along x, a line through p is: 1 left, -1 right. A line that meets the edge
// is taken for one an infinitely small step aside, the same step for all edges, so that of the triangles around an edge
// or a vertex it crosses as many as it would there. The test is exact and, of an edge, the same from either triangle.
inline int side_of_edge(const Vector_3& p, const Vector_3& a, const Vector_3& b)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  const CGAL::Orientation turn = CGAL::orientation(Point(a[1], a[2]), Point(b[1], b[2]), Point(p[1], p[2]));
  if (turn != CGAL::COLLINEAR)
    return turn == CGAL::LEFT_TURN ? 1 : -1;
  // p moves by (ε, ε²): the determinant changes by (b₁ - a₁) ε² - (b₂ - a₂) ε
  if (a[2] != b[2])
    return b[2] < a[2] ? 1 : -1;
  return b[1] == a[1] ? 0 : b[1] > a[1] ? 1 : -1;
}

// Sets grid.is_inside where the center of a cell of the box has the winding number of an inside, positive. The surface
// is closed and oriented, its normals outwards. O(triangles + rows of the triangles' boxes + crossings + cells).
inline void fill_inside(const Positions& points, const std::vector<Triangle_indices>& triangles, Voxel_grid& grid)
{
  using Crossing = std::pair<double, int>; // where along x, and by how much the winding number changes
  std::vector<std::vector<Crossing>> crossings(std::size_t(grid.cells(1)) * std::size_t(grid.cells(2)));
  for (const Triangle_indices& t : triangles) {
    const Vector_3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    std::array<int, 2> first, last; // rows that may cross it
    for (int d = 1; d < 3; ++d) {
      const std::vector<double>& centers = grid.centers(d);
      const auto bounds = std::minmax({a[d], b[d], c[d]});
      const double safe = 1e-6 * grid.mean_spacing(); // rounded to the safe side
      first[d - 1] = static_cast<int>(std::lower_bound(centers.begin(), centers.end(), bounds.first - safe) -
                                      centers.begin());
      last[d - 1] = static_cast<int>(std::upper_bound(centers.begin(), centers.end(), bounds.second + safe) -
                                     centers.begin()) -
                    1;
    }
    for (int k = first[1]; k <= last[1]; ++k)
      for (int j = first[0]; j <= last[0]; ++j) {
        const Vector_3 p(0, grid.center(1, j), grid.center(2, k));
        const int side = side_of_edge(p, a, b);
        if (side == 0 || side_of_edge(p, b, c) != side || side_of_edge(p, c, a) != side)
          continue;
        const Vector_3 n = (b - a).cross(c - a);
        const double lowest = (std::min)({a[0], b[0], c[0]}), highest = (std::max)({a[0], b[0], c[0]});
        // nearly along x, the place is any of the triangle
        double x = n[0] != 0 ? a[0] - (n[1] * (p[1] - a[1]) + n[2] * (p[2] - a[2])) / n[0] : a[0];
        x = (std::min)((std::max)(x, lowest), highest);
        // seen along x, a triangle that is left of its edges looks to x: the line leaves
        crossings[std::size_t(k) * grid.cells(1) + j].emplace_back(x, -side);
      }
  }
  for (int k = 0; k < grid.cells(2); ++k)
    for (int j = 0; j < grid.cells(1); ++j) {
      std::vector<Crossing>& row = crossings[std::size_t(k) * grid.cells(1) + j];
      std::sort(row.begin(), row.end());
      int winding = 0;
      auto next = row.begin();
      for (int i = 0; i < grid.cells(0); ++i) {
        for (; next != row.end() && next->first <= grid.center(0, i); ++next)
          winding += next->second;
        grid.is_inside[grid.index(i, j, k)] = winding > 0;
      }
    }
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSIDE_VOXELS_H
