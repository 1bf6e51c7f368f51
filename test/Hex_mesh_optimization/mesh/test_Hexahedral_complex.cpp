// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Connectivity of meshes small enough to count by hand, and the meshes that have no usable connectivity.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>

#include "../block_of_cubes.h"

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

std::set<int> as_set(const Grouped_array::Group& group) { return std::set<int>(group.begin(), group.end()); }

// 0 1 2 / 3 4 5 at the bottom, 6 7 8 / 9 10 11 at the top
TEST(Hexahedral_complex, of_two_hexahedra)
{
  const Block block(2, 1, 1);
  const Hexahedral_complex complex = block.complex();
  ASSERT_EQ(complex.number_of_vertices(), 12u);
  const std::vector<std::array<int, 2>> edges = {{0, 1}, {0, 3}, {0, 6},  {1, 2},  {1, 4},  {1, 7},  {2, 5},
                                                 {2, 8}, {3, 4}, {3, 9},  {4, 5},  {4, 10}, {5, 11}, {6, 7},
                                                 {6, 9}, {7, 8}, {7, 10}, {8, 11}, {9, 10}, {10, 11}};
  EXPECT_EQ(complex.edges, edges);

  ASSERT_EQ(complex.interior_faces.size(), 1u);
  EXPECT_EQ(complex.interior_faces[0][0], std::make_pair(0, 3)); // the face 1 4 10 7
  EXPECT_EQ(complex.interior_faces[0][1], std::make_pair(1, 5));

  ASSERT_EQ(complex.boundary_faces.size(), 10u);
  const std::array<int, 4> faces[10] = {{0, 3, 4, 1}, {6, 7, 10, 9},  {0, 1, 7, 6}, {4, 3, 9, 10}, {3, 0, 6, 9},
                                        {1, 4, 5, 2}, {7, 8, 11, 10}, {1, 2, 8, 7}, {2, 5, 11, 8}, {5, 4, 10, 11}};
  for (int f = 0; f < 10; ++f) {
    EXPECT_EQ(complex.boundary_faces[f].vertices, faces[f]) << f;
    EXPECT_EQ(complex.boundary_faces[f].hexahedron, f / 5) << f;
  }

  EXPECT_EQ(complex.boundary_edges.size(), 20u);
  for (const auto& e : complex.boundary_edges) {
    const auto runs_along = [&](int face, int a, int b) {
      const std::array<int, 4>& q = complex.boundary_faces[face].vertices;
      for (int i = 0; i < 4; ++i)
        if (q[i] == a && q[(i + 1) % 4] == b)
          return true;
      return false;
    };
    EXPECT_TRUE(runs_along(e.left, complex.edges[e.edge][0], complex.edges[e.edge][1]));
    EXPECT_TRUE(runs_along(e.right, complex.edges[e.edge][1], complex.edges[e.edge][0]));
  }
  EXPECT_EQ(complex.is_on_boundary, std::vector<char>(12, true));
  EXPECT_EQ(complex.is_used, std::vector<char>(12, true));
  EXPECT_EQ(complex.is_boundary_edge, std::vector<char>(20, true));
  for (int v = 0; v < 12; ++v) {
    const int i = v % 3;
    EXPECT_EQ(as_set(complex.vertex_hexahedra[v]), i == 0   ? std::set<int>{0}
                                                   : i == 2 ? std::set<int>{1}
                                                            : (std::set<int>{0, 1}))
      << v;
    EXPECT_EQ(complex.vertex_boundary_faces[v].size(), i == 1 ? 4u : 3u) << v;
  }
}

TEST(Hexahedral_complex, directs_edges)
{
  const Hexahedral_complex complex = Block(2, 1, 1).complex();
  for (std::size_t h = 0; h < 2; ++h)
    for (int k = 0; k < 12; ++k) {
      const int directed = complex.hexahedron_edges[h][k];
      EXPECT_EQ(complex.source(directed), complex.hexahedra[h][hexahedron_edges[k][0]]);
      EXPECT_EQ(complex.target(directed), complex.hexahedra[h][hexahedron_edges[k][1]]);
      EXPECT_EQ(complex.find_edge(complex.source(directed), complex.target(directed)), directed);
      EXPECT_EQ(complex.find_edge(complex.target(directed), complex.source(directed)), opposite_edge(directed));
    }
  for (int c = 0; c < 8; ++c)
    for (int k = 0; k < 3; ++k) {
      const int local = corner_edges[c][k];
      const int directed = complex.hexahedron_edges[0][local / 2] ^ (local & 1);
      EXPECT_EQ(complex.source(directed), complex.hexahedra[0][c]);
      EXPECT_EQ(complex.target(directed), complex.hexahedra[0][corner_neighbors[c][k]]);
    }
}

TEST(Hexahedral_complex, of_eight_hexahedra)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  EXPECT_EQ(complex.number_of_vertices(), 27u);
  EXPECT_EQ(complex.edges.size(), 54u);
  EXPECT_EQ(complex.interior_faces.size(), 12u);
  EXPECT_EQ(complex.boundary_faces.size(), 24u);
  EXPECT_EQ(complex.boundary_edges.size(), 48u);
  for (int v = 0; v < 27; ++v) {
    EXPECT_EQ(bool(complex.is_on_boundary[v]), v != 13) << v;
    const int on_edge = (v % 3 == 1) + (v / 3 % 3 == 1) + (v / 9 == 1); // how many coordinates are in the middle
    EXPECT_EQ(complex.vertex_hexahedra[v].size(), std::size_t(1) << on_edge) << v;
    const std::size_t faces[4] = {3, 4, 4, 0};
    EXPECT_EQ(complex.vertex_boundary_faces[v].size(), faces[on_edge]) << v;
  }
  for (std::size_t e = 0; e < 54; ++e)
    EXPECT_EQ(bool(complex.is_boundary_edge[e]), complex.edges[e][0] != 13 && complex.edges[e][1] != 13) << e;
  EXPECT_EQ(as_set(complex.vertex_hexahedra[13]), (std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(as_set(complex.vertex_hexahedra[14]), (std::set<int>{1, 3, 5, 7}));
}

TEST(Hexahedral_complex, knows_unused_vertices)
{
  Block block(1, 1, 1);
  for (Hexahedron& h : block.hexahedra)
    for (int& v : h)
      v += 2;
  const Hexahedral_complex complex(11, block.hexahedra);
  EXPECT_EQ(complex.is_used, (std::vector<char>{0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 0}));
  EXPECT_EQ(complex.is_on_boundary, complex.is_used);
}

// Vertices − edges + faces − cells, and the same of the boundary
template <class Make>
void expect_euler(const char* name, int of_solid, int of_boundary, Make make)
{
  SCOPED_TRACE(name);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::size_t, 8>> given;
  make(points, given);
  Hexahedra hexahedra(given.size());
  for (std::size_t h = 0; h < given.size(); ++h)
    std::copy(given[h].begin(), given[h].end(), hexahedra[h].begin());
  const Hexahedral_complex complex(points.size(), hexahedra);
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  EXPECT_EQ(2 * n(complex.interior_faces.size()) + n(complex.boundary_faces.size()), 6 * n(hexahedra.size()));
  EXPECT_EQ(n(points.size()) - n(complex.edges.size()) + n(complex.interior_faces.size()) +
              n(complex.boundary_faces.size()) - n(hexahedra.size()),
            of_solid);
  const int boundary_vertices = n(std::count(complex.is_on_boundary.begin(), complex.is_on_boundary.end(), char(true)));
  EXPECT_EQ(boundary_vertices - n(complex.boundary_edges.size()) + n(complex.boundary_faces.size()), of_boundary);
  EXPECT_EQ(n(std::count(complex.is_boundary_edge.begin(), complex.is_boundary_edge.end(), char(true))),
            n(complex.boundary_edges.size()));
}

TEST(Hexahedral_complex, has_the_euler_characteristic_of_the_solid)
{
  expect_euler("block", 1, 2, [](auto& p, auto& h) { HMO::make_block(p, h, {{4, 3, 2}}); });
  expect_euler("bar", 1, 2, [](auto& p, auto& h) { HMO::make_bent_bar(p, h, 5, 2); });
  expect_euler("cylinder", 1, 2, [](auto& p, auto& h) { HMO::make_cylinder(p, h, 3, 2); });
  expect_euler("ball", 1, 2, [](auto& p, auto& h) { HMO::make_ball(p, h, 3); });
  expect_euler("plate with hole", 0, 0, [](auto& p, auto& h) { HMO::make_plate_with_hole(p, h, 2, 2); });
  expect_euler("L", 1, 2, [](auto& p, auto& h) { HMO::make_l_shape(p, h, 2); });
  expect_euler("T", 1, 2, [](auto& p, auto& h) { HMO::make_t_shape(p, h, 2); });
  expect_euler("ring", 0, 0, [](auto& p, auto& h) { HMO::make_ring(p, h, 7, 2); });
}

template <class Function>
void expect_refused(HMO::Input_error::Element element, std::size_t index, const std::string& words, Function function)
{
  try {
    function();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const HMO::Input_error& error) {
    EXPECT_EQ(error.element(), element);
    EXPECT_EQ(error.element_index(), index) << error.message();
    EXPECT_NE(error.message().find(words), std::string::npos) << error.message();
    EXPECT_NE(error.message().find(std::to_string(index)), std::string::npos) << error.message();
  }
}

using Element = HMO::Input_error::Element;

TEST(Hexahedral_complex, refuses_a_third_hexahedron_on_a_face)
{
  Block block(2, 1, 1);
  const Hexahedron h = block.hexahedra[1];
  block.hexahedra.push_back({h[0], 12, 13, h[3], h[4], 14, 15, h[7]});
  expect_refused(Element::HEXAHEDRON, 2, "hexahedra 0 and 1", [&] { Hexahedral_complex(16, block.hexahedra); });
}

TEST(Hexahedral_complex, refuses_a_hexahedron_given_twice)
{
  Block block(1, 1, 1);
  block.hexahedra.push_back(block.hexahedra[0]);
  EXPECT_THROW(Hexahedral_complex(8, block.hexahedra), HMO::Input_error);
}

TEST(Hexahedral_complex, refuses_neighbors_of_opposite_orientation)
{
  Block block(2, 1, 1);
  const Hexahedron h = block.hexahedra[1];
  block.hexahedra[1] = {h[4], h[5], h[6], h[7], h[0], h[1], h[2], h[3]};
  expect_refused(Element::HEXAHEDRON, 1, "hexahedra 0 and 1", [&] { block.complex(); });
}

// The four vertices of a face, joined in another order
TEST(Hexahedral_complex, refuses_neighbors_with_a_twisted_face)
{
  Block block(2, 1, 1);
  std::swap(block.hexahedra[1][0], block.hexahedra[1][3]);
  expect_refused(Element::HEXAHEDRON, 1, "hexahedra 0 and 1", [&] { block.complex(); });
}

// --- Where the boundary is not a manifold --------------------------------------------------

// Of the only edge or vertex that both have
TEST(Hexahedral_complex, of_two_hexahedra_that_share_only_an_edge)
{
  const Block block(2, 2, 1);
  const Hexahedral_complex complex(block.points.size(), {block.hexahedra[0], block.hexahedra[3]});
  const int a = block.vertex(1, 1, 0), b = block.vertex(1, 1, 1);
  EXPECT_EQ(complex.boundary_faces.size(), 12u);
  EXPECT_EQ(complex.boundary_edges.size(), 23u);
  for (const auto& e : complex.boundary_edges)
    EXPECT_EQ(e.right < 0, complex.edges[e.edge] == (std::array<int, 2>{a, b})) << e.edge;
  for (int v = 0; v < int(block.points.size()); ++v)
    EXPECT_EQ(bool(complex.is_singular[v]), v == a || v == b) << v;
}

TEST(Hexahedral_complex, of_two_hexahedra_that_share_only_a_vertex)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex(block.points.size(), {block.hexahedra[0], block.hexahedra[7]});
  EXPECT_EQ(complex.boundary_edges.size(), 24u);
  for (const auto& e : complex.boundary_edges)
    EXPECT_GE(e.right, 0);
  for (int v = 0; v < int(block.points.size()); ++v)
    EXPECT_EQ(bool(complex.is_singular[v]), v == block.vertex(1, 1, 1)) << v;
}

// A void, a pit, a notch, and a missing corner are no contacts.
TEST(Hexahedral_complex, has_no_singular_vertex_around_a_missing_hexahedron)
{
  const Block block(3, 3, 3);
  for (const auto& [i, j, k] : {std::array{1, 1, 1}, std::array{0, 1, 1}, std::array{0, 0, 1}, std::array{0, 0, 0}}) {
    std::vector<Hexahedron> all = block.hexahedra;
    all.erase(all.begin() + i + 3 * (j + 3 * k));
    const Hexahedral_complex complex(block.points.size(), all);
    EXPECT_EQ(complex.is_singular, std::vector<char>(block.points.size(), false)) << i << j << k;
  }
}

// --- Regions -------------------------------------------------------------------------------

std::vector<int> labels_by(const Block& block, int (*label)(int i, int j, int k))
{
  std::vector<int> labels;
  for (int k = 0; k < block.nz; ++k)
    for (int j = 0; j < block.ny; ++j)
      for (int i = 0; i < block.nx; ++i)
        labels.push_back(label(i, j, k));
  return labels;
}

// Out of the hexahedron that it belongs to
void expect_seen_from_outside(const Block& block, const Hexahedral_complex& complex)
{
  const auto center = [&](const auto& vertices) {
    Vector_3 sum = Vector_3::Zero();
    for (int v : vertices)
      sum += block.points[v];
    return Vector_3(sum / double(vertices.size()));
  };
  for (const auto& f : complex.boundary_faces) {
    const Vector_3 normal = (block.points[f.vertices[2]] - block.points[f.vertices[0]])
                              .cross(block.points[f.vertices[3]] - block.points[f.vertices[1]]);
    const Vector_3 to_face = center(f.vertices) - center(complex.hexahedra[f.hexahedron]);
    EXPECT_GT(normal.dot(to_face), 0);
    if (f.beyond >= 0) {
      EXPECT_LT(normal.dot(center(f.vertices) - center(complex.hexahedra[f.beyond])), 0);
    }
  }
}

TEST(Hexahedral_complex, lists_interfaces_after_the_outer_faces_and_as_seen_from_the_lower_label)
{
  const Block block(2, 2, 2);
  const auto labels = labels_by(block, [](int i, int, int k) { return i == 0 ? 7 : k == 0 ? -3 : 7; });
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {labels, {}});
  ASSERT_EQ(complex.boundary_faces.size(), 24u + 4u);
  EXPECT_EQ(complex.interior_faces.size(), 12u);
  for (std::size_t f = 0; f < complex.boundary_faces.size(); ++f) {
    const auto& face = complex.boundary_faces[f];
    EXPECT_EQ(face.beyond >= 0, f >= 24);
    if (face.beyond >= 0) {
      EXPECT_EQ(complex.label(face.hexahedron), -3);
      EXPECT_EQ(complex.label(face.beyond), 7);
    }
  }
  expect_seen_from_outside(block, complex);
  EXPECT_TRUE(complex.is_on_boundary[block.vertex(1, 1, 1)]);
}

// The interface meets the outer faces in a rim of edges with three faces
TEST(Hexahedral_complex, has_no_right_face_at_edges_of_three_and_more)
{
  const Block block(2, 2, 2);
  const auto halves = labels_by(block, [](int i, int, int) { return i; });
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {halves, {}});
  for (const auto& e : complex.boundary_edges) {
    const auto x = [&](int end) { return block.points[complex.edges[e.edge][end]][0]; };
    const auto is_inside = [&](int end) { return complex.edges[e.edge][end] == block.vertex(1, 1, 1); };
    EXPECT_EQ(e.right < 0, x(0) == 1 && x(1) == 1 && !is_inside(0) && !is_inside(1)) << e.edge;
  }
  for (int v = 0; v < 27; ++v)
    EXPECT_EQ(bool(complex.is_singular[v]), block.points[v][0] == 1 && v != block.vertex(1, 1, 1)) << v;
  // four quarters: the edges inside have four faces
  const auto quarters = labels_by(block, [](int i, int j, int) { return i + 2 * j; });
  const Hexahedral_complex four(block.points.size(), block.hexahedra, {quarters, {}});
  int inside = 0;
  for (const auto& e : four.boundary_edges)
    if (four.edges[e.edge][0] == block.vertex(1, 1, 1) || four.edges[e.edge][1] == block.vertex(1, 1, 1)) {
      const auto& ends = four.edges[e.edge];
      const bool is_axis = (block.points[ends[0]] - block.points[ends[1]])[2] != 0;
      EXPECT_EQ(e.right < 0, is_axis);
      inside += is_axis;
    }
  EXPECT_EQ(inside, 2);
}

TEST(Hexahedral_complex, of_one_label_is_that_of_none)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex plain = block.complex(), labelled(27, block.hexahedra, {std::vector<int>(8, 5), {}});
  EXPECT_EQ(labelled.boundary_faces.size(), plain.boundary_faces.size());
  EXPECT_EQ(labelled.is_on_boundary, plain.is_on_boundary);
  EXPECT_EQ(labelled.label(3), 5);
  EXPECT_EQ(plain.label(3), 0);
}

// Whichever way round their hexahedra have them, and in whatever order they are listed
TEST(Hexahedral_complex, orients_listed_faces_within_a_region_consistently)
{
  const Block block(4, 4, 4);
  std::vector<std::array<int, 4>> listed;
  for (int j = 0; j < 3; ++j)
    for (int k = 1; k < 4; ++k)
      listed.push_back({block.vertex(2, j, k), block.vertex(2, j + 1, k), block.vertex(2, j, k + 1),
                        block.vertex(2, j + 1, k + 1)}); // in no order around the face
  // every second hexahedron is listed first
  std::vector<Hexahedron> hexahedra;
  for (std::size_t parity : {0, 1})
    for (std::size_t h = 0; h < block.hexahedra.size(); ++h)
      if ((h + h / 4 + h / 16) % 2 == parity)
        hexahedra.push_back(block.hexahedra[h]);
  const Hexahedral_complex complex(block.points.size(), hexahedra, {{}, listed});
  ASSERT_EQ(complex.boundary_faces.size(), 96u + 9u);
  expect_seen_from_outside(block, complex);
  std::set<double> sides;
  for (std::size_t f = 96; f < complex.boundary_faces.size(); ++f) {
    const auto& q = complex.boundary_faces[f].vertices;
    sides.insert((block.points[q[1]] - block.points[q[0]]).cross(block.points[q[2]] - block.points[q[0]])[0]);
  }
  EXPECT_EQ(sides.size(), 1u) << "all are seen from the same side";
  for (const auto& e : complex.boundary_edges)
    if (complex.boundary_faces[e.left].beyond >= 0) { // two within the sheet, else its rim
      const auto& ends = complex.edges[e.edge];
      const auto is_rim = [&](int d, double low, double high) {
        return block.points[ends[0]][d] == block.points[ends[1]][d] &&
               (block.points[ends[0]][d] == low || block.points[ends[0]][d] == high);
      };
      EXPECT_EQ(e.right < 0, is_rim(1, 0, 3) || is_rim(2, 1, 4)) << e.edge;
    }
}

TEST(Hexahedral_complex, takes_listed_faces_that_are_on_the_boundary_anyway_once)
{
  const Block block(2, 1, 1);
  const std::array<int, 4> outer = {block.vertex(0, 0, 0), block.vertex(0, 1, 0), block.vertex(0, 1, 1),
                                    block.vertex(0, 0, 1)};
  const std::array<int, 4> middle = {block.vertex(1, 0, 0), block.vertex(1, 1, 0), block.vertex(1, 1, 1),
                                     block.vertex(1, 0, 1)};
  EXPECT_EQ(Hexahedral_complex(12, block.hexahedra, {{}, {outer}}).boundary_faces.size(), 10u);
  EXPECT_EQ(Hexahedral_complex(12, block.hexahedra, {{1, 2}, {middle, middle}}).boundary_faces.size(), 11u);
}

TEST(Hexahedral_complex, accepts_components_apart)
{
  const Block block(3, 1, 1);
  const Hexahedral_complex complex(block.points.size(), {block.hexahedra[0], block.hexahedra[2]});
  EXPECT_EQ(complex.boundary_faces.size(), 12u);
  EXPECT_EQ(complex.interior_faces.size(), 0u);
}

} // namespace
