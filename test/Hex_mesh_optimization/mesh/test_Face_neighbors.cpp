// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces are paired whatever the orientation of their hexahedra, and what is no pair is told apart.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/orientation.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace {

int count(const Face_neighbors& neighbors, int value)
{
  int sum = 0;
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    sum += neighbors.opposite(side) == value;
  return sum;
}

TEST(Face_neighbors, of_a_block)
{
  const Block block(3, 2, 4);
  const Face_neighbors neighbors(block.hexahedra);
  EXPECT_EQ(neighbors.number_of_sides(), 6 * 24);
  EXPECT_EQ(count(neighbors, Face_neighbors::ALONE), 2 * (6 + 12 + 8));
  EXPECT_EQ(count(neighbors, Face_neighbors::UNSOUND), 0);
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    if (neighbors.opposite(side) >= 0) {
      EXPECT_EQ(neighbors.opposite(neighbors.opposite(side)), side);
      EXPECT_TRUE(neighbors.is_agreed(side));
    }
}

TEST(Face_neighbors, of_a_mirrored_hexahedron_are_the_same_and_not_agreed)
{
  Block block(3, 1, 1);
  block.hexahedra[1] = turned(block.hexahedra[1]);
  const Face_neighbors neighbors(block.hexahedra);
  int not_agreed = 0;
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    not_agreed += neighbors.opposite(side) >= 0 && !neighbors.is_agreed(side);
  EXPECT_EQ(not_agreed, 4);
  EXPECT_EQ(count(neighbors, Face_neighbors::ALONE), 14);
}

TEST(Face_neighbors, of_three_hexahedra_and_of_crossed_corners_are_unsound)
{
  Block block(2, 1, 1);
  block.hexahedra.push_back(block.hexahedra[0]);
  EXPECT_EQ(count(Face_neighbors(block.hexahedra), Face_neighbors::UNSOUND), 3); // the others are in pairs
  block.hexahedra.pop_back();
  std::swap(block.hexahedra[0][1], block.hexahedra[0][2]); // on the face that they share
  EXPECT_EQ(count(Face_neighbors(block.hexahedra), Face_neighbors::UNSOUND), 2);
}

} // namespace
