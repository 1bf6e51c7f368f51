// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What triangle soups bound: unions of random parts, however they are written, and what is refused.

#include "../Random_parts.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_repair.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using Random = std::mt19937;

int random_int(Random& random, int low, int high) // both included; the same with every standard library
{
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

Reference_input moved(Reference_input surface, const Vector_3& size, const Vector_3& by)
{
  for (Vector_3& p : surface.points)
    p = p.cwiseProduct(size) + by;
  return surface;
}

Reference_input box(const Vector_3& low, const Vector_3& high) { return moved(surface_of(block(1)), high - low, low); }

Reference_input turned(Reference_input surface)
{
  for (Triangle_indices& t : surface.triangles)
    std::swap(t[1], t[2]);
  return surface;
}

// Some triangles turned, some there twice, some divided at the middle of an edge or within, each with its own vertices.
Reference_input written_badly(const Reference_input& surface, Random& random, bool divides)
{
  Reference_input result;
  const auto add = [&](const Vector_3& a, const Vector_3& b, const Vector_3& c) {
    const int n = static_cast<int>(result.points.size());
    result.points.insert(result.points.end(), {a, b, c});
    if (random_int(random, 0, 2) == 0)
      result.triangles.push_back({n, n + 2, n + 1});
    else
      result.triangles.push_back({n, n + 1, n + 2});
  };
  for (const Triangle_indices& t : surface.triangles) {
    const Vector_3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const int way = random_int(random, 0, 9);
    if (way == 0 && divides) {
      const Vector_3 middle = (a + b) / 2;
      add(a, middle, c);
      add(middle, b, c);
    }
    else
      for (int copy = 0; copy < (way == 1 ? 2 : 1); ++copy)
        add(a, b, c);
  }
  return result;
}

// Boxes of unit cells, counted.
struct Cells
{
  static constexpr int n = 8;
  std::set<std::array<int, 3>> inside;

  void add(const std::array<int, 3>& low, const std::array<int, 3>& high)
  {
    for (int i = low[0]; i < high[0]; ++i)
      for (int j = low[1]; j < high[1]; ++j)
        for (int k = low[2]; k < high[2]; ++k)
          inside.insert({i, j, k});
  }

  std::size_t number_of_bodies() const
  {
    std::set<std::array<int, 3>> left = inside;
    std::size_t result = 0;
    for (; !left.empty(); ++result) {
      std::vector<std::array<int, 3>> open = {*left.begin()};
      left.erase(open[0]);
      while (!open.empty()) {
        const std::array<int, 3> c = open.back();
        open.pop_back();
        for (int axis = 0; axis < 3; ++axis)
          for (int step : {-1, 1}) {
            std::array<int, 3> next = c;
            next[axis] += step;
            if (left.erase(next))
              open.push_back(next);
          }
      }
    }
    return result;
  }
};

TEST(Solid_of_surface, of_random_boxes_that_overlap_touch_or_coincide_is_their_union)
{
  Random random(7);
  int refused = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    Reference_input soup;
    Cells cells;
    const int number = random_int(random, 1, 5);
    for (int i = 0; i < number; ++i) {
      std::array<int, 3> low, high;
      for (int d = 0; d < 3; ++d) {
        low[d] = random_int(random, 0, Cells::n - 2);
        high[d] = random_int(random, low[d] + 1, Cells::n);
      }
      cells.add(low, high);
      Reference_input part = box(Vector_3(low[0], low[1], low[2]), Vector_3(high[0], high[1], high[2]));
      if (random_int(random, 0, 1) == 0)
        part = written_badly(part, random, true);
      append(soup, random_int(random, 0, 2) == 0 ? turned(part) : part);
    }
    try {
      const Solid_of_surface solid(soup, 1e6, 0);
      EXPECT_NEAR(solid.report.volume, double(cells.inside.size()), 1e-6);
      EXPECT_EQ(solid.report.number_of_bodies, cells.number_of_bodies());
      for (const Solid_of_surface::Body& body : solid.bodies)
        EXPECT_TRUE(is_closed_and_oriented(body.surface.triangles));
    }
    catch (const CGAL::Hex_mesh_optimization::Input_error& error) {
      // copies of one face that are divided differently
      EXPECT_NE(std::string(error.what()).find("more than two faces"), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_LE(refused, 6);
}

// A plate on four legs, flush with its sides, and a beam across it: turned, and rounded as in files of single precision.
TEST(Solid_of_surface, of_parts_that_touch_but_for_rounding_is_one_body)
{
  for (double turn : {.2, .9, 2.3, 3.1, 4.2, 5.3}) {
    Reference_input soup = turn < 3 ? box(Vector_3(0, 0, .7), Vector_3(1, 1, .8)) : surface_of(block(3));
    if (turn > 3) // the plate has several faces on a side
      for (Vector_3& p : soup.points)
        p = Vector_3(p[0], p[1], .7 + .1 * p[2]);
    for (double x : {0., .9})
      for (double y : {0., .9})
        append(soup, box(Vector_3(x, y, 0), Vector_3(x + .1, y + .1, .7)));
    append(soup, box(Vector_3(.4, -1, .8), Vector_3(.6, 2, 1)));
    const Matrix_3 rotation = Eigen::AngleAxisd(turn, Vector_3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vector_3& p : soup.points)
      p = (rotation * p).cast<float>().cast<double>();
    const Solid_of_surface solid(soup, 1e5, 0);
    EXPECT_NEAR(solid.report.volume, .1 + 4 * .007 + .12, 1e-6);
    EXPECT_EQ(solid.report.number_of_bodies, 1u);
    EXPECT_EQ(solid.report.euler_characteristic, 2);
  }
}

TEST(Solid_of_surface, keeps_cavities_of_what_is_oriented_consistently)
{
  const Reference_input outer = box(Vector_3(0, 0, 0), Vector_3(4, 4, 4)),
                        inner = box(Vector_3(1, 1, 1), Vector_3(2, 2, 2));
  for (bool inside_out : {false, true}) {
    Reference_input soup = outer;
    append(soup, turned(inner));
    const Solid_of_surface solid(inside_out ? turned(soup) : soup, 1000, 0);
    EXPECT_NEAR(solid.report.volume, 63, 1e-9);
    EXPECT_EQ(solid.report.number_of_bodies, 1u);
    EXPECT_EQ(solid.report.euler_characteristic, 4);
  }
  Reference_input soup = outer;
  append(soup, inner);
  const Solid_of_surface solid(soup, 1000, 0);
  EXPECT_NEAR(solid.report.volume, 64, 1e-9);
  EXPECT_GT(solid.report.number_of_faces_within, 0u);
}

TEST(Solid_of_surface, takes_a_dividing_wall_for_none)
{
  Reference_input soup = surface_of(block(2));
  const int n = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(),
                     {Vector_3(.5, 0, 0), Vector_3(.5, 1, 0), Vector_3(.5, 1, 1), Vector_3(.5, 0, 1)});
  soup.points.push_back(Vector_3(.5, .5, .5));
  soup.points.insert(soup.points.end(),
                     {Vector_3(.5, .5, 0), Vector_3(.5, 1, .5), Vector_3(.5, .5, 1), Vector_3(.5, 0, .5)});
  for (int k = 0; k < 4; ++k) { // its corners and the middles of its edges are vertices of the block
    soup.triangles.push_back({n + k, n + 5 + k, n + 4});
    soup.triangles.push_back({n + 5 + k, n + (k + 1) % 4, n + 4});
  }
  const Solid_of_surface solid(soup, 1000, 0);
  EXPECT_NEAR(solid.report.volume, 1, 1e-9);
  EXPECT_EQ(solid.report.euler_characteristic, 2);
  EXPECT_EQ(solid.report.number_of_faces_within, 8u);
}

TEST(Solid_of_surface, takes_a_wall_that_ends_within_faces_for_none_and_refuses_a_sheet_outside)
{
  for (double height : {.4, 1.4}) {
    Reference_input soup = box(Vector_3(0, 0, 0), Vector_3(1, 1, 1));
    const int n = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), {Vector_3(0, 0, height), Vector_3(1, 0, height), Vector_3(1, 1, height),
                                           Vector_3(0, 1, height)});
    soup.triangles.push_back({n, n + 1, n + 2});
    soup.triangles.push_back({n, n + 2, n + 3});
    if (height > 1)
      EXPECT_THROW(Solid_of_surface(soup, 1000, 0), CGAL::Hex_mesh_optimization::Input_error);
    else {
      const Solid_of_surface solid(soup, 1000, 0);
      EXPECT_NEAR(solid.report.volume, 1, 1e-9);
      EXPECT_EQ(solid.report.number_of_faces_within, 2u);
    }
  }
}

TEST(Solid_of_surface, separates_bodies_that_touch_in_an_edge_or_vertex)
{
  for (const Vector_3& at : {Vector_3(1, 1, 0), Vector_3(1, 1, 1)}) {
    Reference_input soup = box(Vector_3(0, 0, 0), Vector_3(1, 1, 1));
    append(soup, box(at, at + Vector_3(1, 1, 1)));
    const Solid_of_surface solid(soup, 1000, 0);
    EXPECT_EQ(solid.report.number_of_bodies, 2u);
    EXPECT_EQ(solid.report.euler_characteristic, 4);
    EXPECT_NEAR(solid.report.volume, 2, 1e-9);
  }
}

TEST(Solid_of_surface, of_a_surface_that_bounds_a_volume_is_that_surface)
{
  const Reference_input surface = surface_of(cylinder(4), .3);
  const Solid_of_surface solid(surface, 1000, 0);
  ASSERT_EQ(solid.bodies.size(), 1u);
  EXPECT_EQ(solid.bodies[0].surface.triangles, surface.triangles);
  EXPECT_TRUE(solid.bodies[0].surface.points == surface.points);
  EXPECT_TRUE(solid.report.is_taken_as_given());
}

std::string refusal(const Reference_input& surface, double number)
{
  try {
    Solid_of_surface solid(surface, number, 0);
  }
  catch (const CGAL::Hex_mesh_optimization::Input_error& error) {
    return error.message();
  }
  return "";
}

TEST(Solid_of_surface, closes_holes_smaller_than_a_cell_and_refuses_others_with_their_size)
{
  Reference_input surface = surface_of(block(8));
  surface.triangles.pop_back();
  EXPECT_NE(refusal(surface, 1e6).find("surface is open: 3 of its edges"), std::string::npos);
  const Solid_of_surface solid(surface, 100, 0);
  EXPECT_NEAR(solid.report.volume, 1, 1e-9);
  EXPECT_EQ(solid.report.number_of_filled_holes, 1u);
  EXPECT_NEAR(solid.report.largest_filled_hole, std::sqrt(2.) / 8, 1e-9);
}

// The sides of a cube, each with vertices of its own.
TEST(Solid_of_surface, stitches_patches_with_gaps_much_smaller_than_a_cell_and_tells_how_far)
{
  const Reference_input cube = box(Vector_3(0, 0, 0), Vector_3(1, 1, 1));
  for (double gap : {1e-5, 1e-3, 5e-3}) {
    Reference_input soup;
    for (const Triangle_indices& t : cube.triangles) {
      const Vector_3 normal = (cube.points[t[1]] - cube.points[t[0]]).cross(cube.points[t[2]] - cube.points[t[0]]);
      for (int v : t)
        soup.points.push_back(cube.points[v] + gap * normal);
      const int n = static_cast<int>(soup.points.size());
      soup.triangles.push_back({n - 3, n - 2, n - 1});
    }
    const Solid_of_surface solid(soup, 1000, .25);
    EXPECT_NEAR(solid.report.volume, 1, 7 * gap);
    EXPECT_EQ(solid.report.euler_characteristic, 2);
    EXPECT_EQ(solid.report.number_of_filled_holes, 0u);
    EXPECT_GT(solid.report.number_of_stitched_vertices, 0u);
    EXPECT_GT(solid.report.farthest_moved, gap);
    EXPECT_LT(solid.report.farthest_moved, 3 * gap);
  }
}

// A vertex of the top goes out through the bottom.
Reference_input pulled_through()
{
  Reference_input surface = surface_of(block(4));
  for (Vector_3& p : surface.points)
    if ((p - Vector_3(.5, .5, 1)).norm() < 1e-9)
      p = Vector_3(.5, .5, -.4);
  return surface;
}

TEST(Solid_of_surface, refuses_what_is_inside_out_beyond_its_opposite_side)
{
  EXPECT_NE(refusal(pulled_through(), 10000).find("inside out"), std::string::npos);
}

TEST(Soup_repair, leaves_out_a_vertex_that_was_pulled_through_and_tells_what_that_changes)
{
  const Soup_repair repaired(pulled_through());
  EXPECT_EQ(repaired.report.number_of_skipped_vertices, 1u);
  EXPECT_NEAR(repaired.report.volume_after, 1, 1e-9);
  EXPECT_LT(repaired.report.volume_before, .99);
  EXPECT_NEAR(repaired.report.farthest, .4, 1e-9);
  EXPECT_EQ(refusal(repaired.surface, 10000), "");
}

} // namespace
