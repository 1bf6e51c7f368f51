// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of the boundary against finite differences, and at rest on the reference.

#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>

#include "../Attached_mesh.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

class Boundary_energy_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Boundary_energy_of_families, ::testing::ValuesIn(mesh_families()), Family_name());

// Targets stay where they were found
TEST_P(Boundary_energy_of_families, has_the_gradient_of_its_value)
{
  std::mt19937 random(6);
  for (double bound : {std::numeric_limits<double>::infinity(), .05}) {
    Attached_mesh s(GetParam()());
    s.maximum_deviation = bound;
    Boundary_samples samples = s.samples();
    Boundary_energy energy(samples, s.distance(), s.points.size());
    energy.tightness = .3;
    s.scramble(random, .1, true);
    for (int round = 0; round < 2; ++round) {
      samples.update(s.points, 1);
      s.scramble(random, .02, true);
    }
    Positions gradient(s.points.size(), Vector_3::Zero());
    Block_matrix matrix(vertex_couplings(s.complex));
    matrix.set_zero();
    const double value = energy.add_derivatives(s.points, gradient, matrix);
    EXPECT_NEAR(value, energy.value(s.points), 1e-12 * value);
    double largest = 0;
    for (const Vector_3& g : gradient)
      largest = (std::max)(largest, g.norm());
    EXPECT_GT(largest, 0);
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      if (!s.complex.is_on_boundary[v]) {
        EXPECT_EQ(gradient[v], Vector_3(Vector_3::Zero()));
      }
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix_3>(matrix.diagonal[v]).eigenvalues().minCoeff(),
                -1e-9 * matrix.diagonal[v].norm());
    }
    for (int trial = 0; trial < 20; ++trial) { // along random directions
      const double h = 1e-6;
      Positions plus = s.points, minus = s.points;
      double slope = 0, size = 0;
      for (std::size_t v = 0; v < s.points.size(); ++v) {
        const Vector_3 d = random_vector(random, 1);
        plus[v] += h * d;
        minus[v] -= h * d;
        slope += gradient[v].dot(d);
        size += gradient[v].norm() * d.norm();
      }
      EXPECT_NEAR((energy.value(plus) - energy.value(minus)) / (2 * h), slope, 1e-6 * size);
    }
  }
}

TEST_P(Boundary_energy_of_families, is_at_rest_on_the_reference)
{
  Attached_mesh s(GetParam()());
  s.maximum_deviation = .2;
  Boundary_samples samples = s.samples();
  const Boundary_energy energy(samples, s.distance(), s.points.size());
  samples.update(s.points, 1);
  EXPECT_EQ(samples.excess(s.points), 0);
  const double at_rest = energy.value(s.points);
  Positions moved = s.points;
  for (Vector_3& p : moved)
    p += Vector_3(.5, .5, .5);
  samples.update(moved, 1);
  EXPECT_GT(energy.value(moved), 100 * at_rest);
  EXPECT_GT(samples.excess(moved), .1);
}

} // namespace
