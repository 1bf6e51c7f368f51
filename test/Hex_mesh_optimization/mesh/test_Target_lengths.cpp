// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the lengths of a mesh say about those that are wanted.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Target_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../Generated_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace test;

// A block of layers, thin ones at the bottom and at the top
struct Layers
{
  const Generated_mesh cubes;
  const Hexahedral_complex& complex = cubes.complex;
  const Edge_relations relations;
  Positions points;

  Layers()
    : cubes([](auto& p, auto& h) {
      HMO::make_block(p, h, {{6, 6, 5}}, {{6, 6, 5}});
    })
    , relations(cubes.complex)
    , points(cubes.points)
  {
    const std::vector<double> heights = {0, .1, .2, 1.2, 2.2, 2.25};
    for (Vector_3& p : points)
      p[2] = heights[std::lround(p[2])];
  }
};

// One hexahedron and all around it say nothing
TEST(Target_lengths, follow_layers_where_they_are_sound)
{
  Layers mesh;
  Positions& points = mesh.points;
  const Edge_relations& relations = mesh.relations;
  const std::vector<double> known = edge_lengths(mesh.complex, points);
  std::vector<char> is_sound(mesh.complex.hexahedra.size(), true);
  const std::size_t moved = 3 + 7 * (3 + 7 * 2); // in the middle
  ASSERT_FALSE(mesh.complex.is_on_boundary[moved]);
  for (int h : mesh.complex.vertex_hexahedra[moved])
    is_sound[h] = false;
  points[moved] += Vector_3(1.5, -1, 1.2);

  const Target_lengths found = lengths_along_sound_sheets(mesh.complex, relations, points, is_sound,
                                                          mean_boundary_edge_length(mesh.complex, points));
  const std::vector<double> estimated = estimate_edge_lengths(mesh.complex, relations, points);
  double largest_error = 0;
  for (std::size_t e = 0; e < known.size(); ++e) {
    EXPECT_GE(found.certainty[e], 0);
    EXPECT_LE(found.certainty[e], 1);
    if (found.certainty[e] > 0) {
      EXPECT_NEAR(std::log(found.lengths[e] / known[e]), 0, .2) << e;
    }
    if (known[e] < .2) {
      EXPECT_GT(found.certainty[e], .9) << e;
      EXPECT_NEAR(found.lengths[e] / known[e], 1, .05) << e;
      largest_error = (std::max)(largest_error, estimated[e] / known[e]);
    }
  }
  EXPECT_GT(largest_error, 2) << "the estimate alone would do";
}

TEST(Target_lengths, are_estimated_where_nothing_is_sound)
{
  const Layers mesh;
  const std::vector<char> is_sound(mesh.complex.hexahedra.size(), false);
  const Target_lengths found = lengths_along_sound_sheets(mesh.complex, mesh.relations, mesh.points, is_sound,
                                                          mean_boundary_edge_length(mesh.complex, mesh.points));
  EXPECT_EQ(found.lengths, estimate_edge_lengths(mesh.complex, mesh.relations, mesh.points));
  EXPECT_EQ(found.certainty, std::vector<double>(mesh.complex.edges.size(), 0.0));
}

TEST(Target_lengths, of_a_valid_mesh_are_its_own_and_certain_for_layers)
{
  const Layers mesh;
  const std::vector<double> known = edge_lengths(mesh.complex, mesh.points);
  const Target_lengths found = own_edge_lengths(mesh.complex, mesh.relations, mesh.points,
                                                mean_boundary_edge_length(mesh.complex, mesh.points));
  for (std::size_t e = 0; e < known.size(); ++e) {
    EXPECT_NEAR(found.lengths[e], known[e], 1e-4) << e;
    if (known[e] < .3) {
      EXPECT_EQ(found.certainty[e], 1) << e;
    }
  }
  const Target_lengths of_cubes = own_edge_lengths(mesh.complex, mesh.relations, mesh.cubes.points,
                                                   mean_boundary_edge_length(mesh.complex, mesh.cubes.points));
  EXPECT_EQ(of_cubes.certainty, std::vector<double>(known.size(), 0.0));
}

} // namespace
