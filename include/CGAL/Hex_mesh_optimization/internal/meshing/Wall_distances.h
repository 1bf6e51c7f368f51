// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_WALL_DISTANCES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_WALL_DISTANCES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How far it is from places of a closed surface through the inside to the opposite wall.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Wall_distance
{
  Vector_3 place;  // on the surface
  Vector_3 inward; // unit normal
  std::size_t triangle;
  double area;              // that it stands for
  double distance;          // to the wall, infinite if what is met is no opposite wall
  std::size_t opposite = 0; // the triangle that is met, if it is
};

// At places spread over the surface, about `spacing` apart, but no fewer than one for each triangle with an area. A wall
// is opposite if it turns away from the ray by at most 30 degrees: two sides of an edge, however sharp, are no thin part.
// O((triangles + places) log triangles).
inline std::vector<Wall_distance> wall_distances(const Positions& points,
                                                 const std::vector<Triangle_indices>& triangles, double spacing)
{
  const double opposite = std::cos(CGAL_PI / 6);
  std::vector<aabb::Kernel::Triangle_3> soup;
  std::vector<std::size_t> index;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    soup.emplace_back(aabb::point(points[triangles[t][0]]), aabb::point(points[triangles[t][1]]),
                      aabb::point(points[triangles[t][2]]));
    if (soup.back().squared_area() > 0)
      index.push_back(t);
    else
      soup.pop_back();
  }
  CGAL::AABB_tree<aabb::Triangle_traits> tree(soup.cbegin(), soup.cend());
  tree.build();
  const auto normal = [&](const aabb::Kernel::Triangle_3& t) {
    return Vector_3(
      (aabb::vector(t[1]) - aabb::vector(t[0])).cross(aabb::vector(t[2]) - aabb::vector(t[0])).normalized());
  };

  std::vector<Wall_distance> result;
  for (std::size_t s = 0; s < soup.size(); ++s) {
    const Vector_3 a = aabb::vector(soup[s][0]), b = aabb::vector(soup[s][1]), c = aabb::vector(soup[s][2]);
    const Vector_3 inward = -normal(soup[s]);
    for_parts(a, b, c, spacing, [&](const Vector_3& place, double area) {
      const aabb::Kernel::Ray_3 ray(aabb::point(place), aabb::Kernel::Vector_3(inward[0], inward[1], inward[2]));
      double distance = std::numeric_limits<double>::infinity();
      std::size_t met = 0;
      const auto found = tree.first_intersection(ray, [&](const aabb::Triangle_iterator& other) {
        return static_cast<std::size_t>(other - soup.cbegin()) == s;
      });
      if (found)
        if (const auto* wall = aabb::get_if<aabb::Kernel::Point_3>(&found->first))
          if (normal(*found->second).dot(inward) > opposite) {
            distance = (aabb::vector(*wall) - place).norm();
            met = index[static_cast<std::size_t>(found->second - soup.cbegin())];
          }
      result.push_back({place, inward, index[s], area, distance, met});
    });
  }
  return result;
}

// The largest distance such that places closer to their walls have no more than that part of the area.
inline double distance_of_thinnest(std::vector<Wall_distance> places, double part)
{
  std::sort(places.begin(), places.end(),
            [](const Wall_distance& a, const Wall_distance& b) { return a.distance < b.distance; });
  double total = 0, sum = 0;
  for (const Wall_distance& p : places)
    total += p.area;
  for (const Wall_distance& p : places) {
    sum += p.area;
    if (sum > part * total)
      return p.distance;
  }
  return std::numeric_limits<double>::infinity();
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_WALL_DISTANCES_H
