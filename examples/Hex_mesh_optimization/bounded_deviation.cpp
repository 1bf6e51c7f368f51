// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The boundary within a distance of the surface that it stands for, certified.

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
  CGAL::Hex_mesh_optimization::make_ball(points, hexahedra, 6);         // of radius 1
  CGAL::Hex_mesh_optimization::scramble_interior(points, hexahedra, 1); // 1: seed

  const auto status = CGAL::optimize_hex_mesh(points, hexahedra, CGAL::parameters::maximum_deviation(.005));

  std::cout << "minimum scaled Jacobian " << status.after.minimum << ", nowhere farther from the surface than "
            << status.deviation.certified << ", the bound is " << status.deviation_bound << '\n';
  return status.valid_mesh() && status.is_within_deviation_bound() ? 0 : 1;
}
