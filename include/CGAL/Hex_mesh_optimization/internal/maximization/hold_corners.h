// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_CORNERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_CORNERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A step of all vertices, shortened where it would ruin single corners: a line
// search sees sums only.

#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hold_back.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Halves the step at the vertices of hexahedra that have a scaled Jacobian below what is given for them after it, or
// that find_more(reached, is_ruined) finds as well, again and again, up to `rounds` times. retract(points) is what
// steps end with. O(rounds · hexahedra).
template <class Retract, class Find_more>
void hold_corners(const Hexahedral_complex& complex, const Hexahedron_batches& batches, const Positions& points,
                  const Batched_values<1>& least, int rounds, Last_resort last_resort, const Retract& retract,
                  const Find_more& find_more, Positions& step)
{
  Positions reached(points.size()), at(points.size());
  for_each(points.size(), [&](std::size_t v) { reached[v] = points[v] + step[v]; });
  const std::vector<double> share = hold_back(
    complex, points, step, rounds, last_resort,
    [&](const Positions& ends, std::vector<char>& is_ruined) {
      at = ends;
      retract(at);
      batches.for_each([&](std::size_t i) {
        const Hexahedron_frame<Lanes> frame = batches.frame(i, at);
        Lanes lowest = Corner_frame<Lanes>(frame, 0).scaled_jacobian;
        for (int c = 1; c < 8; ++c)
          lowest = smaller(Corner_frame<Lanes>(frame, c).scaled_jacobian, lowest);
        for (int l = 0; l < batches.number_of_hexahedra(i); ++l)
          is_ruined[batches.first_hexahedron(i) + l] = !(lane(lowest, l) >= lane(*least.batch(i), l));
      });
      find_more(at, is_ruined);
    },
    reached);
  for (std::size_t v = 0; v < step.size(); ++v)
    step[v] *= share[v];
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_HOLD_CORNERS_H
