// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

std::set<Edge> feature_edges(const Table& edges, const Table& triangles)
{
  std::set<Edge> all, result;
  for (const auto& t : cell_range<3>(triangles))
    for (std::size_t k = 0; k < 3; ++k)
      all.insert(edge_of(t[k], t[(k + 1) % 3]));
  for (const auto& e : cell_range<2>(edges)) {
    if (all.count(edge_of(e[0], e[1])) == 0)
      throw py::value_error("edge_is_constrained_map: no triangle has the edge between the vertices " +
                            std::to_string(e[0]) + " and " + std::to_string(e[1]));
    result.insert(edge_of(e[0], e[1]));
  }
  return result;
}
