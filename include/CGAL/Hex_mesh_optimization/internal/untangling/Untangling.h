// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H

// Removes the inverted corners that rectification left: the mean ratio of all
// corners, regularized so that it is finite for inverted ones too, is minimized
// while the regularization fades (Garanzha et al., "Foldover-free maps in 50 lines
// of code", 2021), with the boundary loosely attached. Only what is near inverted
// corners takes part.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// The mean ratio with χ = ½ (D + √(ε² + D²)) in the place of D = det / l_0 l_1 l_2: itself at ε = 0, D > 0.
struct Regularized_mean_ratio
{
  double r[3], squares; // |e_i|²/l_i² and their sum
  double volume;        // |e_0| |e_1| |e_2| / l_0 l_1 l_2
  double chi, chi_slope; // χ and dχ/dD

  Regularized_mean_ratio(const Edge_ratios<double>& ratios, int corner, double scaled_jacobian, double squared_epsilon)
  {
    for (int k = 0; k < 3; ++k)
      r[k] = ratios.square[corner_edges[corner][k] / 2];
    squares = r[0] + r[1] + r[2];
    volume = std::sqrt(r[0]) * std::sqrt(r[1]) * std::sqrt(r[2]);
    const double D = volume * scaled_jacobian, root = std::sqrt(squared_epsilon + D * D);
    // the difference of nearly equal numbers, where D < 0
    chi = D > 0 ? (D + root) / 2 : squared_epsilon / (2 * (root - D));
    chi_slope = chi / root;
  }

  double value() const { return squares / 3 / std::cbrt(chi * chi); }

  // As that of the mean ratio, with χ in the place of the determinant.
  Corner_quadratic<double> model(const Corner_frame<double>& corner) const
  {
    const double m = value();
    return Corner_quadratic<double>(corner, chi_slope * volume / chi, r, 0, 0, m, 3 * m / squares, 0, 0, 0);
  }
};

class Untangling
{
public:
  // As for Quality_maximization.
  Untangling(const Hexahedral_complex& complex, Surface_attachment& attachment, const std::vector<double>& lengths,
             const std::vector<char>& is_fixed, const Maximization_parameters& parameters)
    : complex_(complex)
    , parameters_(parameters)
    , attachment_(attachment)
    , matrix_(vertex_couplings(complex))
    , assembly_(complex, matrix_)
    , lengths_(lengths)
    , is_fixed_(is_fixed)
  {}

  // Stops when no corner is inverted or nearly so; leaves in points the state with the fewest inverted hexahedra, and the
  // best worst one if none is inverted. Does nothing if none is.
  void run(Positions& points, Run_control& control)
  {
    Mesh_quality quality(complex_, points);
    if (quality.inverted == 0)
      return;
    Positions best = points;
    std::size_t fewest = quality.inverted, since = 0, rings = parameters_.untangling_rings;
    double minimum = quality.minimum;
    attachment_.tightness = parameters_.start_tightness;
    const auto is_done = [&] {
      return fewest == 0 && (minimum >= parameters_.untangled || since >= parameters_.widening_patience);
    };
    for (std::size_t i = 0; !is_done() && since < parameters_.untangling_patience && !control.is_stopped(); ++i) {
      activate(quality, rings);
      const double lowest = lowest_determinant(points);
      squared_epsilon_ = parameters_.least_regularization + parameters_.regularization * std::pow((std::min)(lowest, 0.0), 2);
      attachment_.update(points);
      const double energy = newton_step([this](const Positions& p) { return value(p); },
                                        [this](const Positions& p, Positions& g, Block_matrix& m) { assemble(p, g, m); },
                                        [](Positions&) {},
                                        is_passive_, parameters_.newton, matrix_, points);
      quality = Mesh_quality(complex_, points);
      ++since;
      if (quality.inverted < fewest || (quality.inverted == 0 && quality.minimum > minimum)) {
        fewest = quality.inverted;
        minimum = quality.minimum;
        best = points;
        since = 0;
      }
      if (since > 0 && since % parameters_.widening_patience == 0)
        rings *= 2;
      control.after_iteration(Stage::UNTANGLING, i, energy, quality);
    }
    points = std::move(best);
  }

private:
  // Vertices of inverted and nearly inverted hexahedra and of so many rings around them may move.
  void activate(const Mesh_quality& quality, std::size_t rings)
  {
    std::vector<int> near; // vertices
    is_passive_.assign(is_fixed_.size(), true);
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
    active_.clear();
    for (int v : near)
      active_.insert(active_.end(), complex_.vertex_hexahedra[v].begin(), complex_.vertex_hexahedra[v].end());
    std::sort(active_.begin(), active_.end());
    active_.erase(std::unique(active_.begin(), active_.end()), active_.end());
    for (std::size_t v = 0; v < is_fixed_.size(); ++v)
      is_passive_[v] = is_passive_[v] || is_fixed_[v];
  }

  // Calls visit(h, frame, ratios) for every active hexahedron h. In double: nothing bounds what comes in tangled.
  template <class Visit>
  void for_hexahedra(const Positions& points, const Visit& visit) const
  {
    for (int h : active_) {
      double vectors[12][3], inverse_targets[12];
      edge_vectors(points, complex_.hexahedra[h], vectors);
      for (int k = 0; k < 12; ++k)
        inverse_targets[k] = 1 / lengths_[complex_.hexahedron_edges[h][k] / 2];
      const Hexahedron_frame<double> frame(vectors);
      visit(h, frame, Edge_ratios<double>(frame, inverse_targets));
    }
  }

  double lowest_determinant(const Positions& points) const
  {
    double lowest = 1;
    for_hexahedra(points, [&](std::size_t, const Hexahedron_frame<double>& frame, const Edge_ratios<double>& ratios) {
      for (int c = 0; c < 8; ++c) {
        const double s = Corner_frame<double>(frame, c).scaled_jacobian;
        lowest = (std::min)(lowest, s * Regularized_mean_ratio(ratios, c, s, 1).volume);
      }
    });
    return lowest;
  }

  double value(const Positions& points) const
  {
    double sum = attachment_.energy(points);
    for_hexahedra(points, [&](std::size_t, const Hexahedron_frame<double>& frame, const Edge_ratios<double>& ratios) {
      for (int c = 0; c < 8; ++c)
        sum += Regularized_mean_ratio(ratios, c, Corner_frame<double>(frame, c).scaled_jacobian, squared_epsilon_).value();
    });
    return sum;
  }

  void assemble(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    Hexahedron_derivatives<double> d;
    for_hexahedra(points, [&](std::size_t h, const Hexahedron_frame<double>& frame, const Edge_ratios<double>& ratios) {
      d.set_zero();
      for (int c = 0; c < 8; ++c) {
        const Corner_frame<double> corner(frame, c);
        d.add(c, frame, corner, Regularized_mean_ratio(ratios, c, corner.scaled_jacobian, squared_epsilon_).model(corner));
      }
      assembly_.add(h, d, 0, gradient, matrix);
    });
    attachment_.add_derivatives(points, gradient, matrix);
  }

  const Hexahedral_complex& complex_;
  const Maximization_parameters parameters_;
  Surface_attachment& attachment_;
  Block_matrix matrix_;
  const Hexahedron_assembly assembly_;
  const std::vector<double> lengths_; // targets of the edges
  const std::vector<char> is_fixed_;
  std::vector<int> active_;      // hexahedra
  std::vector<char> is_passive_; // vertices that do not move
  double squared_epsilon_ = 0;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_UNTANGLING_H
