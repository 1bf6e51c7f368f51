// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Sets that grow together, against a list of who is with whom.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Disjoint_sets, are_known_by_their_least_number)
{
  const std::size_t n = 60;
  std::mt19937 random(1);
  Disjoint_sets sets(n);
  std::vector<std::size_t> least(n); // of the set of each number
  for (std::size_t i = 0; i < n; ++i)
    least[i] = i;
  for (int k = 0; k < 80; ++k) {
    const std::size_t i = random() % n, j = random() % n;
    sets.unite(i, j);
    const std::size_t from = (std::max)(least[i], least[j]), to = (std::min)(least[i], least[j]);
    std::replace(least.begin(), least.end(), from, to);
    for (std::size_t v = 0; v < n; ++v)
      ASSERT_EQ(sets.find(v), least[v]);
  }
}

} // namespace
