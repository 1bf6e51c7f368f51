// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a triangle surface to a hexahedral mesh, as a linear cell complex.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/make_hex_mesh.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using LCC = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>;

int main()
{
  // A prism with twelve sides: two faces, and curves that turn at every corner
  CGAL::Surface_mesh<Point> surface;
  CGAL::make_regular_prism(12, surface, Point(0, 0, 0), 2., 1., true); // height, radius, with bottom and top

  LCC lcc;
  const auto status = CGAL::make_hex_mesh(surface, lcc, CGAL::parameters::number_of_hexahedra(1000));

  std::cout << lcc.one_dart_per_cell<3>().size() << " hexahedra, minimum scaled Jacobian " << status.after.minimum
            << ", maximum deviation " << status.deviation.maximum << '\n';
  return status.valid_mesh() ? 0 : 1;
}
