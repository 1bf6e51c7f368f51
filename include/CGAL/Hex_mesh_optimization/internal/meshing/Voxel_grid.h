// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A rectilinear grid of cells in a box, each inside or outside of something, with one layer of cells around the box that
// are always outside, so that every cell of the box has all of its neighbors.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Voxel_grid
{
public:
  // The planes between cells across each axis, in increasing order, the two at the ends of the box included.
  explicit Voxel_grid(std::array<std::vector<double>, 3> planes) : planes_(std::move(planes))
  {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i + 1 < planes_[d].size(); ++i)
        centers_[d].push_back((planes_[d][i] + planes_[d][i + 1]) / 2);
    strides_ = {1, std::size_t(cells(0)) + 2, (std::size_t(cells(0)) + 2) * (std::size_t(cells(1)) + 2)};
    is_inside.assign(strides_[2] * (std::size_t(cells(2)) + 2), false);
  }

  // Divides the box evenly along each axis, into cells that are about as long as the spacing.
  Voxel_grid(const Eigen::AlignedBox3d& box, double spacing)
    : Voxel_grid({divided(box.min()[0], box.max()[0], spacing), divided(box.min()[1], box.max()[1], spacing),
                  divided(box.min()[2], box.max()[2], spacing)})
  {}

  // The interval, evenly.
  static std::vector<double> divided(double low, double high, double spacing)
  {
    const int n = (std::max)(1, static_cast<int>(std::lround((high - low) / spacing)));
    std::vector<double> result;
    for (int i = 0; i < n; ++i)
      result.push_back(low + (high - low) / n * i);
    result.push_back(high);
    return result;
  }

  // Along the axis, without the layer around.
  int cells(int axis) const { return static_cast<int>(centers_[axis].size()); }
  double mean_spacing() const
  {
    double product = 1;
    for (int d = 0; d < 3; ++d)
      product *= (planes_[d].back() - planes_[d].front()) / cells(d);
    return std::cbrt(product);
  }
  double least_spacing() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& planes : planes_)
      for (std::size_t i = 0; i + 1 < planes.size(); ++i)
        least = (std::min)(least, planes[i + 1] - planes[i]);
    return least;
  }
  std::size_t stride(int axis) const { return strides_[axis]; }

  // Of the cell in column i, row j, layer k of the box, from -1 to the number of cells.
  std::size_t index(int i, int j, int k) const
  {
    return std::size_t(i + 1) + strides_[1] * std::size_t(j + 1) + strides_[2] * std::size_t(k + 1);
  }

  std::array<int, 3> place(std::size_t cell) const
  {
    return {static_cast<int>(cell % strides_[1]) - 1, static_cast<int>(cell % strides_[2] / strides_[1]) - 1,
            static_cast<int>(cell / strides_[2]) - 1};
  }

  bool is_in_box(std::size_t cell) const
  {
    const std::array<int, 3> p = place(cell);
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < cells(0) && p[1] < cells(1) && p[2] < cells(2);
  }

  // That a point is in; outside of the box, the nearest one of the layer around.
  std::size_t cell_of(const Vector_3& p) const
  {
    std::array<int, 3> place;
    for (int d = 0; d < 3; ++d)
      place[d] = static_cast<int>(std::upper_bound(planes_[d].begin(), planes_[d].end(), p[d]) - planes_[d].begin()) -
                 1;
    return index(place[0], place[1], place[2]);
  }

  // Of the box.
  double center(int axis, int i) const { return centers_[axis][i]; }
  const std::vector<double>& centers(int axis) const { return centers_[axis]; }
  Vector_3 center(std::size_t cell) const
  {
    const std::array<int, 3> p = place(cell);
    return {center(0, p[0]), center(1, p[1]), center(2, p[2])};
  }

  // The node at the lower end of all axes of a cell.
  Vector_3 node(const std::array<int, 3>& place) const
  {
    return {planes_[0][place[0]], planes_[1][place[1]], planes_[2][place[2]]};
  }

  std::size_t number_inside() const
  {
    return static_cast<std::size_t>(std::count(is_inside.begin(), is_inside.end(), char(true)));
  }

  std::vector<char> is_inside; // of each cell; never of the layer around

private:
  std::array<std::vector<double>, 3> planes_, centers_;
  std::array<std::size_t, 3> strides_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H
