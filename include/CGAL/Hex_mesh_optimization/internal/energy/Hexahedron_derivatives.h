// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_DERIVATIVES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_DERIVATIVES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Gradients and positive semi-definite Hessians of energies of the corners of a
// hexahedron, for one hexahedron (Real = double) or several at once (Real = Lanes).

#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>

#include <array>

namespace CGAL::Hex_mesh_optimization::internal {

// The edges of a hexahedron, in the order of hexahedron_edges.
template <class Real>
struct Hexahedron_frame
{
  Real unit[12][3]; // directions
  Real square[12];  // of the lengths
  Real inverse_length[12];

  // vectors: along the edges
  explicit Hexahedron_frame(const Real (&vectors)[12][3])
  {
    using Number = typename Lane<Real>::type;
    for (int k = 0; k < 12; ++k) {
      const Real* e = vectors[k];
      // an edge without length has no direction, rather than one that is not a number
      square[k] = larger(e[0] * e[0] + e[1] * e[1] + e[2] * e[2], Real{} + Number(1e-30));
      inverse_length[k] = Number(1) / square_root(square[k]);
      for (int a = 0; a < 3; ++a)
        unit[k][a] = e[a] * inverse_length[k];
    }
  }
};

// (length / target length)² of the edges, and the factor of each in mean ratios, its power of −⅓.
template <class Real>
struct Edge_ratios
{
  Real square[12], power[12];

  Edge_ratios(const Hexahedron_frame<Real>& frame, const Real* inverse_targets)
  {
    for (int k = 0; k < 12; ++k) {
      square[k] = frame.square[k] * (inverse_targets[k] * inverse_targets[k]);
      power[k] = inverse_cube_root(square[k]);
    }
  }

  // ⅓ Σ |e_i|²/l_i² / (det / l_0 l_1 l_2)^⅔ of the edges e at a corner for target lengths l. It is 1 for an orthogonal
  // corner with edges in proportion to l and grows without bound towards inversion.
  Real mean_ratio(int corner, const Real& scaled_jacobian) const
  {
    using Number = typename Lane<Real>::type;
    const int i = corner_edges[corner][0] / 2, j = corner_edges[corner][1] / 2, k = corner_edges[corner][2] / 2;
    const Real root = inverse_cube_root(scaled_jacobian);
    return (square[i] + square[j] + square[k]) * Number(1. / 3) * (power[i] * power[j] * power[k]) * (root * root);
  }
};

template <class Real>
struct Corner_frame
{
  Real unit[3][3];  // of the edges that leave the corner
  Real cross[3][3]; // of the two others
  Real scaled_jacobian;

  Corner_frame(const Hexahedron_frame<Real>& frame, int corner)
  {
    for (int i = 0; i < 3; ++i) {
      const int directed = corner_edges[corner][i];
      for (int a = 0; a < 3; ++a)
        unit[i][a] = directed % 2 ? -frame.unit[directed / 2][a] : frame.unit[directed / 2][a];
    }
    for (int i = 0; i < 3; ++i) {
      const Real *u = unit[(i + 1) % 3], *v = unit[(i + 2) % 3];
      for (int a = 0; a < 3; ++a)
        cross[i][a] = u[(a + 1) % 3] * v[(a + 2) % 3] - u[(a + 2) % 3] * v[(a + 1) % 3];
    }
    scaled_jacobian = unit[0][0] * cross[0][0] + unit[0][1] * cross[0][1] + unit[0][2] * cross[0][2];
  }
};

// The matrix of an energy of a corner in the edges e_i that leave it, of unit vectors n_i:
//   H_ij = k_ij n_i n_jᵀ + y_i y_jᵀ + δ_ij d_i I,   all per length of the edges.
template <class Real>
struct Corner_quadratic
{
  Real gradient[3][3];
  Real k[3][3]; // for i ≤ j
  Real y[3][3];
  Real d[3];

  // Of an energy that depends on the edges through r_i = (|e_i| / l_i)², through log det of the edges, whose derivative
  // by e_i is c_i = slope · cross_i / |e_i|, and through log s of the scaled Jacobian s, whose derivative is
  // c_i − n_i / |e_i| where slope is 1 / s. With v_i = r_i n_i / |e_i| = e_i / l_i²,
  //   gradient_i = ⅔ (x n_i / |e_i| + b v_i − (x + p) c_i),
  //   H = ⅔ δ_ij (x / |e_i|² (I − n_i n_iᵀ) + b / l_i² I) + [n v c] M [n v c]ᵀ + growth g gᵀ,   g_i = ⅔ (b' v_i − m
  //   c_i),
  //   M_nn = −M_nc = 10/9 x + 4/9 z, M_cc = M_nn + 10/9 p, M_vc = −4/9 b, and 0 otherwise;
  // with x, z, p, b, growth ≥ 0 and p, b as of a mean ratio, H is positive semi-definite.
  // As n_i and v_i are parallel, the square of c is completed, and the rest is k.
  Corner_quadratic(const Corner_frame<Real>& corner, const Real& slope, const Real* r, const Real& x, const Real& z,
                   const Real& p, const Real& b, const Real& growth, const Real& b1, const Real& m)
  {
    using Number = typename Lane<Real>::type;
    const Number two_thirds = Number(2. / 3), four_ninths = Number(4. / 9), ten_ninths = Number(10. / 9);
    const Real beta = two_thirds * b1, gamma = two_thirds * m;
    const Real nn = ten_ninths * x + four_ninths * z, vv = growth * beta * beta,
               vc = -four_ninths * b - growth * beta * gamma;
    const Real cc = nn + ten_ninths * p + growth * gamma * gamma;
    const Real inverse = Number(1) / larger(cc, Real{} + Number(1e-30)), root = square_root(cc), factor = root * slope;
    Real t[3];
    for (int i = 0; i < 3; ++i) {
      const Real c = vc * r[i] - nn, along = two_thirds * (x + b * r[i]), across = two_thirds * (x + p) * slope;
      t[i] = c * inverse;
      d[i] = along;
      for (int a = 0; a < 3; ++a) {
        y[i][a] = factor * corner.cross[i][a] + root * t[i] * corner.unit[i][a];
        gradient[i][a] = along * corner.unit[i][a] - across * corner.cross[i][a];
      }
      for (int j = 0; j <= i; ++j)
        k[j][i] = nn + vv * r[i] * r[j] - cc * t[i] * t[j];
      k[i][i] -= two_thirds * x;
    }
  }
};

// Derivatives in the vertices of a hexahedron, those of second order in the couplings of it. Blocks are stored row by
// row, symmetric ones as xx, xy, xz, yy, yz, zz.
template <class Real>
struct Hexahedron_derivatives
{
  Real gradient[8][3];
  Real diagonal[8][6];
  Real coupling[Hexahedron_couplings::number][9];

  void set_zero() { *this = {}; }

  void add(int corner, const Hexahedron_frame<Real>& frame, const Corner_frame<Real>& c,
           const Corner_quadratic<Real>& model)
  {
    Real u[3][3], y[3][3], row[3][9], d[3]; // row: of the vertex of an edge, summed over the edges
    for (int i = 0; i < 3; ++i) {
      const Real scale = frame.inverse_length[corner_edges[corner][i] / 2];
      const int v = corner_neighbors[corner][i];
      for (int a = 0; a < 3; ++a) {
        u[i][a] = scale * c.unit[i][a];
        y[i][a] = scale * model.y[i][a];
        const Real g = scale * model.gradient[i][a];
        gradient[v][a] += g;
        gradient[corner][a] -= g;
      }
      d[i] = scale * scale * model.d[i];
    }
    for (int i = 0; i < 3; ++i) {
      int n = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++n) {
          Real value = model.k[i][i] * u[i][a] * u[i][b] + y[i][a] * y[i][b];
          if (a == b)
            value += d[i];
          diagonal[corner_neighbors[corner][i]][n] += value;
          row[i][3 * a + b] = row[i][3 * b + a] = value;
        }
    }
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 3; ++j) {
        const int v = corner_neighbors[corner][i], w = corner_neighbors[corner][j];
        Real* block = coupling[hexahedron_couplings.of[v][w]];
        const int down = v < w ? 3 : 1, right = 4 - down;
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) {
            const Real value = model.k[i][j] * u[i][a] * u[j][b] + y[i][a] * y[j][b];
            block[down * a + right * b] += value;
            row[i][3 * a + b] += value;
            row[j][3 * b + a] += value;
          }
      }
    for (int i = 0; i < 3; ++i) {
      const int v = corner_neighbors[corner][i];
      Real* block = coupling[hexahedron_couplings.of[v][corner]];
      const int down = v < corner ? 3 : 1, right = 4 - down;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          block[down * a + right * b] -= row[i][3 * a + b];
    }
    int n = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b, ++n)
        diagonal[corner][n] += row[0][3 * a + b] + row[1][3 * a + b] + row[2][3 * a + b];
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_DERIVATIVES_H
