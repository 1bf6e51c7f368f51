// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HEXAHEDRON_COORDINATES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HEXAHEDRON_COORDINATES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The double coordinates of one hexahedron and its twelve edge vectors, on
// which the quality measures and the validity certificate work.

#include <CGAL/number_utils.h>

#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <array>
#include <cstddef>
#include <iterator>

namespace CGAL::Hex_mesh_optimization::internal {

template <class NT>
using Coordinates = std::array<NT, 3>;

using Hexahedron_coordinates = std::array<Coordinates<double>, 8>;

template <class Point>
Coordinates<double> coordinates(const Point& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

template <class Point>
Hexahedron_coordinates hexahedron_coordinates(const Point& p0, const Point& p1, const Point& p2, const Point& p3,
                                              const Point& p4, const Point& p5, const Point& p6, const Point& p7)
{
  return {{coordinates(p0), coordinates(p1), coordinates(p2), coordinates(p3), coordinates(p4), coordinates(p5),
           coordinates(p6), coordinates(p7)}};
}

template <class PointRange>
Hexahedron_coordinates hexahedron_coordinates(const PointRange& p)
{
  return hexahedron_coordinates(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7]);
}

template <class PointRange, class Hexahedron>
Hexahedron_coordinates hexahedron_coordinates(const PointRange& points, const Hexahedron& hexahedron)
{
  Hexahedron_coordinates result;
  auto vertex = std::begin(hexahedron);
  for (Coordinates<double>& x : result) {
    x = coordinates(points[static_cast<std::size_t>(*vertex)]);
    ++vertex;
  }
  return result;
}

// Small, and called so often that compilers are to inline them: hence the word, which templates do not need.
template <class NT>
inline Coordinates<NT> difference(const Coordinates<NT>& a, const Coordinates<NT>& b)
{
  return {{NT(a[0] - b[0]), NT(a[1] - b[1]), NT(a[2] - b[2])}};
}

template <class NT>
inline Coordinates<NT> cross_product(const Coordinates<NT>& a, const Coordinates<NT>& b)
{
  return {{NT(a[1] * b[2] - a[2] * b[1]), NT(a[2] * b[0] - a[0] * b[2]), NT(a[0] * b[1] - a[1] * b[0])}};
}

template <class NT>
inline NT scalar_product(const Coordinates<NT>& a, const Coordinates<NT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The edges as vectors, grouped by parametric direction: four along u, four
// along v, four along w. The Jacobian matrix at the corner (i, j, k) of the unit
// cube has the columns u[j + 2 * k], v[i + 2 * k] and w[i + 2 * j].
template <class NT>
struct Edge_vectors
{
  std::array<Coordinates<NT>, 4> u, v, w;

  explicit Edge_vectors(const std::array<Coordinates<NT>, 8>& x)
  {
    // hexahedron_edges lists the edges along w around the bottom face
    constexpr int around[4] = {0, 1, 3, 2};
    for (int e = 0; e < 4; ++e) {
      u[e] = along(x, hexahedron_edges[e]);
      v[e] = along(x, hexahedron_edges[4 + e]);
      w[e] = along(x, hexahedron_edges[8 + around[e]]);
    }
  }

private:
  static Coordinates<NT> along(const std::array<Coordinates<NT>, 8>& x, const int (&edge)[2])
  {
    return difference(x[edge[1]], x[edge[0]]);
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_HEXAHEDRON_COORDINATES_H
