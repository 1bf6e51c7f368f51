// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Feature curves and corners of simple solids, and of given edges on flat surfaces.

#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve_tracer.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include "../Generated_mesh.h"
#include "../reference_checks.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

std::map<Vertex_kind, int> count(const Boundary_attachment& attachment)
{
  std::map<Vertex_kind, int> result;
  for (Vertex_kind kind : attachment.kind)
    ++result[kind];
  return result;
}

TEST(Feature_curves, of_a_cube_are_its_edges)
{
  for (std::size_t n : {1, 2, 5}) {
    const Generated_mesh mesh = block(n);
    const auto surface = mesh.own_reference();
    expect_sound(*surface);
    EXPECT_EQ(surface->curves.size(), 12u);
    EXPECT_EQ(surface->corners.size(), 8u);
    for (const auto& curve : surface->curves) {
      EXPECT_EQ(curve->vertices.size(), n + 1);
      EXPECT_NEAR(curve->length, 1, 1e-12);
      EXPECT_FALSE(curve->is_closed());
    }
    for (int v : surface->corners)
      EXPECT_EQ(extreme_coordinates(surface->points[v]), 3);

    const Boundary_attachment attachment = attach_to_own_boundary(mesh.complex, *surface);
    const Vertex_kind kinds[4] = {Vertex_kind::INTERIOR, Vertex_kind::SURFACE, Vertex_kind::FEATURE,
                                  Vertex_kind::CORNER};
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      EXPECT_EQ(attachment.kind[v], kinds[extreme_coordinates(mesh.points[v])]) << v;
      if (attachment.kind[v] == Vertex_kind::FEATURE) {
        const auto& on = surface->curves[attachment.curve[v]]->vertices;
        EXPECT_NE(std::find(on.begin(), on.end(), int(v)), on.end());
      }
      if (attachment.kind[v] == Vertex_kind::CORNER) {
        EXPECT_EQ(attachment.corner[v], mesh.points[v]);
      }
    }
  }
}

TEST(Feature_curves, of_a_cylinder_are_its_rims)
{
  const Generated_mesh mesh = cylinder(4);
  const auto surface = mesh.own_reference();
  expect_sound(*surface);
  ASSERT_EQ(surface->curves.size(), 2u);
  EXPECT_EQ(surface->corners.size(), 0u);
  for (const auto& curve : surface->curves) {
    EXPECT_TRUE(curve->is_closed());
    EXPECT_EQ(curve->vertices.size(), 17u);
    EXPECT_NEAR(curve->length, 16 * 2 * std::sin(pi / 16), 1e-9);
  }
  const auto kinds = count(attach_to_own_boundary(mesh.complex, *surface));
  EXPECT_EQ(kinds.at(Vertex_kind::FEATURE), 32);
  EXPECT_EQ(kinds.count(Vertex_kind::CORNER), 0u);
}

TEST(Feature_curves, of_an_l_include_the_reentrant_edge)
{
  const Generated_mesh mesh = l_shape(2);
  const auto surface = mesh.own_reference();
  expect_sound(*surface);
  EXPECT_EQ(surface->curves.size(), 18u); // 6 upright, 6 around either end
  EXPECT_EQ(surface->corners.size(), 12u);
  bool reentrant = false;
  for (const auto& curve : surface->curves)
    reentrant = reentrant || std::all_of(curve->vertices.begin(), curve->vertices.end(), [&](int v) {
                  return (surface->points[v].head<2>() - Eigen::Vector2d(1, 1)).norm() < 1e-12;
                });
  EXPECT_TRUE(reentrant);
}

TEST(Feature_curves, of_a_ball_are_none)
{
  const Generated_mesh mesh([](auto& p, auto& h) { HMO::make_ball(p, h, 4); });
  const auto surface = mesh.own_reference();
  EXPECT_EQ(surface->curves.size(), 0u);
  EXPECT_EQ(surface->corners.size(), 0u);
}

TEST(Feature_curves, depend_on_the_angle_bound)
{
  const Generated_mesh mesh([](auto& p, auto& h) { HMO::make_ring(p, h, 7, 2); }); // a heptagonal prism: 51.4 degrees
  EXPECT_EQ(mesh.own_reference(45)->corners.size(), 28u);
  EXPECT_EQ(mesh.own_reference(45)->curves.size(), 42u);
  EXPECT_EQ(mesh.own_reference(70)->corners.size(), 0u);
  EXPECT_EQ(mesh.own_reference(70)->curves.size(), 4u);
  EXPECT_EQ(mesh.own_reference(100)->curves.size(), 0u);
}

using Points_on_surface = std::vector<int>; // one after the other

Edge_list edges_along(const Points_on_surface& vertices)
{
  Edge_list edges;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    edges.push_back({vertices[i], vertices[i + 1]});
  return edges;
}

Edge_list operator+(Edge_list a, const Edge_list& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Triangulated
{
  Positions points;
  std::vector<Triangle_indices> triangles;

  void add_quad(int a, int b, int c, int d)
  {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }

  Feature_curve_tracer trace(const Edge_list& sharp, bool keep_all = false,
                             const Feature_parameters& parameters = {}) const
  {
    return Feature_curve_tracer(points, triangles, sharp, keep_all, parameters);
  }
};

// Unit squares, each cut by a diagonal
struct Grid : Triangulated
{
  int nx, ny;

  Grid(int nx, int ny) : nx(nx), ny(ny)
  {
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        points.emplace_back(i, j, 0);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }

  int at(int i, int j) const { return (nx + 1) * j + i; }

  // From one vertex straight to another one in the same row or column
  Edge_list straight(int i, int j, int i_end, int j_end) const
  {
    Points_on_surface vertices{at(i, j)};
    while (i != i_end || j != j_end) {
      i += (i < i_end) - (i > i_end);
      j += (j < j_end) - (j > j_end);
      vertices.push_back(at(i, j));
    }
    return edges_along(vertices);
  }

  Edge_list rectangle(int i, int j, int i_end, int j_end) const
  {
    return straight(i, j, i_end, j) + straight(i_end, j, i_end, j_end) + straight(i_end, j_end, i, j_end) +
           straight(i, j_end, i, j);
  }
};

// A polyline in the plane, on a strip that stands upright on the plane and that it cuts in two lengthwise
struct Ribbon : Triangulated
{
  Edge_list middle;

  Ribbon(const Positions& line, bool is_closed)
  {
    const int n = int(line.size());
    for (double height : {0., -1., 1.})
      for (const Vector_3& p : line)
        points.push_back(p + height * Vector_3::UnitZ());
    for (int i = 0; i < (is_closed ? n : n - 1); ++i) {
      const int next = (i + 1) % n;
      middle.push_back({i, next});
      add_quad(n + i, n + next, next, i);
      add_quad(i, next, 2 * n + next, 2 * n + i);
    }
  }
};

// The same patch is on either side of a slit
TEST(Feature_curve_tracer, drops_short_slits)
{
  const Feature_parameters parameters;
  const Grid grid(24, 8);
  for (int n = 1; n < 20; ++n) {
    const bool is_short = n < parameters.persistence;
    const Feature_curve_tracer tracer = grid.trace(grid.straight(2, 4, 2 + n, 4));
    ASSERT_EQ(tracer.curves().size(), is_short ? 0u : 1u) << n;
    EXPECT_EQ(tracer.corners().size(), is_short ? 0u : 2u) << n;
    if (!is_short) {
      EXPECT_EQ(tracer.curves()[0].size(), std::size_t(n + 1)) << n;
    }
  }
}

// It is the length that counts, not the number of edges
TEST(Feature_curve_tracer, measures_slits_along_their_edges)
{
  for (double scale : {.5, 2.}) {
    Grid grid(24, 8);
    for (Vector_3& p : grid.points)
      p *= scale;
    for (int n : {7, 8, 20}) {
      const std::size_t expected = scale * n < Feature_parameters().persistence ? 0 : 1;
      EXPECT_EQ(grid.trace(grid.straight(2, 4, 2 + n, 4)).curves().size(), expected) << n << " edges of " << scale;
    }
  }
}

// A slit from the rim separates nothing either
TEST(Feature_curve_tracer, drops_short_slits_that_begin_at_the_rim)
{
  const Grid grid(10, 10);
  EXPECT_TRUE(grid.trace(grid.straight(5, 0, 5, 9)).curves().empty());
  EXPECT_EQ(grid.trace(grid.straight(5, 0, 5, 10)).curves().size(), 1u);
}

TEST(Feature_curve_tracer, keeps_every_edge_that_the_user_gave)
{
  const Grid grid(12, 4);
  for (int n = 1; n < 10; ++n) {
    const Feature_curve_tracer tracer = grid.trace(grid.straight(1, 2, 1 + n, 2), true);
    ASSERT_EQ(tracer.curves().size(), 1u) << n;
    EXPECT_EQ(tracer.curves()[0].size(), std::size_t(n + 1)) << n;
    EXPECT_EQ(tracer.corners().size(), 2u) << n;
  }
  EXPECT_EQ(grid.trace(grid.rectangle(3, 1, 4, 2), true).curves().size(), 4u) << "around two triangles";
}

// However short it is
TEST(Feature_curve_tracer, keeps_a_curve_that_cuts_the_surface_in_two)
{
  for (int n : {1, 2, 5, 12}) {
    const Grid grid(n, 9);
    for (int j = 1; j < 9; ++j) {
      const Feature_curve_tracer tracer = grid.trace(grid.straight(0, j, n, j));
      ASSERT_EQ(tracer.curves().size(), 1u) << n << ", " << j;
      EXPECT_EQ(tracer.curves()[0].size(), std::size_t(n + 1));
      EXPECT_EQ(tracer.corners(), (std::vector<int>{grid.at(0, j), grid.at(n, j)}));
    }
  }
}

// A patch is one from an area on, or from a part of the whole surface on, whichever is less.
TEST(Feature_curve_tracer, drops_the_rim_of_a_tiny_patch)
{
  const Feature_parameters parameters;
  for (int size : {6, 12, 16, 30})
    for (int n = 1; n < 5; ++n) {
      const Grid grid(size, size);
      const bool is_tiny = n * n < std::min(parameters.least_patch_area, parameters.least_patch_part * size * size);
      const Feature_curve_tracer tracer = grid.trace(grid.rectangle(1, 1, 1 + n, 1 + n));
      EXPECT_EQ(tracer.curves().size(), is_tiny ? 0u : 4u) << n << " of " << size;
      EXPECT_EQ(tracer.corners().size(), is_tiny ? 0u : 4u) << n << " of " << size;
    }
}

TEST(Feature_curve_tracer, keeps_the_rim_of_a_tiny_patch_that_is_long)
{
  Feature_parameters parameters;
  parameters.least_patch_area = 30;
  parameters.least_patch_part = 1;
  for (int n : {10, 14, 15, 20}) {
    const Grid grid(n, 9);
    const std::size_t expected = n < parameters.persistence ? 0 : 1;
    EXPECT_EQ(grid.trace(grid.straight(0, 1, n, 1), false, parameters).curves().size(), expected) << n;
  }
}

TEST(Feature_curve_tracer, keeps_a_patch_whether_it_is_divided_or_slit)
{
  const Grid grid(30, 30);
  const Edge_list rim = grid.rectangle(5, 5, 10, 10);
  const Feature_curve_tracer divided = grid.trace(rim + grid.straight(7, 5, 7, 10));
  const Feature_curve_tracer slit = grid.trace(rim + grid.straight(7, 5, 7, 9));
  EXPECT_EQ(divided.curves().size(), 7u);
  EXPECT_EQ(divided.corners().size(), 6u);
  EXPECT_EQ(slit.curves().size(), 4u);
  EXPECT_EQ(slit.corners().size(), 4u);
}

TEST(Feature_curve_tracer, keeps_single_edges_on_the_rim_alone)
{
  const Grid grid(20, 20);
  std::map<std::pair<int, int>, int> triangles;
  for (const Triangle_indices& t : grid.triangles)
    for (int k = 0; k < 3; ++k)
      ++triangles[std::minmax(t[k], t[(k + 1) % 3])];
  int on_rim = 0;
  for (const auto& edge : triangles) {
    on_rim += edge.second == 1;
    EXPECT_EQ(grid.trace(edges_along({edge.first.first, edge.first.second})).curves().size(),
              edge.second == 1 ? 1u : 0u);
  }
  EXPECT_EQ(on_rim, 80);
}

TEST(Feature_curve_tracer, keeps_edges_with_three_triangles)
{
  Triangulated fins;
  fins.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
  fins.triangles = {{0, 1, 2}, {0, 1, 3}};
  Feature_parameters parameters;
  parameters.least_patch_area = parameters.least_patch_part = 1; // more than a fin has
  EXPECT_TRUE(fins.trace(edges_along({0, 1}), false, parameters).curves().empty());
  fins.triangles.push_back({0, 1, 4});
  EXPECT_EQ(fins.trace(edges_along({0, 1}), false, parameters).curves().size(), 1u);
}

// A curve may follow the rim and then leave it.
TEST(Feature_curve_tracer, judges_a_curve_by_the_larger_part_of_its_length)
{
  const Grid grid(8, 8);
  Feature_parameters parameters;
  parameters.corner_turn = 120; // one curve around the corner
  for (int rim = 1; rim < 7; ++rim) {
    const Edge_list edges = grid.straight(rim, 0, 0, 0) + grid.straight(0, 0, 0, 1) + grid.straight(0, 1, 5, 1);
    EXPECT_EQ(grid.trace(edges, false, parameters).curves().size(), rim + 1 < 5 ? 0u : 1u) << rim;
  }
}

// A curve across the surface with a short branch: without the branch, it is one curve
TEST(Feature_curve_tracer, heals_a_curve_where_a_twig_was_dropped)
{
  const Grid grid(12, 6);
  const Edge_list edges = grid.straight(0, 3, 12, 3) + grid.straight(6, 3, 6, 5);
  const Feature_curve_tracer without = grid.trace(edges);
  ASSERT_EQ(without.curves().size(), 1u);
  EXPECT_EQ(without.curves()[0].size(), 13u);
  EXPECT_EQ(without.corners(), (std::vector<int>{grid.at(0, 3), grid.at(12, 3)}));
  const Feature_curve_tracer with = grid.trace(edges, true);
  EXPECT_EQ(with.curves().size(), 3u);
  EXPECT_EQ(with.corners(), (std::vector<int>{grid.at(0, 3), grid.at(6, 3), grid.at(12, 3), grid.at(6, 5)}));
}

TEST(Feature_curve_tracer, splits_where_a_curve_turns_sharply)
{
  for (double turn : {20., 50., 70., 120.}) {
    Positions line;
    for (int i = 0; i <= 8; ++i)
      line.emplace_back(i, 0, 0);
    for (int i = 1; i <= 8; ++i)
      line.push_back(line[8] + i * Vector_3(std::cos(turn * pi / 180), std::sin(turn * pi / 180), 0));
    const Ribbon ribbon(line, false);
    const Feature_curve_tracer tracer = ribbon.trace(ribbon.middle);
    EXPECT_EQ(tracer.curves().size(), turn < 60 ? 1u : 2u) << turn;
    EXPECT_EQ(tracer.corners(), turn < 60 ? (std::vector<int>{0, 16}) : (std::vector<int>{0, 8, 16})) << turn;
  }
}

TEST(Feature_curve_tracer, of_no_edges_finds_nothing)
{
  const Grid grid(2, 2);
  for (bool keep_all : {false, true}) {
    const Feature_curve_tracer tracer = grid.trace({}, keep_all);
    EXPECT_TRUE(tracer.curves().empty());
    EXPECT_TRUE(tracer.corners().empty());
  }
}

// A closed curve with one corner: starts and ends there
TEST(Feature_curve_tracer, closes_a_drop)
{
  Positions line;
  const int n = 24;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n;
    line.emplace_back(std::cos(t), std::sin(t) * std::sin(t / 2), 0);
  }
  const Ribbon ribbon(line, true);
  const Feature_curve_tracer tracer = ribbon.trace(ribbon.middle);
  ASSERT_EQ(tracer.corners(), std::vector<int>{0});
  ASSERT_EQ(tracer.curves().size(), 1u);
  EXPECT_EQ(tracer.curves()[0].size(), std::size_t(n + 1));
  EXPECT_EQ(tracer.curves()[0].front(), 0);
  EXPECT_EQ(tracer.curves()[0].back(), 0);
}

TEST(Feature_curve_tracer, finds_the_same_edges_in_any_order)
{
  const Grid grid(20, 20);
  Edge_list edges = grid.rectangle(2, 2, 7, 9) + grid.straight(4, 2, 4, 9) + grid.straight(12, 1, 12, 18) + // features
                    grid.straight(14, 9, 18, 9) + grid.rectangle(15, 15, 16, 16) + grid.straight(2, 12, 5, 12); // none
  const auto found = [&] {
    std::set<std::pair<int, int>> result;
    const Feature_curve_tracer tracer = grid.trace(edges);
    for (const std::vector<int>& curve : tracer.curves())
      for (std::size_t i = 0; i + 1 < curve.size(); ++i)
        EXPECT_TRUE(result.insert(std::minmax(curve[i], curve[i + 1])).second) << "an edge on two curves";
    return result;
  };
  const std::set<std::pair<int, int>> expected = found();
  EXPECT_FALSE(expected.empty());
  EXPECT_LT(expected.size(), edges.size());
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(edges.begin(), edges.end(), random);
    for (std::array<int, 2>& e : edges)
      if (random() % 2)
        std::swap(e[0], e[1]);
    EXPECT_EQ(found(), expected);
  }
}

} // namespace
