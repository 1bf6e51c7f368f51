// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The closest point of a surface against a search of all of its triangles.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>

#include "Cube_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

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
    for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
      const Surface_point found = surface.closest_point(p, t);
      EXPECT_NEAR((found.point - p).norm(), (closest - p).norm(), 1e-12) << t;
      const Surface_point of_same = closest_point_of_triangle(p, found.triangle, surface.points, surface.triangles);
      EXPECT_LT((found.point - of_same.point).norm(), 1e-12) << t;
    }
    const auto none = surface.closer_point(p, closest);
    EXPECT_TRUE(!none || (none->point - p).norm() > (closest - p).norm() - 1e-12);
    const auto other = surface.closer_point(p, closest + 1.5 * (closest - p) + Vector_3(1e-3, 0, 0));
    ASSERT_TRUE(other);
    EXPECT_NEAR((other->point - p).norm(), (closest - p).norm(), 1e-12);
  }
}

// The six sides of a cube as sheets, by the axis and the place of their triangles
std::vector<int> sides(const Surface& cube)
{
  std::vector<int> result;
  for (const Triangle_indices& t : cube.triangles)
    for (int d = 0; d < 3; ++d) {
      const double x = cube.points[t[0]][d];
      if ((x == 0 || x == 3) && cube.points[t[1]][d] == x && cube.points[t[2]][d] == x)
        result.push_back(2 * d + (x > 0));
    }
  return result;
}

Vector_3 on_side(Vector_3 p, int side)
{
  for (double& x : p)
    x = (std::min)((std::max)(x, 0.), 3.);
  p[side / 2] = side % 2 ? 3 : 0;
  return p;
}

// Whatever the triangle said to be near: one of the same sheet, of another, or of none
TEST(Triangle_surface, finds_the_closest_point_of_the_sheet_asked_for)
{
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles, sides(cube));
  ASSERT_EQ(surface.number_of_sheets(), 6u);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 4);
  std::vector<std::size_t> triangles{Surface_point::no_triangle, 0, 1000000};
  for (int trial = 0; trial < 100; ++trial) {
    const Vector_3 p(uniform(random), uniform(random), uniform(random));
    for (int side = 0; side < 6; ++side) {
      const Vector_3 closest = on_side(p, side);
      for (std::size_t near : triangles) {
        const Surface_point found = surface.closest_point(p, near, side);
        EXPECT_LT((found.point - closest).norm(), 1e-12) << side;
        EXPECT_EQ(surface.sheet(found.triangle), side);
        Vector_3 same = Vector_3::Zero();
        for (int k = 0; k < 3; ++k)
          same += found.coordinates[k] * surface.corner(found.triangle, k);
        EXPECT_LT((same - found.point).norm(), 1e-12);
        if (triangles.size() < 20)
          triangles.push_back(found.triangle);
      }
      const auto closer = surface.closer_point(p, p + 1.01 * (closest - p) + Vector_3(1e-3, 0, 0), side);
      ASSERT_TRUE(closer);
      EXPECT_LT((closer->point - closest).norm(), 1e-12);
      EXPECT_EQ(surface.sheet(closer->triangle), side);
    }
  }
}

TEST(Triangle_surface, visits_the_triangles_of_the_sheet_asked_for)
{
  const Surface cube(1);
  const std::vector<int> sheets = sides(cube);
  const Triangle_surface surface(cube.points, cube.triangles, sheets);
  for (int side = 0; side < 6; ++side) {
    std::set<std::size_t> visited, all;
    surface.for_triangles_near(
      Vector_3(1, 1, 1), 9, [&](std::size_t t) { visited.insert(t); }, side);
    for (std::size_t t = 0; t < sheets.size(); ++t)
      if (sheets[t] == side)
        all.insert(t);
    EXPECT_EQ(visited, all);
  }
}

// A sheet of which nothing has an area, and a number beyond the last
TEST(Triangle_surface, searches_another_sheet_for_one_that_is_empty)
{
  const Positions points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const Triangle_surface surface(points, {{0, 1, 3}, {0, 1, 2}}, {0, 2});
  ASSERT_EQ(surface.number_of_sheets(), 3u);
  EXPECT_FALSE(surface.is_empty());
  for (int sheet : {0, 1, 2, 7})
    EXPECT_LT(
      (surface.closest_point(Vector_3(.2, .3, 5), Surface_point::no_triangle, sheet).point - Vector_3(.2, .3, 0)).norm(),
      1e-15);
  for (int sheet : {0, 1, 7})
    EXPECT_FALSE(surface.closer_point(Vector_3(.2, .3, 5), Vector_3(9, 9, 9), sheet));
  EXPECT_TRUE(surface.closer_point(Vector_3(.2, .3, 5), Vector_3(9, 9, 9), 2));
  EXPECT_TRUE(Triangle_surface(points, {{0, 1, 3}}, {1}).is_empty());
}

} // namespace
