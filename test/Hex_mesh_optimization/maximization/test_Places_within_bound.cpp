// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices go along their curves and surfaces, and no farther than the faces
// around them keep to the bound; a search that goes only there stays within it.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Pattern_search.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "Bounded_mesh.h"

#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

class Places_within_bound_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Places_within_bound_of_families, ::testing::ValuesIn(mesh_families()),
                         Family_name());

TEST_P(Places_within_bound_of_families, lead_along_what_vertices_are_attached_to)
{
  std::mt19937 random(31);
  const Bounded_mesh s(GetParam()(), .05);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    const int vertex = static_cast<int>(v);
    const Vector_3 to = s.points[v] + random_vector(random, .3),
                   reached = s.places.reached(vertex, s.places.departure(vertex, s.points[v]), to);
    switch (s.attachment.kind[v]) {
    case Vertex_kind::FEATURE:
    case Vertex_kind::SURFACE:
      EXPECT_LT(s.distance(v, reached), 1e-9) << v; // as its start
      EXPECT_LE((reached - to).norm(), (s.points[v] - to).norm() + 1e-9) << v;
      break;
    case Vertex_kind::INTERIOR:
      EXPECT_EQ(reached, to) << v;
      break;
    default:
      break;
    }
  }
}

TEST_P(Places_within_bound_of_families, allow_what_is_within_the_bound)
{
  const double bound = .05;
  const Bounded_mesh s(GetParam()(), bound);
  Positions points = s.points;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const int vertex = static_cast<int>(v);
    EXPECT_TRUE(s.places.allows({vertex}, points)) << v;
    const bool is_interior = s.attachment.kind[v] == Vertex_kind::INTERIOR;
    const Vector_3 normal = is_interior ? Vector_3::UnitX() : s.surface->foot_point(points[v]).normal;
    points[v] += .5 * bound * normal;
    EXPECT_TRUE(s.places.allows({vertex}, points)) << v;
    points[v] = s.points[v] + 3 * bound * normal;
    EXPECT_EQ(s.places.allows({vertex}, points), is_interior) << v;
    points[v] = s.points[v];
  }
}

TEST_P(Places_within_bound_of_families, keep_a_search_within_the_bound)
{
  const double bound = .1;
  std::mt19937 random(32);
  Bounded_mesh s(GetParam()(), bound);
  s.scramble(random, .3, false);
  const Mesh_quality before(s.complex, s.points);
  Pattern_search search(s.complex, s.lengths, s.places);
  search.raise(.6, s.points);
  EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, (std::min)(.3, before.minimum + .1));
  s.its_samples.update(s.points, 1);
  EXPECT_LE(s.its_samples.excess(s.points), .01); // what has hardly moved keeps its target
}

} // namespace
