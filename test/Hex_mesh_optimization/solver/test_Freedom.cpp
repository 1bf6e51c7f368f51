// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inverses restricted to the directions in which a point may move.

#include <CGAL/Hex_mesh_optimization/internal/solver/Freedom.h>

#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

struct Case
{
  Freedom freedom;
  Matrix_3 projector; // onto the directions
};

std::vector<Case> cases(std::mt19937& random)
{
  const Vector_3 axis = random_vector(random, 1).normalized();
  const Matrix_3 line = axis * axis.transpose();
  return {{Freedom::nowhere(), Matrix_3::Zero()},
          {Freedom::along_line(axis), line},
          {Freedom::along_plane(axis), Matrix_3::Identity() - line},
          {Freedom::everywhere(), Matrix_3::Identity()}};
}

TEST(Freedom, has_the_dimension_of_its_directions)
{
  std::mt19937 random(1);
  const std::vector<Case> all = cases(random);
  for (int dimension = 0; dimension <= 3; ++dimension)
    EXPECT_EQ(all[dimension].freedom.dimension(), dimension);
}

// With P the projector: X = X P = P X, symmetric, and P D X = P. Together they say X = T (Tᵀ D T)⁻¹ Tᵀ.
TEST(Freedom, inverts_what_is_restricted_to_its_directions)
{
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    Matrix_3 A;
    A << random_vector(random, 1), random_vector(random, 1), random_vector(random, 1);
    const Matrix_3 D = A * A.transpose() + .05 * Matrix_3::Identity();
    for (const Case& c : cases(random)) {
      const Matrix_3 X = c.freedom.inverse(D), &P = c.projector;
      const double tolerance = 1e-11;
      EXPECT_LT((X - X.transpose()).norm(), tolerance);
      EXPECT_LT((X - P * X).norm(), tolerance);
      EXPECT_LT((P * D * X - P).norm(), tolerance);
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Matrix_3>(X).eigenvalues().minCoeff(), -tolerance);
      EXPECT_EQ(Eigen::FullPivLU<Matrix_3>(X).setThreshold(1e-9).rank(), c.freedom.dimension());
    }
  }
}

TEST(Freedom, is_none_along_a_line_without_direction_and_all_along_a_plane_without_normal)
{
  EXPECT_EQ(Freedom::along_line(Vector_3::Zero()).dimension(), 0);
  EXPECT_EQ(Freedom::along_plane(Vector_3::Zero()).dimension(), 3);
}

TEST(Freedom, is_all_but_at_fixed_points)
{
  const Freedoms freedoms = all_but({false, true, false});
  ASSERT_EQ(freedoms.size(), 3u);
  EXPECT_EQ(freedoms[0].dimension(), 3);
  EXPECT_EQ(freedoms[1].dimension(), 0);
  EXPECT_EQ(freedoms[2].dimension(), 3);
}

} // namespace
