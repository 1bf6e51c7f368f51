// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel and consecutive edges of meshes small enough to count by hand.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>

#include "../block_of_cubes.h"
#include "../hexahedron_rotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

std::set<std::pair<int, int>> vertex_pairs(const Hexahedral_complex& complex, const std::vector<Edge_pair>& pairs)
{
  // a pair as the sources of its edges, where the targets follow by the direction
  std::set<std::pair<int, int>> result;
  for (const Edge_pair& p : pairs) {
    EXPECT_EQ(p.first % 2, 0);
    const std::pair<int, int> sources = std::minmax(complex.source(p.first), complex.source(p.second));
    EXPECT_TRUE(result.insert(sources).second) << "twice: " << sources.first << " " << sources.second;
  }
  return result;
}

TEST(Edge_relations, of_two_hexahedra)
{
  const Hexahedral_complex complex = Block(2, 1, 1).complex();
  const Edge_relations relations(complex);

  // Across the two cubes one edge continues another four times
  EXPECT_EQ(vertex_pairs(complex, relations.consecutive),
            (std::set<std::pair<int, int>>{{0, 1}, {3, 4}, {6, 7}, {9, 10}}));
  for (const Edge_pair& p : relations.consecutive)
    EXPECT_EQ(complex.target(p.first), complex.source(p.second));

  // Along x: 6 pairs in either cube. Along y and z the shared face has one pair
  // in common: 2 · 6 − 1 each.
  EXPECT_EQ(relations.parallel.size(), 12u + 11u + 11u);
  std::set<std::pair<int, int>> expected[3];
  for (int i = 0; i < 2; ++i) {
    const int x[4] = {i, i + 3, i + 6, i + 9}, y[4] = {i, i + 1, i + 6, i + 7}, z[4] = {i, i + 1, i + 3, i + 4};
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        expected[0].emplace(std::minmax(x[a], x[b]));
        expected[1].emplace(std::minmax(y[a], y[b]));
        expected[2].emplace(std::minmax(z[a], z[b]));
      }
  }
  const int step[3] = {1, 3, 6};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Edge_pair> along;
    for (const Edge_pair& p : relations.parallel) {
      EXPECT_EQ(complex.target(p.first) - complex.source(p.first), complex.target(p.second) - complex.source(p.second));
      if (complex.target(p.first) - complex.source(p.first) == step[axis])
        along.push_back(p);
    }
    EXPECT_EQ(vertex_pairs(complex, along), expected[axis]) << axis;
  }

  const int e01 = complex.find_edge(0, 1) / 2, e14 = complex.find_edge(1, 4) / 2, e03 = complex.find_edge(0, 3) / 2;
  EXPECT_EQ(relations.parallel_degree[e01], 3);
  EXPECT_EQ(relations.consecutive_degree[e01], 1);
  EXPECT_EQ(relations.parallel_degree[e14], 5); // three in either cube, the one above counted once
  EXPECT_EQ(relations.consecutive_degree[e14], 0);
  EXPECT_EQ(relations.parallel_degree[e03], 3);
}

TEST(Edge_relations, of_eight_hexahedra)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  const Edge_relations relations(complex);
  // per axis: 9 lines of two edges; 2 layers of 9 edges in 4 squares: 20 pairs, 12 sides and 8 diagonals
  EXPECT_EQ(relations.consecutive.size(), 27u);
  EXPECT_EQ(relations.parallel.size(), 3u * 2 * 20);
  const int inner = complex.find_edge(block.vertex(0, 1, 1), block.vertex(1, 1, 1)) / 2;
  EXPECT_EQ(relations.parallel_degree[inner], 8);
  EXPECT_EQ(relations.consecutive_degree[inner], 1);
  const int corner = complex.find_edge(block.vertex(0, 0, 0), block.vertex(1, 0, 0)) / 2;
  EXPECT_EQ(relations.parallel_degree[corner], 3);
  const int side = complex.find_edge(block.vertex(0, 1, 0), block.vertex(1, 1, 0)) / 2;
  EXPECT_EQ(relations.parallel_degree[side], 5);
}

// Renumbering the corners of a cube must not change what resembles what
TEST(Edge_relations, do_not_depend_on_the_corner_a_hexahedron_starts_at)
{
  Block block(2, 1, 1);
  const Hexahedral_complex straight = block.complex();
  const Edge_relations expected(straight);
  const auto pairs_of = [](const std::vector<Edge_pair>& pairs) {
    std::set<std::pair<int, int>> result;
    for (const Edge_pair& p : pairs)
      result.emplace(p.first, p.second);
    EXPECT_EQ(result.size(), pairs.size());
    return result;
  };
  const Hexahedron h = block.hexahedra[1];
  const auto rotations = numberings(1);
  ASSERT_EQ(rotations.size(), 24u);
  for (const std::array<int, 8>& rotation : rotations) {
    for (int c = 0; c < 8; ++c)
      block.hexahedra[1][c] = h[rotation[c]];
    const Hexahedral_complex turned = block.complex();
    EXPECT_EQ(turned.edges, straight.edges);
    const Edge_relations relations(turned);
    EXPECT_EQ(pairs_of(relations.consecutive), pairs_of(expected.consecutive));
    EXPECT_EQ(pairs_of(relations.parallel), pairs_of(expected.parallel));
  }
}

// A ring of one sheet: every edge along it is parallel to none of itself
TEST(Edge_relations, of_a_closed_ring)
{
  Hexahedra hexahedra;
  const int n = 3;
  for (int i = 0; i < n; ++i) {
    const int a = 4 * i, b = 4 * ((i + 1) % n);
    hexahedra.push_back({a, a + 1, b + 1, b, a + 2, a + 3, b + 3, b + 2});
  }
  const Hexahedral_complex complex(12, hexahedra);
  const Edge_relations relations(complex);
  EXPECT_EQ(relations.consecutive.size(), 12u); // four edges around, each continued at either end
  for (const Edge_pair& p : relations.consecutive) {
    EXPECT_NE(p.first / 2, p.second / 2);
    EXPECT_TRUE(complex.target(p.first) == complex.source(p.second) ||
                complex.target(p.second) == complex.source(p.first));
  }
}

} // namespace
