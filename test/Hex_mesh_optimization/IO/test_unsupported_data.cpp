// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever a format cannot hold is named, and nothing that it can.

#include "Io_test.h"

#include <CGAL/Hex_mesh_optimization/IO/unsupported_data.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

class Unsupported_data : public Io_test
{};

bool names(const std::vector<std::string>& lost, const std::string& words)
{
  return std::any_of(lost.begin(), lost.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST_F(Unsupported_data, of_a_medit_file_are_sections)
{
  const std::string text = medit_header + medit_vertices() + "Hexahedra\n1\n1 2 3 4 5 6 7 8 -4\n" +
                           "Quadrilaterals 1\n1 2 3 4 5\nCorners 2\n1 8\n# Comment here\nNormals 1\nnan Inf 0\n"
                           "RequiredVertices\n1\n2\nEnd\n";
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  read_hex_mesh(write("a.mesh", text), points, hexahedra, mesh_data);
  EXPECT_TRUE(CGAL::IO::unsupported_data("b.mesh", mesh_data).empty());
  for (const char* name : {"b.vtk", "b.vtu"})
    EXPECT_EQ(CGAL::IO::unsupported_data(name, mesh_data),
              (std::vector<std::string>{"the section Corners", "the section Normals", "the section RequiredVertices"}));
}

TEST_F(Unsupported_data, of_a_vtk_file_are_arrays_and_cells)
{
  Mesh_data mesh_data;
  add_other_cells(mesh_data);
  mesh_data.point_data = arrays_of_all_types(14, 1);
  mesh_data.cell_data = arrays_of_all_types(6, 1);
  mesh_data.field_data = arrays_of_all_types(3, 1);
  mesh_data.cell_data[4].name = "material";
  mesh_data.find_label_array();
  EXPECT_TRUE(CGAL::IO::unsupported_data("b.vtk", mesh_data).empty());
  EXPECT_TRUE(CGAL::IO::unsupported_data("b.vtu", mesh_data).empty());
  const std::vector<std::string> lost = CGAL::IO::unsupported_data("b.mesh", mesh_data);
  EXPECT_TRUE(names(lost, "\"int8\" of the points"));
  EXPECT_TRUE(names(lost, "\"int8\" of the cells"));
  EXPECT_TRUE(names(lost, "\"int8\" of the mesh"));
  EXPECT_TRUE(names(lost, "1 cells of VTK type 1"));
  EXPECT_FALSE(names(lost, "material")) << "the labels of the hexahedra";
  EXPECT_EQ(lost.size(), 36u);

  mesh_data.point_data[0].metadata = "INFORMATION 0\n";
  mesh_data.point_data[1].attributes = {{"ComponentName0", "x"}};
  mesh_data.point_data[2].role = Role::LOOKUP_TABLE;
  EXPECT_TRUE(names(CGAL::IO::unsupported_data("b.vtu", mesh_data), "the metadata of the array \"int8\""));
  EXPECT_TRUE(names(CGAL::IO::unsupported_data("b.vtu", mesh_data), "the lookup table \"int16\""));
  EXPECT_TRUE(names(CGAL::IO::unsupported_data("b.vtk", mesh_data), "ComponentName0=\"x\""));
}

} // namespace
