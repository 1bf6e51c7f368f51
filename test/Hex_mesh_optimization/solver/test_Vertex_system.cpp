// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse system with one number a vertex against a dense one.

#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Global_step.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../numerical_gradient.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

struct Random_system
{
  static constexpr std::size_t n = 12;
  Vertex_system system;
  Eigen::MatrixXd A;
  Eigen::VectorXd b;

  explicit Random_system(unsigned int seed)
    : system(n, {{{0, 1}},
                 {{0, 2}},
                 {{1, 2}},
                 {{2, 3}},
                 {{3, 4}},
                 {{3, 7}},
                 {{4, 5}},
                 {{0, 5}},
                 {{5, 6}},
                 {{6, 7}},
                 {{7, 8}},
                 {{1, 8}},
                 {{8, 9}},
                 {{9, 10}},
                 {{10, 11}},
                 {{2, 11}},
                 {{0, 1}},
                 {{3, 4}}})
    , A(Eigen::MatrixXd::Zero(3 * n, 3 * n))
    , b(3 * n)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(.1, 2);
    const std::array<int, 2> pairs[] = {{{0, 1}}, {{0, 2}},  {{1, 2}},   {{2, 3}}, {{3, 4}}, {{3, 7}},
                                        {{4, 5}}, {{0, 5}},  {{5, 6}},   {{6, 7}}, {{7, 8}}, {{1, 8}},
                                        {{8, 9}}, {{9, 10}}, {{10, 11}}, {{2, 11}}};
    for (const auto& p : pairs) {
      const double w = uniform(random);
      for (int end = 0; end < 2; ++end) {
        system.diagonal[p[end]] += w;
        system.couplings()[system.slot(p[end], p[1 - end])] -= w;
        for (int d = 0; d < 3; ++d) {
          A(3 * p[end] + d, 3 * p[end] + d) += w;
          A(3 * p[end] + d, 3 * p[1 - end] + d) -= w;
        }
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      system.right[v] = random_vector(random, 3);
      b.segment<3>(3 * v) = system.right[v];
      if (v % 3)
        continue;
      const Vector_3 normal = random_vector(random, 1).normalized();
      system.blocks[v] = 5 * normal * normal.transpose() + .5 * Matrix_3::Identity();
      A.block<3, 3>(3 * v, 3 * v) += system.blocks[v];
    }
  }
};

TEST(Vertex_system, has_the_energy_and_gradient_of_its_matrix)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Random_system s(seed);
    std::mt19937 random(seed + 10);
    const Positions points = moved(Positions(s.n, Vector_3::Zero()), random, 2);
    const Eigen::VectorXd x = flat(points);
    EXPECT_NEAR(s.system.energy(points), x.dot(s.A * x) - 2 * s.b.dot(x), 1e-10);
    const Eigen::VectorXd difference = gradient([&](const Positions& p) { return s.system.energy(p); }, points) -
                                       2 * (s.A * x - s.b);
    EXPECT_LT(difference.norm(), 1e-8);
  }
}

TEST(Vertex_system, is_solved_as_a_dense_system)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Random_system s(seed);
    Positions points(s.n, Vector_3::Zero());
    const int iterations = s.system.solve(points, 1e-13, 1000);
    EXPECT_GT(iterations, 0);
    EXPECT_LE(iterations, 3 * int(s.n) + 5);
    EXPECT_LT((flat(points) - s.A.ldlt().solve(s.b)).norm(), 1e-9);
    EXPECT_EQ(s.system.solve(points, 1e-6, 1000), 0) << "started at the solution";
  }
}

TEST(Vertex_system, keeps_fixed_rows_and_solves_for_the_others)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    Random_system s(seed);
    std::mt19937 random(seed);
    const Positions start = moved(Positions(s.n, Vector_3::Zero()), random, 2);
    Positions points = start;
    std::vector<int> free;
    for (std::size_t v = 0; v < s.n; ++v)
      if (v % 4 == 1)
        s.system.is_fixed[v] = true;
      else
        free.push_back(static_cast<int>(v));
    s.system.solve(points, 1e-13, 1000);
    const Eigen::VectorXd residual = s.A * flat(points) - s.b;
    for (std::size_t v = 0; v < s.n; ++v)
      if (s.system.is_fixed[v])
        EXPECT_EQ(points[v], start[v]);
      else
        EXPECT_LT(residual.segment<3>(3 * v).norm(), 1e-9);
  }
}

// From a start whose differences stay: the minimizer among all that have them
TEST(Vertex_system, with_ties_keeps_differences_and_solves_for_the_rest)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    Random_system s(seed);
    s.system.ties = Ties(s.n, {{{3, 9}}, {{11, 9}}, {{4, 10}}, {{0, 1}}});
    s.system.is_fixed[4] = s.system.is_fixed[10] = true;
    std::mt19937 random(seed);
    const Positions start = moved(Positions(s.n, Vector_3::Zero()), random, 2);
    Positions points = start;
    EXPECT_GT(s.system.solve(points, 1e-13, 1000), 0);
    std::vector<Vector_3> force_on(s.n, Vector_3::Zero()); // by the leaders
    const Eigen::VectorXd residual = s.A * flat(points) - s.b;
    for (std::size_t v = 0; v < s.n; ++v) {
      const int leader = s.system.ties.leader(int(v));
      EXPECT_LT(((points[v] - start[v]) - (points[leader] - start[leader])).norm(), 1e-12);
      force_on[leader] += residual.segment<3>(3 * v);
    }
    for (std::size_t v = 0; v < s.n; ++v)
      if (s.system.is_fixed[v])
        EXPECT_EQ(points[v], start[v]);
      else
        EXPECT_LT(force_on[v].norm(), 1e-9) << v;
  }
}

TEST(Vertex_system, honors_the_limit_of_iterations)
{
  const Random_system s(1);
  Positions points(s.n, Vector_3::Zero());
  EXPECT_EQ(s.system.solve(points, 1e-13, 3), 3);
  EXPECT_LT(s.system.energy(points), 0) << "three steps downhill from zero";
}

} // namespace
