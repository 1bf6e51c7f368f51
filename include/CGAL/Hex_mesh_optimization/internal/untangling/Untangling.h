// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Removes inverted corners, where they are or those that rectification left: the mean ratio of all
// corners, regularized so that it is finite for inverted ones too, is minimized
// while the regularization fades (Garanzha et al., "Foldover-free maps in 50 lines
// of code", 2021), with the boundary loosely attached. Only what is near inverted
// corners takes part.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Sum_of_energies.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Untangling_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Newton_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Untangling_parameters
{
  // ε² = least + factor · min(0, lowest determinant)², as in Garanzha et al. (With a least of 3e-5 to 1e-4, some tens of
  // inverted hexahedra take 5 to 10 iterations instead of 10 to 15, but with 3e-5 and 5e-5 a large organic model ends with an
  // average .0001 lower. With 1e-3 a CAD part is left to rectification.)
  double least_regularization = 1e-6;
  double regularization = .04;
  // Factor of the weights of the attachment.
  double tightness = .02;
  // It ends when no corner is below this: from nearly inverted ones, the maximization of quality climbs slowly, if at
  // all.
  double untangled = .02;
  // Only vertices so many hexahedra around an inverted one move; twice as many after so many iterations without a
  // hexahedron less that is inverted. After so many it gives up, and after the former number where none is left.
  std::size_t rings = 5;
  std::size_t widening_patience = 10;
  std::size_t patience = 30;

  Newton_parameters newton;
};

class Untangling
{
public:
  enum class Attempt { FIRST, LAST };

  // Positions are in units of the mean boundary edge; lengths are the targets of the edges. distance: of the samples.
  // All but the numbers must outlive the object.
  Untangling(const Hexahedral_complex& complex, Boundary_samples& samples, const Distance_energy& distance,
             const std::vector<double>& lengths, const Sliding& sliding, const Untangling_parameters& parameters)
    : complex_(complex)
    , parameters_(parameters)
    , samples_(samples)
    , matrix_(vertex_couplings(complex), complex.ties)
    , assembly_(complex, matrix_)
    , hexahedra_(complex, assembly_, lengths)
    , boundary_(samples, distance, complex.number_of_vertices())
    , sliding_(sliding)
  {
    boundary_.tightness = parameters.tightness;
  }

  // Stops when no corner is inverted or nearly so; leaves in points the state with the fewest inverted hexahedra, and
  // the best worst one if none is inverted. Does nothing if none is inverted or nearly so. A first attempt gives up where a
  // last one widens.
  Stage_end run(Positions& points, Run_control& control, Attempt attempt = Attempt::LAST)
  {
    Mesh_quality quality(complex_, points);
    if (quality.inverted == 0 && quality.minimum >= parameters_.untangled)
      return Stage_end::CONVERGED;
    Best_state best(points, quality, 1, 0);
    std::size_t since = 0, rings = parameters_.rings;
    const auto is_done = [&] {
      return best.inverted() == 0 &&
             (best.highest_minimum() >= parameters_.untangled || since >= parameters_.widening_patience);
    };
    const std::size_t patience = attempt == Attempt::FIRST ? parameters_.widening_patience : parameters_.patience;
    for (std::size_t i = 0; !is_done() && since < patience && !control.is_stopped(); ++i) {
      activate(quality, rings);
      const double lowest = (std::min)(hexahedra_.lowest_determinant(points), 0.0);
      hexahedra_.set_regularization(parameters_.least_regularization + parameters_.regularization * (lowest * lowest));
      samples_.update(points, boundary_.tightness);
      const double energy = newton_step(
        Sum_of_energies(hexahedra_, boundary_), freedoms(points), [](Positions&) {}, [this](Positions& p) { sliding_.retract(p); },
        parameters_.newton, matrix_, points);
      quality = Mesh_quality(complex_, points);
      ++since;
      const std::size_t fewest = best.inverted();
      const double highest = best.highest_minimum();
      best.offer(points, quality);
      if (best.inverted() < fewest || (best.inverted() == 0 && best.highest_minimum() > highest))
        since = 0;
      else if (since % parameters_.widening_patience == 0)
        rings *= 2;
      control.after_iteration(Stage::UNTANGLING, i, energy, points, quality);
    }
    points = best.points();
    return control.stage_end(false);
  }

private:
  Freedoms freedoms(const Positions& points) const
  {
    Freedoms result = sliding_.freedoms(points);
    for (std::size_t v = 0; v < result.size(); ++v)
      if (is_passive_[v])
        result[v] = Freedom::nowhere();
    return result;
  }

  // Vertices of inverted and nearly inverted hexahedra and of so many rings around them may move.
  void activate(const Mesh_quality& quality, std::size_t rings)
  {
    std::vector<int> near; // vertices
    is_passive_.assign(complex_.number_of_vertices(), true);
    const auto add = [&](int h) {
      for (int v : complex_.hexahedra[h])
        if (is_passive_[v]) {
          is_passive_[v] = false;
          near.push_back(v);
        }
    };
    for (std::size_t h = 0; h < quality.scaled_jacobians.size(); ++h)
      if (quality.scaled_jacobians[h] < parameters_.untangled)
        add(static_cast<int>(h));
    for (std::size_t ring = 0, begin = 0; ring < rings; ++ring)
      for (const std::size_t end = near.size(); begin < end; ++begin)
        for (int h : complex_.vertex_hexahedra[near[begin]])
          add(h);
    if (!complex_.ties.is_empty()) {
      std::vector<char> moves(is_passive_.size());
      for (std::size_t v = 0; v < moves.size(); ++v)
        moves[v] = !is_passive_[v];
      complex_.ties.unite(moves);
      for (std::size_t v = 0; v < moves.size(); ++v)
        if (moves[v] && is_passive_[v]) {
          is_passive_[v] = false;
          near.push_back(static_cast<int>(v));
        }
    }
    std::vector<int> active;
    for (int v : near)
      active.insert(active.end(), complex_.vertex_hexahedra[v].begin(), complex_.vertex_hexahedra[v].end());
    std::sort(active.begin(), active.end());
    active.erase(std::unique(active.begin(), active.end()), active.end());
    hexahedra_.set_active(std::move(active));
    std::vector<char> is_active(samples_.faces().size(), false); // faces
    for (std::size_t f = 0; f < is_active.size(); ++f)
      for (int v : samples_.faces()[f])
        is_active[f] = is_active[f] || !is_passive_[v];
    boundary_.set_active(std::move(is_active));
  }

  const Hexahedral_complex& complex_;
  const Untangling_parameters parameters_;
  Boundary_samples& samples_;
  Block_matrix matrix_;
  const Hexahedron_assembly assembly_;
  Untangling_energy hexahedra_;
  Boundary_energy boundary_;
  const Sliding& sliding_;
  std::vector<char> is_passive_; // vertices far from all that is inverted
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H
