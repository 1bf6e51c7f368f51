// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arrays.h"

#include <CGAL/Hex_mesh_optimization/Input_error.h>

#include <algorithm>

void require_vertices(const Table& hexahedra, std::size_t number_of_points)
{
  for (std::size_t h = 0; h < hexahedra.rows(); ++h)
    for (std::size_t k = 0; k < 8; ++k) {
      const std::int64_t v = hexahedra.index(h, k);
      if (v < 0 || static_cast<std::uint64_t>(v) >= number_of_points)
        throw CGAL::Hex_mesh_optimization::Input_error(CGAL::Hex_mesh_optimization::Input_error::Element::HEXAHEDRON, h,
                                                       "hexahedron " + std::to_string(h) +
                                                         " refers to a vertex that does not exist");
    }
}

Points points_of(const py::array& points)
{
  const auto range = point_range(Table(points));
  return Points(range.begin(), range.end());
}

std::vector<std::array<std::size_t, 8>> hexahedra_of(const py::array& hexahedra)
{
  std::vector<std::array<std::size_t, 8>> result;
  for (const auto& h : cell_range<8>(Table(hexahedra))) {
    result.emplace_back();
    std::copy(h.begin(), h.end(), result.back().begin());
  }
  return result;
}
