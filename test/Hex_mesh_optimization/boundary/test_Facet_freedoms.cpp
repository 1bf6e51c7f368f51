// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points of a roof: within its faces, on its ridge and at the end of that.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Facet_freedoms.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// The ridge runs from (0, 0, 1) to (4, 0, 1), the eaves at y = -1 and y = 1; its ends are triangles down to x = -1 and 5.
struct Roof
{
  Triangle_surface surface{{Vector_3(0, 0, 1), Vector_3(4, 0, 1), Vector_3(-1, -1, 0), Vector_3(5, -1, 0),
                            Vector_3(-1, 1, 0), Vector_3(5, 1, 0)},
                           {{{0, 2, 3}}, {{0, 3, 1}}, {{0, 1, 5}}, {{0, 5, 4}}, {{0, 4, 2}}, {{1, 3, 5}}}};
  Facet_freedoms facets{surface};

  Surface_point at(const Vector_3& p) const { return surface.closest_point(p); }

  // The part of a vector that a freedom leaves of it.
  static Vector_3 left(const Freedom& f, const Vector_3& v) { return f.inverse(Matrix_3::Identity()) * v; }
};

const Vector_3 right_normal = Vector_3(0, 1, 1).normalized(), left_normal = Vector_3(0, -1, 1).normalized();

TEST(Facet_freedoms, are_those_of_the_plane_within_a_face)
{
  const Roof roof;
  const Surface_point p = roof.at(Vector_3(2, .5, .5));
  for (const Vector_3& force : {Vector_3(1, 2, 3), Vector_3(0, -1, 0), Vector_3(0, 0, 0)}) {
    const Freedom f = roof.facets.freedom(p, force);
    EXPECT_EQ(f.dimension(), 2);
    EXPECT_LT(Roof::left(f, right_normal).norm(), 1e-12);
    EXPECT_EQ(roof.facets.within(p, force), force);
  }
}

TEST(Facet_freedoms, on_a_ridge_follow_the_pull_into_a_face_or_along_the_ridge)
{
  const Roof roof;
  const Surface_point p = roof.at(Vector_3(2, 0, 1));
  // down on either side
  const Freedom right = roof.facets.freedom(p, Vector_3(.1, 1, 0)), left = roof.facets.freedom(p, Vector_3(.1, -1, 0));
  ASSERT_EQ(right.dimension(), 2);
  ASSERT_EQ(left.dimension(), 2);
  EXPECT_LT(Roof::left(right, right_normal).norm(), 1e-12);
  EXPECT_LT(Roof::left(left, left_normal).norm(), 1e-12);
  // down on both: where it is steeper
  EXPECT_LT(Roof::left(roof.facets.freedom(p, Vector_3(0, .1, -1)), right_normal).norm(), 1e-12);
  // up: there is no place higher
  const Freedom up = roof.facets.freedom(p, Vector_3(.1, .2, 1));
  ASSERT_EQ(up.dimension(), 1);
  EXPECT_LT(Roof::left(up, Vector_3(0, 1, 1)).norm(), 1e-12);
  EXPECT_NEAR(Roof::left(up, Vector_3(1, 0, 0)).norm(), 1, 1e-12);
}

TEST(Facet_freedoms, at_the_end_of_a_ridge_are_those_of_a_face_an_edge_or_none)
{
  const Roof roof;
  const Surface_point p = roof.at(Vector_3(0, 0, 1));
  EXPECT_EQ(roof.facets.freedom(p, Vector_3(-1, 0, 0)).dimension(), 2);
  const Freedom along = roof.facets.freedom(p, Vector_3(1, 0, 2));
  ASSERT_EQ(along.dimension(), 1);
  EXPECT_NEAR(Roof::left(along, Vector_3(1, 0, 0)).norm(), 1, 1e-12);
  EXPECT_EQ(roof.facets.freedom(p, Vector_3(-.1, 0, 1)).dimension(), 0);
}

TEST(Facet_freedoms, leave_of_a_step_the_other_way_what_is_along_the_ridge)
{
  const Roof roof;
  const Surface_point ridge = roof.at(Vector_3(2, 0, 1)), end = roof.at(Vector_3(0, 0, 1));
  const Vector_3 down(.3, 1, -1), up(.3, -1, 1), along(.3, 0, 0);
  EXPECT_EQ(roof.facets.within(ridge, down), down);
  EXPECT_LT((roof.facets.within(ridge, up) - along).norm(), 1e-12) << "it would leave the roof";
  EXPECT_EQ(roof.facets.within(ridge, along), along);
  EXPECT_EQ(roof.facets.within(end, along), along);
  EXPECT_EQ(roof.facets.within(end, Vector_3(-1, 0, 0)), Vector_3(Vector_3::Zero()));
}

// What touches in space but is another sheet, or has no area, is no way to go.
TEST(Facet_freedoms, ignore_other_sheets_and_triangles_without_area)
{
  const Triangle_surface surface({Vector_3(0, 0, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), Vector_3(0, -1, 0),
                                  Vector_3(2, 0, 0)},
                                 {{{0, 1, 2}}, {{1, 0, 3}}, {{0, 1, 4}}}, {0, 1, 0});
  const Facet_freedoms facets(surface);
  const Surface_point p = surface.closest_point(Vector_3(.5, 0, 0), Surface_point::no_hint, 0);
  EXPECT_EQ(facets.freedom(p, Vector_3(0, 1, 0)).dimension(), 2);
  EXPECT_EQ(facets.freedom(p, Vector_3(0, -1, 0)).dimension(), 1);
}

} // namespace
