// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where curves go on from their points.

#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

const Positions square = {Vector_3(0, 0, 0), Vector_3(2, 0, 0), Vector_3(2, 2, 0), Vector_3(0, 2, 0)};
const Vector_3 x = Vector_3::UnitX(), y = Vector_3::UnitY(), zero = Vector_3::Zero();

void expect_directions(const Feature_curve& curve, const Vector_3& query, const Vector_3& back, const Vector_3& forth)
{
  const std::array<Vector_3, 2> directions = curve.directions(query);
  EXPECT_EQ(directions[0], back);
  EXPECT_EQ(directions[1], forth);
}

TEST(Feature_curve, goes_on_in_two_directions_that_are_opposite_but_at_kinks)
{
  const Feature_curve curve({0, 1, 2}, square);
  expect_directions(curve, Vector_3(1, -.1, .3), -x, x);
  expect_directions(curve, Vector_3(2.1, 1, 0), -y, y);
  expect_directions(curve, Vector_3(3, -1, 0), -x, y);
  expect_directions(curve, Vector_3(2, 0, 0), -x, y);
}

TEST(Feature_curve, does_not_go_on_beyond_its_ends)
{
  const Feature_curve curve({0, 1, 2}, square);
  expect_directions(curve, Vector_3(-1, 0, 0), zero, x);
  expect_directions(curve, Vector_3(2, 3, 0), -y, zero);
}

TEST(Feature_curve, goes_on_where_it_closes)
{
  const Feature_curve curve({0, 1, 2, 3, 0}, square);
  expect_directions(curve, Vector_3(0, 0, 0), y, x);
  expect_directions(curve, Vector_3(0, 2, 0), x, -y);
}

TEST(Feature_curve, shrunk_to_a_point_goes_nowhere)
{
  const Feature_curve curve({0, 1}, {Vector_3(1, 1, 1), Vector_3(1, 1, 1)});
  expect_directions(curve, Vector_3(0, 0, 0), zero, zero);
}

} // namespace
