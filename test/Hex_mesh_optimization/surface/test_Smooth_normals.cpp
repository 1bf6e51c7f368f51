// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Hex_mesh_optimization/internal/surface/Smooth_normals.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Two slopes that meet at the ridge from 0 to 1, two triangles each
const Positions points{{0, 0, 0}, {1, 0, 0}, {0, -1, -1}, {1, -1, -1}, {0, 1, -1}, {1, 1, -1}};
const std::vector<Triangle_indices> roof{{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}};
const Vector_3 slopes[2] = {Vector_3(0, -1, 1).normalized(), Vector_3(0, 1, 1).normalized()};

TEST(Smooth_normals, turn_from_one_slope_to_the_other_without_barriers)
{
  const Triangle_surface surface(points, roof);
  const Smooth_normals normals(surface);
  const Vector_3 middle = normals.at(1, {.5, 0, .5}); // of the ridge
  EXPECT_LT((middle - normals.at(2, {.5, .5, 0})).norm(), 1e-14) << "one normal from either side";
  EXPECT_NEAR(middle.norm(), 1, 1e-14);
  EXPECT_GT(middle[2], .99);
  EXPECT_LT((normals.at(0, {0, .5, .5}) - slopes[0]).norm(), 1e-14) << "far from the ridge";
  EXPECT_LT((normals.at(3, {0, .5, .5}) - slopes[1]).norm(), 1e-14);
}

TEST(Smooth_normals, are_those_of_the_slopes_along_a_barrier)
{
  const Triangle_surface surface(points, roof);
  const Smooth_normals normals(surface, {{0, 1}});
  for (double t : {0., .3, .5, 1.}) {
    EXPECT_LT((normals.at(1, {1 - t, 0, t}) - slopes[0]).norm(), 1e-14) << t;
    EXPECT_LT((normals.at(2, {1 - t, t, 0}) - slopes[1]).norm(), 1e-14) << t;
  }
}

// Two triangles back to back
TEST(Smooth_normals, are_those_of_the_triangle_where_they_cancel)
{
  const Triangle_surface surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const Smooth_normals normals(surface);
  const std::array<double, 3> center{1. / 3, 1. / 3, 1. / 3};
  EXPECT_LT((normals.at(0, center) - Vector_3::UnitZ()).norm(), 1e-14);
  EXPECT_LT((normals.at(1, center) + Vector_3::UnitZ()).norm(), 1e-14);
}

} // namespace
