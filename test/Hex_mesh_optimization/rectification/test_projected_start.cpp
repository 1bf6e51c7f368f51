// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh beside its reference, one on it.

#include <CGAL/Hex_mesh_optimization/internal/rectification/projected_start.h>

#include "../Generated_mesh.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// An affine map takes it away from its own boundary
TEST(Projected_start, finds_a_block_again_that_was_stretched_and_sheared)
{
  const Generated_mesh mesh = block(5);
  const auto surface = mesh.own_reference();
  const Boundary_attachment attachment = attach_to_own_boundary(mesh.complex, *surface);
  Matrix_3 map;
  map << 1.6, .2, 0, 0, .7, 0, .1, 0, 1.2;
  Positions points;
  for (const Vector_3& p : mesh.points)
    points.push_back(map * p + Vector_3(.3, -2, .1));
  const Positions result = Projected_start(mesh.complex, *surface, attachment)(points);
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_LT((result[v] - mesh.points[v]).norm(), 1e-5) << v;
}

TEST(Projected_start, leaves_fixed_vertices_alone)
{
  const Generated_mesh mesh = block(4);
  const auto surface = mesh.own_reference();
  Boundary_attachment attachment = attach_to_own_boundary(mesh.complex, *surface);
  Positions points;
  for (const Vector_3& p : mesh.points)
    points.push_back(1.1 * p);
  for (std::size_t v = 0; v < points.size(); v += 5)
    attachment.kind[v] = Vertex_kind::FIXED;
  const Positions result = Projected_start(mesh.complex, *surface, attachment)(points);
  for (std::size_t v = 0; v < points.size(); v += 5)
    EXPECT_EQ(result[v], points[v]) << v;
}

} // namespace
