// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// validity.h: the certificate against the definition of the Jacobian determinant, evaluated without
// rounding, and its tiers against each other.

#include <CGAL/Exact_rational.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

#include "hexahedron_rotations.h"
#include "mesh_families.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;
namespace internal = CGAL::Hex_mesh_optimization::internal;
using HMO::Validity;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Hexahedron = std::array<Point, 8>;
using Integers = std::array<std::array<std::int64_t, 3>, 8>;
using Rational = CGAL::Exact_rational;

static Hexahedron box(double x, double y, double z)
{
  Hexahedron h;
  for (int i = 0; i < 8; ++i)
    h[i] = Point(x * unit_corners[i][0], y * unit_corners[i][1], z * unit_corners[i][2]);
  return h;
}

static Hexahedron with_coordinates(const Integers& h)
{
  Hexahedron result;
  for (int i = 0; i < 8; ++i)
    result[i] = Point(double(h[i][0]), double(h[i][1]), double(h[i][2]));
  return result;
}

// The determinant of the Jacobian matrix at (u, v, w) / n, times n^6, by the definition of the
// trilinear map: the derivative of sum_c prod_d (c_d u_d + (1 - c_d) (1 - u_d)) x_c.
template <class NT>
static NT jacobian(const std::array<std::array<NT, 3>, 8>& x, const std::array<NT, 3>& u, const NT& n)
{
  NT m[3][3];
  for (int direction = 0; direction < 3; ++direction)
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
      NT sum(0);
      for (int c = 0; c < 8; ++c) {
        NT weight(1);
        for (int d = 0; d < 3; ++d) {
          if (d == direction)
            weight = weight * NT(unit_corners[c][d] == 1 ? 1 : -1);
          else
            weight = weight * (unit_corners[c][d] == 1 ? u[d] : NT(n - u[d]));
        }
        sum = sum + weight * x[c][coordinate];
      }
      m[coordinate][direction] = sum;
    }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The smallest value on a lattice. No overflow for coordinates up to 256 and n up to 32.
static std::int64_t smallest_jacobian(const Integers& h, int n)
{
  std::int64_t result = std::numeric_limits<std::int64_t>::max();
  for (int u = 0; u <= n; ++u)
    for (int v = 0; v <= n; ++v)
      for (int w = 0; w <= n; ++w)
        result = (std::min)(result, jacobian<std::int64_t>(h, {{u, v, w}}, n));
  return result;
}

// Coordinates between -256 and 256
static Integers random_integers(std::mt19937& generator, int size, int noise)
{
  std::uniform_int_distribution<int> uniform(-noise, noise);
  Integers h;
  for (int i = 0; i < 8; ++i)
    for (int d = 0; d < 3; ++d)
      h[i][d] = size * (2 * unit_corners[i][d] - 1) + uniform(generator);
  return h;
}

// The families: more and more noisy cubes, nearly flat, turned, and with coincident corners.
static std::vector<Integers> families()
{
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> corner(0, 7);
  std::vector<Integers> result;
  for (int n = 0; n < 600; ++n)
    result.push_back(random_integers(generator, 100, 20 + n % 130));
  for (int n = 0; n < 300; ++n) {
    Integers h = random_integers(generator, 100, 40);
    for (int i = 0; i < 8; ++i)
      h[i][2] = unit_corners[i][2] * (1 + n % 3) + h[i][2] % (2 + n % 4);
    result.push_back(h);
  }
  for (int n = 0; n < 300; ++n) {
    Integers h = random_integers(generator, 100, 10);
    const double angle = .0105 * n;
    for (int i : {1, 2, 5, 6}) {
      const double y = double(h[i][1]), z = double(h[i][2]);
      h[i][1] = std::llround(std::cos(angle) * y - std::sin(angle) * z);
      h[i][2] = std::llround(std::sin(angle) * y + std::cos(angle) * z);
    }
    result.push_back(h);
  }
  for (int n = 0; n < 100; ++n) {
    Integers h = random_integers(generator, 100, 30);
    h[corner(generator)] = h[corner(generator)];
    result.push_back(h);
  }
  for (int n = 0; n < 100; ++n)
    result.push_back(random_integers(generator, 0, 2));
  return result;
}

static Validity certificate(const Integers& h) { return HMO::hexahedron_validity(with_coordinates(h)); }

TEST(Bezier_coefficients, agree_with_the_determinant)
{
  std::mt19937 generator(2);
  std::uniform_int_distribution<int> parameter(-10, 20);
  for (int n = 0; n < 20; ++n) {
    std::array<internal::Coordinates<Rational>, 8> x;
    const Integers h = random_integers(generator, 50, 100);
    for (int i = 0; i < 8; ++i)
      x[i] = {{Rational(double(h[i][0])), Rational(double(h[i][1])), Rational(double(h[i][2]))}};
    const auto b = internal::jacobian_coefficients(internal::Edge_vectors<Rational>(x));
    const auto cells = internal::split(b);

    auto polynomial = [](const internal::Bezier_coefficients<Rational>& coefficients,
                         const std::array<Rational, 3>& u) {
      Rational sum = 0, bernstein[3][3];
      for (int d = 0; d < 3; ++d) {
        bernstein[d][0] = (1 - u[d]) * (1 - u[d]);
        bernstein[d][1] = 2 * (1 - u[d]) * u[d];
        bernstein[d][2] = u[d] * u[d];
      }
      for (int i = 0; i < 27; ++i)
        sum += coefficients[i] * bernstein[0][i % 3] * bernstein[1][i / 3 % 3] * bernstein[2][i / 9];
      return sum;
    };

    for (int m = 0; m < 10; ++m) {
      const std::array<Rational, 3> u = {
        {Rational(parameter(generator)) / 7, Rational(parameter(generator)) / 11, Rational(parameter(generator)) / 13}};
      const Rational expected = jacobian<Rational>(x, u, 1);
      EXPECT_EQ(polynomial(b, u), expected);
      for (int cell = 0; cell < 8; ++cell) {
        const std::array<Rational, 3> local = {
          {2 * u[0] - (cell & 1), 2 * u[1] - (cell >> 1 & 1), 2 * u[2] - (cell >> 2)}};
        EXPECT_EQ(polynomial(cells[cell], local), expected);
      }
    }
  }
}

TEST(Validity, of_simple_hexahedra)
{
  EXPECT_EQ(HMO::hexahedron_validity(box(1, 1, 1)), Validity::VALID);
  EXPECT_EQ(HMO::hexahedron_validity(box(1e-3, 1, 1e5)), Validity::VALID);
  EXPECT_EQ(HMO::hexahedron_validity(box(1, 1, -1)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(box(1, 1, 0)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(box(1, 0, 0)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(box(0, 0, 0)), Validity::INVALID);
  const Hexahedron h = box(1, 2, 3);
  EXPECT_EQ(HMO::hexahedron_validity(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]), Validity::VALID);
  EXPECT_TRUE(HMO::is_valid_hexahedron(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]));
  EXPECT_FALSE(HMO::is_valid_hexahedron(h[4], h[5], h[6], h[7], h[0], h[1], h[2], h[3]));
}

TEST(Validity, agrees_with_dense_samples)
{
  int valid = 0, invalid = 0;
  for (const Integers& h : families()) {
    const Validity validity = certificate(h);
    const std::int64_t smallest = smallest_jacobian(h, 6);
    EXPECT_NE(validity, Validity::UNDECIDED);
    if (validity == Validity::VALID) {
      ++valid;
      EXPECT_GT(smallest, 0);
    }
    else {
      ++invalid;
      // the points that prove it are those of a lattice of a power of two
      EXPECT_TRUE(smallest <= 0 || smallest_jacobian(h, 32) <= 0);
    }
  }
  EXPECT_GT(valid, 300);
  EXPECT_GT(invalid, 300);
}

// The smallest of the values on a lattice, exactly, has a sign of -1, 0 or 1.
static int sign_of_smallest_jacobian(const internal::Hexahedron_coordinates& h, int n)
{
  using NT = internal::Exact_number;
  std::array<internal::Coordinates<NT>, 8> x;
  for (int i = 0; i < 8; ++i)
    x[i] = {{NT(h[i][0]), NT(h[i][1]), NT(h[i][2])}};
  int result = 1;
  for (int u = 0; u <= n && result >= 0; ++u)
    for (int v = 0; v <= n; ++v)
      for (int w = 0; w <= n; ++w) {
        const NT value = jacobian<NT>(x, {{NT(u), NT(v), NT(w)}}, NT(n));
        result = (std::min)(result, CGAL::is_positive(value) ? 1 : CGAL::is_zero(value) ? 0 : -1);
      }
  return result;
}

// The kinds of hexahedra of families(), but with coordinates that are no integers and of any magnitude.
static internal::Hexahedron_coordinates random_doubles(std::mt19937& generator, int n)
{
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double noise = .1 + .1 * (n % 8), thin = n / 8 % 4 == 1 ? std::ldexp(1., -(n % 50)) : 1;
  const double angle = n / 8 % 4 == 2 ? 1.7 * uniform(generator) : 0;
  const double unit = n % 5 == 0 ? 1e150 : n % 5 == 1 ? 1e-150 : 1;
  internal::Hexahedron_coordinates x;
  for (int i = 0; i < 8; ++i) {
    double p[3];
    for (int d = 0; d < 3; ++d)
      p[d] = unit_corners[i][d] - .5 + .5 * noise * uniform(generator);
    p[2] *= thin;
    const double a = p[0] > 0 ? angle : 0; // one side turned against the other
    x[i] = {{unit * p[0], unit * (std::cos(a) * p[1] - std::sin(a) * p[2]),
             unit * (std::sin(a) * p[1] + std::cos(a) * p[2])}};
  }
  if (n / 8 % 4 == 3)
    x[n % 8] = x[(n + 1) % 8];
  return x;
}

TEST(Validity, agrees_with_exact_samples_of_any_doubles)
{
  std::mt19937 generator(9);
  int valid = 0, invalid = 0;
  for (int n = 0; n < 480; ++n) {
    const internal::Hexahedron_coordinates x = random_doubles(generator, n);
    const Validity validity = internal::hexahedron_validity(x);
    ASSERT_NE(validity, Validity::UNDECIDED) << n;
    if (validity == Validity::VALID) {
      ++valid;
      EXPECT_EQ(sign_of_smallest_jacobian(x, 5), 1) << n;
      EXPECT_EQ(sign_of_smallest_jacobian(x, 8), 1) << n;
    }
    else {
      ++invalid;
      EXPECT_TRUE(sign_of_smallest_jacobian(x, 4) <= 0 || sign_of_smallest_jacobian(x, 16) <= 0) << n;
    }
  }
  EXPECT_GE(valid, 100);
  EXPECT_GE(invalid, 100);
}

TEST(Validity, finds_hexahedra_invalid_between_positive_corners)
{
  std::mt19937 generator(3);
  int found = 0;
  double best = 0;
  for (int n = 0; n < 20000; ++n) {
    const Integers h = random_integers(generator, 100, 100);
    if (smallest_jacobian(h, 1) <= 0 || smallest_jacobian(h, 4) > 0)
      continue;
    ++found;
    EXPECT_EQ(certificate(h), Validity::INVALID);
    EXPECT_GT(HMO::scaled_jacobian(with_coordinates(h)), 0);
    best = (std::max)(best, HMO::scaled_jacobian(with_coordinates(h)));
  }
  EXPECT_GE(found, 20);
  EXPECT_GT(best, .1);
}

TEST(Validity, needs_the_subdivision_for_some)
{
  std::mt19937 generator(4);
  int found = 0;
  for (int n = 0; n < 20000; ++n) {
    const Hexahedron h = with_coordinates(random_integers(generator, 100, 80));
    if (HMO::hexahedron_validity(h) != Validity::VALID || HMO::hexahedron_validity(h, 0) == Validity::VALID)
      continue;
    EXPECT_EQ(HMO::hexahedron_validity(h, 0), Validity::UNDECIDED);
    ++found;
  }
  EXPECT_GE(found, 10);
}

// A hexahedron with a determinant of (1 + (a - 1) u) (1 + (b - 1) u).
static Hexahedron with_roots(double a, double b)
{
  return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, a, 0), Point(0, 1, 0), Point(0, 0, 1), Point(1, 0, b),
           Point(1, a, b), Point(0, 1, 1)}};
}

TEST(Validity, where_the_determinant_touches_zero)
{
  // at corners
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(0, 1)), Validity::INVALID);
  // at u = 1/2, 1/4 and 3/4: corners of cells
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(-1, -1)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(-3, -3)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(-1 / 3., -1 / 3.)), Validity::UNDECIDED); // -1/3 is rounded
  // at u = 1/3: never
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(-2, -2)), Validity::UNDECIDED);
  EXPECT_FALSE(HMO::is_valid_hexahedron(with_roots(-2, -2)));
  // negative in between
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(-2, -1.99)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(std::nextafter(-1., 0), -1)), Validity::INVALID);
}

TEST(Validity, is_undecided_at_any_limit_on_the_subdivision)
{
  for (int depth : {-1, 0, 1, 50, 100, 1000, std::numeric_limits<int>::max()})
    EXPECT_EQ(HMO::hexahedron_validity(with_roots(-2, -2), depth), Validity::UNDECIDED) << depth;
}

// No generated mesh, tangled in any way, needs half the subdivision that is allowed.
TEST(Validity, of_generated_meshes_is_decided_soon)
{
  std::size_t valid = 0, invalid = 0, subdivided = 0;
  for (const Mesh_family& family : mesh_families())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Indexed_mesh mesh = family();
      if (seed % 4 == 1)
        HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, .05 * double(seed));
      if (seed % 4 == 2)
        HMO::rotate_hexahedra(mesh.points, mesh.hexahedra, seed, .3);
      if (seed % 4 == 3)
        HMO::jitter_boundary(mesh.points, mesh.hexahedra, seed, .4);
      for (const auto& hexahedron : mesh.hexahedra) {
        const internal::Hexahedron_coordinates x = internal::hexahedron_coordinates(mesh.points, hexahedron);
        const Validity validity = internal::hexahedron_validity(x, internal::default_maximum_depth / 2);
        EXPECT_NE(validity, Validity::UNDECIDED);
        ++(validity == Validity::VALID ? valid : invalid);
        subdivided += internal::hexahedron_validity(x, 0) == Validity::UNDECIDED;
      }
    }
  EXPECT_GT(valid, 5000u);
  EXPECT_GT(invalid, 1000u);
  EXPECT_GT(subdivided, 0u);
}

TEST(Validity, decides_what_rounding_hides)
{
  // The top is one unit in the last place above the bottom, or below.
  const double tiny = std::numeric_limits<double>::epsilon();
  for (double sign : {1., 0., -1.}) {
    Hexahedron h = box(1, 1, 1);
    for (int i = 4; i < 8; ++i)
      h[i] = Point(h[i].x() + .3, h[i].y() + .7, 1 + sign * tiny);
    for (int i = 0; i < 4; ++i)
      h[i] = Point(h[i].x(), h[i].y(), 1);
    EXPECT_EQ(HMO::hexahedron_validity(h), sign > 0 ? Validity::VALID : Validity::INVALID);

    // the same, sheared so that no coordinate is constant
    const double third = 1 / 3.;
    Hexahedron g = h;
    for (Point& p : g)
      p = Point(p.x(), p.y(), p.z() + third * p.x());
    const Validity exact = internal::exact_validity<CGAL::MP_Float>(internal::hexahedron_coordinates(g), 20);
    EXPECT_EQ(HMO::hexahedron_validity(g), exact);
  }
}

TEST(Validity, does_not_depend_on_the_numbering)
{
  std::mt19937 generator(5);
  for (int n = 0; n < 200; ++n) {
    const Hexahedron h = with_coordinates(random_integers(generator, 60, 10 + n % 60));
    const Validity validity = HMO::hexahedron_validity(h);
    for (const std::array<int, 8>& numbering : numberings(1)) {
      Hexahedron g;
      for (int i = 0; i < 8; ++i)
        g[i] = h[numbering[i]];
      EXPECT_EQ(HMO::hexahedron_validity(g), validity);
    }
    if (validity == Validity::VALID)
      for (const std::array<int, 8>& numbering : numberings(-1)) {
        Hexahedron g;
        for (int i = 0; i < 8; ++i)
          g[i] = h[numbering[i]];
        EXPECT_EQ(HMO::hexahedron_validity(g), Validity::INVALID);
      }
  }
}

TEST(Validity, does_not_depend_on_the_unit_of_any_axis)
{
  std::mt19937 generator(6);
  for (int n = 0; n < 100; ++n) {
    const Integers h = random_integers(generator, 60, 10 + n % 60);
    const Validity validity = certificate(h);
    auto scaled = [&](double x, double y, double z) {
      Hexahedron g;
      for (int i = 0; i < 8; ++i)
        g[i] = Point(x * double(h[i][0]), y * double(h[i][1]), z * double(h[i][2]));
      return HMO::hexahedron_validity(g);
    };
    for (double s : {0x1p-1074, 0x1p-900, 0x1p-500, 0x1p-301, 0x1p300, 0x1p500, 0x1p1014})
      EXPECT_EQ(scaled(s, s, s), validity) << s;
    EXPECT_EQ(scaled(0x1p-1074, 1, 0x1p1014), validity);
    EXPECT_EQ(scaled(0x1p1014, 0x1p-1074, 0x1p-300), validity);
    EXPECT_EQ(scaled(1, 0x1p-40, 0x1p40), validity);
  }
  for (double s : {1e-150, 1e150, 1e300}) {
    EXPECT_EQ(HMO::hexahedron_validity(box(s, s, s)), Validity::VALID);
    EXPECT_EQ(HMO::hexahedron_validity(box(s, s, -s)), Validity::INVALID);
  }
  // differences that overflow
  Hexahedron h = box(1, 1, 1);
  for (Point& p : h)
    p = Point((2 * p.x() - 1) * 1.7e308, p.y(), p.z());
  EXPECT_EQ(HMO::hexahedron_validity(h), Validity::VALID);
}

TEST(Validity, of_coordinates_that_are_not_finite)
{
  for (double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity()})
    for (int i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d) {
        internal::Hexahedron_coordinates x = internal::hexahedron_coordinates(box(1, 1, 1));
        x[i][d] = wrong;
        EXPECT_EQ(internal::hexahedron_validity(x), Validity::INVALID);
      }
}

// Answers of the tiers where they have one, on hexahedra from harmless to degenerate up to a rounding.
TEST(Tiers, agree)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int answers_by_means = 0, rounded_answers = 0, interval_answers = 0, total = 0;
  for (int n = 0; n < 1500; ++n) {
    // a map of rank 3 or 2, noise from large to the rounding of the coordinates
    double matrix[3][3];
    for (auto& row : matrix)
      for (double& m : row)
        m = uniform(generator);
    if (n % 3 == 0)
      for (int d = 0; d < 3; ++d)
        matrix[2][d] = matrix[0][d] - matrix[1][d];
    const double noise = std::ldexp(1., -(n % 60));
    internal::Hexahedron_coordinates x;
    for (int i = 0; i < 8; ++i)
      for (int d = 0; d < 3; ++d)
        x[i][d] = matrix[d][0] * unit_corners[i][0] + matrix[d][1] * unit_corners[i][1] +
                  matrix[d][2] * unit_corners[i][2] + noise * uniform(generator);

    const internal::Edge_vectors<double> edges(x);
    const internal::Scaling scaling(edges);
    ASSERT_TRUE(scaling.applies());
    const Validity exact = internal::exact_validity<internal::Exact_number>(x, 20);
    EXPECT_EQ(internal::exact_validity<CGAL::MP_Float>(x, 20), exact);
    EXPECT_EQ(internal::hexahedron_validity(x), exact);
    ++total;
    if (internal::have_like_edges(edges)) {
      ++answers_by_means;
      EXPECT_EQ(exact, Validity::VALID);
    }
    if (const auto rounded = internal::rounded_validity(edges, scaling, 20)) {
      ++rounded_answers;
      EXPECT_EQ(*rounded, exact);
    }
    if (const auto interval = internal::interval_validity(x, scaling, 20)) {
      ++interval_answers;
      EXPECT_EQ(*interval, exact);
    }
  }
  // each tier is needed
  EXPECT_GT(answers_by_means, total / 10);
  EXPECT_GT(rounded_answers, total / 2);
  EXPECT_GT(interval_answers, rounded_answers);
  EXPECT_LT(interval_answers, total);
}

TEST(Tiers, bound_of_the_rounding_error_holds)
{
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double largest = 0;
  for (int rounding : {CGAL_FE_TONEAREST, CGAL_FE_UPWARD, CGAL_FE_DOWNWARD, CGAL_FE_TOWARDZERO})
    for (int n = 0; n < 100; ++n) {
      internal::Hexahedron_coordinates x;
      for (auto& p : x)
        for (double& c : p)
          c = uniform(generator) + (n % 2) * 1000;
      internal::Bezier_coefficients<double> rounded;
      double unit;
      std::array<internal::Bezier_coefficients<double>, 8> rounded_cells;
      {
        const CGAL::Protect_FPU_rounding<true> protect((CGAL::FPU_CW_t(rounding)));
        const internal::Edge_vectors<double> edges(x);
        const internal::Scaling scaling(edges);
        unit = 0x1p-53 * scaling.largest[0] * scaling.largest[1] * scaling.largest[2];
        rounded = internal::jacobian_coefficients(edges);
        rounded_cells = internal::split(internal::split(rounded)[3]);
      }
      const auto exact = internal::jacobian_coefficients(internal::edge_vectors_of_type<Rational>(x));
      const auto exact_cells = internal::split(internal::split(exact)[3]);
      for (int i = 0; i < 27; ++i) {
        const double error = std::abs(CGAL::to_double(exact[i] - Rational(rounded[i]))) / unit;
        largest = (std::max)(largest, error);
        EXPECT_LE(error, 134);
        for (int cell = 0; cell < 8; ++cell)
          EXPECT_LE(std::abs(CGAL::to_double(exact_cells[cell][i] - Rational(rounded_cells[cell][i]))) / unit,
                    134 + 2 * 72);
      }
    }
  EXPECT_GT(largest, 1); // the bound is not of another magnitude
}

TEST(Tiers, leave_the_rounding_mode_alone)
{
  const CGAL::FPU_CW_t before = CGAL::FPU_get_cw();
  EXPECT_EQ(HMO::hexahedron_validity(box(1, 1, 0)), Validity::INVALID);
  EXPECT_EQ(HMO::hexahedron_validity(with_roots(0, 1)), Validity::INVALID);
  EXPECT_EQ(CGAL::FPU_get_cw(), before);
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    EXPECT_EQ(HMO::hexahedron_validity(box(.1, .3, .7)), Validity::VALID);
    EXPECT_EQ(HMO::hexahedron_validity(with_roots(0, 1)), Validity::INVALID);
    EXPECT_EQ(CGAL::FPU_get_cw(), CGAL::FPU_CW_t(CGAL_FE_UPWARD));
  }
}

TEST(Invalid_hexahedra, are_listed_by_index)
{
  std::vector<CGAL::Simple_cartesian<Rational>::Point_3> points;
  std::vector<std::array<unsigned, 8>> hexahedra;
  for (const Hexahedron& h :
       {box(1, 1, 1), box(1, 1, -1), with_roots(1, 2), with_roots(-2, -2), with_roots(-1, -2), box(2, 2, 2)}) {
    hexahedra.emplace_back();
    for (int i = 0; i < 8; ++i) {
      hexahedra.back()[i] = unsigned(points.size());
      points.emplace_back(h[i].x(), h[i].y(), h[i].z());
    }
  }
  std::vector<std::size_t> invalid;
  HMO::invalid_hexahedra(points, hexahedra, std::back_inserter(invalid));
  EXPECT_EQ(invalid, (std::vector<std::size_t>{1, 3, 4}));
}
