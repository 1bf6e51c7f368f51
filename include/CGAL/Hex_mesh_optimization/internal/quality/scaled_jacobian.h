// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_SCALED_JACOBIAN_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_SCALED_JACOBIAN_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The quality measures of one hexahedron: the scaled Jacobian, at its corners and
// at its center, and the edge ratio.

#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Hex_mesh_optimization::internal {

// The vector scaled to length 1. Zero vectors, and those that are not finite,
// become NaN, which spreads to every determinant they enter.
inline Coordinates<double> normalized(Coordinates<double> a)
{
  double squared_length = scalar_product(a, a);
  if (!(squared_length > 1e-280 && squared_length < 1e280)) {
    // the square may have over- or underflowed: bring the largest component to 1 first
    const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    for (double& x : a)
      x /= largest;
    squared_length = scalar_product(a, a);
  }
  const double length = std::sqrt(squared_length);
  return {{a[0] / length, a[1] / length, a[2] / length}};
}

// det(a, b, c) for unit vectors; -1 where one of them is undefined.
inline double scaled_determinant(const Coordinates<double>& a, const Coordinates<double>& b,
                                 const Coordinates<double>& c)
{
  const double d = scalar_product(cross_product(a, b), c);
  return d > -1 ? (std::min)(d, 1.) : -1.;
}

// In the order of i + 2 j + 4 k, with the sides that a corner is on along the three axes.
inline std::array<double, 8> scaled_jacobians_of_corners(const Hexahedron_coordinates& x)
{
  Edge_vectors<double> edges(x);
  for (auto* direction : {&edges.u, &edges.v, &edges.w})
    for (Coordinates<double>& e : *direction)
      e = normalized(e);
  std::array<double, 8> result;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        result[i + 2 * j + 4 * k] = scaled_determinant(edges.u[j + 2 * k], edges.v[i + 2 * k], edges.w[i + 2 * j]);
  return result;
}

inline double scaled_jacobian(const Hexahedron_coordinates& x)
{
  const std::array<double, 8> of_corners = scaled_jacobians_of_corners(x);
  return *std::min_element(of_corners.begin(), of_corners.end());
}

// The scaled determinant of the principal axes: the Jacobian at the center.
inline double center_scaled_jacobian(const Hexahedron_coordinates& x)
{
  const Edge_vectors<double> edges(x);
  auto principal_axis = [](const std::array<Coordinates<double>, 4>& e) {
    Coordinates<double> axis;
    for (int i = 0; i < 3; ++i)
      axis[i] = .25 * e[0][i] + .25 * e[1][i] + .25 * e[2][i] + .25 * e[3][i];
    return normalized(axis);
  };
  return scaled_determinant(principal_axis(edges.u), principal_axis(edges.v), principal_axis(edges.w));
}

inline double edge_ratio(const Hexahedron_coordinates& x)
{
  const Edge_vectors<double> edges(x);
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const auto* direction : {&edges.u, &edges.v, &edges.w})
    for (const Coordinates<double>& e : *direction) {
      const double length = std::hypot(e[0], e[1], e[2]);
      if (!(length > 0) || std::isinf(length))
        return std::numeric_limits<double>::infinity();
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
  return longest / shortest;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_SCALED_JACOBIAN_H
