// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// All parameters of a run: those that a caller chooses, and those of its parts.

#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Raising_within_bound.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>

namespace CGAL::Hex_mesh_optimization {

namespace internal {

struct Optimization_parameters : Chosen_parameters
{
  Boundary_parameters boundary;
  Untangling_parameters untangling;
  Interior_point_parameters interior_point;
  Maximization_parameters maximization;
  Raising_parameters raising;             // within a bound of the deviation
  Certification_parameters certification; // of that
  // Up to this part of the hexahedra, those that are inverted are untangled where they are, before rectification is tried:
  // most of the mesh tells where they should be (measured on eleven models, of which up to 1.6 % are inverted: maximum
  // deviations of 1.1e-2 and 6.2e-3 of the diagonal become 6.4e-3 and 4.9e-3; where all vertices were scrambled or a part
  // turned, the average may be .03 lower than after rectification).
  double untangled_as_given = .03;
  // Rectification leaves it to untangling when no more than this part of the hexahedra is inverted, unless that fails:
  // in a large mesh it takes many iterations for the last ones.
  double left_to_untangling = 1e-4;
  // A tangled interior is brought to its best within a boundary that allows this minimum, before any of that moves. (The
  // inputs that benchmark/Hex_mesh_optimization/paper_tables.py downloads allow .20, .10, .04, .03 and less, and up to .19 is
  // reached within them; only bunny's allows .57, of which .56 is.)
  double worth_holding_boundary = .3;
  // A mesh that was brought to a reference and whose minimum is above this has quality to spare for the largest deviation:
  // it is bound to the part of what it is, so often, as long as the minimum stays above and the average loses no more
  // than that. sin 120° = .866 is the most where three faces meet on a smooth surface, so that hardly any mesh of an
  // irregular connectivity comes here (measured on cubes that follow a bulge, .926/.991: the maximum is 1.9e-3 of the
  // diagonal at .892/.985 instead of 2.7e-3). A further part costs so many times as much of the minimum as the last one,
  // and is not tried where that is not there (measured on the cubes: with a factor of 1 it is tried in vain, and takes two
  // thirds of the time).
  double spare_above = .85;
  double spared_deviation = .75;
  double spared_average = .01;
  double growth_of_cost = 1.5;
  std::size_t most_spared = 2;
  double measuring_spacing = .3; // of the samples that measure the deviation, in mean boundary edges
};

} // namespace internal
} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_OPTIMIZATION_PARAMETERS_H
