// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that are tied in pairs, in chains of pairs and not at all.

#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Ties, of_nothing_leave_all_as_it_is)
{
  for (const Ties& ties : {Ties(), Ties(3, {})}) {
    EXPECT_TRUE(ties.is_empty());
    EXPECT_EQ(ties.leader(2), 2);
    std::vector<double> values = {1, 2, 3};
    ties.average(values);
    ties.follow(values);
    EXPECT_EQ(values, (std::vector<double>{1, 2, 3}));
  }
}

TEST(Ties, hold_together_what_pairs_connect)
{
  const Ties ties(8, {{{6, 2}}, {{1, 5}}, {{2, 4}}, {{4, 6}}, {{7, 7}}});
  EXPECT_EQ(ties.groups(), (std::vector<std::vector<int>>{{2, 4, 6}, {1, 5}}));
  std::vector<int> leaders;
  for (int v = 0; v < 8; ++v)
    leaders.push_back(ties.leader(v));
  EXPECT_EQ(leaders, (std::vector<int>{0, 1, 2, 3, 2, 1, 2, 7}));
  std::vector<double> values = {0, 1, 2, 3, 4, 5, 9, 7}, means = values;
  ties.follow(values);
  EXPECT_EQ(values, (std::vector<double>{0, 1, 2, 3, 2, 1, 2, 7}));
  ties.average(means);
  EXPECT_EQ(means, (std::vector<double>{0, 3, 5, 3, 5, 3, 5, 7}));
  std::vector<char> marks = {0, 0, 0, 1, 1, 0, 0, 0};
  ties.unite(marks);
  EXPECT_EQ(marks, (std::vector<char>{0, 0, 1, 1, 1, 0, 1, 0}));
}

} // namespace
