// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cells that stand for a solid: a manifold, in as many pieces, with its holes.

#include "../Generated_surface.h"
#include "../manifold_boundary.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>

#include <gtest/gtest.h>

#include <cstddef>

namespace {

Voxel_grid voxels(const Reference_input& surface, double spacing)
{
  const Triangle_surface solid(surface.points, surface.triangles);
  return solid_voxels(solid, wall_distances(surface.points, surface.triangles, spacing), even_grid(solid, spacing));
}

TEST(solid_voxels, divide_a_box_evenly)
{
  const Voxel_grid grid = voxels(surface_of(block(2)), .13);
  EXPECT_EQ(grid.number_inside(), 512u);
  EXPECT_DOUBLE_EQ(grid.mean_spacing(), .125);
}

TEST(solid_voxels, have_the_topology_of_the_surface)
{
  const Generated_mesh ring([](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_ring(p, h, 24, 2); });
  for (const Generated_mesh& mesh : {block(2), l_shape(2), cylinder(4), ring})
    for (double turn : {0., .4, 1.1}) {
      const Reference_input surface = surface_of(mesh, turn);
      const Voxel_grid grid = voxels(surface, .21);
      EXPECT_EQ(euler_characteristic(grid), euler_characteristic(surface.triangles)) << turn;
      EXPECT_TRUE(has_manifold_boundary(voxel_hexahedra(grid))) << turn;
    }
}

TEST(solid_voxels, have_no_crumbs_but_all_components)
{
  Reference_input two = surface_of(block(1));
  const Reference_input other = surface_of(l_shape(1));
  const int n = static_cast<int>(two.points.size());
  for (const Vector_3& p : other.points)
    two.points.push_back(p + Vector_3(5, 0, 0));
  for (Triangle_indices t : other.triangles) {
    for (int& v : t)
      v += n;
    two.triangles.push_back(t);
  }
  EXPECT_EQ(euler_characteristic(voxels(two, .25)), 4);

  const Triangle_surface cube(surface_of(block(1)).points, surface_of(block(1)).triangles);
  Voxel_grid grid(Eigen::AlignedBox3d(Vector_3::Zero(), Vector_3::Ones()), .125);
  grid.is_inside[grid.index(0, 0, 0)] = grid.is_inside[grid.index(0, 1, 0)] = true;
  grid.is_inside[grid.index(5, 5, 5)] = true;
  drop_crumbs(grid, cube);
  EXPECT_EQ(grid.number_inside(), 2u);
}

TEST(solid_voxels, are_not_too_many)
{
  EXPECT_THROW(voxels(surface_of(block(1)), 1e-4), CGAL::Hex_mesh_optimization::Input_error);
}

} // namespace
