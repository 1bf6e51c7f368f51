// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which hexahedra the connectivity limits, and that their limits are neither
// exceeded nor too high.

#include <CGAL/Hex_mesh_optimization/internal/boundary/connectivity_limits.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "../hexahedron_rotations.h"
#include "../mesh_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;
using HMO::Connectivity_limit;
using Reason = HMO::Connectivity_limit_reason;
using Limits = std::map<std::size_t, std::pair<Reason, double>>;

double sine(double degrees) { return std::sin(degrees * pi / 180); }

Boundary_attachment own_attachment(const Indexed_mesh& mesh, double angle_bound = 45)
{
  const Hexahedral_complex complex = mesh.complex();
  Positions points;
  for (const auto& p : mesh.points)
    points.emplace_back(p.x(), p.y(), p.z());
  const auto surface = boundary_as_reference(complex, points, Feature_parameters{angle_bound});
  return attach_to_own_boundary(complex, *surface);
}

// The limits by hexahedron, once what holds for every result is checked.
Limits limits(const Hexahedral_complex& complex, const Boundary_attachment& attachment)
{
  Limits result;
  for (const Connectivity_limit& l : connectivity_limits(complex, attachment)) {
    EXPECT_TRUE(result.empty() || result.rbegin()->first < l.hexahedron);
    EXPECT_LT(l.hexahedron, complex.hexahedra.size());
    EXPECT_GE(l.largest_scaled_jacobian, 0);
    EXPECT_LT(l.largest_scaled_jacobian, 1);
    result[l.hexahedron] = {l.reason, l.largest_scaled_jacobian};
  }
  return result;
}

Limits limits(const Indexed_mesh& mesh, double angle_bound = 45)
{
  return limits(mesh.complex(), own_attachment(mesh, angle_bound));
}

void expect_limit(const Limits& limits, std::size_t hexahedron, Reason reason, double bound)
{
  const auto found = limits.find(hexahedron);
  ASSERT_NE(found, limits.end()) << hexahedron;
  EXPECT_EQ(found->second.first, reason) << hexahedron << ": " << HMO::description(found->second.first);
  EXPECT_NEAR(found->second.second, bound, 1e-12) << hexahedron;
}

// The hexahedra at each edge of a mesh, in terms of its input
std::map<std::pair<std::size_t, std::size_t>, std::set<std::size_t>> hexahedra_at_edges(const Indexed_mesh& mesh)
{
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::size_t>> result;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    for (const auto& e : hexahedron_edges)
      result[std::minmax(mesh.hexahedra[h][e[0]], mesh.hexahedra[h][e[1]])].insert(h);
  return result;
}

TEST(Connectivity_limits, of_regular_meshes_are_none)
{
  for (std::size_t n : {1, 2, 3}) {
    Indexed_mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{n, n, n}});
    EXPECT_TRUE(limits(mesh).empty()) << n;
    HMO::make_block(mesh.points, mesh.hexahedra, {{n, 2, 4}});
    EXPECT_TRUE(limits(mesh).empty()) << n;
  }
  for (const Mesh_family& family : mesh_families()) {
    const std::string name = family.name;
    if (name != "cylinder" && name != "ball") {
      EXPECT_TRUE(limits(family()).empty()) << name;
    }
  }
}

// Four lines with three hexahedra around them run along the corners of the core.
TEST(Connectivity_limits, of_a_cylinder_are_at_the_lines_with_three_hexahedra)
{
  for (std::size_t n : {2, 3, 5}) {
    SCOPED_TRACE(n);
    const std::size_t n_along = 3;
    Indexed_mesh mesh;
    HMO::make_cylinder(mesh.points, mesh.hexahedra, n, n_along);
    std::set<std::size_t> at_lines;
    for (const auto& edge : hexahedra_at_edges(mesh)) {
      const auto &a = mesh.points[edge.first.first], &b = mesh.points[edge.first.second];
      if (edge.second.size() == 3 && a.x() == b.x() && a.y() == b.y())
        at_lines.insert(edge.second.begin(), edge.second.end());
    }
    EXPECT_EQ(at_lines.size(), 4 * 3 * n_along);
    const Limits found = limits(mesh);
    EXPECT_EQ(found.size(), at_lines.size());
    for (std::size_t h : at_lines)
      expect_limit(found, h, Reason::INTERIOR_EDGE, sine(120));
  }
}

// Lines with three hexahedra run along the edges of the core and from its corners to the sphere. Where they meet there
// are four hexahedra, at best with the corner of four rays to the corners of a tetrahedron.
TEST(Connectivity_limits, of_a_ball_are_at_the_lines_with_three_hexahedra)
{
  for (std::size_t n : {3, 4}) {
    SCOPED_TRACE(n);
    Indexed_mesh mesh;
    HMO::make_ball(mesh.points, mesh.hexahedra, n);
    std::map<std::size_t, std::set<std::size_t>> at_vertices;
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      for (std::size_t v : mesh.hexahedra[h])
        at_vertices[v].insert(h);
    std::set<std::size_t> at_corners, at_lines;
    std::size_t lines = 0;
    for (const auto& edge : hexahedra_at_edges(mesh))
      if (edge.second.size() == 3) {
        at_lines.insert(edge.second.begin(), edge.second.end());
        ++lines;
      }
    const std::size_t shells = n / 2;
    EXPECT_EQ(lines, 12 * n + 8 * shells);
    const auto boundary = mesh.complex().is_on_boundary;
    for (const auto& vertex : at_vertices)
      if (!boundary[vertex.first] && vertex.second.size() == 4)
        at_corners.insert(vertex.second.begin(), vertex.second.end());
    EXPECT_EQ(at_corners.size(), 8u * 4);

    const Limits found = limits(mesh);
    EXPECT_EQ(found.size(), at_lines.size());
    for (std::size_t h : at_lines)
      if (at_corners.count(h))
        expect_limit(found, h, Reason::INTERIOR_VERTEX, std::sqrt(16. / 27));
      else
        expect_limit(found, h, Reason::INTERIOR_EDGE, sine(120));
  }
}

TEST(Connectivity_limits, do_not_depend_on_the_numbering)
{
  const auto rotations = numberings(1);
  std::mt19937 random(5);
  for (const Mesh_family& family : mesh_families()) {
    Indexed_mesh mesh = family();
    const Limits expected = limits(mesh);
    for (auto& h : mesh.hexahedra) {
      const auto& rotation = rotations[random() % rotations.size()];
      std::array<std::size_t, 8> rotated;
      for (std::size_t k = 0; k < 8; ++k)
        rotated[k] = h[rotation[k]];
      h = rotated;
    }
    EXPECT_EQ(limits(mesh), expected) << family.name;

    // hexahedra in another order
    std::vector<std::size_t> order(mesh.hexahedra.size());
    for (std::size_t h = 0; h < order.size(); ++h)
      order[h] = h;
    std::shuffle(order.begin(), order.end(), random);
    Indexed_mesh shuffled{mesh.points, {}};
    for (std::size_t h : order)
      shuffled.hexahedra.push_back(mesh.hexahedra[h]);
    Limits back;
    for (const auto& l : limits(shuffled))
      back[order[l.first]] = l.second;
    EXPECT_EQ(back, expected) << family.name;
  }
}

TEST(Connectivity_limits, make_a_hexahedron_flat_at_a_smooth_edge)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{2, 2, 2}});
  const Hexahedral_complex complex = mesh.complex();
  for (std::size_t h = 0; h < 8; ++h) {
    // the half of an edge of the block from one of its corners
    Boundary_attachment attachment = own_attachment(mesh);
    const auto is_corner = [&](int v) { return attachment.kind[v] == Vertex_kind::CORNER; };
    for (int directed : complex.hexahedron_edges[h])
      if (is_corner(complex.source(directed)) || is_corner(complex.target(directed))) {
        attachment.curve_of_edge[directed / 2] = -1;
        break;
      }
    const Limits found = limits(complex, attachment);
    EXPECT_EQ(found.size(), 1u);
    expect_limit(found, h, Reason::FLAT_EDGE, 0);
  }
}

TEST(Connectivity_limits, claim_nothing_at_fixed_vertices_and_corners)
{
  Indexed_mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{1, 1, 1}});
  const Hexahedral_complex cube = mesh.complex();
  Boundary_attachment attachment(cube);
  EXPECT_EQ(limits(cube, attachment).size(), 1u);
  for (Vertex_kind kind : {Vertex_kind::CORNER, Vertex_kind::FIXED}) {
    std::fill(attachment.kind.begin(), attachment.kind.end(), kind);
    EXPECT_TRUE(limits(cube, attachment).empty());
  }
  for (const Mesh_family& family : mesh_families()) {
    const Hexahedral_complex complex = family().complex();
    Boundary_attachment fixed(complex);
    std::fill(fixed.kind.begin(), fixed.kind.end(), Vertex_kind::FIXED);
    EXPECT_TRUE(limits(complex, fixed).empty()) << family.name;
  }
}

// The hexahedra around vertex 0, one for each triangle of the surface that a small sphere around the vertex shows: an
// edge of the mesh for each vertex of it and a face for each edge. All boundary vertices but 0 are fixed.
struct Star
{
  Hexahedral_complex complex;
  Boundary_attachment attachment;

  explicit Star(const std::vector<std::array<int, 3>>& triangles) : complex(of(triangles)), attachment(complex)
  {
    for (std::size_t v = 1; v < attachment.kind.size(); ++v)
      if (complex.is_on_boundary[v])
        attachment.kind[v] = Vertex_kind::FIXED;
  }

  // Around an interior edge: triangles from the vertex n to the vertices 0, ..., n - 1 of a polygon
  static Star wheel(int n)
  {
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < n; ++i)
      triangles.push_back({n, i, (i + 1) % n});
    return Star(triangles);
  }

  // A curve runs through vertex 0 along two edges.
  void add_curve(int a, int b)
  {
    attachment.kind[0] = Vertex_kind::FEATURE;
    attachment.curve[0] = 7;
    for (int end : {a, b})
      attachment.curve_of_edge[complex.find_edge(0, 1 + end) / 2] = 7;
  }

private:
  static Hexahedral_complex of(const std::vector<std::array<int, 3>>& triangles)
  {
    int next = 1;
    for (const auto& t : triangles)
      next = (std::max)(next, 2 + *std::max_element(t.begin(), t.end()));
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto inserted = middles.emplace(std::minmax(a, b), next);
      next += inserted.second;
      return inserted.first->second;
    };
    std::vector<Hexahedron> hexahedra;
    for (const auto& t : triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      hexahedra.push_back({0, 1 + t[0], ab, 1 + t[1], 1 + t[2], ca, next, bc});
      ++next;
    }
    return Hexahedral_complex(next, hexahedra);
  }
};

TEST(Connectivity_limits, at_interior_vertices)
{
  const std::vector<std::array<int, 3>> tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
  std::vector<std::array<int, 3>> octahedron, icosahedron;
  for (int i = 0; i < 4; ++i) {
    octahedron.push_back({4, i, (i + 1) % 4});
    octahedron.push_back({5, (i + 1) % 4, i});
  }
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    icosahedron.push_back({10, i, j});
    icosahedron.push_back({i, 5 + i, j});
    icosahedron.push_back({j, 5 + i, 5 + j});
    icosahedron.push_back({11, 5 + j, 5 + i});
  }
  const Star of_four(tetrahedron), of_eight(octahedron), of_twenty(icosahedron);
  const Limits four = limits(of_four.complex, of_four.attachment),
               twenty = limits(of_twenty.complex, of_twenty.attachment);
  EXPECT_TRUE(limits(of_eight.complex, of_eight.attachment).empty());
  EXPECT_EQ(four.size(), 4u);
  EXPECT_EQ(twenty.size(), 20u);
  // neighboring corners of a regular tetrahedron and icosahedron, seen from the center, have these cosines
  for (const auto& expected : {std::make_pair(four, -1. / 3), std::make_pair(twenty, 1 / std::sqrt(5.))})
    for (const auto& l : expected.first)
      expect_limit(expected.first, l.first, Reason::INTERIOR_VERTEX,
                   (1 - expected.second) * std::sqrt(1 + 2 * expected.second));
}

TEST(Connectivity_limits, at_interior_edges)
{
  for (int n = 3; n < 10; ++n) {
    SCOPED_TRACE(n);
    const Star star = Star::wheel(n);
    const Limits found = limits(star.complex, star.attachment);
    EXPECT_EQ(found.size(), n == 4 ? 0u : std::size_t(n));
    for (const auto& l : found)
      expect_limit(found, l.first, Reason::INTERIOR_EDGE, sine(360. / n));
  }
}

// Eight boundary faces around a smooth vertex, and inside no edge with more than six hexahedra
TEST(Connectivity_limits, at_smooth_vertices_concern_hexahedra_with_a_boundary_face)
{
  std::vector<std::array<int, 3>> triangles; // an octagon 0 ... 7 around a square 8 ... 11 around 12
  for (int i = 0; i < 4; ++i) {
    const int b = 2 * i, t = 8 + i, u = 8 + (i + 1) % 4;
    triangles.push_back({t, (b + 7) % 8, b});
    triangles.push_back({t, b, b + 1});
    triangles.push_back({t, b + 1, u});
    triangles.push_back({12, t, u});
  }
  const Star star(triangles);
  const Limits found = limits(star.complex, star.attachment);
  EXPECT_EQ(found.size(), 16u);
  for (std::size_t h = 0; h < 16; ++h)
    if (h % 4 < 2)
      expect_limit(found, h, Reason::SMOOTH_VERTEX, sine(45));
    else if (h % 4 == 3)
      expect_limit(found, h, Reason::INTERIOR_EDGE, sine(60));
}

// A curve passes a vertex with five boundary faces
TEST(Connectivity_limits, at_curves)
{
  Star star = Star::wheel(5);
  star.add_curve(0, 3);
  const Limits three_and_two = limits(star.complex, star.attachment);
  for (std::size_t h = 0; h < 3; ++h)
    expect_limit(three_and_two, h, Reason::CURVE_VERTEX, sine(60));
  for (std::size_t h = 3; h < 5; ++h)
    expect_limit(three_and_two, h, Reason::INTERIOR_EDGE, sine(72));

  star = Star::wheel(5);
  star.add_curve(2, 1);
  const Limits one_and_four = limits(star.complex, star.attachment);
  for (std::size_t h = 0; h < 5; ++h)
    if (h == 1)
      expect_limit(one_and_four, h, Reason::FLAT_CURVE, 0);
    else
      expect_limit(one_and_four, h, Reason::CURVE_VERTEX, sine(45));

  star.attachment.kind[0] = Vertex_kind::CORNER; // where the curve may turn
  for (const auto& l : limits(star.complex, star.attachment))
    EXPECT_EQ(l.second.first, Reason::INTERIOR_EDGE);
}

// n columns around an axis at the origin, each over a rhombus with the same angle at the axis, three layers high
Indexed_mesh rhombi(int n, double degrees)
{
  const bool closed = degrees == 360;
  const int sides = closed ? n : n + 1, layer = 1 + sides + n;
  const double angle = degrees / n * pi / 180;
  Indexed_mesh mesh;
  const auto direction = [&](int i) {
    return Indexed_mesh::Kernel::Vector_3(std::cos(i * angle), std::sin(i * angle), 0);
  };
  for (int z = 0; z <= 3; ++z) {
    const Indexed_mesh::Point center(0, 0, z);
    mesh.points.push_back(center);
    for (int i = 0; i < sides; ++i)
      mesh.points.push_back(center + direction(i));
    for (int i = 0; i < n; ++i)
      mesh.points.push_back(center + direction(i) + direction(i + 1));
  }
  for (int z = 0; z < 3; ++z)
    for (int i = 0; i < n; ++i) {
      const int bottom[4] = {0, 1 + i, 1 + sides + i, 1 + (i + 1) % sides};
      std::array<std::size_t, 8> h;
      for (int k = 0; k < 4; ++k) {
        h[k] = bottom[k] + z * layer;
        h[k + 4] = bottom[k] + (z + 1) * layer;
      }
      mesh.hexahedra.push_back(h);
    }
  return mesh;
}

TEST(Connectivity_limits, are_reached_around_an_interior_edge)
{
  for (int n : {3, 5, 6, 7}) {
    SCOPED_TRACE(n);
    const Indexed_mesh mesh = rhombi(n, 360);
    const Limits found = limits(mesh);
    ASSERT_EQ(found.size(), mesh.hexahedra.size());
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      expect_limit(found, h, Reason::INTERIOR_EDGE, HMO::scaled_jacobians(mesh.points, mesh.hexahedra)[h]);
  }
}

// The axis of a half: an edge within its flat side, at whose ends the rim passes
TEST(Connectivity_limits, are_reached_around_a_smooth_edge)
{
  EXPECT_TRUE(limits(rhombi(2, 180)).empty());
  for (int n : {3, 4, 5}) {
    SCOPED_TRACE(n);
    const Indexed_mesh mesh = rhombi(n, 180);
    const Limits found = limits(mesh, 30); // its other edges are sharp by 180 / n degrees or more
    ASSERT_EQ(found.size(), mesh.hexahedra.size());
    for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
      expect_limit(found, h, h / n == 1 ? Reason::SMOOTH_EDGE : Reason::CURVE_VERTEX,
                   HMO::scaled_jacobians(mesh.points, mesh.hexahedra)[h]);
  }
}

// Not all hexahedra around an edge beat its limit at once, wherever the vertices are
TEST(Connectivity_limits, of_interior_edges_are_not_exceeded)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-.1, .1);
  for (int n : {3, 5, 6})
    for (int trial = 0; trial < 200; ++trial) {
      Indexed_mesh mesh = rhombi(n, 360);
      const double bound = limits(mesh).at(0).second;
      for (auto& p : mesh.points)
        p = {p.x() + shift(random), p.y() + shift(random), p.z() + shift(random)};
      EXPECT_LE(HMO::quality_statistics(mesh.points, mesh.hexahedra).minimum, bound);
    }
}

TEST(Largest_determinant, is_that_of_the_best_corner_with_a_solid_angle)
{
  std::mt19937 random(1);
  std::normal_distribution<double> coordinate;
  for (int trial = 0; trial < 100000; ++trial) {
    Vector_3 a[3];
    for (Vector_3& x : a)
      x = Vector_3(coordinate(random), coordinate(random), coordinate(random)).normalized();
    const double d = a[0].cross(a[1]).dot(a[2]);
    if (d <= 0)
      continue;
    const double solid_angle = 2 * std::atan2(d, 1 + a[0].dot(a[1]) + a[1].dot(a[2]) + a[2].dot(a[0]));
    EXPECT_LE(d, largest_determinant(solid_angle) + 1e-12);
  }
  EXPECT_NEAR(largest_determinant(pi / 2), 1, 1e-15);
  EXPECT_NEAR(largest_determinant(pi), std::sqrt(16. / 27), 1e-15); // of a regular tetrahedron
  EXPECT_EQ(largest_determinant(2 * pi), 0);
}

TEST(Connectivity_limit, is_described_in_words)
{
  std::set<std::string> descriptions;
  for (Reason reason : {Reason::FLAT_EDGE, Reason::FLAT_CURVE, Reason::INTERIOR_EDGE, Reason::INTERIOR_VERTEX,
                        Reason::CURVE_VERTEX, Reason::SMOOTH_EDGE, Reason::SMOOTH_VERTEX})
    descriptions.insert(HMO::description(reason));
  EXPECT_EQ(descriptions.size(), 7u);
  EXPECT_EQ(descriptions.count(""), 0u);
}

} // namespace
