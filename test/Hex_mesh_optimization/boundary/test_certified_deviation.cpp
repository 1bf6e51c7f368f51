// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The certified distance is above every sample and below what it promises, exact where that is known, and the same in
// any number of threads and in any place.

#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>

#include "../block_of_cubes.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
namespace HMO = CGAL::Hex_mesh_optimization;

const double infinity = std::numeric_limits<double>::infinity();

// By all triangles
double distance(const Vector_3& p, const Triangle_surface& surface)
{
  double least = infinity;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    least = (std::min)(least, (closest_point_of_triangle(p, t, surface.points, surface.triangles).point - p).norm());
  return least;
}

double largest_sample(const Triangle_surface& first, const Triangle_surface& second, double spacing)
{
  const std::size_t any_size = 1000000000; // of the surfaces, to be sampled as densely as that
  Deviations result;
  result.of_sheet.resize(1);
  extend_deviations(first, second, any_size, spacing, result);
  extend_deviations(second, first, any_size, spacing, result);
  return result.all.maximum;
}

// The unit square times a size in n² quads, moved
Triangle_surface sheet(int n, double size = 1, const Vector_3& offset = Vector_3::Zero(),
                       std::optional<Beyond_rim> beyond = std::nullopt)
{
  Positions points;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<bool, 4>> rims;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.push_back(Vector_3(size * i / n, size * j / n, 0) + offset);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = i + (n + 1) * j;
      quads.push_back({v, v + 1, v + n + 2, v + n + 1});
      rims.push_back({j == 0, i == n - 1, j == n - 1, i == 0});
    }
  const std::vector<Triangle_indices> triangles = split_quads(quads);
  if (!beyond)
    return Triangle_surface(points, triangles);
  Surface_faces faces;
  faces.rims = rims;
  return Triangle_surface(points, triangles, {}, Rims(triangles, {}, rim_sides(faces), *beyond));
}

void expect_same(const Certified_deviation& a, const Certified_deviation& b, double scale = 1)
{
  EXPECT_EQ(scale * a.upper_bound, b.upper_bound);
  EXPECT_EQ(scale * a.largest_found, b.largest_found);
  EXPECT_EQ(scale * a.where, b.where);
  EXPECT_EQ(a.is_shown, b.is_shown);
}

// --- Where the distance is known -----------------------------------------------------------

TEST(Farthest_places, are_those_of_the_triangles_beyond_their_targets)
{
  const Triangle_surface flat = sheet(4);
  Positions points = flat.points;
  points[12].z() = .1; // the center
  const Triangle_surface raised(points, flat.triangles);
  const std::vector<Found_in_triangle> places = farthest_places(raised, flat,
                                                                [](std::size_t, std::size_t) { return .05; });
  ASSERT_FALSE(places.empty());
  for (const Found_in_triangle& place : places) {
    const Triangle_indices& t = raised.triangles[place.triangle];
    EXPECT_TRUE(t[0] == 12 || t[1] == 12 || t[2] == 12);
    EXPECT_NEAR((place.where - points[12]).norm(), 0, .01) << "of each the farthest";
  }
  EXPECT_TRUE(farthest_places(raised, flat, [](std::size_t, std::size_t) { return .2; }).empty());
  EXPECT_TRUE(farthest_places(flat, flat, [](std::size_t, std::size_t) { return 1e-9; }).empty());
  const std::size_t only = places.front().triangle;
  EXPECT_EQ(
    farthest_places(raised, flat, [&](std::size_t t, std::size_t) { return t == only ? .05 : infinity; }).size(), 1u);
  EXPECT_TRUE(farthest_places(flat, raised, [](std::size_t, std::size_t) { return .05; }).size() > 0)
    << "the other way round";
}

// Under a ridge the distance has a sharp peak, which is at no center of the parts that a triangle is cut into
TEST(Farthest_places, are_found_where_the_distance_has_a_sharp_peak)
{
  for (double ridge : {.37, .5, .613}) {
    const Triangle_surface flat = sheet(1);
    const double far = 3, height = .5;
    const auto roof_point = [&](double x, double y) { return Vector_3(x, y, height - std::abs(x - ridge)); };
    const Positions points{roof_point(ridge - far, -far), roof_point(ridge, -far), roof_point(ridge + far, -far),
                           roof_point(ridge - far, far),  roof_point(ridge, far),  roof_point(ridge + far, far)};
    const Triangle_surface roof(points, split_quads({{0, 1, 4, 3}, {1, 2, 5, 4}}));
    const double peak = height / std::sqrt(2.), target = .9999 * peak;
    const std::vector<Found_in_triangle> places = farthest_places(flat, roof,
                                                                  [&](std::size_t, std::size_t) { return target; });
    ASSERT_FALSE(places.empty()) << ridge;
    for (const Found_in_triangle& place : places)
      EXPECT_NEAR(place.where.x(), ridge, .02);
    EXPECT_TRUE(farthest_places(flat, roof, [&](std::size_t, std::size_t) { return 1.02 * peak; }).empty());
  }
}

TEST(Certified_deviation, of_parallel_sheets_is_their_distance)
{
  for (double height : {.3, 1e-3, 1e-6})
    for (std::pair<int, int> n :
         {std::make_pair(1, 1), std::make_pair(3, 4), std::make_pair(1, 25), std::make_pair(20, 7)}) {
      const Triangle_surface low = sheet(n.first), high = sheet(n.second, 1, Vector_3(0, 0, height));
      const Certified_deviation d = certified_distance(low, high, height + 1e-10);
      EXPECT_TRUE(d.is_shown) << n.first << ' ' << n.second << ": " << d.upper_bound << " of " << height;
      EXPECT_NEAR(d.largest_found, height, 1e-12);
      EXPECT_GE(d.upper_bound, height);
      const Certified_deviation missed = certified_distance(low, high, .99 * height);
      EXPECT_FALSE(missed.is_shown);
      EXPECT_NEAR(missed.largest_found, height, 1e-12);
      EXPECT_LE(missed.upper_bound, 1.01 * height + 1e-10);
    }
}

// Only at a corner of the larger one is it that much, only in one direction
TEST(Certified_deviation, is_that_of_both_directions)
{
  const Triangle_surface small = sheet(4), large = sheet(3, 2, Vector_3(0, 0, .5));
  const double exact = std::sqrt(2 + .25);
  for (bool swapped : {false, true}) {
    const Certified_deviation d = swapped ? certified_distance(large, small, 0) : certified_distance(small, large, 0);
    EXPECT_NEAR(d.largest_found, exact, 1e-12);
    EXPECT_NEAR((d.where - Vector_3(2, 2, .5)).norm(), 0, 1e-12);
    EXPECT_GE(d.upper_bound, exact);
    EXPECT_LE(d.upper_bound, 1.01 * exact + 1e-10);
  }
}

// Beside each other, and over each other: the one goes on in its plane, the other does not have to.
TEST(Certified_deviation, beyond_rims_is_that_across)
{
  const double height = .3;
  for (double size : {.8, 1., 1.3})
    for (const Vector_3& offset : {Vector_3(1.2, 0, height), Vector_3(-.6, .3, height), Vector_3(1.1, 1.4, height)}) {
      const Triangle_surface reference = sheet(5, 1, Vector_3::Zero(), Beyond_rim::PLANE);
      const Triangle_surface mesh = sheet(4, size, offset, Beyond_rim::ANYTHING);
      const Certified_deviation d = certified_distance(mesh, reference, height + 1e-10);
      EXPECT_TRUE(d.is_shown) << d.upper_bound;
      EXPECT_NEAR(d.largest_found, height, 1e-12);
      EXPECT_FALSE(certified_distance(mesh, reference, .99 * height).is_shown);
    }
}

TEST(Certified_deviation, of_a_moved_vertex_is_its_way)
{
  const Block block(4, 4, 4);
  const Hexahedral_complex complex = block.complex();
  const Triangle_surface reference(block.points, boundary_triangles(complex));
  for (double way : {.4, 1e-2, 1e-4}) {
    Positions points = block.points;
    const int v = block.vertex(2, 2, 4);
    points[v][2] += way;
    const Certified_deviation d = certified_deviation(boundary_surface_faces(complex), points, reference, 1.001 * way);
    EXPECT_TRUE(d.is_shown);
    EXPECT_NEAR(d.largest_found, way, 1e-12);
    EXPECT_EQ(d.where, points[v]);
    EXPECT_FALSE(certified_deviation(boundary_surface_faces(complex), points, reference, .999 * way).is_shown);
  }
}

// Far between the samples: a fin that no vertex and no center of a triangle comes from
TEST(Certified_deviation, sees_what_samples_miss)
{
  const Triangle_surface sheet({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}});
  // the same, but for a notch beside its longest side
  const Triangle_surface notched({{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {6, 3, 0}, {5.9, 3.1, 0}, {5.9, 2.9, 0}},
                                 {{0, 1, 5}, {1, 3, 5}, {0, 5, 2}, {5, 4, 2}});
  const double exact = Vector_3(.05, .05, 0).norm(); // of the middle of the gap, to the sides of the notch, or less
  const Certified_deviation d = certified_distance(sheet, notched, 1e-4);
  EXPECT_FALSE(d.is_shown);
  EXPECT_GT(d.largest_found, 1e-2);
  EXPECT_LE(d.upper_bound, 1.01 * exact + 1e-10);
  EXPECT_LE(d.upper_bound, 1.01 * d.largest_found + 1e-10);
}

TEST(Certified_deviation, is_infinite_for_a_surface_without_area)
{
  const Triangle_surface none({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), some = sheet(2);
  for (const Certified_deviation& d : {certified_distance(none, some, 1), certified_distance(some, none, 1)}) {
    EXPECT_EQ(d.upper_bound, infinity);
    EXPECT_FALSE(d.is_shown);
  }
}

// --- Over families of meshes ---------------------------------------------------------------

class Certified_deviation_of : public ::testing::TestWithParam<Mesh_family>
{};
INSTANTIATE_TEST_SUITE_P(families, Certified_deviation_of, ::testing::ValuesIn(mesh_families()), Family_name());

Positions jittered(const Mesh_family& family, double edges, unsigned seed)
{
  const Indexed_mesh mesh = family();
  std::mt19937 random(seed);
  return moved(positions(mesh), random, edges * mesh.mean_edge_length());
}

// As the triangles of another program
Triangle_surface split_otherwise(const Indexed_mesh& mesh)
{
  Positions points;
  std::vector<Triangle_indices> triangles;
  for_boundary(
    mesh,
    [&](const Indexed_mesh::Point& p) {
      points.emplace_back(p.x(), p.y(), p.z());
      return static_cast<int>(points.size()) - 1;
    },
    [&](int a, int b, int c) {
      triangles.push_back({a, b, c});
    });
  return Triangle_surface(points, triangles);
}

TEST_P(Certified_deviation_of, a_mesh_from_itself_is_shown_without_a_cut)
{
  const Hexahedral_complex complex = GetParam()().complex();
  Certification_parameters parameters;
  parameters.pieces = 1;
  const Positions points = jittered(GetParam(), .2, 1);
  const Triangle_surface reference(points, boundary_triangles(complex));
  const Certified_deviation d = certified_deviation(boundary_surface_faces(complex), points, reference, 1e-9,
                                                    parameters);
  EXPECT_TRUE(d.is_shown) << d.upper_bound;
  EXPECT_LT(d.largest_found, 1e-13);
}

TEST_P(Certified_deviation_of, is_above_all_samples_and_close_to_the_largest)
{
  const Indexed_mesh mesh = GetParam()();
  const Hexahedral_complex complex = mesh.complex();
  const Triangle_surface own(positions(mesh), boundary_triangles(complex)), other = split_otherwise(mesh);
  for (const Triangle_surface* reference : {&own, &other})
    for (double edges : {.3, .05, 1e-3}) {
      const Triangle_surface boundary(jittered(GetParam(), edges, 2), boundary_triangles(complex));
      const double spacing = .05 * mesh.mean_edge_length(), sampled = largest_sample(boundary, *reference, spacing);
      const Certified_deviation d = certified_distance(boundary, *reference, 0);
      EXPECT_GE(d.upper_bound, sampled);
      EXPECT_LE(d.upper_bound, 1.01 * d.largest_found + 1e-10);
      // what was found is there, though samples may miss it: by a tenth for the plate with a hole
      EXPECT_LE(d.largest_found, sampled + spacing);
      EXPECT_NEAR((std::max)(distance(d.where, boundary), distance(d.where, *reference)), d.largest_found, 1e-12);
      for (double part : {.5, .95, 1.05, 2.}) {
        const double target = part * d.upper_bound;
        const Certified_deviation asked = certified_distance(boundary, *reference, target);
        EXPECT_EQ(asked.is_shown, part > 1) << asked.upper_bound << " of " << target;
        EXPECT_EQ(asked.is_shown, asked.upper_bound <= target);
        EXPECT_GE(asked.upper_bound, sampled);
        EXPECT_LE(asked.largest_found, d.upper_bound);
      }
    }
}

// Whatever is left undone
TEST_P(Certified_deviation_of, is_valid_when_it_ends_early)
{
  const Indexed_mesh mesh = GetParam()();
  const Hexahedral_complex complex = mesh.complex();
  const Triangle_surface reference = split_otherwise(mesh),
                         boundary(jittered(GetParam(), .1, 3), boundary_triangles(complex));
  const double sampled = largest_sample(boundary, reference, .05 * mesh.mean_edge_length());
  double before = infinity;
  for (std::size_t pieces : {1, 2, 8, 64}) {
    Certification_parameters parameters;
    parameters.pieces = pieces;
    const double bound = certified_distance(boundary, reference, .5 * sampled, parameters).upper_bound;
    EXPECT_GE(bound, sampled);
    EXPECT_LE(bound, before);
    before = bound;
  }
  Certification_parameters first_witness;
  first_witness.tolerance = infinity;
  const Certified_deviation d = certified_distance(boundary, reference, .5 * sampled, first_witness);
  EXPECT_FALSE(d.is_shown);
  EXPECT_GT(d.largest_found, .5 * sampled);
  EXPECT_GE(d.upper_bound, sampled);
  EXPECT_TRUE(std::isfinite(d.upper_bound));
}

TEST_P(Certified_deviation_of, is_the_same_wherever_the_surfaces_are)
{
  const Indexed_mesh mesh = GetParam()();
  const std::vector<Triangle_indices> triangles = boundary_triangles(mesh.complex());
  const Positions first = jittered(GetParam(), .1, 4), second = jittered(GetParam(), .1, 5);
  const auto certified = [&](const auto& map, double target) {
    const auto mapped = [&](Positions points) {
      for (Vector_3& p : points)
        p = map(p);
      return Triangle_surface(points, triangles);
    };
    return certified_distance(mapped(first), mapped(second), target);
  };
  const double target = .05 * mesh.mean_edge_length();
  const Certified_deviation d = certified([](const Vector_3& p) { return p; }, target);
  for (double scale : {std::ldexp(1, 40), std::ldexp(1, -40)})
    expect_same(d, certified([&](const Vector_3& p) { return Vector_3(scale * p); }, scale * target), scale);
  const Matrix_3 rotation = Eigen::AngleAxisd(1, Vector_3(1, 2, 3).normalized()).toRotationMatrix();
  const Certified_deviation rotated =
    certified([&](const Vector_3& p) { return Vector_3(rotation * p + Vector_3(5, -3, 2)); }, target);
  EXPECT_NEAR(rotated.upper_bound, d.upper_bound, .011 * d.upper_bound);
  EXPECT_EQ(rotated.is_shown, d.is_shown);
}

// --- Larger surfaces -----------------------------------------------------------------------

TEST(Certified_deviation, of_balls_in_any_numbers_of_triangles_is_bounded_by_samples)
{
  Indexed_mesh fine, coarse;
  HMO::make_ball(fine.points, fine.hexahedra, 9);
  HMO::make_ball(coarse.points, coarse.hexahedra, 2);
  const Triangle_surface many = split_otherwise(fine), few = split_otherwise(coarse);
  const double sampled = largest_sample(few, many, .02 * coarse.mean_edge_length());
  const Certified_deviation d = certified_distance(few, many, 1.05 * sampled);
  EXPECT_TRUE(d.is_shown) << d.upper_bound << " of " << sampled;
  EXPECT_GE(d.upper_bound, sampled);
}

TEST(Certified_deviation, does_not_depend_on_the_number_of_threads)
{
  Indexed_mesh mesh;
  HMO::make_ball(mesh.points, mesh.hexahedra, 12);
  const Hexahedral_complex complex = mesh.complex();
  const Triangle_surface reference = split_otherwise(mesh);
  std::mt19937 random(6);
  const Positions points = moved(positions(mesh), random, .1 * mesh.mean_edge_length());
  for (double edges : {0., .1, .15, .3}) {
    Certified_deviation alone, together;
    const double target = edges * mesh.mean_edge_length();
    run_concurrently(false,
                     [&] { alone = certified_deviation(boundary_surface_faces(complex), points, reference, target); });
    run_concurrently(true, [&] {
      together = certified_deviation(boundary_surface_faces(complex), points, reference, target);
    });
    expect_same(alone, together);
  }
}

// --- Bilinear faces ------------------------------------------------------------------------

TEST(Bilinear_excess, is_reached_at_the_center_of_a_face_and_nowhere_exceeded)
{
  const Block block(1, 1, 1);
  const Hexahedral_complex complex = block.complex();
  EXPECT_EQ(bilinear_excess(complex, block.points), 0);
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Positions points = moved(block.points, random, .3);
    const double excess = bilinear_excess(complex, points);
    double at_centers = 0;
    for (const auto& f : complex.boundary_faces) {
      const Vector_3 &a = points[f.vertices[0]], &b = points[f.vertices[1]], &c = points[f.vertices[2]],
                     &d = points[f.vertices[3]];
      at_centers = (std::max)(at_centers, ((a + b + c + d) / 4 - (a + c) / 2).norm());
      const Triangle_surface triangles({a, b, c, d}, {{0, 1, 2}, {0, 2, 3}});
      for (double u = 0; u <= 1; u += .125)
        for (double v = 0; v <= 1; v += .125)
          EXPECT_LE(distance((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * d + u * c), triangles), excess + 1e-15);
    }
    EXPECT_NEAR(at_centers, excess, 1e-15);
  }
}

} // namespace
