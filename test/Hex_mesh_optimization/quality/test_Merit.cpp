// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The order of goals is an order, and that order.

#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

std::vector<Merit> merits()
{
  std::vector<Merit> result;
  for (std::size_t inverted : {0, 1, 5})
    for (std::size_t invalid : {0, 1, 7})
      for (double excess : {0., .1, 3.})
        for (std::size_t away : {0, 2})
          result.push_back({inverted, invalid, excess, away});
  return result;
}

bool are_equivalent(const Merit& a, const Merit& b) { return !(a < b) && !(b < a); }

TEST(Merit, is_a_strict_weak_order)
{
  const std::vector<Merit> all = merits();
  for (const Merit& a : all) {
    EXPECT_FALSE(a < a);
    for (const Merit& b : all) {
      EXPECT_FALSE(a < b && b < a);
      for (const Merit& c : all) {
        if (a < b && b < c) {
          EXPECT_TRUE(a < c);
        }
        if (are_equivalent(a, b) && are_equivalent(b, c)) {
          EXPECT_TRUE(are_equivalent(a, c));
        }
      }
    }
  }
}

TEST(Merit,
     counts_inverted_hexahedra_then_invalid_ones_then_the_excess_then_vertices_off_the_surface_then_off_features)
{
  EXPECT_TRUE((Merit{0, 9, 9, {}} < Merit{1, 1, 0, {}}));
  EXPECT_TRUE((Merit{1, 1, 9, {}} < Merit{1, 2, 0, {}}));
  EXPECT_TRUE((Merit{1, 2, .5, {9, 9}} < Merit{1, 2, .6, {}}));
  EXPECT_TRUE((Merit{1, 2, .5, {1, 8}} < Merit{1, 2, .5, {1, 9}}));
  EXPECT_TRUE((Merit{1, 2, .5, {1, 9}} < Merit{1, 2, .5, {2, 2}}));
  EXPECT_TRUE(are_equivalent({1, 2, .5, {2, 3}}, {1, 2, .5, {2, 3}}));
}

TEST(Merit, is_good_where_all_is_valid_and_in_place)
{
  for (const Merit& s : merits())
    EXPECT_EQ(s.is_good(), s.invalid == 0 && s.excess == 0 && s.away.in_all == 0);
}

} // namespace
