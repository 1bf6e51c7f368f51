// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Contacts in edges and vertices are removed, with few changes.

#include "../manifold_boundary.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Manifold_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

using namespace CGAL::Hex_mesh_optimization::internal;

namespace {

Voxel_grid empty_grid(int n) { return Voxel_grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Constant(n)), 1); }

bool is_manifold(const Voxel_grid& grid) { return test::has_manifold_boundary(voxel_hexahedra(grid)); }

std::size_t changes(Voxel_grid& grid)
{
  const Manifold_voxels result(grid, [](std::size_t) { return 1.0; });
  return result.added() + result.removed();
}

TEST(Manifold_voxels, leaves_a_manifold)
{
  Voxel_grid grid = empty_grid(4);
  for (int i = 0; i < 3; ++i)
    grid.is_inside[grid.index(i, 1, 1)] = grid.is_inside[grid.index(1, i, 1)] = true;
  const std::vector<char> before = grid.is_inside;
  EXPECT_EQ(changes(grid), 0u);
  EXPECT_EQ(grid.is_inside, before);
}

TEST(Manifold_voxels, changes_one_cell_at_an_edge_and_no_more_than_two_at_a_vertex)
{
  Voxel_grid grid = empty_grid(4);
  grid.is_inside[grid.index(1, 1, 1)] = grid.is_inside[grid.index(2, 2, 1)] = true;
  EXPECT_FALSE(is_manifold(grid));
  EXPECT_EQ(changes(grid), 1u);
  EXPECT_TRUE(is_manifold(grid));

  grid = empty_grid(4);
  grid.is_inside[grid.index(1, 1, 1)] = grid.is_inside[grid.index(2, 2, 2)] = true;
  EXPECT_FALSE(is_manifold(grid));
  EXPECT_LE(changes(grid), 2u);
  EXPECT_TRUE(is_manifold(grid));
}

TEST(Manifold_voxels, makes_the_cheaper_change)
{
  Voxel_grid grid = empty_grid(4);
  grid.is_inside[grid.index(1, 1, 1)] = grid.is_inside[grid.index(2, 2, 1)] = true;
  const std::size_t cheap = grid.index(2, 1, 1);
  const Manifold_voxels result(grid, [&](std::size_t cell) { return cell == cheap ? .5 : 1.0; });
  EXPECT_EQ(result.added(), 1u);
  EXPECT_TRUE(grid.is_inside[cheap]);
}

TEST(Manifold_voxels, ends_with_a_manifold_from_any_cells)
{
  std::mt19937 random(1);
  for (int density = 1; density < 10; ++density) {
    Voxel_grid grid = empty_grid(7);
    for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
      if (grid.is_in_box(cell))
        grid.is_inside[cell] = int(random() % 10) < density;
    changes(grid);
    EXPECT_TRUE(is_manifold(grid)) << density;
  }
}

} // namespace
