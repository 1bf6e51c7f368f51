// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Optimizes a linear cell complex toward a surface mesh, with named parameters
// and a visitor that reports every iteration.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_traits.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iostream>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using LCC = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>;

struct Printer
{
  std::size_t calls = 0;

  bool on_iteration(const HMO::Iteration& i)
  {
    ++calls;
    std::cout << HMO::name(i.stage) << ' ' << i.iteration << ": " << i.number_of_inverted << " inverted, minimum "
              << i.minimum << ", average " << i.average << '\n';
    return true; // false ends the optimization
  }
};

int main()
{
  // A tangled mesh of a cylinder ...
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  HMO::make_cylinder(points, hexahedra, 4, 8, 1, 2);
  HMO::scramble_interior(points, hexahedra, 1); // 1: seed
  LCC lcc;
  HMO::hexahedra_to_linear_cell_complex(points, hexahedra, lcc);

  // ... and the surface that its boundary represents: a prism of 60 sides
  CGAL::Surface_mesh<Point> reference;
  CGAL::make_regular_prism(60, reference, Point(0, 0, 0), 2., 1.);
  for (const auto v : reference.vertices()) // which is along the y axis
    reference.point(v) = Point(reference.point(v).z(), reference.point(v).x(), reference.point(v).y());
  CGAL::Polygon_mesh_processing::triangulate_faces(reference);

  Printer printer;
  const HMO::Status status = CGAL::optimize_hex_mesh(
    lcc, reference, CGAL::parameters::features_angle_bound(60).maximum_running_time(60).visitor(std::ref(printer)));

  std::cout << "after " << printer.calls << " iterations: " << (status.valid_mesh() ? "valid" : "not valid")
            << ", maximum deviation " << status.deviation.maximum << '\n';
  return status.valid_mesh() ? 0 : 1;
}
