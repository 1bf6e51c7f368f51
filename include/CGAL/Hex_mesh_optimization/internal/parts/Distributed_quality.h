// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_QUALITY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The quality of a mesh that is distributed over ranks: exact sums, the same whatever the ranks are.

#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Block_array.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Exact_sum.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/coordinate_bisection.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/volume.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Distributed_quality
{
public:
  // Of the mesh with its vertices at these places. Collective.
  Distributed_quality(const Distributed_mesh& mesh, const Block_array<Triple>& places)
    : is_invalid(mesh.new_array<char>(mesh.number_of_own_hexahedra()))
    , qualities(mesh.new_array<float>(mesh.number_of_own_hexahedra()))
    , volumes(mesh.all_labels.size())
  {
    const Distributed_mesh::Nearby<Triple> nearby = mesh.nearby(places);
    Block_array<float> ratios = mesh.new_array<float>(mesh.number_of_own_hexahedra());
    std::vector<std::int64_t> counts(2, 0); // inverted, invalid
    std::vector<double> largest{-1, -1, 0}; // less the minima, the largest edge ratio
    Exact_sum sum, squares, with_center_sum;
    std::vector<Exact_sum> volumes_of_labels(mesh.all_labels.size());
    const double unit_of_volume = mesh.unit * mesh.unit * mesh.unit;
    std::vector<Global_index> own_invalid;
    mesh.for_own_hexahedra([&](std::size_t h) {
      Hexahedron_coordinates x;
      Vector_3 corners[8];
      for (int i = 0; i < 8; ++i) {
        x[i] = nearby[mesh.hexahedra[h][i]];
        corners[i] = as_vector(x[i]);
      }
      const double quality = scaled_jacobian(x), with_center = (std::min)(quality, center_scaled_jacobian(x));
      qualities[h] = static_cast<float>(quality);
      counts[0] += quality <= 0;
      is_invalid[h] = hexahedron_validity(x) != Validity::VALID;
      if (is_invalid[h])
        own_invalid.push_back(mesh.first_hexahedron() + static_cast<Global_index>(h));
      sum.add(quality);
      squares.add(quality * quality);
      with_center_sum.add(with_center);
      const double ratio = edge_ratio(x);
      ratios[h] = static_cast<float>(ratio);
      largest[0] = (std::max)(largest[0], -quality);
      largest[1] = (std::max)(largest[1], -with_center);
      largest[2] = (std::max)(largest[2], ratio);
      const auto label = std::lower_bound(mesh.all_labels.begin(), mesh.all_labels.end(), mesh.label(h));
      volumes_of_labels[label - mesh.all_labels.begin()].add(volume(corners) / unit_of_volume);
    });
    counts[1] = static_cast<std::int64_t>(own_invalid.size());
    mesh.ranks.sum(counts);
    mesh.ranks.maximum(largest);
    std::vector<Exact_sum*> sums{&sum, &squares, &with_center_sum};
    for (Exact_sum& v : volumes_of_labels)
      sums.push_back(&v);
    Exact_sum::sum(mesh.ranks, sums);
    invalid = mesh.ranks.gather_values(own_invalid);
    const double n = double(mesh.number_of_hexahedra);
    statistics.number_of_hexahedra = static_cast<std::size_t>(mesh.number_of_hexahedra);
    statistics.number_of_inverted = static_cast<std::size_t>(counts[0]);
    statistics.number_of_invalid = static_cast<std::size_t>(counts[1]);
    statistics.minimum = -largest[0];
    statistics.minimum_with_center = -largest[1];
    statistics.average = sum.value() / n;
    statistics.average_with_center = with_center_sum.value() / n;
    statistics.standard_deviation = std::sqrt(
      (std::max)(0., squares.value() / n - statistics.average * statistics.average));
    statistics.maximum_edge_ratio = largest[2];
    for (std::size_t l = 0; l < volumes.size(); ++l)
      volumes[l] = volumes_of_labels[l].value() * unit_of_volume;
    const auto entry = [&](Global_index rank) {
      // positive numbers are in the order of their bits
      const std::uint32_t bits = ranked_values(mesh, {rank}, [&](std::size_t h, int& group) {
        group = 0;
        std::uint32_t b;
        std::memcpy(&b, &ratios[h], sizeof(b));
        return b;
      })[0];
      float ratio;
      std::memcpy(&ratio, &bits, sizeof(ratio));
      return double(ratio);
    };
    statistics.median_edge_ratio = entry(mesh.number_of_hexahedra / 2);
    statistics.edge_ratio_99 = entry(mesh.number_of_hexahedra * 99 / 100);
  }

  Quality_statistics statistics;     // of all; ratios of edges in single precision
  std::vector<Global_index> invalid; // of all, in increasing order
  Block_array<char> is_invalid;      // of the hexahedra of this rank
  Block_array<float> qualities;      // of those: scaled Jacobians
  std::vector<double> volumes;       // of the labels
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_QUALITY_H
