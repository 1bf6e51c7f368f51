// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Edges are sharp by the angle of their two triangles, and always where there are not two.

#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Two triangles folded along the edge from 0 to 1 by an angle in degrees, and a third one on demand
Edge_list sharp_edges_of_fold(double degrees, double bound, bool has_third)
{
  const double angle = degrees * CGAL_PI / 180;
  const Positions points = {{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, std::cos(angle), std::sin(angle)}, {1, 0, -3}};
  std::vector<Triangle_indices> triangles = {{0, 2, 1}, {0, 1, 3}};
  if (has_third)
    triangles.push_back({0, 1, 4});
  return sharp_edges(points, triangles, bound);
}

TEST(Sharp_edges, are_those_folded_by_more_than_the_bound)
{
  for (double degrees : {0., 10., 44., 46., 90., 179.})
    for (double bound : {5., 45., 100.}) {
      const Edge_list sharp = sharp_edges_of_fold(degrees, bound, false);
      EXPECT_EQ(sharp.size(), degrees > bound ? 5u : 4u) << degrees << ' ' << bound; // the rim is sharp in any case
      EXPECT_EQ(sharp.front() == (Edge_list::value_type{0, 1}), degrees > bound);
    }
}

TEST(Sharp_edges, are_those_of_one_triangle_or_of_three)
{
  EXPECT_EQ(sharp_edges_of_fold(0, 45, true).size(), 7u);
  EXPECT_TRUE(sharp_edges({}, {}, 45).empty());
}

} // namespace
