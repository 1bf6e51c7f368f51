// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_STEP_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_STEP_H

#include <CGAL/license/Hex_mesh_optimization.h>

// One step of Newton's method with line search on an energy of all vertices.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Freedom.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Newton_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Stops those points that lose more by being taken back to what they slide on than they gain on their way: where that has
// a kink, retract() takes them aside in proportion to the step, however short it is. Returns whether there were any.
inline bool stop_at_kinks(const Positions& points, const Positions& reached, double t,
                          const Positions& negative_gradient, const Ties& ties, Positions& direction)
{
  const double least_bend = 1e-3; // of the step: less is rounding, or smooth
  std::vector<char> is_stopped(points.size(), false);
  bool are_some_stopped = false;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Vector_3 step = t * direction[v], bend = reached[v] - points[v] - step;
    if (bend.squaredNorm() > least_bend * least_bend * step.squaredNorm() &&
        negative_gradient[v].dot(bend) < -std::abs(negative_gradient[v].dot(step)))
      is_stopped[v] = are_some_stopped = true;
  }
  ties.unite(is_stopped);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (is_stopped[v])
      direction[v].setZero();
  return are_some_stopped;
}

// An energy is a class with
//   double value(const Positions& points) const,
//     which may be infinite where the energy is not defined, and
//   double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const,
//     which adds its gradient and a positive semi-definite model of its Hessian, where it is finite, and returns its value.
//
// Moves the points, each within its freedom. restrict_step(direction) may shorten the steps of single points; retract(points) takes those that slide on something
// curved back onto it. Returns the energy reached.
template <class Energy, class Restrict, class Retract>
double newton_step(const Energy& energy, const Freedoms& freedoms, const Restrict& restrict_step,
                   const Retract& retract, const Newton_parameters& parameters, Block_matrix& matrix, Positions& points)
{
  Positions gradient(points.size(), Vector_3::Zero()), direction;
  matrix.set_zero();
  const double start = energy.add_derivatives(points, gradient, matrix);
  for_each(points.size(), [&](std::size_t v) { gradient[v] = -gradient[v]; });
  matrix.solve(gradient, freedoms, parameters.tolerance, parameters.iterations, direction);
  for_each(points.size(), [&](std::size_t v) { direction[v] *= parameters.relaxation; });
  restrict_step(direction);
  const auto slope_of_direction = [&] {
    return -sum_of_ranges(points.size(), [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t v = begin; v < end; ++v)
        sum += gradient[v].dot(direction[v]);
      return sum;
    });
  };
  double slope = slope_of_direction();
  Positions trial(points.size());
  double t = 1;
  for (int i = 1; i <= parameters.line_search_steps; ++i) {
    for_each(points.size(), [&](std::size_t v) { trial[v] = points[v] + t * direction[v]; });
    retract(trial);
    const double reached = energy.value(trial);
    if (reached <= start + parameters.armijo * t * slope) {
      points.swap(trial);
      return reached;
    }
    t /= 2;
    if (i % parameters.steps_between_kinks == 0 &&
        stop_at_kinks(points, trial, 2 * t, gradient, matrix.ties(), direction)) {
      // one such point would keep all others where they are; but what is left may be too much for what is around it
      restrict_step(direction);
      slope = slope_of_direction();
      t = 1;
    }
  }
  return start;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_STEP_H
