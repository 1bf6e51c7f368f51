// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes made from surfaces: quality, distance, features; index ranges and linear cell complexes.

#include "Generated_surface.h"
#include "mesh_checks.h"

#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/validity.h>
#include <CGAL/Hex_mesh_optimization/voxel_mesh.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/make_hex_mesh.h>

#include <boost/property_map/function_property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using LCC = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

Generated_mesh ball(std::size_t n)
{
  return Generated_mesh([&](auto& p, auto& h) { HMO::make_ball(p, h, n); });
}

double distance_to_nearest(const Mesh& mesh, const Vector_3& place)
{
  double result = std::numeric_limits<double>::infinity();
  for (const Point& p : mesh.points)
    result = (std::min)(result, (Vector_3(p.x(), p.y(), p.z()) - place).norm());
  return result;
}

TEST(make_hex_mesh, of_smooth_and_sharp_solids_is_valid_good_and_near)
{
  for (const Generated_mesh& mesh : {ball(10), cylinder(10), block(1), l_shape(1)})
    for (double turn : {0., .8}) {
      Mesh result;
      const auto status = CGAL::make_hex_mesh(surface_mesh(surface_of(mesh, turn)), result.points, result.hexahedra,
                                              CGAL::parameters::number_of_hexahedra(1500));
      EXPECT_TRUE(status.valid_mesh());
      EXPECT_TRUE(invalid_hexahedra(result).empty());
      EXPECT_TRUE(status.has_topology_of_surface);
      EXPECT_GT(status.after.minimum, .5);
      EXPECT_GT(status.after.average, .84);
      EXPECT_LT(status.deviation.average_relative, 5e-4);
      EXPECT_LT(status.deviation.maximum_relative, 8e-3);
    }
}

TEST(make_hex_mesh, has_vertices_at_corners)
{
  for (double turn : {0., .8}) {
    Mesh result;
    CGAL::make_hex_mesh(surface_mesh(surface_of(block(1), turn)), result.points, result.hexahedra,
                        CGAL::parameters::number_of_hexahedra(600));
    for (const Vector_3& corner : surface_of(block(1), turn).points)
      EXPECT_LT(distance_to_nearest(result, corner), 1e-9);
  }
}

TEST(make_hex_mesh, of_a_box_is_the_grid)
{
  Mesh result;
  const auto status = CGAL::make_hex_mesh(surface_mesh(surface_of(block(1))), result.points, result.hexahedra,
                                          CGAL::parameters::grid_spacing(.2));
  EXPECT_EQ(result.hexahedra.size(), 125u);
  EXPECT_NEAR(status.after.minimum, 1, 1e-9);
  EXPECT_NEAR(status.spacing, .2, 1e-12);
}

TEST(make_hex_mesh, of_a_turned_solid_with_flat_sides_is_a_grid_along_them)
{
  for (double turn : {0., .7}) {
    const Reference_input surface = surface_of(Generated_mesh([](auto& p, auto& h) { HMO::make_t_shape(p, h, 1); }),
                                               turn);
    Mesh result;
    const auto status = CGAL::make_hex_mesh(surface_mesh(surface), result.points, result.hexahedra,
                                            CGAL::parameters::grid_spacing(.29));
    EXPECT_NEAR(status.after.minimum, 1, 1e-6);
    EXPECT_LT(status.deviation.maximum_relative, 1e-9);
    for (const Vector_3& corner : surface.points)
      EXPECT_LT(distance_to_nearest(result, corner), 1e-9);
  }
}

TEST(make_hex_mesh, as_a_linear_cell_complex_is_the_same)
{
  const Surface surface = surface_mesh(surface_of(cylinder(8), .4));
  const auto np = CGAL::parameters::number_of_hexahedra(300);
  Mesh ranges, of_lcc;
  CGAL::make_hex_mesh(surface, ranges.points, ranges.hexahedra, np);
  LCC lcc;
  lcc.make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)); // is cleared
  CGAL::make_hex_mesh(surface, lcc, np);
  HMO::linear_cell_complex_to_hexahedra(lcc, of_lcc.points, of_lcc.hexahedra);
  EXPECT_EQ(of_lcc.hexahedra, ranges.hexahedra);
  EXPECT_TRUE(same_points(of_lcc.points, ranges.points));
}

TEST(make_hex_mesh, of_a_triangle_soup_is_the_same)
{
  const Reference_input surface = surface_of(cylinder(8), .4);
  std::vector<Point> soup;
  for (const Vector_3& p : surface.points)
    soup.emplace_back(p[0], p[1], p[2]);
  const auto np = CGAL::parameters::number_of_hexahedra(300);
  Mesh of_graph, of_soup;
  CGAL::make_hex_mesh(surface_mesh(surface), of_graph.points, of_graph.hexahedra, np);
  CGAL::make_hex_mesh(soup, surface.triangles, of_soup.points, of_soup.hexahedra, np);
  EXPECT_EQ(of_soup.hexahedra, of_graph.hexahedra);
  double most = 0; // faces of a graph may start at other vertices: the same up to rounding
  ASSERT_EQ(of_soup.points.size(), of_graph.points.size());
  for (std::size_t v = 0; v < of_soup.points.size(); ++v)
    most = (std::max)(most, CGAL::to_double(CGAL::squared_distance(of_soup.points[v], of_graph.points[v])));
  EXPECT_LT(most, 1e-12);
}

// The boxes of a soup of 8 points and 12 triangles each.
void append_box(std::vector<Point>& points, std::vector<std::array<std::size_t, 3>>& triangles, const Vector_3& low,
                const Vector_3& high)
{
  const Reference_input cube = surface_of(block(1));
  const std::size_t n = points.size();
  for (const Vector_3& p : cube.points) {
    const Vector_3 q = low + p.cwiseProduct(high - low);
    points.emplace_back(q[0], q[1], q[2]);
  }
  for (const Triangle_indices& t : cube.triangles)
    triangles.push_back({n + std::size_t(t[0]), n + std::size_t(t[1]), n + std::size_t(t[2])});
}

TEST(make_hex_mesh, of_parts_that_overlap_is_true_to_their_union)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  append_box(points, triangles, Vector_3(0, 0, 0), Vector_3(2, 2, 1));
  append_box(points, triangles, Vector_3(.5, .5, .5), Vector_3(1.5, 1.5, 3));
  std::swap(triangles[0][0], triangles[0][1]);
  Mesh mesh;
  const auto status = CGAL::make_hex_mesh(points, triangles, mesh.points, mesh.hexahedra,
                                          CGAL::parameters::number_of_hexahedra(800));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_TRUE(status.matches_surface());
  EXPECT_NEAR(status.surface.volume, 6, 1e-9);
  EXPECT_NEAR(status.volume_after, 6, 1e-3);
}

TEST(make_hex_mesh, of_bodies_closer_than_a_cell_has_as_many_and_lists_hexahedra_of_all)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  append_box(points, triangles, Vector_3(0, 0, 0), Vector_3(1, 1, 1));
  append_box(points, triangles, Vector_3(1.001, 0, 0), Vector_3(3, 1, 1));
  Mesh mesh;
  const auto status = CGAL::make_hex_mesh(points, triangles, mesh.points, mesh.hexahedra,
                                          CGAL::parameters::number_of_hexahedra(400));
  EXPECT_TRUE(status.matches_surface());
  EXPECT_EQ(status.number_of_bodies, 2u);
  EXPECT_EQ(status.euler_characteristic, 4);
  EXPECT_EQ(status.after.number_of_hexahedra, mesh.hexahedra.size());
  EXPECT_NEAR(double(mesh.hexahedra.size()), 400, 150);
  EXPECT_TRUE(invalid_hexahedra(mesh).empty());
  EXPECT_NEAR(status.volume_after, 2.999, 1e-6);
}

// Touching and overlapping boxes and balls: each hexahedron has a label, and each part its volume.
TEST(make_hex_mesh, keeps_parts_with_labels_apart)
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  append_box(points, triangles, Vector_3(-1, -1, -1), Vector_3(1, 1, 0));
  const std::size_t of_box = triangles.size(), first = points.size();
  const Reference_input sphere = surface_of(ball(6), .3);
  for (const Vector_3& p : sphere.points)
    points.emplace_back(.6 * p[0] + .1, .6 * p[1], .6 * p[2] + .2);
  for (const Triangle_indices& t : sphere.triangles)
    triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  Mesh mesh;
  const auto status = CGAL::make_hex_mesh(points, triangles, mesh.points, mesh.hexahedra,
                                          CGAL::parameters::number_of_hexahedra(1500).face_label_map(
                                            boost::make_function_property_map<std::size_t>(
                                              [&](std::size_t t) { return t < of_box ? 5 : 8; })));
  EXPECT_TRUE(status.valid_mesh());
  EXPECT_GT(status.after.minimum, .3);
  EXPECT_TRUE(status.matches_surface());
  ASSERT_EQ(status.labels.size(), mesh.hexahedra.size());
  ASSERT_EQ(status.materials.size(), 2u);
  for (std::size_t i : {0, 1}) {
    const HMO::Material_report& part = status.materials[i];
    EXPECT_EQ(part.label, i == 0 ? 5 : 8);
    EXPECT_EQ(part.number_of_hexahedra,
              std::size_t(std::count(status.labels.begin(), status.labels.end(), part.label)));
    EXPECT_NEAR(part.volume_after, part.volume, .01 * part.volume);
  }
  EXPECT_NEAR(status.materials[0].volume + status.materials[1].volume, status.surface.volume, 1e-9);
  EXPECT_LT(status.deviation.maximum_relative, .02);
}

TEST(make_hex_mesh, refuses_cells_that_would_close_a_hole)
{
  const Generated_mesh ring([](auto& p, auto& h) { HMO::make_ring(p, h, 18, 2); });
  Mesh mesh;
  EXPECT_THROW(CGAL::make_hex_mesh(surface_mesh(surface_of(ring)), mesh.points, mesh.hexahedra,
                                   CGAL::parameters::grid_spacing(2.)),
               HMO::Input_error);
  EXPECT_TRUE(mesh.hexahedra.empty());
}

TEST(make_hex_mesh, refuses_parameters_and_surfaces_and_leaves_the_mesh)
{
  Surface open = surface_mesh(surface_of(block(1)));
  CGAL::Euler::remove_face(halfedge(*open.faces().begin(), open), open);
  Mesh mesh{{Point(1, 2, 3)}, {}};
  EXPECT_THROW(CGAL::make_hex_mesh(open, mesh.points, mesh.hexahedra), HMO::Input_error);
  const Surface cube = surface_mesh(surface_of(block(1)));
  namespace np = CGAL::parameters;
  EXPECT_THROW(CGAL::make_hex_mesh(cube, mesh.points, mesh.hexahedra, np::grid_spacing(-1.)), HMO::Input_error);
  EXPECT_THROW(CGAL::make_hex_mesh(cube, mesh.points, mesh.hexahedra, np::minimum_cells_across(0)), HMO::Input_error);
  EXPECT_THROW(CGAL::make_hex_mesh(cube, mesh.points, mesh.hexahedra, np::number_of_hexahedra(0)), HMO::Input_error);
  EXPECT_EQ(mesh.points.size(), 1u);
}

TEST(voxel_mesh, are_boxes_of_the_spacing_inside)
{
  Mesh mesh;
  const auto status = CGAL::voxel_mesh(surface_mesh(surface_of(ball(8))), .2, mesh.points, mesh.hexahedra);
  EXPECT_NEAR(status.spacing, .2, 1e-6);
  EXPECT_TRUE(status.has_topology_of_surface);
  EXPECT_TRUE(status.thin_faces.empty());
  EXPECT_NEAR(double(mesh.hexahedra.size()) * .008, 4.19, .2);
  LCC lcc;
  CGAL::voxel_mesh(surface_mesh(surface_of(ball(8))), .2, lcc);
  EXPECT_EQ(lcc.one_dart_per_cell<3>().size(), mesh.hexahedra.size());
  EXPECT_THROW(CGAL::voxel_mesh(surface_mesh(surface_of(ball(8))), 0, mesh.points, mesh.hexahedra), HMO::Input_error);
}

} // namespace
