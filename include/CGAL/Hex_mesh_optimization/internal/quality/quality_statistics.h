// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_STATISTICS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_STATISTICS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The statistics of a mesh as they are reported: in one pass over the hexahedra,
// in the order given.

#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Quality_counts.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

template <class PointRange, class HexahedronRange>
Quality_statistics quality_statistics(const PointRange& points, const HexahedronRange& hexahedra)
{
  Quality_statistics result;
  const std::size_t n = result.number_of_hexahedra = hexahedra.size();
  if (n == 0)
    return result;

  std::vector<double> qualities, edge_ratios;
  qualities.reserve(n);
  edge_ratios.reserve(n);
  result.minimum_with_center = 1;
  Quality_counts counts;
  for (const auto& hexahedron : hexahedra) {
    const auto x = hexahedron_coordinates(points, hexahedron);
    const double quality = scaled_jacobian(x);
    const double with_center = (std::min)(quality, center_scaled_jacobian(x));
    qualities.push_back(quality);
    edge_ratios.push_back(edge_ratio(x));
    counts.add(quality, hexahedron_validity(x) == Validity::VALID);
    result.minimum_with_center = (std::min)(result.minimum_with_center, with_center);
    result.average_with_center += with_center;
  }
  result.number_of_inverted = counts.inverted;
  result.number_of_invalid = counts.invalid;
  result.minimum = counts.minimum;
  result.average = counts.sum / double(n);
  result.average_with_center /= double(n);

  double variance = 0;
  for (double quality : qualities)
    variance += (quality - result.average) * (quality - result.average);
  result.standard_deviation = std::sqrt(variance / double(n));

  auto entry = [&edge_ratios](std::size_t rank) {
    std::nth_element(edge_ratios.begin(), edge_ratios.begin() + rank, edge_ratios.end());
    return edge_ratios[rank];
  };
  result.median_edge_ratio = entry(n / 2);
  result.edge_ratio_99 = entry(n * 99 / 100);
  result.maximum_edge_ratio = entry(n - 1);
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_QUALITY_STATISTICS_H
