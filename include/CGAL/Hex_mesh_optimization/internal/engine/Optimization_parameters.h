// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H

// Everything a caller can choose, with its default.

#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Rectification_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>

#include <cstddef>
#include <functional>
#include <limits>

namespace CGAL::Hex_mesh_optimization {

namespace internal {

struct Optimization_parameters
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
  Feature_parameters features;
  Rectification_parameters rectification;
  Boundary_parameters boundary;
  Untangling_parameters untangling;
  Maximization_parameters maximization;
  Certification_parameters certification; // of the bound of the deviation
  // Rectification leaves it to untangling when no more than this part of the hexahedra is inverted, unless that fails:
  // in a large mesh it takes many iterations for the last ones.
  double left_to_untangling = 1e-4;
  double measuring_spacing = .3; // of the samples that measure the deviation, in mean boundary edges
};

} // namespace internal
} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H
