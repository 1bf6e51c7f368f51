// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangles on each edge, against a search of all triangles.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Triangle_adjacency, has_all_sides_of_every_edge)
{
  std::mt19937 random(1);
  std::vector<Triangle_indices> triangles; // any, so that edges have one to many of them
  while (triangles.size() < 40) {
    const int a = random() % 9, b = random() % 9, c = random() % 9;
    if (a != b && b != c && c != a)
      triangles.push_back({a, b, c});
  }
  const Triangle_adjacency adjacency(triangles);

  std::set<std::array<int, 2>> seen;
  std::array<int, 2> last = {-1, -1};
  std::size_t number_of_sides = 0;
  adjacency.for_each_edge([&](const Triangle_adjacency::Sides& sides) {
    ASSERT_GT(sides.size(), 0u);
    const std::array<int, 2> edge = sides[0].edge;
    EXPECT_LT(last, edge);
    last = edge;
    seen.insert(edge);
    number_of_sides += sides.size();
    int before = -1;
    for (const auto& side : sides) {
      EXPECT_EQ(side.edge, edge);
      EXPECT_GT(side.triangle, before);
      before = side.triangle;
      const Triangle_indices& t = triangles[side.triangle];
      EXPECT_EQ(Triangle_adjacency::ordered({t[side.corner], t[(side.corner + 1) % 3]}), edge);
    }
  });
  EXPECT_EQ(number_of_sides, 3 * triangles.size());

  for (int a = 0; a < 9; ++a)
    for (int b = 0; b < 9; ++b) {
      const auto has = [](const Triangle_indices& t, int v) { return std::find(t.begin(), t.end(), v) != t.end(); };
      const auto expected = a == b ? 0
                                   : std::count_if(triangles.begin(), triangles.end(),
                                                   [&](const Triangle_indices& t) { return has(t, a) && has(t, b); });
      EXPECT_EQ(adjacency.sides({a, b}).size(), std::size_t(expected));
      EXPECT_EQ(seen.count(Triangle_adjacency::ordered({a, b})), std::size_t(expected > 0));
    }
}

TEST(Triangle_adjacency, of_no_triangles_has_no_edges)
{
  const Triangle_adjacency adjacency({});
  adjacency.for_each_edge([](const Triangle_adjacency::Sides&) { ADD_FAILURE(); });
  EXPECT_EQ(adjacency.sides({0, 1}).size(), 0u);
}

} // namespace
