// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells inside a surface, also where rows of cells run through its edges and vertices.

#include "../Generated_surface.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/inside_voxels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

Eigen::AlignedBox3d box(double low, double high)
{
  return Eigen::AlignedBox3d(Vector_3::Constant(low), Vector_3::Constant(high));
}

// A cube whose diagonals and edges are all met by rows of centers.
TEST(inside_voxels, are_those_of_a_cube_whose_edges_rows_meet)
{
  const Reference_input cube = surface_of(block(2));
  Voxel_grid grid(box(-.5, 1.5), .25);
  ASSERT_EQ(grid.cells(0), 8);
  Positions moved = cube.points;
  for (Vector_3& p : moved) // the faces of the cube run through centers of cells
    p += Vector_3::Constant(.125);
  fill_inside(moved, cube.triangles, grid);
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell) {
    if (!grid.is_in_box(cell))
      continue;
    const Vector_3 c = grid.center(cell);
    if ((c.array() > .13).all() && (c.array() < 1.12).all()) {
      EXPECT_TRUE(grid.is_inside[cell]) << c.transpose();
    }
    if ((c.array() < .12).any() || (c.array() > 1.13).any()) {
      EXPECT_FALSE(grid.is_inside[cell]) << c.transpose();
    }
  }
}

TEST(inside_voxels, are_nearer_to_the_center_of_a_ball_than_its_surface)
{
  const Generated_mesh ball([](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_ball(p, h, 8); });
  const Reference_input surface = surface_of(ball, .3);
  Voxel_grid grid(box(-1.1, 1.1), .1);
  fill_inside(surface.points, surface.triangles, grid);
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell) {
    if (!grid.is_in_box(cell))
      continue;
    const double radius = grid.center(cell).norm();
    if (radius < .96 || radius > 1) {
      EXPECT_EQ(bool(grid.is_inside[cell]), radius < .96) << radius;
    }
  }
}

TEST(inside_voxels, leave_out_what_a_component_within_cuts_out)
{
  Reference_input surface = surface_of(block(1));
  const std::size_t n = surface.points.size(), m = surface.triangles.size();
  for (std::size_t v = 0; v < n; ++v)
    surface.points.push_back(Vector_3::Constant(.25) + surface.points[v] / 2);
  for (std::size_t t = 0; t < m; ++t) {
    Triangle_indices inner = surface.triangles[t];
    for (int& v : inner)
      v += static_cast<int>(n);
    std::swap(inner[0], inner[1]);
    surface.triangles.push_back(inner);
  }
  Voxel_grid grid(box(0, 1), .125);
  fill_inside(surface.points, surface.triangles, grid);
  EXPECT_EQ(grid.number_inside(), 512u - 64u);
}

} // namespace
