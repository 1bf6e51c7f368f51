// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The order in memory brings neighbors together, and everything back to where it was.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

TEST(Memory_order, brings_neighbors_together_and_back)
{
  const Block block(6, 5, 4);
  std::mt19937 random(1);
  std::vector<int> shuffled(block.points.size());
  for (std::size_t v = 0; v < shuffled.size(); ++v)
    shuffled[v] = static_cast<int>(v);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  Hexahedra hexahedra = block.hexahedra;
  for (Hexahedron& h : hexahedra)
    for (int& v : h)
      v = shuffled[v];
  std::shuffle(hexahedra.begin(), hexahedra.end(), random);
  const std::size_t n = block.points.size() + 3; // the last three are not used
  const Memory_order order(Hexahedral_complex(n, hexahedra));

  std::vector<int> given(n);
  for (std::size_t v = 0; v < n; ++v)
    given[v] = static_cast<int>(v);
  const std::vector<int> ordered = order.ordered(given);
  EXPECT_EQ(std::set<int>(ordered.begin(), ordered.end()).size(), n);
  EXPECT_EQ(order.as_given(ordered), given);
  for (std::size_t v = 0; v < n; ++v)
    EXPECT_EQ(order.given_vertex(v), ordered[v]);
  for (int k = 1; k <= 3; ++k)
    EXPECT_GE(ordered[n - k], static_cast<int>(block.points.size()));

  const Hexahedra cells = order.ordered(hexahedra);
  std::set<int> seen;
  int widest = 0;
  for (std::size_t h = 0; h < cells.size(); ++h) {
    seen.insert(order.given_hexahedron(h));
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(ordered[cells[h][i]], hexahedra[order.given_hexahedron(h)][i]);
    const auto [low, high] = std::minmax_element(cells[h].begin(), cells[h].end());
    widest = (std::max)(widest, *high - *low);
    if (h > 0) {
      EXPECT_LE(*std::min_element(cells[h - 1].begin(), cells[h - 1].end()), *low);
    }
  }
  EXPECT_EQ(seen.size(), cells.size());
  EXPECT_LT(widest, 3 * 6 * 5) << "three layers of vertices";
  EXPECT_TRUE(order.ordered(std::vector<char>()).empty());
}

} // namespace
