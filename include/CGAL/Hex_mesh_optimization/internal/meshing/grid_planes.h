// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PLANES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PLANES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How a grid suits the flat parts of a surface: its axes, and planes between cells that lie in them.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Areas by the direction of the normal, either way, as vectors: those of directions that differ by less than about
// `resolution`, in radians, are added.
inline std::vector<Vector_3> areas_by_direction(const Positions& points, const std::vector<Triangle_indices>& triangles,
                                                double resolution)
{
  std::map<std::array<long, 3>, Vector_3> of_direction;
  for (const Triangle_indices& t : triangles) {
    Vector_3 area = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]) / 2;
    const double size = area.norm();
    if (!(size > 0))
      continue;
    // the larger half of all directions is told by the sum of unequal parts, which is not near zero for any axis
    if (area.dot(Vector_3(1, .6, .36)) < 0)
      area = -area;
    std::array<long, 3> key;
    for (int d = 0; d < 3; ++d)
      key[d] = std::lround(area[d] / (size * resolution));
    of_direction.emplace(key, Vector_3::Zero()).first->second += area;
  }
  std::vector<Vector_3> result;
  for (const auto& entry : of_direction)
    result.push_back(entry.second);
  return result;
}

// The columns are the axes of a grid that as much of the surface as possible lies along, the identity unless others suit
// notably more of it. O(n log n).
inline Matrix_3 grid_axes(const Positions& points, const std::vector<Triangle_indices>& triangles,
                          const Grid_parameters& parameters)
{
  const double degree = CGAL_PI / 180;
  const double aligned = std::cos(parameters.aligned_angle * degree);
  const std::vector<Vector_3> coarse = areas_by_direction(points, triangles, parameters.aligned_angle * degree / 2);
  double total = 0;
  for (const Vector_3& area : coarse)
    total += area.norm();
  const auto part_along = [&](const Matrix_3& axes) {
    double sum = 0;
    for (const Vector_3& area : coarse) {
      const double size = area.norm();
      if ((axes.transpose() * area).cwiseAbs().maxCoeff() > aligned * size)
        sum += size;
    }
    return sum / total;
  };

  std::vector<Vector_3> largest = areas_by_direction(points, triangles, parameters.flatness);
  const std::size_t number = (std::min)(largest.size(), parameters.number_of_candidates);
  std::partial_sort(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(number), largest.end(),
                    [](const Vector_3& a, const Vector_3& b) { return a.squaredNorm() > b.squaredNorm(); });
  largest.resize(number);
  for (Vector_3& direction : largest)
    direction.normalize();

  Matrix_3 best = Matrix_3::Identity();
  double best_part = part_along(best) + parameters.least_gain;
  const auto propose = [&](const Vector_3& first, const Vector_3& second) {
    Matrix_3 axes;
    axes.col(0) = first;
    axes.col(1) = (second - first.dot(second) * first).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    const double part = part_along(axes);
    if (part > best_part) {
      best_part = part;
      best = axes;
    }
  };
  for (std::size_t i = 0; i < largest.size(); ++i) {
    propose(largest[i], largest[i].unitOrthogonal());
    for (std::size_t j = i + 1; j < largest.size(); ++j)
      if (std::abs(largest[i].dot(largest[j])) < std::sin(parameters.aligned_angle * degree))
        propose(largest[i], largest[j]);
  }
  return best;
}

// Across each axis: the flat parts of the surface that lie across it, the largest first, unless they are too small or too
// close to others; evenly divided between, the strip between two parts into two at least, unless that is too narrow.
inline std::array<std::vector<double>, 3> grid_planes(const Positions& points,
                                                      const std::vector<Triangle_indices>& triangles,
                                                      const Eigen::AlignedBox3d& box, double spacing,
                                                      const Grid_parameters& parameters)
{
  std::array<std::vector<double>, 3> result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::pair<double, double>> flat; // place, area
    for (const Triangle_indices& t : triangles) {
      const Vector_3 area = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]) / 2;
      const double size = area.norm();
      if (size > 0 && std::abs(area[axis]) > std::cos(parameters.flatness) * size)
        flat.emplace_back((points[t[0]][axis] + points[t[1]][axis] + points[t[2]][axis]) / 3, size);
    }
    std::sort(flat.begin(), flat.end());
    std::vector<std::pair<double, double>> levels; // area, mean place
    for (std::size_t i = 0; i < flat.size();) {
      const double start = flat[i].first;
      double area = 0, sum = 0;
      for (; i < flat.size() && flat[i].first - start <= parameters.same_level * spacing; ++i) {
        area += flat[i].second;
        sum += flat[i].first * flat[i].second;
      }
      if (area >= parameters.least_flat_area * spacing * spacing)
        levels.emplace_back(area, sum / area);
    }
    std::sort(levels.rbegin(), levels.rend());

    std::vector<double> planes = {box.min()[axis], box.max()[axis]};
    for (const auto& level : levels) {
      const auto next = std::upper_bound(planes.begin(), planes.end(), level.second);
      if (next == planes.begin() || next == planes.end())
        continue;
      if ((std::min)(level.second - *(next - 1), *next - level.second) >= parameters.least_gap * spacing)
        planes.insert(next, level.second);
    }
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
      if (i > 0)
        result[axis].pop_back(); // the end of the interval before
      const double width = planes[i + 1] - planes[i];
      const bool is_strip = planes.size() > 2 && width >= parameters.least_width_of_two * spacing;
      const double part = is_strip ? (std::min)(spacing, width / 2) : spacing;
      const std::vector<double> interval = Voxel_grid::divided(planes[i], planes[i + 1], part);
      result[axis].insert(result[axis].end(), interval.begin(), interval.end());
    }
  }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_GRID_PLANES_H
