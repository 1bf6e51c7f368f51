// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The closest point of a triangle against a search of all of its points.

#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// No point of a fine lattice of the triangle is closer; also for needles, segments and points
TEST(Closest_point_of_triangle, is_closest)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Vector_3(uniform(random), uniform(random), uniform(random)); };
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector_3 a = point(), b = trial % 7 == 0 ? a : point(), p = 2 * point();
    const Vector_3 c = trial % 5 == 0 ? Vector_3(a + uniform(random) * (b - a)) : trial % 11 == 0 ? b : point();
    const std::array<double, 3> w = closest_point_of_triangle(p, a, b, c);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
    for (double weight : w)
      EXPECT_GE(weight, 0);
    const double distance = (w[0] * a + w[1] * b + w[2] * c - p).norm();
    const int n = 12;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        EXPECT_LE(distance, (a + double(i) / n * (b - a) + double(j) / n * (c - a) - p).norm() + 1e-9);
  }
}

} // namespace
