// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The least that a program using the installed package does.

#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::Hex_mesh_optimization::make_block(points, hexahedra, {{4, 4, 4}});
  CGAL::Hex_mesh_optimization::scramble_interior(points, hexahedra, 1);

  const CGAL::Hex_mesh_optimization::Status status =
    CGAL::optimize_hex_mesh(points, hexahedra, CGAL::parameters::features_angle_bound(60));

  std::cout << status.before.number_of_inverted << " inverted before, " << status.after.number_of_inverted
            << " after\n";
  return status.before.number_of_inverted > 0 && status.valid_mesh() ? EXIT_SUCCESS : EXIT_FAILURE;
}
