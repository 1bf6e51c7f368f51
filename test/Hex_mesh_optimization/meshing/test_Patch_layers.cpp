// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Labels of the boundary, and the layers that patches get.

#include "../Generated_surface.h"
#include "../manifold_boundary.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_labels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Patch_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace {

// A surface in units of cells, and the labelled cells inside.
struct Labelled
{
  const Reference_input surface;
  const Surface_partition partition;
  Hexahedra mesh;

  Labelled(const Generated_mesh& generated, double turn, double spacing)
    : surface(scaled(surface_of(generated, turn), spacing))
    , partition(surface.points, surface.triangles, sharp_edges(surface.points, surface.triangles, 45), false, {})
    , mesh(voxel_hexahedra(solid_voxels(Triangle_surface(surface.points, surface.triangles),
                                        wall_distances(surface.points, surface.triangles, 1),
                                        even_grid(Triangle_surface(surface.points, surface.triangles), 1))))
  {
    const Boundary_fans fans(mesh, opposite_sides(mesh));
    const Boundary_labels labels(mesh, fans, partition);
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      mesh.label[fans.sides[f]] = labels.labels[f];
  }

  static Reference_input scaled(Reference_input surface, double spacing)
  {
    for (Vector_3& p : surface.points)
      p /= spacing;
    return surface;
  }

  // Of each label, in how many pieces its faces hang together.
  std::map<int, int> pieces() const
  {
    const Boundary_fans fans(mesh, opposite_sides(mesh));
    Disjoint_sets sets(fans.sides.size());
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      for (int g : fans.neighbors[f])
        if (mesh.label[fans.sides[f]] == mesh.label[fans.sides[g]])
          sets.unite(f, g);
    std::map<int, int> result;
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      result[mesh.label[fans.sides[f]]] += sets.find(f) == f;
    return result;
  }
};

TEST(Surface_partition, knows_patches_borders_and_corners)
{
  const Labelled cube(block(2), .7, .2);
  EXPECT_EQ(cube.partition.number_of_patches(), 6u);
  EXPECT_EQ(cube.partition.borders().size(), 12u);
  for (const auto& border : cube.partition.borders())
    EXPECT_NEAR(border.second.angle, 90, 1e-6);
  const Labelled l(l_shape(2), .7, .2);
  EXPECT_EQ(std::count_if(l.partition.borders().begin(), l.partition.borders().end(),
                          [](const auto& border) { return border.second.angle > 180; }),
            1);
}

TEST(Boundary_labels, have_every_patch_in_one_piece)
{
  for (const Generated_mesh& mesh : {block(2), l_shape(2), cylinder(6)})
    for (double turn : {0., .3, 1.}) {
      const Labelled labelled(mesh, turn, .15);
      const std::map<int, int> pieces = labelled.pieces();
      EXPECT_EQ(pieces.size(), labelled.partition.number_of_patches()) << turn;
      for (const auto& piece : pieces)
        EXPECT_EQ(piece.second, 1) << turn;
    }
}

TEST(Patch_layers, are_none_where_cells_fit)
{
  for (const Generated_mesh& mesh : {block(2), l_shape(2)}) {
    Labelled labelled(mesh, 0, .2);
    const std::size_t n = labelled.mesh.hexahedra.size();
    Patch_layers(labelled.mesh, labelled.partition, {});
    EXPECT_EQ(labelled.mesh.hexahedra.size(), n);
  }
}

// Then no face of the boundary shares its patch with another one of the same hexahedron, and at a convex edge
// there is one hexahedron.
TEST(Patch_layers, give_each_hexahedron_one_face_of_a_patch)
{
  for (double turn : {.3, 1.}) {
    Labelled labelled(block(2), turn, .15);
    Patch_layers(labelled.mesh, labelled.partition, {});
    const std::vector<std::ptrdiff_t> opposite = opposite_sides(labelled.mesh);
    EXPECT_TRUE(has_manifold_boundary(labelled.mesh));
    std::set<std::array<std::size_t, 2>> seen;
    for (std::size_t side = 0; side < opposite.size(); ++side) {
      EXPECT_EQ(opposite[side] < 0, labelled.mesh.label[side] != Hexahedra::no_label);
      if (opposite[side] < 0) {
        EXPECT_TRUE(seen.insert({side / 6, std::size_t(labelled.mesh.label[side])}).second);
      }
    }
    const Boundary_fans fans(labelled.mesh, opposite);
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      for (int g : fans.neighbors[f])
        if (labelled.mesh.label[fans.sides[f]] != labelled.mesh.label[fans.sides[g]]) {
          EXPECT_EQ(fans.sides[f] / 6, fans.sides[g] / 6);
        }
  }
}

} // namespace
