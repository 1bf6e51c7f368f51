// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The quality of all hexahedra at given positions, by which iterates compare.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Quality_counts.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Mesh_quality
{
  std::vector<double> scaled_jacobians; // of each hexahedron
  std::size_t inverted = 0;             // with a corner ≤ 0
  std::size_t invalid = 0;              // not certified, the inverted ones included
  double minimum = 1, average = 0;

  Mesh_quality(const Hexahedral_complex& complex, const Positions& points) : scaled_jacobians(complex.hexahedra.size())
  {
    const auto parts = results_of_ranges<Quality_counts>(
      scaled_jacobians.size(),
      [&](std::size_t begin, std::size_t end) {
        Quality_counts part;
        for (std::size_t h = begin; h < end; ++h) {
          const Hexahedron_coordinates x = hexahedron_coordinates(points, complex.hexahedra[h]);
          const double q = scaled_jacobians[h] = scaled_jacobian(x);
          part.add(q, q > 0 && hexahedron_validity(x) == Validity::VALID);
        }
        return part;
      },
      512);
    Quality_counts counts;
    for (const Quality_counts& part : parts)
      counts.add(part);
    inverted = counts.inverted;
    invalid = counts.invalid;
    minimum = counts.minimum;
    average = counts.sum / double(scaled_jacobians.size());
  }

  // The least that all but this part of the hexahedra have.
  double quantile(double part) const
  {
    std::vector<double> sorted = scaled_jacobians;
    const std::size_t rank = static_cast<std::size_t>(part * double(sorted.size()));
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    return sorted[rank];
  }

  // The worst hexahedron around a vertex.
  double worst_around(const Hexahedral_complex& complex, int v) const
  {
    double worst = 1;
    for (int h : complex.vertex_hexahedra[v])
      worst = (std::min)(worst, scaled_jacobians[h]);
    return worst;
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H
