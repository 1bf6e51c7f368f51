// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SMOOTH_NORMALS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SMOOTH_NORMALS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Normals of a triangle surface that are continuous but for some edges: those of its
// feature curves.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Averages over the triangles around each vertex, weighted by their angles, but not across the barriers. A point on an
// edge or a vertex then has one normal, whichever of the triangles around it a search returns.
class Smooth_normals
{
public:
  // barriers: sorted, the smaller index first. The surface must outlive the object.
  explicit Smooth_normals(const Triangle_surface& surface, const Edge_list& barriers = {})
    : surface_(surface)
    , normals_(3 * surface.triangles.size())
  {
    Disjoint_sets group(normals_.size()); // of the corners of triangles
    Triangle_adjacency(surface.triangles).for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      if (sides.size() > 1 && !std::binary_search(barriers.begin(), barriers.end(), sides[0].edge))
        for (std::size_t i = 1; i < sides.size(); ++i)
          unite_ends(sides[i - 1], sides[i], group);
    });
    Positions sums(normals_.size(), Vector_3::Zero());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Vector_3 normal = area_vector(t);
      if (!(normal.norm() > 0))
        continue;
      for (int k = 0; k < 3; ++k) {
        const Vector_3 &p = surface.corner(t, k), a = surface.corner(t, (k + 1) % 3) - p,
                       b = surface.corner(t, (k + 2) % 3) - p;
        sums[group.find(3 * t + k)] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal.normalized();
      }
    }
    for (std::size_t c = 0; c < normals_.size(); ++c)
      normals_[c] = sums[group.find(c)].normalized(); // stays zero where the normals cancel
  }

  // At a point of a triangle that is not degenerate, given by barycentric coordinates; unit length, outwards.
  Vector_3 at(std::size_t triangle, const std::array<double, 3>& coordinates) const
  {
    Vector_3 sum = Vector_3::Zero();
    for (int k = 0; k < 3; ++k)
      sum += coordinates[k] * normals_[3 * triangle + k];
    const double length = sum.norm();
    if (length > 1e-6)
      return sum / length;
    return area_vector(triangle).normalized();
  }

private:
  Vector_3 area_vector(std::size_t t) const
  {
    return (surface_.corner(t, 1) - surface_.corner(t, 0)).cross(surface_.corner(t, 2) - surface_.corner(t, 0));
  }

  // The corners of two triangles at the ends of an edge that they share.
  void unite_ends(const Triangle_adjacency::Side& s, const Triangle_adjacency::Side& t, Disjoint_sets& group) const
  {
    const Triangle_indices &of_s = surface_.triangles[s.triangle], &of_t = surface_.triangles[t.triangle];
    for (int end = 0; end < 2; ++end) {
      const int c = (s.corner + end) % 3;
      for (int k = 0; k < 3; ++k)
        if (of_t[k] == of_s[c])
          group.unite(3 * t.triangle + k, 3 * s.triangle + c);
    }
  }

  const Triangle_surface& surface_;
  Positions normals_; // at the corners of triangles
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SMOOTH_NORMALS_H
