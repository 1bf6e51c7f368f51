// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_SURFACE_H

// Closed triangle surfaces: the boundaries of generated meshes, turned out of the axes on request, as flat arrays and as
// surface meshes.

#include "Generated_mesh.h"

#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <vector>

namespace test {

using Surface_point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Surface_point_3>;

// turn: about an axis that is none of the coordinate axes, in radians
inline Reference_input surface_of(const Generated_mesh& mesh, double turn = 0)
{
  Reference_input result;
  std::vector<int> number(mesh.points.size(), -1);
  const Matrix_3 rotation = Eigen::AngleAxisd(turn, Vector_3(1, 2, 3).normalized()).toRotationMatrix();
  for (Triangle_indices t : boundary_triangles(mesh.complex)) {
    for (int& v : t) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(result.points.size());
        result.points.push_back(rotation * mesh.points[v]);
      }
      v = number[v];
    }
    result.triangles.push_back(t);
  }
  return result;
}

inline Surface surface_mesh(const Reference_input& surface)
{
  Surface result;
  for (const Vector_3& p : surface.points)
    result.add_vertex(Surface_point_3(p[0], p[1], p[2]));
  const auto vertex = [](int v) { return Surface::Vertex_index(static_cast<Surface::size_type>(v)); };
  for (const Triangle_indices& t : surface.triangles)
    result.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return result;
}

} // namespace test

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_SURFACE_H
