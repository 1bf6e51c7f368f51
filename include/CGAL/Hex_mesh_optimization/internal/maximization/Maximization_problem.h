// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PROBLEM_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PROBLEM_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the maximization of quality minimizes, the energies of hexahedra and
// boundary with their weights and target lengths, and one step of Newton's method.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedra_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Sum_of_energies.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/hold_corners.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Target_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Maximization_problem
{
public:
  // Positions are in units of the mean boundary edge; targets are those of the edges, of which what is not certain may
  // be adapted. All but the numbers and the targets must outlive the object. distance: of the samples.
  Maximization_problem(const Hexahedral_complex& its_complex, Boundary_samples& its_samples,
                       const Distance_energy& distance, const Target_lengths& its_targets,
                       const Edge_relations& relations, Sliding& its_sliding,
                       const Maximization_parameters& its_parameters)
    : complex(its_complex)
    , parameters(its_parameters)
    , samples(its_samples)
    , sliding(its_sliding)
    , batches(its_complex)
    , floor(batches, its_parameters.floor)
    , boundary(its_samples, distance, its_complex.number_of_vertices())
    , targets(its_targets)
    , relations_(relations)
    , matrix_(vertex_couplings(its_complex), its_complex.ties)
    , assembly_(its_complex, matrix_)
    , hexahedra_(its_complex, batches, assembly_, floor.floors(), its_targets.lengths, its_parameters.energy)
  {
    // a hexahedron keeps its lengths as closely as the most certain of them
    const double weight = targets.are_asked_for ? parameters.weight_of_lengths_asked_for : 1;
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      double certainty = 0;
      for (int directed : complex.hexahedron_edges[h])
        certainty = (std::max)(certainty, targets.certainty[directed / 2]);
      hexahedra_.set_certainty(h, weight * certainty);
    }
  }

  // Moves the target lengths of the interior towards those that a mesh has found to suit it: smoothly, so that they follow
  // the shape of the model and not of single poor hexahedra.
  void adapt_lengths(const Positions& points)
  {
    const std::vector<double> reached = smooth_edge_lengths(relations_, edge_lengths(complex, points));
    std::vector<double>& lengths = targets.lengths;
    for (std::size_t e = 0; e < lengths.size(); ++e)
      if (!complex.is_boundary_edge[e])
        lengths[e] *= std::pow(reached[e] / lengths[e], (1 - targets.certainty[e]) * parameters.length_adaptation);
    hexahedra_.set_target_lengths(lengths);
  }

  // The factor of both weights of the shape for a mesh with this average scaled Jacobian.
  double balanced_shape(double average) const
  {
    return parameters.shape_balance / (parameters.shape_balance_offset + 1 - average);
  }

  void set_energy(const Hexahedron_energy_parameters& energy) { hexahedra_.set_parameters(energy); }

  // One step of Newton's method, each vertex within its freedom. least: what no corner of each hexahedron drops below;
  // find_more(reached, is_ruined) adds hexahedra that the step would ruin otherwise. Returns the energy.
  template <class Find_more>
  double step(const Batched_values<1>& least, Last_resort last_resort, double relaxation, const Find_more& find_more,
              Positions& points)
  {
    const auto retract = [this](Positions& p) { sliding.retract(p); };
    const auto restrict_step = [&](Positions& direction) {
      hold_corners(
        complex, batches, points, least, parameters.holding_rounds, last_resort, retract,
        [&](const Positions& reached, std::vector<char>& is_ruined) {
          samples.find_leaving(points, reached, complex, is_ruined);
          find_more(reached, is_ruined);
        },
        direction);
    };
    Newton_parameters newton = parameters.newton;
    newton.relaxation = relaxation;
    return newton_step(Sum_of_energies(hexahedra_, boundary), sliding.freedoms(points), restrict_step, retract, newton, matrix_,
                       points);
  }

  // Those that are certified at points, and not where they are reached: their corners may all be good.
  void find_invalidated(const Positions& points, const Positions& reached, std::vector<char>& is_ruined) const
  {
    const auto is_valid = [this](const Positions& p, std::size_t h) {
      return hexahedron_validity(hexahedron_coordinates(p, complex.hexahedra[h])) == Validity::VALID;
    };
    for_each(is_ruined.size(), [&](std::size_t h) {
      if (!is_ruined[h] && !is_valid(reached, h) && is_valid(points, h))
        is_ruined[h] = true;
    });
  }

  // Takes the vertices of hexahedra that find_ruined(points, is_ruined) finds back to the start of a step, until there are
  // none: a part of a step can ruin what all of it does not.
  template <class Find_ruined>
  void take_back(const Positions& start, const Find_ruined& find_ruined, Positions& points) const
  {
    std::vector<char> is_ruined(complex.hexahedra.size()), goes_back(points.size(), false);
    const auto find = [&] {
      std::fill(is_ruined.begin(), is_ruined.end(), false);
      find_ruined(points, is_ruined);
      return std::count(is_ruined.begin(), is_ruined.end(), true) > 0;
    };
    while (find()) {
      for (std::size_t h = 0; h < is_ruined.size(); ++h)
        for (int v : complex.hexahedra[h])
          goes_back[v] = goes_back[v] || is_ruined[h];
      complex.ties.unite(goes_back);
      for (std::size_t v = 0; v < points.size(); ++v)
        if (goes_back[v])
          points[v] = start[v];
    }
  }

  const Hexahedral_complex& complex;
  const Maximization_parameters parameters;
  Boundary_samples& samples;
  Sliding& sliding;
  const Hexahedron_batches batches;
  Quality_floor floor;
  Boundary_energy boundary;
  Target_lengths targets; // of the edges

private:
  const Edge_relations& relations_;
  Block_matrix matrix_;
  const Hexahedron_assembly assembly_;
  Hexahedra_energy hexahedra_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_MAXIMIZATION_PROBLEM_H
