// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse matrix with a block a pair of vertices against a dense one.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>

#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <random>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

// As many rows as take several sweeps at once.
TEST(Block_matrix, solves_large_systems_the_same_whatever_the_number_of_threads)
{
  std::mt19937 random(8);
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{14, 13, 12}}, {{1, 1, 1}});
  const Hexahedral_complex complex = block.complex();
  const int n = static_cast<int>(complex.number_of_vertices());
  Block_matrix matrix(vertex_couplings(complex));
  matrix.set_zero();
  for (const Hexahedron& h : complex.hexahedra)
    for (int k = 0; k < 12; ++k) {
      const int v = h[hexahedron_edges[k][0]], u = h[hexahedron_edges[k][1]];
      matrix.add(v, v, Matrix_3::Identity());
      matrix.add(u, u, Matrix_3::Identity());
      matrix.add(v, u, -Matrix_3::Identity());
    }
  std::vector<char> is_fixed(n, false);
  is_fixed[0] = true; // else all could move by the same vector
  const Freedoms freedoms = all_but(is_fixed);
  Positions x, b(n, Vector_3::Zero()), solution, in_parallel;
  for (int v = 0; v < n; ++v)
    x.push_back(is_fixed[v] ? Vector_3(Vector_3::Zero()) : random_vector(random, 1));
  for (const Hexahedron& h : complex.hexahedra)
    for (int k = 0; k < 12; ++k) {
      const int v = h[hexahedron_edges[k][0]], u = h[hexahedron_edges[k][1]];
      b[v] += x[v] - x[u];
      b[u] += x[u] - x[v];
    }
  int iterations = 0;
  run_concurrently(false, [&] { iterations = matrix.solve(b, freedoms, 1e-6, 1000, solution); });
  run_concurrently(true, [&] { matrix.solve(b, freedoms, 1e-6, 1000, in_parallel); });
  EXPECT_LT(iterations, 60); // rather than in proportion to the number of rows
  EXPECT_EQ(solution, in_parallel);
  for (int v = 0; v < n; ++v)
    EXPECT_LT((solution[v] - x[v]).norm(), 1e-3);
}

// Against the dense system of the leaders. Some that are tied are coupled.
TEST(Block_matrix, with_ties_solves_for_those_that_move_together)
{
  std::mt19937 random(5);
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{3, 2, 2}}, {{1, 1, 1}});
  const Hexahedral_complex complex = block.complex();
  const int n = static_cast<int>(complex.number_of_vertices());
  const Ties ties(n, {{{0, 1}}, {{2, 20}}, {{20, 30}}, {{7, 5}}, {{11, 12}}});
  Block_matrix matrix(vertex_couplings(complex), ties);
  matrix.set_zero();
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(3 * n, 3 * n), A = P;
  const auto add = [&](int i, int j, const Matrix_3& B) {
    matrix.add(i, j, B);
    A.block<3, 3>(3 * i, 3 * j) += B;
    if (i != j)
      A.block<3, 3>(3 * j, 3 * i) += B.transpose();
  };
  for (int v = 0; v < n; ++v)
    add(v, v, Matrix_3::Identity());
  for (const Hexahedron& h : complex.hexahedra)
    for (int k = 0; k < 12; ++k) {
      const int v = h[hexahedron_edges[k][0]], u = h[hexahedron_edges[k][1]];
      Matrix_3 M; // of |v - M u|²
      M << random_vector(random, 1), random_vector(random, 1), random_vector(random, 1);
      add(v, v, Matrix_3::Identity());
      add(u, u, M.transpose() * M);
      add(v, u, -M);
    }
  std::vector<char> is_fixed(n, false);
  is_fixed[0] = is_fixed[1] = is_fixed[9] = true;
  for (int v = 0; v < n; ++v)
    if (!is_fixed[v])
      P.block<3, 3>(3 * v, 3 * ties.leader(v)).setIdentity();
  Positions b, x;
  Eigen::VectorXd dense(3 * n);
  for (int v = 0; v < n; ++v) {
    b.push_back(random_vector(random, 1));
    dense.segment<3>(3 * v) = b[v];
  }
  const Eigen::VectorXd expected =
    P * Eigen::MatrixXd(P.transpose() * A * P).completeOrthogonalDecomposition().solve(P.transpose() * dense);
  matrix.solve(b, all_but(is_fixed), 1e-6, 1000, x);
  for (int v = 0; v < n; ++v) {
    EXPECT_EQ(x[v], x[ties.leader(v)]);
    EXPECT_LT((x[v] - expected.segment<3>(3 * v)).norm(), 1e-4 * expected.norm()) << v;
  }
}

} // namespace
