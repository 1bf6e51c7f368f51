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

TEST(Hexahedral_complex, refuses_two_hexahedra_that_share_only_an_edge)
{
  const Block block(2, 2, 1);
  const Hexahedra diagonal = {block.hexahedra[0], block.hexahedra[3]};
  const int a = block.vertex(1, 1, 0), b = block.vertex(1, 1, 1);
  expect_refused(Element::HEXAHEDRON, 0, "vertex " + std::to_string(a) + " to vertex " + std::to_string(b),
                 [&] { Hexahedral_complex(block.points.size(), diagonal); });
}

TEST(Hexahedral_complex, refuses_two_hexahedra_that_share_only_a_vertex)
{
  const Block block(2, 2, 2);
  const Hexahedra diagonal = {block.hexahedra[0], block.hexahedra[7]};
  expect_refused(Element::VERTEX, block.vertex(1, 1, 1), "not a manifold",
                 [&] { Hexahedral_complex(block.points.size(), diagonal); });
}

TEST(Hexahedral_complex, accepts_components_apart)
{
  const Block block(3, 1, 1);
  const Hexahedral_complex complex(block.points.size(), {block.hexahedra[0], block.hexahedra[2]});
  EXPECT_EQ(complex.boundary_faces.size(), 12u);
  EXPECT_EQ(complex.interior_faces.size(), 0u);
}

} // namespace
