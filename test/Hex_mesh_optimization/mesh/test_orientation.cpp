// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Hexahedra that are connected through faces come to agree, the right way out, whichever are given inside out.

#include <CGAL/Hex_mesh_optimization/internal/mesh/orientation.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

using Turns = std::vector<char>;

Turns turns(const Positions& points, const std::vector<Hexahedron>& hexahedra)
{
  return Orientation(points, hexahedra, Face_neighbors(hexahedra)).is_turned();
}

TEST(Orientation, of_any_hexahedra_inside_out_is_found)
{
  std::mt19937 random(1);
  for (int share = 0; share <= 4; ++share)
    for (int trial = 0; trial < 10; ++trial) {
      Block block(3, 2, 3);
      for (Vector_3& p : block.points)
        for (int d = 0; d < 3; ++d)
          p[d] += 1e-3 * double(random() % 100);
      Turns expected(block.hexahedra.size());
      for (std::size_t h = 0; h < expected.size(); ++h)
        if (int(random() % 4) < share) {
          expected[h] = true;
          block.hexahedra[h] = turned(block.hexahedra[h]);
        }
      EXPECT_EQ(turns(block.points, block.hexahedra), expected);
    }
}

// Only the boundary decides.
TEST(Orientation, does_not_depend_on_a_tangled_interior)
{
  Block block(3, 3, 3);
  for (int i : {1, 2})
    for (int j : {1, 2})
      for (int k : {1, 2})
        block.points[block.vertex(i, j, k)] = Vector_3(100 * i, -70 * j, 1000);
  EXPECT_EQ(turns(block.points, block.hexahedra), Turns(27, false));
  for (Hexahedron& h : block.hexahedra)
    h = turned(h);
  EXPECT_EQ(turns(block.points, block.hexahedra), Turns(27, true));
}

TEST(Orientation, is_decided_for_each_component)
{
  Block large(3, 3, 3);
  const Block small(1, 1, 2);
  const int n = int(large.points.size());
  for (const Vector_3& p : small.points)
    large.points.push_back(p + Vector_3(9, 9, 9));
  Turns expected(29, false);
  for (Hexahedron h : small.hexahedra) {
    for (int& v : h)
      v += n;
    large.hexahedra.push_back(turned(h));
  }
  expected[27] = expected[28] = true;
  EXPECT_EQ(turns(large.points, large.hexahedra), expected);
}

// A component that encloses nothing: the corners decide, and where they do not, it stays.
TEST(Orientation, without_a_volume_is_that_of_most_corners)
{
  Block block(1, 1, 1);
  for (Vector_3& p : block.points)
    p[2] = 0;
  EXPECT_EQ(turns(block.points, block.hexahedra), Turns(1, false));
  block.hexahedra[0] = turned(block.hexahedra[0]);
  EXPECT_EQ(turns(block.points, block.hexahedra), Turns(1, false));

  // as much below the bottom as above
  block = Block(1, 1, 1);
  block.points[block.vertex(0, 0, 1)][2] = -3;
  const Turns upright = turns(block.points, block.hexahedra);
  block.hexahedra[0] = turned(block.hexahedra[0]);
  EXPECT_NE(turns(block.points, block.hexahedra), upright);
}

// A ring of n hexahedra; the last is joined to the first with the two rows of its corners exchanged if it is twisted.
struct Ring
{
  Positions points;
  std::vector<Hexahedron> hexahedra;

  Ring(int n, bool is_twisted)
  {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * 3.14159265358979 * i / n;
      for (const double r : {2., 3.})
        for (const double z : {0., 1.})
          points.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
    for (int i = 0; i < n; ++i) {
      const int a = 4 * i, b = 4 * ((i + 1) % n);
      // the corners of the end: inner below, outer below, inner above, outer above
      int end[4] = {b, b + 2, b + 1, b + 3};
      if (is_twisted && i + 1 == n) {
        std::swap(end[0], end[1]);
        std::swap(end[2], end[3]);
      }
      hexahedra.push_back({a, a + 2, end[1], end[0], a + 1, a + 3, end[3], end[2]});
    }
  }
};

TEST(Orientation, of_a_ring_is_refused_by_name_where_it_is_twisted)
{
  const Ring ring(6, false);
  EXPECT_EQ(turns(ring.points, ring.hexahedra), Turns(6, false));
  const Ring moebius(6, true);
  try {
    turns(moebius.points, moebius.hexahedra);
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const CGAL::Hex_mesh_optimization::Input_error& error) {
    EXPECT_EQ(int(error.element()), int(CGAL::Hex_mesh_optimization::Input_error::Element::HEXAHEDRON));
    EXPECT_EQ(error.element_index(), 3u) << error.message(); // opposite the first, from which it is reached twice
    EXPECT_NE(error.message().find("hexahedra 2 and 3"), std::string::npos) << error.message();
  }
}

} // namespace
