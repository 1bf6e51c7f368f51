// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HOLD_BACK_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HOLD_BACK_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A step of all vertices, shortened where it would ruin single hexahedra: what
// minimizes sums lets them collapse.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Whether steps that ruin hexahedra however often they are halved are taken back altogether.
enum class Last_resort {
  NONE,
  IN_LAST_TWO_ROUNDS, // which may leave some
  UNTIL_NONE_IS_RUINED
};

// Halves the step at the vertices of hexahedra that are ruined by it, again and again, up to `rounds` times.
// find_ruined(reached, is_ruined) tells for each hexahedron, and nothing of one whose vertices all stay where they are
// changes any more. reached comes in as the end of the full step and is moved back with it. Returns the part of the
// step that each vertex keeps. O(rounds · hexahedra), and as much again for each round in which more is taken back.
template <class Find_ruined>
std::vector<double> hold_back(const Hexahedral_complex& complex, const Positions& before, const Positions& step,
                              int rounds, Last_resort last_resort, const Find_ruined& find_ruined, Positions& reached)
{
  std::vector<double> share(step.size(), 1.0);
  std::vector<char> is_ruined(complex.hexahedra.size());
  for (int round = 0; round < rounds || last_resort == Last_resort::UNTIL_NONE_IS_RUINED; ++round) {
    find_ruined(reached, is_ruined);
    std::vector<char> is_held(step.size(), false);
    bool are_some_held = false;
    for (std::size_t h = 0; h < is_ruined.size(); ++h)
      if (is_ruined[h])
        for (int v : complex.hexahedra[h])
          is_held[v] = are_some_held = true;
    if (!are_some_held)
      break;
    complex.ties.unite(is_held);
    const int first_of_last = last_resort == Last_resort::IN_LAST_TWO_ROUNDS ? rounds - 2 : rounds;
    const bool is_last = last_resort != Last_resort::NONE && round >= first_of_last;
    are_some_held = false;
    for (std::size_t v = 0; v < step.size(); ++v)
      if (is_held[v] && share[v] > 0) {
        are_some_held = true;
        share[v] = is_last ? 0 : share[v] / 2;
        reached[v] = before[v] + share[v] * step[v];
      }
    if (!are_some_held)
      break;
  }
  return share;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HOLD_BACK_H
