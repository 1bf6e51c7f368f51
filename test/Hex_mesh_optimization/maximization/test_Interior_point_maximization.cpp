// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps from a feasible mesh that lose nothing.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Interior_point_maximization.h>

#include "../Attached_mesh.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

class Interior_point_maximization_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Interior_point_maximization_of_families, ::testing::ValuesIn(mesh_families()),
                         Family_name());

void improve(Attached_mesh& s, Run_control& control, Attached_mesh::Placement placement,
             double target = std::numeric_limits<double>::infinity())
{
  Boundary_samples samples = s.samples();
  Sliding sliding = s.sliding(placement);
  const Target_lengths targets = guessed_lengths(s.lengths);
  Maximization_problem problem(s.complex, samples, s.distance(), targets, s.relations, sliding,
                               Maximization_parameters());
  Interior_point_maximization(problem, Interior_point_parameters()).run(s.points, control, target);
}

// Valid, with an interior moved at random
Attached_mesh scrambled(const Mesh_family& family, unsigned seed)
{
  for (double amplitude = .3;; amplitude *= .8) {
    Attached_mesh s(family());
    std::mt19937 random(seed);
    s.scramble(random, amplitude, false);
    if (Mesh_quality(s.complex, s.points).invalid == 0)
      return s;
  }
}

TEST_P(Interior_point_maximization_of_families, no_step_loses_the_minimum_or_validity)
{
  for (const auto placement : {Attached_mesh::Placement::WITHIN_TOLERANCE, Attached_mesh::Placement::ON_SURFACE}) {
    Attached_mesh s = scrambled(GetParam(), 3);
    const Mesh_quality before(s.complex, s.points);
    double least = before.minimum;
    Run_control control;
    control.on_state = [&](const Positions&, const Mesh_quality& now, std::optional<double>) {
      EXPECT_EQ(now.invalid, 0u);
      EXPECT_GE(now.minimum, least);
      least = now.minimum;
      return Run_control::Shown{now.inverted, now.minimum, now.average};
    };
    improve(s, control, placement);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.minimum, least);
    EXPECT_GT(after.average, before.average);
    EXPECT_GT(control.iterations, 0u);
    if (placement == Attached_mesh::Placement::ON_SURFACE) {
      EXPECT_TRUE(s.sliding(placement).vertices_away().empty());
    }
  }
}

TEST_P(Interior_point_maximization_of_families, leaves_fixed_vertices_alone)
{
  Attached_mesh s = scrambled(GetParam(), 4);
  for (std::size_t v = 0; v < s.points.size(); v += 3)
    s.fix(v);
  const Positions given = s.points;
  Run_control control;
  improve(s, control, Attached_mesh::Placement::WITHIN_TOLERANCE);
  for (std::size_t v = 0; v < given.size(); v += 3)
    EXPECT_EQ(s.points[v], given[v]) << v;
}

TEST_P(Interior_point_maximization_of_families, does_nothing_to_a_mesh_that_is_invalid_or_good_enough)
{
  Attached_mesh s = scrambled(GetParam(), 5);
  const Positions given = s.points;
  Run_control control;
  improve(s, control, Attached_mesh::Placement::WITHIN_TOLERANCE, Mesh_quality(s.complex, s.points).minimum);
  EXPECT_EQ(s.points, given);
  const Hexahedron& h = s.complex.hexahedra[s.complex.hexahedra.size() / 2];
  std::swap(s.points[h[0]], s.points[h[6]]);
  const Positions tangled = s.points;
  improve(s, control, Attached_mesh::Placement::WITHIN_TOLERANCE);
  EXPECT_EQ(s.points, tangled);
  EXPECT_EQ(control.iterations, 0u);
}

} // namespace
