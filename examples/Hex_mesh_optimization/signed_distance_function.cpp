// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Brings the mesh of a ball to a cube with round edges that is given by its distance function.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/optimize_hex_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

// A model of HexMeshOptimizationProjector: all points at a distance of .5 from a cube.
struct Round_cube
{
  static constexpr double half = .5, radius = .5;

  static double clamped(double x) { return (std::max)(-half, (std::min)(half, x)); }

  Vector normal(const Point& p) const { return p - Point(clamped(p.x()), clamped(p.y()), clamped(p.z())); }

  Point closest_point(const Point& p) const
  {
    const Vector out = normal(p);
    const double length = std::sqrt(out.squared_length());
    if (length > 0)
      return p + (radius / length - 1) * out;
    return Point(0, 0, half + radius); // within the cube, where nobody asks
  }
};

int main()
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  HMO::make_ball(points, hexahedra, 6);

  const HMO::Status status = CGAL::optimize_hex_mesh(
    points, hexahedra, Round_cube(),
    CGAL::parameters::boundary_placement(HMO::Boundary_placement::ON_SURFACE).maximum_running_time(60));

  std::cout << (status.valid_mesh() ? "valid" : "not valid") << ", minimum scaled Jacobian " << status.after.minimum
            << ", " << status.vertices_off_reference.size() << " vertices are not on the surface\n";
  return status.valid_mesh() ? 0 : 1;
}
