// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From surfaces to hexahedra: numbers of cells, and places of the boundary.

#include "../Generated_surface.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Hex_mesher.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/volume.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace {

TEST(Hex_mesher, makes_about_the_number_of_hexahedra_that_is_wanted)
{
  const Reference_input surface = surface_of(cylinder(8), .5);
  for (std::size_t number : {500, 2000}) {
    Meshing_parameters parameters;
    parameters.number_of_hexahedra = number;
    const Hex_mesher mesher(surface, parameters);
    EXPECT_NEAR(double(mesher.mesh.hexahedra.size()), double(number), .25 * double(number));
    EXPECT_TRUE(mesher.has_topology_of_surface);
    EXPECT_TRUE(mesher.thin_triangles.empty());
  }
}

TEST(Hex_mesher, starts_with_the_boundary_on_the_surface_and_vertices_at_all_corners)
{
  const Reference_input surface = surface_of(block(2), .6);
  Meshing_parameters parameters;
  parameters.number_of_hexahedra = 1000;
  const Hex_mesher mesher(surface, parameters);
  const Hexahedral_complex complex(mesher.mesh.points.size(), mesher.mesh.hexahedra);
  const Triangle_surface tree(surface.points, surface.triangles);
  std::size_t at_corners = 0;
  const Positions corners = surface_of(block(1), .6).points;
  for (std::size_t v = 0; v < mesher.mesh.points.size(); ++v)
    if (complex.is_on_boundary[v]) {
      const Vector_3& p = mesher.mesh.points[v];
      EXPECT_NEAR((tree.closest_point(p).point - p).norm(), 0, 1e-9);
      for (const Vector_3& corner : corners)
        at_corners += (corner - p).norm() < 1e-9;
    }
  EXPECT_EQ(at_corners, 8u);
}

TEST(Hex_mesher, makes_more_where_parts_are_thin_or_says_so)
{
  const Reference_input plate = surface_of(Generated_mesh([](auto& p, auto& h) {
    CGAL::Hex_mesh_optimization::make_block(p, h, {{4, 4, 1}}, {{4, 4, .25}});
  }));
  Meshing_parameters parameters;
  parameters.number_of_hexahedra = 250;
  parameters.minimum_cells_across = 2;
  const Hex_mesher mesher(plate, parameters);
  EXPECT_GT(mesher.mesh.hexahedra.size(), 1000u);
  EXPECT_TRUE(mesher.thin_triangles.empty());

  parameters.spacing = .25;
  EXPECT_FALSE(Hex_mesher(plate, parameters).thin_triangles.empty());
}

// A box with walls of a hundredth of its length, closed all around.
TEST(Hex_mesher, makes_one_layer_of_a_thin_shell)
{
  Reference_input shell = surface_of(block(2));
  const int n = static_cast<int>(shell.points.size());
  const Reference_input outer = shell;
  for (const Vector_3& p : outer.points)
    shell.points.push_back(Vector_3::Constant(.01) + .98 * p);
  for (const Triangle_indices& t : outer.triangles)
    shell.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
  Meshing_parameters parameters;
  parameters.number_of_hexahedra = 1000;
  const Hex_mesher mesher(shell, parameters);
  EXPECT_TRUE(mesher.has_topology_of_surface);
  EXPECT_NEAR(double(mesher.mesh.hexahedra.size()), 1000, 300);
  double sum = 0;
  for (const Hexahedron& h : mesher.mesh.hexahedra) {
    Vector_3 corners[8];
    for (int c = 0; c < 8; ++c)
      corners[c] = mesher.mesh.points[h[c]];
    sum += volume(corners);
  }
  EXPECT_NEAR(sum, 1 - std::pow(.98, 3), 1e-6);
}

} // namespace
