// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What belongs to each group, in order.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Grouped_array, keeps_the_order_within_groups)
{
  const int group[] = {2, 0, 2, 3, 0, 2}, value[] = {5, 6, 7, 8, 9, 4};
  const Grouped_array array(
    5, 6, [&](std::size_t i) { return group[i]; }, [&](std::size_t i) { return value[i]; });
  ASSERT_EQ(array.size(), 5u);
  const std::vector<std::vector<int>> expected = {{6, 9}, {}, {5, 7, 4}, {8}, {}};
  for (std::size_t g = 0; g < 5; ++g)
    EXPECT_EQ(std::vector<int>(array[g].begin(), array[g].end()), expected[g]) << g;
  EXPECT_EQ(Grouped_array().size(), 0u);
}

} // namespace
