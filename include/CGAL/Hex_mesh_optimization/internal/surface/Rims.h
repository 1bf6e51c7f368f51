// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_RIMS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_RIMS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where a sheet of triangles ends only because another surface is there, which may go elsewhere: as an interface ends at
// an outer boundary that is brought to a reference.

#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// What is beyond a rim: the plane of the triangle goes on, or nothing is asked for, so that every place is as good.
enum class Beyond_rim : char { PLANE, ANYTHING };

class Rims
{
public:
  static constexpr int none = -1;

  Rims() = default;

  // sides: 3t + k is the side from corner k of triangle t to the next one. sheets: of the triangles; none: all are in
  // one.
  Rims(const std::vector<Triangle_indices>& triangles, const std::vector<int>& sheets,
       const std::vector<std::size_t>& sides, Beyond_rim its_beyond)
    : beyond(its_beyond)
  {
    if (sides.empty())
      return;
    of_triangle_.resize(triangles.size());
    using Place = std::array<int, 3>; // sheet, vertex, a triangle with a side there
    std::vector<Place> places;
    for (std::size_t side : sides) {
      const std::size_t t = side / 3, k = side % 3;
      of_triangle_[t].sides[k] = true;
      for (std::size_t end : {k, (k + 1) % 3})
        places.push_back({sheets.empty() ? 0 : sheets[t], triangles[t][end], static_cast<int>(t)});
    }
    std::sort(places.begin(), places.end());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Place first{sheets.empty() ? 0 : sheets[t], triangles[t][k], 0};
        const auto place = std::lower_bound(places.begin(), places.end(), first);
        if (place != places.end() && (*place)[0] == first[0] && (*place)[1] == first[1])
          of_triangle_[t].at_corner[k] = (*place)[2];
      }
  }

  bool is_empty() const { return of_triangle_.empty(); }

  // Whether a side of a triangle is on a rim.
  bool has(std::size_t triangle, int side) const { return !is_empty() && of_triangle_[triangle].sides[side]; }

  // A triangle of the sheet with a side in the rim that the point is on, or none.
  int triangle_at(const Surface_point& p) const
  {
    if (is_empty())
      return none;
    const Of_triangle& of = of_triangle_[p.triangle];
    int away = 0, last_away = 0, last_near = 0; // corners
    for (int k = 0; k < 3; ++k)
      if (p.coordinates[k] <= rounding) {
        ++away;
        last_away = k;
      }
      else
        last_near = k;
    if (away == 1)
      return of.sides[(last_away + 1) % 3] ? static_cast<int>(p.triangle) : none;
    return away == 2 ? of.at_corner[last_near] : none;
  }

  Beyond_rim beyond = Beyond_rim::PLANE;

private:
  static constexpr double rounding = 1e-9; // of barycentric coordinates

  struct Of_triangle
  {
    std::array<bool, 3> sides{};
    std::array<int, 3> at_corner{{none, none, none}}; // a triangle with a side there
  };

  std::vector<Of_triangle> of_triangle_; // none: there are no rims
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_RIMS_H
