// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Untangling moves what is near inverted corners, and nothing else.

#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>

#include "../Attached_mesh.h"
#include "../Corner.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Untangling, moves_what_is_near_inverted_corners_and_nothing_else)
{
  Indexed_mesh block;
  HMO::make_block(block.points, block.hexahedra, {{16, 5, 5}}, {{16, 5, 5}});
  Attached_mesh s(block);
  std::size_t displaced = 0; // the first interior vertex is near one end
  while (s.complex.is_on_boundary[displaced])
    ++displaced;
  s.points[displaced] += Vector_3(2.3, .7, .4);
  const Positions given = s.points;
  ASSERT_GT(Mesh_quality(s.complex, given).inverted, 0u);
  Untangling_parameters parameters;
  parameters.rings = 3;
  Boundary_samples samples = s.samples();
  const Sliding sliding = s.sliding();
  Run_control control;
  Untangling(s.complex, samples, s.distance(), s.lengths, sliding, parameters).run(s.points, control);
  EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, parameters.untangled);
  EXPECT_NE(s.points[displaced], given[displaced]);
  std::size_t far = 0;
  for (std::size_t v = 0; v < given.size(); ++v)
    if (std::abs(block.points[v].x() - block.points[displaced].x()) > 9) { // inverted ones may wander a little
      ++far;
      EXPECT_EQ(s.points[v], given[v]) << v;
    }
  EXPECT_GT(far, 30u);
}

} // namespace
