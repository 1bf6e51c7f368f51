// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_CORNER_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_CORNER_H

// The corners of a hexahedron one by one, as the definition has them: what the
// vectorized energy and the floors of corners are compared with.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <array>
#include <cmath>

struct Corner
{
  using Vector_3 = CGAL::Hex_mesh_optimization::internal::Vector_3;

  double determinant; // of the three edge vectors that leave it
  double scaled_jacobian;

  Corner(const Vector_3& a, const Vector_3& b, const Vector_3& c)
    : determinant(a.dot(b.cross(c)))
    , scaled_jacobian(determinant / std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm()))
  {}
};

// x: the eight vertices of a hexahedron.
inline Corner corner_at(const Corner::Vector_3* x, int i)
{
  const auto& next = CGAL::Hex_mesh_optimization::internal::corner_neighbors[i];
  return Corner(x[next[0]] - x[i], x[next[1]] - x[i], x[next[2]] - x[i]);
}

inline std::array<Corner::Vector_3, 8>
hexahedron_corners(const CGAL::Hex_mesh_optimization::internal::Positions& points,
                   const CGAL::Hex_mesh_optimization::internal::Hexahedron& h)
{
  std::array<Corner::Vector_3, 8> x;
  for (int i = 0; i < 8; ++i)
    x[i] = points[h[i]];
  return x;
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_CORNER_H
