// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H

// A regular grid of cells in a box, each inside or outside of something, with one layer of cells around the box that
// are always outside, so that every cell of the box has all of its neighbors.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Voxel_grid
{
public:
  // Divides the box evenly along each axis, into cells that are about as long as the spacing.
  Voxel_grid(const Eigen::AlignedBox3d& box, double spacing) : origin_(box.min())
  {
    for (int d = 0; d < 3; ++d) {
      const double length = box.sizes()[d];
      cells_[d] = (std::max)(1, static_cast<int>(std::lround(length / spacing)));
      spacing_[d] = length / cells_[d];
    }
    strides_ = {1, std::size_t(cells_[0]) + 2, (std::size_t(cells_[0]) + 2) * (std::size_t(cells_[1]) + 2)};
    is_inside.assign(strides_[2] * (std::size_t(cells_[2]) + 2), false);
  }

  // Along the axis, without the layer around.
  int cells(int axis) const { return cells_[axis]; }
  const Vector_3& spacing() const { return spacing_; }
  double mean_spacing() const { return std::cbrt(spacing_[0] * spacing_[1] * spacing_[2]); }
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
    return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < cells_[0] && p[1] < cells_[1] && p[2] < cells_[2];
  }

  // That a point is in; outside of the box, the nearest one of the layer around.
  std::size_t cell_of(const Vector_3& p) const
  {
    std::array<int, 3> place;
    for (int d = 0; d < 3; ++d)
      place[d] = static_cast<int>(
        (std::min)((std::max)(std::floor((p[d] - origin_[d]) / spacing_[d]), -1.0), double(cells_[d])));
    return index(place[0], place[1], place[2]);
  }

  double center(int axis, int i) const { return origin_[axis] + (i + .5) * spacing_[axis]; }
  Vector_3 center(std::size_t cell) const
  {
    const std::array<int, 3> p = place(cell);
    return {center(0, p[0]), center(1, p[1]), center(2, p[2])};
  }

  // The node at the lower end of all axes of a cell.
  Vector_3 node(const std::array<int, 3>& place) const
  {
    return origin_ + spacing_.cwiseProduct(Vector_3(place[0], place[1], place[2]));
  }

  std::size_t number_inside() const
  {
    return static_cast<std::size_t>(std::count(is_inside.begin(), is_inside.end(), char(true)));
  }

  std::vector<char> is_inside; // of each cell; never of the layer around

private:
  Vector_3 origin_, spacing_;
  std::array<int, 3> cells_;
  std::array<std::size_t, 3> strides_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_VOXEL_GRID_H
