// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_INTERIOR_POINT_MAXIMIZATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_INTERIOR_POINT_MAXIMIZATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Raises the quality of a feasible mesh by feasible steps: none loses the minimum,
// validity, a bound, or a place that is to be kept. An interior-point method.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_problem.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Progress.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Interior_point_maximization
{
public:
  // problem must outlive the object.
  Interior_point_maximization(Maximization_problem& problem, const Interior_point_parameters& parameters)
    : problem_(problem)
    , parameters_(parameters)
    , barrier_(parameters.first_weight)
  {}

  // Improves points until the average does not rise any more, for the most iterations, or until control ends the run. Does
  // nothing to a mesh that is not valid. Every state on the way is at least as good as the one before.
  Stage_end run(Positions& points, Run_control& control, double target_quality)
  {
    Mesh_quality quality(problem_.complex, points);
    if (quality.invalid > 0 || quality.minimum >= target_quality)
      return Stage_end::CONVERGED;
    problem_.samples.restore_walls();
    problem_.samples.update(points, 1);
    problem_.adapt_lengths(points);
    const double shape = parameters_.shape * problem_.balanced_shape(quality.average);
    const Maximization_parameters& p = problem_.parameters; // it ends as the second phase of the other method does
    Progress progress(quality, p.least_gain_of_minimum, p.least_change_of_average);
    std::size_t i = 0;
    for (; i < parameters_.iterations && !control.is_stopped() &&
           progress.iterations_without_change_of_average() < p.patience;
         ++i) {
      set_energy(shape);
      barrier_ = (std::max)(parameters_.weight, parameters_.decrease * barrier_);
      problem_.floor.stand_at(quality.minimum - parameters_.gap + parameters_.width);
      problem_.samples.update(points, 1);
      const double energy = step(quality, points);
      quality = Mesh_quality(problem_.complex, points);
      progress.add(quality);
      control.after_iteration(Stage::MAXIMIZATION, i, energy, points, quality);
      if (quality.minimum >= target_quality)
        break;
    }
    return control.stage_end(i == parameters_.iterations);
  }

private:
  void set_energy(double shape)
  {
    Hexahedron_energy_parameters energy = problem_.parameters.energy;
    energy.shape_weight *= shape;
    energy.poor_shape_weight *= shape;
    energy.certain_shape_weight *= parameters_.certain_shape;
    energy.floor_weight = barrier_;
    energy.interior_width = parameters_.width;
    problem_.set_energy(energy);
  }

  double step(const Mesh_quality& quality, Positions& points)
  {
    // corners are told apart in single precision first, and exactly where that is close
    const double rounding = 1e-6;
    const auto least = [&](std::size_t h) { return (std::min)(quality.minimum, quality.scaled_jacobians[h]); };
    Batched_values<1> rounded(quality.scaled_jacobians.size());
    for (std::size_t h = 0; h < quality.scaled_jacobians.size(); ++h)
      rounded.set(h, 0, least(h) - rounding);
    const Positions start = points;
    const auto find_ruined = [&](const Positions& reached, std::vector<char>& is_ruined) {
      for_each(is_ruined.size(), [&](std::size_t h) {
        is_ruined[h] = is_ruined[h] ||
                       scaled_jacobian(hexahedron_coordinates(reached, problem_.complex.hexahedra[h])) < least(h);
      });
      problem_.find_invalidated(start, reached, is_ruined);
    };
    const double energy = problem_.step(rounded, Last_resort::UNTIL_NONE_IS_RUINED, 1, find_ruined, points);
    problem_.take_back(start, find_ruined, points);
    return energy;
  }

  Maximization_problem& problem_;
  const Interior_point_parameters parameters_;
  double barrier_; // the weight that has been reached, in a run before too
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_INTERIOR_POINT_MAXIMIZATION_H
