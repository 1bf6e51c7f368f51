// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Legacy VTK files: all of their data come back, and what cannot be read is refused with the line it is in.

#include "Io_test.h"

#include <string>
#include <utility>
#include <vector>

namespace {

class Vtk : public Io_test
{};

TEST_F(Vtk, in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    read_hex_mesh(write("a.vtk", text), points, hexahedra);
    return points.size() == 8 && hexahedra.size() == 1 && points[6] == Simple::Point_3(1, 1, 1) &&
           hexahedra[0] == Cell{0, 1, 2, 3, 4, 5, 6, 7};
  };
  EXPECT_TRUE(read(vtk_header + vtk_points + vtk_cells + "CELL_TYPES 1\n12\n"));
  EXPECT_TRUE(read(vtk_header + vtk_points + "CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n")) << "voxel";
  EXPECT_TRUE(read(vtk_header + "CELL_TYPES 3\n9 12 3\nCELLS 3 17\n4 0 1 2 3 8 0 1 2 3 4 5 6 7 2 0 1\n" + vtk_points +
                   "CELL_DATA 3\nSCALARS a double\nLOOKUP_TABLE default\nnan 2 3\n"));
  EXPECT_TRUE(read(vtk_header + "FIELD FieldData 2\nTIME 1 1 double\n0.5\nNAME 1 1 string\nCELLS and more\n" +
                   vtk_points + "METADATA\nINFORMATION 0\n\n" + vtk_cells + "CELL_TYPES 1\n12"));
  EXPECT_TRUE(read("# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" +
                   cube_points +
                   "METADATA\nINFORMATION 0\n\nCELLS 2 8\nOFFSETS vtktypeint64\n0 8\nCONNECTIVITY vtktypeint64\n"
                   "0 1 2 3 4\n5 6 7\nCELL_TYPES 1\n12\n"));
  std::string windows;
  for (const char c : vtk_header + vtk_points + vtk_cells + "CELL_TYPES 1\n12\n")
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(read(windows));
}

// Binary numbers of this format are big-endian.
template <class Number>
std::string big_endian(std::initializer_list<Number> numbers)
{
  std::string text;
  for (const Number n : numbers)
    CGAL::Hex_mesh_optimization::internal::IO::append_binary(text, n, false);
  return text;
}

TEST_F(Vtk, binary)
{
  const std::string header = "# vtk DataFile Version 5.1\ntitle\nBINARY\nDATASET UNSTRUCTURED_GRID\n";
  const std::string field = "FIELD FieldData 2\nNAME 1 2 string\n" +
                            std::string("\xc3"
                                        "abc"
                                        "\x80\x02"
                                        "de") +
                            "\nT 1 1 float\n" + big_endian<float>({1}) + "\n";
  const std::string points_text = "POINTS 8 float\n" + big_endian<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                                                          0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}) +
                                  "\n";
  const std::string cells = "CELLS 2 8\nOFFSETS vtktypeint64\n" + big_endian<std::int64_t>({0, 8}) +
                            "\nCONNECTIVITY vtktypeint32\n" + big_endian<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}) + "\n";
  const std::string types = "CELL_TYPES 1\n" + big_endian<std::int32_t>({12}) + "\n";
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  read_hex_mesh(write("a.vtk", header + field + points_text + cells + types), points, hexahedra);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points[6], Simple::Point_3(1, 1, 1));
  EXPECT_EQ(hexahedra, (std::vector<Cell>{{0, 1, 2, 3, 4, 5, 6, 7}}));

  refused("a.vtk", header + points_text.substr(0, 60), 0, "the file ends within the data");
  refused("a.vtk", header + points_text + cells + "CELL_TYPES 1\n" + big_endian<std::int32_t>({10}), 0,
          "cell 0: it is a tetrahedron");
  std::string bad = points_text;
  bad.replace(15, 4, big_endian<float>({std::numeric_limits<float>::quiet_NaN()}));
  refused("a.vtk", header + bad + cells + types, 0, "not a finite number");
}

TEST_F(Vtk, errors)
{
  const std::string types = "CELL_TYPES 1\n12\n"; // lines 16 and 17
  const std::string start = vtk_header + vtk_points;
  refused("a.vtk", "", 1, "this is no legacy VTK file");
  refused("a.vtk", std::string("\0\1\2garbage", 10), 1, "this is no legacy VTK file");
  refused("a.vtk", "# vtk DataFile Version 7.0\n", 1, "version 7.0");
  refused("a.vtk", "# vtk DataFile Version 3.0\ntitle\nXML\n", 3, "ASCII or BINARY");
  refused("a.vtk", "# vtk DataFile Version 3.0\ntitle\nASCII\nPOINTS 8 float\n", 4, "DATASET is expected");
  refused("a.vtk", "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n", 4, "the dataset is polydata");
  refused("a.vtk", vtk_header, 5, "there are no POINTS");
  refused("a.vtk", start, 14, "there are no CELLS");
  refused("a.vtk", start + vtk_cells, 16, "there are no CELL_TYPES");
  refused("a.vtk", start + vtk_points, 14, "a second time");
  refused("a.vtk", start + vtk_cells + "CELL_TYPES 2\n12 12\n", 18, "there are 1 cells and 2 cell types");
  refused("a.vtk", start + "CELLS 1 9\n8 0 1 2 3\n4 5 6 8\n" + types, 16, "point 8 does not exist");
  refused("a.vtk", start + "CELLS 1 9\n8 0 1 2 3 4 5 6 -1\n" + types, 15, "point -1 does not exist");
  refused("a.vtk", start + "CELLS 1 9\n8 0 1 2 3 4 5 six 7\n" + types, 15, "not \"six\"");
  refused("a.vtk", start + "CELLS 1 8\n7 0 1 2 3 4 5 6\n" + types, 15, "cell 0: it has 7 vertices, not 8");
  refused("a.vtk", start + "CELLS 1 9\n9 0 1 2 3 4 5 6 7\n" + types, 15, "cannot have 9 vertices");
  refused("a.vtk", start + "CELLS 1 999999999999\n8 0 1 2 3 4 5 6 7\n" + types, 14, "more than the rest");
  refused("a.vtk", start + "CELLS 2 14\n8 0 1 2 3 4 5 6 7\n4 0 1 2 3\nCELL_TYPES 2\n12\n10\n", 16,
          "cell 1: it is a tetrahedron");
  for (const char* type : {"25", "29", "33", "72", "79"})
    refused("a.vtk", start + "CELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 2\n12\n" + type + "\n", 16,
            std::string("cell 1: it is a hexahedron of higher order (type ") + type + ", 8 nodes)");
  refused("a.vtk", vtk_header + "POINTS 99999999999 double\n0 0 0\n", 5, "more than the rest");
  refused("a.vtk", vtk_header + "POINTS 2 double\n0 0 0\n1 nan 0\n", 7, "not a finite number");
  refused("a.vtk", vtk_header + "POINTS 2 double\n0 0 0\n1 1        ", 7, "the data end here");
  refused("a.vtk", vtk_header + "POINTS 1 complex\n0 0 0\n", 5, "\"complex\"");
  refused("a.vtk", start + "POLYGONS 1 2\n", 14, "unknown keyword");
  refused("a.vtk",
          "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n" + vtk_points +
            "CELLS 2 8\nOFFSETS vtktypeint64\n0 9\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 5 6 7\n" + types,
          14, "the offsets do not ascend");
}

// Each kind of attribute, as the file has it
TEST_F(Vtk, attributes_come_back)
{
  const std::string text =
    "# vtk DataFile Version 3.0\nthe title of the user\nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" +
    vtk_points +
    "CELLS 2 14\n4 0 1 2 3\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 2\n9\n12\n"
    "POINT_DATA 8\nSCALARS temperature double\nLOOKUP_TABLE hot\n1\n2\n3\n4\n5\n6\n7\n8\n"
    "LOOKUP_TABLE hot 2\n1 0 0 1\n0.5 0.25 0 1\n"
    "VECTORS v float\n0 0 1\n0 1 0\n1 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n0.5 1e-09 3\n"
    "GLOBAL_IDS id vtkIdType\n10\n11\n12\n13\n14\n15\n16\n5000000000\n"
    "FIELD FieldData 2\nname%20of%20words 2 8 unsigned_char\n1 2\n3 4\n5 6\n7 8\n9 10\n11 12\n13 14\n15 255\n"
    "METADATA\nCOMPONENT_NAMES\nfirst\nsecond\n\n"
    "long_ones 1 8 long\n1\n2\n3\n4\n5\n6\n7\n-9000000000000000000\n"
    "CELL_DATA 2\nSCALARS material int\nLOOKUP_TABLE default\n7\n-1\n"
    "TENSORS t double\n1 2 3 4 5 6 7 8 9\n9 8 7 6 5 4 3 2 1\n"
    "SCALARS pair short 2\nLOOKUP_TABLE default\n1 2\n3 4\n"
    "NORMALS n float\n0 0 1\n1 0 0\nTEXTURE_COORDINATES tc 2 float\n0 1\n1 0\n"
    "COLOR_SCALARS c 3\n0 0.5 1\n1 1 0\n";
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  read_hex_mesh(write("a.vtk", text), points, hexahedra, mesh_data);
  EXPECT_TRUE(mesh_data.skipped.empty()) << mesh_data.skipped[0];
  EXPECT_EQ(mesh_data.hexahedron_labels, std::vector<std::int64_t>{-1});
  EXPECT_EQ(mesh_data.other_cells.at(0).label, 7);
  write_hex_mesh(path("b.vtk"), points, hexahedra, mesh_data);
  EXPECT_EQ(content(path("b.vtk")), text);

  // in binary and back, in XML and back
  Mesh_data again;
  write_hex_mesh(path("c.vtk"), points, hexahedra, mesh_data, true);
  read_hex_mesh(path("c.vtk"), points, hexahedra, again);
  EXPECT_TRUE(again.skipped.empty()) << again.skipped[0];
  ASSERT_EQ(again.point_data.size(), mesh_data.point_data.size());
  EXPECT_EQ(again.point_data[4].metadata, "COMPONENT_NAMES\nfirst\nsecond\n");
  EXPECT_EQ(again.cell_data.back().values, Array::Values(std::vector<std::uint8_t>{0, 128, 255, 255, 255, 0}));
  write_hex_mesh(path("d.vtu"), points, hexahedra, mesh_data);
  read_hex_mesh(path("d.vtu"), points, hexahedra, again);
  for (std::size_t i = 0; i < mesh_data.cell_data.size(); ++i) {
    EXPECT_EQ(again.cell_data.at(i).name, mesh_data.cell_data[i].name);
    EXPECT_EQ(again.cell_data[i].values, mesh_data.cell_data[i].values);
  }
}

TEST_F(Vtk, layouts_that_others_write)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  Mesh_data mesh_data;
  const std::string mesh = vtk_header + vtk_points + vtk_cells + "CELL_TYPES 1\n12\n";
  read_hex_mesh(write("a.vtk", mesh + "CELL_DATA 1\nSCALARS region int 1\n3\n"), points, hexahedra, mesh_data);
  EXPECT_EQ(mesh_data.hexahedron_labels, std::vector<std::int64_t>{3}) << "without a lookup table";
  read_hex_mesh(write("a.vtk", mesh + "CELL_DATA 1\nSCALARS REGION int 1\nlookup_table default\n3.0"), points,
                hexahedra, mesh_data);
  EXPECT_EQ(mesh_data.hexahedron_labels, std::vector<std::int64_t>{3}) << "written as 3.0";
  read_hex_mesh(write("a.vtk", mesh + "CELL_DATA 1\nPOINT_DATA 8\n"), points, hexahedra, mesh_data);
  EXPECT_TRUE(mesh_data.skipped.empty() && mesh_data.cell_data.empty() && mesh_data.point_data.empty());
}

// The mesh is there all the same, and what is not is named.
TEST_F(Vtk, damaged_data_are_named)
{
  const std::string mesh = vtk_header + vtk_points + vtk_cells + "CELL_TYPES 1\n12\n"; // 17 lines
  const std::string good = "CELL_DATA 1\nSCALARS a int\nLOOKUP_TABLE default\n1\n";    // to line 21
  for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
         {"SCALARS b int\nLOOKUP_TABLE default\nx\n", ":24: a number of the array is expected, not \"x\""},
         {"SCALARS b int\nLOOKUP_TABLE default\n", ":24: a number is expected, but the data end here"},
         {"SCALARS b int 9\nLOOKUP_TABLE default\n1 2 3\n", "9 numbers are more than the rest of the file can hold"},
         {"SCALARS b int 99999999\nLOOKUP_TABLE default\n1\n", "larger than the rest of the file"},
         {"SCALARS b complex\nLOOKUP_TABLE default\n1\n", "\"complex\""},
         {"SCALARS b unsigned_char\nLOOKUP_TABLE default\n256\n", "not \"256\""},
         {"SPLINES b int\n1\n", ":22: unknown keyword \"splines\""},
         {"FIELD f 1\nb 1 99999999999999999 int\n1\n", "larger than the rest of the file"},
         {"FIELD f 1\nb 1 -2 int\n1\n", "negative"},
         {"FIELD f 1\nb 1 2 int\n1 2\n", "the array \"b\" of the cells: it has 2 values, not 1"},
         {"POINT_DATA 7\nSCALARS b int\nLOOKUP_TABLE default\n1 2 3 4 5 6 7\n", "it has 7 values, not 8"}}) {
    SCOPED_TRACE(text);
    std::vector<Simple::Point_3> points;
    std::vector<Cell> hexahedra;
    Mesh_data mesh_data;
    read_hex_mesh(write("a.vtk", mesh + good + text), points, hexahedra, mesh_data);
    EXPECT_EQ(hexahedra.size(), 1u);
    ASSERT_EQ(mesh_data.skipped.size(), 1u);
    EXPECT_NE(mesh_data.skipped[0].find(words), std::string::npos) << mesh_data.skipped[0];
    ASSERT_EQ(mesh_data.cell_data.size(), 1u);
    EXPECT_EQ(mesh_data.cell_data[0].name, "a");
  }
}

// A grid of 4 x 3 x 2 points in each of the ways to say so
TEST_F(Vtk, structured_grids_are_hexahedral_meshes)
{
  std::string points_text;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i)
        points_text += std::to_string(1 + i * .5) + " " + std::to_string(2 + j * 2) + " " + std::to_string(-k * -3) +
                       "\n";
  const std::string header = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET ";
  const std::string data = "CELL_DATA 6\nSCALARS material int 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\n";
  for (const std::string& grid :
       {"STRUCTURED_GRID\nDIMENSIONS 4 3 2\nPOINTS 24 float\n" + points_text,
        std::string("STRUCTURED_POINTS\nDIMENSIONS 4 3 2\nORIGIN 1 2 0\nSPACING .5 2 3\n"),
        std::string("STRUCTURED_POINTS\nDIMENSIONS 4 3 2\nASPECT_RATIO .5 2 3\nORIGIN 1 2 0\n"),
        std::string(
          "RECTILINEAR_GRID\nDIMENSIONS 4 3 2\nX_COORDINATES 4 float\n1 1.5 2 2.5\nY_COORDINATES 3 int\n2 4 6\n"
          "Z_COORDINATES 2 double\n0 3\n")}) {
    SCOPED_TRACE(grid);
    std::vector<Simple::Point_3> points, again;
    std::vector<Cell> hexahedra, hexahedra_again;
    Mesh_data mesh_data;
    read_hex_mesh(write("a.vtk", header + grid + data), points, hexahedra, mesh_data);
    ASSERT_EQ(points.size(), 24u);
    ASSERT_EQ(hexahedra.size(), 6u);
    EXPECT_EQ(hexahedra[4], (Cell{{5, 6, 10, 9, 17, 18, 22, 21}}));
    EXPECT_EQ(points[17], Simple::Point_3(1.5, 4, 3));
    EXPECT_EQ(mesh_data.hexahedron_labels, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6}));
    ASSERT_EQ(mesh_data.skipped.size(), 1u);
    EXPECT_NE(mesh_data.skipped[0].find("4 x 3 x 2"), std::string::npos);
    write_hex_mesh(path("b.vtk"), points, hexahedra, mesh_data);
    read_hex_mesh(path("b.vtk"), again, hexahedra_again, mesh_data);
    EXPECT_EQ(again, points);
    EXPECT_EQ(hexahedra_again, hexahedra);
    EXPECT_EQ(mesh_data.hexahedron_labels.size(), 6u);
  }
}

TEST_F(Vtk, structured_grids_that_cannot_be)
{
  const std::string header = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET "; // lines 1 to 4
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 4 3 1\n", 6, "4 x 3 x 1 points has no hexahedra");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 0 3 2\n", 6, "no hexahedra");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS -4 3 2\n", 5, "negative");
  refused("a.vtk", header + "STRUCTURED_POINTS\nORIGIN 0 0 0\n", 6, "no DIMENSIONS");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 99999 99999 99999\n", 6, "more than a file of this size");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 4000000000 4000000000 4000000000\n", 6, "more than");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nSPACING 1 1e308 9e999\n", 6, "not a finite number");
  refused("a.vtk", header + "STRUCTURED_POINTS\nDIMENSIONS 4 4 4\nSPACING 1 1 1e308\n", 7, "not a finite number");
  refused("a.vtk", header + "STRUCTURED_GRID\nDIMENSIONS 2 2 2\n", 6, "no POINTS");
  refused("a.vtk", header + "STRUCTURED_GRID\nDIMENSIONS 2 2 3\n" + vtk_points, 15, "more than the POINTS");
  refused("a.vtk", header + "STRUCTURED_GRID\nDIMENSIONS 2 2 2\nPOINTS 9 float\n9 9 9\n" + cube_points, 16,
          "there are 9 points, not 2 x 2 x 2");
  refused("a.vtk",
          header + "RECTILINEAR_GRID\nDIMENSIONS 2 2 2\nX_COORDINATES 2 float\n0 1\nZ_COORDINATES 2 float\n0 1\n", 10,
          "there are 0 Y_COORDINATES, not 2");
  refused("a.vtk", header + "STRUCTURED_GRID\nDIMENSIONS 2 2 2\n" + vtk_cells, 6, "unknown keyword \"cells\"");
}

} // namespace
