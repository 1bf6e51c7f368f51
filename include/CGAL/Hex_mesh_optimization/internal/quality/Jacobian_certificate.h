// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_JACOBIAN_CERTIFICATE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_JACOBIAN_CERTIFICATE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The certificate that a hexahedron is valid: a proof, for the coordinates as
// given, that its trilinear map has a positive Jacobian determinant everywhere.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>
#ifndef CGAL_HAS_MPZF
#include <CGAL/MP_Float.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Hex_mesh_optimization::internal {

constexpr int default_maximum_depth = 20;

// Bounds the recursion, and the digits that exact numbers grow by in each depth. A cell of this size is
// far below the distance of any two doubles in the parameter space.
constexpr int largest_maximum_depth = 100;

// Bounds the time spent on a determinant that vanishes on a whole surface, where
// the number of cells grows by a factor of four from each depth to the next.
constexpr int maximum_number_of_splits = 20000;

// Numbers with a sum, a difference and a product without rounding, and with doubles among them.
#ifdef CGAL_HAS_MPZF
using Exact_number = CGAL::Mpzf;
#else
using Exact_number = CGAL::MP_Float;
#endif

// The determinant of the Jacobian matrix of a trilinear map is a polynomial of
// degree 2 in each of the three parameters. It has 27 Bernstein-Bezier
// coefficients; coefficient (a, b, c) is stored at a + 3 * b + 9 * c. Over the unit
// cube the coefficients bound the polynomial from both sides, and the eight
// at the corners are its values there.
template <class NT>
using Bezier_coefficients = std::array<NT, 27>;

constexpr int bezier_corners[8] = {0, 2, 6, 8, 18, 20, 24, 26};

// With the linear Bernstein polynomials B_0(t) = 1 - t and B_1(t) = t, the columns of the
// Jacobian matrix are
//   U(v, w) = sum_{j,k} B_j(v) B_k(w) u_jk,  V(u, w) = sum_{i,m} B_i(u) B_m(w) v_im,
//   W(u, v) = sum_{n,l} B_n(u) B_l(v) w_nl
// with the edge vectors u_jk, v_im, w_nl. As B_0 B_0, B_0 B_1, B_1 B_1 are 1, 1/2, 1 times the
// quadratic Bernstein polynomials 0, 1, 2, the coefficient (a, b, c) of det(U, V, W) is the
// average of det(u_jk, v_im, w_nl) over i + n = a, j + l = b, k + m = c.
// First the cross products are averaged over k + m = c, for each i and j.
template <class NT>
Bezier_coefficients<NT> jacobian_coefficients(const Edge_vectors<NT>& edges)
{
  const NT half(.5);
  Coordinates<NT> normal[2][2][3]; // i, j, c
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      normal[i][j][0] = cross_product(edges.u[j], edges.v[i]);
      normal[i][j][2] = cross_product(edges.u[j + 2], edges.v[i + 2]);
      const Coordinates<NT> s = cross_product(edges.u[j], edges.v[i + 2]);
      const Coordinates<NT> t = cross_product(edges.u[j + 2], edges.v[i]);
      for (int x = 0; x < 3; ++x)
        normal[i][j][1][x] = half * (s[x] + t[x]);
    }

  Bezier_coefficients<NT> result;
  for (int c = 0; c < 3; ++c) {
    auto det = [&](int i, int j, int n, int l) { return scalar_product(normal[i][j][c], edges.w[n + 2 * l]); };
    NT* const b = result.data() + 9 * c;
    b[0] = det(0, 0, 0, 0);
    b[1] = half * (det(0, 0, 1, 0) + det(1, 0, 0, 0));
    b[2] = det(1, 0, 1, 0);
    b[3] = half * (det(0, 0, 0, 1) + det(0, 1, 0, 0));
    b[4] = half * (half * ((det(0, 0, 1, 1) + det(1, 1, 0, 0)) + (det(0, 1, 1, 0) + det(1, 0, 0, 1))));
    b[5] = half * (det(1, 0, 1, 1) + det(1, 1, 1, 0));
    b[6] = det(0, 1, 0, 1);
    b[7] = half * (det(0, 1, 1, 1) + det(1, 1, 0, 1));
    b[8] = det(1, 1, 1, 1);
  }
  return result;
}

// The coefficients over the eight halves of halves of halves, by de Casteljau's algorithm.
template <class NT>
std::array<Bezier_coefficients<NT>, 8> split(const Bezier_coefficients<NT>& coefficients)
{
  const NT half(.5);
  std::array<Bezier_coefficients<NT>, 8> cells;
  cells[0] = coefficients;
  int count = 1;
  for (int stride : {1, 3, 9}) {
    for (int cell = 0; cell < count; ++cell) {
      Bezier_coefficients<NT>& lower = cells[cell];
      Bezier_coefficients<NT>& upper = cells[cell + count];
      for (int first = 0; first < 27; ++first) {
        if (first / stride % 3 != 0)
          continue;
        const int middle = first + stride, last = middle + stride;
        const NT s = half * (lower[first] + lower[middle]);
        const NT t = half * (lower[middle] + lower[last]);
        upper[last] = lower[last];
        upper[middle] = t;
        upper[first] = lower[last] = half * (s + t);
        lower[middle] = s;
      }
    }
    count *= 2;
  }
  return cells;
}

// Decides from the coefficients. `sign(x, depth)` is 1 where the number computed as x at this
// depth of the subdivision is certainly positive, -1 where it is certainly not, and 0 otherwise.
template <class NT, class Sign>
class Subdivision
{
public:
  Subdivision(const Sign& sign, int maximum_depth)
    : sign_(sign)
    , maximum_depth_((std::min)(maximum_depth, largest_maximum_depth))
  {}

  // No answer: numbers of this type are not precise enough.
  std::optional<Validity> operator()(const Bezier_coefficients<NT>& coefficients)
  {
    Validity result = classify(coefficients, 0);
    if (result == Validity::UNDECIDED && !imprecise_)
      result = subdivide(coefficients, 0);
    if (imprecise_ && result != Validity::INVALID)
      return std::nullopt;
    return result;
  }

private:
  Validity classify(const Bezier_coefficients<NT>& b, int depth)
  {
    for (int corner : bezier_corners) {
      const int s = sign_(b[corner], depth);
      if (s < 0)
        return Validity::INVALID;
      if (s == 0)
        imprecise_ = true; // and no subdivision changes this value
    }
    const bool positive = std::all_of(b.begin(), b.end(), [&](const NT& x) { return sign_(x, depth) > 0; });
    return positive ? Validity::VALID : Validity::UNDECIDED;
  }

  Validity subdivide(const Bezier_coefficients<NT>& coefficients, int depth)
  {
    if (depth >= maximum_depth_ || number_of_splits_ == maximum_number_of_splits) {
      // it is the limit that prevents the proof only where more precise numbers would not give it
      if (std::none_of(coefficients.begin(), coefficients.end(), [&](const NT& x) { return sign_(x, depth) < 0; }))
        imprecise_ = true;
      return Validity::UNDECIDED;
    }
    ++number_of_splits_;

    // 216 exact numbers for each depth are too many for the stack of a thread
    const std::unique_ptr<const std::array<Bezier_coefficients<NT>, 8>> halves(
      new std::array<Bezier_coefficients<NT>, 8>(split(coefficients)));
    const std::array<Bezier_coefficients<NT>, 8>& cells = *halves;
    std::array<std::pair<double, int>, 8> open;
    auto end = open.begin();
    for (int cell = 0; cell < 8; ++cell) {
      const Validity validity = classify(cells[cell], depth + 1);
      if (validity == Validity::INVALID)
        return validity;
      if (validity == Validity::UNDECIDED)
        *end++ = {CGAL::to_double(*std::min_element(cells[cell].begin(), cells[cell].end(), smaller)), cell};
    }

    Validity result = Validity::VALID;
    while (end != open.begin() && !imprecise_) {
      // the most suspicious cell first: a negative value is then found soon
      std::iter_swap(std::min_element(open.begin(), end), end - 1);
      --end;
      const Validity validity = subdivide(cells[end->second], depth + 1);
      if (validity == Validity::INVALID)
        return validity;
      if (validity == Validity::UNDECIDED)
        result = validity;
    }
    return result;
  }

  // only orders the cells, so that an approximation will do
  static bool smaller(const NT& x, const NT& y) { return CGAL::to_double(x) < CGAL::to_double(y); }

  Sign sign_;
  int maximum_depth_;
  int number_of_splits_ = 0;
  bool imprecise_ = false;
};

// Tier 0: most hexahedra of a good mesh, by the means of their edges.
//
// Let U, V, W be the means of the edge vectors along each direction, and a, b, c the largest distances of one from its
// mean. As a determinant is linear in each of its columns and at most the product of their lengths, all those that the
// coefficients are averages of differ from det(U, V, W) by at most (|U| + a) (|V| + b) (|W| + c) - |U| |V| |W|. The
// rounded operations change what is compared by less than 2^-45 of the first product, with components as in tier 1.
inline bool have_like_edges(const Edge_vectors<double>& edges)
{
  Coordinates<double> mean[3];
  double product = 1, largest_product = 1;
  int d = 0;
  for (const std::array<Coordinates<double>, 4>* along : {&edges.u, &edges.v, &edges.w}) {
    const std::array<Coordinates<double>, 4>& e = *along;
    Coordinates<double>& m = mean[d++];
    for (int x = 0; x < 3; ++x)
      m[x] = ((e[0][x] + e[1][x]) + (e[2][x] + e[3][x])) / 4;
    double farthest = 0;
    for (const Coordinates<double>& one : e) {
      const Coordinates<double> way = difference(one, m);
      farthest = (std::max)(farthest, scalar_product(way, way));
    }
    const double length = std::sqrt(scalar_product(m, m));
    product *= length;
    largest_product *= length + std::sqrt(farthest);
  }
  const double determinant = scalar_product(cross_product(mean[0], mean[1]), mean[2]);
  return determinant - (largest_product - product) > 0x1p-40 * largest_product;
}

// Tier 1: doubles with a bound of the error.
//
// Let A, B, C be the largest absolute values of a component of the edge vectors along u, v, w, and
// e = 2^-53. A determinant of three of them has six terms of at most A B C; a coefficient is an average
// of such determinants. Each term that enters the computed value has passed through at most 11 rounded
// operations: three differences of coordinates, product and sum of a cross product, the sum over
// k + m = c, product and two sums of a scalar product, two sums over i + n = a and j + l = b (halving
// is exact). So the error is at most 6 A B C ((1 + e)^11 - 1) < 67 e A B C. A fused multiply-add only
// leaves a rounding out.
// One depth of the subdivision takes two averages in each of the three directions. An average does not
// enlarge the errors of its arguments, and adds one rounding of a number of at most 6 A B C:
// 36 e A B C for a depth.
// The factors 256 and 80 have room for the double error of rounding modes other than to nearest, for the
// rounding of A B C itself, and for underflow: with A, B, C within 2^-300 and 2^300, an underflow moves a
// product of two components by at most 2^-1074, far below e A B >= 2^-653, and a product of three by
// as much, far below e A B C >= 2^-953.
struct Sign_of_rounded
{
  double unit; // e A B C

  int operator()(double x, int depth) const
  {
    const double bound = (256 + 80 * depth) * unit;
    return x > bound ? 1 : x < -bound ? -1 : 0;
  }
};

// Tier 2: intervals.
struct Sign_of_interval
{
  int operator()(const CGAL::Interval_nt<false>& x, int) const { return x.inf() > 0 ? 1 : x.sup() <= 0 ? -1 : 0; }
};

// Tier 3: exact numbers.
struct Sign_of_exact
{
  template <class NT>
  int operator()(const NT& x, int) const
  {
    return CGAL::is_positive(x) ? 1 : -1;
  }
};

// The edges along each direction may be scaled by a positive factor without changing a sign. These are
// the factors, powers of two, that bring the largest component of each direction into [2^-300, 2^300].
struct Scaling
{
  std::array<double, 3> largest; // after the scaling
  std::array<double, 3> factor;

  explicit Scaling(const Edge_vectors<double>& edges)
    : largest{{maximum(edges.u), maximum(edges.v), maximum(edges.w)}}
    , factor{{1, 1, 1}}
  {
    for (int d = 0; d < 3; ++d)
      if (!in_range(largest[d]) && largest[d] > 0 && std::isfinite(largest[d])) {
        // the factor for a denormal number must remain finite
        factor[d] = std::ldexp(1., -(std::max)(std::ilogb(largest[d]), -1000));
        largest[d] *= factor[d];
      }
  }

  bool applies() const { return in_range(largest[0]) && in_range(largest[1]) && in_range(largest[2]); }
  bool is_none() const { return factor[0] == 1 && factor[1] == 1 && factor[2] == 1; }

  template <class NT>
  void operator()(Edge_vectors<NT>& edges) const
  {
    if (is_none())
      return;
    int d = 0;
    for (auto* direction : {&edges.u, &edges.v, &edges.w}) {
      for (Coordinates<NT>& e : *direction)
        for (NT& x : e)
          x = x * NT(factor[d]);
      ++d;
    }
  }

private:
  static double maximum(const std::array<Coordinates<double>, 4>& edges)
  {
    double result = 0;
    for (const Coordinates<double>& e : edges)
      for (double x : e)
        result = (std::max)(result, std::abs(x));
    return result;
  }

  static bool in_range(double x) { return x > 0x1p-300 && x < 0x1p300; }
};

template <class NT>
Edge_vectors<NT> edge_vectors_of_type(const Hexahedron_coordinates& x)
{
  std::array<Coordinates<NT>, 8> y;
  for (int i = 0; i < 8; ++i)
    y[i] = {{NT(x[i][0]), NT(x[i][1]), NT(x[i][2])}};
  return Edge_vectors<NT>(y);
}

inline std::optional<Validity> rounded_validity(Edge_vectors<double> edges, const Scaling& scaling, int maximum_depth)
{
  scaling(edges);
  const double unit = 0x1p-53 * scaling.largest[0] * scaling.largest[1] * scaling.largest[2];
  return Subdivision<double, Sign_of_rounded>(Sign_of_rounded{unit}, maximum_depth)(jacobian_coefficients(edges));
}

inline std::optional<Validity> interval_validity(const Hexahedron_coordinates& x, const Scaling& scaling,
                                                 int maximum_depth)
{
  using Interval = CGAL::Interval_nt<false>;
  Interval::Protector upward_rounding;
  Edge_vectors<Interval> edges = edge_vectors_of_type<Interval>(x);
  scaling(edges);
  return Subdivision<Interval, Sign_of_interval>(Sign_of_interval(), maximum_depth)(jacobian_coefficients(edges));
}

template <class NT>
Validity exact_validity(const Hexahedron_coordinates& x, int maximum_depth)
{
  return *Subdivision<NT, Sign_of_exact>(Sign_of_exact(),
                                         maximum_depth)(jacobian_coefficients(edge_vectors_of_type<NT>(x)));
}

inline Validity hexahedron_validity(const Hexahedron_coordinates& x, int maximum_depth = default_maximum_depth)
{
  const Edge_vectors<double> edges(x);
  const Scaling scaling(edges);
  if (scaling.applies() && scaling.is_none() && have_like_edges(edges))
    return Validity::VALID;
  if (scaling.applies())
    if (const auto validity = rounded_validity(edges, scaling, maximum_depth))
      return *validity;
  for (const Coordinates<double>& p : x)
    for (double c : p)
      if (!std::isfinite(c))
        return Validity::INVALID;
  // where all edges of one direction vanish, so does the determinant
  if (scaling.largest[0] == 0 || scaling.largest[1] == 0 || scaling.largest[2] == 0)
    return Validity::INVALID;
  if (scaling.applies())
    if (const auto validity = interval_validity(x, scaling, maximum_depth))
      return *validity;
  return exact_validity<Exact_number>(x, maximum_depth);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_JACOBIAN_CERTIFICATE_H
