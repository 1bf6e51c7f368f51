// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_SUBDIVISION_H
#define CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_SUBDIVISION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Uniform subdivision: the same solid with more hexahedra, for examples and
// benchmarks.

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * divides every hexahedron into `n`³ by the lattice of its trilinear map. Vertices keep their indices, the new ones
 * follow; the parts of a hexahedron take its place. O(`n`³ · hexahedra · log).
 *
 * \tparam PointRange a model of `RandomAccessContainer` and `BackInsertionSequence` of 3D points
 * \tparam HexahedronRange a model of `RandomAccessContainer` and `BackInsertionSequence` whose value type is an array
 *         of eight integers
 *
 * \pre `n` > 0
 */
template <class PointRange, class HexahedronRange>
void subdivide_hex_mesh(PointRange& points, HexahedronRange& hexahedra, std::size_t n)
{
  using Point = typename PointRange::value_type;
  using Hexahedron = typename HexahedronRange::value_type;
  using Index = typename Hexahedron::value_type;
  // A lattice point belongs to all hexahedra for which it is the same combination of the same vertices.
  using Term = std::pair<std::size_t, std::size_t>; // vertex, n³ times its weight
  std::map<std::vector<Term>, std::size_t> known;
  const HexahedronRange given = hexahedra;
  const double whole = double(n) * double(n) * double(n);
  constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

  const auto lattice_point = [&](const Hexahedron& h, const std::array<std::size_t, 3>& place) {
    std::vector<Term> terms;
    for (int c = 0; c < 8; ++c) {
      std::size_t weight = 1;
      for (int d = 0; d < 3; ++d)
        weight *= corner[c][d] ? place[d] : n - place[d];
      if (weight > 0)
        terms.emplace_back(static_cast<std::size_t>(h[c]), weight);
    }
    if (terms.size() == 1)
      return terms[0].first;
    std::sort(terms.begin(), terms.end()); // also makes the sum the same, bit for bit
    const auto [entry, is_new] = known.emplace(std::move(terms), points.size());
    if (is_new) {
      double x = 0, y = 0, z = 0;
      for (const Term& term : entry->first) {
        const Point& p = points[term.first];
        const double weight = double(term.second) / whole;
        x += weight * CGAL::to_double(p.x());
        y += weight * CGAL::to_double(p.y());
        z += weight * CGAL::to_double(p.z());
      }
      points.push_back(Point(x, y, z));
    }
    return entry->second;
  };

  hexahedra.clear();
  std::vector<std::size_t> lattice((n + 1) * (n + 1) * (n + 1));
  const auto number = [n](std::size_t i, std::size_t j, std::size_t k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (const Hexahedron& h : given) {
    for (std::size_t k = 0; k <= n; ++k)
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
          lattice[number(i, j, k)] = lattice_point(h, {{i, j, k}});
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          Hexahedron part;
          for (int c = 0; c < 8; ++c)
            part[c] = static_cast<Index>(lattice[number(i + corner[c][0], j + corner[c][1], k + corner[c][2])]);
          hexahedra.push_back(part);
        }
  }
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_SUBDIVISION_H
