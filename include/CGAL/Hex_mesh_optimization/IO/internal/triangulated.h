// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TRIANGULATED_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TRIANGULATED_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Cuts the polygons of a soup into triangles before a mesh is built from them: whatever its shape, also
// far from planar or self-intersecting, one of n corners gives n - 2 triangles.

#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Along the diagonal across which the two normals agree better.
template <class PointRange>
void append_triangles_of_quad(const PointRange& points, const std::vector<std::size_t>& q,
                              std::vector<std::vector<std::size_t>>& triangles)
{
  const auto normal = [&](int a, int b, int c) {
    return CGAL::cross_product(points[q[b]] - points[q[a]], points[q[c]] - points[q[b]]);
  };
  if (CGAL::to_double(normal(0, 1, 2) * normal(2, 3, 0)) > CGAL::to_double(normal(1, 2, 3) * normal(3, 0, 1))) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[2], q[3], q[0]});
  }
  else {
    triangles.push_back({q[1], q[2], q[3]});
    triangles.push_back({q[3], q[0], q[1]});
  }
}

// Cuts ears off, in the projection along the axis nearest to the normal. Where none is left, which a simple polygon
// never comes to, any corner is cut off.
template <class PointRange>
void append_triangles_of_polygon(const PointRange& points, std::vector<std::size_t> polygon,
                                 std::vector<std::vector<std::size_t>>& triangles)
{
  using Point_2 = std::array<double, 2>;
  std::array<double, 3> area = {{0, 0, 0}};
  const std::array<double, 3> origin = coordinates(points[polygon[0]]);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto p = coordinates(points[polygon[i]]), q = coordinates(points[polygon[(i + 1) % polygon.size()]]);
    for (int d = 0; d < 3; ++d) {
      const int e = (d + 1) % 3, f = (d + 2) % 3;
      area[d] += (p[e] - origin[e]) * (q[f] - origin[f]) - (p[f] - origin[f]) * (q[e] - origin[e]);
    }
  }
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (std::abs(area[d]) > std::abs(area[axis]))
      axis = d;
  std::vector<Point_2> flat; // of the corners, counter-clockwise
  for (const std::size_t v : polygon) {
    const auto p = coordinates(points[v]);
    flat.push_back({{p[(axis + 1) % 3] - origin[(axis + 1) % 3], p[(axis + 2) % 3] - origin[(axis + 2) % 3]}});
    if (area[axis] < 0)
      std::swap(flat.back()[0], flat.back()[1]);
  }
  const auto turn = [](const Point_2& a, const Point_2& b, const Point_2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = flat.size();
    const Point_2 &a = flat[(i + n - 1) % n], &b = flat[i], &c = flat[(i + 1) % n];
    return turn(a, b, c) > 0 && std::none_of(flat.begin(), flat.end(), [&](const Point_2& p) {
             return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
           });
  };
  for (std::size_t i = 0; polygon.size() > 3;) {
    const std::size_t n = polygon.size();
    std::size_t tried = 0;
    for (i %= n; tried < n && !is_ear(i); ++tried)
      i = (i + 1) % n;
    triangles.push_back({polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
    flat.erase(flat.begin() + static_cast<std::ptrdiff_t>(i));
    ++i; // not from the same corner again and again
  }
  triangles.push_back(std::move(polygon));
}

template <class PointRange>
std::vector<std::vector<std::size_t>> triangulated(const PointRange& points,
                                                   std::vector<std::vector<std::size_t>> polygons)
{
  std::vector<std::vector<std::size_t>> triangles;
  triangles.reserve(polygons.size());
  for (std::vector<std::size_t>& polygon : polygons)
    if (polygon.size() == 4)
      append_triangles_of_quad(points, polygon, triangles);
    else
      append_triangles_of_polygon(points, std::move(polygon), triangles);
  return triangles;
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_TRIANGULATED_H
