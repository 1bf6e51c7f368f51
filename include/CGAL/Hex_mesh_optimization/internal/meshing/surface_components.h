// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_COMPONENTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_COMPONENTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The closed parts of a surface, which may have vertices, edges and faces at the same places.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The triangles on an edge, in the order in which they are met turning left about it. Of those in one plane, what
// closes an inside comes before what opens one.
inline std::vector<Soup_side> sides_around(const Positions& points, const std::vector<Triangle_indices>& triangles,
                                           std::vector<Soup_side> sides)
{
  const std::array<int, 2> edge = sides[0].edge;
  const Vector_3 axis = (points[edge[1]] - points[edge[0]]).normalized();
  const Vector_3 u = axis.unitOrthogonal(), v = axis.cross(u);
  using Keyed = std::tuple<long, bool, std::size_t>;
  std::vector<Keyed> keys;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    int third = edge[0];
    for (int w : triangles[sides[i].triangle])
      if (w != edge[0] && w != edge[1])
        third = w;
    const Vector_3 d = points[third] - points[edge[0]];
    constexpr double resolution = 1e-6; // in radians
    keys.emplace_back(std::lround(std::atan2(d.dot(v), d.dot(u)) / resolution), sides[i].is_reversed, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Soup_side> result;
  for (const Keyed& key : keys)
    result.push_back(sides[std::get<2>(key)]);
  return result;
}

// Of each triangle the number of its part, from 1, in the order of the first triangles. Where more than two meet in
// an edge, those belong together that have inside between them. What is oriented against the rest is a cavity, and
// belongs to the smallest part around it. O(n log n), and the parts times the cavities' windings.
inline std::vector<int> surface_components(const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  Disjoint_sets sets(triangles.size());
  for_soup_edges(triangles, [&](auto first, auto last) {
    std::vector<Soup_side> sides(first, last);
    const auto number_reversed = std::count_if(first, last, [](const Soup_side& s) { return s.is_reversed; });
    if (sides.size() <= 2 || 2 * number_reversed != last - first) {
      for (const Soup_side& s : sides)
        sets.unite(s.triangle, sides[0].triangle);
      return;
    }
    sides = sides_around(points, triangles, std::move(sides));
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Soup_side &a = sides[i], &b = sides[(i + 1) % sides.size()];
      if (a.is_reversed && !b.is_reversed) // inside is after a
        sets.unite(a.triangle, b.triangle);
    }
  });

  std::map<std::size_t, int> number; // of each set
  std::vector<std::vector<int>> members;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto inserted = number.emplace(sets.find(t), static_cast<int>(members.size()));
    if (inserted.second)
      members.emplace_back();
    members[inserted.first->second].push_back(static_cast<int>(t));
  }
  std::vector<double> volume(members.size(), 0);
  double total = 0;
  for (std::size_t c = 0; c < members.size(); ++c) {
    const Vector_3 origin = points[triangles[members[c][0]][0]];
    for (int t : members[c])
      volume[c] += (points[triangles[t][0]] - origin)
                     .dot((points[triangles[t][1]] - origin).cross(points[triangles[t][2]] - origin)) /
                   6;
    total += volume[c];
  }
  const auto winds_around = [&](std::size_t c, const Vector_3& p) {
    double sum = 0;
    for (int t : members[c])
      sum += solid_angle(p, points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]);
    return std::abs(sum) > .5;
  };
  std::vector<std::size_t> owner(members.size());
  for (std::size_t c = 0; c < members.size(); ++c) {
    owner[c] = c;
    if (volume[c] * total >= 0)
      continue;
    const Triangle_indices& t = triangles[members[c][0]];
    const Vector_3 middle = (points[t[0]] + points[t[1]] + points[t[2]]) / 3;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < members.size(); ++d)
      if (volume[d] * total > 0 && std::abs(volume[d]) < least && std::abs(volume[d]) > std::abs(volume[c]) &&
          winds_around(d, middle)) {
        least = std::abs(volume[d]);
        owner[c] = d;
      }
  }
  std::vector<int> label(members.size(), 0), result(triangles.size());
  int last = 0;
  for (std::size_t c = 0; c < members.size(); ++c)
    if (owner[c] == c)
      label[c] = ++last;
  for (std::size_t c = 0; c < members.size(); ++c)
    for (int t : members[c])
      result[t] = label[owner[c]];
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_COMPONENTS_H
