// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances between opposite walls.

#include "../Generated_surface.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

Generated_mesh plate(double thickness)
{
  return Generated_mesh([&](auto& p, auto& h) {
    CGAL::Hex_mesh_optimization::make_block(p, h, {{4, 4, 1}}, {{1, 1, thickness}});
  });
}

TEST(Wall_distances, of_a_plate_are_its_thickness_and_width)
{
  const Reference_input surface = surface_of(plate(.1), .5);
  double area = 0;
  for (const Wall_distance& p : wall_distances(surface.points, surface.triangles, .1)) {
    EXPECT_TRUE(std::abs(p.distance - .1) < 1e-9 || std::abs(p.distance - 1) < 1e-9) << p.distance;
    area += p.area;
  }
  EXPECT_NEAR(area, 2 + 4 * .1, 1e-9);
}

TEST(Wall_distances, know_the_thinnest_part)
{
  const Reference_input surface = surface_of(plate(.1));
  const auto places = wall_distances(surface.points, surface.triangles, .1);
  EXPECT_NEAR(distance_of_thinnest(places, .5), .1, 1e-9); // 2 of 2.4 are that thin
  EXPECT_NEAR(distance_of_thinnest(places, .9), 1, 1e-9);
}

// The sides of a tetrahedron meet at 70 degrees: none is opposite.
TEST(Wall_distances, are_infinite_between_the_sides_of_an_edge)
{
  const Positions points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const Wall_distance& p : wall_distances(points, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, .2))
    EXPECT_TRUE(std::isinf(p.distance));
}

} // namespace
