// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How good a mesh is: statistics, a histogram, and the hexahedra that are not valid.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;

int main()
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  HMO::make_ball(points, hexahedra, 4);
  HMO::scramble_interior(points, hexahedra, 1, .5); // seed; in local edge lengths

  const HMO::Quality_statistics quality = HMO::quality_statistics(points, hexahedra);
  std::cout << "scaled Jacobian: minimum " << quality.minimum << ", average " << quality.average << "\nhistogram:";
  for (std::size_t count : HMO::quality_histogram(points, hexahedra, 10)) // from -1 to 1
    std::cout << ' ' << count;

  std::vector<std::size_t> invalid;
  HMO::invalid_hexahedra(points, hexahedra, std::back_inserter(invalid));
  std::cout << "\n"
            << quality.number_of_inverted << " are inverted at a corner, " << invalid.size() << " are not valid\n";
  return invalid.size() >= quality.number_of_inverted ? 0 : 1;
}
