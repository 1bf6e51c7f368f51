// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H

// The quality of all hexahedra at given positions, by which iterates compare.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

struct Mesh_quality
{
  std::vector<double> scaled_jacobians; // of each hexahedron
  std::size_t inverted = 0;             // with a corner ≤ 0
  std::size_t invalid = 0;              // not certified; at least the inverted ones
  double minimum = 1, average = 0;

  Mesh_quality(const Hexahedral_complex& complex, const Positions& points)
    : scaled_jacobians(complex.hexahedra.size())
  {
    struct Part
    {
      std::size_t inverted = 0, invalid = 0;
      double minimum = 1, sum = 0;
    };
    const auto parts = results_of_ranges<Part>(scaled_jacobians.size(), [&](std::size_t begin, std::size_t end) {
      Part part;
      for (std::size_t h = begin; h < end; ++h) {
        const Hexahedron_coordinates x = hexahedron_coordinates(points, complex.hexahedra[h]);
        const double q = scaled_jacobians[h] = scaled_jacobian(x);
        part.inverted += q <= 0;
        part.invalid += q <= 0 || hexahedron_validity(x) != Validity::VALID;
        part.minimum = (std::min)(part.minimum, q);
        part.sum += q;
      }
      return part;
    }, 512);
    for (const Part& part : parts) {
      inverted += part.inverted;
      invalid += part.invalid;
      minimum = (std::min)(minimum, part.minimum);
      average += part.sum;
    }
    average /= scaled_jacobians.size();
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

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MESH_QUALITY_H
