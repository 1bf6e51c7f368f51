// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sheets of the boundary of a mesh with regions: each face is in one, each edge and vertex once in every sheet that
// it belongs to.

#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../block_of_cubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr int nothing = Surface_faces::no_label;
using Labels = std::vector<std::array<int, 2>>;

// Every incidence of a face, by brute force
void expect_complete(const Hexahedral_complex& complex, const Surface_faces& faces)
{
  ASSERT_EQ(faces.quads.size(), complex.boundary_faces.size());
  std::set<std::pair<int, int>> edges, vertices; // with their sheets
  std::vector<std::size_t> size(faces.labels.size(), 0);
  for (std::size_t f = 0; f < faces.quads.size(); ++f) {
    EXPECT_EQ(faces.quads[f], complex.boundary_faces[f].vertices);
    const int sheet = faces.sheet(int(f));
    ++size[sheet];
    EXPECT_EQ(faces.is_interface(int(f)), complex.boundary_faces[f].beyond >= 0);
    for (int k = 0; k < 4; ++k) {
      edges.emplace(complex.find_edge(faces.quads[f][k], faces.quads[f][(k + 1) % 4]) / 2, sheet);
      vertices.emplace(faces.quads[f][k], sheet);
    }
  }
  for (std::size_t s = 0; s < size.size(); ++s) {
    EXPECT_EQ(faces.size_of_sheet(int(s)), size[s]);
    EXPECT_GT(size[s], 0u);
  }
  EXPECT_EQ(faces.edges.size(), edges.size());
  for (const Surface_faces::Edge& e : faces.edges) {
    EXPECT_EQ(edges.count({e.edge, faces.sheet(e.face)}), 1u);
    const auto& q = faces.quads[e.face];
    for (int end : complex.edges[e.edge])
      EXPECT_EQ(std::count(q.begin(), q.end(), end), 1);
  }
  EXPECT_EQ(faces.vertices.size(), vertices.size());
  for (std::size_t i = 0; i < faces.vertices.size(); ++i) {
    const Surface_faces::Vertex& v = faces.vertices[i];
    EXPECT_EQ(vertices.count({v.vertex, faces.sheet(v.face)}), 1u);
    EXPECT_EQ(std::count(faces.quads[v.face].begin(), faces.quads[v.face].end(), v.vertex), 1);
    EXPECT_TRUE(i == 0 || faces.vertices[i - 1].vertex <= v.vertex);
  }
}

TEST(Surface_faces, of_one_region_are_one_sheet)
{
  const Block block(2, 3, 2);
  const Hexahedral_complex complex = block.complex();
  const Surface_faces faces = boundary_surface_faces(complex);
  EXPECT_EQ(faces.labels, (Labels{{0, nothing}}));
  EXPECT_TRUE(faces.sheets.empty());
  EXPECT_EQ(faces.edges.size(), complex.boundary_edges.size());
  expect_complete(complex, faces);
}

TEST(Surface_faces, of_regions_are_a_sheet_for_each_pair_of_labels)
{
  const Block block(3, 2, 2);
  std::vector<int> labels;
  for (std::size_t h = 0; h < block.hexahedra.size(); ++h)
    labels.push_back(h % 3 == 1 ? 9 : h < 6 ? 4 : -1); // along x: 4 or -1, 9, 4 or -1
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {labels, {}});
  const Surface_faces faces = boundary_surface_faces(complex);
  EXPECT_EQ(faces.labels, (Labels{{-1, 4}, {-1, 9}, {-1, nothing}, {4, 9}, {4, nothing}, {9, nothing}}));
  expect_complete(complex, faces);
}

TEST(Surface_faces, outside_are_one_sheet_where_they_have_a_reference)
{
  const Block block(3, 2, 2);
  std::vector<int> labels(block.hexahedra.size(), 1);
  labels[0] = 0;
  const Hexahedral_complex complex(block.points.size(), block.hexahedra, {labels, {}});
  const Surface_faces faces = boundary_surface_faces(complex, true);
  ASSERT_EQ(faces.labels.size(), 2u);
  EXPECT_EQ(faces.labels[0][1], nothing);
  EXPECT_EQ(faces.labels[1], (std::array<int, 2>{0, 1}));
  for (std::size_t f = 0; f < faces.quads.size(); ++f)
    EXPECT_EQ(faces.sheet(int(f)), complex.boundary_faces[f].beyond < 0 ? 0 : 1);
  expect_complete(complex, faces);
}

// All cubes of a block whose three indices have an even sum: edges and vertices of many contacts
TEST(Surface_faces, of_contacts_have_each_edge_and_vertex_once)
{
  const Block block(3, 3, 3);
  std::vector<Hexahedron> hexahedra;
  std::vector<int> labels;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        if ((i + j + k) % 2 == 0) {
          hexahedra.push_back(block.hexahedra[i + 3 * (j + 3 * k)]);
          labels.push_back(k);
        }
  for (const Regions& regions : {Regions(), Regions{labels, {}}}) {
    const Hexahedral_complex complex(block.points.size(), hexahedra, regions);
    const Surface_faces faces = boundary_surface_faces(complex);
    EXPECT_EQ(faces.labels.size(), regions.labels.empty() ? 1u : 3u);
    expect_complete(complex, faces);
  }
}

TEST(Surface_faces, within_a_region_are_a_sheet_of_their_own)
{
  const Block block(2, 2, 1);
  const Hexahedral_complex complex(
    block.points.size(), block.hexahedra,
    {{3, 3, 3, 3}, {{block.vertex(1, 0, 0), block.vertex(1, 1, 0), block.vertex(1, 1, 1), block.vertex(1, 0, 1)}}});
  const Surface_faces faces = boundary_surface_faces(complex);
  EXPECT_EQ(faces.labels, (Labels{{3, 3}, {3, nothing}}));
  EXPECT_EQ(faces.size_of_sheet(0), 1u);
  expect_complete(complex, faces);
}

} // namespace
