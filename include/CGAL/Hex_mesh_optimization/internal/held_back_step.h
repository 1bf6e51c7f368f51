// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HELD_BACK_STEP_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HELD_BACK_STEP_H

// A step of all vertices, shortened where it would ruin single corners: a line
// search sees sums only.

#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// Halves the step at the vertices of hexahedra that have a scaled Jacobian below least[h] after it, again and again, up
// to `rounds` times. O(rounds · hexahedra).
inline void hold_back(const Hexahedral_complex& complex, const Positions& points, const std::vector<double>& least, int rounds,
                      Positions& step)
{
  std::vector<char> is_held_back(points.size());
  for (int round = 0; round < rounds; ++round) {
    std::fill(is_held_back.begin(), is_held_back.end(), false);
    bool are_some_held_back = false;
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      const Hexahedron& hexahedron = complex.hexahedra[h];
      std::array<Vector_3, 8> x = hexahedron_corners(points, hexahedron);
      for (int i = 0; i < 8; ++i)
        x[i] += step[hexahedron[i]];
      bool is_too_low = false;
      for (int i = 0; i < 8 && !is_too_low; ++i)
        is_too_low = !(corner_at(x.data(), i).scaled_jacobian >= least[h]);
      if (!is_too_low)
        continue;
      for (int v : hexahedron)
        is_held_back[v] = true;
      are_some_held_back = true;
    }
    if (!are_some_held_back)
      return;
    for (std::size_t v = 0; v < step.size(); ++v)
      if (is_held_back[v])
        step[v] /= 2;
  }
}

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_HELD_BACK_STEP_H
