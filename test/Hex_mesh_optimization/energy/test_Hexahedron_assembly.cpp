// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The derivatives of a hexahedron reach the rows of its vertices.

#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../Corner.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Vertices in any order, so that blocks stand on either side of the diagonal
Hexahedral_complex shuffled_complex(const Indexed_mesh& mesh, std::mt19937& random)
{
  std::vector<int> number(mesh.points.size());
  for (std::size_t v = 0; v < number.size(); ++v)
    number[v] = static_cast<int>(v);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Hexahedron> hexahedra;
  for (const auto& h : mesh.hexahedra) {
    hexahedra.emplace_back();
    for (int i = 0; i < 8; ++i)
      hexahedra.back()[i] = number[h[i]];
  }
  return Hexahedral_complex(number.size(), hexahedra);
}

// Positive definite; opposite corners of a hexahedron are not coupled
Eigen::Matrix<double, 24, 24> random_matrix(std::mt19937& random)
{
  Eigen::Matrix<double, 24, 24> A = Eigen::Matrix<double, 24, 24>::Identity();
  for (const auto& face : hexahedron_faces) {
    const Eigen::Matrix<double, 12, 12> R = Eigen::Matrix<double, 12, 12>::NullaryExpr(
      [&] { return uniform(random, -1, 1); });
    const Eigen::Matrix<double, 12, 12> S = R.transpose() * R;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        A.block<3, 3>(3 * face[i], 3 * face[j]) += S.block<3, 3>(3 * i, 3 * j);
  }
  return A;
}

TEST(Hexahedron_assembly, adds_a_hexahedron_as_the_matrix_adds_its_blocks)
{
  std::mt19937 random(5);
  for (const Mesh_family& family : mesh_families()) {
    SCOPED_TRACE(family.name);
    const Hexahedral_complex complex = shuffled_complex(family(), random);
    const int n = static_cast<int>(complex.number_of_vertices());
    Block_matrix whole(vertex_couplings(complex)), one_by_one(vertex_couplings(complex));
    const Hexahedron_assembly assembly(complex, whole);
    Positions gradient(n, Vector_3::Zero()), expected_gradient = gradient;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (Block_matrix* matrix : {&whole, &one_by_one})
      matrix->set_zero();
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      const Eigen::Matrix<double, 24, 24> A = random_matrix(random);
      Hexahedron_derivatives<double> derivatives;
      derivatives.set_zero();
      for (int i = 0; i < 8; ++i)
        for (int j = i; j < 8; ++j) {
          const Matrix_3 B = A.block<3, 3>(3 * i, 3 * j);
          const int v = complex.hexahedra[h][i], u = complex.hexahedra[h][j], k = hexahedron_couplings.of[i][j];
          if (i != j && k < 0) {
            EXPECT_TRUE(B.isZero());
            continue;
          }
          int entry = 0;
          for (int a = 0; a < 3; ++a)
            for (int b = i == j ? a : 0; b < 3; ++b)
              (i == j ? derivatives.diagonal[i] : derivatives.coupling[k])[entry++] = B(a, b);
          one_by_one.add(v, u, B);
          dense.block<3, 3>(3 * v, 3 * u) += B;
          if (i != j)
            dense.block<3, 3>(3 * u, 3 * v) += B.transpose();
        }
      for (int i = 0; i < 8; ++i)
        for (int a = 0; a < 3; ++a)
          expected_gradient[complex.hexahedra[h][i]][a] += derivatives.gradient[i][a] = uniform(random, -1, 1);
      assembly.add(h, derivatives, 0, gradient, whole);
    }
    EXPECT_EQ(gradient, expected_gradient);
    std::vector<char> is_fixed(n);
    for (int v = 0; v < n; ++v)
      is_fixed[v] = v % 7 == 3;
    Positions b, x, y;
    for (int v = 0; v < n; ++v)
      b.push_back(random_vector(random, 1));
    whole.solve(b, all_but(is_fixed), 1e-6, 10000, x);
    one_by_one.solve(b, all_but(is_fixed), 1e-6, 10000, y);
    EXPECT_EQ(whole.diagonal, one_by_one.diagonal);
    EXPECT_EQ(x, y);

    // and it is the matrix that was meant
    Eigen::VectorXd solution(3 * n);
    for (int v = 0; v < n; ++v)
      solution.segment<3>(3 * v) = x[v];
    const Eigen::VectorXd product = dense * solution;
    for (int v = 0; v < n; ++v)
      if (is_fixed[v]) {
        EXPECT_EQ(x[v], Vector_3(Vector_3::Zero()));
      }
      else {
        EXPECT_LT((product.segment<3>(3 * v) - b[v]).norm(), 1e-3);
      }
  }
}

} // namespace
