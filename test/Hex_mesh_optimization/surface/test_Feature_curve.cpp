// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The tangents of curves.

#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

const Positions square = {Vector_3(0, 0, 0), Vector_3(2, 0, 0), Vector_3(2, 2, 0), Vector_3(0, 2, 0)};
const Vector_3 x = Vector_3::UnitX(), y = Vector_3::UnitY();

void expect_tangent(const Feature_curve& curve, const Vector_3& query, const Vector_3& tangent)
{
  EXPECT_LT((curve.closest_point(query).tangent - tangent).norm(), 1e-12);
}

TEST(Feature_curve, turns_smoothly_from_one_segment_to_the_next)
{
  const Feature_curve curve({0, 1, 2}, square);
  const Vector_3 middle = (x + y).normalized();
  expect_tangent(curve, Vector_3(3, -1, 0), middle);
  expect_tangent(curve, Vector_3(1, -.1, .3), (x + middle).normalized());
  expect_tangent(curve, Vector_3(2.1, 1, 0), (y + middle).normalized());
}

TEST(Feature_curve, has_the_tangent_of_a_segment_where_it_ends)
{
  const Feature_curve curve({0, 1, 2}, square);
  expect_tangent(curve, Vector_3(-1, 0, 0), x);
  expect_tangent(curve, Vector_3(2, 3, 0), y);
}

TEST(Feature_curve, turns_smoothly_where_it_closes)
{
  const Feature_curve curve({0, 1, 2, 3, 0}, square);
  expect_tangent(curve, Vector_3(0, 0, 0), (x - y).normalized());
}

TEST(Feature_curve, shrunk_to_a_point_has_no_tangent)
{
  const Feature_curve curve({0, 1}, {Vector_3(1, 1, 1), Vector_3(1, 1, 1)});
  EXPECT_EQ(curve.closest_point(Vector_3(0, 0, 0)).tangent, Vector_3::Zero());
  EXPECT_EQ(curve.closest_point(Vector_3(0, 0, 0)).point, Vector_3(1, 1, 1));
}

} // namespace
