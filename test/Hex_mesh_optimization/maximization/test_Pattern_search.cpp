// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices are brought to places with those around making room, or nothing has
// happened; the worst hexahedra are raised, and none pays for it.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Pattern_search.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "../Attached_mesh.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using CGAL::Hex_mesh_optimization::Boundary_placement;

Indexed_mesh single_cube()
{
  Indexed_mesh mesh;
  CGAL::Hex_mesh_optimization::make_block(mesh.points, mesh.hexahedra, {{1, 1, 1}}, {{1, 1, 1}});
  return mesh;
}

class Pattern_search_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Pattern_search_of_families, ::testing::ValuesIn(mesh_families()), Family_name());

TEST_P(Pattern_search_of_families, raises_the_worst_and_leaves_the_boundary_where_it_stands)
{
  std::mt19937 random(21);
  for (int trial = 0; trial < 3; ++trial) {
    Attached_mesh s(GetParam()());
    const Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
    s.scramble(random, .3, false);
    const Mesh_quality before(s.complex, s.points);
    Pattern_search search(s.complex, s.lengths, sliding);
    search.raise(.4, s.points);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_GE(after.minimum, before.minimum - 1e-6);
    EXPECT_GE(after.minimum, (std::min)(.3, before.minimum + .1));
    EXPECT_LE(after.invalid, before.invalid);
    EXPECT_EQ(sliding.away(s.points).in_all, 0u);
    for (std::size_t v = 0; v < s.points.size(); ++v)
      if (s.attachment.kind[v] == Vertex_kind::CORNER) {
        EXPECT_EQ(s.points[v], s.attachment.corner[v]) << v;
      }
  }
}

TEST_P(Pattern_search_of_families, leaves_alone_what_is_good_enough)
{
  Attached_mesh s(GetParam()());
  const Sliding sliding = s.sliding(Boundary_placement::ON_SURFACE);
  Pattern_search search(s.complex, s.lengths, sliding);
  const Positions before = s.points;
  search.raise(Mesh_quality(s.complex, s.points).minimum, s.points);
  EXPECT_EQ(s.points, before);
}

TEST_P(Pattern_search_of_families, brings_a_vertex_or_undoes_all)
{
  std::mt19937 random(22);
  const Attached_mesh s(GetParam()());
  const Sliding sliding = s.sliding(); // free but for corners
  Pattern_search search(s.complex, s.lengths, sliding);
  std::size_t brought = 0, undone = 0;
  for (int v = 0; v < static_cast<int>(s.points.size()); ++v) {
    if (sliding.movable_with(v).empty())
      continue;
    Positions points = s.points;
    const double least = v % 2 == 0 ? .05 : 2; // no scaled Jacobian is above 1
    if (search.bring({v}, random_vector(random, 1), .3, least, points)) {
      ++brought;
      const Mesh_quality quality(s.complex, points);
      EXPECT_EQ(quality.invalid, 0u) << v;
      EXPECT_GE(quality.minimum, .05 - 1e-6) << v;
    }
    else {
      ++undone;
      EXPECT_EQ(points, s.points) << v;
    }
  }
  EXPECT_GT(brought, 0u);
  EXPECT_GT(undone, 0u);
}

// Cubes whose vertices were moved until all corners are right and the inside is not
TEST(Pattern_search, makes_valid_what_is_not_although_its_corners_are_good)
{
  std::mt19937 random(23);
  int found = 0;
  for (int trial = 0; trial < 20000 && found < 20; ++trial) {
    Attached_mesh s(single_cube());
    std::fill(s.attachment.kind.begin(), s.attachment.kind.end(), Vertex_kind::INTERIOR);
    const Sliding sliding = s.sliding();
    s.scramble(random, .6, true);
    const Mesh_quality before(s.complex, s.points);
    if (!(before.minimum > .02 && before.invalid == 1))
      continue;
    ++found;
    Pattern_search(s.complex, s.lengths, sliding).raise(.4, s.points);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.invalid, 0u) << trial;
    EXPECT_GT(after.minimum, before.minimum) << trial;
  }
  EXPECT_EQ(found, 20);
}

} // namespace
