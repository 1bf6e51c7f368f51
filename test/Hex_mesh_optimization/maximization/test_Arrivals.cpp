// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is called comes to its place where its hexahedra allow it, and is let go
// where they do not.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Arrivals.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "../Attached_mesh.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using CGAL::Hex_mesh_optimization::Boundary_placement;

struct Arriving
{
  Attached_mesh& mesh;
  Sliding sliding;
  Arrivals arrivals;
  bool is_over = false;

  explicit Arriving(Attached_mesh& s, const Arrival_parameters& parameters = Arrival_parameters())
    : mesh(s)
    , sliding(s.sliding(Boundary_placement::ON_SURFACE))
    , arrivals(s.complex, s.lengths, sliding, parameters)
  {}

  double minimum() const { return Mesh_quality(mesh.complex, mesh.points).minimum; }
  bool call()
  {
    return arrivals.call(mesh.points, minimum(), [this] { return is_over; });
  }
  bool go_on()
  {
    return arrivals.go_on(mesh.points, [this] { return is_over; });
  }

  void approach()
  {
    const Mesh_quality quality(mesh.complex, mesh.points);
    arrivals.approach(quality.scaled_jacobians, Batched_values<1>(quality.scaled_jacobians.size()), .9, mesh.points);
  }

  // Up to the end. Returns the iterations.
  int come()
  {
    int i = 0;
    for (; go_on() && i < 1000; ++i)
      approach();
    return i;
  }
};

class Arrivals_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Arrivals_of_families, ::testing::ValuesIn(mesh_families()), Family_name());

TEST_P(Arrivals_of_families, bring_all_to_their_places_where_nothing_is_in_the_way)
{
  Attached_mesh s(GetParam()());
  std::mt19937 random(11);
  s.scramble(random, .02, true);
  Arriving a(s);
  EXPECT_FALSE(a.arrivals.have_begun());
  EXPECT_EQ(a.arrivals.level(), 0);
  EXPECT_TRUE(a.call());
  EXPECT_TRUE(a.arrivals.have_begun());
  EXPECT_GT(a.arrivals.level(), 0);
  EXPECT_LT(a.come(), 1000);
  EXPECT_TRUE(a.sliding.vertices_away().empty());
  EXPECT_EQ(a.arrivals.level(), 0);
  EXPECT_FALSE(a.call()) << "there is nobody to call";
}

TEST_P(Arrivals_of_families, keep_valid_what_is_valid_and_no_less_than_the_level)
{
  std::mt19937 random(12);
  for (int trial = 0; trial < 5; ++trial) {
    Attached_mesh s(GetParam()());
    s.scramble(random, .1, true);
    if (Mesh_quality(s.complex, s.points).invalid > 0)
      continue;
    Arriving a(s);
    ASSERT_TRUE(a.call());
    for (int i = 0; a.go_on() && i < 300; ++i) {
      const Mesh_quality before(s.complex, s.points);
      a.approach();
      const Mesh_quality after(s.complex, s.points);
      EXPECT_EQ(after.invalid, 0u) << i;
      EXPECT_GE(after.minimum, (std::min)(before.minimum, .9 * a.arrivals.level()) - 1e-5) << i;
    }
  }
}

// A corner of the reference that is so many times as far from the vertex as the center of its hexahedron, this way: from
// 2/3 on it cannot stand there among its neighbors, and far beyond not wherever they slide
struct Corner_inside
{
  Attached_mesh mesh{mesh_families()[0]()};
  int vertex = -1;

  explicit Corner_inside(double distance)
  {
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.attachment.kind[v] == Vertex_kind::CORNER)
        vertex = static_cast<int>(v);
    const Hexahedron& h = mesh.complex.hexahedra[mesh.complex.vertex_hexahedra[vertex][0]];
    Vector_3 center = Vector_3::Zero();
    for (int v : h)
      center += mesh.points[v] / 8;
    mesh.attachment.corner[vertex] = mesh.points[vertex] + distance * (center - mesh.points[vertex]);
  }
};

TEST(Arrivals, let_a_feature_go_that_its_hexahedron_cannot_hold_and_keep_the_surface)
{
  Corner_inside c(3);
  Arriving a(c.mesh);
  ASSERT_TRUE(a.call());
  EXPECT_LT(a.come(), 1000);
  EXPECT_EQ(a.sliding.vertices_away(), std::vector<int>{c.vertex});
  EXPECT_EQ(a.sliding.away(c.mesh.points).off_surface, 0u);
  EXPECT_EQ(Mesh_quality(c.mesh.complex, c.mesh.points).invalid, 0u);
  EXPECT_FALSE(a.call()) << "it could not stand there";
}

TEST(Arrivals, find_a_place_by_others_making_room)
{
  Corner_inside c(.9);
  Arriving a(c.mesh);
  ASSERT_TRUE(a.call());
  EXPECT_LT(a.come(), 1000);
  EXPECT_TRUE(a.sliding.vertices_away().empty());
  EXPECT_EQ(c.mesh.points[c.vertex], c.mesh.attachment.corner[c.vertex]);
  const Mesh_quality quality(c.mesh.complex, c.mesh.points);
  EXPECT_EQ(quality.invalid, 0u);
  EXPECT_GE(quality.minimum, Arrival_parameters().least_minimum - 1e-6);
  EXPECT_EQ(a.sliding.away(c.mesh.points).in_all, 0u);
}

TEST(Arrivals, search_no_longer_when_time_is_over)
{
  Corner_inside c(.9);
  Arriving a(c.mesh);
  a.is_over = true;
  ASSERT_TRUE(a.call());
  EXPECT_LT(a.come(), 1000);
  EXPECT_EQ(a.sliding.vertices_away(), std::vector<int>{c.vertex});
  EXPECT_EQ(Mesh_quality(c.mesh.complex, c.mesh.points).invalid, 0u);
}

TEST(Arrivals, are_called_again_as_often_as_is_said)
{
  Corner_inside c(3);
  Arrival_parameters parameters;
  parameters.most_calls = 1;
  Arriving a(c.mesh, parameters);
  ASSERT_TRUE(a.call());
  a.come();
  c.mesh.attachment.corner[c.vertex] = c.mesh.points[c.vertex];
  EXPECT_FALSE(a.call());

  Corner_inside d(3);
  Arriving b(d.mesh);
  ASSERT_TRUE(b.call());
  b.come();
  d.mesh.attachment.corner[d.vertex] = d.mesh.points[d.vertex] + Vector_3(.1, .1, .1); // now it could
  EXPECT_TRUE(b.call());
  b.come();
  EXPECT_TRUE(b.sliding.vertices_away().empty());
}

} // namespace
