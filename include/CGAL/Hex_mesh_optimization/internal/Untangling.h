// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_H

// Removes the inverted corners that rectification left: the mean ratio of all
// corners, regularized so that it is finite for inverted ones too, is minimized
// while the regularization fades (Garanzha et al., "Foldover-free maps in 50 lines
// of code", 2021), with the boundary loosely attached.

#include <CGAL/Hex_mesh_optimization/internal/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/Surface_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/newton_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// ⅓ Σ |e_i|²/l_i² / χ^⅔ with χ = ½ (D + √(ε² + D²)), D = det / l_0 l_1 l_2: the mean ratio at ε = 0, D > 0.
struct Regularized_mean_ratio
{
  double squares, chi, chi_slope; // Σ |e_i|²/l_i², χ and dχ/dD

  Regularized_mean_ratio(const Corner& corner, const double* l, double squared_epsilon)
    : squares(0)
  {
    for (int i = 0; i < 3; ++i)
      squares += corner.squared_length[i] / (l[i] * l[i]);
    const double D = relative_determinant(corner, l), root = std::sqrt(squared_epsilon + D * D);
    // the difference of nearly equal numbers, where D < 0
    chi = D > 0 ? (D + root) / 2 : squared_epsilon / (2 * (root - D));
    chi_slope = chi / root;
  }

  static double relative_determinant(const Corner& corner, const double* l) { return corner.determinant / (l[0] * l[1] * l[2]); }

  double value() const { return squares / 3 / std::cbrt(chi * chi); }

  // As for the mean ratio, with c_i = ∂ log χ / ∂e_i.
  void derivatives(const Corner& corner, const double* l, Corner_derivatives& d) const
  {
    const double b = 1 / std::cbrt(chi * chi), m = squares / 3 * b, volume = l[0] * l[1] * l[2];
    Vector_3 c[3], v[3];
    for (int i = 0; i < 3; ++i) {
      c[i] = corner.edge[(i + 1) % 3].cross(corner.edge[(i + 2) % 3]) * (chi_slope / (chi * volume));
      v[i] = corner.edge[i] / (l[i] * l[i]);
      d.gradient[i] = 2.0 / 3 * (b * v[i] - m * c[i]);
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j)
        d.hessian[i][j] = -4.0 / 9 * b * (v[i] * c[j].transpose() + c[i] * v[j].transpose()) + 10.0 / 9 * m * c[i] * c[j].transpose();
      d.hessian[i][i].diagonal().array() += 2.0 / 3 * b / (l[i] * l[i]);
    }
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
    , matrix_(complex)
    , lengths_(hexahedron_lengths(complex, lengths))
    , is_fixed_(is_fixed)
  {}

  // Stops when no corner is inverted; leaves in points the state with the fewest inverted hexahedra.
  void run(Positions& points, Run_control& control)
  {
    Mesh_quality quality(complex_, points);
    Positions best = points;
    std::size_t fewest = quality.inverted, since = 0;
    attachment_.tightness = parameters_.start_tightness;
    for (std::size_t i = 0; fewest > 0 && since < parameters_.untangling_patience && !control.is_stopped(); ++i, ++since) {
      const double lowest = lowest_determinant(points);
      squared_epsilon_ = parameters_.least_regularization + parameters_.regularization * std::pow((std::min)(lowest, 0.0), 2);
      attachment_.update(points);
      const double energy = newton_step([this](const Positions& p) { return value(p); },
                                        [this](const Positions& p, Positions& g, Block_matrix& m) { assemble(p, g, m); },
                                        [](Positions&) {},
                                        is_fixed_, parameters_, matrix_, points);
      quality = Mesh_quality(complex_, points);
      if (quality.inverted < fewest) {
        fewest = quality.inverted;
        best = points;
        since = 0;
      }
      control.after_iteration(Stage::UNTANGLING, i, energy, quality);
    }
    points = std::move(best);
  }

private:
  template <class Visit>
  void for_corners(const Positions& points, const Visit& visit) const
  {
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h) {
      const std::array<Vector_3, 8> x = hexahedron_corners(points, complex_.hexahedra[h]);
      for (int c = 0; c < 8; ++c) {
        double target[3];
        corner_targets(lengths_[h], c, target);
        visit(h, c, corner_at(x.data(), c), target);
      }
    }
  }

  double lowest_determinant(const Positions& points) const
  {
    double lowest = 1;
    for_corners(points, [&](std::size_t, int, const Corner& corner, const double* target) {
      lowest = (std::min)(lowest, Regularized_mean_ratio::relative_determinant(corner, target));
    });
    return lowest;
  }

  double value(const Positions& points) const
  {
    double sum = attachment_.energy(points);
    for_corners(points, [&](std::size_t, int, const Corner& corner, const double* target) {
      sum += Regularized_mean_ratio(corner, target, squared_epsilon_).value();
    });
    return sum;
  }

  void assemble(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    std::array<Vector_3, 8> g;
    Block_matrix::Hexahedron_blocks H;
    Corner_derivatives d;
    for_corners(points, [&](std::size_t h, int c, const Corner& corner, const double* target) {
      if (c == 0) {
        g.fill(Vector_3::Zero());
        H.fill(Matrix_3::Zero());
      }
      Regularized_mean_ratio(corner, target, squared_epsilon_).derivatives(corner, target, d);
      add_corner(c, d, g, H);
      if (c == 7) {
        for (int i = 0; i < 8; ++i)
          gradient[complex_.hexahedra[h][i]] += g[i];
        matrix.add(h, H);
      }
    });
    attachment_.add_derivatives(points, gradient, matrix);
  }

  const Hexahedral_complex& complex_;
  const Maximization_parameters parameters_;
  Surface_attachment& attachment_;
  Block_matrix matrix_;
  const std::vector<Hexahedron_lengths> lengths_;
  const std::vector<char> is_fixed_;
  double squared_epsilon_ = 0;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_UNTANGLING_H
