// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The thickness of blocks behind each of their faces, with edges that tell the directions apart.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Solid_thickness.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr double heights[3] = {1, 10, 100}; // of a cube, along each axis
constexpr double far = 1e6;

// The axis along which all vertices of a face agree, or both ends of an edge do not
template <std::size_t N>
int axis_of(const Block& block, const std::array<int, N>& vertices)
{
  for (int axis = 0; axis < 3; ++axis) {
    bool agree = true;
    for (int v : vertices)
      agree = agree && block.points[v][axis] == block.points[vertices[0]][axis];
    if (agree == (N == 4))
      return axis;
  }
  return -1;
}

std::vector<double> lengths(const Block& block, const Hexahedral_complex& complex)
{
  std::vector<double> result;
  for (const std::array<int, 2>& e : complex.edges)
    result.push_back(heights[axis_of(block, e)]);
  return result;
}

TEST(Solid_thickness, reaches_to_the_opposite_face)
{
  const Block block(2, 3, 4);
  const Hexahedral_complex complex = block.complex();
  const std::vector<double> edges = lengths(block, complex);
  const Solid_thickness thickness(complex, edges);
  const double expected[3] = {2 * heights[0], 3 * heights[1], 4 * heights[2]};
  for (const auto& f : complex.boundary_faces)
    EXPECT_DOUBLE_EQ(thickness.at(f, far), expected[axis_of(block, f.vertices)]);
}

TEST(Solid_thickness, is_not_measured_farther_than_most)
{
  const Block block(2, 3, 4);
  const Hexahedral_complex complex = block.complex();
  const std::vector<double> edges = lengths(block, complex);
  const Solid_thickness thickness(complex, edges);
  for (const auto& f : complex.boundary_faces)
    EXPECT_DOUBLE_EQ(thickness.at(f, 1.5), 1.5);
}

// Of three layers of cubes, one above and two below an interface, all that is above or beside it is one thick.
TEST(Solid_thickness, ends_at_interfaces)
{
  const Block block(2, 2, 3);
  std::vector<int> labels(block.hexahedra.size(), 0);
  for (std::size_t h = 0; h < labels.size(); ++h)
    labels[h] = h >= 8;
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {labels, {}});
  const std::vector<double> edges = lengths(block, complex);
  const Solid_thickness thickness(complex, edges);
  std::size_t interfaces = 0;
  for (const auto& f : complex.boundary_faces)
    if (axis_of(block, f.vertices) == 2) {
      const double z = block.points[f.vertices[0]].z();
      EXPECT_DOUBLE_EQ(thickness.at(f, far), heights[2] * (z == 0 ? 2 : 1)) << "at " << z;
      interfaces += z == 2;
    }
  EXPECT_EQ(interfaces, 4u);
}

} // namespace
