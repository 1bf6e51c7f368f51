// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The numbers of a step of Newton's method.

namespace CGAL::Hex_mesh_optimization::internal {

struct Newton_parameters
{
  double tolerance = .05; // of the conjugate gradients: the Hessian is a model
  // More gain nothing, even on large meshes: what is left is smooth, and the next step sees it again.
  int iterations = 16;
  // Factor of the step. Where the model is larger than the Hessian, as what is kept positive semi-definite is, steps are
  // too short, and all converge at the rate of the model: above 1 they are over-relaxed.
  double relaxation = 1;
  // Part of the decrease that the slope promises (Armijo), and how often the step is halved to reach it.
  double armijo = 1e-4;
  int line_search_steps = 12;
  // After so many of them in vain it looks for points that are at kinks of what they slide on.
  int steps_between_kinks = 4;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_NEWTON_PARAMETERS_H
