// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_COORDINATE_BISECTION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_COORDINATE_BISECTION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which part of a mesh each hexahedron belongs to: by recursive bisection at medians of the centers, which is the same
// whatever the ranks are.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Block_array.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The value of a given rank in each of several groups: counted digit by digit. value(h, group): of a hexahedron of this rank;
// the group is -1 where it does not count. Collective.
template <class Value>
std::vector<std::uint32_t> ranked_values(const Distributed_mesh& mesh, const std::vector<std::int64_t>& wanted_ranks,
                                         const Value& value)
{
  constexpr int digits = 4, values_of_digit = 256;
  const std::size_t groups = wanted_ranks.size();
  std::vector<std::uint32_t> found(groups, 0);
  std::vector<std::int64_t> left = wanted_ranks;
  for (int digit = digits - 1; digit >= 0; --digit) {
    std::vector<std::int64_t> counts(groups * values_of_digit, 0);
    mesh.for_own_hexahedra([&](std::size_t h) {
      int group = -1;
      const std::uint32_t v = value(h, group);
      if (group < 0)
        return;
      const bool is_alike = digit == digits - 1 || v >> 8 * (digit + 1) == found[group] >> 8 * (digit + 1);
      if (is_alike)
        ++counts[std::size_t(group) * values_of_digit + (v >> 8 * digit & 255)];
    });
    mesh.ranks.sum(counts);
    for (std::size_t g = 0; g < groups; ++g) {
      std::uint32_t d = 0;
      while (d < values_of_digit - 1 && left[g] >= counts[g * values_of_digit + d])
        left[g] -= counts[g * values_of_digit + d++];
      found[g] |= d << 8 * digit;
    }
  }
  return found;
}

// Three orthogonal directions, others for each cut.
inline std::array<Vector_3, 3> directions_of_cut(int cut)
{
  const double a = .6 * cut, b = .35 * cut; // angles
  const Vector_3 x(std::cos(a), std::sin(a), 0), y(-std::sin(a), std::cos(a), 0), z(0, 0, 1);
  return {x, Vector_3(std::cos(b) * y + std::sin(b) * z), Vector_3(std::cos(b) * z - std::sin(b) * y)};
}

// Of the first of two parts, against its share: where a mesh is symmetric, medians are at the same places for all directions.
inline double shift_of_cut(int cut) { return 1 + .15 * ((cut + 1) % 3 - 1); }

// Of the hexahedra of this rank; none is -1. is_in: which are to be in a part. Collective. O(hexahedra · log parts).
template <class Is_in>
Block_array<int> coordinate_bisection(const Distributed_mesh& mesh, int number_of_parts, int cut, const Is_in& is_in)
{
  constexpr double largest_key = 4294967295.;
  Block_array<int> part = mesh.new_array<int>(mesh.number_of_own_hexahedra());
  mesh.for_own_hexahedra([&](std::size_t h) { part[h] = is_in(h) ? 0 : -1; });
  const Distributed_mesh::Nearby<Triple> places = mesh.nearby(mesh.points);
  const std::array<Vector_3, 3> directions = directions_of_cut(cut);
  const auto center = [&](std::size_t h) {
    Vector_3 sum = Vector_3::Zero();
    for (const Vector_3& p : mesh.corners(places, h))
      sum += p;
    return Vector_3(sum / 8);
  };
  // nodes of a tree: how many parts each is to become, the first of which has its number
  std::vector<int> sizes(number_of_parts, 0);
  sizes[0] = number_of_parts;
  while (std::any_of(sizes.begin(), sizes.end(), [](int size) { return size > 1; })) {
    std::vector<double> extents(6 * sizes.size(), -std::numeric_limits<double>::infinity());
    std::vector<std::int64_t> counts(sizes.size(), 0);
    mesh.for_own_hexahedra([&](std::size_t h) {
      if (part[h] < 0 || sizes[part[h]] < 2)
        return;
      ++counts[part[h]];
      const Vector_3 c = center(h);
      for (int i = 0; i < 3; ++i) {
        double* of_node = &extents[6 * part[h] + 2 * i];
        of_node[0] = (std::max)(of_node[0], directions[i].dot(c));
        of_node[1] = (std::max)(of_node[1], -directions[i].dot(c));
      }
    });
    mesh.ranks.maximum(extents);
    mesh.ranks.sum(counts);
    std::vector<int> axis(sizes.size(), 0);
    std::vector<std::int64_t> ranks(sizes.size(), 0);
    const auto extent = [&](std::size_t n, int i) { return extents[6 * n + 2 * i] + extents[6 * n + 2 * i + 1]; };
    for (std::size_t n = 0; n < sizes.size(); ++n) {
      for (int i = 1; i < 3; ++i)
        if (extent(n, i) > extent(n, axis[n]))
          axis[n] = i;
      if (sizes[n] > 1)
        ranks[n] = static_cast<std::int64_t>(shift_of_cut(cut) * double(counts[n] * (sizes[n] / 2) / sizes[n]));
    }
    const auto key = [&](std::size_t h) {
      const int n = part[h], i = axis[n];
      const double length = extent(n, i);
      const double from_low = directions[i].dot(center(h)) + extents[6 * n + 2 * i + 1];
      return length > 0 ? static_cast<std::uint32_t>((std::max)(0., (std::min)(1., from_low / length)) * largest_key)
                        : std::uint32_t(0);
    };
    const std::vector<std::uint32_t> medians = ranked_values(mesh, ranks, [&](std::size_t h, int& node) {
      node = part[h] >= 0 && sizes[part[h]] > 1 ? part[h] : -1;
      return node < 0 ? std::uint32_t(0) : key(h);
    });
    mesh.for_own_hexahedra([&](std::size_t h) {
      const int n = part[h];
      if (n >= 0 && sizes[n] > 1 && key(h) >= medians[n])
        part[h] = n + sizes[n] / 2;
    });
    for (std::size_t n = sizes.size(); n-- > 0;)
      if (sizes[n] > 1) {
        sizes[n + sizes[n] / 2] = sizes[n] - sizes[n] / 2;
        sizes[n] /= 2;
      }
  }
  part.release();
  return part;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_COORDINATE_BISECTION_H
