// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CLOSEST_POINT_OF_TRIANGLE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CLOSEST_POINT_OF_TRIANGLE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The point of one triangle that is closest to another point.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Barycentric coordinates of the point of a triangle closest to p; the triangle may be degenerate. By the Voronoi
// regions of its vertices and edges: C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
inline std::array<double, 3> closest_point_of_triangle(const Vector_3& p, const Vector_3& a, const Vector_3& b,
                                                       const Vector_3& c)
{
  const Vector_3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0)
    return {1, 0, 0};
  const Vector_3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3)
    return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3)
    return {-d3 / (d1 - d3), d1 / (d1 - d3), 0};
  const Vector_3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6)
    return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6)
    return {-d6 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0 && along + back > 0)
    return {0, back / (along + back), along / (along + back)};
  const double sum = va + vb + vc; // the square of twice the area
  if (sum > 1e-10 * ab.squaredNorm() * ac.squaredNorm())
    return {va / sum, vb / sum, vc / sum};
  // a needle, of which rounding hides where p projects to: the closest point of its edges is as good
  const Vector_3 corners[3] = {a, b, c};
  std::array<double, 3> best{1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vector_3 &from = corners[k], edge = corners[(k + 1) % 3] - from;
    const double square = edge.squaredNorm(),
                 t = square > 0 ? (std::max)(0.0, (std::min)(1.0, edge.dot(p - from) / square)) : 0.0;
    const double distance = (from + t * edge - p).squaredNorm();
    if (distance < least) {
      least = distance;
      best = {0, 0, 0};
      best[k] = 1 - t;
      best[(k + 1) % 3] = t;
    }
  }
  return best;
}

inline Surface_point closest_point_of_triangle(const Vector_3& p, std::size_t triangle, const Positions& points,
                                               const std::vector<Triangle_indices>& triangles)
{
  const Vector_3 &a = points[triangles[triangle][0]], &b = points[triangles[triangle][1]],
                 &c = points[triangles[triangle][2]];
  const std::array<double, 3> w = closest_point_of_triangle(p, a, b, c);
  return {w[0] * a + w[1] * b + w[2] * c, w, triangle};
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CLOSEST_POINT_OF_TRIANGLE_H
