// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_BACK_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_BACK_H

// A step of all vertices, shortened where it would ruin single corners: a line
// search sees sums only.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// Halves the step at the vertices of hexahedra that have a scaled Jacobian below what is given for them after it, again
// and again, up to `rounds` times. O(rounds · hexahedra).
inline void hold_back(const Hexahedral_complex& complex, const Hexahedron_batches& batches, const Positions& points,
                      const Batched_values<1>& least, int rounds, Positions& step)
{
  std::vector<char> is_too_low(complex.hexahedra.size());
  Positions reached(points.size());
  for (int round = 0; round < rounds; ++round) {
    for_each(points.size(), [&](std::size_t v) { reached[v] = points[v] + step[v]; });
    batches.for_each([&](std::size_t i) {
      const Hexahedron_frame<Lanes> frame = batches.frame(i, reached);
      Lanes lowest = Corner_frame<Lanes>(frame, 0).scaled_jacobian;
      for (int c = 1; c < 8; ++c)
        lowest = smaller(Corner_frame<Lanes>(frame, c).scaled_jacobian, lowest);
      for (int l = 0; l < batches.number_of_hexahedra(i); ++l)
        is_too_low[batches.first_hexahedron(i) + l] = !(lane(lowest, l) >= lane(*least.batch(i), l));
    });
    std::vector<char> is_held_back(points.size(), false);
    bool are_some_held_back = false;
    for (std::size_t h = 0; h < is_too_low.size(); ++h)
      if (is_too_low[h]) {
        for (int v : complex.hexahedra[h])
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

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_BACK_H
