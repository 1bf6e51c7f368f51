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
#include <vector>

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

Freedoms freedoms_without_force(const Sliding& sliding, const Positions& points)
{
  return sliding.freedoms(points);
}

// Lets all go their ways but one.
void approach_all_but(int stays, Sliding& sliding, Positions& points)
{
  sliding.approach(points, [&](const std::vector<int>& vertices, const Vector_3& way) {
    for (int v : vertices)
      if (v != stays)
        points[v] += way;
    return vertices[0] != stays;
  });
}

constexpr int none = -1;

// What is away goes all the way once all are called, or stays free until then
TEST_P(Sliding_of_families, calls_what_is_away)
{
  Attached_mesh s(GetParam()());
  std::mt19937 random(6);
  s.scramble(random, .2, true);
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  EXPECT_FALSE(sliding.are_some_away());
  for (const Freedom& f : freedoms_without_force(sliding, s.points))
    EXPECT_EQ(f.dimension(), 3);
  const Positions before = s.points;
  approach_all_but(none, sliding, s.points);
  EXPECT_EQ(s.points, before);
  sliding.call_all();
  EXPECT_TRUE(sliding.are_some_away());
  double last = 0; // distance
  sliding.approach(s.points, [&](const std::vector<int>& vertices, const Vector_3& way) {
    EXPECT_EQ(vertices.size(), 1u);
    EXPECT_NEAR(way.norm(), distance(s, vertices[0], s.points[vertices[0]]), 1e-12);
    EXPECT_GE(way.norm(), last) << "the nearest first";
    last = way.norm();
    return true;
  });
  EXPECT_FALSE(sliding.are_some_away());
  for (std::size_t v = 0; v < s.points.size(); ++v)
    EXPECT_LT(distance(s, v, s.points[v]), 1e-12) << v;
  EXPECT_EQ(sliding.away(s.points).in_all, 0u);
}

// What has not come to its feature is to come to the surface, and is free after that; it is told all the while, and what
// has come stays held
TEST_P(Sliding_of_families, releases_what_is_away_from_features_before_the_surface)
{
  Attached_mesh s(GetParam()());
  std::mt19937 random(7);
  s.scramble(random, .2, true);
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  EXPECT_TRUE(sliding.holds_more_than_corners());
  EXPECT_FALSE(s.sliding().holds_more_than_corners());
  sliding.call_all();
  const std::vector<int> called = sliding.vertices_away();
  ASSERT_GT(called.size(), 1u);
  const auto on_surface = [&](int v) { return s.surface->closest_point(s.points[v]).point; };
  const auto on_feature = std::find_if(called.begin(), called.end(), [&](int v) {
    return s.attachment.kind[v] != Vertex_kind::SURFACE &&
           distance(s, v, s.points[v]) > 1e-3 + (on_surface(v) - s.points[v]).norm();
  });
  const int last = on_feature == called.end() ? called.back() : *on_feature;
  approach_all_but(last, sliding, s.points);
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});

  sliding.release_from_features(s.points);
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});
  EXPECT_TRUE(sliding.are_some_away());
  sliding.approach(s.points, [&](const std::vector<int>& vertices, const Vector_3& way) {
    EXPECT_EQ(vertices[0], last);
    EXPECT_NEAR(way.norm(), (on_surface(last) - s.points[last]).norm(), 1e-12);
    return false;
  });
  EXPECT_EQ(sliding.away(s.points).off_surface, 1u);

  sliding.release_those_away();
  EXPECT_FALSE(sliding.are_some_away());
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});
  const Freedoms freedoms = freedoms_without_force(sliding, s.points);
  for (int v : called)
    EXPECT_EQ(freedoms[v].dimension() == 3, v == last) << v;
  EXPECT_TRUE(sliding.movable_with(last).empty()) << "nothing would keep it near";
  approach_all_but(none, sliding, s.points);
  EXPECT_EQ(sliding.away(s.points).off_surface, 1u) << "it is not called";

  sliding.recall_released(s.points);
  EXPECT_TRUE(sliding.are_some_away());
  EXPECT_EQ(sliding.vertices_away(), std::vector<int>{last});
  EXPECT_EQ(sliding.movable_with(last), std::vector<int>{last});
  sliding.approach(s.points, [&](const std::vector<int>& vertices, const Vector_3& way) {
    EXPECT_EQ(vertices[0], last);
    EXPECT_NEAR(way.norm(), distance(s, last, s.points[last]), 1e-12) << "to its feature, if it has one";
    s.points[last] += way;
    return true;
  });
  EXPECT_TRUE(sliding.vertices_away().empty());
  EXPECT_LT(freedoms_without_force(sliding, s.points)[last].dimension(), 3);
  sliding.recall_released(s.points);
  EXPECT_FALSE(sliding.are_some_away());
}

TEST_P(Sliding_of_families, notices_who_stands_where_at_other_points)
{
  Attached_mesh s(GetParam()());
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  const Positions before = s.points;
  EXPECT_TRUE(sliding.vertices_away().empty());
  std::mt19937 random(9);
  s.scramble(random, .2, true);
  sliding.notice(s.points);
  EXPECT_EQ(sliding.vertices_away().size(), sliding.away(s.points).in_all);
  EXPECT_FALSE(sliding.vertices_away().empty());
  sliding.notice(before);
  EXPECT_TRUE(sliding.vertices_away().empty());
}

// Where vertices may be tried: what has come keeps to its curve or face, corners do not move, and all else is free
TEST_P(Sliding_of_families, tells_places_near_others)
{
  const Attached_mesh s(GetParam()());
  const Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  std::mt19937 random(10);
  for (int v = 0; v < static_cast<int>(s.points.size()); ++v) {
    const bool is_corner = s.attachment.kind[v] == Vertex_kind::CORNER;
    EXPECT_EQ(sliding.movable_with(v), is_corner ? std::vector<int>() : std::vector<int>{v});
    const Vector_3 p = s.points[v] + random_vector(random, .2), q = sliding.reached(v, s.points[v], p);
    if (s.attachment.kind[v] == Vertex_kind::INTERIOR)
      EXPECT_EQ(q, p);
    else
      EXPECT_LT(distance(s, v, q), 1e-12);
  }
}

// Until all are called, what stands on curves and faces may be let go; corners stay
TEST_P(Sliding_of_families, lets_all_but_corners_go_until_they_are_called)
{
  const Attached_mesh s(GetParam()());
  Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  sliding.let_go();
  const Freedoms freedoms = freedoms_without_force(sliding, s.points);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    EXPECT_EQ(freedoms[v].dimension(), s.sliding().is_at_rest(v) ? 0 : 3) << "as within the tolerance, " << v;
  sliding.call_all();
  Positions points = s.points;
  approach_all_but(none, sliding, points);
  EXPECT_TRUE(sliding.vertices_away().empty());
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
