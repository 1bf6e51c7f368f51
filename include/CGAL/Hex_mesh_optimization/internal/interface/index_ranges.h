// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INDEX_RANGES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INDEX_RANGES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Points and hexahedra of the caller's as flat arrays, and back.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <CGAL/Container_helper.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The indices of a cell of n vertices; what cannot be one becomes -1.
template <std::size_t n, class IndexRange>
std::array<int, n> engine_indices(const IndexRange& indices)
{
  std::array<int, n> result;
  auto given = std::begin(indices);
  for (int& i : result) {
    const auto index = static_cast<unsigned long long>(*given++); // negative ones become huge
    i = index > 0x7fffffffull ? -1 : static_cast<int>(index);
  }
  return result;
}

template <class HexahedronRange>
std::vector<Hexahedron> engine_hexahedra(const HexahedronRange& hexahedra)
{
  std::vector<Hexahedron> result;
  result.reserve(hexahedra.size());
  for (const auto& h : hexahedra) {
    const auto count = std::distance(std::begin(h), std::end(h));
    if (count != 8)
      throw Input_error(Input_error::Element::HEXAHEDRON, result.size(),
                        "cell " + std::to_string(result.size()) + " has " + std::to_string(count) +
                          " vertices: it is not a hexahedron");
    result.push_back(engine_indices<8>(h));
  }
  return result;
}

template <class PointRange>
Positions engine_positions(const PointRange& points)
{
  Positions result;
  result.reserve(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))));
  for (const auto& p : points)
    result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  return result;
}

// Replaces both.
template <class PointRange, class HexahedronRange>
void assign_index_ranges(const Positions& positions, const std::vector<Hexahedron>& corners, PointRange& points,
                         HexahedronRange& hexahedra)
{
  using Point = typename PointRange::value_type;
  PointRange new_points;
  new_points.reserve(positions.size());
  for (const Vector_3& p : positions)
    new_points.push_back(Point(p[0], p[1], p[2]));
  HexahedronRange new_hexahedra;
  new_hexahedra.reserve(corners.size());
  for (const Hexahedron& h : corners) {
    typename HexahedronRange::value_type hexahedron;
    CGAL::internal::resize(hexahedron, 8);
    for (int c = 0; c < 8; ++c)
      hexahedron[c] = static_cast<std::decay_t<decltype(hexahedron[0])>>(h[c]);
    new_hexahedra.push_back(std::move(hexahedron));
  }
  points = std::move(new_points);
  hexahedra = std::move(new_hexahedra);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_INDEX_RANGES_H
