// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangles nearby, which must be found as by a search of all.

#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include "Cube_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

double distance_to_all(const Vector_3& p, const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    least = (std::min)(least, (closest_point_of_triangle(p, t, points, triangles).point - p).norm());
  return least;
}

// Whatever has moved: what is found is the closest of all triangles, or nothing is found
TEST(Nearby_triangles, are_the_closest_while_they_are_said_to_be)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&](double size) {
    return Vector_3(size * uniform(random), size * uniform(random), size * uniform(random));
  };
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  const std::size_t n = 200;
  Nearby_triangles nearby;
  nearby.reset(n);
  int found = 0, not_found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector_3 p = Vector_3::Constant(1.5) + point(2);
    EXPECT_FALSE(nearby.closest(i, p, cube.points, cube.triangles, 0)) << "nothing is listed yet";
    if (!nearby.list(i, p, distance_to_all(p, cube.points, cube.triangles), surface))
      continue; // a crowd, in the middle of the cube
    for (double size : {0., .02, .05, .2}) {
      Positions moved = cube.points;
      double farthest = 0;
      for (Vector_3& q : moved) {
        const Vector_3 step = point(size);
        farthest = (std::max)(farthest, step.norm());
        q += step;
      }
      const Vector_3 now = p + point(size);
      const std::optional<Surface_point> foot = nearby.closest(i, now, moved, cube.triangles, farthest);
      ++(foot ? found : not_found);
      if (foot) {
        EXPECT_NEAR((foot->point - now).norm(), distance_to_all(now, moved, cube.triangles), 1e-12);
      }
      if (size == 0) {
        EXPECT_TRUE(foot);
      }
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(not_found, 100);
}

TEST(Nearby_triangles, give_way_to_a_tree_in_a_crowd)
{
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  Nearby_triangles nearby;
  nearby.reset(1);
  const Vector_3 center = Vector_3::Constant(1.5);
  EXPECT_FALSE(nearby.list(0, center, 1.5, surface));
  EXPECT_FALSE(nearby.closest(0, center, cube.points, cube.triangles, 0));
}

} // namespace
