// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEETING_PAIRS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEETING_PAIRS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The pairs of triangles of a soup that have more in common than an edge or a vertex.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Soup_pair
{
  int first, second;
  bool is_coplanar;
};

// Of vertices as they are.
struct Predicate_points
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  Kernel::Point_3 operator()(int v) const { return Kernel::Point_3(points[v][0], points[v][1], points[v][2]); }

  const Positions& points;
};

// Point_of: as Predicate_points.
template <class Point_of>
class Soup_predicates
{
public:
  using Kernel = typename Point_of::Kernel;

  Soup_predicates(const Point_of& point_of, const std::vector<Triangle_indices>& triangles)
    : point(point_of)
    , triangles_(triangles)
  {}

  const Point_of point;

  bool are_coplanar(int s, int t) const
  {
    const Triangle_indices &a = triangles_[s], &b = triangles_[t];
    for (int k = 0; k < 3; ++k)
      if (CGAL::orientation(point(a[0]), point(a[1]), point(a[2]), point(b[k])) != CGAL::COPLANAR)
        return false;
    return true;
  }

  // In more than the edge or vertex that they have in common.
  bool meet(int s, int t) const
  {
    const Triangle_indices &a = triangles_[s], &b = triangles_[t];
    std::array<int, 3> in_a{}, in_b{}; // places of common vertices
    int common = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (a[i] == b[j]) {
          in_a[common] = i;
          in_b[common++] = j;
        }
    if (common == 3)
      return true;
    if (common == 2) {
      const auto p = point(a[3 - in_a[0] - in_a[1]]), q = point(b[3 - in_b[0] - in_b[1]]);
      const auto r = point(a[in_a[0]]), u = point(a[in_a[1]]);
      return CGAL::orientation(r, u, p, q) == CGAL::COPLANAR &&
             CGAL::coplanar_orientation(r, u, p, q) == CGAL::POSITIVE;
    }
    const typename Kernel::Triangle_3 of_a(point(a[0]), point(a[1]), point(a[2])),
      of_b(point(b[0]), point(b[1]), point(b[2]));
    if (common == 0)
      return CGAL::do_intersect(of_a, of_b);
    const auto opposite = [&](const Triangle_indices& c, int k) {
      return typename Kernel::Segment_3(point(c[(k + 1) % 3]), point(c[(k + 2) % 3]));
    };
    return CGAL::do_intersect(opposite(a, in_a[0]), of_b) || CGAL::do_intersect(opposite(b, in_b[0]), of_a);
  }

private:
  const std::vector<Triangle_indices>& triangles_;
};

// In increasing order. Equal places have equal indices. O(n log² n + pairs of overlapping boxes).
template <class Point_of>
std::vector<Soup_pair> meeting_pairs(const Point_of& point_of, const std::vector<Triangle_indices>& triangles)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  const Soup_predicates<Point_of> predicates(point_of, triangles);
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    boxes.emplace_back(predicates.point(triangles[t][0]).bbox() + predicates.point(triangles[t][1]).bbox() +
                         predicates.point(triangles[t][2]).bbox(),
                       static_cast<int>(t));
  std::vector<Soup_pair> result;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const int s = (std::min)(a.info(), b.info()), t = (std::max)(a.info(), b.info());
    if (predicates.meet(s, t))
      result.push_back({s, t, predicates.are_coplanar(s, t)});
  });
  std::sort(result.begin(), result.end(), [](const Soup_pair& a, const Soup_pair& b) {
    return std::make_pair(a.first, a.second) < std::make_pair(b.first, b.second);
  });
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEETING_PAIRS_H
