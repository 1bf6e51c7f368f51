// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What optimize_hex_mesh() guarantees, over generated meshes of all families.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "boundary_surface_mesh.h"
#include "Marked_vertices.h"
#include "mesh_checks.h"
#include "mesh_families.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/squared_distance_3.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Kernel = Indexed_mesh::Kernel;
using Point = Indexed_mesh::Point;
using Points = std::vector<Point>;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using HMO::Method;
using HMO::Return_code;
using HMO::Status;

template <class NamedParameters>
Status optimize(Indexed_mesh& mesh, const NamedParameters& np)
{
  return CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
}

// The status tells what is there, by measures of its own
void expect_honest(const Indexed_mesh& input, const Indexed_mesh& result, const Status& status)
{
  const HMO::Quality_statistics before = HMO::quality_statistics(input.points, input.hexahedra);
  const HMO::Quality_statistics after = HMO::quality_statistics(result.points, result.hexahedra);
  EXPECT_EQ(status.before.number_of_inverted, before.number_of_inverted);
  EXPECT_EQ(status.before.minimum, before.minimum);
  EXPECT_EQ(status.after.number_of_inverted, after.number_of_inverted);
  EXPECT_EQ(status.after.number_of_invalid, after.number_of_invalid);
  EXPECT_EQ(status.after.minimum, after.minimum);
  EXPECT_EQ(status.after.average, after.average);
  EXPECT_EQ(status.invalid_hexahedra.size(), after.number_of_invalid);
  EXPECT_EQ(status.valid_mesh(), after.number_of_invalid == 0);
  if (status.return_code == Return_code::NO_IMPROVEMENT) {
    EXPECT_EQ(result.points, input.points);
  }
}

void expect_never_worse(const Status& status)
{
  EXPECT_LE(status.after.number_of_inverted, status.before.number_of_inverted);
  if (status.before.number_of_invalid == 0) {
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_GE(status.after.minimum, status.before.minimum);
  }
}

class Optimize_hex_mesh : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Optimize_hex_mesh, ::testing::ValuesIn(mesh_families()), Family_name());

// --- Untangling -------------------------------------------------------------------

// The boundary is intact: a valid interior exists
TEST_P(Optimize_hex_mesh, untangles_a_scrambled_interior)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    Indexed_mesh mesh = GetParam()();
    HMO::scramble_interior(mesh.points, mesh.hexahedra, seed);
    const Indexed_mesh input = mesh;
    const Status status = optimize(mesh, params::optimization_method(Method::RECTIFICATION));
    expect_honest(input, mesh, status);
    expect_never_worse(status);
    EXPECT_GT(status.before.number_of_inverted, 0u);
    EXPECT_TRUE(status.valid_mesh()) << status.after.number_of_inverted << " inverted of "
                                     << status.before.number_of_inverted << ", minimum " << status.after.minimum;
    EXPECT_GT(status.after.minimum, 0);
  }
}

TEST_P(Optimize_hex_mesh, untangles_within_a_fixed_boundary)
{
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    SCOPED_TRACE(seed);
    Indexed_mesh mesh = GetParam()();
    HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, 1.);
    const Indexed_mesh input = mesh;
    const Status status = optimize(mesh, params::fixed_boundary(true).optimization_method(Method::RECTIFICATION));
    expect_honest(input, mesh, status);
    expect_never_worse(status);
    const auto complex = mesh.complex();
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (complex.is_on_boundary[v]) {
        EXPECT_EQ(mesh.points[v], input.points[v]) << v;
      }
    EXPECT_TRUE(status.valid_mesh()) << status.after.number_of_inverted << ", minimum " << status.after.minimum;
    EXPECT_NEAR(status.deviation.maximum, 0, 1e-12 * mesh.mean_edge_length());
  }
}

// As in the paper, Section 4: an interior vertex held away from its place. Twice the edge length always comes out
// valid; of four times, nothing is promised but that the result is no worse.
TEST(Optimize_hex_mesh_with_constraints, untangles_around_a_displaced_vertex)
{
  for (int edges : {2, 4})
    for (std::uint64_t seed = 0, tried = 0; tried < 3; ++seed) {
      Indexed_mesh mesh;
      const int n = 9;
      HMO::make_block(mesh.points, mesh.hexahedra, {{n, n, n}}, {{double(n), double(n), double(n)}});
      const std::size_t v = HMO::displace_vertex(mesh.points, mesh.hexahedra, seed, edges);
      const Point place = mesh.points[v];
      bool inside = true; // and with room for the hexahedra between it and the boundary
      for (int d = 0; d < 3; ++d)
        inside = inside && place[d] > 1.5 && place[d] < n - 1.5;
      if (!inside)
        continue;
      ++tried;
      SCOPED_TRACE(seed);
      const Indexed_mesh input = mesh;
      std::vector<char> marks(mesh.points.size(), false);
      marks[v] = true;
      const Status status = optimize(
        mesh, params::vertex_is_constrained_map(Marked_vertices{&marks}).optimization_method(Method::RECTIFICATION));
      EXPECT_EQ(mesh.points[v], place);
      expect_honest(input, mesh, status);
      expect_never_worse(status);
      EXPECT_TRUE(edges > 2 || status.valid_mesh())
        << status.after.number_of_inverted << " of " << status.before.number_of_inverted << ", minimum "
        << status.after.minimum;
    }
}

TEST_P(Optimize_hex_mesh, keeps_constrained_vertices)
{
  for (Method method : {Method::RECTIFICATION, Method::FULL}) {
    Indexed_mesh mesh = GetParam()();
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 5, .6);
    const Indexed_mesh input = mesh;
    std::vector<char> marks(mesh.points.size());
    for (std::size_t v = 0; v < marks.size(); ++v)
      marks[v] = v % 5 == 0;
    const Status status =
      optimize(mesh, params::vertex_is_constrained_map(Marked_vertices{&marks}).optimization_method(method));
    expect_honest(input, mesh, status);
    expect_never_worse(status);
    for (std::size_t v = 0; v < marks.size(); ++v)
      if (marks[v]) {
        EXPECT_EQ(mesh.points[v], input.points[v]) << v;
      }
  }
}

TEST(Optimize_hex_mesh_with_constraints, moves_nothing_when_all_vertices_are_held)
{
  Indexed_mesh mesh = mesh_families()[0]();
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  const Indexed_mesh input = mesh;
  const std::vector<char> marks(mesh.points.size(), true);
  const Status status = optimize(mesh, params::vertex_is_constrained_map(Marked_vertices{&marks}));
  EXPECT_EQ(mesh.points, input.points);
  EXPECT_EQ(status.return_code, Return_code::NO_IMPROVEMENT);
  EXPECT_FALSE(status.valid_mesh());
  expect_honest(input, mesh, status);
}

TEST_P(Optimize_hex_mesh, keeps_points_that_no_hexahedron_uses)
{
  Indexed_mesh mesh = GetParam()();
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 2, 1.);
  Indexed_mesh plain = mesh;
  mesh.points.insert(mesh.points.begin(), Point(1e6, -1. / 3, 0));
  mesh.points.push_back(Point(0, 0, 1e-300));
  for (auto& h : mesh.hexahedra)
    for (std::size_t& v : h)
      ++v;
  const auto np = params::optimization_method(Method::RECTIFICATION);
  const Status with = optimize(mesh, np), without = optimize(plain, np);
  EXPECT_EQ(mesh.points.front(), Point(1e6, -1. / 3, 0));
  EXPECT_EQ(mesh.points.back(), Point(0, 0, 1e-300));
  EXPECT_EQ(Points(mesh.points.begin() + 1, mesh.points.end() - 1), plain.points);
  EXPECT_EQ(with.after.minimum, without.after.minimum);
  EXPECT_EQ(with.deviation.maximum, without.deviation.maximum);
}

// --- Never worse --------------------------------------------------------------------

TEST_P(Optimize_hex_mesh, never_makes_a_valid_mesh_worse)
{
  int valid = 0;
  for (int variant = 0; variant < 5; ++variant)
    for (Method method : {Method::RECTIFICATION, Method::FULL}) {
      SCOPED_TRACE(std::to_string(variant) + (method == Method::FULL ? " full" : " rectification"));
      Indexed_mesh mesh = GetParam()();
      if (variant > 0)
        HMO::scramble_interior(mesh.points, mesh.hexahedra, 40 + variant, .12 * variant);
      if (variant > 2)
        HMO::jitter_boundary(mesh.points, mesh.hexahedra, variant, .15);
      const Indexed_mesh input = mesh;
      const Status status = optimize(mesh, params::optimization_method(method));
      valid += status.before.number_of_invalid == 0;
      expect_honest(input, mesh, status);
      expect_never_worse(status);
    }
  EXPECT_GE(valid, 4);
}

TEST_P(Optimize_hex_mesh, never_makes_a_valid_mesh_worse_with_a_separate_reference)
{
  const Surface_mesh surface = surface_of(GetParam()());
  for (int variant = 0; variant < 4; ++variant) {
    SCOPED_TRACE(variant);
    Indexed_mesh mesh = GetParam()();
    if (variant > 0)
      HMO::scramble_interior(mesh.points, mesh.hexahedra, 60 + variant, .15 * variant);
    if (variant > 1)
      HMO::jitter_boundary(mesh.points, mesh.hexahedra, variant, .15);
    const Indexed_mesh input = mesh;
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface,
                                                  params::optimization_method(Method::RECTIFICATION));
    expect_honest(input, mesh, status);
    expect_never_worse(status); // all is within what is tolerated
  }
}

TEST_P(Optimize_hex_mesh, gives_its_own_result_back)
{
  Indexed_mesh mesh = GetParam()();
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 8, .5);
  const Surface_mesh surface = surface_of(mesh);
  const auto np = params::optimization_method(Method::RECTIFICATION);
  for (int round = 0; round < 2; ++round) {
    const Indexed_mesh input = mesh;
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface, np);
    expect_honest(input, mesh, status);
    expect_never_worse(status);
    EXPECT_TRUE(status.valid_mesh());
  }
}

// What could still change is rounding
TEST(Optimize_hex_mesh_never_worse, gives_perfect_cubes_back_bit_for_bit)
{
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{3, 4, 5}}, {{3, 4, 5}});
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(.3, -.5, .7, .2).normalized();
  for (bool is_rotated : {false, true})
    for (bool has_reference : {false, true})
      for (Method method : {Method::RECTIFICATION, Method::MAXIMIZATION, Method::FULL}) {
        Indexed_mesh mesh = block;
        if (is_rotated)
          for (Point& p : mesh.points) {
            const Eigen::Vector3d q = rotation * Eigen::Vector3d(p.x(), p.y(), p.z()) + Eigen::Vector3d(10, -20, 5);
            p = Point(q[0], q[1], q[2]);
          }
        const Indexed_mesh input = mesh;
        const auto np = params::optimization_method(method);
        const Status status = has_reference
                                ? CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface_of(input), np)
                                : CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
        EXPECT_TRUE(same_points(mesh.points, input.points));
        EXPECT_NEAR(status.after.minimum, 1, 1e-12);
        EXPECT_EQ(status.volume_after, status.volume_before);
        EXPECT_EQ(status.return_code, Return_code::NO_IMPROVEMENT);
      }
}

// --- Invariance -----------------------------------------------------------------------

Indexed_mesh tangled(const Mesh_family& family, std::uint64_t seed)
{
  Indexed_mesh mesh = family();
  HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, 1.);
  return mesh;
}

template <class Map>
Indexed_mesh mapped(Indexed_mesh mesh, const Map& map)
{
  for (Point& p : mesh.points)
    p = map(p);
  return mesh;
}

const auto rectification = params::optimization_method(Method::RECTIFICATION);

void expect_same_quality(const Status& a, const Status& b, double tolerance)
{
  EXPECT_EQ(a.after.number_of_inverted, b.after.number_of_inverted);
  EXPECT_EQ(a.after.number_of_invalid, b.after.number_of_invalid);
  EXPECT_NEAR(a.after.minimum, b.after.minimum, tolerance);
  EXPECT_NEAR(a.after.average, b.after.average, tolerance);
}

// After a few iterations the same positions, up to the tolerance of the linear solver (.001 of an edge), which may stop
// one step earlier or later. A whole run from a tangled state amplifies rounding
// wherever it decides by thresholds, so that its end can only be equally good.
template <class Map>
void expect_equivalent(const Indexed_mesh& input, double scale, const Map& map)
{
  const auto short_run = rectification.number_of_iterations(4).number_of_restarts(0).maximize_minimum_quality(false);
  Indexed_mesh original = input, image = mapped(input, map);
  Status a = optimize(original, short_run), b = optimize(image, short_run);
  EXPECT_EQ(a.iterations, b.iterations);
  double largest = 0;
  for (std::size_t v = 0; v < original.points.size(); ++v)
    largest = (std::max)(largest, CGAL::squared_distance(map(original.points[v]), image.points[v]));
  EXPECT_LT(std::sqrt(largest), 1e-3 * scale * input.mean_edge_length());
  EXPECT_NEAR(b.deviation.average, scale * a.deviation.average, 1e-3 * scale * input.mean_edge_length());

  original = input;
  image = mapped(input, map);
  a = optimize(original, rectification);
  b = optimize(image, rectification);
  expect_same_quality(a, b, .02);
  EXPECT_NEAR(b.deviation.average, scale * a.deviation.average, .01 * scale * original.mean_edge_length());
}

TEST_P(Optimize_hex_mesh, does_not_depend_on_translation)
{
  const Indexed_mesh input = tangled(GetParam(), 3);
  expect_equivalent(input, 1, [](const Point& p) { return Point(p.x() + 10, p.y() - 20, p.z() + 30); });
  expect_equivalent(input, 1, [](const Point& p) { return Point(p.x() - 1000, p.y(), p.z() + .1); });
}

TEST_P(Optimize_hex_mesh, does_not_depend_on_rotation)
{
  const Indexed_mesh input = tangled(GetParam(), 4);
  expect_equivalent(input, 1, [](const Point& p) { return Point(p.y(), p.z(), p.x()); });
  const double c = std::cos(.7), s = std::sin(.7), d = std::cos(1.9), t = std::sin(1.9);
  expect_equivalent(input, 1, [=](const Point& p) {
    const Point q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    return Point(q.x(), d * q.y() - t * q.z(), t * q.y() + d * q.z());
  });
}

TEST_P(Optimize_hex_mesh, does_not_depend_on_the_unit_of_length)
{
  const Indexed_mesh input = tangled(GetParam(), 5);
  Indexed_mesh original = input;
  const Status status = optimize(original, rectification);
  for (double scale : {0x1p-20, 0x1p20, 0x1p-100, 0x1p100}) {
    SCOPED_TRACE(scale);
    const auto map = [=](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); };
    Indexed_mesh image = mapped(input, map);
    const Status of_image = optimize(image, rectification);
    EXPECT_EQ(image.points, mapped(original, map).points);
    EXPECT_EQ(of_image.after.minimum, status.after.minimum);
    EXPECT_EQ(of_image.iterations, status.iterations);
    EXPECT_EQ(of_image.deviation.maximum, scale * status.deviation.maximum);
    EXPECT_EQ(of_image.deviation.average_relative, status.deviation.average_relative);
  }
  for (double scale : {1e-6, 1e6})
    expect_equivalent(input, scale, [=](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); });
}

TEST_P(Optimize_hex_mesh, does_not_depend_on_the_numbering)
{
  const Indexed_mesh input = tangled(GetParam(), 6);
  Indexed_mesh original = input;
  const Status status = optimize(original, rectification);
  std::mt19937 random(1);
  for (int i = 0; i < 2; ++i) {
    std::vector<std::size_t> number(input.points.size()), order(input.hexahedra.size());
    std::iota(number.begin(), number.end(), std::size_t(0));
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(number.begin(), number.end(), random);
    std::shuffle(order.begin(), order.end(), random);
    Indexed_mesh image = input;
    for (std::size_t v = 0; v < number.size(); ++v)
      image.points[number[v]] = input.points[v];
    for (std::size_t h = 0; h < order.size(); ++h)
      for (int c = 0; c < 8; ++c)
        image.hexahedra[order[h]][c] = number[input.hexahedra[h][c]];
    const Status renumbered = optimize(image, rectification);
    expect_same_quality(status, renumbered, .02);
  }
}

TEST_P(Optimize_hex_mesh, accepts_hexahedra_numbered_inside_out)
{
  Indexed_mesh mesh = tangled(GetParam(), 7), mirrored = mesh;
  for (auto& h : mirrored.hexahedra)
    std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
  const auto given = mirrored.hexahedra;
  const Status straight = optimize(mesh, rectification), reversed = optimize(mirrored, rectification);
  EXPECT_EQ(straight.number_of_reoriented_hexahedra(), 0u);
  EXPECT_EQ(reversed.number_of_reoriented_hexahedra(), mesh.hexahedra.size());
  EXPECT_EQ(mirrored.points, mesh.points);
  EXPECT_EQ(mirrored.hexahedra, given);
  EXPECT_EQ(reversed.after.minimum, straight.after.minimum);
  EXPECT_EQ(reversed.before.minimum, straight.before.minimum);
  EXPECT_EQ(reversed.valid_mesh(), straight.valid_mesh());
}

// Whichever hexahedra are inside out, the result is that of the mesh in which none is, bit by bit.
TEST_P(Optimize_hex_mesh, turns_single_hexahedra_that_are_inside_out)
{
  Indexed_mesh mesh = tangled(GetParam(), 7), mirrored = mesh;
  std::vector<std::size_t> expected;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); h += 3) {
    expected.push_back(h);
    std::swap_ranges(mirrored.hexahedra[h].begin(), mirrored.hexahedra[h].begin() + 4,
                     mirrored.hexahedra[h].begin() + 4);
  }
  const auto given = mirrored.hexahedra;
  const Status straight = optimize(mesh, rectification), turned = optimize(mirrored, rectification);
  EXPECT_EQ(turned.reoriented_hexahedra, expected);
  EXPECT_EQ(mirrored.points, mesh.points);
  EXPECT_EQ(mirrored.hexahedra, given);
  EXPECT_EQ(turned.before.minimum, straight.before.minimum);
  EXPECT_EQ(turned.after.average, straight.after.average);
}

TEST_P(Optimize_hex_mesh, gives_the_same_result_twice)
{
  for (Method method : {Method::RECTIFICATION, Method::FULL}) {
    Indexed_mesh first = tangled(GetParam(), 8), second = first;
    const Status a = optimize(first, params::optimization_method(method));
    const Status b = optimize(second, params::optimization_method(method));
    EXPECT_EQ(first.points, second.points);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_EQ(a.return_code, b.return_code);
    EXPECT_EQ(a.deviation.average, b.deviation.average);
  }
}

// --- Deviation --------------------------------------------------------------------------

struct Triangles
{
  std::vector<Kernel::Triangle_3> list;

  double distance(const Point& p) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Kernel::Triangle_3& t : list)
      nearest = (std::min)(nearest, double(CGAL::squared_distance(p, t)));
    return std::sqrt(nearest);
  }

  // Average and maximum of the distance over a dense lattice in every triangle
  std::array<double, 2> distance(const Triangles& other) const
  {
    double sum = 0, area = 0, largest = 0;
    for (const Kernel::Triangle_3& t : list) {
      const int n = 12;
      double of_triangle = 0;
      int count = 0;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; i + j <= n; ++j) {
          const double d = other.distance(t[0] + double(i) / n * (t[1] - t[0]) + double(j) / n * (t[2] - t[0]));
          largest = (std::max)(largest, d);
          if (i > 0 && j > 0 && i + j < n) { // the inner points stand for equal areas
            of_triangle += d;
            ++count;
          }
        }
      const double a = std::sqrt(t.squared_area());
      sum += a * of_triangle / count;
      area += a;
    }
    return {{sum / area, largest}};
  }
};

Triangles triangles_of(const Surface_mesh& surface)
{
  Triangles result;
  for (const auto f : surface.faces()) {
    std::vector<Point> p;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      p.push_back(surface.point(v));
    result.list.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

// As the reference is split: from the first corners
Triangles boundary_triangles(const Indexed_mesh& mesh)
{
  Triangles result;
  const auto complex = mesh.complex();
  for (const auto& face : complex.boundary_faces) {
    const auto corner = [&](int i) { return mesh.points[face.vertices[i]]; };
    result.list.emplace_back(corner(0), corner(1), corner(2));
    result.list.emplace_back(corner(0), corner(2), corner(3));
  }
  return result;
}

void expect_deviation(const Indexed_mesh& mesh, const Triangles& reference, const Status& status)
{
  const Triangles boundary = boundary_triangles(mesh);
  const std::array<double, 2> there = boundary.distance(reference), back = reference.distance(boundary);
  const double average = (std::max)(there[0], back[0]), maximum = (std::max)(there[1], back[1]);
  const double least = 1e-6 * mesh.mean_edge_length();
  EXPECT_NEAR(status.deviation.average, average, .2 * average + least);
  EXPECT_NEAR(status.deviation.maximum, maximum, .2 * maximum + least);
  CGAL::Bbox_3 box;
  for (const Kernel::Triangle_3& t : reference.list)
    box += t.bbox();
  const double diagonal = std::sqrt(std::pow(box.xmax() - box.xmin(), 2) + std::pow(box.ymax() - box.ymin(), 2) +
                                    std::pow(box.zmax() - box.zmin(), 2));
  EXPECT_NEAR(status.deviation.average_relative, status.deviation.average / diagonal, 1e-12);
  EXPECT_NEAR(status.deviation.maximum_relative, status.deviation.maximum / diagonal, 1e-12);
}

TEST_P(Optimize_hex_mesh, measures_the_deviation_from_its_own_boundary)
{
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Indexed_mesh mesh = GetParam()();
    HMO::scramble_interior(mesh.points, mesh.hexahedra, seed);
    HMO::jitter_boundary(mesh.points, mesh.hexahedra, seed, .3);
    const Triangles reference = boundary_triangles(mesh);
    const Status status = optimize(mesh, rectification);
    expect_deviation(mesh, reference, status);
  }
}

TEST(Optimize_hex_mesh_deviation, is_measured_from_a_separate_reference)
{
  Indexed_mesh fine, coarse;
  HMO::make_ball(fine.points, fine.hexahedra, 6);
  HMO::make_ball(coarse.points, coarse.hexahedra, 3);
  const Surface_mesh surface = surface_of(fine);
  const Status status = CGAL::optimize_hex_mesh(coarse.points, coarse.hexahedra, surface, rectification);
  expect_deviation(coarse, triangles_of(surface), status);
  EXPECT_GT(status.deviation.average, 0);
}

// A way on which the minimum never falls leads nowhere here
TEST(Optimize_hex_mesh_sheared, gains_though_all_corners_are_as_poor_as_the_worst)
{
  Indexed_mesh mesh;
  HMO::make_cylinder(mesh.points, mesh.hexahedra, 9, 6);
  mesh = sheared(mesh, 2);
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_LT(status.before.average, .45);
  EXPECT_GT(status.after.average, .8);
  EXPECT_GE(status.after.minimum, status.before.minimum);
}

// Whose quality would gain from a boundary that leaves the surface
TEST_P(Optimize_hex_mesh, keeps_within_a_bound_of_the_deviation)
{
  for (const Indexed_mesh& intact : {GetParam()(), sheared(GetParam()(), 2)}) {
    const Surface_mesh surface = surface_of(intact);
    for (double edges : {.3, .1})
      for (std::uint64_t seed = 0; seed < 1; ++seed) {
        SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(edges));
        Indexed_mesh mesh = intact;
        HMO::jitter_boundary(mesh.points, mesh.hexahedra, seed, .2);
        const Indexed_mesh input = mesh;
        const double bound = edges * intact.mean_edge_length();
        const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface,
                                                      params::maximum_deviation(bound));
        expect_honest(input, mesh, status);
        expect_never_worse(status);
        EXPECT_TRUE(status.valid_mesh());
        EXPECT_EQ(status.deviation_bound, bound);
        EXPECT_EQ(status.is_within_deviation_bound(), status.deviation.certified <= bound);
        EXPECT_TRUE(status.is_within_deviation_bound()) << status.deviation.certified << " of " << bound;
      }
  }
}

// It makes a difference
TEST(Optimize_hex_mesh_deviation, is_larger_without_a_bound)
{
  const Indexed_mesh intact = sheared(mesh_families()[5](), 2);
  const Surface_mesh surface = surface_of(intact);
  Indexed_mesh free = intact, bounded = intact;
  const Status without = CGAL::optimize_hex_mesh(free.points, free.hexahedra, surface);
  const double bound = .9 * without.deviation.maximum;
  const Status with = CGAL::optimize_hex_mesh(bounded.points, bounded.hexahedra, surface,
                                              params::maximum_deviation(bound));
  EXPECT_GT(bound, 0);
  EXPECT_LE(with.deviation.maximum, with.deviation.certified);
  EXPECT_LE(with.deviation.certified, bound);
  EXPECT_EQ(without.deviation.certified, std::numeric_limits<double>::infinity());
  EXPECT_EQ(without.deviation_bound, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(without.is_within_deviation_bound());
  for (const Status* status : {&without, &with})
    EXPECT_TRUE(status->valid_mesh());
}

// Whether the bound is met is measured, not promised.
TEST_P(Optimize_hex_mesh, admits_to_have_missed_a_bound_of_the_deviation)
{
  const Surface_mesh surface = surface_of(GetParam()());
  for (double edges : {1e-2, 1e-9}) {
    Indexed_mesh mesh = GetParam()();
    HMO::jitter_boundary(mesh.points, mesh.hexahedra, 4, .2);
    const Indexed_mesh input = mesh;
    const double bound = edges * mesh.mean_edge_length();
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface,
                                                  params::maximum_deviation(bound));
    expect_honest(input, mesh, status);
    // angles do not protect what comes in off its reference
    EXPECT_LE(status.after.number_of_inverted, status.before.number_of_inverted);
    EXPECT_TRUE(status.valid_mesh() || status.before.number_of_invalid > 0);
    EXPECT_EQ(status.return_code == Return_code::DEVIATION_BOUND_NOT_MET, !status.is_within_deviation_bound());
    EXPECT_EQ(status.is_within_deviation_bound(), status.deviation.certified <= bound);
  }
}

// --- Ends before the end -------------------------------------------------------------------

struct Recorder
{
  std::vector<HMO::Iteration> seen;
  std::size_t stop_after = std::numeric_limits<std::size_t>::max();
  std::size_t throw_after = std::numeric_limits<std::size_t>::max();

  bool on_iteration(const HMO::Iteration& iteration)
  {
    seen.push_back(iteration);
    if (seen.size() >= throw_after)
      throw std::runtime_error("thrown by the visitor");
    return seen.size() < stop_after;
  }
};

TEST_P(Optimize_hex_mesh, shows_every_iteration_to_the_visitor)
{
  for (Method method : {Method::RECTIFICATION, Method::FULL}) {
    Indexed_mesh mesh = tangled(GetParam(), 9), unseen = mesh;
    Recorder recorder;
    const Status status = optimize(mesh, params::visitor(std::ref(recorder)).optimization_method(method));
    optimize(unseen, params::optimization_method(method));
    EXPECT_EQ(mesh.points, unseen.points) << "the visitor changed the result";
    ASSERT_GT(recorder.seen.size(), 0u);
    EXPECT_EQ(recorder.seen.size(), status.iterations);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < recorder.seen.size(); ++i) {
      const HMO::Iteration& it = recorder.seen[i];
      if (i > 0 && it.stage != recorder.seen[i - 1].stage) {
        EXPECT_EQ(it.stage, HMO::Stage::MAXIMIZATION) << "the stages come in order";
        expected = 0;
      }
      EXPECT_EQ(it.iteration, expected++);
      EXPECT_TRUE(std::isfinite(it.energy));
      EXPECT_LE(it.number_of_inverted, mesh.hexahedra.size());
      EXPECT_LE(it.minimum, it.average);
      if (i > 0) {
        EXPECT_GE(it.seconds, recorder.seen[i - 1].seconds);
      }
    }
    EXPECT_GE(status.total_seconds, recorder.seen.back().seconds);
    if (method == Method::RECTIFICATION) {
      EXPECT_EQ(recorder.seen.back().stage, HMO::Stage::RECTIFICATION);
    }
  }
}

TEST_P(Optimize_hex_mesh, stops_when_the_visitor_asks)
{
  for (std::size_t stop_after : {1, 3}) {
    Indexed_mesh mesh = tangled(GetParam(), 10);
    const Indexed_mesh input = mesh;
    Recorder recorder;
    recorder.stop_after = stop_after;
    const Status status = optimize(mesh, params::visitor(std::ref(recorder)));
    EXPECT_EQ(recorder.seen.size(), stop_after);
    EXPECT_EQ(status.iterations, stop_after);
    EXPECT_EQ(status.return_code, Return_code::STOPPED_BY_VISITOR);
    expect_honest(input, mesh, status);
    expect_never_worse(status);
  }
}

TEST_P(Optimize_hex_mesh, moves_nothing_if_the_visitor_throws)
{
  for (std::size_t throw_after : {1, 4}) {
    Indexed_mesh mesh = tangled(GetParam(), 11);
    const Indexed_mesh input = mesh;
    Recorder recorder;
    recorder.throw_after = throw_after;
    EXPECT_THROW(optimize(mesh, params::visitor(std::ref(recorder))), std::runtime_error);
    EXPECT_EQ(recorder.seen.size(), throw_after);
    EXPECT_EQ(mesh.points, input.points);
  }
}

TEST_P(Optimize_hex_mesh, stops_at_the_target_quality)
{
  Indexed_mesh mesh = tangled(GetParam(), 12), unlimited = mesh;
  const Indexed_mesh input = mesh;
  const Status best = optimize(unlimited, rectification);
  ASSERT_TRUE(best.valid_mesh());
  const double target = .5 * best.after.minimum;
  const Status status = optimize(mesh, rectification.target_quality(target));
  EXPECT_EQ(status.return_code, Return_code::TARGET_QUALITY_REACHED);
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GE(status.after.minimum, target);
  EXPECT_LT(status.iterations, best.iterations);
  expect_honest(input, mesh, status);
}

TEST(Optimize_hex_mesh_limits, that_are_met_already_leave_the_mesh_alone)
{
  Indexed_mesh mesh = mesh_families()[5]();
  const Indexed_mesh input = mesh;
  const double minimum = HMO::quality_statistics(mesh.points, mesh.hexahedra).minimum;
  const Status status = optimize(mesh, params::target_quality(.9 * minimum));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GE(status.after.minimum, .9 * minimum);
  EXPECT_LE(status.iterations, 2u);
  expect_never_worse(status);
}

TEST_P(Optimize_hex_mesh, stops_when_the_time_is_over)
{
  Indexed_mesh mesh = tangled(GetParam(), 13);
  const Indexed_mesh input = mesh;
  const Status status = optimize(mesh, params::maximum_running_time(0));
  EXPECT_EQ(status.return_code, Return_code::TIME_LIMIT);
  EXPECT_LE(status.iterations, 1u);
  expect_honest(input, mesh, status);
  expect_never_worse(status);
}

// A time limit in the middle of a run
TEST(Optimize_hex_mesh_limits, hold_within_a_run)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{30, 30, 30}});
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  const Indexed_mesh input = mesh;
  const Status status = optimize(mesh, params::maximum_running_time(.1));
  EXPECT_EQ(status.return_code, Return_code::TIME_LIMIT);
  EXPECT_GE(status.total_seconds, .1);
  expect_honest(input, mesh, status);
  expect_never_worse(status);
}

TEST(Optimize_hex_mesh_limits, on_iterations_are_kept)
{
  Indexed_mesh mesh = tangled(mesh_families()[5], 2);
  const Status status =
    optimize(mesh, rectification.number_of_iterations(2).number_of_restarts(1).maximize_minimum_quality(false));
  EXPECT_LE(status.iterations, 4u);
  EXPECT_GE(status.iterations, 1u);
}

TEST_P(Optimize_hex_mesh, is_not_changed_by_printing)
{
  Indexed_mesh loud = tangled(GetParam(), 14), silent = loud;
  std::ostringstream printed;
  std::streambuf* const before = std::cerr.rdbuf(printed.rdbuf());
  const Status a = optimize(loud, rectification.verbose(true));
  std::cerr.rdbuf(before);
  std::ostringstream nothing;
  std::cerr.rdbuf(nothing.rdbuf());
  const Status b = optimize(silent, rectification);
  std::cerr.rdbuf(before);
  EXPECT_EQ(loud.points, silent.points);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.deviation.average, b.deviation.average);
  const std::string lines = printed.str();
  EXPECT_EQ(std::size_t(std::count(lines.begin(), lines.end(), '\n')), a.iterations);
  EXPECT_TRUE(nothing.str().empty());
}

// --- Further parameters ---------------------------------------------------------------------

// Three layers along z, the middle one wanted thin
struct Layer_lengths
{
  using key_type = std::pair<std::size_t, std::size_t>;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const Points* points;
  friend double get(const Layer_lengths& map, const key_type& edge)
  {
    const Point &a = (*map.points)[edge.first], &b = (*map.points)[edge.second];
    if (std::abs(a.z() - b.z()) < .5)
      return 1;
    const double middle = (a.z() + b.z()) / 2;
    return middle > 1 && middle < 2 ? .3 : 1.35;
  }
};

TEST(Optimize_hex_mesh_parameters, target_lengths_shape_the_interior)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{4, 4, 3}}, {{4, 4, 3}});
  const Points given = mesh.points;
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1, 1.);
  const Status status = optimize(mesh, params::optimization_method(Method::RECTIFICATION)
                                         .target_edge_length_map(Layer_lengths{&given})
                                         .edge_length_update(HMO::Edge_length_update::NONE)
                                         .maximize_minimum_quality(false)
                                         .surface_weight(.05)
                                         .feature_weight(.05));
  expect_never_worse(status);
  const auto complex = mesh.complex();
  for (std::size_t v = 0; v < given.size(); ++v)
    if (!complex.is_on_boundary[v] && given[v].z() == 1) {
      // its partner above
      for (std::size_t u = 0; u < given.size(); ++u)
        if (given[u] == given[v] + Kernel::Vector_3(0, 0, 1)) {
          EXPECT_LT(mesh.points[u].z() - mesh.points[v].z(), .95);
        }
    }
}

// --- What only the boundary or the connectivity could change --------------------------------

// Moves the vertex at a place. Returns its index.
std::size_t move(Indexed_mesh& mesh, const Point& from, const Point& to)
{
  const auto vertex = std::find(mesh.points.begin(), mesh.points.end(), from);
  EXPECT_NE(vertex, mesh.points.end());
  *vertex = to;
  return vertex - mesh.points.begin();
}

// The hexahedra around a vertex of a mesh of cubes once it was pushed inside out: whether they are locked with a fixed
// boundary, and that they are not without one
void expect_locked(const Point& from, const Point& to, bool is_locked)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{3, 3, 3}}, {{3, 3, 3}});
  const std::size_t pushed = move(mesh, from, to);
  std::vector<std::size_t> around;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (std::count(mesh.hexahedra[h].begin(), mesh.hexahedra[h].end(), pushed))
      around.push_back(h);
  for (Method method : {Method::RECTIFICATION, Method::FULL}) {
    Indexed_mesh within = mesh, free = mesh;
    const Status fixed = optimize(within, params::fixed_boundary(true).optimization_method(method));
    expect_honest(mesh, within, fixed);
    EXPECT_EQ(fixed.locked_hexahedra, is_locked ? around : std::vector<std::size_t>());
    EXPECT_TRUE(std::includes(fixed.invalid_hexahedra.begin(), fixed.invalid_hexahedra.end(),
                              fixed.locked_hexahedra.begin(), fixed.locked_hexahedra.end()));
    const Status movable = optimize(free, params::optimization_method(method));
    expect_honest(mesh, free, movable);
    EXPECT_TRUE(movable.locked_hexahedra.empty());
  }
}

TEST(Optimize_hex_mesh_locked, are_hexahedra_with_an_inverted_corner_on_the_boundary)
{
  expect_locked(Point(0, 0, 0), Point(.6, .6, .6), true);  // a corner of the block
  expect_locked(Point(1, 0, 0), Point(1, .8, .8), true);   // on an edge
  expect_locked(Point(1, 1, 0), Point(1, 1, 1.4), false);  // within a side: the vertices inside can make way
  expect_locked(Point(0, 0, 0), Point(.2, .2, .2), false); // not far enough
}

// Held by the caller, not by a fixed boundary
TEST(Optimize_hex_mesh_locked, are_hexahedra_between_constrained_vertices)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{2, 2, 2}}, {{2, 2, 2}});
  move(mesh, Point(1, 1, 1), Point(1, 1, 2.5)); // out of the top
  const std::vector<char> marks(mesh.points.size(), true);
  const Status status = optimize(mesh, params::vertex_is_constrained_map(Marked_vertices{&marks}));
  EXPECT_EQ(status.locked_hexahedra, (std::vector<std::size_t>{4, 5, 6, 7}));
  EXPECT_EQ(status.locked_hexahedra, status.invalid_hexahedra);
}

TEST_P(Optimize_hex_mesh, locks_nothing_that_can_move)
{
  Indexed_mesh mesh = tangled(GetParam(), 15);
  EXPECT_TRUE(optimize(mesh, params::number_of_iterations(1).number_of_restarts(0)).locked_hexahedra.empty());
}

TEST(Optimize_hex_mesh_connectivity_limits, of_a_block_are_none)
{
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Indexed_mesh mesh = tangled(mesh_families()[0], seed);
    EXPECT_TRUE(optimize(mesh, rectification).connectivity_limits.empty());
  }
}

// Of three hexahedra around an edge, at least one is no better than the limit.
TEST(Optimize_hex_mesh_connectivity_limits, of_a_cylinder_are_at_its_lines_with_three_hexahedra)
{
  for (Method method : {Method::RECTIFICATION, Method::FULL}) {
    Indexed_mesh mesh;
    HMO::make_cylinder(mesh.points, mesh.hexahedra, 3, 4);
    const auto complex = mesh.complex();
    std::vector<std::vector<std::size_t>> at_edges(complex.edges.size());
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
      for (int directed : complex.hexahedron_edges[h])
        at_edges[directed / 2].push_back(h);
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 3);
    const Status status = optimize(mesh, params::optimization_method(method));
    const std::vector<double> quality = HMO::scaled_jacobians(mesh.points, mesh.hexahedra);
    std::vector<char> is_reported(mesh.hexahedra.size(), false);
    for (const HMO::Connectivity_limit& limit : status.connectivity_limits) {
      EXPECT_EQ(limit.reason, HMO::Connectivity_limit_reason::INTERIOR_EDGE);
      EXPECT_NEAR(limit.largest_scaled_jacobian, std::sqrt(.75), 1e-12);
      EXPECT_LE(quality[limit.hexahedron], limit.largest_scaled_jacobian);
      EXPECT_EQ(quality[limit.hexahedron], limit.scaled_jacobian);
      EXPECT_EQ(limit.is_reached(), quality[limit.hexahedron] >= limit.largest_scaled_jacobian - .01);
      EXPECT_FALSE(is_reported[limit.hexahedron]);
      is_reported[limit.hexahedron] = true;
    }
    EXPECT_TRUE(std::is_sorted(status.connectivity_limits.begin(), status.connectivity_limits.end(),
                               [](const auto& a, const auto& b) { return a.hexahedron < b.hexahedron; }));
    std::vector<char> is_limited(mesh.hexahedra.size(), false);
    int lines = 0;
    for (std::size_t e = 0; e < at_edges.size(); ++e)
      if (!complex.is_boundary_edge[e] && at_edges[e].size() == 3) {
        ++lines;
        EXPECT_TRUE(std::any_of(at_edges[e].begin(), at_edges[e].end(), [&](std::size_t h) { return is_reported[h]; }));
        for (std::size_t h : at_edges[e])
          is_limited[h] = true;
      }
    EXPECT_EQ(lines, 4 * 4);
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      EXPECT_TRUE(is_limited[h] || !is_reported[h]) << h;
  }
}

} // namespace
