// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSERT_LAYERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSERT_LAYERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Layers of hexahedra between faces and the hexahedra behind them: what is called padding where the faces are those of
// the boundary, and pillowing where they enclose a set of hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The label of the face of the boundary that is reached from a marked side around its edge from a to b, through hexahedra
// that no marked side divides.
inline int label_beside(const Hexahedra& mesh, const std::vector<std::ptrdiff_t>& opposite,
                        const std::vector<char>& is_marked, std::size_t side, int a, int b)
{
  for (;;) {
    const std::size_t next = side_beside(mesh, side, a, b);
    if (is_marked[next])
      return Hexahedra::no_label;
    if (opposite[next] < 0)
      return mesh.label[next];
    side = static_cast<std::size_t>(opposite[next]);
    if (is_marked[side])
      return Hexahedra::no_label;
  }
}

// A hexahedron is inserted between each face that is marked and the hexahedron at that side of it. `is_marked` has an
// entry for each side; with two hexahedra at a face, one side or both may be. A vertex of marked faces keeps its place,
// and gets a copy for each set of hexahedra around it that hang together by faces none of whose sides is marked; the copy
// stands `thickness` edges behind the marked faces, as nearly as several can be obeyed. Old vertices keep their numbers,
// old hexahedra too; new ones are appended, one for each marked side in increasing order, with the face first.
//
// mesh.label of a new face of the boundary is that of the face that it continues. Returns the old vertex of each new one.
// O(n log n).
inline std::vector<int> insert_layers(Hexahedra& mesh, const std::vector<std::ptrdiff_t>& opposite,
                                      const std::vector<char>& is_marked, double thickness)
{
  const std::size_t number_of_old = mesh.hexahedra.size();
  // The sets of corners, numbered 8h + c, that share a vertex and are not divided.
  Disjoint_sets sets(8 * number_of_old);
  for (std::size_t side = 0; side < opposite.size(); ++side) {
    if (opposite[side] < static_cast<std::ptrdiff_t>(side) || is_marked[side] || is_marked[opposite[side]])
      continue;
    const Hexahedron &h = mesh.hexahedra[side / 6], &g = mesh.hexahedra[opposite[side] / 6];
    for (int c : hexahedron_faces[side % 6])
      for (int d : hexahedron_faces[opposite[side] % 6])
        if (h[c] == g[d])
          sets.unite(8 * (side / 6) + c, 8 * (opposite[side] / 6) + d);
  }

  struct Planes // behind which a copy stands
  {
    Matrix_3 normals = Matrix_3::Zero();
    Vector_3 offsets = Vector_3::Zero();
    double weight = 0;
  };
  std::vector<int> copy_of_set(8 * number_of_old, -1);
  std::vector<Planes> planes;
  std::vector<int> original;
  for (std::size_t side = 0; side < opposite.size(); ++side) {
    if (!is_marked[side])
      continue;
    const std::array<int, 4> q = mesh.face(side);
    const std::array<Vector_3, 4> p = {mesh.points[q[0]], mesh.points[q[1]], mesh.points[q[2]], mesh.points[q[3]]};
    for (int k = 0; k < 4; ++k) {
      const std::size_t set = sets.find(8 * (side / 6) + hexahedron_faces[side % 6][k]);
      if (copy_of_set[set] < 0) {
        copy_of_set[set] = static_cast<int>(planes.size());
        planes.emplace_back();
        original.push_back(q[k]);
      }
      const Vector_3 after = p[(k + 1) % 4] - p[k], before = p[(k + 3) % 4] - p[k];
      const Vector_3 normal = after.cross(before).normalized(); // outwards; zero where the face has none
      Planes& of_copy = planes[copy_of_set[set]];
      of_copy.normals += normal * normal.transpose();
      of_copy.offsets -= normal * (thickness * (after.norm() + before.norm()) / 2);
      of_copy.weight += 1;
    }
  }

  const int first_new = static_cast<int>(mesh.points.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    constexpr double indifference = 1e-3; // to directions that no plane determines: they are not gone
    const Matrix_3 system = planes[i].normals + indifference * planes[i].weight * Matrix_3::Identity();
    mesh.points.push_back(mesh.points[original[i]] + system.inverse() * planes[i].offsets);
  }
  const auto copy = [&](std::size_t h, int c) {
    const int number = copy_of_set[sets.find(8 * h + c)];
    return number < 0 ? mesh.hexahedra[h][c] : first_new + number;
  };
  std::vector<Hexahedron> inserted;
  std::vector<int> labels = mesh.label;
  for (std::size_t side = 0; side < opposite.size(); ++side) {
    if (!is_marked[side])
      continue;
    const std::array<int, 4> q = mesh.face(side);
    Hexahedron hexahedron;
    for (int k = 0; k < 4; ++k) { // seen from inside, its bottom runs counter-clockwise
      hexahedron[k] = q[3 - k];
      hexahedron[4 + k] = copy(side / 6, hexahedron_faces[side % 6][3 - k]);
    }
    inserted.push_back(hexahedron);
    labels[side] = Hexahedra::no_label;
    labels.push_back(mesh.label[side]);
    labels.push_back(Hexahedra::no_label);
    for (int k = 0; k < 4; ++k) // the face over edge k of the bottom
      labels.push_back(label_beside(mesh, opposite, is_marked, side, q[3 - k], q[(6 - k) % 4]));
  }
  mesh.label = std::move(labels);
  std::vector<Hexahedron> moved = mesh.hexahedra;
  for (std::size_t h = 0; h < number_of_old; ++h)
    for (int c = 0; c < 8; ++c)
      moved[h][c] = copy(h, c);
  mesh.hexahedra = std::move(moved);
  mesh.hexahedra.insert(mesh.hexahedra.end(), inserted.begin(), inserted.end());
  return original;
}

// Around all of the boundary.
inline std::vector<int> pad_boundary(Hexahedra& mesh, double thickness)
{
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  std::vector<char> is_boundary(opposite.size());
  for (std::size_t side = 0; side < opposite.size(); ++side)
    is_boundary[side] = opposite[side] < 0;
  return insert_layers(mesh, opposite, is_boundary, thickness);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_INSERT_LAYERS_H
