// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Layers behind the boundary and beside interfaces.

#include "labelled_meshes.h"
#include "mesh_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/hexahedra_to_linear_cell_complex.h>
#include <CGAL/Hex_mesh_optimization/pad_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/validity.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using LCC = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>;

struct Mesh
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
};

Mesh block(std::size_t nx, std::size_t ny, std::size_t nz)
{
  Mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{nx, ny, nz}}, {{double(nx), double(ny), double(nz)}});
  return mesh;
}

TEST(pad_hex_mesh, adds_a_hexahedron_for_each_face_of_the_boundary)
{
  Mesh mesh = block(3, 3, 3);
  const Mesh before = mesh;
  const std::vector<std::size_t> source = CGAL::pad_hex_mesh(mesh.points, mesh.hexahedra);
  EXPECT_EQ(source.size(), 54u);
  EXPECT_EQ(mesh.hexahedra.size(), 27u + 54u);
  EXPECT_TRUE(invalid_hexahedra(mesh).empty());
  for (std::size_t v = 0; v < before.points.size(); ++v)
    EXPECT_EQ(mesh.points[v], before.points[v]);
  for (std::size_t h : source)
    EXPECT_LT(h, 27u);
}

TEST(pad_hex_mesh, makes_layers_on_both_sides_of_an_interface)
{
  Mesh mesh = block(4, 1, 1);
  const std::vector<int> labels = {1, 1, 2, 2};
  const auto label = CGAL::make_property_map(labels);
  const std::vector<std::size_t> source = CGAL::pad_hex_mesh(mesh.points, mesh.hexahedra,
                                                             CGAL::parameters::hexahedron_label_map(label));
  EXPECT_EQ(source.size(), 18u + 2u);
  EXPECT_TRUE(invalid_hexahedra(mesh).empty());
  const Mesh without = [] {
    Mesh m = block(4, 1, 1);
    CGAL::pad_hex_mesh(m.points, m.hexahedra);
    return m;
  }();
  EXPECT_EQ(mesh.hexahedra.size(), without.hexahedra.size() + 2);
}

// The faces of the boundary, each by its vertices
std::multiset<std::set<int>> boundary(const Indexed_mesh& mesh)
{
  std::multiset<std::set<int>> result;
  const auto faces = mesh.complex().boundary_faces;
  for (const auto& f : faces)
    result.insert(std::set<int>(f.vertices.begin(), f.vertices.end()));
  return result;
}

void expect_padded(const Labelled_mesh& input, bool is_valid)
{
  Labelled_mesh mesh = input;
  const std::vector<std::size_t> source = CGAL::pad_hex_mesh(mesh.points, mesh.hexahedra);
  EXPECT_EQ(source.size(), boundary(input).size());
  EXPECT_EQ(mesh.hexahedra.size(), input.hexahedra.size() + source.size());
  EXPECT_EQ(invalid_hexahedra(mesh).empty(), is_valid);
  EXPECT_EQ(boundary(mesh), boundary(input)) << "what was in contact still is, and nothing else";
  for (std::size_t v = 0; v < input.points.size(); ++v)
    EXPECT_EQ(mesh.points[v], input.points[v]);
}

// Parts that have an edge in common, or a vertex, have layers of their own there.
TEST(pad_hex_mesh, goes_around_contacts_at_an_edge)
{
  Labelled_mesh mesh;
  make_voxels(mesh, 2, 2, 1, 2, [](int i, int j, int) { return i == j; });
  ASSERT_EQ(boundary(mesh).size(), 48u);
  expect_padded(mesh, true);
}

TEST(pad_hex_mesh, goes_around_contacts_at_a_vertex)
{
  Labelled_mesh mesh;
  make_voxels(mesh, 2, 2, 2, 2, [](int i, int j, int k) { return i == j && j == k; });
  ASSERT_EQ(boundary(mesh).size(), 48u);
  expect_padded(mesh, true);
}

// Two of the eight voxels around a vertex are missing, one opposite the other: nothing is behind the faces of both.
TEST(pad_hex_mesh, is_not_valid_where_the_boundary_touches_itself_across_hexahedra_that_hang_together)
{
  Labelled_mesh mesh;
  make_voxels(mesh, 2, 2, 2, 2, [](int i, int j, int k) { return i != j || j != k; });
  expect_padded(mesh, false);
}

// Regions that touch each other in an edge have layers beside it too.
TEST(pad_hex_mesh, makes_layers_of_regions_around_an_edge)
{
  Labelled_mesh mesh;
  make_voxels(mesh, 2, 2, 1, 2, [](int, int, int) { return true; });
  mesh.label([](const Indexed_mesh::Point& p) { return (p.x() < 1) == (p.y() < 1) ? 1 : 2; });
  const std::size_t of_boundary = boundary(mesh).size(), between = 4 * 4;
  const std::size_t before = mesh.hexahedra.size();
  const std::vector<std::size_t> source = CGAL::pad_hex_mesh(mesh.points, mesh.hexahedra,
                                                             CGAL::parameters::hexahedron_label_map(
                                                               CGAL::make_property_map(mesh.labels)));
  EXPECT_EQ(source.size(), of_boundary + 2 * between);
  EXPECT_EQ(mesh.hexahedra.size(), before + source.size());
  EXPECT_TRUE(invalid_hexahedra(mesh).empty());
  for (std::size_t s : source)
    mesh.labels.push_back(mesh.labels[s]);
  std::size_t faces_between = 0;
  const auto faces = mesh.regions().boundary_faces;
  for (const auto& f : faces)
    faces_between += f.beyond >= 0;
  EXPECT_EQ(faces_between, between);
}

TEST(pad_hex_mesh, of_a_linear_cell_complex)
{
  const Mesh mesh = block(2, 2, 2);
  LCC lcc;
  HMO::hexahedra_to_linear_cell_complex(mesh.points, mesh.hexahedra, lcc);
  CGAL::pad_hex_mesh(lcc, CGAL::parameters::layer_thickness(.2));
  EXPECT_EQ(lcc.one_dart_per_cell<3>().size(), 8u + 24u);
  EXPECT_TRUE(lcc.is_valid());
}

TEST(pad_hex_mesh, refuses_what_is_no_mesh_and_leaves_it)
{
  Mesh mesh = block(2, 1, 1);
  const auto refused = [](Mesh m, std::size_t hexahedron) {
    const Mesh before = m;
    try {
      CGAL::pad_hex_mesh(m.points, m.hexahedra);
    }
    catch (const HMO::Input_error& error) {
      return error.element_index() == hexahedron && m.hexahedra == before.hexahedra && m.points == before.points;
    }
    return false;
  };
  Mesh other = mesh;
  other.hexahedra[1][3] = other.hexahedra[1][2];
  EXPECT_TRUE(refused(other, 1));
  other = mesh;
  other.hexahedra[1][3] = 99;
  EXPECT_TRUE(refused(other, 1));
  other = mesh;
  other.hexahedra.push_back(other.hexahedra[0]);
  other.hexahedra.push_back(other.hexahedra[0]);
  EXPECT_TRUE(refused(other, 3) || refused(other, 2));
  EXPECT_THROW(CGAL::pad_hex_mesh(mesh.points, mesh.hexahedra, CGAL::parameters::layer_thickness(1.5)),
               HMO::Input_error);
}

} // namespace
