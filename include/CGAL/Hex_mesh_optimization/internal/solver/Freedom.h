// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_FREEDOM_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_FREEDOM_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The directions in which a point may move: those that it may not are eliminated
// from linear systems, not made expensive.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <Eigen/LU>

#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Freedom
{
public:
  static Freedom everywhere() { return {3, Vector_3::Zero()}; }
  static Freedom nowhere() { return {0, Vector_3::Zero()}; }
  // direction and normal: of length 1; without one (zero) there is no such line, and no such plane.
  static Freedom along_line(const Vector_3& direction) { return {direction.isZero(0) ? 0 : 1, direction}; }
  static Freedom along_plane(const Vector_3& normal) { return {normal.isZero(0) ? 3 : 2, normal}; }

  int dimension() const { return dimension_; }

  // With the columns of T a basis of the directions: T (Tᵀ D T)⁻¹ Tᵀ, for a symmetric positive definite D.
  Matrix_3 inverse(const Matrix_3& D) const
  {
    switch (dimension_) {
    case 1:
      return axis_ * axis_.transpose() / axis_.dot(D * axis_);
    case 2: {
      Eigen::Matrix<double, 3, 2> T;
      T.col(0) = axis_.unitOrthogonal();
      T.col(1) = axis_.cross(T.col(0));
      return T * (T.transpose() * D * T).inverse() * T.transpose();
    }
    case 3:
      return D.inverse();
    default:
      return Matrix_3::Zero();
    }
  }

private:
  Freedom(int dimension, const Vector_3& axis) : dimension_(dimension), axis_(axis) {}

  int dimension_;
  Vector_3 axis_; // the line, or the normal of the plane
};

using Freedoms = std::vector<Freedom>; // of all points

inline Freedoms all_but(const std::vector<char>& is_fixed)
{
  Freedoms result;
  result.reserve(is_fixed.size());
  for (char fixed : is_fixed)
    result.push_back(fixed ? Freedom::nowhere() : Freedom::everywhere());
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SOLVER_FREEDOM_H
