// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files: what is written comes back bit by bit and in order, and what cannot be
// read is refused with the line it is in.

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/surface.h>

#include "mesh_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Simple = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hexahedron = std::array<std::size_t, 8>;

// A folder of its own for every test, removed at the end.
class Io : public ::testing::Test
{
protected:
  Io()
  {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("hex_mesh_io_" + std::string(info->name()) + "_" + std::to_string(std::random_device()()));
    std::filesystem::create_directory(folder_);
  }

  ~Io() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  static std::string content(const std::string& filename)
  {
    std::ostringstream out;
    out << std::ifstream(filename, std::ios::binary).rdbuf();
    return out.str();
  }

  // Reading must fail at this line for this reason, and change nothing.
  void refused(const std::string& name, const std::string& text, std::size_t line, const std::string& reason) const
  {
    const std::string filename = write(name, text);
    std::vector<Simple::Point_3> points(1, Simple::Point_3(7, 8, 9));
    std::vector<Hexahedron> hexahedra(2);
    try {
      CGAL::IO::read_hex_mesh(filename, points, hexahedra);
      ADD_FAILURE() << "nothing was thrown for " << reason;
    }
    catch (const CGAL::IO::Hex_mesh_file_error& error) {
      EXPECT_EQ(error.file(), filename);
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
      const std::string start = filename + ":" + (line == 0 ? "" : std::to_string(line) + ":") + " ";
      EXPECT_EQ(std::string(error.what()).substr(0, start.size()), start);
    }
    EXPECT_EQ(points.size(), 1u);
    EXPECT_EQ(hexahedra.size(), 2u);
  }

  std::filesystem::path folder_;
};

// Two cubes with unreferenced points between and coordinates that are hard to print.
template <class Point>
void make_mesh(std::vector<Point>& points, std::vector<Hexahedron>& hexahedra)
{
  std::mt19937_64 random(1);
  points.emplace_back(5., -0., 1. / 3.); // unreferenced
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        points.emplace_back(i + 1e-9 * double(random()) / 1e19, j * 0.1 + 1e-17, k / 7.);
  points.emplace_back(std::numeric_limits<double>::denorm_min(), (std::numeric_limits<double>::max)(), 1e-300);
  points.emplace_back(-1.7976931348623157e308, 123456789.123456789, 2.2250738585072014e-308);
  hexahedra = {{5, 6, 8, 7, 9, 10, 12, 11}, {1, 2, 4, 3, 5, 6, 8, 7}};
}

const std::string cube_points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";

std::string medit_vertices()
{
  std::string text = "Vertices\n8\n";
  std::istringstream in(cube_points);
  for (std::string line; std::getline(in, line);)
    text += line + " 0\n";
  return text;
}

const std::string medit_header = "MeshVersionFormatted 2\nDimension 3\n";                               // lines 1 and 2
const std::string medit_hexahedra = "Hexahedra\n1\n1 2 3 4 5 6 7 8 0\n";                                // 3 lines
const std::string vtk_header = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n"; // lines 1 to 4
const std::string vtk_points = "POINTS 8 double\n" + cube_points;                                       // lines 5 to 13
const std::string vtk_cells = "CELLS 1 9\n8 0 1 2 3 4 5 6 7\n"; // lines 14 and 15

TEST_F(Io, all_formats_give_back_every_bit)
{
  std::vector<Simple::Point_3> points, points_back;
  std::vector<Hexahedron> hexahedra, hexahedra_back;
  make_mesh(points, hexahedra);
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu", "a.MESH", "b.Vtk", "c.VTU"})
    for (const bool binary : {false, true}) {
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, CGAL::parameters::use_binary_mode(binary));
      CGAL::IO::read_hex_mesh(path(name), points_back, hexahedra_back);
      EXPECT_TRUE(same_points(points, points_back)) << name << binary;
      EXPECT_EQ(hexahedra, hexahedra_back) << name << binary;
    }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    files += entry.is_regular_file();
  EXPECT_EQ(files, 6u) << "temporary files are left";
}

TEST_F(Io, larger_meshes_and_other_containers)
{
  std::vector<Epick::Point_3> points, points_back;
  std::vector<std::vector<int>> hexahedra, hexahedra_back;
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i)
    points.emplace_back(double(random()), 1. / double(random()), -double(random() % 1000));
  for (int i = 0; i < 20001; ++i) {
    hexahedra.emplace_back();
    for (int c = 0; c < 8; ++c)
      hexahedra.back().push_back(int(random() % points.size()));
  }
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"})
    for (const bool binary : {false, true}) {
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, CGAL::parameters::use_binary_mode(binary));
      CGAL::IO::read_hex_mesh(path(name), points_back, hexahedra_back);
      EXPECT_TRUE(same_points(points, points_back)) << name << binary;
      EXPECT_EQ(hexahedra, hexahedra_back) << name << binary;
    }
}

TEST_F(Io, empty_meshes)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"})
    for (const bool binary : {false, true}) {
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, CGAL::parameters::use_binary_mode(binary));
      EXPECT_NO_THROW(CGAL::IO::read_hex_mesh(path(name), points, hexahedra)) << name << binary;
      EXPECT_TRUE(points.empty());
      EXPECT_TRUE(hexahedra.empty());
    }
}

template <class LCC>
void check_linear_cell_complex(const std::string& filename)
{
  using Point = typename LCC::Point;
  std::vector<Point> points, points_back;
  std::vector<Hexahedron> hexahedra, hexahedra_back;
  make_mesh(points, hexahedra);
  CGAL::IO::write_hex_mesh(filename, points, hexahedra);
  LCC lcc;
  lcc.make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1));
  CGAL::IO::read_hex_mesh(filename, lcc);
  CGAL::IO::write_hex_mesh(filename, lcc);
  CGAL::IO::read_hex_mesh(filename, points_back, hexahedra_back);
  EXPECT_TRUE(same_points(points, points_back));
  EXPECT_EQ(hexahedra, hexahedra_back);
}

TEST_F(Io, linear_cell_complexes)
{
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"}) {
    check_linear_cell_complex<CGAL::Linear_cell_complex_for_combinatorial_map<3, 3>>(path(name));
    check_linear_cell_complex<
      CGAL::Linear_cell_complex_for_generalized_map<3, 3, CGAL::Linear_cell_complex_traits<3, Simple>>>(path(name));
  }
}

TEST_F(Io, linear_cell_complex_keeps_attachments_and_stays_upon_an_error)
{
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3> lcc;
  CGAL::IO::Hex_mesh_attachments attachments;
  const std::string text = medit_header + medit_vertices() + medit_hexahedra + "Corners\n2\n1\n8\nEnd\n";
  CGAL::IO::read_hex_mesh(write("a.mesh", text), lcc, attachments);
  CGAL::IO::write_hex_mesh(path("b.mesh"), lcc, attachments);
  EXPECT_EQ(content(path("b.mesh")), text);

  const std::string bad = medit_header + medit_vertices() + "Hexahedra\n1\n1 2 3 4 5 6 7 7 0\nEnd\n";
  EXPECT_THROW(CGAL::IO::read_hex_mesh(write("c.mesh", bad), lcc), CGAL::IO::Hex_mesh_file_error);
  EXPECT_EQ(lcc.number_of_vertex_attributes(), 8u);
}

TEST_F(Io, medit_sections_are_carried_through)
{
  const std::string other = "Triangles 1\n1 2 3 7\n"
                            "# a comment\nQuadrilaterals\n1\n1 2 3 4 -5\n"
                            "Edges\n1\n1 2 3\nCorners\n2\n1\n8\nRequiredVertices\n1\n2\nRidges\n1\n1\n"
                            "Normals\n2\n0 0 1\nnan inf -1e-3\nNormalAtVertices 1\n1 1\nMyOwnSection 0\n";
  const std::string first = medit_header + "Triangles 1\n1 2 3 7\n# a comment\n" +
                            "Hexahedra\n1\n1 2 3 4 5 6 7 8 -4\n" + other.substr(other.find("Quadri")) +
                            medit_vertices() + "End\nand whatever";
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  CGAL::IO::Hex_mesh_attachments attachments, again;
  CGAL::IO::read_hex_mesh(write("a.mesh", first), points, hexahedra, attachments);
  EXPECT_EQ(attachments.other_sections, other);
  EXPECT_EQ(attachments.hexahedron_labels, std::vector<std::int64_t>{-4});
  attachments.vertex_labels[3] = 1234567890123;

  CGAL::IO::write_hex_mesh(path("b.mesh"), points, hexahedra, attachments);
  CGAL::IO::read_hex_mesh(path("b.mesh"), points, hexahedra, again);
  EXPECT_EQ(again.other_sections, attachments.other_sections);
  EXPECT_EQ(again.vertex_labels, attachments.vertex_labels);
  EXPECT_EQ(again.hexahedron_labels, attachments.hexahedron_labels);

  CGAL::IO::write_hex_mesh(path("b.vtk"), points, hexahedra, attachments);
  CGAL::IO::read_hex_mesh(path("b.vtk"), points, hexahedra, again);
  EXPECT_TRUE(again.other_sections.empty() && again.vertex_labels.empty() && again.hexahedron_labels.empty());

  attachments.vertex_labels.pop_back();
  EXPECT_THROW(CGAL::IO::write_hex_mesh(path("c.mesh"), points, hexahedra, attachments), CGAL::IO::Hex_mesh_file_error);
  EXPECT_FALSE(std::filesystem::exists(path("c.mesh")));
}

TEST_F(Io, medit_in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    CGAL::IO::read_hex_mesh(write("a.mesh", text), points, hexahedra);
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

TEST_F(Io, medit_errors)
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
  refused("a.mesh", start + "Tetrahedra\n1\n1 2 3 4 0\n" + medit_hexahedra, 13, "the mesh has Tetrahedra");
  for (const std::string bad : {"nan", "-inf", "1e999", "NaN", "Infinity"}) {
    std::string text = vertices;
    text.replace(text.find("1 1 1"), 1, bad);
    refused("a.mesh", medit_header + text + medit_hexahedra, 11, "not a finite number");
  }
  refused("a.msh", start + medit_hexahedra, 0, "the format is unknown");
  refused("mesh", start + medit_hexahedra, 0, "the format is unknown");
}

TEST_F(Io, missing_files_and_folders)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  make_mesh(points, hexahedra);
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"}) {
    EXPECT_THROW(CGAL::IO::read_hex_mesh(path(name), points, hexahedra), CGAL::IO::Hex_mesh_file_error);
    EXPECT_THROW(CGAL::IO::write_hex_mesh(path("missing/") + name, points, hexahedra), CGAL::IO::Hex_mesh_file_error);
    std::filesystem::create_directory(path(name));
    EXPECT_THROW(CGAL::IO::read_hex_mesh(path(name), points, hexahedra), CGAL::IO::Hex_mesh_file_error);
    EXPECT_THROW(CGAL::IO::write_hex_mesh(path(name), points, hexahedra), CGAL::IO::Hex_mesh_file_error);
  }
  EXPECT_THROW(CGAL::IO::write_hex_mesh(path("a.xyz"), points, hexahedra), CGAL::IO::Hex_mesh_file_error);
  EXPECT_EQ(hexahedra.size(), 2u);
}

TEST_F(Io, vtk_in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    CGAL::IO::read_hex_mesh(write("a.vtk", text), points, hexahedra);
    return points.size() == 8 && hexahedra.size() == 1 && points[6] == Simple::Point_3(1, 1, 1) &&
           hexahedra[0] == Hexahedron{0, 1, 2, 3, 4, 5, 6, 7};
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

TEST_F(Io, vtk_binary)
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
  std::vector<Hexahedron> hexahedra;
  CGAL::IO::read_hex_mesh(write("a.vtk", header + field + points_text + cells + types), points, hexahedra);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points[6], Simple::Point_3(1, 1, 1));
  EXPECT_EQ(hexahedra, (std::vector<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}}));

  refused("a.vtk", header + points_text.substr(0, 60), 0, "the file ends within the data");
  refused("a.vtk", header + points_text + cells + "CELL_TYPES 1\n" + big_endian<std::int32_t>({10}), 0,
          "cell 0: it is a tetrahedron");
  std::string bad = points_text;
  bad.replace(15, 4, big_endian<float>({std::numeric_limits<float>::quiet_NaN()}));
  refused("a.vtk", header + bad + cells + types, 0, "not a finite number");
}

TEST_F(Io, vtk_errors)
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

std::string vtu(const std::string& attributes, const std::string& points, const std::string& connectivity,
                const std::string& offsets, const std::string& types, const std::string& appended = "")
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" " + attributes +
         ">\n"
         "<!-- a comment --><UnstructuredGrid><FieldData><DataArray type=\"String\" Name=\"a\" "
         "format=\"ascii\">9</DataArray>"
         "</FieldData><Piece NumberOfPoints=\"8\" NumberOfCells=\"1\">\n"
         "<PointData><DataArray type=\"Float32\" Name=\"p\" format=\"ascii\">nan</DataArray></PointData>\n"
         "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" " +
         connectivity +
         "</DataArray>\n"
         "<DataArray type=\"Int32\" Name=\"offsets\" " +
         offsets +
         "</DataArray>\n"
         "<DataArray type=\"UInt8\" Name=\"types\" " +
         types +
         "</DataArray></Cells>\n"
         "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" " +
         points +
         "<InformationKey name=\"L2\" location=\"x\">\n</InformationKey></DataArray></Points>\n"
         "</Piece></UnstructuredGrid>" +
         appended + "</VTKFile>\n";
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers, bool little_endian)
{
  std::string text;
  for (const Number n : numbers)
    CGAL::Hex_mesh_optimization::internal::IO::append_binary(text, n, little_endian);
  return text;
}

std::string base64(const std::string& bytes)
{
  std::string text;
  CGAL::Hex_mesh_optimization::internal::IO::append_base64(text, bytes);
  return text;
}

TEST_F(Io, vtu_in_other_layouts)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  const auto read = [&](const std::string& text) {
    points.clear();
    hexahedra.clear();
    CGAL::IO::read_hex_mesh(write("a.vtu", text), points, hexahedra);
    return points.size() == 8 && hexahedra.size() == 1 && points[6] == Simple::Point_3(1, 1, 1) &&
           points[1] == Simple::Point_3(1, 0, 0) && hexahedra[0] == Hexahedron{0, 1, 2, 3, 4, 5, 6, 7};
  };
  const std::string ascii = "format=\"ascii\">";
  const std::string text = vtu("", ascii + cube_points, ascii + "0 1 2 3 4 5 6 7", ascii + "8", ascii + "12");
  EXPECT_TRUE(read(text));
  EXPECT_TRUE(read(vtu("", ascii + cube_points, ascii + "0 1 3 2 4 5 7 6", ascii + "8", ascii + "11"))) << "voxel";

  for (const bool little : {true, false})
    for (const bool wide : {true, false}) {
      const std::string attributes = std::string("byte_order=\"") + (little ? "LittleEndian" : "BigEndian") +
                                     "\" header_type=\"" + (wide ? "UInt64" : "UInt32") + "\"";
      const std::string blocks[4] = {
        bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}, little),
        bytes_of<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}, little), bytes_of<std::int32_t>({8}, little),
        bytes_of<std::uint8_t>({12}, little)};
      const auto size = [&](std::size_t s) {
        return wide ? bytes_of<std::uint64_t>({s}, little) : bytes_of<std::uint32_t>({std::uint32_t(s)}, little);
      };

      std::string inlined[4], split[4], raw[4], encoded[4], raw_data, encoded_data;
      for (int b = 0; b < 4; ++b) {
        const std::string header = size(blocks[b].size());
        inlined[b] = "format=\"binary\">\n  " + base64(header + blocks[b]) + "\n";
        split[b] = "format=\"binary\">\n" + base64(header) + base64(blocks[b]) + "\n";
        raw[b] = "format=\"appended\" offset=\"" + std::to_string(raw_data.size()) + "\">";
        raw_data += header + blocks[b];
        encoded[b] = "format=\"appended\" offset=\"" + std::to_string(encoded_data.size()) + "\">";
        encoded_data += base64(header + blocks[b]);
      }
      EXPECT_TRUE(read(vtu(attributes, inlined[0], inlined[1], inlined[2], inlined[3])));
      EXPECT_TRUE(read(vtu(attributes, split[0], split[1], split[2], split[3])));
      EXPECT_TRUE(read(vtu(attributes, raw[0], raw[1], raw[2], raw[3],
                           "<AppendedData encoding=\"raw\">\n  _" + raw_data + "\n</AppendedData>")));
      EXPECT_TRUE(read(vtu(attributes, encoded[0], encoded[1], encoded[2], encoded[3],
                           "<AppendedData encoding=\"base64\">\n_" + encoded_data + "\n</AppendedData>")));
      refused("a.vtu",
              vtu(attributes, raw[0], raw[1], raw[2], raw[3],
                  "<AppendedData encoding=\"raw\">\n  _" + raw_data.substr(0, 40) + "\n</AppendedData>"),
              0, "incomplete");
      refused("a.vtu", vtu(attributes, inlined[0].substr(0, 60), inlined[1], inlined[2], inlined[3]), 0, "incomplete");
      refused("a.vtu", vtu(attributes, inlined[1], inlined[1], inlined[2], inlined[3]), 0, "32 bytes, not 96");
    }

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
  const auto compressed = [&](const std::string& block, std::size_t block_size) {
    std::vector<std::uint32_t> header = {std::uint32_t((block.size() + block_size - 1) / block_size),
                                         std::uint32_t(block_size), std::uint32_t(block.size() % block_size)};
    std::string data, head;
    for (std::size_t begin = 0; begin < block.size(); begin += block_size) {
      const std::string part = block.substr(begin, block_size);
      std::string packed(compressBound(part.size()), ' ');
      uLongf length = packed.size();
      compress(reinterpret_cast<Bytef*>(&packed[0]), &length, reinterpret_cast<const Bytef*>(part.data()), part.size());
      data += packed.substr(0, length);
      header.push_back(std::uint32_t(length));
    }
    for (const std::uint32_t h : header)
      CGAL::Hex_mesh_optimization::internal::IO::append_binary(head, h, true);
    return "format=\"binary\">" + base64(head) + base64(data);
  };
  const std::string with_zlib = "compressor=\"vtkZLibDataCompressor\"";
  for (const std::size_t block_size : {1000, 96, 32, 7})
    EXPECT_TRUE(read(
      vtu(with_zlib,
          compressed(bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}, true),
                     block_size),
          compressed(bytes_of<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}, true), block_size),
          compressed(bytes_of<std::int32_t>({8}, true), block_size),
          compressed(bytes_of<std::uint8_t>({12}, true), block_size))));
#else
  refused("a.vtu", vtu("compressor=\"vtkZLibDataCompressor\"", ascii, ascii, ascii, ascii), 0, "without zlib");
#endif
}

TEST_F(Io, vtu_errors)
{
  const std::string ascii = "format=\"ascii\">";
  const std::string p = ascii + cube_points, c = ascii + "0 1 2 3 4 5 6 7", o = ascii + "8", t = ascii + "12";
  refused("a.vtu", "<a>\n<b>\n</a>\n", 4, "unexpected end of data");
  refused("a.vtu", "<a></a>", 0, "no VTKFile element");
  refused("a.vtu", "<VTKFile type=\"PolyData\"></VTKFile>", 0, "the file holds a PolyData");
  refused("a.vtu", "<VTKFile type=\"UnstructuredGrid\"></VTKFile>", 0, "no UnstructuredGrid");
  refused("a.vtu", vtu("byte_order=\"Middle\"", p, c, o, t), 0, "byte order");
  refused("a.vtu", vtu("compressor=\"vtkLZMADataCompressor\"", p, c, o, t), 0, "vtkLZMADataCompressor");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 8", o, t), 0, "cell 0: point 8 does not exist");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 -2", o, t), 0, "cell 0: point -2 does not exist");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6", o, t), 0, "incomplete");
  refused("a.vtu", vtu("", p, ascii + "0 1 2 3 4 5 6 7 8", o, t), 0, "longer than");
  refused("a.vtu", vtu("", p, c, ascii + "99999999999999", t), 0, "connectivity are incomplete");
  refused("a.vtu", vtu("", p, c, ascii + "-1", t), 0, "do not ascend");
  refused("a.vtu", vtu("", p, c, o, ascii + "14"), 0, "cell 0: it is a pyramid");
  refused("a.vtu", vtu("", p, c, o, "format=\"appended\" offset=\"77\">"), 0, "outside the file");
  refused("a.vtu", vtu("", p, c, o, "format=\"new\">"), 0, "\"new\"");
  refused("a.vtu", vtu("", ascii + "nan" + cube_points.substr(1), c, o, t), 0, "not a finite number");
  std::string many = vtu("", p, c, o, t);
  many.replace(many.find("NumberOfPoints=\"8\""), 18, "NumberOfPoints=\"88888888888888888\"");
  refused("a.vtu", many, 0, "incomplete");
}

// Any prefix and any damage ends in an error or a mesh, never in a crash.
TEST_F(Io, damaged_files_do_no_harm)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  make_mesh(points, hexahedra);
  std::mt19937 random(3);
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"})
    for (const bool binary : {false, true}) {
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, CGAL::parameters::use_binary_mode(binary));
      const std::string good = content(path(name));
      for (int i = 0; i < 300; ++i) {
        std::string bad = good;
        if (i % 2 == 0)
          bad.resize(random() % bad.size());
        else
          for (int j = 0; j < 3; ++j)
            bad[random() % bad.size()] = static_cast<char>(random());
        std::vector<Simple::Point_3> p;
        std::vector<Hexahedron> h;
        try {
          CGAL::IO::read_hex_mesh(write(name, bad), p, h);
          for (const Hexahedron& hexahedron : h)
            for (const std::size_t v : hexahedron)
              EXPECT_LT(v, p.size());
        }
        catch (const CGAL::IO::Hex_mesh_file_error&) {
        }
      }
    }
}

TEST_F(Io, output_appears_complete_or_not_at_all)
{
  std::vector<Simple::Point_3> points;
  std::vector<Hexahedron> hexahedra;
  make_mesh(points, hexahedra);
  write("old.mesh", "old");
  CGAL::IO::Hex_mesh_attachments wrong;
  wrong.hexahedron_labels = {1, 2, 3};
  EXPECT_THROW(CGAL::IO::write_hex_mesh(path("old.mesh"), points, hexahedra, wrong), CGAL::IO::Hex_mesh_file_error);
  EXPECT_EQ(content(path("old.mesh")), "old");
  {
    CGAL::Hex_mesh_optimization::internal::IO::Atomic_file file(path("old.mesh"));
    file.text() = "new, but not finished";
    file.text().resize(2 << 20, ' ');
    file.write_if_large();
  }
  EXPECT_EQ(content(path("old.mesh")), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()), 1);

  std::filesystem::create_symlink("old.mesh", path("link.mesh"));
  CGAL::IO::write_hex_mesh(path("link.mesh"), points, hexahedra);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.mesh")));
  EXPECT_NE(content(path("old.mesh")), "old");
}

// A cube as six quadrilaterals in every format.
TEST_F(Io, surfaces)
{
  const int quads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::string off = "OFF\n8 6 0\n" + cube_points, medit = medit_header + medit_vertices() + "Quadrilaterals\n6\n";
  std::string obj, vtk = vtk_points, poly, cells = "CELLS 7 39\n8 0 1 2 3 4 5 6 7\n", stl = "solid a\n";
  std::istringstream in(cube_points);
  std::vector<std::string> corners;
  for (std::string line; std::getline(in, line); corners.push_back(line))
    obj += "v " + line + "\n";
  for (const auto& q : quads) {
    off += "4", obj += "f", poly += "4", cells += "4";
    for (const int v : q) {
      off += " " + std::to_string(v);
      obj += " " + std::to_string(v + 1);
      medit += std::to_string(v + 1) + " ";
      poly += " " + std::to_string(v);
      cells += " " + std::to_string(v);
    }
    off += "\n", obj += "\n", medit += "0\n", poly += "\n", cells += "\n";
    for (int t = 1; t < 3; ++t)
      stl += "facet normal 0 0 0\nouter loop\nvertex " + corners[q[0]] + "\nvertex " + corners[q[t]] + "\nvertex " +
             corners[q[t + 1]] + "\nendloop\nendfacet\n";
  }
  stl += "endsolid a\n";
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 6\nproperty list uchar int vertex_indices\nend_header\n" +
    cube_points + poly;

  std::string connectivity, xml = vtu("", "format=\"ascii\">" + cube_points, "format=\"ascii\">CONNECTIVITY",
                                      "format=\"ascii\">4 8 12 16 20 24", "format=\"ascii\">9 9 9 9 9 9");
  for (const auto& q : quads)
    for (const int v : q)
      connectivity += std::to_string(v) + " ";
  xml.replace(xml.find("CONNECTIVITY"), 12, connectivity);
  xml.replace(xml.find("NumberOfCells=\"1"), 16, "NumberOfCells=\"6");

  const std::string poly_header = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\n";
  for (const std::string& file :
       {write("a.off", off), write("a.obj", obj), write("a.STL", stl), write("a.ply", ply), write("a.mesh", medit),
        write("a.vtk", vtk_header + vtk + cells + "CELL_TYPES 7\n12 9 9 9 9 9 9\n"),
        write("b.vtk", poly_header + vtk + "POLYGONS 6 30\n" + poly + "CELL_DATA 6\n"), write("a.vtu", xml)}) {
    CGAL::Surface_mesh<Epick::Point_3> surface;
    surface.add_vertex();
    CGAL::IO::read_surface(file, surface);
    EXPECT_EQ(num_vertices(surface), 8u) << file;
    EXPECT_EQ(num_faces(surface), 12u) << file;
    EXPECT_TRUE(CGAL::is_closed(surface)) << file;
    EXPECT_TRUE(CGAL::is_triangle_mesh(surface)) << file;
  }
}

TEST_F(Io, surface_errors)
{
  CGAL::Surface_mesh<Epick::Point_3> surface;
  surface.add_vertex();
  const auto fails = [&](const std::string& name, const std::string& text, std::size_t line,
                         const std::string& reason) {
    const std::string filename = write(name, text);
    try {
      CGAL::IO::read_surface(filename, surface);
      ADD_FAILURE() << "nothing was thrown for " << name;
    }
    catch (const CGAL::IO::Hex_mesh_file_error& error) {
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  EXPECT_THROW(CGAL::IO::read_surface(path("missing.off"), surface), CGAL::IO::Hex_mesh_file_error);
  fails("a.stl", "", 0, "no polygons");
  fails("a.obj", "", 0, ".obj format");
  fails("a.off", "", 1, "does not begin with OFF");
  fails("a.off", "OFF BINARY\n", 1, "binary");
  fails("a.off", "OFF\n-1 1 0\n", 2, "the number of vertices is negative");
  fails("a.off", "OFF\n2000000000 1 0\n0 0 0\n", 2, "more than the rest of the file can hold");
  fails("a.off", "OFF\n1 2000000000 0\n0 0 0\n", 2, "more than the rest of the file can hold");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", 6, "more than the rest of the file can hold");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", 5, "the data end here");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", 4, "not a finite number");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n", 6, "vertex 9 does not exist");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", 6, "vertex -1 does not exist");
  fails("a.off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n", 4, "at infinity");
  fails("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n", 0, "no polygons");
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 1\nproperty list uint int vertex_indices\n"; // lines 1 to 8
  fails("a.ply", "", 1, "does not begin with \"ply\"");
  fails("a.ply", ply, 9, "the header does not end");
  fails("a.ply", "ply\nformat dvi 1.0\nend_header\n", 0, "the format is none of");
  fails("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n", 3, "negative");
  fails("a.ply", "ply\nproperty double x\n", 2, "before all elements");
  fails("a.ply", ply + "property real r\n", 9, "numbers of type \"real\"");
  fails("a.ply", ply + "color red\n", 9, "unknown keyword \"color\"");
  fails("a.ply", ply + "end_header\n0 0 0\n", 10, "fewer elements vertex");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 1    ", 12, "the data end here");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", 12, "not a finite number");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", 13,
        "a list cannot have 4000000000 numbers");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", 13, "a list cannot have -3 numbers");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", 0, "face 0 refers to vertex 3");
  fails("a.ply", ply + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -7\n", 0, "face 0 refers to vertex -7");
  std::string many = ply;
  many.replace(many.find("vertex 3"), 8, "vertex 4000000000");
  fails("a.ply", many + "end_header\n0 0 0\n", 10, "fewer elements vertex");
  std::string binary = ply;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  fails("a.ply", binary + "end_header\n" + std::string(80, '\xff'), 0, "not finite");
  fails("a.ply", binary + "end_header\n" + std::string(72, '\0') + std::string(16, '\xff'), 0,
        "a list cannot have 4294967295 numbers");
  fails("a.ply", binary + "end_header\n" + std::string(60, '\0'), 0, "the file ends within the data");
  fails("a.stl", std::string(80, ' ') + std::string(4, '\xff') + std::string(50, '\0'), 0, ".stl format");
  fails("a.xyz", "0 0 0\n", 0, "the format is unknown");
  fails("a.mesh", medit_header + medit_vertices() + medit_hexahedra, 0, "no polygons");
  fails("a.mesh", medit_header + medit_vertices() + "Triangles\n1\n1 2 9 0\n", 15, "vertex 9 does not exist");
  fails("a.vtk", vtk_header + vtk_points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n9\n", 15, "cell 0: it has 3 vertices");
  EXPECT_EQ(num_vertices(surface), 1u);
}

TEST_F(Io, surfaces_with_the_line_ends_of_windows)
{
  std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a.ply", ply},
        {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                  "endloop\nendfacet\nendsolid a\n"},
        {"a.mesh", medit_header + medit_vertices() + "Triangles\n1\n1 2 3 0\nEnd\n"}}) {
    std::string windows;
    for (const char c : text)
      windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    CGAL::Surface_mesh<Epick::Point_3> surface;
    CGAL::IO::read_surface(write(name, windows), surface);
    EXPECT_EQ(num_faces(surface), 1u) << name;
  }
}

TEST_F(Io, surfaces_in_other_kinds_of_off_and_ply)
{
  const auto triangles = [&](const std::string& name, const std::string& text) {
    CGAL::Surface_mesh<Epick::Point_3> surface;
    CGAL::IO::read_surface(write(name, text), surface);
    EXPECT_EQ(num_vertices(surface), 3u) << text;
    double sum = 0;
    for (const auto v : surface.vertices())
      sum += surface.point(v).x() + 2 * surface.point(v).y() + 4 * surface.point(v).z();
    EXPECT_EQ(sum, 3) << text; // (0, 0, 0), (1, 0, 0), (0, 1, 0)
    return num_faces(surface);
  };
  EXPECT_EQ(triangles("a.off", "# c\n\nOFF # c\n# c\n3 1 0 # c\n0 0 0\n1 0 0 # c\n\n0 1 0\n3 0 1 2 255 0 0\n"), 1u);
  EXPECT_EQ(triangles("a.off", "OFF 3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2"), 1u);
  EXPECT_EQ(triangles("a.off", "COFF\n3 1 0\n0 0 0 2\n1 0 0\n0 1 0\n3 0 1 2\n"), 1u) << "one vertex has a color";
  EXPECT_EQ(triangles("a.off", "STCN4OFF\n3 1 0\n0 0 0 2 9 9 9\n2 0 0 2 9 9 9\n0 .5 0 .5 9 9\n3 0 1 2\n"), 1u);
  EXPECT_EQ(
    triangles("a.ply",
              "ply\ncomment c\nformat ascii 1.0\nelement nothing 7\nelement vertex 3\nproperty list uchar float w\n"
              "property int x\nproperty float y\nproperty float nx\nproperty float z\nelement edge 1\n"
              "property int a\nelement face 2\nproperty uchar flag\nproperty list uchar uint vertex_index\n"
              "end_header\n2 1 2 0 0 9 0\n0 1 0 9 0\n1 5 0 1 9 0\n7\n1 3 0 1 2\n1 2 0 1\n"),
    1u);
  for (const bool little : {true, false}) {
    std::string binary = std::string("ply\nformat binary_") + (little ? "little" : "big") +
                         "_endian 1.0\nelement face 1\n"
                         "property list short uint vertex_indices\nproperty double d\nelement vertex 3\n"
                         "property float z\nproperty double y\nproperty char x\nend_header\n";
    binary += bytes_of<std::int16_t>({3}, little) + bytes_of<std::uint32_t>({0, 1, 2}, little) +
              bytes_of<double>({7}, little);
    for (int v = 0; v < 3; ++v)
      binary += bytes_of<float>({0}, little) + bytes_of<double>({double(v == 2)}, little) +
                bytes_of<std::int8_t>({std::int8_t(v == 1)}, little);
    EXPECT_EQ(triangles("a.ply", binary), 1u) << little;
  }
}

// Sum of the areas of the triangles
double total_area(const CGAL::Surface_mesh<Epick::Point_3>& surface)
{
  double sum = 0;
  for (const auto f : surface.faces()) {
    std::vector<Epick::Point_3> p;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      p.push_back(surface.point(v));
    sum += std::sqrt(CGAL::to_double(CGAL::cross_product(p[1] - p[0], p[2] - p[0]).squared_length())) / 2;
  }
  return sum;
}

// Whatever its shape, a polygon of n corners gives n - 2 connected triangles, and a simple one is covered once.
TEST_F(Io, polygons_are_triangulated)
{
  const auto read = [&](const std::vector<std::array<double, 3>>& corners) {
    std::string text = "OFF\n" + std::to_string(corners.size()) + " 1 0\n", face = std::to_string(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (const double x : corners[i])
        text += std::to_string(x) + " ";
      text += "\n";
      face += " " + std::to_string(i);
    }
    CGAL::Surface_mesh<Epick::Point_3> surface;
    CGAL::IO::read_surface(write("a.off", text + face + "\n"), surface);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
    EXPECT_EQ(num_vertices(surface), corners.size());
    EXPECT_EQ(num_faces(surface), corners.size() - 2);
    return surface;
  };
  // an L, a comb, a spiral; upright and turned over
  const std::vector<std::vector<std::array<double, 2>>> shapes = {
    {{{0, 0}}, {{2, 0}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{0, 2}}},
    {{{0, 0}},
     {{5, 0}},
     {{5, 3}},
     {{4, 3}},
     {{4, 1}},
     {{3, 1}},
     {{3, 3}},
     {{2, 3}},
     {{2, 1}},
     {{1, 1}},
     {{1, 3}},
     {{0, 3}}},
    {{{0, 0}}, {{4, 0}}, {{4, 4}}, {{1, 4}}, {{1, 2}}, {{2, 2}}, {{2, 3}}, {{3, 3}}, {{3, 1}}, {{0, 1}}}};
  for (const auto& shape : shapes)
    for (int plane = 0; plane < 3; ++plane)
      for (const bool backwards : {false, true}) {
        double area = 0;
        std::vector<std::array<double, 3>> corners;
        for (std::size_t i = 0; i < shape.size(); ++i) {
          const auto &p = shape[i], &q = shape[(i + 1) % shape.size()];
          area += (p[0] * q[1] - p[1] * q[0]) / 2;
          std::array<double, 3> corner = {{9, 9, 9}};
          corner[(plane + 1) % 3] = p[0];
          corner[(plane + 2) % 3] = p[1];
          corners.push_back(corner);
        }
        if (backwards)
          std::reverse(corners.begin(), corners.end());
        EXPECT_NEAR(total_area(read(corners)), area, 1e-12);
      }
  // a bow tie of five, all in a line, all in a point, a random walk
  read({{{0, 0, 0}}, {{2, 2, 0}}, {{2, 0, 0}}, {{0, 2, 0}}, {{-1, 1, 0}}});
  read({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}, {{4, 0, 0}}});
  read({{{1, 1, 1}}, {{1, 1, 1}}, {{1, 1, 1}}, {{1, 1, 1}}, {{1, 1, 1}}});
  std::mt19937 random(5);
  for (int n = 4; n < 60; ++n) {
    std::vector<std::array<double, 3>> corners(n);
    for (auto& p : corners)
      for (double& x : p)
        x = double(random() % 10);
    read(corners);
  }
}

} // namespace
