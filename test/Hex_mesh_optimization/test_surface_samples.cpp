// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Samples of a surface: as dense as they should be on one of the size of the mesh, and not more than in proportion to the
// mesh on one of any other size. And the triangles nearby, which must be found as by a search of all.

#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include "mesh_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr double spacing = .5;
constexpr std::size_t number_of_faces = 54; // of the mesh that the surface stands for, with edges of length 1

struct Surface
{
  Positions points;
  std::vector<Triangle_indices> triangles;

  // a cube with as many faces as the mesh
  explicit Surface(double scale)
  {
    Indexed_mesh block;
    CGAL::Hex_mesh_optimization::make_block(block.points, block.hexahedra, {{3, 3, 3}}, {{3, 3, 3}});
    for_boundary(block,
                 [&](const Indexed_mesh::Point& p) {
                   points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
                   return static_cast<int>(points.size()) - 1;
                 },
                 [&](int a, int b, int c) { triangles.push_back({a, b, c}); });
  }

  std::vector<Surface_sample> samples() const { return spread_samples(points, triangles, number_of_faces, spacing); }
};

std::size_t largest_number(const Surface& surface)
{
  return surface.points.size() + 2 * surface.triangles.size() + std::size_t(16 * number_of_faces / (spacing * spacing));
}

double area(const std::vector<Surface_sample>& samples)
{
  double sum = 0;
  for (const Surface_sample& s : samples)
    sum += s.area;
  return sum;
}

TEST(Surface_samples, are_as_dense_as_asked_for_on_a_surface_of_the_size_of_the_mesh)
{
  for (double scale : {.01, 1., 1.9}) {
    const Surface surface(scale);
    std::vector<char> seen(surface.points.size(), false);
    for (const Surface_sample& s : surface.samples()) {
      EXPECT_LE(s.area, spacing * spacing / 4 * (1 + 1e-9)); // a right triangle with that hypotenuse
      if (s.vertex >= 0)
        seen[s.vertex] = true;
    }
    EXPECT_EQ(seen, std::vector<char>(surface.points.size(), true));
    EXPECT_NEAR(area(surface.samples()), 54 * scale * scale, 1e-9);
  }
}

TEST(Surface_samples, of_an_oversized_surface_are_in_proportion_to_the_mesh)
{
  for (double scale : {2.5, 10., 1e3, 1e10, 1e50}) {
    const Surface surface(scale);
    const std::vector<Surface_sample> samples = surface.samples();
    EXPECT_LE(samples.size(), largest_number(surface)) << scale;
    EXPECT_GE(samples.size(), 8 * number_of_faces) << scale;
    EXPECT_NEAR(area(samples) / (54 * scale * scale), 1, 1e-9) << scale;
  }
}

TEST(Surface_samples, of_a_surface_beyond_the_range_of_areas_are_its_vertices_and_triangles)
{
  const Surface surface(1e200);
  EXPECT_EQ(surface.samples().size(), surface.points.size() + surface.triangles.size());
}

TEST(Surface_samples, of_long_needles_are_in_proportion_to_the_mesh)
{
  for (double length : {1e3, 1e6, 1e100}) {
    Surface surface(1);
    surface.points.front().y() -= length;
    surface.points.back().x() += length;
    const std::vector<Surface_sample> samples = surface.samples();
    EXPECT_LE(samples.size(), largest_number(surface)) << length;
    for (const Surface_sample& s : samples)
      EXPECT_TRUE(s.point.allFinite());
  }
}

// --- Triangles nearby ---------------------------------------------------------------------------

double distance_to_all(const Vector_3& p, const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    least = (std::min)(least, (closest_point_of_triangle(p, t, points, triangles).point - p).norm());
  return least;
}

// No point of a fine lattice of the triangle is closer; also for needles, segments and points
TEST(Closest_point_of_triangle, is_closest)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Vector_3(uniform(random), uniform(random), uniform(random)); };
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector_3 a = point(), b = trial % 7 == 0 ? a : point(), p = 2 * point();
    const Vector_3 c = trial % 5 == 0 ? Vector_3(a + uniform(random) * (b - a)) : trial % 11 == 0 ? b : point();
    const std::array<double, 3> w = closest_point_of_triangle(p, a, b, c);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-12);
    for (double weight : w)
      EXPECT_GE(weight, 0);
    const double distance = (w[0] * a + w[1] * b + w[2] * c - p).norm();
    const int n = 12;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        EXPECT_LE(distance, (a + double(i) / n * (b - a) + double(j) / n * (c - a) - p).norm() + 1e-9);
  }
}

// Whatever has moved: what is found is the closest of all triangles, or nothing is found
TEST(Nearby_triangles, are_the_closest_while_they_are_said_to_be)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&](double size) { return Vector_3(size * uniform(random), size * uniform(random), size * uniform(random)); };
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  const std::size_t n = 200;
  Nearby_triangles nearby;
  nearby.reset(n);
  int found = 0, not_found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector_3 p = Vector_3::Constant(1.5) + point(2);
    EXPECT_FALSE(nearby.closest(i, p, cube.points, cube.triangles, 0)) << "nothing is listed yet";
    if (!nearby.list(i, p, distance_to_all(p, cube.points, cube.triangles), surface))
      continue; // a crowd, in the middle of the cube
    for (double size : {0., .02, .05, .2}) {
      Positions moved = cube.points;
      double farthest = 0;
      for (Vector_3& q : moved) {
        const Vector_3 step = point(size);
        farthest = (std::max)(farthest, step.norm());
        q += step;
      }
      const Vector_3 now = p + point(size);
      const std::optional<Surface_point> foot = nearby.closest(i, now, moved, cube.triangles, farthest);
      ++(foot ? found : not_found);
      if (foot) {
        EXPECT_NEAR((foot->point - now).norm(), distance_to_all(now, moved, cube.triangles), 1e-12);
      }
      if (size == 0) {
        EXPECT_TRUE(foot);
      }
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(not_found, 100);
}

TEST(Nearby_triangles, give_way_to_a_tree_in_a_crowd)
{
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  Nearby_triangles nearby;
  nearby.reset(1);
  const Vector_3 center = Vector_3::Constant(1.5);
  EXPECT_FALSE(nearby.list(0, center, 1.5, surface));
  EXPECT_FALSE(nearby.closest(0, center, cube.points, cube.triangles, 0));
}

TEST(Triangle_surface, has_no_closer_point_than_the_closest)
{
  const Surface cube(1);
  const Triangle_surface surface(cube.points, cube.triangles);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 4);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector_3 p(uniform(random), uniform(random), uniform(random));
    const Vector_3 closest = surface.closest_point(p).point;
    const auto none = surface.closer_point(p, closest);
    EXPECT_TRUE(!none || (none->point - p).norm() > (closest - p).norm() - 1e-12);
    const auto other = surface.closer_point(p, closest + 1.5 * (closest - p) + Vector_3(1e-3, 0, 0));
    ASSERT_TRUE(other);
    EXPECT_NEAR((other->point - p).norm(), (closest - p).norm(), 1e-12);
  }
}

} // namespace
