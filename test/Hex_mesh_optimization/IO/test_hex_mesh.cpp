// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of all formats: what is written comes back bit by bit and in order.

#include "Io_test.h"

#include "../mesh_checks.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

class Hex_mesh_file : public Io_test
{};

TEST_F(Hex_mesh_file, all_formats_give_back_every_bit)
{
  std::vector<Simple::Point_3> points, points_back;
  std::vector<Cell> hexahedra, hexahedra_back;
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

TEST_F(Hex_mesh_file, larger_meshes_and_other_containers)
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

TEST_F(Hex_mesh_file, empty_meshes)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
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
  std::vector<Cell> hexahedra, hexahedra_back;
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

TEST_F(Hex_mesh_file, linear_cell_complexes)
{
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"}) {
    check_linear_cell_complex<CGAL::Linear_cell_complex_for_combinatorial_map<3, 3>>(path(name));
    check_linear_cell_complex<
      CGAL::Linear_cell_complex_for_generalized_map<3, 3, CGAL::Linear_cell_complex_traits<3, Simple>>>(path(name));
  }
}

TEST_F(Hex_mesh_file, linear_cell_complex_keeps_mesh_data_and_stays_upon_an_error)
{
  CGAL::Linear_cell_complex_for_combinatorial_map<3, 3> lcc;
  CGAL::IO::Hex_mesh_data mesh_data;
  const std::string text = medit_header + medit_vertices() + medit_hexahedra + "Corners\n2\n1\n8\nEnd\n";
  CGAL::IO::read_hex_mesh(write("a.mesh", text), lcc, mesh_data);
  CGAL::IO::write_hex_mesh(path("b.mesh"), lcc, mesh_data);
  EXPECT_EQ(content(path("b.mesh")), text);

  const std::string bad = medit_header + medit_vertices() + "Hexahedra\n1\n1 2 3 4 5 6 7 7 0\nEnd\n";
  EXPECT_THROW(CGAL::IO::read_hex_mesh(write("c.mesh", bad), lcc), CGAL::IO::Hex_mesh_file_error);
  EXPECT_EQ(lcc.number_of_vertex_attributes(), 8u);
}

TEST_F(Hex_mesh_file, missing_files_and_folders)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
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

// Any prefix and any damage ends in an error or a mesh, never in a crash.
TEST_F(Hex_mesh_file, damaged_files_do_no_harm)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  Mesh_data mesh_data;
  add_other_cells(mesh_data);
  mesh_data.point_data = arrays_of_all_types(3 * points.size(), 3);
  mesh_data.cell_data = arrays_of_all_types(6, 1);
  mesh_data.field_data = arrays_of_all_types(5, 1);
  std::mt19937 random(3);
  for (const char* name : {"a.mesh", "a.vtk", "a.vtu"})
    for (const bool binary : {false, true}) {
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, mesh_data, CGAL::parameters::use_binary_mode(binary));
      const std::string good = content(path(name));
      for (int i = 0; i < 300; ++i) {
        std::string bad = good;
        if (i % 2 == 0)
          bad.resize(random() % bad.size());
        else
          for (int j = 0; j < 3; ++j)
            bad[random() % bad.size()] = static_cast<char>(random());
        std::vector<Simple::Point_3> p;
        std::vector<Cell> h;
        try {
          CGAL::IO::read_hex_mesh(write(name, bad), p, h);
          for (const Cell& hexahedron : h)
            for (const std::size_t v : hexahedron)
              EXPECT_LT(v, p.size());
        }
        catch (const CGAL::IO::Hex_mesh_file_error&) {
        }
      }
    }
}

TEST_F(Hex_mesh_file, output_appears_complete_or_not_at_all)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  write("old.mesh", "old");
  CGAL::IO::Hex_mesh_data wrong;
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

// Labels of points, hexahedra, quadrilaterals, triangles and edges go through every format and back.
TEST_F(Hex_mesh_file, labels_survive_any_change_of_format)
{
  std::vector<Simple::Point_3> points, points_back;
  std::vector<Cell> hexahedra, hexahedra_back;
  make_mesh(points, hexahedra);
  Mesh_data mesh_data;
  mesh_data.hexahedron_labels = {-3, 1234567890123};
  for (std::size_t v = 0; v < points.size(); ++v)
    mesh_data.vertex_labels.push_back(std::int64_t(v) - 5);
  mesh_data.other_cells = {{9, {1, 2, 4, 3}, 7, 2}, {5, {1, 2, 3}, -8, 2}, {3, {0, 1}, 9, 2}};
  CGAL::IO::write_hex_mesh(path("0.mesh"), points, hexahedra, mesh_data);
  std::string last = "0.mesh";
  for (const char* next : {"1.vtk", "2.vtu", "3.vtk", "4.mesh", "5.vtu", "6.mesh"}) {
    SCOPED_TRACE(next);
    Mesh_data read;
    CGAL::IO::read_hex_mesh(path(last), points_back, hexahedra_back, read);
    EXPECT_TRUE(read.skipped.empty());
    EXPECT_TRUE(CGAL::IO::unsupported_data(next, read).empty());
    CGAL::IO::write_hex_mesh(path(next), points_back, hexahedra_back, read);
    CGAL::IO::read_hex_mesh(path(next), points_back, hexahedra_back, read);
    EXPECT_TRUE(same_points(points, points_back));
    EXPECT_EQ(hexahedra, hexahedra_back);
    EXPECT_EQ(read.hexahedron_labels, mesh_data.hexahedron_labels);
    EXPECT_EQ(read.vertex_labels, mesh_data.vertex_labels);
    expect_same_cells(mesh_data, read);
    last = next;
  }
  EXPECT_EQ(content(path("0.mesh")), content(path("6.mesh")));
}

// Nobody has labeled anything: no array appears.
TEST_F(Hex_mesh_file, labels_that_are_all_0_are_none)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  Mesh_data mesh_data;
  mesh_data.hexahedron_labels = {0, 0};
  mesh_data.vertex_labels.assign(points.size(), 0);
  for (const char* name : {"a.vtk", "a.vtu"}) {
    CGAL::IO::write_hex_mesh(path(name), points, hexahedra, mesh_data);
    EXPECT_EQ(content(path(name)).find("ref"), std::string::npos);
  }
}

// Labels that the caller has changed are written in the place and the type of the array that they came from.
TEST_F(Hex_mesh_file, changed_labels_are_written)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  for (const char* name : {"a.vtk", "a.vtu"}) {
    Mesh_data mesh_data, read;
    mesh_data.cell_data.emplace_back();
    mesh_data.cell_data.back().name = "Material";
    mesh_data.cell_data.back().values = std::vector<float>{1, 2};
    CGAL::IO::write_hex_mesh(path(name), points, hexahedra, mesh_data);
    CGAL::IO::read_hex_mesh(path(name), points, hexahedra, read);
    EXPECT_EQ(read.hexahedron_labels, (std::vector<std::int64_t>{1, 2}));
    read.hexahedron_labels = {5, 6};
    CGAL::IO::write_hex_mesh(path(name), points, hexahedra, read);
    CGAL::IO::read_hex_mesh(path(name), points, hexahedra, read);
    ASSERT_EQ(read.cell_data.size(), 1u);
    EXPECT_EQ(read.cell_data[0].values, Array::Values(std::vector<float>{5, 6}));
    EXPECT_EQ(read.hexahedron_labels, (std::vector<std::int64_t>{5, 6}));
  }
}

// Arrays of every type on points, cells and the mesh, and cells of other kinds, in their order.
TEST_F(Hex_mesh_file, data_come_back)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  Mesh_data mesh_data;
  add_other_cells(mesh_data);
  for (std::size_t components : {1, 2, 3, 9}) {
    for (const Array& array : arrays_of_all_types(components * points.size(), components))
      mesh_data.point_data.push_back(array);
    for (const Array& array : arrays_of_all_types(components * 6, components))
      mesh_data.cell_data.push_back(array);
    for (const Array& array : arrays_of_all_types(components * 5, components))
      mesh_data.field_data.push_back(array);
  }
  for (const char* name : {"a.vtk", "a.vtu"})
    for (const bool is_binary : {false, true}) {
      SCOPED_TRACE(std::string(name) + (is_binary ? " in binary" : ""));
      mesh_data.is_binary = is_binary;
      CGAL::IO::write_hex_mesh(path(name), points, hexahedra, mesh_data);
      std::vector<Simple::Point_3> points_back;
      std::vector<Cell> hexahedra_back;
      Mesh_data read;
      CGAL::IO::read_hex_mesh(path(name), points_back, hexahedra_back, read);
      EXPECT_TRUE(read.skipped.empty()) << read.skipped[0];
      EXPECT_TRUE(same_points(points, points_back));
      EXPECT_EQ(hexahedra, hexahedra_back);
      EXPECT_EQ(read.is_binary, is_binary);
      expect_same_cells(mesh_data, read);
      expect_same_arrays(mesh_data.point_data, read.point_data);
      expect_same_arrays(mesh_data.cell_data, read.cell_data);
      expect_same_arrays(mesh_data.field_data, read.field_data);
      const std::string before = content(path(name));
      CGAL::IO::write_hex_mesh(path(name), points_back, hexahedra_back, read);
      EXPECT_EQ(content(path(name)), before) << "the second time is as the first";
    }
}

TEST_F(Hex_mesh_file, data_that_do_not_fit_are_refused)
{
  std::vector<Simple::Point_3> points;
  std::vector<Cell> hexahedra;
  make_mesh(points, hexahedra);
  for (const char* name : {"a.vtk", "a.vtu"})
    for (auto Mesh_data::*arrays : {&Mesh_data::point_data, &Mesh_data::cell_data}) {
      Mesh_data mesh_data;
      mesh_data.*arrays = arrays_of_all_types(7, 1);
      EXPECT_THROW(CGAL::IO::write_hex_mesh(path(name), points, hexahedra, mesh_data), CGAL::IO::Hex_mesh_file_error);
      EXPECT_FALSE(std::filesystem::exists(path(name)));
    }
}

} // namespace
