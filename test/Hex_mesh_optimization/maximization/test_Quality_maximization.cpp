// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a maximization of the quality never spoils.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_maximization.h>

#include "../Attached_mesh.h"
#include "../Corner.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

class Quality_maximization_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Quality_maximization_of_families, ::testing::ValuesIn(mesh_families()),
                         Family_name());

void run(Attached_mesh& s, Run_control& control)
{
  Boundary_samples samples = s.samples();
  Sliding sliding = s.sliding();
  const Target_lengths targets = guessed_lengths(s.lengths);
  Maximization_problem problem(s.complex, samples, s.distance(), targets, s.relations, sliding,
                               Maximization_parameters());
  Quality_maximization(problem, Quality_maximization::Projection::LAST).run(s.points, control, std::numeric_limits<double>::infinity());
}

// Calls test with valid states of the mesh whose vertices were moved at random, those of the boundary a little in every
// second one
template <class Test>
void for_scrambled(const Mesh_family& family, const Test& test)
{
  std::mt19937 random(8);
  int valid = 0;
  for (int trial = 0; trial < 100 && valid < 4; ++trial) {
    SCOPED_TRACE(trial);
    Attached_mesh s(family());
    const double amplitude = .3 / (1 + .1 * trial);
    s.scramble(random, amplitude, false);
    if (trial % 2)
      s.scramble(random, .2 * amplitude, true);
    if (Mesh_quality(s.complex, s.points).invalid > 0)
      continue;
    ++valid;
    test(s);
  }
  EXPECT_EQ(valid, 4);
}

// The most iterations that the second phase takes to be fully tight
std::size_t tightening_iterations(const Maximization_parameters& p)
{
  return static_cast<std::size_t>(std::ceil(-std::log(p.start_tightness) / std::log(p.tightening))) *
         (p.waiting_patience + 1);
}

TEST_P(Quality_maximization_of_families, keeps_a_valid_mesh_valid_and_its_minimum)
{
  for_scrambled(GetParam(), [](Attached_mesh& s) {
    const Mesh_quality before(s.complex, s.points);
    Run_control control;
    run(s, control);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.invalid, 0u);
    EXPECT_GE(after.minimum, before.minimum);
    EXPECT_GT(after.average, before.average);
    EXPECT_GT(control.iterations, 0u);
    const Maximization_parameters p;
    EXPECT_LE(control.iterations, p.climbing_iterations + p.settling_iterations + tightening_iterations(p));
  });
}

TEST_P(Quality_maximization_of_families, leaves_fixed_vertices_alone)
{
  for_scrambled(GetParam(), [](Attached_mesh& s) {
    for (std::size_t v = 0; v < s.points.size(); v += 3)
      s.fix(v);
    const Positions given = s.points;
    const Mesh_quality before(s.complex, given);
    Run_control control;
    run(s, control);
    for (std::size_t v = 0; v < given.size(); ++v)
      if (s.is_fixed[v]) {
        EXPECT_EQ(s.points[v], given[v]) << v;
      }
    EXPECT_NE(s.points, given);
    const Mesh_quality after(s.complex, s.points);
    EXPECT_EQ(after.invalid, 0u);
    EXPECT_GE(after.minimum, before.minimum);
  });
}

TEST_P(Quality_maximization_of_families, leaves_a_fixed_boundary_alone)
{
  for_scrambled(GetParam(), [](Attached_mesh& s) {
    for (std::size_t v = 0; v < s.points.size(); ++v)
      if (s.complex.is_on_boundary[v])
        s.fix(v);
    const Positions given = s.points;
    Run_control control;
    run(s, control);
    for (std::size_t v = 0; v < given.size(); ++v)
      if (s.complex.is_on_boundary[v]) {
        EXPECT_EQ(s.points[v], given[v]) << v;
      }
    EXPECT_EQ(Mesh_quality(s.complex, s.points).invalid, 0u);
    EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, Mesh_quality(s.complex, given).minimum);
  });
}

// It is no untangling
TEST_P(Quality_maximization_of_families, does_nothing_to_a_mesh_with_an_inverted_corner)
{
  Attached_mesh s(GetParam()());
  const Hexahedron& h = s.complex.hexahedra[s.complex.hexahedra.size() / 2];
  std::swap(s.points[h[0]], s.points[h[6]]);
  ASSERT_GT(Mesh_quality(s.complex, s.points).inverted, 0u);
  const Positions given = s.points;
  Run_control control;
  run(s, control);
  EXPECT_EQ(s.points, given);
  EXPECT_EQ(control.iterations, 0u);
}

// The energy reported is finite and the state left is one that was met, whenever the run is stopped
TEST_P(Quality_maximization_of_families, leaves_a_valid_mesh_when_it_is_stopped)
{
  for_scrambled(GetParam(), [](Attached_mesh& s) {
    const Positions given = s.points;
    for (std::size_t last : {1, 2, 5, 20}) {
      s.points = given;
      std::size_t seen = 0;
      Run_control control(std::numeric_limits<double>::infinity(), [&](const HMO::Iteration& iteration) {
        EXPECT_TRUE(std::isfinite(iteration.energy));
        EXPECT_EQ(iteration.number_of_inverted, 0u);
        return ++seen < last;
      });
      run(s, control);
      EXPECT_LE(seen, last);
      EXPECT_EQ(Mesh_quality(s.complex, s.points).invalid, 0u);
    }
  });
}

} // namespace
