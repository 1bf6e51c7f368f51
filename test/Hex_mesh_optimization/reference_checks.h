// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_REFERENCE_CHECKS_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_REFERENCE_CHECKS_H

// What holds for every reference surface, and where points of the unit cube are.

#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

// How many coordinates of a point of the unit cube are 0 or 1
inline int extreme_coordinates(const Vector_3& p)
{
  int result = 0;
  for (int d = 0; d < 3; ++d)
    result += std::abs(p[d]) < 1e-9 || std::abs(p[d] - 1) < 1e-9;
  return result;
}

inline void expect_sound(const Reference_surface& surface)
{
  const std::set<int> corners(surface.corners.begin(), surface.corners.end());
  EXPECT_EQ(corners.size(), surface.corners.size());
  std::set<std::pair<int, int>> edges;
  for (const auto& curve : surface.curves) {
    ASSERT_GE(curve->vertices.size(), 2u);
    double length = 0;
    for (std::size_t i = 0; i + 1 < curve->vertices.size(); ++i) {
      const int a = curve->vertices[i], b = curve->vertices[i + 1];
      EXPECT_TRUE(edges.insert(std::minmax(a, b)).second) << "an edge on two curves";
      length += (surface.points[a] - surface.points[b]).norm();
      if (i > 0) {
        EXPECT_EQ(corners.count(a), 0u) << "a curve runs through a corner";
      }
    }
    EXPECT_NEAR(curve->length, length, 1e-12 * length);
    if (!curve->is_closed()) {
      EXPECT_EQ(corners.count(curve->vertices.front()), 1u);
      EXPECT_EQ(corners.count(curve->vertices.back()), 1u);
    }
  }
}

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_REFERENCE_CHECKS_H
