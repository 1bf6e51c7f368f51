// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest use: points, hexahedra, and the boundary as its own reference.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/optimize_hex_mesh.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <vector>

int main()
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::Hex_mesh_optimization::make_cylinder(points, hexahedra, 4, 8);
  CGAL::Hex_mesh_optimization::scramble_interior(points, hexahedra, 1); // 1: seed

  const auto status = CGAL::optimize_hex_mesh(points, hexahedra);

  std::cout << status.before.number_of_inverted << " of " << hexahedra.size() << " hexahedra were inverted, "
            << status.after.number_of_inverted << " are; the minimum scaled Jacobian is " << status.after.minimum
            << ".\n";
  return status.valid_mesh() ? 0 : 1;
}
