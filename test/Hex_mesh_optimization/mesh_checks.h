// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HEX_MESH_OPTIMIZATION_TEST_MESH_CHECKS_H
#define HEX_MESH_OPTIMIZATION_TEST_MESH_CHECKS_H

// What the guarantees of an optimization are checked by.

#include <CGAL/Hex_mesh_optimization/validity.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <vector>

// Tells 0 from -0, and NaN from none.
template <class Point>
bool same_bits(const Point& a, const Point& b)
{
  for (int d = 0; d < 3; ++d) {
    const double x = a[d], y = b[d];
    if (std::memcmp(&x, &y, sizeof x) != 0)
      return false;
  }
  return true;
}

template <class Points>
bool same_points(const Points& p, const Points& q)
{
  return p.size() == q.size() &&
         std::equal(p.begin(), p.end(), q.begin(), [](const auto& a, const auto& b) { return same_bits(a, b); });
}

template <class Mesh>
std::vector<std::size_t> invalid_hexahedra(const Mesh& mesh)
{
  std::vector<std::size_t> result;
  CGAL::Hex_mesh_optimization::invalid_hexahedra(mesh.points, mesh.hexahedra, std::back_inserter(result));
  return result;
}

#endif // HEX_MESH_OPTIMIZATION_TEST_MESH_CHECKS_H
