// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_VOLUME_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_VOLUME_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The volume of a hexahedron: the integral of the determinant of its trilinear map.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <cmath>

namespace CGAL::Hex_mesh_optimization::internal {

// Exact up to rounding, also where faces are warped: the determinant has degree 2 in each coordinate, and two points of
// Gauss are exact up to degree 3. Where the map folds, its parts count with their signs. corners[k]: of corner k.
inline double volume(const Vector_3 (&corners)[8])
{
  const double gauss[2] = {.5 - std::sqrt(1. / 12), .5 + std::sqrt(1. / 12)};
  double sum = 0;
  for (double u : gauss)
    for (double v : gauss)
      for (double w : gauss) {
        // a derivative weighs the four edges in its direction, which the table lists together
        const double at[3] = {u, v, w};
        Vector_3 derivative[3] = {Vector_3::Zero(), Vector_3::Zero(), Vector_3::Zero()};
        for (int e = 0; e < 12; ++e) {
          const int d = e / 4, start = hexahedron_edges[e][0], end = hexahedron_edges[e][1];
          const bool is_far[3] = {start % 4 == 1 || start % 4 == 2, start % 4 >= 2, start >= 4};
          double weight = 1;
          for (int other = 0; other < 3; ++other)
            if (other != d)
              weight *= is_far[other] ? at[other] : 1 - at[other];
          derivative[d] += weight * (corners[end] - corners[start]);
        }
        sum += derivative[0].dot(derivative[1].cross(derivative[2])) / 8;
      }
  return sum;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_VOLUME_H
