// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H

// The two-sided distance between the boundary of the mesh and the reference.

#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Distances from points spread over one surface to the other. O(samples · log triangles).
inline void extend_deviation(const Triangle_surface& from, const Triangle_surface& to,
                             std::size_t number_of_boundary_faces, double spacing, Deviation& deviation)
{
  struct Part
  {
    double sum = 0, weight = 0, largest = 0;
  };
  const std::vector<Surface_sample> samples = spread_samples(from.points, from.triangles, number_of_boundary_faces,
                                                             spacing);
  const auto parts = results_of_ranges<Part>(
    samples.size(),
    [&](std::size_t begin, std::size_t end) {
      Part part;
      std::size_t hint = Surface_point::no_hint; // the next sample is not far
      for (std::size_t i = begin; i < end; ++i) {
        const Surface_point foot = to.closest_point(samples[i].point, hint);
        hint = foot.hint;
        const double distance = (foot.point - samples[i].point).norm();
        part.sum += samples[i].area * distance;
        part.weight += samples[i].area;
        part.largest = (std::max)(part.largest, distance);
      }
      return part;
    },
    1024);
  double sum = 0, weight = 0, largest = 0;
  for (const Part& part : parts) {
    sum += part.sum;
    weight += part.weight;
    largest = (std::max)(largest, part.largest);
  }
  if (weight > 0)
    deviation.average = (std::max)(deviation.average, sum / weight);
  deviation.maximum = (std::max)(deviation.maximum, largest);
}

inline Deviation deviation(const Hexahedral_complex& complex, const Positions& points,
                           const Triangle_surface& reference, double spacing)
{
  Deviation result;
  const Triangle_surface boundary(points, boundary_triangles(complex));
  if (boundary.is_empty() || reference.is_empty())
    return result;
  const std::size_t faces = complex.boundary_faces.size();
  extend_deviation(boundary, reference, faces, spacing, result);
  extend_deviation(reference, boundary, faces, spacing, result);
  const double diagonal = bounding_box_diagonal(reference);
  result.average_relative = result.average / diagonal;
  result.maximum_relative = result.maximum / diagonal;
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H
