// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHOSEN_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHOSEN_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Everything a caller can choose, with its default. It includes nothing of the stages, so that a caller need not compile them.

#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Rectification_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Chosen_parameters
{
  bool is_parallel = false; // in the threads of the caller's task arena, else in one
  Method method = Method::FULL;
  bool fixed_boundary = false;
  Boundary_placement boundary_placement = Boundary_placement::WITHIN_TOLERANCE;
  double target_quality = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();    // length
  double maximum_running_time = std::numeric_limits<double>::infinity(); // seconds
  Target_edge_lengths target_edge_lengths = Target_edge_lengths::ESTIMATED;
  std::function<double(std::size_t, std::size_t)> target_length; // of the edge between two vertices; empty: see above
  std::function<bool(const Iteration&)> on_iteration;
  std::vector<Interface_reference> interface_references; // for pairs of labels, each once
  Feature_parameters features;
  Rectification_parameters rectification;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHOSEN_PARAMETERS_H
