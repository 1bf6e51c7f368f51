// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What becomes of the boundary in whole runs: corners are exact, a bound of the deviation is obeyed, vertices that have
// to be on the surface are. All is measured here, on the mesh that is handed back.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "Marked_vertices.h"
#include "boundary_surface_mesh.h"
#include "mesh_checks.h"
#include "mesh_families.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Kernel = Indexed_mesh::Kernel;
using Point = Indexed_mesh::Point;
using Surface_mesh = CGAL::Surface_mesh<Point>;
using HMO::Boundary_placement;
using HMO::Return_code;
using HMO::Status;

// The boundary as it stands in for a reference: quads are split from their first corners
std::vector<Kernel::Triangle_3> boundary_triangles(const Indexed_mesh& mesh)
{
  std::vector<Kernel::Triangle_3> result;
  const auto faces = mesh.complex().boundary_faces;
  for (const auto& face : faces) {
    const auto corner = [&](int i) { return mesh.points[face.vertices[i]]; };
    result.emplace_back(corner(0), corner(1), corner(2));
    result.emplace_back(corner(0), corner(2), corner(3));
  }
  return result;
}

double distance(const Point& p, const std::vector<Kernel::Triangle_3>& triangles)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Kernel::Triangle_3& t : triangles)
    least = (std::min)(least, double(CGAL::squared_distance(p, t)));
  return std::sqrt(least);
}

// From a lattice of points on each triangle of one
double largest_distance(const std::vector<Kernel::Triangle_3>& from, const std::vector<Kernel::Triangle_3>& to)
{
  const int n = 8;
  double largest = 0;
  for (const Kernel::Triangle_3& t : from)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        largest = (std::max)(largest,
                             distance(t[0] + double(i) / n * (t[1] - t[0]) + double(j) / n * (t[2] - t[0]), to));
  return largest;
}

// Those of the box that the generator has made
std::vector<std::size_t> corners_of(const Indexed_mesh& block)
{
  const Point last = block.points.back();
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < block.points.size(); ++v) {
    const Point& p = block.points[v];
    if ((p.x() == 0 || p.x() == last.x()) && (p.y() == 0 || p.y() == last.y()) && (p.z() == 0 || p.z() == last.z()))
      result.push_back(v);
  }
  return result;
}

TEST(Corners, of_a_box_stay_bit_for_bit)
{
  for (const Indexed_mesh& straight : {mesh_families()[0](), mesh_families()[1]()}) {
    const std::vector<std::size_t> corners = corners_of(straight);
    ASSERT_EQ(corners.size(), 8u);
    for (std::uint64_t seed = 0; seed < 3; ++seed)
      for (bool has_reference : {false, true})
        for (double edges : {std::numeric_limits<double>::infinity(), .05}) {
          SCOPED_TRACE(std::to_string(seed) + (has_reference ? " with" : " without") + " a reference, bound " +
                       std::to_string(edges));
          const Indexed_mesh intact = sheared(straight, .7);
          Indexed_mesh mesh = intact;
          HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, .8);
          const auto np = params::maximum_deviation(edges * intact.mean_edge_length());
          const Status status = has_reference
                                  ? CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface_of(intact), np)
                                  : CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
          EXPECT_TRUE(status.valid_mesh());
          for (std::size_t v : corners)
            EXPECT_TRUE(same_bits(mesh.points[v], intact.points[v])) << v;
        }
  }
}

// They are found, and moved there
TEST(Corners, of_a_box_are_those_of_the_reference_where_they_came_in_beside_them)
{
  const Indexed_mesh intact = mesh_families()[0]();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Indexed_mesh mesh = intact;
    HMO::jitter_boundary(mesh.points, mesh.hexahedra, seed, .2);
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, surface_of(intact));
    EXPECT_TRUE(status.valid_mesh());
    for (std::size_t v : corners_of(intact))
      EXPECT_LT(CGAL::squared_distance(mesh.points[v], intact.points[v]), 1e-24) << v << ", seed " << seed;
  }
}

class Boundary_guarantees : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Boundary_guarantees, ::testing::ValuesIn(mesh_families()), Family_name());

// From a valid mesh on its reference, and never silently otherwise
TEST_P(Boundary_guarantees, a_bound_of_the_deviation_is_obeyed)
{
  const Indexed_mesh intact = sheared(GetParam()(), .7);
  const std::vector<Kernel::Triangle_3> reference = boundary_triangles(intact);
  int improved = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (double edges : {.3, .1, .02}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", bound " + std::to_string(edges));
      Indexed_mesh mesh = intact;
      HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, .1 * double(seed));
      const double bound = edges * intact.mean_edge_length();
      const bool was_valid = invalid_hexahedra(mesh).empty();
      const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, params::maximum_deviation(bound));
      const std::vector<Kernel::Triangle_3> boundary = boundary_triangles(mesh);
      const double deviation = (std::max)(largest_distance(boundary, reference), largest_distance(reference, boundary));
      if (was_valid) {
        EXPECT_LE(deviation, bound);
        EXPECT_NE(status.return_code, Return_code::DEVIATION_BOUND_NOT_MET);
      }
      EXPECT_EQ(status.is_within_deviation_bound(), status.return_code != Return_code::DEVIATION_BOUND_NOT_MET);
      EXPECT_TRUE(deviation <= bound || !status.is_within_deviation_bound());
      improved += status.after.average > status.before.average;
    }
  EXPECT_GT(improved, 0);
}

// However small it is, where the boundary came in as it is to be and the interior is tangled
TEST_P(Boundary_guarantees, a_small_bound_of_the_deviation_is_obeyed)
{
  const Indexed_mesh intact = GetParam()();
  const std::vector<Kernel::Triangle_3> reference = boundary_triangles(intact);
  for (double edges : {1e-4, 1e-6}) {
    SCOPED_TRACE("bound " + std::to_string(edges));
    Indexed_mesh mesh = intact;
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 1, .6);
    const double bound = edges * intact.mean_edge_length();
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, params::maximum_deviation(bound));
    EXPECT_GT(status.before.number_of_inverted, 0u);
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_NE(status.return_code, Return_code::DEVIATION_BOUND_NOT_MET);
    EXPECT_LE(largest_distance(boundary_triangles(mesh), reference), bound);
    EXPECT_GT(status.after.minimum, .6);
  }
}

// Whatever a boundary may do, it may stay: no freedom makes a mesh worse in the order of goals, nor, below what is worth its
// deviation, its minimum.
TEST_P(Boundary_guarantees, no_freedom_of_the_boundary_costs_what_a_fixed_one_reaches)
{
  const double worth = .69;
  for (double amplitude : {.4, 1.}) { // most are valid with the former, tangled with the latter
    Indexed_mesh input = GetParam()();
    HMO::scramble_interior(input.points, input.hexahedra, 1, amplitude);
    const double length = input.mean_edge_length();
    const auto expect_as_good = [&](const auto& np) {
      Indexed_mesh fixed = input, mesh = input;
      const Status least = CGAL::optimize_hex_mesh(fixed.points, fixed.hexahedra, np.fixed_boundary(true));
      const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, np);
      EXPECT_LE(status.after.number_of_inverted, least.after.number_of_inverted);
      EXPECT_LE(status.invalid_hexahedra.size(), least.invalid_hexahedra.size());
      EXPECT_TRUE(status.is_within_deviation_bound());
      EXPECT_TRUE(status.vertices_off_reference.empty());
      EXPECT_GE(status.after.minimum, (std::min)(worth, least.after.minimum - .01));
    };
    for (double edges : {.03, 1e-3, 1e-6}) {
      SCOPED_TRACE("amplitude " + std::to_string(amplitude) + ", bound " + std::to_string(edges));
      expect_as_good(params::maximum_deviation(edges * length));
    }
    SCOPED_TRACE("amplitude " + std::to_string(amplitude));
    expect_as_good(params::default_values());
    expect_as_good(params::boundary_placement(Boundary_placement::ON_SURFACE));
  }
}

// What a smaller bound allows, a larger one does too. The average may yield a little to the minimum.
TEST_P(Boundary_guarantees, a_larger_bound_gives_no_lower_minimum)
{
  const Indexed_mesh intact = sheared(GetParam()(), .7);
  double minimum = 0, average = 0;
  for (double edges : {.02, .1, .4, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE("bound " + std::to_string(edges));
    Indexed_mesh mesh = intact;
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 1, .1);
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                                  params::maximum_deviation(edges * intact.mean_edge_length()));
    // places for single vertices are searched for only within a bound: without one a minimum may be that much lower
    EXPECT_GE(status.after.minimum, minimum - .07);
    EXPECT_GE(status.after.average, average - .03);
    minimum = (std::max)(minimum, status.after.minimum);
    average = (std::max)(average, status.after.average);
  }
}

void expect_on_surface(const Indexed_mesh& intact)
{
  const std::vector<Kernel::Triangle_3> reference = boundary_triangles(intact);
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    Indexed_mesh mesh = intact;
    HMO::scramble_interior(mesh.points, mesh.hexahedra, seed, .1 + double(seed));
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra,
                                                  params::boundary_placement(Boundary_placement::ON_SURFACE));
    EXPECT_TRUE(status.valid_mesh());
    const auto complex = mesh.complex();
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (complex.is_on_boundary[v]) {
        EXPECT_LT(distance(mesh.points[v], reference), 1e-10 * intact.mean_edge_length())
          << "vertex " << v << ", seed " << seed;
      }
    EXPECT_TRUE(status.vertices_off_reference.empty()) << "seed " << seed;
  }
}

TEST_P(Boundary_guarantees, vertices_on_the_surface_are_on_it) { expect_on_surface(GetParam()()); }

TEST_P(Boundary_guarantees, vertices_on_the_surface_are_on_it_where_that_costs_quality)
{
  expect_on_surface(sheared(GetParam()(), .7));
}

// A corner of the reference within the hexahedron whose vertex belongs to it, and no other vertex may give way: it is
// released, and the quality that was asked for does not count as reached.
TEST(Boundary_guarantees, a_corner_out_of_reach_is_released)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{4, 4, 4}}, {{4, 4, 4}});
  Surface_mesh reference = surface_of(mesh);
  const Point place(.55, .55, .55);
  for (auto v : reference.vertices())
    if (reference.point(v) == Point(0, 0, 0))
      reference.point(v) = place;
  const std::size_t corner = std::find(mesh.points.begin(), mesh.points.end(), Point(0, 0, 0)) - mesh.points.begin();
  std::vector<char> is_frozen(mesh.points.size(), true);
  is_frozen[corner] = false;
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, reference,
                                                params::boundary_placement(Boundary_placement::ON_SURFACE)
                                                  .target_quality(.05)
                                                  .vertex_is_constrained_map(Marked_vertices{&is_frozen}));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GT(status.after.minimum, .05);
  EXPECT_EQ(status.vertices_off_reference, std::vector<std::size_t>{corner});
  EXPECT_NE(status.return_code, HMO::Return_code::TARGET_QUALITY_REACHED);
}

// A thin solid of length 1 and width .25, whose vertices have slid along it. n: hexahedra along it; thickness: of all
// layers.
struct Thin_solid
{
  const char* name;
  Point (*at)(double u, double v, double height); // on the middle surface, and above or below it
  bool is_closed;                                 // u = 1 is u = 0

  Indexed_mesh operator()(int n, int layers, double thickness, std::uint64_t seed) const
  {
    const int m = n / 4;
    Indexed_mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{std::size_t(n), std::size_t(m), std::size_t(layers)}},
                    {{double(n), double(m), 1}});
    std::mt19937_64 random(seed);
    std::map<std::array<int, 2>, std::array<double, 2>> places; // the same for all of a column
    for (Point& p : mesh.points) {
      const std::array<int, 2> column = {int(std::lround(p.x())) % (is_closed ? n : n + 1), int(std::lround(p.y()))};
      const auto slid = [&](int i, int last) {
        return i > 0 && i < last ? i + (double(random() >> 11) * 0x1p-53 - .5) * .5 : double(i);
      };
      if (places.count(column) == 0)
        places[column] = {slid(column[0], n), slid(column[1], m)};
      const auto& [u, v] = places[column];
      p = at(u / n, v / n, (p.z() - .5) * thickness);
    }
    if (is_closed) {
      const std::vector<std::size_t> first = HMO::coincident_vertices(mesh.points, mesh.hexahedra);
      for (auto& h : mesh.hexahedra)
        for (std::size_t& v : h)
          v = first[v];
    }
    return mesh;
  }
};

std::ostream& operator<<(std::ostream& os, const Thin_solid& solid) { return os << solid.name; }

class Thin_solids : public ::testing::TestWithParam<Thin_solid>
{};

INSTANTIATE_TEST_SUITE_P(
  Shapes, Thin_solids,
  ::testing::Values(Thin_solid{"plate", [](double u, double v, double h) { return Point(u, v, h); }, false},
                    Thin_solid{"shell",
                               [](double u, double v, double h) {
                                 const double x = u - .5, y = v, z = .8;
                                 const double r = (1 + h) / std::sqrt(x * x + y * y + z * z);
                                 return Point(r * x, r * y, r * z);
                               },
                               false},
                    Thin_solid{"pipe",
                               [](double u, double v, double h) {
                                 const double r = .5 / CGAL_PI + h, a = 2 * CGAL_PI * u;
                                 return Point(r * std::cos(a), -r * std::sin(a), v);
                               },
                               true}),
  Family_name());

// However thin they are in comparison with their edges
TEST_P(Thin_solids, keep_their_volume)
{
  const int n = 40;
  for (double aspect : {3., 10., 30., 100.})
    for (int layers : {1, 2}) {
      SCOPED_TRACE("aspect " + std::to_string(aspect) + ", layers " + std::to_string(layers));
      Indexed_mesh mesh = GetParam()(n, layers, layers / (n * aspect), 7);
      const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
      EXPECT_TRUE(status.valid_mesh());
      EXPECT_GT(status.after.average, status.before.average + .01);
      EXPECT_NEAR(status.volume_after / status.volume_before, 1, .01);
    }
}

// Cubes that follow a bulge of their reference stay good enough to come closer than the average alone asks for
TEST(Spare_quality, goes_into_the_largest_deviation)
{
  const auto bulged_block = [](std::size_t cells, double height) {
    Indexed_mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{cells, cells, cells}}, {{1, 1, 1}});
    for (Point& p : mesh.points)
      p = Point(p.x(), p.y(), p.z() * (1 + height * std::sin(CGAL_PI * p.x()) * std::sin(CGAL_PI * p.y())));
    return mesh;
  };
  for (double height : {.08, .12}) {
    const Surface_mesh reference = surface_of(bulged_block(24, height));
    Indexed_mesh mesh = bulged_block(6, 0);
    const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra, reference);
    EXPECT_TRUE(status.valid_mesh());
    EXPECT_GT(status.after.minimum, .85);
    EXPECT_LT(status.deviation.maximum_relative, 2.4e-3 / .12 * height)
      << "in proportion to the curvature; 2.7e-3 where nothing is spent";
    EXPECT_TRUE(std::isinf(status.deviation_bound)) << "none was asked for";

    // what is asked for, or came in, is not there to be spent; nor is it reached as long as the mesh is off the reference
    Indexed_mesh unspent = bulged_block(6, 0);
    const Status good = CGAL::optimize_hex_mesh(unspent.points, unspent.hexahedra, reference,
                                                params::target_quality(.99));
    EXPECT_NE(good.return_code, Return_code::TARGET_QUALITY_REACHED);
    EXPECT_GT(good.after.minimum, status.after.minimum);
    EXPECT_GT(good.deviation.maximum, status.deviation.maximum);
    EXPECT_LT(good.deviation.maximum_relative, 4e-3);
    const Status again = CGAL::optimize_hex_mesh(unspent.points, unspent.hexahedra, reference);
    EXPECT_GE(again.after.minimum, good.after.minimum);
  }
}

TEST(Volume, is_in_the_status_before_and_after)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{4, 3, 5}}, {{1, 2, 3}});
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  const Status status = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
  EXPECT_NEAR(status.volume_before, 6, 1e-12) << "wherever the interior is";
  EXPECT_NEAR(status.volume_after, 6, .06);
  Indexed_mesh unmoved = mesh;
  EXPECT_NEAR(CGAL::optimize_hex_mesh(unmoved.points, unmoved.hexahedra, params::number_of_iterations(1)).volume_before,
              status.volume_after, 1e-12);

  // inside out
  for (auto& h : mesh.hexahedra)
    std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
  const Status reversed = CGAL::optimize_hex_mesh(mesh.points, mesh.hexahedra);
  EXPECT_EQ(reversed.number_of_reoriented_hexahedra(), mesh.hexahedra.size());
  EXPECT_NEAR(reversed.volume_before, status.volume_after, 1e-12);
}

} // namespace
