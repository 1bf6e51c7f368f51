// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cones of edges of meshes small enough to count by hand, and the normals of their triangles.

#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

TEST(Edge_cones, of_a_block_of_cubes)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  cones.update_normals(block.points);
  ASSERT_EQ(cones.size(), 108u);
  std::map<std::size_t, int> number_of_valence;
  for (int directed = 0; directed < 108; ++directed) {
    const int from = complex.source(directed), to = complex.target(directed);
    const Vector_3 axis = block.points[to] - block.points[from];
    // as many cubes as sides of the edge are inside the block
    std::size_t valence = 1;
    for (int d = 0; d < 3; ++d)
      if (axis[d] == 0 && block.points[from][d] == 1)
        valence *= 2;
    ++number_of_valence[valence];
    const Grouped_array::Group triangles = cones.triangles(directed);
    EXPECT_EQ(triangles.size(), valence) << from << " " << to;

    std::set<int> hexahedra;
    for (int t : triangles) {
      const Hexahedron& h = complex.hexahedra[t / 24];
      const int corner = t % 24 / 3, k = t % 3;
      hexahedra.insert(t / 24);
      EXPECT_EQ(h[corner], from);
      EXPECT_EQ(h[corner_neighbors[corner][k]], to);
      // the base triangle in the plane of the other two edges faces the axis
      EXPECT_EQ(cones.normal(t), axis);
    }
    EXPECT_EQ(hexahedra.size(), valence) << "one triangle in each cube";
    EXPECT_EQ(cones.normal_sum(directed), double(valence) * axis);
    EXPECT_DOUBLE_EQ(cones.worst_cosine(directed, axis), 1);
    EXPECT_DOUBLE_EQ(cones.worst_cosine(directed, -axis), -1);
  }
  EXPECT_EQ(number_of_valence[4], 2 * 6);  // the edges at the center
  EXPECT_EQ(number_of_valence[2], 2 * 24); // within the sides of the block
  EXPECT_EQ(number_of_valence[1], 2 * 24); // along its edges
}

TEST(Edge_cones, have_normals_of_their_triangles_wherever_vertices_are)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  Positions points = block.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += .4 * Vector_3(std::sin(3. * v), std::cos(5. * v), std::sin(7. * v + 1));
  cones.update_normals(points);
  // The cone towards +x at the center, counter-clockwise around x: y, z, -y, -z
  const int center = block.vertex(1, 1, 1);
  const int rim[4] = {block.vertex(1, 2, 1), block.vertex(1, 1, 2), block.vertex(1, 0, 1), block.vertex(1, 1, 0)};
  const int hexahedron[4] = {7, 5, 1, 3}; // with those two rim vertices, at +x
  const int directed = complex.find_edge(center, block.vertex(2, 1, 1));
  Vector_3 sum = Vector_3::Zero();
  double worst = 1;
  const Vector_3 direction = Vector_3(.3, .2, -.5).normalized();
  for (int k = 0; k < 4; ++k) {
    const Vector_3 expected =
      (points[rim[k]] - points[center]).cross(points[rim[(k + 1) % 4]] - points[center]).normalized();
    sum += expected;
    worst = (std::min)(worst, direction.dot(expected));
    int found = 0;
    for (int t : cones.triangles(directed))
      if (t / 24 == hexahedron[k]) {
        ++found;
        EXPECT_LT((cones.normal(t) - expected).norm(), 1e-14);
      }
    EXPECT_EQ(found, 1) << k;
  }
  EXPECT_LT((cones.normal_sum(directed) - sum).norm(), 1e-13);
  EXPECT_NEAR(cones.worst_cosine(directed, direction), worst, 1e-14);
}

TEST(Edge_cones, have_zero_normals_where_a_base_is_degenerate)
{
  const Block block(1, 1, 1);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  Positions points = block.points;
  points[2] = points[0]; // vertex (0,1,0) onto (0,0,0)
  cones.update_normals(points);
  const int up = complex.find_edge(0, 4);
  ASSERT_EQ(cones.triangles(up).size(), 1u);
  EXPECT_EQ(cones.normal_sum(up), Vector_3::Zero());
}

} // namespace
