// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ENERGY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The energy of one hexahedron in its eight vertices: functions of the scaled
// Jacobians of its corners, and the shape relative to target lengths, with exact
// gradient and a positive semi-definite model of the Hessian.

#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>

#include <limits>

namespace CGAL::Hex_mesh_optimization::internal {

// Numbers without another source were chosen together by a coordinate search on organic and CAD models of 2,500 to
// 38,000 hexahedra.
struct Hexahedron_energy_parameters
{
  // Keeps the root of the norm differentiable at a perfect hexahedron.
  double norm_offset = 1e-3;
  // ν, the weight of −log s. It only has to be infinite at 0: the floor does the work.
  double barrier_weight = .005;
  // ρ, the weight of the exterior floor. Stronger than an attachment at any distance, so that it wins.
  double floor_weight = 2000;
  // w: if it is positive, ρ weighs an interior barrier of this width instead, which is infinite w below the floor.
  double interior_width = 0;
  // κ and κ', the shape: the scaled Jacobian is blind to lengths. Growth with the third power keeps the long tail of
  // edge ratios short at less cost for the average than a linear term.
  double shape_weight = .11;
  double poor_shape_weight = .5;
  // λ, of the shape for lengths that are certain. Linear: the terms above vanish too fast to hold a layer to its height.
  double certain_shape_weight = 1;
};

// Over the corners of a hexahedron with scaled Jacobians s:
//   8 (⅛ Σ (1 − s + δ)^8)^⅛ − ν Σ log s + ρ/2 Σ max(0, τ − s)² + Σ (λ c (m − 1) + κ/2 (m − 1)² + κ'/3 (m − 1)³),
// infinite where s ≤ 0. With an interior barrier, ρ b² / (w − b) with b = max(0, τ − s) stands for the term of the floor: it
// vanishes with its slope at τ, and is infinite from τ − w on. The first term is 8 (1 − min s), smoothed. m is the mean ratio for target lengths l,
// of certainty c: 0 to 1, or more for lengths to be kept the more closely.
class Hexahedron_energy
{
public:
  explicit Hexahedron_energy(const Hexahedron_energy_parameters& parameters) : parameters_(parameters) {}

  // inverse_targets: 1 / l of the edges; floor: τ of the corners; certainty: c.
  template <class Real>
  Real value(const Hexahedron_frame<Real>& frame, const Real* inverse_targets, const Real* floor,
             const Real& certainty = Real{}) const
  {
    using Number = typename Lane<Real>::type;
    const Number offset = Number(parameters_.norm_offset);
    const Edge_ratios<Real> ratios(frame, inverse_targets);
    Real sum{}, norm{}, lowest = Real{} + Number(1);
    for (int i = 0; i < 8; ++i) {
      const Real s = Corner_frame<Real>(frame, i).scaled_jacobian, below = larger(Real{}, floor[i] - s);
      lowest = smaller(s, lowest);
      const Real safe = if_positive(s, larger(s, Real{} + least_scaled_jacobian<Number>()), Real{} + Number(1));
      const Real excess = larger(Real{}, ratios.mean_ratio(i, safe) - Number(1));
      sum += value_of_corner(safe, below, excess, certainty);
      norm += power_8(Number(1) - s + offset);
    }
    return if_positive(lowest, sum + Number(8) * root_8(norm * Number(.125)),
                       Real{} + std::numeric_limits<Number>::infinity());
  }

  // Overwrites d, which is that where scaled Jacobians are positive. Returns the value.
  template <class Real>
  Real derivatives(const Hexahedron_frame<Real>& frame, const Real* inverse_targets, const Real* floor,
                   Hexahedron_derivatives<Real>& d, const Real& certainty = Real{}) const
  {
    using Number = typename Lane<Real>::type;
    const Number offset = Number(parameters_.norm_offset), barrier = Number(parameters_.barrier_weight),
                 floor_weight = Number(parameters_.floor_weight), shape = Number(parameters_.shape_weight),
                 poor_shape = Number(parameters_.poor_shape_weight),
                 certain_shape = Number(parameters_.certain_shape_weight);
    const Edge_ratios<Real> ratios(frame, inverse_targets);
    d.set_zero();
    Real sum{}, norm{}, lowest = Real{} + Number(1);
    for (int i = 0; i < 8; ++i) {
      const Real s = Corner_frame<Real>(frame, i).scaled_jacobian;
      lowest = smaller(s, lowest);
      norm += power_8(Number(1) - s + offset);
    }
    norm *= Number(.125);
    const Real root = root_8(norm), outer = root / norm;
    for (int i = 0; i < 8; ++i) {
      const Corner_frame<Real> corner(frame, i);
      const Real s = larger(corner.scaled_jacobian, Real{} + least_scaled_jacobian<Number>());
      const Real base = Number(1) - s + offset, below = larger(Real{}, floor[i] - s),
                 sixth = outer * base * base * power_4(base);
      // s f'(s) and s² f''(s)
      const Floor_term<Real> of_floor(below, floor_weight, Number(parameters_.interior_width));
      const Real f1 = -s * (sixth * base + of_floor.slope) - barrier;
      const Real f2 = s * s * (Number(7) * sixth + of_floor.curvature) + barrier;

      // With the lengths frozen at their values, s^-⅔ is the mean ratio q of the corner, whose gradient there is that
      // of s^-⅔ exactly, and whose Hessian without the second derivative of the determinant is positive definite. Along
      // each edge s is constant, and q is not: these directions are projected out, else corners below the floor would
      // keep all their lengths, and take more iterations. f is chained on as F(q) = f(q^-3/2), F' ≥ 0; a negative F'' is dropped. x and z are F' q and F'' q².
      const Real x = Number(-1.5) * f1, z = larger(Real{}, Number(2.25) * f2 + Number(3.75) * f1);

      const Real m = ratios.mean_ratio(i, s), excess = larger(Real{}, m - Number(1));
      Real r[3], squares{};
      for (int k = 0; k < 3; ++k)
        squares += r[k] = ratios.square[corner_edges[i][k] / 2];
      const Real factor = Number(3) * m / squares; // of ⅓ Σ |e_i|²/l_i²
      const Real slope = certain_shape * certainty + excess * (shape + poor_shape * excess),
                 growth = shape + Number(2) * poor_shape * excess;
      sum += value_of_corner(s, below, excess, certainty);
      d.add(i, frame, corner,
            Corner_quadratic<Real>(corner, Number(1) / s, r, x, z, slope * m, slope * factor, growth, factor, m));
    }
    return if_positive(lowest, sum + Number(8) * root, Real{} + std::numeric_limits<Number>::infinity());
  }

private:
  // The term of the floor over b, what a corner lacks of it: ρ/2 b², or with an interior barrier of width w ρ b² / (w − b).
  template <class Real>
  struct Floor_term
  {
    using Number = typename Lane<Real>::type;
    Real slope, curvature;

    Floor_term(const Real& below, Number weight, Number width)
    {
      if (!(width > 0)) {
        slope = weight * below;
        curvature = if_positive(below, Real{} + weight, Real{});
        return;
      }
      const Real part = width / larger(width - below, Real{} + least_gap(width)); // w / (w − b)
      slope = weight * (part * part - Number(1));
      curvature = if_positive(below, Number(2) * weight / width * part * part * part, Real{});
    }

    static Real value(const Real& below, Number weight, Number width)
    {
      if (!(width > 0))
        return Number(.5) * weight * below * below;
      const Real gap = width - below;
      return if_positive(gap, weight * below * below / larger(gap, Real{} + least_gap(width)),
                         Real{} + std::numeric_limits<Number>::infinity());
    }

  private:
    static Number least_gap(Number width) { return Number(1e-4) * width; } // derivatives would overflow
  };

  // But for the norm. below: what is lacking of the floor; excess: m − 1.
  template <class Real>
  Real value_of_corner(const Real& scaled_jacobian, const Real& below, const Real& excess, const Real& certainty) const
  {
    using Number = typename Lane<Real>::type;
    const Number barrier = Number(parameters_.barrier_weight), floor_weight = Number(parameters_.floor_weight),
                 half_shape = Number(parameters_.shape_weight / 2),
                 third_poor_shape = Number(parameters_.poor_shape_weight / 3),
                 certain_shape = Number(parameters_.certain_shape_weight);
    return excess * (certain_shape * certainty + excess * (half_shape + third_poor_shape * excess)) -
           barrier * logarithm(scaled_jacobian) +
           Floor_term<Real>::value(below, floor_weight, Number(parameters_.interior_width));
  }

  // Below this the derivatives are those at it: they would overflow.
  template <class Number>
  static constexpr Number least_scaled_jacobian()
  {
    return sizeof(Number) < sizeof(double) ? Number(1e-8) : Number(1e-100);
  }

  template <class Real>
  static Real power_4(const Real& x)
  {
    return x * x * (x * x);
  }
  template <class Real>
  static Real power_8(const Real& x)
  {
    return power_4(x) * power_4(x);
  }
  template <class Real>
  static Real root_8(const Real& x)
  {
    return square_root(square_root(square_root(x)));
  }

  Hexahedron_energy_parameters parameters_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ENERGY_H
