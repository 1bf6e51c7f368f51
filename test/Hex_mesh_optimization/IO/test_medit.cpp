// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Medit files: all sections come back, and what cannot be read is refused with the line it is in.

#include "Io_test.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace {

class Medit : public Io_test
{};

TEST_F(Medit, sections_are_carried_through)
{
  const std::string other = "Corners\n2\n1\n8\n# a comment\nRequiredVertices\n1\n2\nRidges\n1\n1\n"
                            "RequiredQuadrilaterals 1 1\n"
                            "Normals\n2\n0 0 1\nnan inf -1e-3\nNormalAtVertices 1\n1 1\nMyOwnSection 0\n";
  const std::string first = medit_header + "Triangles 1\n1 2 3 7\nCorners\n2\n1\n8\n# a comment\n" +
                            "Hexahedra\n1\n1 2 3 4 5 6 7 8 -4\nQuadrilaterals 2\n1 2 3 4 -5 5 6 7 8 0\n" +
                            "Edges\n1\n1 2 3\n" + other.substr(other.find("Required")) + medit_vertices() +
                            "End\nand whatever";
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data, again;
  read_hex_mesh(write("a.mesh", first), points, hexahedra, mesh_data);
  EXPECT_EQ(mesh_data.other_sections, other);
  EXPECT_EQ(mesh_data.hexahedron_labels, std::vector<std::int64_t>{-4});
  ASSERT_EQ(mesh_data.other_cells.size(), 4u);
  const auto quads = mesh_data.labelled_quadrilaterals();
  ASSERT_EQ(quads.size(), 2u);
  EXPECT_EQ(quads[0].vertices, (std::array<std::size_t, 4>{{0, 1, 2, 3}}));
  EXPECT_EQ(quads[0].label, -5);
  mesh_data.vertex_labels[3] = 1234567890123;

  write_hex_mesh(path("b.mesh"), points, hexahedra, mesh_data);
  EXPECT_NE(content(path("b.mesh"))
              .find("Quadrilaterals\n2\n1 2 3 4 -5\n5 6 7 8 0\nTriangles\n1\n1 2 3 7\nEdges\n1\n"
                    "1 2 3\n" +
                    other),
            std::string::npos);
  read_hex_mesh(path("b.mesh"), points, hexahedra, again);
  EXPECT_EQ(again.other_sections, mesh_data.other_sections);
  EXPECT_EQ(again.vertex_labels, mesh_data.vertex_labels);
  EXPECT_EQ(again.hexahedron_labels, mesh_data.hexahedron_labels);
  EXPECT_EQ(again.other_cells.size(), 4u);

  mesh_data.vertex_labels.pop_back();
  EXPECT_THROW(write_hex_mesh(path("c.mesh"), points, hexahedra, mesh_data), CGAL::IO::Hex_mesh_file_error);
  EXPECT_FALSE(std::filesystem::exists(path("c.mesh")));
  mesh_data.vertex_labels.clear();
  mesh_data.other_cells[0].vertices[1] = 8;
  for (const char* name : {"c.mesh", "c.vtk", "c.vtu"})
    EXPECT_THROW(write_hex_mesh(path(name), points, hexahedra, mesh_data), CGAL::IO::Hex_mesh_file_error);
}

TEST_F(Medit, in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    read_hex_mesh(write("a.mesh", text), points, hexahedra);
    return points.size() == 8 && hexahedra.size() == 1 && points[6] == Simple::Point_3(1, 1, 1) && hexahedra[0][7] == 7;
  };
  const std::string text = medit_header + medit_vertices() + medit_hexahedra + "End\n";
  EXPECT_TRUE(read(text));
  EXPECT_TRUE(read(medit_header + medit_vertices() + medit_hexahedra)) << "without End";
  EXPECT_TRUE(read(medit_header + medit_vertices() + "Hexahedra 1 1 2 3 4 5 6 7 8 0")) << "without a line end";
  EXPECT_TRUE(read("MeshVersionFormatted 1\n\nDimension\n3\n" + medit_hexahedra + medit_vertices()));
  EXPECT_TRUE(
    read("# by hand\nMeshVersionFormatted 1 # one\nDimension 3#three\n" + medit_hexahedra + medit_vertices()));
  std::string windows;
  for (const char c : text)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(read(windows));
}

TEST_F(Medit, errors)
{
  const std::string vertices = medit_vertices(); // lines 3 to 12
  const std::string start = medit_header + vertices;
  refused("a.mesh", "", 1, "this is no Medit mesh");
  refused("a.mesh", std::string("\0\1\2\377garbage\n\n\0", 14), 1, "this is no Medit mesh");
  refused("a.mesh", "\n\nVertices\n", 3, "this is no Medit mesh");
  refused("a.mesh", "MeshVersionFormatted 9\nDimension 3\n" + vertices + medit_hexahedra, 1, "version 9");
  refused("a.mesh", "MeshVersionFormatted 2\nDimension 2\n" + vertices + medit_hexahedra, 2, "the dimension is 2");
  refused("a.mesh", medit_header + medit_hexahedra + "End\n", 6, "there is no Vertices section");
  refused("a.mesh", start + "End\n", 13, "there is no Hexahedra section");
  refused("a.mesh", start + vertices + medit_hexahedra, 13, "a second Vertices section");
  refused("a.mesh", start + medit_hexahedra + medit_hexahedra, 16, "a second Hexahedra section");
  refused("a.mesh", start + "Hexahedra\n1\n1 2 3 4 5\n6 7 9 8 0\n", 16, "vertex 9 does not exist");
  refused("a.mesh", start + "Hexahedra\n1\n0 2 3 4 5 6 7 8 0\n", 15, "vertex 0 does not exist");
  refused("a.mesh", medit_header + "Hexahedra\n1\n1 2 3 4 5 6 7 -8 0\n" + vertices, 5, "vertex -8 does not exist");
  refused("a.mesh", start + "Hexahedra\n1\n1 2 3 4 5 6 7 x 0\n", 15, "not \"x\"");
  refused("a.mesh", start + "Hexahedra\n1\n1 2 3 4 5 6 7 8.5 0\n", 15, "not \"8.5\"");
  refused("a.mesh", start + "Hexahedra\n2\n1 2 3 4 5 6 7 8 0\n1 2 3 4 5 6", 14, "more than the rest");
  refused("a.mesh", start + "Hexahedra\n2\n1 2 3 4 5 6 7 8      0\n1 2 3 4 5 6 7", 16, "the data end here");
  refused("a.mesh", start + "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n1 2\n", 16, "longer than it should be");
  refused("a.mesh", start + "Hexahedra\n99999999999999\n1 2 3 4 5 6 7 8 0\n", 14, "more than the rest");
  refused("a.mesh", start + "Hexahedra\n99999999999999999999999\n1 2 3 4 5 6 7 8 0\n", 14, "the number of hexahedra");
  refused("a.mesh", start + "Hexahedra\n-1\n", 14, "negative");
  refused("a.mesh", medit_header + "Vertices\n4000000000\n0 0 0 0\n", 4, "more than the rest");
  refused("a.mesh", start + medit_hexahedra + "Quadrilaterals\n1\n1 2 3 9 0\n", 18, "vertex 9 does not exist");
  refused("a.mesh", start + medit_hexahedra + "Triangles\n4000000000\n1 2 3 0\n", 17, "more than the rest");
  refused("a.mesh", start + medit_hexahedra + "Edges\n1\n1 2 3 4\n", 18, "longer than it should be");
  refused("a.mesh", start + "Tetrahedra\n1\n1 2 3 4 0\n" + medit_hexahedra, 13, "the mesh has Tetrahedra");
  for (const std::string bad : {"nan", "-inf", "1e999", "NaN", "Infinity"}) {
    std::string text = vertices;
    text.replace(text.find("1 1 1"), 1, bad);
    refused("a.mesh", medit_header + text + medit_hexahedra, 11, "not a finite number");
  }
  refused("a.xyz", start + medit_hexahedra, 0, "the format is unknown");
  refused("mesh", start + medit_hexahedra, 0, "the format is unknown");
}

} // namespace
