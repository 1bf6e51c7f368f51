// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_NEARBY_TRIANGLES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_NEARBY_TRIANGLES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// For points whose closest triangle is asked for again and again while little
// moves: the few triangles that it can be, so that no tree has to be searched.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Nearby_triangles
{
public:
  // What moves by no more than this keeps its list; in mean boundary edges. From one search to the next four points of
  // five do, while a list has no more than some ten triangles.
  static constexpr double margin = .1;

  // Forgets all lists. points: how many ask.
  void reset(std::size_t points) { lists_.assign(points, List()); }

  // Further points, without lists.
  void add(std::size_t points) { lists_.resize(lists_.size() + points); }

  // The closest of the triangles listed for point i, which now is at p, without its normal. The triangles may have
  // moved by as much as `moved` since the list was made, to triangle_points. Nothing if another triangle could be
  // closer.
  std::optional<Surface_point> closest(std::size_t i, const Vector_3& p, const Positions& triangle_points,
                                       const std::vector<Triangle_indices>& triangles, double moved) const
  {
    const List& list = lists_[i];
    if (list.size == 0)
      return std::nullopt;
    Surface_point best{};
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < list.size; ++k) {
      const Surface_point candidate = closest_point_of_triangle(p, list.triangles[k], triangle_points, triangles);
      const double square = (candidate.point - p).squaredNorm();
      if (square < least) {
        least = square;
        best = candidate;
      }
    }
    if (!(std::sqrt(least) + moved + (p - list.center).norm() <= list.reach))
      return std::nullopt;
    return best;
  }

  // Lists the triangles of a sheet of a surface that are close to p. distance: about that of the closest. False if
  // there are so many that a tree is faster; it stays so until reset.
  bool list(std::size_t i, const Vector_3& p, double distance, const Triangle_surface& surface, int sheet = 0)
  {
    List& list = lists_[i];
    for (double reach : {distance + 2 * margin, distance + 1.2 * margin}) {
      if (list.is_crowded)
        return false;
      list.center = p;
      list.reach = reach;
      list.size = 0;
      bool is_full = false;
      const auto add = [&](std::size_t triangle) {
        const Surface_point candidate = closest_point_of_triangle(p, triangle, surface.points, surface.triangles);
        if ((candidate.point - p).squaredNorm() > reach * reach)
          return;
        if (list.size == capacity)
          is_full = true;
        else
          list.triangles[list.size++] = static_cast<int>(triangle);
      };
      surface.for_triangles_near(p, reach, add, sheet);
      if (!is_full)
        return true;
    }
    list.size = 0;
    list.is_crowded = true;
    return false;
  }

  // As above, but lists the triangles anew where that is needed and p is not far from where it was asked for the last time: a
  // list pays when it is used again. Nothing otherwise, or if there are too many. before: a triangle of the sheet that is
  // searched, at best that which was the closest to where the point came from.
  std::optional<Surface_point> closest(std::size_t i, const Vector_3& p, std::size_t before,
                                       const Positions& triangle_points, const Triangle_surface& surface, double moved)
  {
    std::optional<Surface_point> q = closest(i, p, triangle_points, surface.triangles, moved);
    if (!q && !has_stayed(i, p))
      return q;
    if (!q && list(i, p, (closest_point_of_triangle(p, before, triangle_points, surface.triangles).point - p).norm(),
                   surface, surface.sheet(before)))
      q = closest(i, p, triangle_points, surface.triangles, moved);
    return q;
  }

private:
  bool has_stayed(std::size_t i, const Vector_3& p)
  {
    List& list = lists_[i];
    if ((p - list.center).squaredNorm() <= margin * margin)
      return true;
    list.center = p;
    list.size = 0;
    return false;
  }

  static constexpr int capacity = 16; // about what can be tried in the time of a search

  struct List
  {
    Vector_3 center = Vector_3::Constant(std::numeric_limits<double>::infinity());
    double reach = 0; // nothing is known beyond
    int size = 0;
    bool is_crowded = false;
    std::array<int, capacity> triangles;
  };

  std::vector<List> lists_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_NEARBY_TRIANGLES_H
