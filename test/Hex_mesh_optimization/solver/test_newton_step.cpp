// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Steps of Newton's method on energies whose minimizers are known.

#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Points drawn to their targets and, by springs, to the next ones; infinite beyond x = wall
struct Springs
{
  Positions targets;
  double wall = std::numeric_limits<double>::infinity();

  double value(const Positions& points) const
  {
    double sum = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points[v].x() > wall)
        return std::numeric_limits<double>::infinity();
      sum += (points[v] - targets[v]).squaredNorm() / 2;
      if (v > 0)
        sum += (points[v] - points[v - 1]).squaredNorm() / 2;
    }
    return sum;
  }

  double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    for (int v = 0; v < static_cast<int>(points.size()); ++v) {
      gradient[v] += points[v] - targets[v];
      matrix.add(v, v, Matrix_3::Identity());
      if (v > 0) {
        const Vector_3 d = points[v] - points[v - 1];
        gradient[v] += d;
        gradient[v - 1] -= d;
        matrix.add(v, v, Matrix_3::Identity());
        matrix.add(v - 1, v - 1, Matrix_3::Identity());
        matrix.add(v, v - 1, -Matrix_3::Identity());
      }
    }
    return value(points);
  }
};

const int n = 6;

Block_matrix chain_matrix()
{
  std::vector<int> row, column;
  for (int v = 1; v < n; ++v) {
    row.insert(row.end(), {v, v - 1});
    column.insert(column.end(), {v - 1, v});
  }
  return Block_matrix(Grouped_array(
    n, row.size(), [&](std::size_t i) { return row[i]; }, [&](std::size_t i) { return column[i]; }));
}

Positions some_targets()
{
  Positions result;
  for (int v = 0; v < n; ++v)
    result.emplace_back(v, v * v % 5, 1);
  return result;
}

const Freedoms everywhere(n, Freedom::everywhere());
const auto unrestricted = [](Positions&) {};
const auto not_retracted = unrestricted;

TEST(Newton_step, reaches_the_minimum_of_a_quadratic_energy_at_once)
{
  const Springs energy{some_targets()};
  Newton_parameters parameters;
  parameters.tolerance = 1e-6;
  Block_matrix matrix = chain_matrix();
  Positions points(n, Vector_3(-1, 2, 0));
  const double reached = newton_step(energy, everywhere, unrestricted, not_retracted, parameters, matrix, points);
  EXPECT_EQ(reached, energy.value(points));
  Positions gradient(n, Vector_3::Zero());
  energy.add_derivatives(points, gradient, matrix);
  for (const Vector_3& g : gradient)
    EXPECT_LT(g.norm(), 1e-5);
}

TEST(Newton_step, goes_beyond_the_minimum_of_the_model_where_it_is_over_relaxed)
{
  const Springs energy{some_targets()};
  Newton_parameters parameters;
  parameters.tolerance = 1e-9;
  Block_matrix matrix = chain_matrix();
  const Positions start(n, Vector_3(-1, 2, 0));
  Positions minimum = start, points = start;
  newton_step(energy, everywhere, unrestricted, not_retracted, parameters, matrix, minimum);
  parameters.relaxation = 1.5;
  Positions restricted;
  newton_step(
    energy, everywhere, [&](Positions& step) { restricted = step; }, not_retracted, parameters, matrix, points);
  for (int v = 0; v < n; ++v) {
    EXPECT_LT((points[v] - start[v] - 1.5 * (minimum[v] - start[v])).norm(), 1e-6) << v;
    EXPECT_LT((points[v] - start[v] - restricted[v]).norm(), 1e-12) << v; // what restricts sees all of the step
  }
}

TEST(Newton_step, leaves_fixed_points_and_restricted_ones)
{
  const Springs energy{some_targets()};
  Block_matrix matrix = chain_matrix();
  const Positions start(n, Vector_3(-1, 2, 0));
  Positions points = start;
  std::vector<char> is_fixed(n, false);
  is_fixed[2] = true;
  newton_step(
    energy, all_but(is_fixed), [](Positions& step) { step[4] = Vector_3::Zero(); },
    not_retracted, Newton_parameters(), matrix, points);
  for (int v = 0; v < n; ++v)
    EXPECT_EQ(points[v] == start[v], v == 2 || v == 4) << v;
}

// On lines and planes the minimizer is the one among the points that may be reached.
TEST(Newton_step, keeps_to_the_freedom_of_each_point)
{
  const Springs energy{some_targets()};
  Newton_parameters parameters;
  parameters.tolerance = 1e-6;
  Block_matrix matrix = chain_matrix();
  const Positions start(n, Vector_3(-1, 2, 0));
  Positions points = start;
  const Vector_3 direction = Vector_3(1, 2, 2) / 3, normal = Vector_3(2, -1, 2) / 3;
  Freedoms freedoms(n, Freedom::everywhere());
  freedoms[1] = Freedom::along_line(direction);
  freedoms[3] = Freedom::along_plane(normal);
  freedoms[4] = Freedom::nowhere();
  newton_step(
    energy, freedoms, unrestricted, not_retracted, parameters, matrix, points);
  EXPECT_LT((points[1] - start[1]).cross(direction).norm(), 1e-5);
  EXPECT_LT(std::abs((points[3] - start[3]).dot(normal)), 1e-5);
  EXPECT_EQ(points[4], start[4]);
  Positions gradient(n, Vector_3::Zero());
  energy.add_derivatives(points, gradient, matrix);
  EXPECT_LT(std::abs(gradient[1].dot(direction)), 1e-5);
  EXPECT_GT(gradient[1].norm(), .1);
  EXPECT_LT(gradient[3].cross(normal).norm(), 1e-5);
  for (int v : {0, 2, 5})
    EXPECT_LT(gradient[v].norm(), 1e-5);
}

// The energy that counts is the one of the points taken back.
TEST(Newton_step, ends_where_points_are_retracted_to)
{
  const Springs energy{some_targets()};
  Block_matrix matrix = chain_matrix();
  Positions points(n, Vector_3(-1, 2, 0));
  const auto to_plane = [](Positions& p) { p[2].z() = 0; };
  const double reached = newton_step(energy, everywhere, unrestricted, to_plane, Newton_parameters(), matrix, points);
  EXPECT_EQ(points[2].z(), 0);
  EXPECT_EQ(reached, energy.value(points));
}

// On a roof whose ridge it is on, a point loses on either side, however short the step: it stays, and the others go on,
// within what steps are restricted to.
TEST(Newton_step, stops_a_point_at_a_kink_and_no_other)
{
  const Springs energy{some_targets()};
  Block_matrix matrix = chain_matrix();
  const Positions start(n, Vector_3::Zero());
  Positions points = start;
  Freedoms freedoms(n, Freedom::everywhere());
  freedoms[2] = Freedom::along_line(Vector_3::UnitX());
  const auto to_roof = [](Positions& p) { p[2].z() = -10 * std::abs(p[2].x()); };
  const double reached = newton_step(
    energy, freedoms,
    [](Positions& step) {
      if (step[2].isZero(0)) // without it, the step of another one is too long
        step[5] /= 2;
    },
    to_roof, Newton_parameters(), matrix, points);
  EXPECT_LT(reached, energy.value(start));
  EXPECT_EQ(reached, energy.value(points));
  for (int v = 0; v < n; ++v)
    EXPECT_EQ(points[v] == start[v], v == 2) << v;

  Positions whole = start;
  const double reached_by_whole = newton_step(
    energy, freedoms, unrestricted, to_roof, Newton_parameters(), matrix, whole);
  EXPECT_LT(reached_by_whole, .5 * energy.value(start));
  EXPECT_NEAR(points[5].norm(), whole[5].norm() / 2, 1e-6 * whole[5].norm());
}

TEST(Newton_step, is_shortened_where_the_energy_is_not_defined)
{
  const Springs energy{some_targets(), .5};
  Block_matrix matrix = chain_matrix();
  Positions points(n, Vector_3(0, 0, 0));
  const double before = energy.value(points);
  EXPECT_LT(newton_step(energy, everywhere, unrestricted, not_retracted, Newton_parameters(), matrix, points), before);
  for (const Vector_3& p : points)
    EXPECT_LE(p.x(), .5);
}

} // namespace
