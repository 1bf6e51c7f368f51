// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

// How good a mesh can be while its boundary stays: a bound that no interior exceeds, and that the interior has no part in.

#include <CGAL/Hex_mesh_optimization/internal/boundary/limit_of_held_boundary.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "../mesh_families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

class Limit_of_held_boundary : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Limit_of_held_boundary, ::testing::ValuesIn(mesh_families()), Family_name());

TEST_P(Limit_of_held_boundary, is_at_least_the_minimum_whatever_the_interior_is)
{
  Indexed_mesh mesh = GetParam()();
  const Hexahedral_complex complex = mesh.complex();
  const double limit = limit_of_held_boundary(complex, positions(mesh));
  EXPECT_GE(limit, HMO::quality_statistics(mesh.points, mesh.hexahedra).minimum - 1e-12);
  for (std::uint64_t seed : {1, 2}) {
    HMO::scramble_interior(mesh.points, mesh.hexahedra, seed);
    EXPECT_EQ(limit_of_held_boundary(complex, positions(mesh)), limit);
  }
}

TEST(Limit_of_held_boundary, is_that_of_the_worst_corner)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{3, 3, 3}});
  EXPECT_NEAR(limit_of_held_boundary(mesh.complex(), positions(mesh)), 1, 1e-12);
  const Indexed_mesh slanted = sheared(mesh, 1); // to angles of 45 degrees
  EXPECT_NEAR(limit_of_held_boundary(slanted.complex(), positions(slanted)), std::sqrt(.5), 1e-12);
}

} // namespace
