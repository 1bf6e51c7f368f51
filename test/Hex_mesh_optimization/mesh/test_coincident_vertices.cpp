// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices of faces in the same places are found, and no others.

#include <CGAL/Hex_mesh_optimization/internal/mesh/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>

#include "../block_of_cubes.h"

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace {

std::vector<int> found(const Positions& points, const std::vector<Hexahedron>& hexahedra)
{
  return coincident_vertices(points, Face_neighbors(hexahedra));
}

std::vector<int> each_alone(std::size_t n)
{
  std::vector<int> result(n);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

// Each hexahedron gets vertices of its own; origin holds the vertex that each was.
struct Unmerged
{
  Positions points;
  std::vector<Hexahedron> hexahedra;
  std::vector<int> origin;

  explicit Unmerged(const Block& block, unsigned int seed)
  {
    std::vector<int> order;
    for (int k = 0; k < int(8 * block.hexahedra.size()); ++k)
      order.push_back(k);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    points.resize(order.size());
    origin.resize(order.size());
    hexahedra.resize(block.hexahedra.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const int v = block.hexahedra[k / 8][k % 8];
      origin[order[k]] = v;
      points[order[k]] = block.points[v];
      hexahedra[k / 8][k % 8] = order[k];
    }
  }
};

TEST(Coincident_vertices, of_hexahedra_with_vertices_of_their_own_are_those_of_the_whole)
{
  for (unsigned int seed = 0; seed < 5; ++seed) {
    const Unmerged mesh(Block(3, 2, 2), seed);
    const std::vector<int> result = found(mesh.points, mesh.hexahedra);
    for (std::size_t v = 0; v < result.size(); ++v) {
      const auto first = std::find(mesh.origin.begin(), mesh.origin.end(), mesh.origin[v]);
      EXPECT_EQ(result[v], first - mesh.origin.begin());
    }
  }
}

TEST(Coincident_vertices, along_a_slit)
{
  Block block(2, 2, 1);
  EXPECT_EQ(found(block.points, block.hexahedra), each_alone(18));
  // the face between hexahedra 0 and 1 has vertices for either, but for those in the middle
  const int below = block.vertex(1, 0, 0), above = block.vertex(1, 0, 1);
  block.points.push_back(block.points[below]);
  block.points.push_back(block.points[above]);
  for (int& v : block.hexahedra[1])
    v = v == below ? 18 : v == above ? 19 : v;
  std::vector<int> expected = each_alone(20);
  expected[18] = below;
  expected[19] = above;
  EXPECT_EQ(found(block.points, block.hexahedra), expected);
  block.points[18][0] = std::nextafter(1., 2.);
  EXPECT_EQ(found(block.points, block.hexahedra), each_alone(20)) << "not the same place";
  block.points[18][0] = 1;
  block.points[below][1] = -0.;
  EXPECT_EQ(found(block.points, block.hexahedra), expected) << "-0 is 0";
}

// In one place, but without a face in common
TEST(Coincident_vertices, of_collapsed_hexahedra_and_of_edges_that_touch_are_none)
{
  Block block(2, 2, 2);
  for (Vector_3& p : block.points)
    p = Vector_3(1, 2, 3);
  EXPECT_EQ(found(block.points, block.hexahedra), each_alone(27));

  block = Block(2, 2, 1);
  block.hexahedra = {block.hexahedra[0], block.hexahedra[3]};
  const int n = int(block.points.size());
  for (int& v : block.hexahedra[1]) {
    block.points.push_back(block.points[v]);
    v = int(block.points.size()) - 1;
  }
  EXPECT_EQ(found(block.points, block.hexahedra), each_alone(std::size_t(n) + 8));
}

TEST(Coincident_vertices, that_differ_by_rounding_are_found_with_a_tolerance)
{
  const Unmerged mesh(Block(3, 2, 2), 1);
  Positions rounded = mesh.points;
  for (std::size_t v = 0; v < rounded.size(); ++v)
    rounded[v] += 1e-6 * Vector_3(double(v % 3) - 1, double(v % 5) - 2, double(v % 7) - 3);
  const Face_neighbors neighbors(mesh.hexahedra);
  const std::vector<int> expected = found(mesh.points, mesh.hexahedra);
  EXPECT_EQ(coincident_vertices(rounded, neighbors, 1e-4), expected);
  EXPECT_EQ(coincident_vertices(mesh.points, neighbors, 1e-4), expected);
  EXPECT_EQ(coincident_vertices(rounded, neighbors), each_alone(rounded.size()));
  EXPECT_EQ(coincident_vertices(rounded, neighbors, 1e-7), each_alone(rounded.size()));
}

TEST(Coincident_vertices, of_ranges)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  namespace HMO = CGAL::Hex_mesh_optimization;
  const Unmerged mesh(Block(2, 2, 2), 1);
  std::vector<Point> points;
  for (const Vector_3& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<long>> hexahedra;
  for (const Hexahedron& h : mesh.hexahedra)
    hexahedra.emplace_back(h.begin(), h.end());
  const std::vector<std::size_t> result = HMO::coincident_vertices(points, hexahedra);
  const std::vector<int> expected = found(mesh.points, mesh.hexahedra);
  EXPECT_TRUE(std::equal(result.begin(), result.end(), expected.begin(), expected.end(),
                         [](std::size_t a, int b) { return a == std::size_t(b); }));

  for (const long bad : {-1l, 64l, std::numeric_limits<long>::max()}) {
    auto wrong = hexahedra;
    wrong[3][2] = bad;
    EXPECT_THROW(HMO::coincident_vertices(points, wrong), HMO::Input_error);
  }
  for (const std::size_t size : {7, 9}) {
    auto wrong = hexahedra;
    wrong[3].resize(size, 0);
    EXPECT_THROW(HMO::coincident_vertices(points, wrong), HMO::Input_error);
  }
  points[5] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_THROW(HMO::coincident_vertices(points, hexahedra), HMO::Input_error);
}

} // namespace
