// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/index_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/projector_to_reference.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace HMO::internal;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

// Of this radius around the origin, by its distance function.
struct Sphere
{
  double radius;
  Point closest_point(const Point& p) const
  {
    const double length = std::sqrt((p - CGAL::ORIGIN).squared_length());
    return p - (length - radius) * (p - CGAL::ORIGIN) / length;
  }
  Vector normal(const Point& p) const { return p - CGAL::ORIGIN; }
};

// From -1 to 1 in each direction.
struct Cube
{
  Point closest_point(const Point& p) const
  {
    std::array<double, 3> x = {p.x(), p.y(), p.z()};
    const int axis = largest(x);
    for (double& c : x)
      c = (std::max)(-1., (std::min)(1., c));
    x[axis] = x[axis] < 0 ? -1 : 1;
    return {x[0], x[1], x[2]};
  }
  Vector normal(const Point& p) const
  {
    const std::array<double, 3> x = {p.x(), p.y(), p.z()};
    std::array<double, 3> n = {0, 0, 0};
    n[largest(x)] = x[largest(x)];
    return {n[0], n[1], n[2]};
  }
  static int largest(const std::array<double, 3>& x)
  {
    int result = 0;
    for (int d = 1; d < 3; ++d)
      if (std::abs(x[d]) > std::abs(x[result]))
        result = d;
    return result;
  }
};

int sides_of_cube(const Vector_3& p)
{
  int result = 0;
  for (int d = 0; d < 3; ++d)
    result += std::abs(std::abs(p[d]) - 1) < 1e-9;
  return result;
}

TEST(projector_to_reference, samples_the_surface_and_shares_samples_between_faces)
{
  Mesh ball;
  HMO::make_ball(ball.points, ball.hexahedra, 2);
  const Reference_input reference = projector_to_reference<Point>(Sphere{2}, engine_positions(ball.points),
                                                                  engine_hexahedra(ball.hexahedra), 45);
  EXPECT_TRUE(reference.sharp.empty() && reference.sharp_is_given);
  for (const Vector_3& p : reference.points)
    EXPECT_NEAR(p.norm(), 2, 1e-12);
  // closed, without a handle
  EXPECT_EQ(reference.points.size(), reference.triangles.size() / 2 + 2);
}

TEST(projector_to_reference, finds_features_that_the_mesh_does_not_have)
{
  Mesh block;
  HMO::make_block(block.points, block.hexahedra, {{3, 3, 3}}, {{1.7, 1.7, 1.7}});
  for (Point& p : block.points) { // about the origin, turned
    const double x = p.x() - .85, y = p.y() - .85, z = p.z() - .85, c = std::cos(.2), s = std::sin(.2);
    p = Point(c * x - s * y, s * x + c * y, z);
  }
  const Reference_input reference = projector_to_reference<Point>(Cube(), engine_positions(block.points),
                                                                  engine_hexahedra(block.hexahedra), 45);
  EXPECT_GT(reference.sharp.size(), 100u);
  for (const auto& edge : reference.sharp)
    for (int v : edge)
      EXPECT_GE(sides_of_cube(reference.points[v]), 2) << reference.points[v].transpose();
  for (const Vector_3& p : reference.points)
    EXPECT_GE(sides_of_cube(p), 1);
}

TEST(projector_to_reference, skips_what_the_engine_will_refuse)
{
  const Positions points(8, Vector_3(1, 2, 3));
  EXPECT_TRUE(
    projector_to_reference<Point>(Sphere{1}, points, {{{0, 1, 2, 3, 4, 5, 6, 8}}, {{0, 0, 2, 3, 4, 5, 6, 7}}}, 45)
      .triangles.empty());
}

TEST(projector_to_reference, is_the_reference_of_an_optimization)
{
  Mesh ball;
  HMO::make_ball(ball.points, ball.hexahedra, 4);
  HMO::scramble_interior(ball.points, ball.hexahedra, 1, .5);
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>> lcc;
  HMO::hexahedra_to_linear_cell_complex(ball.points, ball.hexahedra, lcc);
  const auto exactly = CGAL::parameters::boundary_placement(HMO::Boundary_placement::ON_SURFACE);
  const HMO::Status status = CGAL::optimize_hex_mesh(ball.points, ball.hexahedra, Sphere{1.1}, exactly);
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_TRUE(status.vertices_off_reference.empty());
  EXPECT_NEAR(status.volume_after, 4. / 3 * 3.14159 * 1.1 * 1.1 * 1.1, .1 * status.volume_after);
  EXPECT_GT(status.volume_after, 1.2 * status.volume_before);
  EXPECT_EQ(CGAL::optimize_hex_mesh(lcc, Sphere{1.1}, exactly).volume_after, status.volume_after);
}

} // namespace
