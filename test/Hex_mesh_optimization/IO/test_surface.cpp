// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces in all formats, and what cannot be read is refused with the line it is in.

#include "Io_test.h"

#include <CGAL/Hex_mesh_optimization/IO/surface.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

class Surface_file : public Io_test
{};

// A cube as six quadrilaterals in every format.
TEST_F(Surface_file, surfaces)
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

TEST_F(Surface_file, surface_errors)
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
  fails("a.mesh", medit_header + medit_vertices(), 0, "no polygons");
  fails("a.mesh", medit_header + medit_vertices() + "Triangles\n1\n1 2 9 0\n", 15, "vertex 9 does not exist");
  fails("a.vtk", vtk_header + vtk_points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n9\n", 15, "cell 0: it has 3 vertices");
  EXPECT_EQ(num_vertices(surface), 1u);
}

TEST_F(Surface_file, surfaces_with_the_line_ends_of_windows)
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

TEST_F(Surface_file, surfaces_in_other_kinds_of_off_and_ply)
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
TEST_F(Surface_file, polygons_are_triangulated)
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
