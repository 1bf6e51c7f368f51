// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_CONJUGATE_GRADIENTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Preconditioned conjugate gradients for any symmetric positive definite system,
// one number or one vector a row.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Conjugate_gradients_parameters
{
  double residual; // ends when rᵀ M⁻¹ r is no more than this, with the residual r and the preconditioner M
  int maximum_iterations;
  // Sums of more rows are taken in ranges of so many, in parallel: the result does not depend on the number of threads.
  std::size_t grain = default_grain;
};

inline double inner_product(double a, double b) { return a * b; }
inline double inner_product(const Vector_3& a, const Vector_3& b) { return a.dot(b); }

// Solves A x = right from x as start. A system offers
//   multiply(x, y): y = A x,
//   precondition(i, r): row i of M⁻¹ r, of which r is the row,
//   is_fixed(i): whether x keeps row i, whatever it is; M⁻¹ is zero there.
// Returns the iterations.
template <class System, class Value>
int conjugate_gradients(const System& system, const std::vector<Value>& right,
                        const Conjugate_gradients_parameters& parameters, std::vector<Value>& x)
{
  const std::size_t n = x.size();
  std::vector<Value> r(n), z(n), d(n), Ad(n);
  system.multiply(x, r);
  double rz = 0;
  for (std::size_t i = 0; i < n; ++i) {
    r[i] = system.is_fixed(i) ? Value(0 * right[i]) : Value(right[i] - r[i]);
    z[i] = system.precondition(i, r[i]);
    d[i] = z[i];
    rz += inner_product(r[i], z[i]);
  }
  int iteration = 0;
  for (; iteration < parameters.maximum_iterations && rz > parameters.residual; ++iteration) {
    system.multiply(d, Ad);
    const double dAd = sum_of_ranges(
      n,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i)
          if (!system.is_fixed(i))
            sum += inner_product(d[i], Ad[i]);
        return sum;
      },
      parameters.grain);
    if (!(dAd > 0))
      break;
    const double step = rz / dAd;
    const double next = sum_of_ranges(
      n,
      [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
          if (system.is_fixed(i))
            continue;
          x[i] += step * d[i];
          r[i] -= step * Ad[i];
          z[i] = system.precondition(i, r[i]);
          sum += inner_product(r[i], z[i]);
        }
        return sum;
      },
      parameters.grain);
    const double ratio = next / rz;
    for_each(
      n, [&](std::size_t i) { d[i] = z[i] + ratio * d[i]; }, parameters.grain);
    rz = next;
  }
  return iteration;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_CONJUGATE_GRADIENTS_H
