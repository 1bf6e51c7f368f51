// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that bound no volume are refused with the reason and the place, and mended where that is possible.

#include "Generated_surface.h"
#include "files.h"

#include <CGAL/Hex_mesh_optimization/check_surface.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Element = HMO::Input_error::Element;

// What is said of it; empty if nothing is wrong.
std::string refusal(const Surface& surface)
{
  try {
    HMO::check_surface(surface);
  }
  catch (const HMO::Input_error& error) {
    return error.message();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Surface cube() { return surface_mesh(surface_of(block(2))); }

Surface open_cube()
{
  Surface surface = cube();
  CGAL::Euler::remove_face(halfedge(*surface.faces().begin(), surface), surface);
  surface.collect_garbage();
  return surface;
}

// A vertex of the top goes out through the bottom.
Surface crossing_cube()
{
  Surface surface = cube();
  for (const auto v : surface.vertices())
    if (surface.point(v) == Surface_point_3(.5, .5, 1))
      surface.point(v) = Surface_point_3(.5, .4, -.5);
  return surface;
}

Surface inverted(Surface surface)
{
  CGAL::Polygon_mesh_processing::reverse_face_orientations(surface);
  return surface;
}

Surface two(const Surface& first, const Surface& second)
{
  Surface result = first;
  result += second;
  return result;
}

Surface smaller_cube()
{
  Surface result = cube();
  for (const auto v : result.vertices())
    result.point(v) = Surface_point_3(.5, .5, .5) + (result.point(v) - Surface_point_3(.5, .5, .5)) / 2;
  return result;
}

TEST(check_surface, accepts_solids_with_components_within)
{
  EXPECT_EQ(refusal(cube()), "");
  EXPECT_EQ(refusal(surface_mesh(surface_of(l_shape(2), .7))), "");
  EXPECT_EQ(refusal(two(cube(), inverted(smaller_cube()))), "");
}

TEST(check_surface, refuses_an_open_surface)
{
  EXPECT_TRUE(contains(refusal(open_cube()), "open: 3 of its edges"));
  EXPECT_TRUE(contains(refusal(open_cube()), "vertex"));
}

TEST(check_surface, refuses_a_surface_that_intersects_itself)
{
  EXPECT_TRUE(contains(refusal(crossing_cube()), "intersects itself"));
  EXPECT_TRUE(contains(refusal(crossing_cube()), "pairs of faces, the first"));
}

TEST(check_surface, refuses_what_is_oriented_inwards)
{
  EXPECT_TRUE(contains(refusal(inverted(cube())), "oriented inwards"));
  EXPECT_TRUE(contains(refusal(two(cube(), smaller_cube())), "components"));
}

TEST(check_surface, refuses_numbers_that_are_not_finite_and_faces_without_an_area)
{
  Surface surface = cube();
  surface.point(*surface.vertices().begin()) = Surface_point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_TRUE(contains(refusal(surface), "not finite"));
  surface = cube();
  const auto f = *surface.faces().begin();
  const auto h = halfedge(f, surface);
  surface.point(target(h, surface)) = surface.point(source(h, surface));
  EXPECT_TRUE(contains(refusal(surface), "no area"));
  EXPECT_TRUE(contains(refusal(Surface()), "no faces"));
}

TEST(repair_surface, fills_holes_and_turns_components)
{
  for (Surface surface : {open_cube(), inverted(cube()), two(cube(), smaller_cube())}) {
    repair(surface);
    surface.collect_garbage();
    EXPECT_EQ(refusal(surface), "");
  }
}

TEST(repair_surface, leaves_out_a_vertex_that_was_pulled_through_the_opposite_side)
{
  Surface surface = surface_mesh(surface_of(Generated_mesh([](auto& p, auto& h) { HMO::make_ring(p, h, 18, 2); })));
  auto farthest = *surface.vertices().begin();
  for (const auto v : surface.vertices())
    if (surface.point(v).x() > surface.point(farthest).x())
      farthest = v;
  const Surface_point_3 p = surface.point(farthest);
  surface.point(farthest) = Surface_point_3(-2 * p.x(), p.y(), p.z() + .1);
  const std::size_t number = surface.number_of_vertices();
  ASSERT_TRUE(contains(refusal(surface), "intersects itself"));
  repair(surface);
  surface.collect_garbage();
  EXPECT_EQ(refusal(surface), "");
  EXPECT_EQ(surface.number_of_vertices(), number - 1);
}

} // namespace
