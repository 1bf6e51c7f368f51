// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HEXAHEDRON_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HEXAHEDRON_ENERGY_H

// The energy of one hexahedron in its eight vertices: functions of the scaled
// Jacobians of its corners, and the shape relative to target lengths, with exact
// gradient and a positive definite model of the Hessian.

#include <CGAL/Hex_mesh_optimization/internal/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/hexahedron.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// Three edge vectors that leave a corner.
struct Corner
{
  Vector_3 edge[3];
  double squared_length[3];
  double determinant, scaled_jacobian;

  Corner(const Vector_3& a, const Vector_3& b, const Vector_3& c)
    : edge{a, b, c}
    , squared_length{a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}
    , determinant(a.dot(b.cross(c)))
    , scaled_jacobian(determinant / std::sqrt(squared_length[0] * squared_length[1] * squared_length[2]))
  {}
};

// x: the eight vertices of a hexahedron.
inline Corner corner_at(const Vector_3* x, int i)
{
  return Corner(x[corner_neighbors[i][0]] - x[i], x[corner_neighbors[i][1]] - x[i], x[corner_neighbors[i][2]] - x[i]);
}

inline std::array<Vector_3, 8> hexahedron_corners(const Positions& points, const Hexahedron& h)
{
  std::array<Vector_3, 8> x;
  for (int i = 0; i < 8; ++i)
    x[i] = points[h[i]];
  return x;
}

// The mean ratio ⅓ Σ |e_i|²/l_i² / (det / l_0 l_1 l_2)^⅔ for given lengths l. It is 1
// for an orthogonal corner with edges in proportion to l and grows without bound
// towards inversion. At l = |e| it equals s^-⅔, s being the scaled Jacobian.
inline double mean_ratio(const Corner& corner, const double* l)
{
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    squares += corner.squared_length[i] / (l[i] * l[i]);
  const double ratio = corner.determinant / (l[0] * l[1] * l[2]);
  return squares / 3 / std::cbrt(ratio * ratio);
}

// Value, derivative and second derivative of κ/2 (m − 1)² + κ'/3 (m − 1)³ over the mean ratio m.
struct Shape_energy
{
  double value, slope, growth;

  Shape_energy(const Maximization_parameters& parameters, double m)
  {
    const double x = (std::max)(0.0, m - 1), k = parameters.shape_weight, k3 = parameters.poor_shape_weight;
    value = x * x * (k / 2 + k3 / 3 * x);
    slope = x * (k + k3 * x);
    growth = k + 2 * k3 * x;
  }
};

struct Corner_derivatives
{
  Vector_3 gradient[3];
  Matrix_3 hessian[3][3]; // block (i, j) for i ≤ j
};

// Derivatives of f(s) + Shape_energy(mean_ratio(target lengths)), given f'(s) ≤ 0 and f''(s).
//
// With the lengths frozen at their values, s^-⅔ is the mean ratio q of the corner,
// whose gradient there is that of s^-⅔ exactly, and whose Hessian without the second
// derivative of the determinant,
//   ⅔ a δ_ij I / l_i² − 4/9 a (u cᵀ + c uᵀ) + 10/9 q c cᵀ,   a = det(e/l)^-⅔, u_i = e_i/l_i², c_i = ∂ log det / ∂e_i,
// is positive definite: the discriminant of the quadratic form is (4/3)² − 4 · 5/9 < 0.
// f is chained on as F(q) = f(q^-3/2), whose F' ≥ 0; a negative F'' is dropped.
inline void corner_derivatives(const Corner& corner, double f1, double f2, const Maximization_parameters& parameters, const double* target,
                               Corner_derivatives& d)
{
  Vector_3 c[3], u[3];
  double inverse_square[3];
  const double inverse_determinant = 1 / corner.determinant;
  for (int i = 0; i < 3; ++i) {
    c[i] = corner.edge[(i + 1) % 3].cross(corner.edge[(i + 2) % 3]) * inverse_determinant;
    u[i] = corner.edge[i] / corner.squared_length[i];
    inverse_square[i] = 1 / (target[i] * target[i]);
  }
  const double s = corner.scaled_jacobian, cube_root = std::cbrt(s), a = 1 / (cube_root * cube_root), q = a;
  const double s1 = -1.5 * s / a, s2 = 3.75 * s * s * cube_root; // ds/dq and d²s/dq² of s = q^-3/2
  const double F1 = f1 * s1, F2 = (std::max)(0.0, f2 * s1 * s1 + f1 * s2);

  const double m = mean_ratio(corner, target);
  const Shape_energy shape(parameters, m);
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    squares += corner.squared_length[i] * inverse_square[i];
  const double p = shape.slope * m, b = 3 * p / squares, b1 = 3 * m / squares; // weighted: mean ratio, and its factor of ⅓ Σ |e_i|²/l_i²

  // Hessian = diagonal + [u v c] M [u v c]ᵀ with v_i = e_i/target_i² = r_i u_i, which only occurs next to c
  const double k = 4.0 / 9;
  const double Muu = F2 * k * a * a, Muc = -k * F1 * a - k * F2 * a * q, Mcc = 10.0 / 9 * (F1 * q + p) + k * F2 * q * q, Mvc = -k * b;
  Vector_3 w[3], z[3], ratio_gradient[3];
  for (int i = 0; i < 3; ++i) {
    const double r = corner.squared_length[i] * inverse_square[i];
    w[i] = (Muc + Mvc * r) * u[i];
    z[i] = w[i] + Mcc * c[i];
    ratio_gradient[i] = 2.0 / 3 * (b1 * r * u[i] - m * c[i]);
    d.gradient[i] = 2.0 / 3 * ((F1 * a + b * r) * u[i] - (F1 * q + p) * c[i]);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j)
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
          d.hessian[i][j](x, y) = u[i][x] * (Muu * u[j][y]) + w[i][x] * c[j][y] + c[i][x] * z[j][y];
    for (int j = i; j < 3; ++j)
      d.hessian[i][j] += shape.growth * ratio_gradient[i] * ratio_gradient[j].transpose();
    d.hessian[i][i].diagonal().array() += 2.0 / 3 * (F1 * a / corner.squared_length[i] + b * inverse_square[i]);
  }
}

using Hexahedron_lengths = std::array<double, 12>; // targets of the edges, in the order of hexahedron_edges

inline std::vector<Hexahedron_lengths> hexahedron_lengths(const Hexahedral_complex& complex, const std::vector<double>& lengths)
{
  std::vector<Hexahedron_lengths> result(complex.hexahedra.size());
  for (std::size_t h = 0; h < result.size(); ++h)
    for (int k = 0; k < 12; ++k)
      result[h][k] = lengths[complex.hexahedron_edges[h][k] / 2];
  return result;
}

inline void corner_targets(const Hexahedron_lengths& lengths, int corner, double* target)
{
  for (int k = 0; k < 3; ++k)
    target[k] = lengths[corner_edges[corner][k] / 2];
}

// From the edges that leave a corner to the vertices of the hexahedron.
inline void add_corner(int corner, const Corner_derivatives& d, std::array<Vector_3, 8>& gradient,
                       Block_matrix::Hexahedron_blocks& hessian)
{
  const auto subtract = [&hessian](int i, int j, const Matrix_3& B) {
    if (i < j)
      hessian[Block_matrix::local_block(i, j)] -= B;
    else
      hessian[Block_matrix::local_block(j, i)] -= B.transpose();
  };
  const Matrix_3 row[3] = {d.hessian[0][0] + d.hessian[0][1] + d.hessian[0][2],
                           d.hessian[0][1].transpose() + d.hessian[1][1] + d.hessian[1][2],
                           d.hessian[0][2].transpose() + d.hessian[1][2].transpose() + d.hessian[2][2]};
  hessian[corner] += row[0] + row[1] + row[2];
  for (int j = 0; j < 3; ++j) {
    const int v = corner_neighbors[corner][j];
    gradient[v] += d.gradient[j];
    gradient[corner] -= d.gradient[j];
    hessian[v] += d.hessian[j][j];
    subtract(v, corner, row[j]);
    for (int k = j + 1; k < 3; ++k)
      subtract(v, corner_neighbors[corner][k], -d.hessian[j][k]);
  }
}

// Over the corners of a hexahedron with scaled Jacobians s:
//   8 (⅛ Σ (1 − s + δ)^8)^⅛ − ν Σ log s + ρ/2 Σ max(0, τ − s)² + Σ κ/2 (m − 1)² + κ'/3 (m − 1)³,   m the mean ratio,
// infinite where s ≤ 0. The first term is 8 (1 − min s), smoothed.
class Hexahedron_energy
{
public:
  using Floor = std::array<double, 8>;    // τ of each corner

  explicit Hexahedron_energy(const Maximization_parameters& parameters)
    : parameters_(parameters)
    , shape_weight_(parameters.shape_weight)
    , poor_shape_weight_(parameters.poor_shape_weight)
  {}

  // Multiplies both weights of the shape as the parameters gave them.
  void set_shape_factor(double factor)
  {
    parameters_.shape_weight = factor * shape_weight_;
    parameters_.poor_shape_weight = factor * poor_shape_weight_;
  }

  double value(const Vector_3* x, const Hexahedron_lengths& lengths, const Floor& floor) const
  {
    double sum = 0, norm = 0;
    for (int i = 0; i < 8; ++i) {
      const Corner corner = corner_at(x, i);
      const double s = corner.scaled_jacobian;
      if (!(s > 0))
        return std::numeric_limits<double>::infinity();
      double target[3];
      corner_targets(lengths, i, target);
      const double below = (std::max)(0.0, floor[i] - s);
      sum += Shape_energy(parameters_, mean_ratio(corner, target)).value - parameters_.barrier_weight * std::log(s) +
             parameters_.floor_weight / 2 * below * below;
      norm += power_8(1 - s + parameters_.norm_offset);
    }
    return sum + 8 * root_8(norm / 8);
  }

  // All scaled Jacobians must be positive. Overwrites both results.
  void derivatives(const Vector_3* x, const Hexahedron_lengths& lengths, const Floor& floor, std::array<Vector_3, 8>& gradient,
                   Block_matrix::Hexahedron_blocks& hessian) const
  {
    gradient.fill(Vector_3::Zero());
    hessian.fill(Matrix_3::Zero());
    double norm = 0, base[8], s[8];
    for (int i = 0; i < 8; ++i) {
      s[i] = corner_at(x, i).scaled_jacobian;
      base[i] = 1 - s[i] + parameters_.norm_offset;
      norm += power_8(base[i]);
    }
    const double root = root_8(norm / 8), outer = root / (norm / 8);
    Corner_derivatives d;
    for (int i = 0; i < 8; ++i) {
      const double below = (std::max)(0.0, floor[i] - s[i]), sixth = outer * base[i] * base[i] * power_4(base[i]);
      const double f1 = -sixth * base[i] - parameters_.barrier_weight / s[i] - parameters_.floor_weight * below;
      const double f2 = 7 * sixth + parameters_.barrier_weight / (s[i] * s[i]) + (below > 0 ? parameters_.floor_weight : 0);
      double target[3];
      corner_targets(lengths, i, target);
      corner_derivatives(corner_at(x, i), f1, f2, parameters_, target, d);
      add_corner(i, d, gradient, hessian);
    }
  }

private:
  static double power_4(double x) { return x * x * (x * x); }
  static double power_8(double x) { return power_4(x) * power_4(x); }
  static double root_8(double x) { return std::sqrt(std::sqrt(std::sqrt(x))); }

  Maximization_parameters parameters_;
  const double shape_weight_, poor_shape_weight_; // as given
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HEXAHEDRON_ENERGY_H
