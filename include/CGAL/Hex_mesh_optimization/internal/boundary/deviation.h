// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The two-sided distance between faces of the mesh and the reference, sheet by sheet.

#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/crest_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The two-sided distances of all sheets together, and of each.
struct Deviations
{
  Deviation all;
  std::vector<Deviation> of_sheet;
};

// Distances from points spread over one surface to the other.
struct Sampled_distances
{
  double sum = 0, weight = 0, largest = 0;

  void add(const Sampled_distances& other)
  {
    sum += other.sum;
    weight += other.weight;
    largest = (std::max)(largest, other.largest);
  }

  void extend(Deviation& deviation) const
  {
    if (weight > 0)
      deviation.average = (std::max)(deviation.average, sum / weight);
    deviation.maximum = (std::max)(deviation.maximum, largest);
  }
};

// O(samples · log triangles).
inline void extend_deviations(const Triangle_surface& from, const Triangle_surface& to,
                              std::size_t number_of_boundary_faces, double spacing, Deviations& deviations)
{
  std::vector<Surface_sample> samples = spread_samples(from, number_of_boundary_faces, spacing);
  // for the maximum only: they have no area
  const std::vector<Surface_sample> crests = crest_samples(from, number_of_boundary_faces, spacing, 0);
  samples.insert(samples.end(), crests.begin(), crests.end());
  using Of_sheets = std::vector<Sampled_distances>;
  const auto parts = results_of_ranges<Of_sheets>(
    samples.size(),
    [&](std::size_t begin, std::size_t end) {
      Of_sheets part(from.number_of_sheets());
      Surface_point foot{};
      for (std::size_t i = begin; i < end; ++i) {
        foot = to.closest_point(samples[i].point, foot.triangle, samples[i].sheet); // the next sample is not far
        const double distance = to.way(samples[i].point, foot).norm();
        part[samples[i].sheet].add({samples[i].area * distance, samples[i].area, distance});
      }
      return part;
    },
    1024);
  Of_sheets of_sheets(deviations.of_sheet.size());
  for (const Of_sheets& part : parts)
    for (std::size_t s = 0; s < part.size(); ++s)
      of_sheets[s].add(part[s]);
  Sampled_distances all;
  for (std::size_t s = 0; s < of_sheets.size(); ++s) {
    of_sheets[s].extend(deviations.of_sheet[s]);
    all.add(of_sheets[s]);
  }
  all.extend(deviations.all);
}

// faces: with the sheets of the reference
inline Deviations deviations(const Surface_faces& faces, const Positions& points, const Triangle_surface& reference,
                             double spacing)
{
  Deviations result;
  const Triangle_surface boundary = as_triangle_surface(faces, points);
  result.of_sheet.resize((std::max)(boundary.number_of_sheets(), reference.number_of_sheets()));
  if (boundary.is_empty() || reference.is_empty())
    return result;
  extend_deviations(boundary, reference, faces.quads.size(), spacing, result);
  extend_deviations(reference, boundary, faces.quads.size(), spacing, result);
  const double diagonal = bounding_box_diagonal(reference);
  const auto relate = [&](Deviation& d) {
    d.average_relative = d.average / diagonal;
    d.maximum_relative = d.maximum / diagonal;
  };
  relate(result.all);
  for (Deviation& d : result.of_sheet)
    relate(d);
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_DEVIATION_H
