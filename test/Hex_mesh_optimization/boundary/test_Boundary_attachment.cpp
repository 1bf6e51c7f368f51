// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The vertices of a mesh that are attached to corners, curves and faces of a reference.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Attachment_by_matching.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve_tracer.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include "../Generated_mesh.h"
#include "../reference_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

struct Reference
{
  Positions points;
  std::vector<Triangle_indices> triangles;

  // The boundary of another mesh of the same solid, each quad split the other way
  static Reference of(const Generated_mesh& mesh)
  {
    Reference result;
    std::map<int, int> number;
    const auto vertex = [&](int v) {
      const auto inserted = number.emplace(v, static_cast<int>(result.points.size()));
      if (inserted.second)
        result.points.push_back(mesh.points[v]);
      return inserted.first->second;
    };
    for (const auto& face : mesh.complex.boundary_faces) {
      const std::array<int, 4>& q = face.vertices;
      result.triangles.push_back({vertex(q[1]), vertex(q[2]), vertex(q[3])});
      result.triangles.push_back({vertex(q[1]), vertex(q[3]), vertex(q[0])});
    }
    return result;
  }

  std::unique_ptr<Reference_surface> traced() const
  {
    return std::make_unique<Reference_surface>(points, triangles, sharp_edges(points, triangles, 45), false,
                                               Feature_parameters());
  }
};

TEST(Boundary_attachment_by_matching, puts_the_vertices_of_a_cube_on_another_cube)
{
  const Generated_mesh mesh = block(4);
  for (std::size_t n : {1, 3, 7}) {
    SCOPED_TRACE(n);
    const auto surface = Reference::of(block(n)).traced();
    expect_sound(*surface);
    ASSERT_EQ(surface->curves.size(), 12u);
    ASSERT_EQ(surface->corners.size(), 8u);
    const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, *surface).attachment;
    const Vertex_kind kinds[4] = {Vertex_kind::INTERIOR, Vertex_kind::SURFACE, Vertex_kind::FEATURE,
                                  Vertex_kind::CORNER};
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Vector_3& p = mesh.points[v];
      EXPECT_EQ(attachment.kind[v], kinds[extreme_coordinates(p)]) << v;
      if (attachment.kind[v] == Vertex_kind::CORNER) {
        EXPECT_LT((attachment.corner[v] - p).norm(), 1e-12);
      }
      if (attachment.kind[v] == Vertex_kind::FEATURE) {
        const Curve_point q = surface->curves[attachment.curve[v]]->closest_point(p);
        EXPECT_LT((q.point - p).norm(), 1e-12);
        EXPECT_NEAR(q.tangent.norm(), 1, 1e-12);
      }
    }
  }
}

// Vertices of the mesh near, not on, the cube
TEST(Boundary_attachment_by_matching, tolerates_a_mesh_off_the_surface)
{
  const Generated_mesh mesh = block(5);
  Positions points = mesh.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += .04 * Vector_3(std::sin(3. * v), std::sin(5. * v + 1), std::sin(7. * v + 2));
  const auto surface = Reference::of(block(3)).traced();
  const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, points, *surface).attachment;
  const Vertex_kind kinds[4] = {Vertex_kind::INTERIOR, Vertex_kind::SURFACE, Vertex_kind::FEATURE, Vertex_kind::CORNER};
  for (std::size_t v = 0; v < points.size(); ++v) {
    EXPECT_EQ(attachment.kind[v], kinds[extreme_coordinates(mesh.points[v])]) << v;
    if (attachment.kind[v] == Vertex_kind::CORNER) {
      EXPECT_LT((attachment.corner[v] - mesh.points[v]).norm(), 1e-12);
    }
    if (attachment.kind[v] == Vertex_kind::FEATURE) {
      const Curve_point q = surface->curves[attachment.curve[v]]->closest_point(mesh.points[v]);
      EXPECT_LT((q.point - mesh.points[v]).norm(), 1e-12);
    }
  }
}

TEST(Boundary_attachment_by_matching, follows_closed_curves)
{
  const Generated_mesh mesh = cylinder(4);
  for (std::size_t n : {3, 6}) {
    SCOPED_TRACE(n);
    const auto surface = Reference::of(cylinder(n)).traced();
    ASSERT_EQ(surface->curves.size(), 2u);
    const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, *surface).attachment;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Vector_3& p = mesh.points[v];
      const bool on_rim = std::abs(p.head<2>().norm() - 1) < 1e-9 &&
                          (std::abs(p[2]) < 1e-9 || std::abs(p[2] - 2) < 1e-9);
      EXPECT_EQ(attachment.kind[v] == Vertex_kind::FEATURE, on_rim) << v;
      if (attachment.kind[v] == Vertex_kind::FEATURE) {
        EXPECT_NEAR(surface->curves[attachment.curve[v]]->closest_point(p).point[2], p[2], 1e-9);
      }
    }
  }
}

// The shortest path between its ends is the one edge that the curve leaves out
TEST(Boundary_attachment_by_matching, goes_round_an_almost_closed_curve)
{
  const Generated_mesh mesh = cylinder(4);
  const Reference rim = Reference::of(mesh);
  Edge_list sharp;
  for (const std::array<int, 2>& edge : sharp_edges(rim.points, rim.triangles, 45))
    if (rim.points[edge[0]][2] > 1 && rim.points[edge[1]][2] > 1)
      sharp.push_back(edge);
  const std::size_t number = sharp.size();
  sharp.pop_back();
  const Reference_surface surface(rim.points, rim.triangles, sharp, true, Feature_parameters());
  ASSERT_EQ(surface.curves.size(), 1u);
  ASSERT_FALSE(surface.curves[0]->is_closed());
  const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, surface).attachment;
  EXPECT_EQ(std::count(attachment.kind.begin(), attachment.kind.end(), Vertex_kind::CORNER), 2);
  EXPECT_EQ(std::size_t(std::count(attachment.kind.begin(), attachment.kind.end(), Vertex_kind::FEATURE)), number - 2);
}

// Two curves across a plate whose ends and nearest vertices are those of one row: the one that is nearer to it gets it,
// whichever is first.
TEST(Boundary_attachment_by_matching, leaves_vertices_to_the_curve_that_needs_them_more)
{
  const Generated_mesh mesh([](auto& p, auto& h) { HMO::make_block(p, h, {{8, 4, 1}}, {{2, 1, .25}}); });
  for (bool mirrored : {false, true}) {
    SCOPED_TRACE(mirrored);
    const double nearer = mirrored ? .55 : .45, other = mirrored ? .4 : .6;
    const Generated_mesh plate([&](auto& p, auto& h) {
      HMO::make_block(p, h, {{8, 3, 1}}, {{2, 1, .25}});
      for (auto& q : p) {
        const double rows[4] = {0, (std::min)(nearer, other), (std::max)(nearer, other), 1};
        q = std::decay_t<decltype(q)>(q.x(), rows[std::lround(3 * q.y())], q.z());
      }
    });
    const Reference reference = Reference::of(plate);
    Edge_list sharp;
    Triangle_adjacency(reference.triangles).for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      const std::array<int, 2> e = sides[0].edge;
      const Vector_3 &a = reference.points[e[0]], &b = reference.points[e[1]];
      if (a[2] > .2 && b[2] > .2 && a[1] == b[1] && (a[1] == nearer || a[1] == other))
        sharp.push_back(e);
    });
    const Reference_surface surface(reference.points, reference.triangles, sharp, true, Feature_parameters());
    ASSERT_EQ(surface.curves.size(), 2u);
    const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, surface).attachment;
    int in_row = 0, elsewhere = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (attachment.kind[v] == Vertex_kind::FEATURE) {
        const Vector_3& p = mesh.points[v];
        EXPECT_NEAR(p[2], .25, 1e-12);
        const double y = surface.curves[attachment.curve[v]]->closest_point(p).point[1];
        if (std::abs(y - nearer) < 1e-9) {
          ++in_row;
          EXPECT_NEAR(p[1], .5, 1e-12);
        }
        else
          ++elsewhere;
      }
    EXPECT_GE(in_row, 7);
    EXPECT_GE(elsewhere, 7);
  }
}

// A crease across the top of a cube that swerves by a little more than half of an edge: to swerve with it would take
// corners of faces with both of their edges on it, which are flat where it is straight
TEST(Boundary_attachment_by_matching, goes_straight_on_rather_than_round_corners_of_faces)
{
  const int n = 12;
  const Generated_mesh mesh = block(n);
  Reference reference = Reference::of(mesh);
  std::vector<int> crease(n + 1, -1);
  for (std::size_t v = 0; v < reference.points.size(); ++v) {
    Vector_3& p = reference.points[v];
    if (p.z() == 1 && std::abs(p.y() - .5) < 1e-9) {
      crease[std::lround(n * p.x())] = static_cast<int>(v);
      if (p.x() > .2 && p.x() < .8)
        p.y() += .6 / n;
    }
  }
  auto sharp = sharp_edges(reference.points, reference.triangles, 45);
  for (int i = 0; i < n; ++i)
    sharp.push_back({(std::min)(crease[i], crease[i + 1]), (std::max)(crease[i], crease[i + 1])});
  const Reference_surface surface(reference.points, reference.triangles, sharp, true, Feature_parameters());
  const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, surface).attachment;
  int on_crease = 0;
  for (std::size_t e = 0; e < mesh.complex.edges.size(); ++e) {
    const Vector_3 &a = mesh.points[mesh.complex.edges[e][0]], &b = mesh.points[mesh.complex.edges[e][1]];
    const Vector_3 middle = (a + b) / 2;
    const bool is_inside_the_top = middle.z() == 1 && middle.x() > 0 && middle.x() < 1 && middle.y() > 0 &&
                                   middle.y() < 1;
    if (attachment.curve_of_edge[e] >= 0 && is_inside_the_top) {
      ++on_crease;
      EXPECT_NEAR(middle.y(), .5, 1e-9) << middle.x();
    }
  }
  EXPECT_EQ(on_crease, n);
}

TEST(Boundary_attachment_by_matching, of_an_l_keeps_the_reentrant_edge)
{
  const Generated_mesh mesh = l_shape(3);
  const auto surface = Reference::of(l_shape(2)).traced();
  const auto own = attach_to_own_boundary(mesh.complex, *mesh.own_reference());
  const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, *surface).attachment;
  EXPECT_EQ(attachment.kind, own.kind);
}

// A mesh of half the cube must not reach for the features of the other half
TEST(Boundary_attachment_by_matching, leaves_features_alone_that_are_far_away)
{
  const Generated_mesh mesh([](auto& p, auto& h) { HMO::make_block(p, h, {{2, 4, 4}}, {{.5, 1, 1}}); });
  const auto surface = Reference::of(block(3)).traced();
  const Boundary_attachment attachment = Attachment_by_matching(mesh.complex, mesh.points, *surface).attachment;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (attachment.kind[v] == Vertex_kind::CORNER) {
      EXPECT_LT((attachment.corner[v] - mesh.points[v]).norm(), 1e-12);
    }
    if (attachment.kind[v] == Vertex_kind::FEATURE) {
      const Curve_point q = surface->curves[attachment.curve[v]]->closest_point(mesh.points[v]);
      EXPECT_LT((q.point - mesh.points[v]).norm(), 1e-12);
    }
  }
}

TEST(Boundary_attachment, of_unused_vertices_is_none)
{
  const Generated_mesh mesh = block(2);
  Positions points = mesh.points;
  points.emplace_back(5, 5, 5);
  const Hexahedral_complex complex(points.size(), mesh.complex.hexahedra);
  EXPECT_EQ(Boundary_attachment(complex).kind.back(), Vertex_kind::FIXED);
}

} // namespace
