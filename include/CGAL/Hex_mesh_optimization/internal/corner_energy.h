// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_CORNER_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_CORNER_ENERGY_H

// The energy of one corner of a hexahedron in its three edge vectors: a function
// of the scaled Jacobian, and the shape relative to target lengths, with exact
// gradient and a positive definite model of the Hessian.

#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// Three edge vectors that leave a corner, with what both terms need of them.
struct Corner
{
  Vector_3 edge[3];
  double length[3];
  double determinant, scaled_jacobian;

  Corner(const Vector_3& a, const Vector_3& b, const Vector_3& c)
    : edge{a, b, c}
    , length{a.norm(), b.norm(), c.norm()}
    , determinant(a.dot(b.cross(c)))
    , scaled_jacobian(determinant / (length[0] * length[1] * length[2]))
  {}
};

// The mean ratio ⅓ Σ |e_i|²/l_i² / (det / l_0 l_1 l_2)^⅔ for given lengths l. It is 1
// for an orthogonal corner with edges in proportion to l and grows without bound
// towards inversion. At l = |e| it equals s^-⅔, s being the scaled Jacobian.
inline double mean_ratio(const Corner& corner, const double* l)
{
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    squares += corner.length[i] * corner.length[i] / (l[i] * l[i]);
  return squares / 3 / std::cbrt(std::pow(corner.determinant / (l[0] * l[1] * l[2]), 2));
}

struct Corner_derivatives
{
  Vector_3 gradient[3];
  Matrix_3 hessian[3][3]; // block (i, j) for i ≤ j
};

// Derivatives of f(s) + shape_weight · mean_ratio(target lengths), given f'(s) ≤ 0 and f''(s).
//
// With the lengths frozen at their values, s^-⅔ is the mean ratio q of the corner,
// whose gradient there is that of s^-⅔ exactly, and whose Hessian without the second
// derivative of the determinant,
//   ⅔ a δ_ij I / l_i² − 4/9 a (u cᵀ + c uᵀ) + 10/9 q c cᵀ,   a = det(e/l)^-⅔, u_i = e_i/l_i², c_i = ∂ log det / ∂e_i,
// is positive definite: the discriminant of the quadratic form is (4/3)² − 4 · 5/9 < 0.
// f is chained on as F(q) = f(q^-3/2), whose F' ≥ 0; a negative F'' is dropped.
inline void corner_derivatives(const Corner& corner, double f1, double f2, double shape_weight, const double* target,
                               Corner_derivatives& d)
{
  Vector_3 c[3], u[3], v[3];
  for (int i = 0; i < 3; ++i) {
    c[i] = corner.edge[(i + 1) % 3].cross(corner.edge[(i + 2) % 3]) / corner.determinant;
    u[i] = corner.edge[i] / (corner.length[i] * corner.length[i]);
    v[i] = corner.edge[i] / (target[i] * target[i]);
  }
  const double s = corner.scaled_jacobian, a = 1 / std::cbrt(s * s), q = a;
  const double s1 = -1.5 * s * std::cbrt(s * s), s2 = 3.75 * s * s * std::cbrt(s); // ds/dq and d²s/dq² of s = q^-3/2
  const double F1 = f1 * s1, F2 = (std::max)(0.0, f2 * s1 * s1 + f1 * s2);

  const double ratio = corner.determinant / (target[0] * target[1] * target[2]);
  const double b = shape_weight / std::cbrt(ratio * ratio);
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    squares += corner.edge[i].dot(v[i]);
  const double p = b * squares / 3; // weighted mean ratio

  // Hessian = diagonal + [u v c] M [u v c]ᵀ
  const double k = 4.0 / 9;
  const double Muu = F2 * k * a * a, Muc = -k * F1 * a - k * F2 * a * q, Mcc = 10.0 / 9 * (F1 * q + p) + k * F2 * q * q, Mvc = -k * b;
  for (int i = 0; i < 3; ++i) {
    d.gradient[i] = 2.0 / 3 * (F1 * (a * u[i] - q * c[i]) + b * v[i] - p * c[i]);
    const double diagonal = 2.0 / 3 * (F1 * a / (corner.length[i] * corner.length[i]) + b / (target[i] * target[i]));
    for (int j = i; j < 3; ++j) {
      d.hessian[i][j].noalias() = u[i] * (Muu * u[j] + Muc * c[j]).transpose();
      d.hessian[i][j].noalias() += v[i] * (Mvc * c[j]).transpose();
      d.hessian[i][j].noalias() += c[i] * (Muc * u[j] + Mvc * v[j] + Mcc * c[j]).transpose();
    }
    d.hessian[i][i].diagonal().array() += diagonal;
  }
}

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_CORNER_ENERGY_H
