// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SHARP_EDGES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SHARP_EDGES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The edges of a triangle surface that can belong to features, by the angle between
// their triangles.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Whether the two triangles on an edge deviate from flat by more than the bound, in degrees.
inline bool is_bent(const Positions& points, const std::vector<Triangle_indices>& triangles,
                    const Triangle_adjacency::Sides& sides, double angle_bound)
{
  const auto normal = [&](int t) {
    const Vector_3& a = points[triangles[t][0]];
    return Vector_3((points[triangles[t][1]] - a).cross(points[triangles[t][2]] - a));
  };
  const Vector_3 m = normal(sides[0].triangle), n = normal(sides[1].triangle);
  return m.dot(n) < std::cos(angle_bound * CGAL_PI / 180) * m.norm() * n.norm();
}

// The edges that are bent by more than the bound, in degrees, and those with one triangle or more than two.
inline Edge_list sharp_edges(const Positions& points, const std::vector<Triangle_indices>& triangles,
                             double angle_bound)
{
  Edge_list sharp;
  Triangle_adjacency(triangles).for_each_edge([&](const Triangle_adjacency::Sides& sides) {
    if (sides.size() != 2 || is_bent(points, triangles, sides, angle_bound))
      sharp.push_back(sides[0].edge);
  });
  return sharp;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SHARP_EDGES_H
