// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_CONE_DIRECTION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_CONE_DIRECTION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The convex program of the local step (eq. 9-11, and 20 on the surface): the
// direction in the unit ball that fits the base normals of one cone best while
// it keeps a positive product with each of them.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

namespace cone_direction_detail {

// Minimizes ½ yᵀAy − bᵀy over |y| ≤ radius, A symmetric positive semidefinite of
// order 1 to 3: the multiplier of the ball solves a secular equation that
// decreases and is convex, so that Newton from the left converges.
template <int n>
Eigen::Matrix<double, n, 1> minimize_in_ball(const Eigen::Matrix<double, n, n>& A, const Eigen::Matrix<double, n, 1>& b,
                                             double radius)
{
  using Vector = Eigen::Matrix<double, n, 1>;
  if (radius <= 0)
    return Vector::Zero();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> eigen(A);
  const Vector values = eigen.eigenvalues().cwiseMax(0);
  const Vector c = eigen.eigenvectors().transpose() * b;
  const auto norm_at = [&](double multiplier) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
      if (c[i] != 0)
        sum += c[i] * c[i] / ((values[i] + multiplier) * (values[i] + multiplier));
    return std::sqrt(sum);
  };
  const double scale = c.norm() / radius; // an upper bound of the multiplier
  double multiplier = 0;
  if (!(norm_at(0) <= radius)) {
    double low = 0, high = scale;
    for (int i = 0; i < 100 && high - low > 1e-16 * scale; ++i) {
      multiplier = (low + high) / 2;
      (norm_at(multiplier) > radius ? low : high) = multiplier;
    }
    multiplier = high;
  }
  Vector y = Vector::Zero();
  for (int i = 0; i < n; ++i)
    if (c[i] != 0)
      y[i] = c[i] / (values[i] + multiplier);
  return eigen.eigenvectors() * y;
}

} // namespace cone_direction_detail

struct Cone_direction
{
  Vector_3 direction;
  bool feasible;
};

// Minimizes Σ (x − n_k)² + surface_weight (x·surface_normal)² subject to
// x·n_k ≥ threshold and |x| ≤ 1. At most three half-spaces are tight at the
// minimum: the minimizers over the ball within every intersection of at most
// three of their planes are candidates, the best feasible one is the answer.
// O(k⁴) for k normals, k being the valence of an edge.
inline Cone_direction cone_direction(const std::vector<Vector_3>& normals, double threshold, double surface_weight = 0,
                                     const Vector_3& surface_normal = Vector_3::Zero())
{
  using namespace cone_direction_detail;
  const std::size_t k = normals.size();
  Vector_3 sum = Vector_3::Zero();
  for (const Vector_3& n : normals)
    sum += n;
  const Eigen::Matrix3d A = static_cast<double>(k) * Eigen::Matrix3d::Identity() +
                            surface_weight * surface_normal * surface_normal.transpose();

  Cone_direction best{Vector_3::Zero(), false};
  double best_value = std::numeric_limits<double>::infinity();
  const double slack = 1e-12;
  const auto consider = [&](const Vector_3& x) {
    for (const Vector_3& n : normals)
      if (x.dot(n) < threshold - slack)
        return;
    const double value = 0.5 * x.dot(A * x) - sum.dot(x);
    if (value < best_value) {
      best_value = value;
      best = {x, true};
    }
  };

  consider(minimize_in_ball<3>(A, sum, 1.0));
  if (best.feasible)
    return best; // nothing tight: the minimum over a larger set

  for (std::size_t i = 0; i < k; ++i) {
    const Vector_3& n = normals[i];
    const double length = n.squaredNorm();
    if (length == 0)
      continue;
    const Vector_3 foot = (threshold / length) * n;
    Eigen::Matrix<double, 3, 2> Z;
    Z.col(0) = n.unitOrthogonal();
    Z.col(1) = n.normalized().cross(Z.col(0));
    if (foot.squaredNorm() <= 1)
      consider(foot + Z * minimize_in_ball<2>(Z.transpose() * A * Z, Z.transpose() * (sum - A * foot),
                                              std::sqrt(1 - foot.squaredNorm())));
    for (std::size_t j = 0; j < i; ++j) {
      const Vector_3 axis = n.cross(normals[j]);
      const double sine = axis.squaredNorm();
      if (sine < 1e-20)
        continue;
      // the point of both planes nearest to the origin
      const Vector_3 point = threshold * (normals[j].cross(axis) + axis.cross(n)) / sine;
      if (point.squaredNorm() > 1)
        continue;
      const Eigen::Matrix<double, 3, 1> t = axis / std::sqrt(sine);
      const Eigen::Matrix<double, 1, 1> a(t.dot(A * t)), b(t.dot(sum - A * point));
      consider(point + t * minimize_in_ball<1>(a, b, std::sqrt(1 - point.squaredNorm()))[0]);
      for (std::size_t l = 0; l < j; ++l) {
        const double product = t.dot(normals[l]);
        if (std::abs(product) < 1e-10)
          continue;
        const Vector_3 vertex = point + (threshold - point.dot(normals[l])) / product * t;
        if (vertex.squaredNorm() <= 1 + slack)
          consider(vertex);
      }
    }
  }
  return best;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_CONE_DIRECTION_H
