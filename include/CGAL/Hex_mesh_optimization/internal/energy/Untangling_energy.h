// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_UNTANGLING_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_UNTANGLING_ENERGY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// An energy that is finite where corners are inverted: the mean ratio of all
// corners of some hexahedra, regularized (Garanzha et al., "Foldover-free maps in
// 50 lines of code", 2021).

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The mean ratio with χ = ½ (D + √(ε² + D²)) in the place of D = det / l_0 l_1 l_2: itself at ε = 0, D > 0.
struct Regularized_mean_ratio
{
  double r[3], squares;  // |e_i|²/l_i² and their sum
  double volume;         // |e_0| |e_1| |e_2| / l_0 l_1 l_2
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

  // As that of the mean ratio, with χ in the place of the determinant. m: its value.
  Corner_quadratic<double> model(const Corner_frame<double>& corner, double m) const
  {
    return Corner_quadratic<double>(corner, chi_slope * volume / chi, r, 0, 0, m, 3 * m / squares, 0, 0, 0);
  }
};

class Untangling_energy
{
public:
  // assembly: for the matrix that the derivatives are added to. All but the lengths must outlive the object.
  Untangling_energy(const Hexahedral_complex& complex, const Hexahedron_assembly& assembly,
                    const std::vector<double>& target_lengths)
    : complex_(complex)
    , assembly_(assembly)
    , lengths_(target_lengths)
  {}

  // The hexahedra whose energy this is.
  void set_active(std::vector<int> hexahedra) { active_ = std::move(hexahedra); }
  // ε².
  void set_regularization(double squared_epsilon) { squared_epsilon_ = squared_epsilon; }

  // The lowest D of all corners, or 1 if that is lower.
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
    double sum = 0;
    for_hexahedra(points, [&](std::size_t, const Hexahedron_frame<double>& frame, const Edge_ratios<double>& ratios) {
      for (int c = 0; c < 8; ++c)
        sum +=
          Regularized_mean_ratio(ratios, c, Corner_frame<double>(frame, c).scaled_jacobian, squared_epsilon_).value();
    });
    return sum;
  }

  double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    double sum = 0;
    Hexahedron_derivatives<double> d;
    for_hexahedra(points, [&](std::size_t h, const Hexahedron_frame<double>& frame, const Edge_ratios<double>& ratios) {
      d.set_zero();
      for (int c = 0; c < 8; ++c) {
        const Corner_frame<double> corner(frame, c);
        const Regularized_mean_ratio ratio(ratios, c, corner.scaled_jacobian, squared_epsilon_);
        const double m = ratio.value();
        sum += m;
        d.add(c, frame, corner, ratio.model(corner, m));
      }
      assembly_.add(h, d, 0, gradient, matrix);
    });
    return sum;
  }

private:
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

  const Hexahedral_complex& complex_;
  const Hexahedron_assembly& assembly_;
  const std::vector<double> lengths_; // targets of the edges
  std::vector<int> active_;           // hexahedra
  double squared_epsilon_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_UNTANGLING_ENERGY_H
