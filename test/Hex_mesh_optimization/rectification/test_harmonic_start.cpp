// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From any interior, a start whose interior vertices are the means of their neighbors.

#include <CGAL/Hex_mesh_optimization/internal/rectification/harmonic_start.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "../Generated_mesh.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Harmonic_start, makes_cubes_of_a_tangled_block_and_moves_nothing_else)
{
  const Generated_mesh mesh = block(5);
  const auto surface = mesh.own_reference();
  Boundary_attachment attachment = attach_to_own_boundary(mesh.complex, *surface);
  std::mt19937 random(3);
  Positions points = mesh.points;
  std::size_t fixed = points.size();
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!mesh.complex.is_on_boundary[v]) {
      points[v] += random_vector(random, .5);
      if (fixed == points.size()) { // the first one stays where it should not be
        fixed = v;
        attachment.kind[v] = Vertex_kind::FIXED;
      }
    }
  points[fixed] = mesh.points[fixed] + Vector_3(.02, -.01, .03);
  const Positions start = points;
  ASSERT_GT(Mesh_quality(mesh.complex, start).inverted, mesh.complex.hexahedra.size() / 4);

  harmonic_start(mesh.complex, attachment, points);
  EXPECT_EQ(Mesh_quality(mesh.complex, points).inverted, 0u);
  std::vector<Vector_3> sum(points.size(), Vector_3::Zero());
  std::vector<int> degree(points.size(), 0);
  for (const std::array<int, 2>& e : mesh.complex.edges)
    for (const int end : {0, 1}) {
      sum[e[end]] += points[e[1 - end]];
      ++degree[e[end]];
    }
  for (std::size_t v = 0; v < points.size(); ++v)
    if (attachment.kind[v] == Vertex_kind::INTERIOR)
      EXPECT_LT((points[v] - sum[v] / degree[v]).norm(), 1e-2 / 5);
    else
      EXPECT_EQ(points[v], start[v]);
}

} // namespace
