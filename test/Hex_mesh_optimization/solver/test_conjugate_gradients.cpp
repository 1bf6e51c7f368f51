// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Conjugate gradients on small systems against a dense solver, with rows that are kept.

#include <CGAL/Hex_mesh_optimization/internal/solver/conjugate_gradients.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// A dense positive definite matrix with its diagonal as preconditioner
struct Dense_system
{
  Eigen::MatrixXd matrix;
  std::vector<char> is_kept;

  Dense_system(int n, unsigned int seed) : is_kept(n, false)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(random); });
    matrix = root.transpose() * root + .1 * Eigen::MatrixXd::Identity(n, n);
  }

  template <class Value>
  void multiply(const std::vector<Value>& x, std::vector<Value>& y) const
  {
    for (std::size_t i = 0; i < x.size(); ++i) {
      y[i] = 0 * x[0];
      for (std::size_t j = 0; j < x.size(); ++j)
        y[i] += matrix(i, j) * x[j];
    }
  }

  template <class Value>
  Value precondition(std::size_t i, const Value& r) const
  {
    return (is_kept[i] ? 0 : 1 / matrix(i, i)) * r;
  }

  bool is_fixed(std::size_t i) const { return is_kept[i] != 0; }
};

TEST(Conjugate_gradients, solve_as_a_dense_solver)
{
  for (const int n : {1, 2, 20}) {
    const Dense_system system(n, n);
    std::vector<double> right(n), x(n, .5);
    for (int i = 0; i < n; ++i)
      right[i] = i - 3;
    const int iterations = conjugate_gradients(system, right, {1e-24, 100}, x);
    EXPECT_LE(iterations, n + 20);
    const Eigen::VectorXd expected = system.matrix.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(right.data(), n));
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(x[i], expected[i], 1e-8 * (1 + expected.norm()));
  }
}

TEST(Conjugate_gradients, keep_fixed_rows_and_solve_for_the_others)
{
  const int n = 12;
  Dense_system system(n, 5);
  for (const int i : {0, 4, 11})
    system.is_kept[i] = true;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vector_3(number(random), number(random), number(random)); };
  Positions right, x;
  for (int i = 0; i < n; ++i) {
    right.push_back(vector());
    x.push_back(vector());
  }
  const Positions start = x;
  conjugate_gradients(system, right, {1e-24, 100}, x);
  Positions product(n);
  system.multiply(x, product);
  for (int i = 0; i < n; ++i)
    if (system.is_kept[i])
      EXPECT_EQ(x[i], start[i]);
    else
      EXPECT_LT((product[i] - right[i]).norm(), 1e-9);
}

TEST(Conjugate_gradients, end_at_the_limit_and_at_once_where_nothing_is_left)
{
  const int n = 20;
  const Dense_system system(n, 7);
  std::vector<double> right(n, 1.), x(n, 0.);
  EXPECT_EQ(conjugate_gradients(system, right, {0, 3}, x), 3);
  EXPECT_GT(conjugate_gradients(system, right, {1e-20, 100}, x), 0);
  const std::vector<double> solution = x;
  EXPECT_EQ(conjugate_gradients(system, right, {1e-18, 100}, x), 0);
  EXPECT_EQ(x, solution);
}

} // namespace
