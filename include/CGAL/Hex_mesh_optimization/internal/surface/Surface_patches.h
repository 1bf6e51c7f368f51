// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_PATCHES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_PATCHES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The patches that a set of edges cuts a triangle surface into.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Surface_patches
{
public:
  // barriers: sorted, the smaller index first
  // The adjacency must outlive the object.
  Surface_patches(const Positions& points, const std::vector<Triangle_indices>& triangles,
                  const Triangle_adjacency& adjacency, const Edge_list& barriers)
    : adjacency_(adjacency)
    , patches_(triangles.size())
    , area_(triangles.size(), 0.0)
  {
    adjacency.for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      if (sides.size() > 1 && !std::binary_search(barriers.begin(), barriers.end(), sides[0].edge))
        for (std::size_t i = 1; i < sides.size(); ++i)
          patches_.unite(sides[i].triangle, sides[i - 1].triangle);
    });
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Vector_3& a = points[triangles[t][0]];
      area_[patches_.find(t)] += (points[triangles[t][1]] - a).cross(points[triangles[t][2]] - a).norm() / 2;
    }
  }

  double total_area() const
  {
    double sum = 0;
    for (double area : area_)
      sum += area;
    return sum;
  }

  // Whether an edge lies between different patches none of which is smaller than the area. The rim of an open surface
  // and edges with more than two triangles do.
  bool separates(const std::array<int, 2>& edge, double least_area)
  {
    const Triangle_adjacency::Sides sides = adjacency_.sides(edge);
    if (sides.size() != 2)
      return true;
    const std::size_t left = patches_.find(sides[0].triangle), right = patches_.find(sides[1].triangle);
    return left != right && area_[left] >= least_area && area_[right] >= least_area;
  }

private:
  const Triangle_adjacency& adjacency_;
  Disjoint_sets patches_;
  std::vector<double> area_; // of each patch, at its least triangle
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_SURFACE_PATCHES_H
