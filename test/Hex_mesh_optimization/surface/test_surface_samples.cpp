// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Samples of a surface: as dense as they should be on one of the size of the mesh, and not more than in proportion to
// the mesh on one of any other size.

#include <CGAL/Hex_mesh_optimization/internal/surface/crest_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include "Cube_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

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

// A vertex on several sheets is a sample of each, and each sheet has its area.
TEST(Surface_samples, are_spread_sheet_by_sheet)
{
  const Surface cube(1);
  std::vector<int> sheets;
  for (std::size_t t = 0; t < cube.triangles.size(); ++t)
    sheets.push_back(int(t * 7 % 3)); // mixed
  const Triangle_surface surface(cube.points, cube.triangles, sheets);
  std::vector<double> areas(3, 0.);
  std::vector<std::set<int>> vertices(3);
  int last = 0;
  for (const Surface_sample& s : spread_samples(surface, number_of_faces, spacing)) {
    EXPECT_GE(s.sheet, last);
    last = s.sheet;
    areas[s.sheet] += s.area;
    if (s.vertex >= 0) {
      EXPECT_TRUE(vertices[s.sheet].insert(s.vertex).second) << "once in a sheet";
      EXPECT_EQ(s.point, cube.points[s.vertex]);
    }
  }
  std::vector<double> expected_areas(3, 0.);
  std::vector<std::set<int>> expected(3);
  for (std::size_t t = 0; t < sheets.size(); ++t) {
    expected_areas[sheets[t]] += .5;
    expected[sheets[t]].insert(cube.triangles[t].begin(), cube.triangles[t].end());
  }
  EXPECT_EQ(vertices, expected);
  for (int s = 0; s < 3; ++s)
    EXPECT_NEAR(areas[s], expected_areas[s], 1e-12);
}

// As they are, a needle would be divided into 64² parts, each as slender.
TEST(Surface_samples, divide_needles_along_their_length)
{
  const Vector_3 a(0, 0, 0), b(64, .1, 0), c(64, 0, 0);
  for (const auto& t : {std::array<Vector_3, 3>{a, b, c}, {b, c, a}, {c, a, b}, {a, c, Vector_3(30, .1, 0)}}) {
    std::vector<double> along;
    double sum = 0;
    for_parts(t[0], t[1], t[2], 1, [&](const Vector_3& place, double area) {
      along.push_back(place[0]);
      sum += area;
    });
    EXPECT_NEAR(sum, 3.2, 1e-9);
    EXPECT_LT(along.size(), 150u);
    std::sort(along.begin(), along.end());
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      EXPECT_LT(along[i + 1] - along[i], 2);
  }
}

// They are on the edges of a cube and nowhere else, evenly, and stand for a strip along each.
TEST(Crest_samples, are_on_sharp_edges)
{
  const Surface cube(1);
  const double width = .1;
  const std::vector<Surface_sample> samples = crest_samples(Triangle_surface(cube.points, cube.triangles),
                                                            number_of_faces, spacing, width);
  double area = 0;
  for (const Surface_sample& s : samples) {
    int extreme = 0;
    for (int d = 0; d < 3; ++d)
      extreme += std::abs(s.point[d]) < 1e-12 || std::abs(s.point[d] - 3) < 1e-12;
    EXPECT_EQ(extreme, 2) << s.point.transpose();
    EXPECT_EQ(s.vertex, -1);
    area += s.area;
  }
  EXPECT_NEAR(area, 12 * 3 * width, 1e-12);
  EXPECT_EQ(samples.size(), 12 * 3 * 2u) << "edges of length 1 in two parts each";
}

// Sheets that meet in a sharp edge, one on each side, have none there.
TEST(Crest_samples, are_of_single_sheets)
{
  const Surface cube(1);
  std::vector<int> sheets;
  for (const Triangle_indices& t : cube.triangles) {
    const Vector_3 n = (cube.points[t[1]] - cube.points[t[0]]).cross(cube.points[t[2]] - cube.points[t[0]]);
    sheets.push_back(n[2] > .1 ? 1 : 0); // the top
  }
  std::vector<std::size_t> number(2, 0);
  for (const Surface_sample& s :
       crest_samples(Triangle_surface(cube.points, cube.triangles, sheets), number_of_faces, spacing, 1)) {
    ++number[s.sheet];
  }
  EXPECT_EQ(number[0], 8 * 3 * 2u);
  EXPECT_EQ(number[1], 0u) << "flat";
}

// As many as the mesh can use, however long the edges are.
TEST(Crest_samples, of_an_oversized_surface_are_in_proportion_to_the_mesh)
{
  const Surface cube(1e100);
  EXPECT_LE(crest_samples(Triangle_surface(cube.points, cube.triangles), number_of_faces, spacing, 1).size(),
            12 * 3 * 64u);
}

} // namespace
