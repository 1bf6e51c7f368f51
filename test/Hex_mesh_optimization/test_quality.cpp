// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// quality.h: values known by hand, their invariances, and the statistics of small meshes.

#include <CGAL/Exact_rational.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Simple_cartesian.h>

#include "hexahedron_rotations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Hexahedron = std::array<Point, 8>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

static Hexahedron box(double x, double y, double z)
{
  Hexahedron h;
  for (int i = 0; i < 8; ++i)
    h[i] = Point(x * unit_corners[i][0], y * unit_corners[i][1], z * unit_corners[i][2]);
  return h;
}

template <class Map>
static Hexahedron mapped(Hexahedron h, Map map)
{
  for (Point& p : h)
    p = map(p);
  return h;
}

static Hexahedron random_hexahedron(std::mt19937& generator, double noise)
{
  std::uniform_real_distribution<double> uniform(-noise, noise);
  Hexahedron h;
  for (int i = 0; i < 8; ++i) {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    h[i] = Point(unit_corners[i][0] + x, unit_corners[i][1] + y, unit_corners[i][2] + z);
  }
  return h;
}

// A rotation about an axis that is no coordinate axis, written out by hand.
static Point rotated(const Point& p)
{
  const double c = std::cos(.7), s = std::sin(.7);
  const Point q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  const double d = std::cos(1.1), t = std::sin(1.1);
  return Point(q.x(), d * q.y() - t * q.z(), t * q.y() + d * q.z());
}

// The definitions, with the neighbors of each corner listed.
static double naive_scaled_jacobian(const Hexahedron& h)
{
  static const int neighbors[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                      {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  double result = 2;
  for (int i = 0; i < 8; ++i) {
    const Vector a = h[neighbors[i][0]] - h[i], b = h[neighbors[i][1]] - h[i], c = h[neighbors[i][2]] - h[i];
    const double length = std::sqrt(a.squared_length() * b.squared_length() * c.squared_length());
    result = (std::min)(result, CGAL::determinant(a, b, c) / length);
  }
  return result;
}

static double naive_center(const Hexahedron& h)
{
  const Vector a = (h[1] - h[0]) + (h[2] - h[3]) + (h[5] - h[4]) + (h[6] - h[7]);
  const Vector b = (h[3] - h[0]) + (h[2] - h[1]) + (h[7] - h[4]) + (h[6] - h[5]);
  const Vector c = (h[4] - h[0]) + (h[5] - h[1]) + (h[6] - h[2]) + (h[7] - h[3]);
  return CGAL::determinant(a, b, c) / std::sqrt(a.squared_length() * b.squared_length() * c.squared_length());
}

TEST(Scaled_jacobian, of_boxes_is_exactly_one)
{
  for (const Hexahedron& h : {box(1, 1, 1), box(2, 3, 5), box(1e-3, 1, 1e6), box(1e-150, 1e-150, 1e-150),
                              box(1e150, 1e150, 1e150), box(1e-150, 1, 1e150)}) {
    EXPECT_EQ(HMO::scaled_jacobian(h), 1);
    EXPECT_EQ(HMO::scaled_jacobian_with_center(h), 1);
  }
}

TEST(Scaled_jacobian, of_sheared_boxes)
{
  for (double shear : {.1, .5, 1., 3., -2.}) {
    const Hexahedron h = mapped(box(1, 1, 1),
                                [=](const Point& p) { return Point(p.x() + shear * p.z(), p.y(), p.z()); });
    EXPECT_NEAR(HMO::scaled_jacobian(h), 1 / std::sqrt(1 + shear * shear), 1e-15);
    EXPECT_NEAR(HMO::scaled_jacobian_with_center(h), 1 / std::sqrt(1 + shear * shear), 1e-15);
  }
}

TEST(Scaled_jacobian, of_a_prism_over_a_rhombus_is_the_sine_of_its_angle)
{
  const double angle = 2 * std::acos(0.) * 2 / 3; // 120 degrees
  const Hexahedron h = mapped(box(1, 1, 1), [=](const Point& p) {
    return Point(p.x() + std::cos(angle) * p.y(), std::sin(angle) * p.y(), p.z());
  });
  EXPECT_NEAR(HMO::scaled_jacobian(h), std::sqrt(3.) / 2, 1e-15);
}

TEST(Scaled_jacobian, agrees_with_the_definition)
{
  std::mt19937 generator(1);
  for (int n = 0; n < 2000; ++n) {
    const Hexahedron h = random_hexahedron(generator, .7);
    EXPECT_NEAR(HMO::scaled_jacobian(h), naive_scaled_jacobian(h), 1e-13);
    EXPECT_NEAR(HMO::scaled_jacobian_with_center(h), (std::min)(naive_scaled_jacobian(h), naive_center(h)), 1e-13);
  }
}

// A long hexahedron from a square at x = 0 to a rhombus at x = 4, the sides of which are those of the
// square turned by 170 and by 190 degrees. Halfway, their averages point to 85 and 5 degrees, so that the
// principal axes have the determinant sin(-80 degrees).
static Hexahedron turned_hexahedron()
{
  const double degree = std::acos(0.) / 90;
  Hexahedron h;
  for (int i = 0; i < 8; ++i) {
    const double s = unit_corners[i][1] - .5, t = unit_corners[i][2] - .5;
    h[i] = unit_corners[i][0] == 0 ? Point(0, s, t)
                                   : Point(4, s * std::cos(170 * degree) + t * std::cos(280 * degree),
                                           s * std::sin(170 * degree) + t * std::sin(280 * degree));
  }
  return h;
}

TEST(Scaled_jacobian, with_center_is_the_smaller_one_of_a_turned_hexahedron)
{
  const Hexahedron h = turned_hexahedron();
  EXPECT_GT(HMO::scaled_jacobian(h), .8);
  EXPECT_NEAR(HMO::scaled_jacobian_with_center(h), -std::sin(std::acos(0.) * 8 / 9), 1e-14);
}

TEST(Scaled_jacobian, does_not_change_with_unit_position_and_direction)
{
  std::mt19937 generator(3);
  for (int n = 0; n < 200; ++n) {
    const Hexahedron h = random_hexahedron(generator, .4);
    const double quality = HMO::scaled_jacobian(h), with_center = HMO::scaled_jacobian_with_center(h);
    const double ratio = HMO::edge_ratio(h);
    for (double scale : {1e-150, 1e-100, 1e-6, 1e-3, 1e3, 1e6, 1e100, 1e150}) {
      const Hexahedron g = mapped(h,
                                  [=](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); });
      EXPECT_NEAR(HMO::scaled_jacobian(g), quality, 1e-13);
      EXPECT_NEAR(HMO::scaled_jacobian_with_center(g), with_center, 1e-13);
      EXPECT_NEAR(HMO::edge_ratio(g), ratio, 1e-12 * ratio);
    }
    const Hexahedron g = mapped(h, [](const Point& p) { return rotated(p) + Vector(3, -7, 11); });
    EXPECT_NEAR(HMO::scaled_jacobian(g), quality, 1e-13);
    EXPECT_NEAR(HMO::scaled_jacobian_with_center(g), with_center, 1e-13);
    EXPECT_NEAR(HMO::edge_ratio(g), ratio, 1e-12 * ratio);
  }
}

TEST(Scaled_jacobian, does_not_change_with_the_numbering)
{
  ASSERT_EQ(numberings(1).size(), 24u);
  std::mt19937 generator(4);
  for (int n = 0; n < 100; ++n) {
    const Hexahedron h = random_hexahedron(generator, .5);
    for (const std::array<int, 8>& numbering : numberings(1)) {
      Hexahedron g;
      for (int i = 0; i < 8; ++i)
        g[i] = h[numbering[i]];
      EXPECT_NEAR(HMO::scaled_jacobian(g), HMO::scaled_jacobian(h), 1e-14);
      EXPECT_NEAR(HMO::scaled_jacobian_with_center(g), HMO::scaled_jacobian_with_center(h), 1e-14);
      EXPECT_DOUBLE_EQ(HMO::edge_ratio(g), HMO::edge_ratio(h));
    }
  }
}

TEST(Scaled_jacobian, is_negative_for_mirrored_numberings)
{
  const Hexahedron h = box(1, 2, 3);
  for (const std::array<int, 8>& numbering : numberings(-1)) {
    Hexahedron g;
    for (int i = 0; i < 8; ++i)
      g[i] = h[numbering[i]];
    EXPECT_EQ(HMO::scaled_jacobian(g), -1);
    EXPECT_EQ(HMO::edge_ratio(g), 3);
  }
}

TEST(Scaled_jacobian, of_degenerate_hexahedra)
{
  // flat, with all edges longer than zero
  const Hexahedron flat = mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x() + 2 * p.z(), p.y(), 0); });
  EXPECT_EQ(HMO::scaled_jacobian(flat), 0);
  EXPECT_EQ(HMO::scaled_jacobian_with_center(flat), 0);
  EXPECT_TRUE(std::isfinite(HMO::edge_ratio(flat)));

  // a prism over a triangle: two edges of length zero
  Hexahedron prism = box(1, 1, 1);
  prism[3] = prism[2];
  prism[7] = prism[6];
  EXPECT_EQ(HMO::scaled_jacobian(prism), -1);
  EXPECT_EQ(HMO::edge_ratio(prism), infinity);

  const Hexahedron point = box(0, 0, 0);
  EXPECT_EQ(HMO::scaled_jacobian(point), -1);
  EXPECT_EQ(HMO::scaled_jacobian_with_center(point), -1);
  EXPECT_EQ(HMO::edge_ratio(point), infinity);

  for (double wrong : {nan_value, infinity, -infinity})
    for (int i = 0; i < 8; ++i) {
      Hexahedron h = box(1, 1, 1);
      h[i] = Point(h[i].x(), wrong, h[i].z());
      EXPECT_EQ(HMO::scaled_jacobian(h), -1);
      EXPECT_EQ(HMO::scaled_jacobian_with_center(h), -1);
      EXPECT_EQ(HMO::edge_ratio(h), infinity);
    }
}

TEST(Scaled_jacobian, of_points_of_other_kernels_and_containers)
{
  const double expected = 1 / std::sqrt(2.);
  const Hexahedron h = mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x() + p.z(), p.y(), p.z()); });
  EXPECT_NEAR(HMO::scaled_jacobian(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]), expected, 1e-15);
  EXPECT_NEAR(HMO::scaled_jacobian_with_center(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]), expected, 1e-15);
  EXPECT_NEAR(HMO::edge_ratio(h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]), std::sqrt(2.), 1e-15);

  using Exact_point = CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3;
  std::vector<Exact_point> exact;
  for (const Point& p : h)
    exact.push_back(Exact_point(p.x(), p.y(), p.z()));
  EXPECT_NEAR(HMO::scaled_jacobian(exact), expected, 1e-15);
  EXPECT_NEAR(HMO::edge_ratio(exact), std::sqrt(2.), 1e-15);
}

TEST(Edge_ratio, sees_what_the_scaled_jacobian_does_not)
{
  EXPECT_EQ(HMO::edge_ratio(box(1, 1, 1)), 1);
  EXPECT_EQ(HMO::edge_ratio(box(1, 4, 2)), 4);
  EXPECT_DOUBLE_EQ(HMO::edge_ratio(box(1e-150, 1, 1e150)), 1e300);
}

namespace {

// Hexahedra that share no vertices
struct Mesh
{
  std::deque<Point> points;
  std::vector<std::vector<int>> hexahedra;

  void add(const Hexahedron& h)
  {
    hexahedra.emplace_back(8);
    std::iota(hexahedra.back().begin(), hexahedra.back().end(), int(points.size()));
    points.insert(points.end(), h.begin(), h.end());
  }
};

} // namespace

TEST(Statistics, of_a_mesh_made_by_hand)
{
  Mesh mesh;
  mesh.points.push_back(Point(nan_value, 0, 0)); // belongs to no hexahedron
  mesh.add(box(1, 1, 1));
  mesh.add(mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x() + .75 * p.z(), p.y(), p.z()); })); // .8
  mesh.add(mapped(box(1, 2, 1), [](const Point& p) { return Point(p.x(), p.y(), -p.z()); }));              // -1
  mesh.add(box(3, 1, 1));

  const std::vector<double> expected = {1, .8, -1, 1};
  const std::vector<double> qualities = HMO::scaled_jacobians(mesh.points, mesh.hexahedra);
  ASSERT_EQ(qualities.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(qualities[i], expected[i], 1e-15);

  const HMO::Quality_statistics s = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_EQ(s.number_of_hexahedra, 4u);
  EXPECT_EQ(s.number_of_inverted, 1u);
  EXPECT_EQ(s.number_of_invalid, 1u);
  EXPECT_EQ(s.minimum, -1);
  EXPECT_NEAR(s.average, .45, 1e-15);
  EXPECT_NEAR(s.standard_deviation, std::sqrt((2 * .55 * .55 + .35 * .35 + 1.45 * 1.45) / 4), 1e-15);
  EXPECT_EQ(s.minimum_with_center, -1);
  EXPECT_NEAR(s.average_with_center, .45, 1e-15);
  EXPECT_EQ(s.maximum_edge_ratio, 3);
  EXPECT_EQ(s.median_edge_ratio, 2); // of 1, 1.25, 2, 3
  EXPECT_EQ(s.edge_ratio_99, 3);
}

TEST(Statistics, percentiles_of_the_edge_ratio)
{
  Mesh mesh;
  for (int i = 0; i < 200; ++i)
    mesh.add(box(1, 1, 1 + (i * 77) % 200)); // 1, ..., 200 in another order
  const HMO::Quality_statistics s = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_EQ(s.median_edge_ratio, 101);
  EXPECT_EQ(s.edge_ratio_99, 199);
  EXPECT_EQ(s.maximum_edge_ratio, 200);
  EXPECT_EQ(s.standard_deviation, 0);
  EXPECT_EQ(s.minimum, 1);
}

TEST(Statistics, count_hexahedra_that_are_invalid_between_their_corners)
{
  Mesh mesh;
  mesh.add(turned_hexahedron());
  const HMO::Quality_statistics s = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_EQ(s.number_of_inverted, 0u);
  EXPECT_GT(s.minimum, .8);
  EXPECT_EQ(s.number_of_invalid, 1u);
  EXPECT_LT(s.minimum_with_center, 0);
}

TEST(Statistics, of_a_linear_cell_complex)
{
  Mesh mesh;
  mesh.add(box(1, 1, 1));
  mesh.add(turned_hexahedron());
  mesh.add(box(1, 2, -3));
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>> lcc;
  HMO::hexahedra_to_linear_cell_complex(mesh.points, mesh.hexahedra, lcc);
  const HMO::Quality_statistics s = HMO::quality_statistics(lcc);
  const HMO::Quality_statistics expected = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_EQ(s.number_of_hexahedra, 3u);
  EXPECT_EQ(s.number_of_inverted, 1u);
  EXPECT_EQ(s.number_of_invalid, 2u);
  EXPECT_EQ(s.minimum, expected.minimum);
  EXPECT_NEAR(s.average, expected.average, 1e-15);
  EXPECT_EQ(s.maximum_edge_ratio, expected.maximum_edge_ratio);
}

TEST(Statistics, of_an_empty_mesh_are_zero)
{
  const Mesh mesh;
  const HMO::Quality_statistics s = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  EXPECT_EQ(s.number_of_hexahedra, 0u);
  EXPECT_EQ(s.number_of_invalid, 0u);
  EXPECT_EQ(s.minimum, 0);
  EXPECT_EQ(s.average, 0);
  EXPECT_EQ(s.standard_deviation, 0);
  EXPECT_EQ(s.maximum_edge_ratio, 0);
  EXPECT_TRUE(HMO::scaled_jacobians(mesh.points, mesh.hexahedra).empty());
}

TEST(Histogram, has_half_open_bins_and_includes_the_ends)
{
  Mesh mesh;
  mesh.add(box(1, 1, 1));                                                                                  // 1
  mesh.add(mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x(), p.y(), -p.z()); }));              // -1
  mesh.add(mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x() + 2 * p.z(), p.y(), 0); }));       // 0
  mesh.add(mapped(box(1, 1, 1), [](const Point& p) { return Point(p.x() + .75 * p.z(), p.y(), p.z()); })); // .8
  EXPECT_EQ(HMO::quality_histogram(mesh.points, mesh.hexahedra, 1), (std::vector<std::size_t>{4}));
  EXPECT_EQ(HMO::quality_histogram(mesh.points, mesh.hexahedra, 2), (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(HMO::quality_histogram(mesh.points, mesh.hexahedra, 3), (std::vector<std::size_t>{1, 1, 2}));
  EXPECT_EQ(HMO::quality_histogram(mesh.points, mesh.hexahedra, 4), (std::vector<std::size_t>{1, 0, 1, 2}));
}

TEST(Histogram, counts_every_hexahedron_once)
{
  std::mt19937 generator(5);
  Mesh mesh;
  for (int n = 0; n < 500; ++n)
    mesh.add(random_hexahedron(generator, .6));
  for (std::size_t bins : {1, 7, 20, 1000}) {
    const std::vector<std::size_t> histogram = HMO::quality_histogram(mesh.points, mesh.hexahedra, bins);
    ASSERT_EQ(histogram.size(), bins);
    EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), std::size_t(0)), 500u);
  }
  const std::vector<std::size_t> halves = HMO::quality_histogram(mesh.points, mesh.hexahedra, 2);
  EXPECT_EQ(halves[0], HMO::quality_statistics(mesh.points, mesh.hexahedra).number_of_inverted);
}
