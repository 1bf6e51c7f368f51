// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Hexahedra = std::vector<std::array<std::size_t, 8>>;

double fraction_inverted(const Points& points, const Hexahedra& hexahedra)
{
  std::size_t inverted = 0;
  for (const auto& hexahedron : hexahedra)
    for (int corner = 0; corner < 8; ++corner) {
      const int* neighbors = HMO::internal::corner_neighbors[corner];
      const Point& p = points[hexahedron[corner]];
      if (CGAL::determinant(points[hexahedron[neighbors[0]]] - p, points[hexahedron[neighbors[1]]] - p,
                            points[hexahedron[neighbors[2]]] - p) <= 0) {
        ++inverted;
        break;
      }
    }
  return static_cast<double>(inverted) / static_cast<double>(hexahedra.size());
}

// In a grid of n^3 unit cells the boundary is known without looking at faces.
struct Grid
{
  explicit Grid(std::size_t n) : size(static_cast<double>(n))
  {
    HMO::make_block(points, hexahedra, {{n, n, n}}, {{size, size, size}});
  }

  bool is_boundary(std::size_t v) const
  {
    for (int d = 0; d < 3; ++d)
      if (points[v][d] == 0 || points[v][d] == size)
        return true;
    return false;
  }

  double size;
  Points points;
  Hexahedra hexahedra;
};

struct Corruption
{
  std::string name;
  std::function<void(Points&, const Hexahedra&, std::uint64_t)> apply;
};

const std::vector<Corruption>& interior_corruptions()
{
  static const std::vector<Corruption> all = {
    {"scramble", [](Points& p, const Hexahedra& h, std::uint64_t s) { HMO::scramble_interior(p, h, s); }},
    {"scramble_by_amplitude",
     [](Points& p, const Hexahedra& h, std::uint64_t s) { HMO::scramble_interior(p, h, s, .8); }},
    {"rotate", [](Points& p, const Hexahedra& h, std::uint64_t s) { HMO::rotate_hexahedra(p, h, s, .5); }},
    {"displace", [](Points& p, const Hexahedra& h, std::uint64_t s) { HMO::displace_vertex(p, h, s); }}};
  return all;
}

TEST(Interior_corruption, leaves_the_boundary_bitwise_untouched)
{
  const Grid grid(6);
  for (const Corruption& corruption : interior_corruptions()) {
    Points points = grid.points;
    corruption.apply(points, grid.hexahedra, 1);
    EXPECT_NE(points, grid.points) << corruption.name;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (grid.is_boundary(v)) {
        EXPECT_EQ(points[v], grid.points[v]) << corruption.name;
      }
  }
}

TEST(Interior_corruption, is_determined_by_the_seed)
{
  const Grid grid(5);
  for (const Corruption& corruption : interior_corruptions()) {
    Points a = grid.points, b = grid.points, c = grid.points;
    corruption.apply(a, grid.hexahedra, 1);
    corruption.apply(b, grid.hexahedra, 1);
    corruption.apply(c, grid.hexahedra, 2);
    EXPECT_EQ(a, b) << corruption.name;
    EXPECT_NE(a, c) << corruption.name;
  }
}

TEST(Corruption_random, is_the_published_generator)
{
  // The first outputs of SplitMix64 for the seed 0, by its definition
  HMO::internal::Corruption_random random(0);
  EXPECT_EQ(random(), static_cast<double>(0xe220a8397b1dcdafu >> 11) * 0x1p-53);
  EXPECT_EQ(random(), static_cast<double>(0x6e789e6aa1b965f4u >> 11) * 0x1p-53);
}

TEST(Scramble_interior, inverts_nearly_everything_and_stays_in_the_bounding_box)
{
  Grid grid(10);
  const std::size_t n = grid.points.size();
  HMO::scramble_interior(grid.points, grid.hexahedra, 3);
  EXPECT_GT(fraction_inverted(grid.points, grid.hexahedra), .9);
  for (std::size_t v = 0; v < n; ++v)
    for (int d = 0; d < 3; ++d) {
      EXPECT_GE(grid.points[v][d], 0);
      EXPECT_LE(grid.points[v][d], grid.size);
    }
}

TEST(Scramble_interior, moves_by_the_amplitude_times_the_local_edge_length)
{
  const Grid grid(8);
  for (double amplitude : {.1, 1.}) {
    Points points = grid.points;
    HMO::scramble_interior(points, grid.hexahedra, 3, amplitude);
    double farthest = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
      farthest = (std::max)(farthest, std::sqrt(CGAL::squared_distance(points[v], grid.points[v])));
    EXPECT_LE(farthest, amplitude * (1 + 1e-12));
    EXPECT_GT(farthest, .9 * amplitude);
  }
  Points points = grid.points;
  HMO::scramble_interior(points, grid.hexahedra, 3, .1);
  EXPECT_EQ(fraction_inverted(points, grid.hexahedra), 0);
  points = grid.points;
  HMO::scramble_interior(points, grid.hexahedra, 3, 1);
  EXPECT_GT(fraction_inverted(points, grid.hexahedra), .5);
}

TEST(Rotate_hexahedra, turns_the_stated_fraction)
{
  const Grid grid(10);
  double last = 0;
  for (double fraction : {.01, .1, .3, 1.}) {
    Points points = grid.points;
    HMO::rotate_hexahedra(points, grid.hexahedra, 4, fraction);
    const double inverted = fraction_inverted(points, grid.hexahedra);
    EXPECT_GT(inverted, last);
    last = inverted;
  }
  EXPECT_GT(last, .7);

  Points points = grid.points;
  HMO::rotate_hexahedra(points, grid.hexahedra, 4, 0);
  EXPECT_EQ(points, grid.points);
}

TEST(Rotate_hexahedra, keeps_the_shape_of_a_hexahedron_turned_alone)
{
  const Grid grid(5);
  Points points = grid.points;
  HMO::rotate_hexahedra(points, grid.hexahedra, 5, 1. / 125);
  std::vector<std::size_t> moved;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (points[v] != grid.points[v])
      moved.push_back(v);
  ASSERT_FALSE(moved.empty());
  ASSERT_LE(moved.size(), 8u);
  for (std::size_t v : moved)
    for (std::size_t w : moved)
      EXPECT_NEAR(CGAL::squared_distance(points[v], points[w]), CGAL::squared_distance(grid.points[v], grid.points[w]),
                  1e-12);
}

TEST(Jitter_boundary, slides_within_planes_and_keeps_edges_corners_and_the_interior)
{
  const Grid grid(6);
  Points points = grid.points;
  HMO::jitter_boundary(points, grid.hexahedra, 6, .2);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    int planes = 0;
    for (int d = 0; d < 3; ++d)
      if (grid.points[v][d] == 0 || grid.points[v][d] == grid.size) {
        ++planes;
        EXPECT_NEAR(points[v][d], grid.points[v][d], 1e-12);
      }
    if (planes != 1) {
      EXPECT_EQ(points[v], grid.points[v]);
    }
    else if (points[v] != grid.points[v])
      ++moved;
  }
  EXPECT_EQ(moved, 6u * 5u * 5u);
  EXPECT_EQ(fraction_inverted(points, grid.hexahedra), 0);

  Points again = grid.points, other = grid.points;
  HMO::jitter_boundary(again, grid.hexahedra, 6, .2);
  HMO::jitter_boundary(other, grid.hexahedra, 7, .2);
  EXPECT_EQ(points, again);
  EXPECT_NE(points, other);
}

TEST(Displace_vertex, moves_the_returned_interior_vertex_only_and_by_the_stated_length)
{
  const Grid grid(6);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Points points = grid.points;
    const std::size_t displaced = HMO::displace_vertex(points, grid.hexahedra, seed, 4);
    EXPECT_FALSE(grid.is_boundary(displaced));
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(points[displaced], grid.points[displaced])), 4, 1e-12);
    points[displaced] = grid.points[displaced];
    EXPECT_EQ(points, grid.points);
  }
}

TEST(Displace_vertex, refuses_a_mesh_without_interior)
{
  Grid grid(1);
  EXPECT_THROW(HMO::displace_vertex(grid.points, grid.hexahedra, 1), HMO::Input_error);
}

TEST(Corruption, accepts_indices_of_another_type_and_unused_vertices)
{
  Grid grid(3);
  std::vector<std::vector<int>> hexahedra;
  for (const auto& hexahedron : grid.hexahedra)
    hexahedra.emplace_back(hexahedron.begin(), hexahedron.end());
  const Points original = grid.points;
  Points points = original;
  points.push_back(Point(1, 2, 3));
  HMO::scramble_interior(points, hexahedra, 1);
  HMO::rotate_hexahedra(points, hexahedra, 1, 1);
  HMO::jitter_boundary(points, hexahedra, 1, .3);
  EXPECT_EQ(points.back(), Point(1, 2, 3));
  EXPECT_LT(HMO::displace_vertex(points, hexahedra, 1), original.size());
}

} // namespace
