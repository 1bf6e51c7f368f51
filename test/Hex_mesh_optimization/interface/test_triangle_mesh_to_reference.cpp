// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The reference of the engine is the caller's mesh: its points and triangles in order, whatever map the points come
// from, and its marked edges.

#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_mesh_to_reference.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

// A square pyramid without its base, and a vertex in its middle that was removed again
Surface pyramid()
{
  Surface surface;
  std::array<Surface::Vertex_index, 6> v;
  const double x[6][3] = {{0, 0, 0}, {1, 0, 0}, {7, 7, 7}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}};
  for (int i = 0; i < 6; ++i)
    v[i] = surface.add_vertex(Point(x[i][0], x[i][1], x[i][2]));
  for (const std::array<int, 2>& side : {std::array<int, 2>{0, 1}, {1, 3}, {3, 4}, {4, 0}})
    surface.add_face(v[side[0]], v[side[1]], v[5]);
  surface.remove_vertex(v[2]);
  return surface;
}

TEST(Triangle_mesh_to_reference, keeps_points_and_triangles_in_order)
{
  const Surface surface = pyramid();
  const Reference_input reference = triangle_mesh_to_reference(surface, CGAL::parameters::default_values());
  ASSERT_EQ(reference.points.size(), 5u); // without the removed one
  ASSERT_EQ(reference.triangles.size(), 4u);
  EXPECT_FALSE(reference.sharp_is_given);
  EXPECT_TRUE(reference.sharp.empty());
  std::size_t t = 0;
  for (const auto f : surface.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface)) {
      const Vector_3& p = reference.points[reference.triangles[t][k++]];
      EXPECT_EQ(Point(p[0], p[1], p[2]), surface.point(v));
    }
    ++t;
  }
}

TEST(Triangle_mesh_to_reference, takes_points_from_a_map_and_edges_that_are_marked)
{
  Surface surface = pyramid();
  auto points = surface.add_property_map<Surface::Vertex_index, Point>("v:elsewhere").first;
  for (const auto v : surface.vertices())
    points[v] = Point(surface.point(v).z(), 2, surface.point(v).x());
  auto marks = surface.add_property_map<Surface::Edge_index, bool>("e:mark", false).first;
  const auto marked = *surface.edges().begin();
  marks[marked] = true;
  const Reference_input reference =
    triangle_mesh_to_reference(surface, CGAL::parameters::vertex_point_map(points).edge_is_constrained_map(marks));
  EXPECT_TRUE(reference.sharp_is_given);
  ASSERT_EQ(reference.sharp.size(), 1u);
  for (const int end : {0, 1}) {
    const Point& p = points[surface.vertex(marked, end == 0 ? 0 : 1)];
    const Vector_3 &a = reference.points[reference.sharp[0][0]], &b = reference.points[reference.sharp[0][1]];
    const Vector_3 q(p.x(), p.y(), p.z());
    EXPECT_TRUE(q == a || q == b);
  }
}

TEST(Triangle_mesh_to_reference, refuses_a_quad_by_its_number)
{
  Surface surface = pyramid();
  const auto v = [&](double x, double y) { return surface.add_vertex(Point(x, y, 9)); };
  surface.add_face(v(0, 0), v(1, 0), v(1, 1), v(0, 1));
  try {
    triangle_mesh_to_reference(surface, CGAL::parameters::default_values());
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const CGAL::Hex_mesh_optimization::Input_error& error) {
    EXPECT_EQ(error.element(), CGAL::Hex_mesh_optimization::Input_error::Element::REFERENCE_FACE);
    EXPECT_EQ(error.element_index(), 4u);
  }
}

} // namespace
