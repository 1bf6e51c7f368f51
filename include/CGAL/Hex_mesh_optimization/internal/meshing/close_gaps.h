// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CLOSE_GAPS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CLOSE_GAPS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where two parts have a curved surface in common that each divides into triangles of its own, slivers of gaps and of
// overlaps are between them. If the first one goes a little into the second, or behind its surface, the second one's
// surface is that of both. A gap, or an overlap, that is about as wide everywhere is meant.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Moves vertices of `triangles` that are within the distance `nearly` of the surface, by no more than that; with
// copies, as others may have the same ones. wins: where both parts are, that of the triangles is. Nothing where all
// that is as near touches but for `rounding`. Returns how many were moved.
inline std::size_t close_gaps(Positions& points, std::vector<Triangle_indices>& triangles,
                              const Triangle_surface& surface, bool wins, double nearly, double rounding)
{
  const auto distance = [&](const Vector_3& p) { return (surface.closest_point(p).point - p).norm(); };
  const auto normal = [](const Vector_3& a, const Vector_3& b, const Vector_3& c) {
    return Vector_3((b - a).cross(c - a).normalized());
  };
  std::vector<int> side(triangles.size(), 0); // 1: to go outwards, into the other part or around it; -1: inwards
  double gap = 0;                             // the widest, and the deepest overlap
  double least = std::numeric_limits<double>::infinity(); // the narrowest
  std::vector<double> of_vertex(points.size(), -1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle_indices& v = triangles[t];
    double farthest = 0;
    for (int w : v) {
      if (of_vertex[w] < 0)
        of_vertex[w] = distance(points[w]);
      farthest = (std::max)(farthest, of_vertex[w]);
    }
    if (farthest > nearly)
      continue;
    const Vector_3 &a = points[v[0]], &b = points[v[1]], &c = points[v[2]];
    for (const Vector_3& middle : {Vector_3((a + b) / 2), Vector_3((b + c) / 2), Vector_3((c + a) / 2)})
      farthest = (std::max)(farthest, distance(middle));
    const Vector_3 center = (a + b + c) / 3;
    const Surface_point foot = surface.closest_point(center);
    farthest = (std::max)(farthest, (foot.point - center).norm());
    const double along = normal(a, b, c).dot(
      normal(surface.corner(foot.triangle, 0), surface.corner(foot.triangle, 1), surface.corner(foot.triangle, 2)));
    constexpr double parallel = .8;
    if (farthest > nearly || std::abs(along) < parallel)
      continue;
    side[t] = along < 0 || wins ? 1 : -1;
    gap = (std::max)(gap, farthest);
    for (int w : v)
      least = (std::min)(least, of_vertex[w]);
    least = (std::min)(least, (foot.point - center).norm());
  }
  constexpr double even = .5; // the narrowest over the widest
  if (gap <= rounding || least > even * gap)
    return 0;
  const double depth = (std::min)(nearly, 2 * gap); // where neither has a vertex, both are off

  // along the normals of the faces that are to go, within the planes of others
  struct Planes
  {
    Matrix_3 normals = Matrix_3::Zero();
    Vector_3 offsets = Vector_3::Zero();
    bool moves = false;
  };
  std::map<int, Planes> planes;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle_indices& v = triangles[t];
    const Vector_3 n = normal(points[v[0]], points[v[1]], points[v[2]]);
    constexpr double keeps_plane = 100; // weight
    for (int w : v) {
      Planes& of = planes[w];
      of.normals += (side[t] == 0 ? keeps_plane : 1) * n * n.transpose();
      of.offsets += side[t] * depth * n;
      of.moves = of.moves || side[t] != 0;
    }
  }
  std::map<int, int> moved;
  for (const auto& [v, of] : planes)
    if (of.moves) {
      constexpr double indifference = 1e-3; // to directions that no plane determines
      const Vector_3 step = (of.normals + indifference * Matrix_3::Identity()).inverse() * of.offsets;
      moved.emplace(v, static_cast<int>(points.size()));
      points.push_back(points[v] + step);
    }
  for (Triangle_indices& t : triangles)
    for (int& v : t) {
      const auto found = moved.find(v);
      if (found != moved.end())
        v = found->second;
    }
  return moved.size();
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CLOSE_GAPS_H
