// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which part of a step is kept where it ruins hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/quality/hold_back.h>

#include "../mesh_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Hold_back, halves_until_nothing_is_ruined_or_the_rounds_are_over_and_then_takes_back)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions before = positions(mesh), step(before.size(), Vector_3(1, 0, 0));
  const Hexahedron& ruined = complex.hexahedra[0];
  for (double least : {1., .3, .1, 0.})
    for (Last_resort last : {Last_resort::NONE, Last_resort::IN_LAST_TWO_ROUNDS, Last_resort::UNTIL_NONE_IS_RUINED}) {
      Positions reached = before;
      for (Vector_3& p : reached)
        p += Vector_3(1, 0, 0);
      const Positions full = reached;
      const std::vector<double> share = hold_back(
        complex, before, step, 5, last,
        [&](const Positions& at, std::vector<char>& is_ruined) {
          std::fill(is_ruined.begin(), is_ruined.end(), false);
          is_ruined[0] = (at[ruined[0]] - before[ruined[0]]).norm() > least + 1e-9;
        },
        reached);
      const double kept = least == 1                                               ? 1
                          : least == .3                                            ? .25
                          : least == .1 && last != Last_resort::IN_LAST_TWO_ROUNDS ? .0625
                          : last != Last_resort::NONE                              ? 0
                                                                                   : 1 / 32.;
      for (std::size_t v = 0; v < before.size(); ++v) {
        const bool is_held = std::find(ruined.begin(), ruined.end(), static_cast<int>(v)) != ruined.end() && least < 1;
        EXPECT_EQ(share[v], is_held ? kept : 1) << v;
        EXPECT_EQ(reached[v], is_held ? Vector_3(before[v] + share[v] * step[v]) : full[v]) << v;
      }
    }
}

// What stays where it is may ruin the next one: it goes on until none is left, and ends though one is ruined at rest.
TEST(Hold_back, takes_back_as_much_as_it_takes)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions before = positions(mesh), step(before.size(), Vector_3(1, 0, 0));
  Positions reached = before;
  for (Vector_3& p : reached)
    p += Vector_3(1, 0, 0);
  const std::vector<double> share = hold_back(
    complex, before, step, 2, Last_resort::UNTIL_NONE_IS_RUINED,
    [&](const Positions& at, std::vector<char>& is_ruined) {
      for (std::size_t h = 0; h < is_ruined.size(); ++h) {
        const auto [least, largest] = std::minmax_element(complex.hexahedra[h].begin(), complex.hexahedra[h].end(),
                                                          [&](int v, int w) {
                                                            return (at[v] - before[v]).norm() <
                                                                   (at[w] - before[w]).norm();
                                                          });
        is_ruined[h] = h == 0 || (at[*largest] - before[*largest]).norm() > (at[*least] - before[*least]).norm() + 1e-9;
      }
    },
    reached);
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_EQ(share[v], 0) << v;
    EXPECT_EQ(reached[v], before[v]) << v;
  }
}

} // namespace
