// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Two-sided deviations, of each sheet for itself and of all together.

#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Layers of cubes with the labels 0, 1, ... from below
struct Layers
{
  Block block;
  Hexahedral_complex complex;
  Surface_faces faces;
  Triangle_surface reference;

  explicit Layers(int n, bool outside_is_one = false)
    : block(3, 3, n)
    , complex(block.points.size(), block.hexahedra, {labels(block), {}})
    , faces(boundary_surface_faces(complex, outside_is_one))
    , reference(block.points, split_quads(faces.quads), triangle_sheets(faces),
                Rims(split_quads(faces.quads), triangle_sheets(faces), rim_sides(faces), Beyond_rim::PLANE))
  {}

  static std::vector<int> labels(const Block& block)
  {
    std::vector<int> result;
    for (const Hexahedron& h : block.hexahedra)
      result.push_back(int(block.points[h[0]][2]));
    return result;
  }

  int sheet(int below, int above) const
  {
    const std::array<int, 2> labels{below, above};
    return int(std::find(faces.labels.begin(), faces.labels.end(), labels) - faces.labels.begin());
  }
};

TEST(Deviations, of_what_has_not_moved_are_zero)
{
  const Layers layers(3);
  const Deviations d = deviations(layers.faces, layers.block.points, layers.reference, .2);
  ASSERT_EQ(d.of_sheet.size(), 5u);
  EXPECT_LT(d.all.maximum, 1e-14);
  for (const auto& s : d.of_sheet)
    EXPECT_LT(s.maximum, 1e-14);
}

// The mesh cuts an edge of the reference off: what is farthest is on that edge, between its ends.
TEST(Deviations, are_those_of_sharp_edges_too)
{
  const Layers layers(3);
  Positions points = layers.block.points;
  const double chamfer = .3;
  for (Vector_3& p : points)
    if (p[0] == 3 && p[1] == 3 && p[2] > 0 && p[2] < 3)
      p -= Vector_3(chamfer, chamfer, 0);
  const Deviations d = deviations(layers.faces, points, layers.reference, .05);
  // the corners of the cut faces stay where they were
  const double expected = chamfer * std::sqrt(2.) / std::sqrt(1 + 2 * chamfer * chamfer / 4);
  EXPECT_LE(d.all.maximum, chamfer * std::sqrt(2.) + 1e-12);
  EXPECT_GT(d.all.maximum, .9 * expected);
}

// An interface that has moved onto another one is as far from its own place as before
TEST(Deviations, of_a_sheet_are_from_its_own_place)
{
  const Layers layers(4);
  Positions points = layers.block.points;
  for (Vector_3& p : points)
    if (p[2] == 1 || p[2] == 2)
      p[2] = 3 - p[2];
  const Deviations d = deviations(layers.faces, points, layers.reference, .2);
  const int first = layers.sheet(0, 1), second = layers.sheet(1, 2), third = layers.sheet(2, 3);
  EXPECT_NEAR(d.of_sheet[first].maximum, 1, 1e-12);
  EXPECT_NEAR(d.of_sheet[first].average, 1, 1e-12);
  EXPECT_NEAR(d.of_sheet[second].maximum, 1, 1e-12);
  EXPECT_LT(d.of_sheet[third].maximum, 1e-12);
  EXPECT_NEAR(d.all.maximum, 1, 1e-12);
  EXPECT_LT(d.all.average, .7);
  const double diagonal = std::sqrt(9. + 9. + 16.);
  EXPECT_NEAR(d.of_sheet[first].maximum_relative, 1 / diagonal, 1e-12);
  EXPECT_NEAR(d.all.maximum_relative, 1 / diagonal, 1e-12);
}

// Where the outside goes along with another surface, what is in the plane of an interface is on it.
TEST(Deviations, of_an_interface_are_measured_across_it_beyond_its_rim)
{
  const Layers layers(2, true);
  const int outside = 0, interface = layers.sheet(0, 1);
  ASSERT_NE(interface, outside);
  for (double factor : {.7, 1.3}) {
    Positions points = layers.block.points;
    for (Vector_3& p : points)
      p = Vector_3(1.5 + factor * (p[0] - 1.5), 1.5 + factor * (p[1] - 1.5), p[2]);
    const Deviations aside = deviations(layers.faces, points, layers.reference, .2);
    EXPECT_LT(aside.of_sheet[interface].maximum, 1e-12);
    EXPECT_NEAR(aside.of_sheet[outside].maximum, .45 * std::sqrt(2), 1e-12) << "at the corners";
    for (Vector_3& p : points)
      p[2] += .2;
    const Deviations across = deviations(layers.faces, points, layers.reference, .2);
    EXPECT_NEAR(across.of_sheet[interface].maximum, .2, 1e-12);
  }
}

// The sums of all are those of the sheets, whichever of them are far off
TEST(Deviations, of_all_are_within_those_of_the_sheets)
{
  const Layers layers(3);
  Positions points = layers.block.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += .1 * double(v % 3) * Vector_3(std::sin(double(v)), std::cos(double(v)), 1);
  const Deviations d = deviations(layers.faces, points, layers.reference, .2);
  double largest = 0, least = 1e9, most = 0;
  for (const auto& s : d.of_sheet) {
    EXPECT_GT(s.average, 0);
    EXPECT_LE(s.average, s.maximum);
    largest = (std::max)(largest, s.maximum);
    least = (std::min)(least, s.average);
    most = (std::max)(most, s.average);
  }
  EXPECT_EQ(d.all.maximum, largest);
  EXPECT_GE(d.all.average, least);
  EXPECT_LE(d.all.average, most);
}

} // namespace
