// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CREST_SAMPLES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CREST_SAMPLES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Points on the sharp edges of a surface. Where another surface cuts such an edge
// off, the edge is what is farthest from it; points within triangles cannot tell
// how far.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// In the middle of parts of the edges within a sheet that are bent by more than some 30 degrees, parts no longer than the
// spacing; each stands for an area of its length times the width. Fewer on an oversized surface, as of spread_samples.
// Sheet by sheet. O(n log n).
inline std::vector<Surface_sample> crest_samples(const Triangle_surface& surface, std::size_t number_of_boundary_faces,
                                                 double spacing, double width)
{
  const double least_bend = 30; // degrees; with less there are more samples, and nothing is gained
  const double most_parts = 64; // of an edge that is very much longer
  spacing *= std::sqrt(oversize(surface.points, surface.triangles, number_of_boundary_faces));
  std::vector<std::vector<Triangle_indices>> of_sheet(surface.number_of_sheets());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    of_sheet[surface.sheet(t)].push_back(surface.triangles[t]);
  std::vector<Surface_sample> samples;
  for (std::size_t sheet = 0; sheet < of_sheet.size(); ++sheet)
    Triangle_adjacency(of_sheet[sheet]).for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      if (sides.size() != 2 || !is_bent(surface.points, of_sheet[sheet], sides, least_bend))
        return;
      const Vector_3 &a = surface.points[sides[0].edge[0]], &b = surface.points[sides[0].edge[1]];
      const double length = (b - a).norm();
      const int n = static_cast<int>((std::max)(1.0, (std::min)(std::ceil(length / spacing), most_parts)));
      for (int i = 0; i < n; ++i)
        samples.push_back({a + (i + .5) / n * (b - a), width * length / n, -1, static_cast<int>(sheet)});
    });
  return samples;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_CREST_SAMPLES_H
