// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Walls between the centers of cells.

#include <CGAL/Hex_mesh_optimization/internal/meshing/thin_walls.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using namespace CGAL::Hex_mesh_optimization::internal;

namespace {

Voxel_grid empty_grid() { return Voxel_grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Constant(4)), 1); }

// Across the z axis, its lower side at height z.
std::vector<Wall_distance> wall(double z, double thickness)
{
  std::vector<Wall_distance> result;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      result.push_back({Vector_3(i + .5, j + .5, z), Vector_3(0, 0, 1), std::size_t(4 * i + j), 1, thickness});
  return result;
}

TEST(thin_walls, keep_the_cells_in_their_middle)
{
  Voxel_grid grid = empty_grid();
  keep_thin_walls(wall(1.6, .6), .25, grid);
  EXPECT_EQ(grid.number_inside(), 16u);
  EXPECT_TRUE(grid.is_inside[grid.index(2, 2, 1)]);
}

TEST(thin_walls, are_lost_where_they_are_much_thinner_than_a_cell)
{
  Voxel_grid grid = empty_grid();
  keep_thin_walls(wall(1.6, .2), .25, grid);
  EXPECT_EQ(grid.number_inside(), 0u);
  EXPECT_EQ(thin_triangles(wall(1.6, .2), grid, 1).size(), 16u);
  EXPECT_EQ(lost_part(wall(1.6, .2), grid), 1);
  grid.is_inside[grid.index(2, 2, 1)] = true;
  EXPECT_EQ(lost_part(wall(1.6, .2), grid), 15. / 16);
}

TEST(thin_walls, leave_gaps_between_them_open_that_are_not_much_narrower_than_a_cell)
{
  for (double width : {.6, .2}) {
    Voxel_grid grid = empty_grid();
    for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
      grid.is_inside[cell] = grid.is_in_box(cell);
    EXPECT_TRUE(is_gap_closed(wall(1.6, width)[0], grid));
    keep_gaps(wall(1.6, width), .25, grid);
    EXPECT_EQ(grid.number_inside(), width > .25 ? 48u : 64u);
    EXPECT_EQ(grid.is_inside[grid.index(2, 2, 1)] != 0, width < .25);
    EXPECT_EQ(is_gap_closed(wall(1.6, width)[0], grid), width < .25);
  }
}

TEST(thin_walls, are_those_with_fewer_cells_behind_them_than_wanted)
{
  Voxel_grid grid = empty_grid();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 1; k < (i < 2 ? 2 : 3); ++k)
        grid.is_inside[grid.index(i, j, k)] = true;
  EXPECT_TRUE(thin_triangles(wall(1, 2), grid, 1).empty());
  EXPECT_EQ(thin_triangles(wall(1, 2), grid, 2), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
}

} // namespace
