// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Elements that share a vertex are never visited at the same time, nor in another order.

#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <set>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

TEST(Conflict_free_ranges, visit_every_element_once_and_neighbors_in_turn)
{
  const Block block(20, 20, 20);
  for (std::size_t size_of_range : {1, 7, 64, 100000}) {
    const Conflict_free_ranges ranges(block.hexahedra.size(), block.points.size(), size_of_range,
                                      [&](std::size_t h) -> const Hexahedron& { return block.hexahedra[h]; });
    EXPECT_GE(ranges.number_of_colors(), size_of_range < 8000 ? 2u : 1u);
    for (bool backwards : {false, true}) {
      std::vector<int> visits(block.hexahedra.size(), 0), users(block.points.size(), 0);
      std::vector<std::size_t> last_color(block.points.size(), backwards ? 1000 : 0); // that came to each vertex
      std::mutex mutex;
      bool is_conflict = false, is_in_order = true;
      const auto work = [&](std::size_t begin, std::size_t end) {
        ASSERT_LE(end - begin, size_of_range);
        const auto use = [&](int change) {
          const std::lock_guard<std::mutex> lock(mutex);
          std::set<int> vertices;
          for (std::size_t h = begin; h < end; ++h)
            vertices.insert(block.hexahedra[h].begin(), block.hexahedra[h].end());
          for (int v : vertices) {
            is_conflict = (users[v] += change) > 1 || is_conflict;
            const std::size_t color = ranges.color(begin), last = std::exchange(last_color[v], color);
            is_in_order = is_in_order && (backwards ? color <= last : color >= last);
          }
        };
        use(1);
        for (std::size_t h = begin; h < end; ++h)
          ++visits[h];
        use(-1);
      };
      if (backwards)
        ranges.for_ranges_backwards(work);
      else
        ranges.for_ranges(work);
      EXPECT_FALSE(is_conflict);
      EXPECT_TRUE(is_in_order);
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<long>(visits.size()));
    }
  }
}

} // namespace
