// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_MARKED_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_MARKED_VERTICES_H

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

// A set of vertices as a property map, for vertex_is_constrained_map().
struct Marked_vertices
{
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<char>* marks;
  friend bool get(const Marked_vertices& map, std::size_t v) { return (*map.marks)[v]; }
};

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_MARKED_VERTICES_H
