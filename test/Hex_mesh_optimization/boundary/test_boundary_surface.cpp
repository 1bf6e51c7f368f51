// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The boundary of a mesh as its own reference: curves and corners where sheets of it meet, and what is attached to
// them.

#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>

#include "../block_of_cubes.h"
#include "../reference_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Two blocks of 2³ cubes that have one edge of the lattice, or one vertex, in common
Hexahedral_complex touching(const Block& block, bool at_a_vertex)
{
  std::vector<Hexahedron> hexahedra;
  for (const Hexahedron& h : block.hexahedra) {
    Vector_3 center = Vector_3::Zero();
    for (int v : h)
      center += block.points[v] / 8;
    const bool x = center[0] > 2, y = center[1] > 2, z = at_a_vertex ? center[2] > 2 : x;
    if (x == y && y == z)
      hexahedra.push_back(h);
  }
  return Hexahedral_complex(block.points.size(), hexahedra);
}

TEST(Boundary_surface, touches_at_vertices_without_a_common_edge)
{
  const Block block(4, 4, 4);
  EXPECT_EQ(touching_vertices(touching(block, true)), std::vector<int>{block.vertex(2, 2, 2)});
  EXPECT_EQ(touching_vertices(touching(block, false)), std::vector<int>()) << "these have an edge that does";
  EXPECT_EQ(touching_vertices(block.complex()), std::vector<int>());
}

TEST(Boundary_surface, has_a_corner_where_it_touches_at_a_vertex)
{
  const Block block(4, 4, 4);
  const Hexahedral_complex complex = touching(block, true);
  const auto surface = boundary_as_reference(complex, block.points, Feature_parameters{180}); // no edge is sharp
  const int contact = block.vertex(2, 2, 2);
  EXPECT_EQ(surface->corners, std::vector<int>{contact});
  EXPECT_TRUE(surface->curves.empty());
  EXPECT_EQ(surface->corner_rank(contact), Corner_rank::JUNCTION);
  const Boundary_attachment attachment = attach_to_own_boundary(complex, *surface);
  for (int v = 0; v < int(block.points.size()); ++v) {
    EXPECT_EQ(attachment.kind[v] == Vertex_kind::CORNER, v == contact);
  }
}

TEST(Boundary_surface, has_a_curve_where_it_touches_along_edges)
{
  const Block block(4, 4, 4);
  const Hexahedral_complex complex = touching(block, false);
  const auto surface = boundary_as_reference(complex, block.points, Feature_parameters{180});
  expect_sound(*surface);
  ASSERT_EQ(surface->curves.size(), 1u);
  EXPECT_EQ(surface->curves[0]->vertices.size(), 5u);
  for (int v : surface->curves[0]->vertices)
    EXPECT_EQ(block.points[v].head<2>(), Eigen::Vector2d(2, 2));
  EXPECT_EQ(surface->corners.size(), 2u);
}

// Where four regions meet along an axis, and leave through two sides
TEST(Boundary_surface, has_curves_where_sheets_of_regions_meet)
{
  const Block block(4, 4, 4);
  std::vector<int> labels;
  for (const Hexahedron& h : block.hexahedra)
    labels.push_back((block.points[h[0]][0] >= 2) + 2 * (block.points[h[0]][1] >= 2));
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {labels, {}});
  const Surface_faces faces = boundary_surface_faces(complex);
  const auto surface = boundary_as_reference(complex, faces, block.points, Feature_parameters{180});
  expect_sound(*surface);
  EXPECT_EQ(surface->number_of_sheets(), 8u);
  // the axis, four spokes on either side, and four uprights where the interfaces leave
  EXPECT_EQ(surface->curves.size(), 1u + 8u + 4u);
  Boundary_attachment attachment = attach_to_own_boundary(complex, *surface);
  attachment.set_sheets(faces);
  for (int v = 0; v < int(block.points.size()); ++v) {
    const Vector_3& p = block.points[v];
    const bool is_on_x = p[0] == 2, is_on_y = p[1] == 2;
    if (attachment.kind[v] == Vertex_kind::SURFACE) {
      EXPECT_FALSE(is_on_x && is_on_y);
      // the sheet has the vertex
      double nearest = surface->closest_point(p, Surface_point::no_triangle, attachment.sheet[v]).coordinates[0];
      EXPECT_GE(nearest, -1e-12);
      EXPECT_EQ(surface->closest_point(p, Surface_point::no_triangle, attachment.sheet[v]).point, p);
    }
    if (is_on_x && is_on_y) {
      EXPECT_NE(attachment.kind[v], Vertex_kind::INTERIOR);
      EXPECT_EQ(attachment.kind[v] == Vertex_kind::CORNER, p[2] == 0 || p[2] == 4);
    }
  }
}

TEST(Boundary_surface, is_split_sheet_by_sheet)
{
  const Block block(2, 1, 1);
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {{5, 2}, {}});
  const Surface_faces faces = boundary_surface_faces(complex);
  const Triangle_surface surface = as_triangle_surface(faces, block.points);
  ASSERT_EQ(surface.triangles.size(), 2 * faces.quads.size());
  ASSERT_EQ(surface.number_of_sheets(), 3u); // between them, around the one, around the other
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    EXPECT_EQ(surface.sheet(t), faces.sheet(int(t / 2)));
    for (int v : surface.triangles[t])
      EXPECT_EQ(std::count(faces.quads[t / 2].begin(), faces.quads[t / 2].end(), v), 1);
  }
}

// A mesh behind the vertices of another surface: only its own corners and curves are taken
TEST(Boundary_surface, is_attached_to_by_identity_from_the_first_vertex_on)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  Positions points = block.points; // another block before it, with all its features
  points.insert(points.end(), block.points.begin(), block.points.end());
  const int first = int(block.points.size());
  std::vector<Triangle_indices> triangles = boundary_triangles(complex);
  std::vector<int> sheets(triangles.size(), 0);
  Edge_list sharp = sharp_boundary_edges(complex, block.points, 45);
  for (Triangle_indices t : boundary_triangles(complex)) {
    triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    sheets.push_back(1);
  }
  const std::size_t count = sharp.size();
  for (std::size_t e = 0; e < count; ++e)
    sharp.push_back({sharp[e][0] + first, sharp[e][1] + first});
  const Reference_surface surface(points, triangles, sharp, true, Feature_parameters(), sheets);
  ASSERT_EQ(surface.curves.size(), 24u);
  ASSERT_EQ(surface.corners.size(), 16u);
  Boundary_attachment attachment(complex);
  attach_by_identity(complex, surface, first, attachment);
  for (int v = 0; v < first; ++v) {
    const Vertex_kind kinds[4] = {Vertex_kind::INTERIOR, Vertex_kind::SURFACE, Vertex_kind::FEATURE,
                                  Vertex_kind::CORNER};
    EXPECT_EQ(attachment.kind[v], kinds[extreme_coordinates(block.points[v] / 2)]);
    if (attachment.kind[v] == Vertex_kind::FEATURE) {
      EXPECT_GE(surface.curves[attachment.curve[v]]->vertices.front(), first);
    }
  }
}

} // namespace
