// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The closest point of a surface against a search of all of its triangles.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>

#include "Cube_surface.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Triangle_surface, has_no_closer_point_than_the_closest)
{
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 4);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector_3 p(uniform(random), uniform(random), uniform(random));
    const Vector_3 closest = surface.closest_point(p).point;
    const auto none = surface.closer_point(p, closest);
    EXPECT_TRUE(!none || (none->point - p).norm() > (closest - p).norm() - 1e-12);
    const auto other = surface.closer_point(p, closest + 1.5 * (closest - p) + Vector_3(1e-3, 0, 0));
    ASSERT_TRUE(other);
    EXPECT_NEAR((other->point - p).norm(), (closest - p).norm(), 1e-12);
  }
}

} // namespace
