// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_RECTIFICATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_RECTIFICATION_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The numbers of edge-cone rectification, each with its source. Lengths are in
// units of the mean boundary edge; "paper" is Livesu et al. 2015.

#include <CGAL/Hex_mesh_optimization/enum.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization {

namespace internal {

struct Rectification_parameters
{
  // E_Qcone, per base triangle, as in eq. 5, and E_penalty.
  double cone_weight = 1;
  // E_regularize, eq. 19.
  double regularization_weight = 1;
  // α and β of eq. 21. The paper's 20 and 10 leave 2 to 9 times the deviation it publishes; ten times as much
  // reaches it, since the weight of every vertex adapts where that is too stiff.
  double feature_weight = 200;
  double surface_weight = 100;
  // β of eq. 20 (paper).
  double direction_surface_weight = 10;
  // Two unit normals with a sum no longer than this have no average.
  double opposite_normals = 1e-3;
  // The largest angle between axis and base normals, in degrees: ε = cos 85° (paper).
  double cone_angle_bound = 85;
  // σ and the amplitude of eq. 16 (paper).
  double angle_weight_sigma = .3;
  double angle_weight_amplitude = 10;
  // "5 or fewer" suffice (paper).
  int penalty_iterations = 5;
  // Moves below this count as none.
  double convergence = 1e-3;
  // Relative to one unit of length; the next local step changes the system by much more.
  double solver_tolerance = 1e-3;
  int solver_iterations = 300;

  // Local-global iterations between updates of the target lengths; 20 to 25 are what corrupted inputs need (paper).
  std::size_t iterations = 20;
  // Restarts with updated lengths: two leave none inverted where the literal method leaves a few.
  std::size_t restarts = 2;
  Edge_length_update length_update = Edge_length_update::FULL;
  double length_update_sigma = .15; // σ of eq. 24 (paper)
  // A reached length below this part of the mean is no sensible target.
  double least_length = .05;

  // Boundary vertices start with an additional pull to their foot points that stops them from gliding along the
  // surface while the interior is still tangled, and fades by this factor in each iteration.
  double tangential_anchor = 10;
  double tangential_fade = .8;
  // Boundary weights relax where the worst hexahedron around a vertex is below wanted_quality and tighten where it is
  // above by the margin.
  double wanted_quality = .4;
  double wanted_margin = .1;
  double weight_relaxation = .7;
  double weight_tightening = 1.3;
  double least_weight = .02;
  double largest_weight = 5; // stiffer ones gain no accuracy worth the quality they cost

  // In a valid state, a move may not cost a hexahedron below the quality more than this factor; it is halved so often
  // before it is taken back.
  double hold_back_quality = .3;
  double hold_back_loss = .5;
  int hold_back_attempts = 8;

  // Once all hexahedra are valid, samples of the reference farther from the boundary than the tolerance pull it back.
  double reference_spacing = .5;
  double pull_tolerance = .05;
  double pull_weight = 400; // of one unit of area

  // Section 3.6: raise the worst cones once all are valid.
  bool maximize_minimum_quality = true;
  double minimum_quality_step = .01; // ϵ of eq. 26 (paper), read as cos α + ϵ
  double sufficient_quality = .5;    // cones better than this are left alone (paper)
  std::size_t maximization_iterations = 20;
  // It ends when the minimum has not gained so much in so many iterations.
  double maximization_gain = 1e-3;
  std::size_t maximization_patience = 5;

  // A later state with a minimum of no less than this part of the highest one counts as better.
  double accepted_part_of_minimum = .9;
};

} // namespace internal
} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_RECTIFICATION_PARAMETERS_H
