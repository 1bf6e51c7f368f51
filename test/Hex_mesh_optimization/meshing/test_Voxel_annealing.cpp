// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fewer irregular vertices, with the topology and the thickness that there were.

#include "../manifold_boundary.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_annealing.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace CGAL::Hex_mesh_optimization::internal;

namespace {

constexpr int n = 20;
const Vector_3 middle = Vector_3::Constant(n / 2.) + Vector_3(.13, -.21, .08);

double to_ball(const Vector_3& p) { return (p - middle).norm() - 8.2; }
double to_torus(const Vector_3& p)
{
  const Vector_3 d = p - middle;
  return std::hypot(std::hypot(d[0], d[1]) - 6, d[2]) - 3;
}
double to_slope(const Vector_3& p) { return (p - middle).dot(Vector_3(.3, .2, 1).normalized()); }

// signed_distance: negative inside
Voxel_grid voxels_of(double (*signed_distance)(const Vector_3&))
{
  Voxel_grid grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Constant(n)), 1);
  for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell)
    grid.is_inside[cell] = grid.is_in_box(cell) && signed_distance(grid.center(cell)) < 0;
  Manifold_voxels(grid, [](std::size_t) { return 1.0; });
  return grid;
}

// How many faces more or less than four the vertices of the boundary have, in all
int irregularity(const Voxel_grid& grid)
{
  const Node_patterns patterns;
  int sum = 0;
  for (int k = 0; k <= grid.cells(2); ++k)
    for (int j = 0; j <= grid.cells(1); ++j)
      for (int i = 0; i <= grid.cells(0); ++i)
        sum += patterns.irregularity(pattern_at(grid, grid.index(i, j, k)));
  return sum;
}

void anneal(Voxel_grid& grid, double (*signed_distance)(const Vector_3&))
{
  Voxel_annealing(
    grid, [&](std::size_t cell) { return std::abs(signed_distance(grid.center(cell))); }, Annealing_parameters());
}

TEST(Voxel_annealing, leaves_a_manifold_of_the_same_topology_with_fewer_irregular_vertices)
{
  for (double (*shape)(const Vector_3&) : {to_ball, to_torus, to_slope}) {
    Voxel_grid grid = voxels_of(shape);
    const int before = irregularity(grid);
    const std::ptrdiff_t topology = euler_characteristic(grid);
    anneal(grid, shape);
    EXPECT_LT(irregularity(grid), .8 * before);
    EXPECT_EQ(euler_characteristic(grid), topology);
    EXPECT_TRUE(test::has_manifold_boundary(voxel_hexahedra(grid)));
  }
}

TEST(Voxel_annealing, changes_no_cell_whose_center_is_far_from_the_surface)
{
  Voxel_grid grid = voxels_of(to_ball);
  const std::vector<char> before = grid.is_inside;
  anneal(grid, to_ball);
  std::size_t changed = 0;
  for (std::size_t cell = 0; cell < before.size(); ++cell)
    if (grid.is_inside[cell] != before[cell]) {
      ++changed;
      EXPECT_LE(std::abs(to_ball(grid.center(cell))), Annealing_parameters().most_distance);
    }
  EXPECT_GT(changed, 0u);
}

TEST(Voxel_annealing, takes_a_lone_step_away)
{
  Voxel_grid grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Constant(6)), 1);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k)
        grid.is_inside[grid.index(i, j, k)] = true;
  const std::vector<char> flat = grid.is_inside;
  grid.is_inside[grid.index(2, 3, 3)] = true;
  Voxel_annealing(
    grid, [&](std::size_t cell) { return cell == grid.index(2, 3, 3) ? .2 : .5; }, Annealing_parameters());
  EXPECT_EQ(grid.is_inside, flat);
}

TEST(Voxel_annealing, keeps_walls_and_gaps_of_one_cell)
{
  for (bool is_wall : {true, false}) {
    Voxel_grid grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Constant(7)), 1);
    for (std::size_t cell = 0; cell < grid.is_inside.size(); ++cell) {
      const std::array<int, 3> p = grid.place(cell);
      const bool is_at_plate = p[2] == 3 && p[0] > 0 && p[0] < 6 && p[1] > 0 && p[1] < 5;
      grid.is_inside[cell] = grid.is_in_box(cell) && is_at_plate == is_wall;
    }
    const std::vector<char> before = grid.is_inside;
    Voxel_annealing(
      grid, [](std::size_t) { return .1; }, Annealing_parameters());
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < 7; ++j) {
        const std::size_t cell = grid.index(i, j, 3);
        if (bool(before[cell]) == is_wall) {
          EXPECT_EQ(bool(grid.is_inside[cell]), is_wall) << i << ' ' << j;
        }
      }
  }
}

TEST(Voxel_annealing, does_the_same_each_time)
{
  Voxel_grid first = voxels_of(to_torus), second = first;
  anneal(first, to_torus);
  anneal(second, to_torus);
  EXPECT_EQ(first.is_inside, second.is_inside);
}

} // namespace
