// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PARAMETERS_H

// The numbers of quality maximization. Lengths are in units of the mean boundary edge.

#include <cstddef>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

struct Maximization_parameters
{
  std::size_t iterations = 80;
  // It ends when neither the minimum nor the average has gained this much in so many iterations.
  double least_gain_of_minimum = 2e-3;
  double least_gain_of_average = 2e-4;
  std::size_t patience = 12;
  // Exponent of the norm over the corners of a hexahedron: 4 to 8 lift the worst corner without losing the average.
  double norm_exponent = 8;
  double norm_offset = 1e-3;
  // Weight of −log s, which keeps corners from crossing zero.
  double barrier_weight = .02;
  // Weight of the exterior floor ½ ρ max(0, τ − s)², and how far above the worst corner it stands, at most.
  double floor_weight = 600;
  // It rises no higher than the limit, nor than this part of the hexahedra lies.
  double floor_step = .2;
  double floor_limit = .95;
  double floor_fraction = .1;
  // Weight of the mean ratio relative to the target lengths: without it hexahedra are squashed into slabs, to which the
  // scaled Jacobian is blind.
  double shape_weight = .3;
  // Attachment of the boundary: weight, and scale of the distance over the diagonal of the reference.
  double attachment_weight = .07;
  double attachment_scale = .001;
  double edge_sample_weight = .5;
  // Multipliers of the attachment, one a boundary vertex: relaxed where the worst hexahedron around it is below the
  // floor by relaxed_step and below relaxed_quality, tightened where it is above by the margin.
  double start_multiplier = 1;
  double least_multiplier = .02;
  double largest_multiplier = 2;
  double relaxed_step = .02;
  double relaxed_quality = .66;
  double relaxed_margin = .05;
  double relaxation = .7;
  double tightening = 1.1;
  // A vertex on a feature whose multiplier fell below the first, or which is farther from the feature than the second,
  // leaves the feature: it was a chance crease.
  double demotion_multiplier = .03;
  double demotion_distance = 1;
  // From this deviation on, the poorer a hexahedron must be for its attachment to relax.
  double deviation_budget = .3;
  double pull_tolerance = 0;
  double pull_weight = .5;
  double reference_spacing = .5;
  // Conjugate gradients.
  double solver_tolerance = .1;
  int solver_iterations = 200;
  // Sufficient decrease and least step of the line search.
  double armijo = 1e-4;
  int line_search_steps = 12;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PARAMETERS_H
