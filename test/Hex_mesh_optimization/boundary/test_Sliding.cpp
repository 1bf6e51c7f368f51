// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices on corners stay there bit for bit, those on curves and on the surface
// stay on them, and nothing else is held.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>

#include "../Attached_mesh.h"
#include "../Generated_mesh.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using CGAL::Hex_mesh_optimization::Boundary_placement;

class Sliding_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Sliding_of_families, ::testing::ValuesIn(mesh_families()), Family_name());

int dimension_on_surface(Vertex_kind kind)
{
  switch (kind) {
  case Vertex_kind::FIXED:
  case Vertex_kind::CORNER:
    return 0;
  case Vertex_kind::FEATURE:
    return 1;
  case Vertex_kind::SURFACE:
    return 2;
  default:
    return 3;
  }
}

// How far a point is from what its vertex is attached to
double distance(const Attached_mesh& s, std::size_t v, const Vector_3& p)
{
  switch (s.attachment.kind[v]) {
  case Vertex_kind::CORNER:
    return (s.attachment.corner[v] - p).norm();
  case Vertex_kind::FEATURE:
    return (s.surface->curves[s.attachment.curve[v]]->closest_point(p).point - p).norm();
  case Vertex_kind::SURFACE:
    return (s.surface->closest_point(p).point - p).norm();
  default:
    return 0;
  }
}

TEST_P(Sliding_of_families, has_the_freedoms_of_what_vertices_are_attached_to)
{
  Attached_mesh s(GetParam()());
  for (std::size_t v = 0; v < s.points.size(); v += 5)
    s.fix(v);
  const Freedoms within = s.sliding().freedoms(s.points),
                 on = s.sliding(Boundary_placement::ON_SURFACE).freedoms(s.points);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    const int dimension = dimension_on_surface(s.attachment.kind[v]);
    EXPECT_EQ(on[v].dimension(), dimension) << v;
    EXPECT_EQ(within[v].dimension(), dimension == 0 ? 0 : 3) << v;
    EXPECT_EQ(s.sliding().is_at_rest(v), dimension == 0) << v;
  }
}

TEST_P(Sliding_of_families, keeps_vertices_on_what_they_are_attached_to)
{
  const Attached_mesh s(GetParam()());
  const Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  std::mt19937 random(5);
  Positions points = s.points;
  for (int step = 0; step < 20; ++step) {
    Positions moved = points;
    for (Vector_3& p : moved)
      p += random_vector(random, .2);
    const Positions free = moved;
    sliding.retract(moved);
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (s.attachment.kind[v] == Vertex_kind::INTERIOR) {
        EXPECT_EQ(moved[v], free[v]) << v;
      }
      if (s.attachment.kind[v] == Vertex_kind::CORNER) {
        EXPECT_EQ(moved[v], s.attachment.corner[v]) << v;
      }
      EXPECT_LT(distance(s, v, moved[v]), 1e-12) << v;
    }
    points = std::move(moved);
  }
}

TEST_P(Sliding_of_families, within_the_tolerance_keeps_corners_only)
{
  const Attached_mesh s(GetParam()());
  const Sliding sliding = s.sliding();
  Positions moved = s.points;
  for (Vector_3& p : moved)
    p += Vector_3(.1, .2, -.1);
  const Positions free = moved;
  sliding.retract(moved);
  for (std::size_t v = 0; v < moved.size(); ++v)
    EXPECT_EQ(moved[v], s.attachment.kind[v] == Vertex_kind::CORNER ? s.attachment.corner[v] : free[v]) << v;
}

// What is away goes all the way once all are called, or stays free until then
TEST_P(Sliding_of_families, calls_what_is_away)
{
  Attached_mesh s(GetParam()());
  std::mt19937 random(6);
  const Positions on = s.points;
  s.scramble(random, .2, true);
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  EXPECT_FALSE(sliding.are_some_away());
  for (const Freedom& f : sliding.freedoms(s.points))
    EXPECT_EQ(f.dimension(), 3);
  sliding.call_all();
  EXPECT_TRUE(sliding.are_some_away());
  const Positions ways = sliding.ways(s.points);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    EXPECT_NEAR(ways[v].norm(), distance(s, v, s.points[v]), 1e-12) << v;
    s.points[v] += ways[v];
  }
  sliding.arrive(s.points);
  EXPECT_FALSE(sliding.are_some_away());
  for (const Vector_3& way : sliding.ways(s.points))
    EXPECT_EQ(way, Vector_3(Vector_3::Zero()));
}

// What has not come is free from then on, and still told; what has come stays held
TEST_P(Sliding_of_families, releases_what_is_away)
{
  Attached_mesh s(GetParam()());
  std::mt19937 random(7);
  s.scramble(random, .2, true);
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  EXPECT_TRUE(sliding.holds_more_than_corners());
  EXPECT_FALSE(s.sliding().holds_more_than_corners());
  sliding.call_all();
  const Positions ways = sliding.ways(s.points);
  const std::vector<int> called = sliding.vertices_away();
  ASSERT_GT(called.size(), 1u);
  const int last = called.back();
  for (int v : called)
    if (v != last)
      s.points[v] += ways[v];
  sliding.arrive(s.points);
  sliding.release_those_away();
  EXPECT_FALSE(sliding.are_some_away());
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});
  const Freedoms freedoms = sliding.freedoms(s.points);
  for (int v : called)
    EXPECT_EQ(freedoms[v].dimension() == 3, v == last) << v;
  EXPECT_EQ(sliding.ways(s.points)[last], Vector_3(Vector_3::Zero()));

  // and comes when it is called again
  EXPECT_TRUE(sliding.recall_released());
  EXPECT_TRUE(sliding.are_some_away());
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});
  s.points[last] += sliding.ways(s.points)[last];
  sliding.arrive(s.points);
  EXPECT_TRUE(sliding.vertices_away().empty());
  EXPECT_LT(sliding.freedoms(s.points)[last].dimension(), 3);
  EXPECT_FALSE(sliding.recall_released());
}

// A block whose only sharp edges are those around its top: four corners that are turns
struct Block_with_turns
{
  Generated_mesh mesh = block(4);
  std::unique_ptr<Reference_surface> surface;
  Boundary_attachment attachment;

  Block_with_turns() : surface(reference(mesh)), attachment(attach_to_own_boundary(mesh.complex, *surface)) {}

  static std::unique_ptr<Reference_surface> reference(const Generated_mesh& mesh)
  {
    Edge_list rim;
    for (const std::array<int, 2>& e : mesh.complex.edges) {
      const auto is_on_rim = [&](int v) {
        const Vector_3& p = mesh.points[v];
        return p.z() == 1 && (p.x() == 0 || p.x() == 1 || p.y() == 0 || p.y() == 1);
      };
      const Vector_3 middle = (mesh.points[e[0]] + mesh.points[e[1]]) / 2;
      const bool is_along = middle.x() == 0 || middle.x() == 1 || middle.y() == 0 || middle.y() == 1;
      if (is_on_rim(e[0]) && is_on_rim(e[1]) && is_along)
        rim.push_back(e);
    }
    return std::make_unique<Reference_surface>(mesh.points, boundary_triangles(mesh.complex), rim, true,
                                               Feature_parameters());
  }
};

TEST(Sliding, holds_turns_where_all_is_exact_only)
{
  const Block_with_turns s;
  const Sliding sliding(*s.surface, s.attachment, Boundary_placement::WITHIN_TOLERANCE, s.mesh.points);
  const Sliding exact(*s.surface, s.attachment, Boundary_placement::ON_SURFACE, s.mesh.points);
  int turns = 0;
  for (std::size_t v = 0; v < s.mesh.points.size(); ++v) {
    const bool is_turn = s.attachment.kind[v] == Vertex_kind::CORNER;
    if (is_turn) {
      EXPECT_EQ(s.attachment.corner_rank[v], Corner_rank::TURN);
    }
    EXPECT_FALSE(sliding.is_at_rest(v)) << v;
    EXPECT_EQ(exact.is_at_rest(v), is_turn) << v;
    turns += is_turn;
  }
  EXPECT_EQ(turns, 4);
}

TEST(Sliding, holds_corners_where_curves_meet)
{
  const Attached_mesh s(mesh_families()[0]());
  const Sliding sliding = s.sliding();
  int junctions = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    if (s.attachment.kind[v] == Vertex_kind::CORNER) {
      EXPECT_EQ(s.attachment.corner_rank[v], Corner_rank::JUNCTION);
      EXPECT_TRUE(sliding.is_at_rest(v));
      ++junctions;
    }
  }
  EXPECT_EQ(junctions, 8);
}

} // namespace
