// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_SAMPLES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_SAMPLES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Points spread evenly and deterministically over a triangle surface.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Surface_sample
{
  Vector_3 point;
  double area; // that the sample stands for; 0 for vertices
  int vertex;  // -1 within a triangle
  int sheet;
};

// How many times a surface is larger than could be said to be of the size of the mesh, at least 1.
// In units of the mean edge of the boundary.
inline double oversize(const Positions& points, const std::vector<Triangle_indices>& triangles,
                       std::size_t number_of_boundary_faces)
{
  const double largest_area = 4; // for each face of the boundary, where 1 is about what there is
  double area = 0;
  for (const Triangle_indices& t : triangles)
    area += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
  return (std::max)(1.0, area / (largest_area * double(number_of_boundary_faces)));
}

// Calls visit(place) for the centers of n² equal parts of a triangle.
template <class Visit>
void for_lattice(const Vector_3& a, const Vector_3& b, const Vector_3& c, int n, const Visit& visit)
{
  const auto at = [&](double u, double v) { visit(Vector_3(a + u / n * (b - a) + v / n * (c - a))); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      at(i + 1 / 3.0, j + 1 / 3.0);
      if (i + j + 1 < n)
        at(i + 2 / 3.0, j + 2 / 3.0);
    }
}

// Calls visit(place, area) for the centers of parts of a triangle whose edges are about as long as the spacing, and the
// areas that they stand for; more coarsely where a triangle is very much longer. Needles are cut across: n² equal parts
// would be as slender as they are, and far too many.
template <class Visit>
void for_parts(const Vector_3& a, const Vector_3& b, const Vector_3& c, double spacing, const Visit& visit)
{
  const double most_parts = 64; // along an edge
  const double slender = .45; // twice the area over the squared longest edge: .5 with a right angle between equal sides
  const double needle = .25;  // the shortest edge over the longest
  const double least_area = 1 / 16.; // of the slices of a needle on average, in squared spacings
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double longest = (std::max)({ab, bc, ca}), shortest = (std::min)({ab, bc, ca});
  const double area = (b - a).cross(c - a).norm() / 2;
  spacing = (std::max)(spacing, longest / most_parts);
  const int n = static_cast<int>((std::max)(1.0, std::ceil(longest / spacing)));
  if (n == 1 || 2 * area >= slender * longest * longest)
    for_lattice(a, b, c, n, [&](const Vector_3& place) { visit(place, area / (double(n) * n)); });
  else if (shortest < needle * longest) {
    if (bc != shortest)
      return for_parts(b, c, a, spacing, visit);
    // from a to the shortest edge, and fewer where neighbors are as slender
    const double most_slices = std::ceil(area / (least_area * spacing * spacing));
    const int slices = static_cast<int>((std::max)(1.0, (std::min)(double(n), most_slices)));
    for (int i = 0; i < slices; ++i) {
      const double height = (i + .5) / slices;
      const int m = static_cast<int>((std::max)(1.0, std::ceil(height * shortest / spacing)));
      for (int j = 0; j < m; ++j) {
        const double across = (j + .5) / m;
        visit(Vector_3(a + height * ((1 - across) * (b - a) + across * (c - a))), area * 2 * height / slices / m);
      }
    }
  }
  else { // into needles, at the longest edge
    if (ab != longest)
      return for_parts(b, c, a, spacing, visit);
    const Vector_3 middle = (a + b) / 2;
    for_parts(a, middle, c, spacing, visit);
    for_parts(middle, b, c, spacing, visit);
  }
}

// The triangles of a surface, sheet by sheet.
inline std::vector<std::size_t> triangles_by_sheets(const Triangle_surface& surface)
{
  std::vector<std::size_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (!surface.sheets.empty())
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return surface.sheet(a) < surface.sheet(b) || (surface.sheet(a) == surface.sheet(b) && a < b);
    });
  return order;
}

// The vertices, and in every triangle the centers of parts with edges of about the given length;
// the number of samples of an oversized surface is in proportion to the mesh, not to the surface. Sheet by sheet: a
// vertex on several of them is a sample of each.
inline std::vector<Surface_sample> spread_samples(const Triangle_surface& surface, std::size_t number_of_boundary_faces,
                                                  double spacing)
{
  const Positions& points = surface.points;
  const double most_parts = 64; // a triangle this many times longer than the spacing is sampled more coarsely
  const double excess = oversize(points, surface.triangles, number_of_boundary_faces);
  std::vector<Surface_sample> samples;
  std::vector<int> seen(points.size(), -1); // in a sheet
  for (std::size_t triangle : triangles_by_sheets(surface)) {
    const Triangle_indices& t = surface.triangles[triangle];
    const int sheet = surface.sheet(triangle);
    const Vector_3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    for (int v : t)
      if (seen[v] != sheet) {
        seen[v] = sheet;
        samples.push_back({points[v], 0.0, v, sheet});
      }
    if (excess > 1) {
      const double doubled = (b - a).cross(c - a).norm();
      const int n = static_cast<int>(
        (std::max)(1.0, (std::min)(std::ceil(std::sqrt(doubled / excess) / spacing), most_parts)));
      const double area = doubled / 2 / (double(n) * n);
      for_lattice(a, b, c, n, [&](const Vector_3& place) { samples.push_back({place, area, -1, sheet}); });
    }
    else
      for_parts(a, b, c, spacing, [&](const Vector_3& place, double area) {
        samples.push_back({place, area, -1, sheet});
      });
  }
  return samples;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_SAMPLES_H
