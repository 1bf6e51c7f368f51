// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Connectivity, edge relations and edge cones of meshes small enough to count by
// hand, and the meshes that have no usable connectivity.

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Simple_cartesian.h>

#include "hexahedron_rotations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;
using Hexahedra = std::vector<Hexahedron>;

// Unit cubes on a lattice, vertex (i, j, k) at number i + (nx+1) (j + (ny+1) k).
struct Block
{
  int nx, ny, nz;
  Positions points;
  Hexahedra hexahedra;

  Block(int nx, int ny, int nz) : nx(nx), ny(ny), nz(nz)
  {
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
          points.emplace_back(i, j, k);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          hexahedra.push_back({vertex(i, j, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k), vertex(i, j + 1, k),
                               vertex(i, j, k + 1), vertex(i + 1, j, k + 1), vertex(i + 1, j + 1, k + 1), vertex(i, j + 1, k + 1)});
  }

  int vertex(int i, int j, int k) const { return i + (nx + 1) * (j + (ny + 1) * k); }

  Hexahedral_complex complex() const { return Hexahedral_complex(points.size(), hexahedra); }
};

std::set<int> as_set(const Grouped_array::Group& group) { return std::set<int>(group.begin(), group.end()); }

TEST(Grouped_array, keeps_the_order_within_groups)
{
  const int group[] = {2, 0, 2, 3, 0, 2}, value[] = {5, 6, 7, 8, 9, 4};
  const Grouped_array array(5, 6, [&](std::size_t i) { return group[i]; }, [&](std::size_t i) { return value[i]; });
  ASSERT_EQ(array.size(), 5u);
  const std::vector<std::vector<int>> expected = {{6, 9}, {}, {5, 7, 4}, {8}, {}};
  for (std::size_t g = 0; g < 5; ++g)
    EXPECT_EQ(std::vector<int>(array[g].begin(), array[g].end()), expected[g]) << g;
  EXPECT_EQ(Grouped_array().size(), 0u);
}

// 0 1 2 / 3 4 5 at the bottom, 6 7 8 / 9 10 11 at the top
TEST(Hexahedral_complex, of_two_hexahedra)
{
  const Block block(2, 1, 1);
  const Hexahedral_complex complex = block.complex();
  ASSERT_EQ(complex.number_of_vertices(), 12u);
  const std::vector<std::array<int, 2>> edges = {
    {0, 1}, {0, 3}, {0, 6}, {1, 2}, {1, 4}, {1, 7}, {2, 5}, {2, 8}, {3, 4}, {3, 9},
    {4, 5}, {4, 10}, {5, 11}, {6, 7}, {6, 9}, {7, 8}, {7, 10}, {8, 11}, {9, 10}, {10, 11}};
  EXPECT_EQ(complex.edges, edges);

  ASSERT_EQ(complex.interior_faces.size(), 1u);
  EXPECT_EQ(complex.interior_faces[0][0], std::make_pair(0, 3)); // the face 1 4 10 7
  EXPECT_EQ(complex.interior_faces[0][1], std::make_pair(1, 5));

  ASSERT_EQ(complex.boundary_faces.size(), 10u);
  const std::array<int, 4> faces[10] = {{0, 3, 4, 1}, {6, 7, 10, 9}, {0, 1, 7, 6}, {4, 3, 9, 10}, {3, 0, 6, 9},
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
    EXPECT_EQ(as_set(complex.vertex_hexahedra[v]), i == 0 ? std::set<int>{0} : i == 2 ? std::set<int>{1} : (std::set<int>{0, 1})) << v;
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
  EXPECT_EQ(n(points.size()) - n(complex.edges.size()) + n(complex.interior_faces.size()) + n(complex.boundary_faces.size()) -
              n(hexahedra.size()), of_solid);
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

std::set<std::pair<int, int>> vertex_pairs(const Hexahedral_complex& complex, const std::vector<Edge_pair>& pairs)
{
  // a pair as the sources of its edges, where the targets follow by the direction
  std::set<std::pair<int, int>> result;
  for (const Edge_pair& p : pairs) {
    EXPECT_EQ(p.first % 2, 0);
    const std::pair<int, int> sources = std::minmax(complex.source(p.first), complex.source(p.second));
    EXPECT_TRUE(result.insert(sources).second) << "twice: " << sources.first << " " << sources.second;
  }
  return result;
}

TEST(Edge_relations, of_two_hexahedra)
{
  const Hexahedral_complex complex = Block(2, 1, 1).complex();
  const Edge_relations relations(complex);

  // Across the two cubes one edge continues another four times
  EXPECT_EQ(vertex_pairs(complex, relations.consecutive), (std::set<std::pair<int, int>>{{0, 1}, {3, 4}, {6, 7}, {9, 10}}));
  for (const Edge_pair& p : relations.consecutive)
    EXPECT_EQ(complex.target(p.first), complex.source(p.second));

  // Along x: 6 pairs in either cube. Along y and z the shared face has one pair
  // in common: 2 · 6 − 1 each.
  EXPECT_EQ(relations.parallel.size(), 12u + 11u + 11u);
  std::set<std::pair<int, int>> expected[3];
  for (int i = 0; i < 2; ++i) {
    const int x[4] = {i, i + 3, i + 6, i + 9}, y[4] = {i, i + 1, i + 6, i + 7}, z[4] = {i, i + 1, i + 3, i + 4};
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        expected[0].emplace(std::minmax(x[a], x[b]));
        expected[1].emplace(std::minmax(y[a], y[b]));
        expected[2].emplace(std::minmax(z[a], z[b]));
      }
  }
  const int step[3] = {1, 3, 6};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Edge_pair> along;
    for (const Edge_pair& p : relations.parallel) {
      EXPECT_EQ(complex.target(p.first) - complex.source(p.first), complex.target(p.second) - complex.source(p.second));
      if (complex.target(p.first) - complex.source(p.first) == step[axis])
        along.push_back(p);
    }
    EXPECT_EQ(vertex_pairs(complex, along), expected[axis]) << axis;
  }

  const int e01 = complex.find_edge(0, 1) / 2, e14 = complex.find_edge(1, 4) / 2, e03 = complex.find_edge(0, 3) / 2;
  EXPECT_EQ(relations.parallel_degree[e01], 3);
  EXPECT_EQ(relations.consecutive_degree[e01], 1);
  EXPECT_EQ(relations.parallel_degree[e14], 5); // three in either cube, the one above counted once
  EXPECT_EQ(relations.consecutive_degree[e14], 0);
  EXPECT_EQ(relations.parallel_degree[e03], 3);
}

TEST(Edge_relations, of_eight_hexahedra)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  const Edge_relations relations(complex);
  // per axis: 9 lines of two edges; 2 layers of 9 edges in 4 squares: 20 pairs, 12 sides and 8 diagonals
  EXPECT_EQ(relations.consecutive.size(), 27u);
  EXPECT_EQ(relations.parallel.size(), 3u * 2 * 20);
  const int inner = complex.find_edge(block.vertex(0, 1, 1), block.vertex(1, 1, 1)) / 2;
  EXPECT_EQ(relations.parallel_degree[inner], 8);
  EXPECT_EQ(relations.consecutive_degree[inner], 1);
  const int corner = complex.find_edge(block.vertex(0, 0, 0), block.vertex(1, 0, 0)) / 2;
  EXPECT_EQ(relations.parallel_degree[corner], 3);
  const int side = complex.find_edge(block.vertex(0, 1, 0), block.vertex(1, 1, 0)) / 2;
  EXPECT_EQ(relations.parallel_degree[side], 5);
}

// Renumbering the corners of a cube must not change what resembles what
TEST(Edge_relations, do_not_depend_on_the_corner_a_hexahedron_starts_at)
{
  Block block(2, 1, 1);
  const Hexahedral_complex straight = block.complex();
  const Edge_relations expected(straight);
  const auto pairs_of = [](const std::vector<Edge_pair>& pairs) {
    std::set<std::pair<int, int>> result;
    for (const Edge_pair& p : pairs)
      result.emplace(p.first, p.second);
    EXPECT_EQ(result.size(), pairs.size());
    return result;
  };
  const Hexahedron h = block.hexahedra[1];
  const auto rotations = numberings(1);
  ASSERT_EQ(rotations.size(), 24u);
  for (const std::array<int, 8>& rotation : rotations) {
    for (int c = 0; c < 8; ++c)
      block.hexahedra[1][c] = h[rotation[c]];
    const Hexahedral_complex turned = block.complex();
    EXPECT_EQ(turned.edges, straight.edges);
    const Edge_relations relations(turned);
    EXPECT_EQ(pairs_of(relations.consecutive), pairs_of(expected.consecutive));
    EXPECT_EQ(pairs_of(relations.parallel), pairs_of(expected.parallel));
  }
}

// A ring of one sheet: every edge along it is parallel to none of itself
TEST(Edge_relations, of_a_closed_ring)
{
  Hexahedra hexahedra;
  const int n = 3;
  for (int i = 0; i < n; ++i) {
    const int a = 4 * i, b = 4 * ((i + 1) % n);
    hexahedra.push_back({a, a + 1, b + 1, b, a + 2, a + 3, b + 3, b + 2});
  }
  const Hexahedral_complex complex(12, hexahedra);
  const Edge_relations relations(complex);
  EXPECT_EQ(relations.consecutive.size(), 12u); // four edges around, each continued at either end
  for (const Edge_pair& p : relations.consecutive) {
    EXPECT_NE(p.first / 2, p.second / 2);
    EXPECT_TRUE(complex.target(p.first) == complex.source(p.second) || complex.target(p.second) == complex.source(p.first));
  }
}

TEST(Edge_cones, of_a_block_of_cubes)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  cones.update_normals(block.points);
  ASSERT_EQ(cones.size(), 108u);
  std::map<std::size_t, int> number_of_valence;
  for (int directed = 0; directed < 108; ++directed) {
    const int from = complex.source(directed), to = complex.target(directed);
    const Vector_3 axis = block.points[to] - block.points[from];
    // as many cubes as sides of the edge are inside the block
    std::size_t valence = 1;
    for (int d = 0; d < 3; ++d)
      if (axis[d] == 0 && block.points[from][d] == 1)
        valence *= 2;
    ++number_of_valence[valence];
    const Grouped_array::Group triangles = cones.triangles(directed);
    EXPECT_EQ(triangles.size(), valence) << from << " " << to;

    std::set<int> hexahedra;
    for (int t : triangles) {
      const Hexahedron& h = complex.hexahedra[t / 24];
      const int corner = t % 24 / 3, k = t % 3;
      hexahedra.insert(t / 24);
      EXPECT_EQ(h[corner], from);
      EXPECT_EQ(h[corner_neighbors[corner][k]], to);
      // the base triangle in the plane of the other two edges faces the axis
      EXPECT_EQ(cones.normal(t), axis);
    }
    EXPECT_EQ(hexahedra.size(), valence) << "one triangle in each cube";
    EXPECT_EQ(cones.normal_sum(directed), double(valence) * axis);
    EXPECT_DOUBLE_EQ(cones.worst_cosine(directed, axis), 1);
    EXPECT_DOUBLE_EQ(cones.worst_cosine(directed, -axis), -1);
  }
  EXPECT_EQ(number_of_valence[4], 2 * 6);  // the edges at the center
  EXPECT_EQ(number_of_valence[2], 2 * 24); // within the sides of the block
  EXPECT_EQ(number_of_valence[1], 2 * 24); // along its edges
}

TEST(Edge_cones, have_normals_of_their_triangles_wherever_vertices_are)
{
  const Block block(2, 2, 2);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  Positions points = block.points;
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] += .4 * Vector_3(std::sin(3. * v), std::cos(5. * v), std::sin(7. * v + 1));
  cones.update_normals(points);
  // The cone towards +x at the center, counter-clockwise around x: y, z, -y, -z
  const int center = block.vertex(1, 1, 1);
  const int rim[4] = {block.vertex(1, 2, 1), block.vertex(1, 1, 2), block.vertex(1, 0, 1), block.vertex(1, 1, 0)};
  const int hexahedron[4] = {7, 5, 1, 3}; // with those two rim vertices, at +x
  const int directed = complex.find_edge(center, block.vertex(2, 1, 1));
  Vector_3 sum = Vector_3::Zero();
  double worst = 1;
  const Vector_3 direction = Vector_3(.3, .2, -.5).normalized();
  for (int k = 0; k < 4; ++k) {
    const Vector_3 expected =
      (points[rim[k]] - points[center]).cross(points[rim[(k + 1) % 4]] - points[center]).normalized();
    sum += expected;
    worst = (std::min)(worst, direction.dot(expected));
    int found = 0;
    for (int t : cones.triangles(directed))
      if (t / 24 == hexahedron[k]) {
        ++found;
        EXPECT_LT((cones.normal(t) - expected).norm(), 1e-14);
      }
    EXPECT_EQ(found, 1) << k;
  }
  EXPECT_LT((cones.normal_sum(directed) - sum).norm(), 1e-13);
  EXPECT_NEAR(cones.worst_cosine(directed, direction), worst, 1e-14);
}

TEST(Edge_cones, have_zero_normals_where_a_base_is_degenerate)
{
  const Block block(1, 1, 1);
  const Hexahedral_complex complex = block.complex();
  Edge_cones cones(complex);
  Positions points = block.points;
  points[2] = points[0]; // vertex (0,1,0) onto (0,0,0)
  cones.update_normals(points);
  const int up = complex.find_edge(0, 4);
  ASSERT_EQ(cones.triangles(up).size(), 1u);
  EXPECT_EQ(cones.normal_sum(up), Vector_3::Zero());
}

// --- Meshes that are refused ---------------------------------------------------

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

// --- Order in memory --------------------------------------------------------------------------------------

TEST(Memory_order, brings_neighbors_together_and_back)
{
  const Block block(6, 5, 4);
  std::mt19937 random(1);
  std::vector<int> shuffled(block.points.size());
  for (std::size_t v = 0; v < shuffled.size(); ++v)
    shuffled[v] = static_cast<int>(v);
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  Hexahedra hexahedra = block.hexahedra;
  for (Hexahedron& h : hexahedra)
    for (int& v : h)
      v = shuffled[v];
  std::shuffle(hexahedra.begin(), hexahedra.end(), random);
  const std::size_t n = block.points.size() + 3; // the last three are not used
  const Memory_order order(Hexahedral_complex(n, hexahedra));

  std::vector<int> given(n);
  for (std::size_t v = 0; v < n; ++v)
    given[v] = static_cast<int>(v);
  const std::vector<int> ordered = order.ordered(given);
  EXPECT_EQ(std::set<int>(ordered.begin(), ordered.end()).size(), n);
  EXPECT_EQ(order.as_given(ordered), given);
  for (std::size_t v = 0; v < n; ++v)
    EXPECT_EQ(order.given_vertex(v), ordered[v]);
  for (int k = 1; k <= 3; ++k)
    EXPECT_GE(ordered[n - k], static_cast<int>(block.points.size()));

  const Hexahedra cells = order.ordered(hexahedra);
  std::set<int> seen;
  int widest = 0;
  for (std::size_t h = 0; h < cells.size(); ++h) {
    seen.insert(order.given_hexahedron(h));
    for (int i = 0; i < 8; ++i)
      EXPECT_EQ(ordered[cells[h][i]], hexahedra[order.given_hexahedron(h)][i]);
    const auto [low, high] = std::minmax_element(cells[h].begin(), cells[h].end());
    widest = (std::max)(widest, *high - *low);
    if (h > 0) {
      EXPECT_LE(*std::min_element(cells[h - 1].begin(), cells[h - 1].end()), *low);
    }
  }
  EXPECT_EQ(seen.size(), cells.size());
  EXPECT_LT(widest, 3 * 6 * 5) << "three layers of vertices";
  EXPECT_TRUE(order.ordered(std::vector<char>()).empty());
}

// --- Elements that conflict -----------------------------------------------------------------------------

TEST(Conflict_free_ranges, visit_every_element_once_and_neighbors_in_turn)
{
  const Block block(20, 20, 20);
  for (std::size_t size_of_range : {1, 7, 64, 100000}) {
    const Conflict_free_ranges ranges(block.hexahedra.size(), block.points.size(), size_of_range,
                                      [&](std::size_t h) -> const Hexahedron& { return block.hexahedra[h]; });
    EXPECT_GE(ranges.number_of_colors(), size_of_range < 8000 ? 2u : 1u);
    for (bool backwards : {false, true}) {
      std::vector<int> visits(block.hexahedra.size(), 0), users(block.points.size(), 0);
      std::vector<std::size_t> last_color(block.points.size(), backwards ? 1000 : 0); // that came to each vertex
      std::mutex mutex;
      bool is_conflict = false, is_in_order = true;
      const auto work = [&](std::size_t begin, std::size_t end) {
        ASSERT_LE(end - begin, size_of_range);
        const auto use = [&](int change) {
          const std::lock_guard<std::mutex> lock(mutex);
          std::set<int> vertices;
          for (std::size_t h = begin; h < end; ++h)
            vertices.insert(block.hexahedra[h].begin(), block.hexahedra[h].end());
          for (int v : vertices) {
            is_conflict = (users[v] += change) > 1 || is_conflict;
            const std::size_t color = ranges.color(begin), last = std::exchange(last_color[v], color);
            is_in_order = is_in_order && (backwards ? color <= last : color >= last);
          }
        };
        use(1);
        for (std::size_t h = begin; h < end; ++h)
          ++visits[h];
        use(-1);
      };
      if (backwards)
        ranges.for_ranges_backwards(work);
      else
        ranges.for_ranges(work);
      EXPECT_FALSE(is_conflict);
      EXPECT_TRUE(is_in_order);
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<long>(visits.size()));
    }
  }
}

} // namespace
