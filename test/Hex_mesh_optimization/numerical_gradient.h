// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_NUMERICAL_GRADIENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_NUMERICAL_GRADIENT_H

// The gradient of a function of positions by differences.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <Eigen/Dense>

#include <cstddef>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

// All positions as 3 n numbers.
inline Eigen::VectorXd flat(const Positions& points)
{
  Eigen::VectorXd x(3 * points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    x.segment<3>(3 * v) = points[v];
  return x;
}

// Exact for quadratic functions, up to rounding
template <class Energy>
Eigen::VectorXd gradient(const Energy& energy, const Positions& points)
{
  const double h = 1e-2;
  Eigen::VectorXd result(3 * points.size());
  Positions p = points;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    double& x = p[i / 3][i % 3];
    const double at = x;
    x = at + h;
    const double after = energy(p);
    x = at - h;
    const double before = energy(p);
    x = at;
    result[i] = (after - before) / (2 * h);
  }
  return result;
}

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_NUMERICAL_GRADIENT_H
