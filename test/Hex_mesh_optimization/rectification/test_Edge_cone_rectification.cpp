// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rectification untangles an interior, never gives back a worse mesh than it was given, and ends when it is told to.

#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cone_rectification.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>

#include "../Generated_mesh.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr double no_target = std::numeric_limits<double>::infinity();

// A block of unit cubes with all that a rectification takes
struct Rectified_block
{
  Generated_mesh mesh;
  Surface_faces faces;
  std::unique_ptr<Reference_surface> surface;
  Boundary_attachment attachment;
  Edge_relations relations;
  Rectification_parameters parameters;

  Rectified_block()
    : mesh([](auto& p, auto& h) {
      CGAL::Hex_mesh_optimization::make_block(p, h, {{4, 4, 4}}, {{4, 4, 4}});
    })
    , faces(boundary_surface_faces(mesh.complex))
    , surface(mesh.own_reference())
    , attachment(attach_to_own_boundary(mesh.complex, *surface))
    , relations(mesh.complex)
  {}

  Positions tangled(double amplitude) const
  {
    std::mt19937 random(4);
    Positions points = mesh.points;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!mesh.complex.is_on_boundary[v])
        points[v] += random_vector(random, amplitude);
    return points;
  }

  void run(Positions& points, Run_control& control, double target) const
  {
    const std::vector<double> lengths(mesh.complex.edges.size(), 1.);
    Edge_cone_rectification(mesh.complex, relations, faces, *surface, attachment, attachment.fixed_vertices(), lengths,
                            parameters)
      .run(points, control, target);
  }
};

TEST(Edge_cone_rectification, untangles_an_interior)
{
  const Rectified_block block;
  Positions points = block.tangled(1);
  ASSERT_GT(Mesh_quality(block.mesh.complex, points).inverted, 10u);
  Run_control control;
  block.run(points, control, no_target);
  const Mesh_quality quality(block.mesh.complex, points);
  EXPECT_EQ(quality.invalid, 0u);
  EXPECT_GT(quality.minimum, .5);
}

TEST(Edge_cone_rectification, keeps_fixed_vertices_bit_for_bit)
{
  Rectified_block block;
  for (std::size_t v = 0; v < block.mesh.points.size(); v += 3)
    block.attachment.kind[v] = Vertex_kind::FIXED;
  const Positions start = block.tangled(.3);
  Positions points = start;
  Run_control control;
  block.run(points, control, no_target);
  EXPECT_NE(points, start);
  for (std::size_t v = 0; v < points.size(); v += 3)
    EXPECT_EQ(points[v], start[v]);
}

TEST(Edge_cone_rectification, never_gives_a_valid_mesh_back_invalid_or_with_a_lower_minimum)
{
  const Rectified_block block;
  int valid = 0;
  for (const double amplitude : {0., .1, .2, .25}) {
    Positions points = block.tangled(amplitude);
    const Mesh_quality before(block.mesh.complex, points);
    if (before.invalid > 0)
      continue;
    ++valid;
    Run_control control;
    block.run(points, control, no_target);
    const Mesh_quality after(block.mesh.complex, points);
    EXPECT_EQ(after.invalid, 0u);
    EXPECT_GE(after.minimum, before.minimum);
  }
  EXPECT_GE(valid, 2);
}

TEST(Edge_cone_rectification, ends_at_the_target_when_stopped_and_when_the_time_is_over)
{
  const Rectified_block block;
  const auto iterations = [&](Run_control control, double target) {
    Positions points = block.tangled(1);
    block.run(points, control, target);
    return control.iterations;
  };
  const std::size_t all = iterations(Run_control(), no_target);
  EXPECT_LT(iterations(Run_control(), .1), all);
  std::size_t calls = 0;
  EXPECT_EQ(iterations(Run_control(no_target,
                                   [&](const CGAL::Hex_mesh_optimization::Iteration&) { return ++calls < 2; }),
                       no_target),
            2u);
  EXPECT_LE(iterations(Run_control(0), no_target), 1u);
}

} // namespace
