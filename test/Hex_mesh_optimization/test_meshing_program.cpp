// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program make_hex_mesh as other programs see it: what it writes, what it prints, and its exit codes.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace {

namespace fs = std::filesystem;

const char* const cube = "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
const char* const open_cube = "OFF\n8 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                              "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n";

// Each test runs in a folder of its own.
class Meshing_program : public testing::Test
{
protected:
  void SetUp() override
  {
    folder = fs::absolute(std::string("meshing_test_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::ofstream(folder / "cube.off") << cube;
    std::ofstream(folder / "open.off") << open_cube;
  }

  void TearDown() override { fs::remove_all(folder); }

  int run(const std::string& arguments)
  {
    const std::string line = "cd '" + folder.string() + "' && '" MAKE_HEX_MESH "' " + arguments + " >stdout 2>stderr";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string text(const std::string& name) const
  {
    std::ifstream in(folder / name);
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  bool exists(const std::string& name) const { return fs::exists(folder / name); }

  std::size_t number_of_hexahedra(const std::string& name) const
  {
    std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    CGAL::IO::read_hex_mesh((folder / name).string(), points, hexahedra);
    return hexahedra.size();
  }

  fs::path folder;
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Meshing_program, makes_a_mesh_and_prints_a_table)
{
  EXPECT_EQ(run("cube.off out.mesh --cells 216"), 0);
  EXPECT_GE(number_of_hexahedra("out.mesh"), 125u); // whole numbers of cells along an edge
  EXPECT_LE(number_of_hexahedra("out.mesh"), 343u);
  EXPECT_TRUE(contains(text("stdout"), "minimum scaled Jacobian"));
  EXPECT_TRUE(contains(text("stdout"), "The mesh is valid."));
  EXPECT_EQ(text("stderr"), "");
}

TEST_F(Meshing_program, takes_a_spacing_and_writes_a_report)
{
  EXPECT_EQ(run("cube.off out.vtk --spacing .25 --json report.json --quiet"), 0);
  EXPECT_EQ(number_of_hexahedra("out.vtk"), 64u);
  EXPECT_EQ(text("stdout"), "");
  const nlohmann::json report = nlohmann::json::parse(text("report.json"));
  EXPECT_EQ(report["options"]["spacing"], .25);
  EXPECT_NEAR(report["status"]["spacing"].get<double>(), .25, 1e-9);
  EXPECT_EQ(report["status"]["valid_mesh"], true);
  EXPECT_EQ(report["status"]["has_topology_of_surface"], true);
  EXPECT_TRUE(report["status"]["thin_faces"].empty());
}

TEST_F(Meshing_program, refuses_an_open_surface_or_mends_it_on_request)
{
  EXPECT_EQ(run("open.off out.mesh --cells 100"), 3);
  EXPECT_FALSE(exists("out.mesh"));
  EXPECT_TRUE(contains(text("stderr"), "the surface is open"));
  EXPECT_EQ(run("open.off out.mesh --cells 100 --repair"), 0);
  EXPECT_TRUE(exists("out.mesh"));
}

// A second cube crosses the first, and its faces are there twice.
TEST_F(Meshing_program, takes_parts_that_cross_and_tells_what_it_took)
{
  std::ofstream(folder / "two.off")
    << "OFF\n16 18 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
       ".5 .5 .5\n2 .5 .5\n2 2 .5\n.5 2 .5\n.5 .5 2\n2 .5 2\n2 2 2\n.5 2 2\n"
       "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
       "4 8 11 10 9\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n"
       "4 8 11 10 9\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n";
  EXPECT_EQ(run("two.off out.mesh --cells 300 --json report.json"), 0);
  EXPECT_TRUE(contains(text("stdout"), "12 faces are copies of others"));
  EXPECT_TRUE(contains(text("stdout"), "its 2 closed parts bound 1 body"));
  const nlohmann::json status = nlohmann::json::parse(text("report.json"))["status"];
  EXPECT_NEAR(status["surface"]["volume"].get<double>(), 1 + 3.375 - .125, 1e-9);
  EXPECT_NEAR(status["volume_after"].get<double>(), 4.25, .02);
  EXPECT_EQ(status["matches_surface"], true);
}

// As .stl, with the facets of two cubes in two solids.
void write_solids(const fs::path& file)
{
  std::ofstream out(file);
  for (int solid : {0, 1}) {
    out << "solid part" << solid << '\n';
    const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (const int(&f)[4] : faces)
      for (int half : {1, 2}) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (int v : {f[0], f[half], f[half + 1]})
          out << "vertex " << solid + (v % 4 == 1 || v % 4 == 2) << ' ' << (v % 4 >= 2) << ' ' << (v >= 4) << '\n';
        out << "endloop\nendfacet\n";
      }
    out << "endsolid part" << solid << '\n';
  }
}

std::size_t number_with_label(const fs::path& file, int label)
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::IO::Hex_mesh_data mesh_data;
  CGAL::IO::read_hex_mesh(file.string(), points, hexahedra, mesh_data);
  return std::size_t(std::count(mesh_data.hexahedron_labels.begin(), mesh_data.hexahedron_labels.end(), label));
}

TEST_F(Meshing_program, keeps_solids_of_a_file_apart_with_labels)
{
  write_solids(folder / "two.stl");
  for (const std::string output : {"out.vtu", "out.vtk", "out.mesh"}) {
    EXPECT_EQ(run("two.stl " + output + " --materials --spacing .25 --json report.json"), 0);
    EXPECT_EQ(number_with_label(folder / output, 1), 64u);
    EXPECT_EQ(number_with_label(folder / output, 2), 64u);
  }
  EXPECT_TRUE(contains(text("stdout"), "Part 1: 64 hexahedra, volume 1 of 1"));
  EXPECT_TRUE(contains(text("stdout"), "between labels 1 and 2"));
  const nlohmann::json parts = nlohmann::json::parse(text("report.json"))["status"]["parts"];
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[1]["volume_after"].get<double>(), 1, 1e-9);
}

// Of each file a part; the later one has what both have.
TEST_F(Meshing_program, takes_each_of_several_files_for_a_part)
{
  std::ofstream(folder / "upper.off") << "OFF\n8 6 0\n0 0 .5\n1 0 .5\n1 1 .5\n0 1 .5\n0 0 2\n1 0 2\n1 1 2\n0 1 2\n"
                                         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  EXPECT_EQ(run("cube.off upper.off out.mesh --materials --spacing .25"), 0);
  EXPECT_EQ(number_with_label(folder / "out.mesh", 1), 32u);
  EXPECT_EQ(number_with_label(folder / "out.mesh", 2), 96u);
  EXPECT_EQ(run("cube.off upper.off out.mesh --spacing .25"), 0); // their union
  EXPECT_EQ(number_of_hexahedra("out.mesh"), 128u);
}

TEST_F(Meshing_program, refuses_cells_that_lose_a_part_and_says_which)
{
  std::ofstream(folder / "tiny.off") << "OFF\n8 6 0\n.4 .4 .49\n.6 .4 .49\n.6 .6 .49\n.4 .6 .49\n.4 .4 .51\n.6 .4 .51\n"
                                        ".6 .6 .51\n.4 .6 .51\n"
                                        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  EXPECT_EQ(run("cube.off tiny.off out.mesh --materials --spacing .5"), 3);
  EXPECT_TRUE(contains(text("stderr"), "part 2 is about"));
  EXPECT_TRUE(contains(text("stderr"), "would do"));
  EXPECT_FALSE(exists("out.mesh"));
}

TEST_F(Meshing_program, keeps_parts_apart_however_narrow_the_gap_between_them)
{
  std::ofstream(folder / "near.off") << "OFF\n8 6 0\n1.001 0 0\n2 0 0\n2 1 0\n1.001 1 0\n1.001 0 1\n2 0 1\n2 1 1\n"
                                        "1.001 1 1\n"
                                        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  EXPECT_EQ(run("cube.off near.off out.mesh --materials --spacing .25 --json report.json"), 0);
  EXPECT_EQ(number_with_label(folder / "out.mesh", 1), 64u);
  EXPECT_EQ(number_with_label(folder / "out.mesh", 2), 64u);
  const nlohmann::json status = nlohmann::json::parse(text("report.json"))["status"];
  EXPECT_EQ(status["number_of_bodies"], 2);
  ASSERT_EQ(status["parts"].size(), 2u);
  EXPECT_NEAR(status["parts"][0]["volume_after"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(status["parts"][1]["volume_after"].get<double>(), .999, 1e-9);
  EXPECT_EQ(status["regions"].size(), 2u);
}

TEST_F(Meshing_program, tells_wrong_usage_from_files_that_cannot_be_used)
{
  EXPECT_EQ(run("--help"), 0);
  EXPECT_EQ(run("cube.off"), 2);
  EXPECT_EQ(run("cube.off out.mesh --cells 0"), 2);
  EXPECT_EQ(run("cube.off out.mesh --cells 100 --spacing .1"), 2);
  EXPECT_EQ(run("cube.off out.mesh --materials --repair"), 2);
  EXPECT_EQ(run("cube.off out.mesh --spacing 100"), 0); // a single cell
  EXPECT_EQ(run("cube.off out.unknown"), 3);
  EXPECT_EQ(run("missing.off out.mesh"), 3);
}

TEST_F(Meshing_program, tells_its_version)
{
  EXPECT_EQ(run("--version"), 0);
  EXPECT_EQ(text("stdout"), CGAL_HEX_MESH_OPTIMIZATION_VERSION "\n");
}

} // namespace
