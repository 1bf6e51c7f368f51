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

TEST(Hold_back, halves_until_nothing_is_ruined_or_the_rounds_are_over)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions before = positions(mesh), step(before.size(), Vector_3(1, 0, 0));
  const Hexahedron& ruined = complex.hexahedra[0];
  for (double least : {1., .3, .1, 0.})
    for (bool ends_at_rest : {false, true}) {
      Positions reached = before;
      for (Vector_3& p : reached)
        p += Vector_3(1, 0, 0);
      const Positions full = reached;
      const std::vector<double> share = hold_back(
        complex, before, step, 5, ends_at_rest,
        [&](const Positions& at, std::vector<char>& is_ruined) {
          std::fill(is_ruined.begin(), is_ruined.end(), false);
          is_ruined[0] = (at[ruined[0]] - before[ruined[0]]).norm() > least + 1e-9;
        },
        reached);
      const double kept = least == 1                     ? 1
                          : least == .3                  ? .25
                          : least == .1 && !ends_at_rest ? .0625
                          : ends_at_rest                 ? 0
                                                         : 1 / 32.;
      for (std::size_t v = 0; v < before.size(); ++v) {
        const bool is_held = std::find(ruined.begin(), ruined.end(), static_cast<int>(v)) != ruined.end() && least < 1;
        EXPECT_EQ(share[v], is_held ? kept : 1) << v;
        EXPECT_EQ(reached[v], is_held ? Vector_3(before[v] + share[v] * step[v]) : full[v]) << v;
      }
    }
}

} // namespace
