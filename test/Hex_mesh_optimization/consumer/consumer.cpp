// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The least that a program using the installed package does.

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

  std::cout << hexahedra.size() << " hexahedra\n";
  return hexahedra.size() == 64 ? EXIT_SUCCESS : EXIT_FAILURE;
}
