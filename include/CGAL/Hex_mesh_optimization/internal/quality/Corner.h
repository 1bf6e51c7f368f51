// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_CORNER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_CORNER_H

// The corners of a hexahedron: the edges that leave them and their scaled
// Jacobians.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

struct Corner
{
  double determinant; // of the three edge vectors that leave it
  double scaled_jacobian;

  Corner(const Vector_3& a, const Vector_3& b, const Vector_3& c)
    : determinant(a.dot(b.cross(c)))
    , scaled_jacobian(determinant / std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm()))
  {}
};

// x: the eight vertices of a hexahedron.
inline Corner corner_at(const Vector_3* x, int i)
{
  return Corner(x[corner_neighbors[i][0]] - x[i], x[corner_neighbors[i][1]] - x[i], x[corner_neighbors[i][2]] - x[i]);
}

inline std::array<Vector_3, 8> hexahedron_corners(const Positions& points, const Hexahedron& h)
{
  std::array<Vector_3, 8> x;
  for (int i = 0; i < 8; ++i)
    x[i] = points[h[i]];
  return x;
}

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_CORNER_H
