// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Layers behind faces: their number, their places and their labels.

#include "../Generated_mesh.h"

#include <CGAL/Hex_mesh_optimization/internal/meshing/insert_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

namespace {

Hexahedra hexahedra_of(const Generated_mesh& mesh)
{
  return {mesh.points, mesh.complex.hexahedra, std::vector<int>(6 * mesh.complex.hexahedra.size(), -1)};
}

std::vector<char> marked_boundary(const std::vector<std::ptrdiff_t>& opposite)
{
  std::vector<char> result;
  for (std::ptrdiff_t side : opposite)
    result.push_back(side < 0);
  return result;
}

TEST(insert_layers, behind_the_boundary_one_hexahedron_for_each_face)
{
  for (const Generated_mesh& mesh : {block(3), l_shape(2), cylinder(4)}) {
    Hexahedra padded = hexahedra_of(mesh);
    const std::vector<std::ptrdiff_t> opposite = opposite_sides(padded);
    const std::vector<int> original = insert_layers(padded, opposite, marked_boundary(opposite), .3);
    EXPECT_EQ(padded.hexahedra.size(), mesh.complex.hexahedra.size() + mesh.complex.boundary_faces.size());
    EXPECT_EQ(padded.points.size(), mesh.points.size() + original.size());
    const Hexahedral_complex complex(padded.points.size(), padded.hexahedra);
    EXPECT_EQ(Mesh_quality(complex, padded.points).invalid, 0u);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      EXPECT_EQ(bool(complex.is_on_boundary[v]), bool(mesh.complex.is_on_boundary[v]));
    std::set<int> on_boundary; // each face has a hexahedron of its own
    for (const auto& face : complex.boundary_faces)
      EXPECT_TRUE(on_boundary.insert(face.hexahedron).second);
  }
}

TEST(insert_layers, stand_as_far_behind_as_they_are_thick)
{
  Hexahedra padded = hexahedra_of(block(4)); // edges of a fourth
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(padded);
  const std::size_t n = padded.points.size();
  insert_layers(padded, opposite, marked_boundary(opposite), .4);
  for (std::size_t v = n; v < padded.points.size(); ++v) {
    const Vector_3 p = padded.points[v];
    EXPECT_NEAR((std::min)(p.minCoeff(), 1 - p.maxCoeff()), .1, 1e-3);
  }
}

// A layer behind the top ends on the four sides, where the new faces have their labels.
TEST(insert_layers, end_on_faces_that_are_not_marked)
{
  Hexahedra mesh = hexahedra_of(block(2));
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  std::vector<char> is_marked(opposite.size(), false);
  for (std::size_t side = 0; side < opposite.size(); ++side)
    if (opposite[side] < 0) {
      mesh.label[side] = static_cast<int>(side % 6);
      is_marked[side] = side % 6 == 1; // the top
    }
  insert_layers(mesh, opposite, is_marked, .5);
  ASSERT_EQ(mesh.hexahedra.size(), 12u);
  const std::vector<std::ptrdiff_t> now = opposite_sides(mesh);
  std::vector<std::size_t> number(6, 0);
  for (std::size_t side = 0; side < now.size(); ++side) {
    EXPECT_EQ(now[side] < 0, mesh.label[side] != Hexahedra::no_label);
    if (now[side] < 0)
      ++number[mesh.label[side]];
  }
  EXPECT_EQ(number, (std::vector<std::size_t>{4, 4, 6, 6, 6, 6}));
  const Hexahedral_complex complex(mesh.points.size(), mesh.hexahedra);
  EXPECT_EQ(Mesh_quality(complex, mesh.points).invalid, 0u);
}

TEST(insert_layers, on_both_sides_of_a_face_within)
{
  Hexahedra mesh = hexahedra_of(Generated_mesh([](auto& p, auto& h) {
    CGAL::Hex_mesh_optimization::make_block(p, h, {{2, 1, 1}});
  }));
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  std::vector<char> is_marked;
  for (std::ptrdiff_t side : opposite)
    is_marked.push_back(side >= 0);
  insert_layers(mesh, opposite, is_marked, .5);
  EXPECT_EQ(mesh.hexahedra.size(), 4u);
  EXPECT_EQ(mesh.points.size(), 20u);
}

} // namespace
