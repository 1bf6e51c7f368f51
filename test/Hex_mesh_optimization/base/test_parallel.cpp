// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops reach every index once, and what they give does not depend on the number of threads.

#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Parallel, loops_reach_every_index_once)
{
  for (const std::size_t n : {0, 1, 7, 8, 9, 1000})
    for (const std::size_t grain : {1, 8, 5000}) {
      std::vector<int> visits(n, 0), visits_of_ranges(n, 0);
      for_each(
        n, [&](std::size_t i) { ++visits[i]; }, grain);
      for_ranges(
        n,
        [&](std::size_t begin, std::size_t end) {
          EXPECT_LE(end - begin, grain);
          for (std::size_t i = begin; i < end; ++i)
            ++visits_of_ranges[i];
        },
        grain);
      EXPECT_EQ(visits, std::vector<int>(n, 1));
      EXPECT_EQ(visits_of_ranges, std::vector<int>(n, 1));
    }
}

TEST(Parallel, results_come_in_the_order_of_their_ranges)
{
  const auto begins = results_of_ranges<std::size_t>(
    100, [](std::size_t begin, std::size_t) { return begin; }, 9);
  ASSERT_EQ(begins.size(), 12u);
  for (std::size_t i = 0; i < begins.size(); ++i)
    EXPECT_EQ(begins[i], 9 * i);
}

TEST(Parallel, sums_are_the_same_bit_for_bit_in_one_thread_and_in_several)
{
  std::mt19937 random(2);
  std::vector<double> numbers(100000);
  for (double& x : numbers)
    x = std::uniform_real_distribution<double>(-1, 1)(random);
  const auto sum = [&] {
    return sum_of_ranges(
      numbers.size(),
      [&](std::size_t begin, std::size_t end) {
        double result = 0;
        for (std::size_t i = begin; i < end; ++i)
          result += numbers[i];
        return result;
      },
      100);
  };
  double alone = 0, together = 0, exact = 0;
  run_concurrently(false, [&] { alone = sum(); });
  run_concurrently(true, [&] { together = sum(); });
  for (const double x : numbers)
    exact += x;
  EXPECT_EQ(alone, together);
  EXPECT_NEAR(alone, exact, 1e-9);
}

} // namespace
