// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The program optimize_hex_mesh as other programs see it: what it writes, what
// it prints, and its exit codes.

#include <CGAL/Hex_mesh_optimization/IO/medit.h>
#include <CGAL/Hex_mesh_optimization/IO/vtu.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include <CGAL/Simple_cartesian.h>

#include "Folder_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <sys/wait.h>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace fs = std::filesystem;
using Point = CGAL::Simple_cartesian<double>::Point_3;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::IO::Hex_mesh_data mesh_data;
};

class Program : public test::Folder_test
{
protected:
  // The exit code of a shell command, in which $PROGRAM is the program.
  int shell(const std::string& command)
  {
    const std::string line = "cd '" + folder.string() + "' && PROGRAM='" OPTIMIZE_HEX_MESH "' && { " + command +
                             "; } >stdout 2>stderr";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  int run(const std::string& arguments) { return shell("\"$PROGRAM\" " + arguments); }

  std::string text(const std::string& name) const
  {
    std::ifstream in(folder / name);
    EXPECT_TRUE(in) << name;
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }

  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(text(name)); }

  void write(const std::string& name, const Mesh& mesh) const
  {
    CGAL::IO::write_medit_hex_mesh((folder / name).string(), mesh.points, mesh.hexahedra, mesh.mesh_data);
  }

  Mesh read(const std::string& name) const
  {
    Mesh mesh;
    CGAL::IO::read_medit_hex_mesh((folder / name).string(), mesh.points, mesh.hexahedra, mesh.mesh_data);
    return mesh;
  }

  static Mesh tangled_block()
  {
    Mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{4, 4, 4}});
    HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
    return mesh;
  }

  // A corner of the boundary is pushed out through the opposite side.
  static Mesh hopeless_block()
  {
    Mesh mesh;
    HMO::make_block(mesh.points, mesh.hexahedra, {{2, 2, 2}});
    mesh.points[0] = Point(2, 2, 2);
    return mesh;
  }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Program, repairs_a_tangled_mesh_and_prints_a_table)
{
  const Mesh input = tangled_block();
  write("in.mesh", input);
  EXPECT_EQ(run("in.mesh out.mesh"), 0);

  const Mesh output = read("out.mesh");
  EXPECT_EQ(output.hexahedra, input.hexahedra);
  EXPECT_EQ(output.points.size(), input.points.size());
  EXPECT_EQ(HMO::quality_statistics(output.points, output.hexahedra).number_of_invalid, 0u);

  const std::string table = text("stdout");
  for (const char* title :
       {"before", "after", "inverted", "invalid", "minimum", "mean", "standard deviation", "edge ratio", "volume",
        "average deviation", "maximum deviation", "seconds", "of rectification", "of untangling", "of maximization",
        "Stopped after", "The mesh is valid."})
    EXPECT_TRUE(contains(table, title)) << title << " in\n" << table;
  EXPECT_EQ(text("stderr"), "") << "progress is for terminals";
}

TEST_F(Program, takes_options_before_the_file_names)
{
  write("in.mesh", tangled_block());
  write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(run("--method rectification in.mesh out.vtk --reference cube.off --json out.json"), 0) << text("stderr");
  EXPECT_TRUE(exists("out.vtk"));
  const nlohmann::json report = json("out.json");
  EXPECT_EQ(report["options"]["method"], "rectification");
  EXPECT_EQ(report["options"]["reference"], "cube.off");
  EXPECT_LT(report["status"]["deviation"]["maximum_relative"], .02);
}

TEST_F(Program, prints_nothing_when_quiet)
{
  write("in.mesh", tangled_block());
  EXPECT_EQ(run("in.mesh out.mesh --quiet"), 0);
  EXPECT_EQ(text("stdout") + text("stderr"), "");
  write("hopeless.mesh", hopeless_block());
  EXPECT_EQ(run("hopeless.mesh out.mesh --quiet --fixed-boundary"), 1);
  EXPECT_EQ(text("stdout") + text("stderr"), "");
}

TEST_F(Program, reports_every_iteration_in_json)
{
  write("in.mesh", tangled_block());
  EXPECT_EQ(run("in.mesh out.mesh --json out.json"), 0);
  const nlohmann::json report = json("out.json");
  const nlohmann::json& status = report["status"];
  EXPECT_TRUE(status["return_code"].is_string());
  EXPECT_EQ(status["valid_mesh"], true);
  EXPECT_EQ(status["number_of_reoriented_hexahedra"], 0);
  EXPECT_EQ(status["number_of_coincident_vertices"], 0);
  EXPECT_EQ(report["lost"], nlohmann::json::array());
  EXPECT_EQ(status["invalid_hexahedra"], nlohmann::json::array());
  EXPECT_GT(status["before"]["number_of_inverted"], 0);
  EXPECT_EQ(status["after"]["number_of_inverted"], 0);
  double of_stages = 0;
  for (const char* stage : {"rectification_seconds", "untangling_seconds", "maximization_seconds"}) {
    EXPECT_GE(status[stage], 0.) << stage;
    of_stages += double(status[stage]);
  }
  EXPECT_GT(of_stages, 0.);
  EXPECT_GT(status["total_seconds"], of_stages);

  const Mesh output = read("out.mesh");
  EXPECT_EQ(status["after"]["minimum"], HMO::quality_statistics(output.points, output.hexahedra).minimum)
    << "the numbers are those of the file, to the last bit";

  ASSERT_TRUE(report["iterations"].is_array());
  EXPECT_EQ(report["iterations"].size(), status["iterations"]);
  EXPECT_GT(report["iterations"].size(), 0u);
  for (const nlohmann::json& iteration : report["iterations"])
    for (const char* number : {"iteration", "energy", "number_of_inverted", "minimum", "average", "seconds"})
      EXPECT_TRUE(iteration[number].is_number()) << number;
}

TEST_F(Program, lists_the_hexahedra_that_stay_invalid)
{
  const Mesh input = hopeless_block();
  write("in.mesh", input);
  EXPECT_EQ(run("in.mesh out.mesh --fixed-boundary --json out.json"), 1);
  EXPECT_TRUE(contains(text("stdout"), "not valid"));
  EXPECT_EQ(read("out.mesh").points[0], input.points[0]);

  const nlohmann::json status = json("out.json")["status"];
  EXPECT_EQ(status["valid_mesh"], false);
  ASSERT_EQ(status["invalid_hexahedra"].size(), status["after"]["number_of_invalid"]);
  ASSERT_GT(status["invalid_hexahedra"].size(), 0u);
  EXPECT_EQ(status["invalid_hexahedra"][0]["id"], 0);
  EXPECT_EQ(status["invalid_hexahedra"][0]["center"].size(), 3u);
}

TEST_F(Program, tells_that_a_bound_of_the_deviation_is_not_met)
{
  Mesh mesh;
  HMO::make_ball(mesh.points, mesh.hexahedra, 3);
  write("in.mesh", mesh);
  write("cube.off", "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
                    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(run("in.mesh out.mesh --reference cube.off --fixed-boundary --max-deviation 1e-3 --json out.json"), 1)
    << text("stderr");
  EXPECT_TRUE(exists("out.mesh"));
  EXPECT_TRUE(contains(text("stdout"), "The deviation bound is not met"));
  EXPECT_TRUE(contains(text("stdout"), "deviation bound not certified"));
  const nlohmann::json status = json("out.json")["status"];
  EXPECT_EQ(status["return_code"], "DEVIATION_BOUND_NOT_MET");
  EXPECT_EQ(status["valid_mesh"], true);
  EXPECT_EQ(run("in.mesh out.mesh --reference cube.off --fixed-boundary --max-deviation 1"), 0) << text("stderr");
}

TEST_F(Program, keeps_the_boundary_on_the_surface)
{
  write("in.mesh", tangled_block());
  EXPECT_EQ(run("in.mesh out.mesh --on-surface --json out.json"), 0) << text("stderr");
  const nlohmann::json report = json("out.json");
  EXPECT_EQ(report["options"]["on_surface"], true);
  EXPECT_LT(report["status"]["deviation"]["maximum_relative"], 1e-12);
  EXPECT_NEAR(report["status"]["volume_before"], 1, 1e-12);
  EXPECT_NEAR(report["status"]["volume_after"], 1, 1e-12);
}

TEST_F(Program, says_how_many_hexahedra_are_at_their_limit)
{
  Mesh mesh;
  HMO::make_cylinder(mesh.points, mesh.hexahedra, 3, 4);
  write("in.mesh", mesh);
  EXPECT_EQ(run("in.mesh out.mesh --json out.json"), 0);
  const nlohmann::json limits = json("out.json")["status"]["connectivity_limits"];
  ASSERT_GT(limits.size(), 0u);
  std::size_t reached = 0;
  for (const nlohmann::json& l : limits) {
    EXPECT_LE(l["scaled_jacobian"], l["largest_scaled_jacobian"]);
    EXPECT_EQ(l["is_reached"], double(l["scaled_jacobian"]) >= double(l["largest_scaled_jacobian"]) - .01);
    reached += bool(l["is_reached"]);
  }
  EXPECT_EQ(contains(text("stdout"),
                     std::to_string(reached) + " hexahedra are at the limit that the connectivity sets"),
            reached > 0);
  EXPECT_EQ(contains(text("stdout"), "have a limit below 1 from the connectivity and are below it"),
            limits.size() > reached);
}

TEST_F(Program, refuses_a_reference_in_another_unit_of_length)
{
  write("in.mesh", tangled_block());
  write("cube.off",
        "OFF\n8 6 0\n0 0 0\n1000 0 0\n1000 1000 0\n0 1000 0\n0 0 1000\n1000 0 1000\n1000 1000 1000\n0 1000 1000\n"
        "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  EXPECT_EQ(run("in.mesh out.mesh --reference cube.off"), 3);
  EXPECT_TRUE(contains(text("stderr"), "times as large as the mesh")) << text("stderr");
  EXPECT_FALSE(exists("out.mesh"));
}

TEST_F(Program, refuses_wrong_usage)
{
  write("in.mesh", tangled_block());
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("in.mesh"), 2);
  for (const char* option :
       {"--unknown", "superfluous", "--threads 0", "--threads -1", "--method other", "--iterations -1",
        "--features-angle 200", "--features-angle x", "--time-limit -1", "--target-quality nan", "--json"}) {
    EXPECT_EQ(run(std::string("in.mesh out.mesh ") + option), 2) << option;
    EXPECT_NE(text("stderr"), "") << option;
  }
  EXPECT_FALSE(exists("out.mesh"));
  EXPECT_EQ(run("--help"), 0);
  EXPECT_TRUE(contains(text("stdout"), "Exit codes"));
}

TEST_F(Program, writes_nothing_when_a_file_is_unusable)
{
  Mesh mesh = tangled_block();
  write("in.mesh", mesh);
  write("garbage.mesh", "no mesh at all\n");
  write("fixed_out_of_range.txt", "0\n125\n");
  write("fixed_garbage.txt", "0 1\n");
  mesh.hexahedra[3][1] = mesh.hexahedra[3][0];
  write("repeated_vertex.mesh", mesh);
  mesh.hexahedra.clear();
  write("no_hexahedra.mesh", mesh);
  fs::create_directory(folder / "folder.mesh");
  for (const char* arguments :
       {"missing.mesh out.mesh", "garbage.mesh out.mesh", "repeated_vertex.mesh out.mesh", "no_hexahedra.mesh out.mesh",
        "in.mesh out.unknown", "in.mesh missing/out.mesh", "in.mesh folder.mesh",
        "in.mesh out.mesh --reference missing.off", "in.mesh out.mesh --reference garbage.mesh",
        "in.mesh out.mesh --fixed-vertices missing.txt", "in.mesh out.mesh --fixed-vertices fixed_out_of_range.txt",
        "in.mesh out.mesh --fixed-vertices fixed_garbage.txt", "in.mesh out.mesh --json missing/out.json"}) {
    EXPECT_EQ(run(arguments), 3) << arguments;
    EXPECT_TRUE(contains(text("stderr"), "error: ")) << arguments;
    EXPECT_EQ(text("stdout"), "") << arguments;
    EXPECT_FALSE(exists("out.mesh")) << arguments;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 9) << "no temporary file is left";

  write("out.mesh", "precious");
  EXPECT_EQ(run("garbage.mesh out.mesh"), 3);
  EXPECT_EQ(text("out.mesh"), "precious");
}

TEST_F(Program, looks_at_the_output_before_the_input)
{
  EXPECT_EQ(run("missing.mesh missing/out.mesh"), 3);
  EXPECT_TRUE(contains(text("stderr"), "missing/out.mesh"));
}

TEST_F(Program, renumbers_hexahedra_that_are_inside_out)
{
  const Mesh right = tangled_block();
  Mesh reversed = right;
  for (auto& h : reversed.hexahedra)
    std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
  write("in.mesh", reversed);
  EXPECT_EQ(run("in.mesh out.mesh --json out.json"), 0);
  EXPECT_EQ(read("out.mesh").hexahedra, right.hexahedra);
  EXPECT_TRUE(contains(text("stdout"), "inside out"));
  EXPECT_EQ(json("out.json")["status"]["number_of_reoriented_hexahedra"], 64);
}

// One of them is written turned, in its place and with its label; the others stay.
TEST_F(Program, renumbers_a_single_hexahedron_that_is_inside_out)
{
  const Mesh right = tangled_block();
  Mesh mirrored = right;
  std::swap_ranges(mirrored.hexahedra[21].begin(), mirrored.hexahedra[21].begin() + 4,
                   mirrored.hexahedra[21].begin() + 4);
  for (std::size_t h = 0; h < 64; ++h)
    mirrored.mesh_data.hexahedron_labels.push_back(static_cast<int>(h / 32));
  write("in.mesh", mirrored);
  EXPECT_NE(run("in.mesh out.mesh --json out.json"), 3);
  const Mesh output = read("out.mesh");
  EXPECT_EQ(output.hexahedra, right.hexahedra);
  EXPECT_EQ(output.mesh_data.hexahedron_labels, mirrored.mesh_data.hexahedron_labels);
  EXPECT_TRUE(contains(text("stdout"), "1 hexahedra were numbered inside out"));
  EXPECT_EQ(json("out.json")["status"]["reoriented_hexahedra"], nlohmann::json::array({21}));
}

TEST_F(Program, says_which_vertices_coincide_and_merges_them_when_asked)
{
  const Mesh whole = tangled_block();
  Mesh mesh;
  for (const auto& h : whole.hexahedra) {
    mesh.hexahedra.emplace_back();
    for (std::size_t c = 0; c < 8; ++c) {
      mesh.hexahedra.back()[c] = mesh.points.size();
      mesh.points.push_back(whole.points[h[c]]);
    }
  }
  write("in.mesh", mesh);
  EXPECT_NE(run("in.mesh out.mesh --time-limit 0 --json out.json"), 3);
  EXPECT_TRUE(contains(text("stdout"), "387 vertices coincide with others"));
  EXPECT_TRUE(contains(text("stdout"), "--merge"));
  EXPECT_EQ(json("out.json")["status"]["number_of_coincident_vertices"], 64 * 8 - 125);

  write("fixed.txt", std::to_string(mesh.hexahedra[63][0]) + "\n"); // one of eight in one place
  EXPECT_EQ(run("in.mesh out.mesh --merge --fixed-vertices fixed.txt --json out.json"), 0);
  EXPECT_TRUE(contains(text("stdout"), "387 vertices coincide with others and were merged"));
  EXPECT_EQ(json("out.json")["number_of_merged_vertices"], 387);
  EXPECT_EQ(json("out.json")["status"]["number_of_coincident_vertices"], 0);
  const Mesh output = read("out.mesh");
  EXPECT_EQ(output.hexahedra, mesh.hexahedra);
  ASSERT_EQ(output.points.size(), mesh.points.size());
  std::vector<Point> place(whole.points.size());
  std::vector<char> is_known(whole.points.size(), false);
  for (std::size_t h = 0; h < 64; ++h)
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t v = whole.hexahedra[h][c];
      EXPECT_TRUE(!is_known[v] || output.points[mesh.hexahedra[h][c]] == place[v]);
      place[v] = output.points[mesh.hexahedra[h][c]];
      is_known[v] = true;
    }
  EXPECT_EQ(place[whole.hexahedra[63][0]], whole.points[whole.hexahedra[63][0]]) << "all of them are fixed";
  EXPECT_EQ(HMO::quality_statistics(output.points, output.hexahedra).number_of_invalid, 0u);
}

TEST_F(Program, keeps_labels_and_other_sections)
{
  Mesh input = tangled_block();
  for (std::size_t v = 0; v < input.points.size(); ++v)
    input.mesh_data.vertex_labels.push_back(static_cast<int>(v % 5));
  for (std::size_t h = 0; h < input.hexahedra.size(); ++h)
    input.mesh_data.hexahedron_labels.push_back(7); // one region: interfaces of a tangled mesh may be hopeless
  input.mesh_data.other_sections = "Corners\n2\n1\n5\nRequiredVertices\n1\n1\n";
  write("in.mesh", input);
  EXPECT_EQ(run("in.mesh out.mesh"), 0);
  const Mesh output = read("out.mesh");
  EXPECT_EQ(output.mesh_data.vertex_labels, input.mesh_data.vertex_labels);
  EXPECT_EQ(output.mesh_data.hexahedron_labels, input.mesh_data.hexahedron_labels);
  for (const char* section : {"Corners", "RequiredVertices"})
    EXPECT_TRUE(contains(output.mesh_data.other_sections, section)) << section;
}

// Data of points and cells come back from a .vtk file, and labels from any other format; what cannot is named.
TEST_F(Program, keeps_data_and_names_what_a_format_cannot_hold)
{
  Mesh input = tangled_block();
  for (std::size_t h = 0; h < input.hexahedra.size(); ++h)
    input.mesh_data.hexahedron_labels.push_back(h < 32 ? 7 : -3);
  input.mesh_data.other_sections = "Corners\n2\n1\n5\n";
  input.mesh_data.other_cells = {{9, {0, 1, 6, 5}, 8, 64}};
  write("in.mesh", input);
  run("in.mesh out.vtk --json out.json");
  EXPECT_EQ(text("stderr"), "warning: not in the output: the section Corners\n");
  EXPECT_EQ(json("out.json")["lost"], nlohmann::json::array({"the section Corners"}));
  EXPECT_TRUE(contains(text("out.vtk"), "\nCELL_DATA 65\n"));
  EXPECT_TRUE(contains(text("out.vtk"), "medit:ref"));
  run("in.mesh out.vtk --quiet");
  EXPECT_EQ(text("stderr"), "");

  std::string with_data = text("out.vtk") + "CELL_DATA 65\nSCALARS heat double\nLOOKUP_TABLE default\n";
  for (int h = 0; h < 65; ++h)
    with_data += "0." + std::to_string(h + 1) + "1\n";
  write("data.vtk", with_data);
  run("data.vtk again.vtk --json out.json");
  EXPECT_EQ(text("stderr"), "");
  EXPECT_EQ(json("out.json")["labels"]["array"], "medit:ref");
  EXPECT_TRUE(contains(text("again.vtk"), with_data.substr(with_data.find("SCALARS heat"))));

  run("data.vtk back.mesh");
  EXPECT_EQ(text("stderr"), "warning: not in the output: the array \"heat\" of the cells\n");
  EXPECT_EQ(read("back.mesh").mesh_data.hexahedron_labels, input.mesh_data.hexahedron_labels);
  ASSERT_EQ(read("back.mesh").mesh_data.other_cells.size(), 1u);
  EXPECT_EQ(read("back.mesh").mesh_data.other_cells[0].label, 8);

  EXPECT_EQ(run("data.vtk other.mesh --label-array heat"), 3);
  EXPECT_TRUE(contains(text("stderr"), "there is no array \"heat\" with one integral number for each cell"));
  EXPECT_FALSE(exists("other.mesh"));
  write(
    "chosen.vtk", text("out.vtk") + "CELL_DATA 65\nSCALARS mine float\nLOOKUP_TABLE default\n" + [] {
      std::string ones;
      for (int h = 0; h < 65; ++h)
        ones += "4\n";
      return ones;
    }());
  run("chosen.vtk chosen.mesh --label-array mine --json out.json");
  EXPECT_EQ(json("out.json")["labels"]["array"], "mine");
  EXPECT_EQ(read("chosen.mesh").mesh_data.hexahedron_labels, std::vector<std::int64_t>(64, 4));
}

// In sixteen columns of four cells: the lower half is of one material, the upper one of another. No vertex between them is
// out of place.
Mesh two_materials()
{
  Mesh mesh;
  HMO::make_block(mesh.points, mesh.hexahedra, {{4, 4, 4}});
  const std::vector<Point> intact = mesh.points;
  HMO::scramble_interior(mesh.points, mesh.hexahedra, 1);
  for (std::size_t v = 0; v < intact.size(); ++v)
    if (intact[v].z() == .5)
      mesh.points[v] = intact[v];
  for (const auto& h : mesh.hexahedra) {
    double z = 0;
    for (std::size_t v : h)
      z += intact[v].z() / 8;
    mesh.mesh_data.hexahedron_labels.push_back(z < .5 ? 30 : 20);
  }
  return mesh;
}

std::vector<std::size_t> vertices_between(const Mesh& mesh)
{
  std::vector<std::array<bool, 2>> is_in(mesh.points.size());
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    for (std::size_t v : mesh.hexahedra[h])
      is_in[v][mesh.mesh_data.hexahedron_labels[h] == 20] = true;
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < is_in.size(); ++v)
    if (is_in[v][0] && is_in[v][1])
      result.push_back(v);
  return result;
}

// A file as other programs write it, with a cell array of materials beside another one of numbers
std::string vtu(const Mesh& mesh)
{
  std::ostringstream out;
  out.precision(17);
  const std::size_t n = mesh.hexahedra.size();
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "<UnstructuredGrid><Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfCells=\"" << n << "\">\n"
      << "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Point& p : mesh.points)
    out << p << '\n';
  out << "</DataArray></Points>\n<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& h : mesh.hexahedra)
    for (std::size_t v : h)
      out << v << ' ';
  out << "\n</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t h = 1; h <= n; ++h)
    out << 8 * h << ' ';
  out << "\n</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (std::size_t h = 0; h < n; ++h)
    out << "12 ";
  out << "\n</DataArray></Cells>\n<CellData>\n<DataArray type=\"Float32\" Name=\"heat\" format=\"ascii\">\n";
  for (std::size_t h = 0; h < n; ++h)
    out << h << ".5 ";
  out << "\n</DataArray>\n<DataArray type=\"Int32\" Name=\"material\" format=\"ascii\">\n";
  for (std::int64_t label : mesh.mesh_data.hexahedron_labels)
    out << label << ' ';
  out << "\n</DataArray></CellData>\n</Piece></UnstructuredGrid>\n</VTKFile>\n";
  return out.str();
}

TEST_F(Program, keeps_the_interface_that_cell_data_of_a_vtu_file_make)
{
  const Mesh input = two_materials();
  write("in.vtu", vtu(input));
  EXPECT_EQ(run("in.vtu out.vtu --json out.json"), 0);
  EXPECT_EQ(text("stderr"), "");
  const auto status = json("out.json")["status"];
  EXPECT_EQ(json("out.json")["labels"]["array"], "material");
  ASSERT_EQ(status["interfaces"].size(), 1u);
  EXPECT_EQ(status["interfaces"][0]["labels"], nlohmann::json::array({20, 30}));
  EXPECT_EQ(status["interfaces"][0]["number_of_faces"], 16);
  EXPECT_LE(status["interfaces"][0]["maximum_deviation"], .1 * .25);
  ASSERT_EQ(status["regions"].size(), 2u);
  for (const auto& region : status["regions"])
    EXPECT_NEAR(region["volume_after"].get<double>(), .5, .005);
  EXPECT_TRUE(contains(text("stdout"), "between labels 20 and 30"));

  // all of it comes back: to a format with labels, and from there
  Mesh output;
  CGAL::IO::read_vtu_hex_mesh((folder / "out.vtu").string(), output.points, output.hexahedra, output.mesh_data);
  EXPECT_EQ(output.hexahedra, input.hexahedra);
  EXPECT_EQ(output.mesh_data.hexahedron_labels, input.mesh_data.hexahedron_labels);
  EXPECT_TRUE(contains(text("out.vtu"), "\"heat\""));
  const std::vector<std::size_t> between = vertices_between(input);
  EXPECT_EQ(between.size(), 25u);
  for (std::size_t v : between)
    EXPECT_NEAR(output.points[v].z(), .5, .1 * .25) << v;
}

TEST_F(Program, brings_an_interface_to_a_surface)
{
  const Mesh input = two_materials();
  write("in.mesh", input);
  write("tilted.off", "OFF\n4 2 0\n-1 -1 .45\n2 -1 .45\n2 2 .6\n-1 2 .6\n3 0 1 2\n3 0 2 3\n");
  EXPECT_EQ(run("in.mesh out.mesh --interface 30 20 tilted.off --json out.json"), 0);
  for (std::size_t v : vertices_between(input)) {
    const Point p = read("out.mesh").points[v];
    EXPECT_NEAR(p.z(), .5 + .05 * p.y(), .1 * .25) << v;
  }
  EXPECT_LE(json("out.json")["status"]["interfaces"][0]["maximum_deviation"], .1 * .25);
  EXPECT_EQ(json("out.json")["options"]["interfaces"][0]["labels"], nlohmann::json::array({30, 20}));

  EXPECT_EQ(run("in.mesh other.mesh --interface 30 21 tilted.off"), 3);
  EXPECT_TRUE(contains(text("stderr"), "no hexahedron has the label 21"));
  EXPECT_EQ(run("in.mesh other.mesh --interface 30 30 tilted.off"), 2);
  EXPECT_TRUE(contains(text("stderr"), "--interface 30 30: there are no faces between these labels"));
  EXPECT_EQ(run("in.mesh other.mesh --interface 30 20"), 2);
  EXPECT_FALSE(exists("other.mesh"));
}

TEST_F(Program, may_replace_its_input)
{
  write("in.mesh", tangled_block());
  EXPECT_EQ(run("in.mesh in.mesh"), 0);
  const Mesh output = read("in.mesh");
  EXPECT_EQ(HMO::quality_statistics(output.points, output.hexahedra).number_of_invalid, 0u);
}

TEST_F(Program, does_not_move_fixed_vertices)
{
  Mesh input;
  HMO::make_block(input.points, input.hexahedra, {{4, 4, 4}});
  HMO::scramble_interior(input.points, input.hexahedra, 1, .5);
  write("in.mesh", input);
  std::string odd;
  for (std::size_t v = 1; v < input.points.size(); v += 2)
    odd += std::to_string(v) + "\n\n";
  write("fixed.txt", odd);
  run("in.mesh out.mesh --fixed-vertices fixed.txt");
  const Mesh output = read("out.mesh");
  bool moved = false;
  for (std::size_t v = 0; v < input.points.size(); ++v)
    if (v % 2 == 0)
      moved = moved || output.points[v] != input.points[v];
    else
      EXPECT_EQ(output.points[v], input.points[v]) << v;
  EXPECT_TRUE(moved);
}

// Two processes, any number of threads: the same bits
TEST_F(Program, writes_the_same_file_every_time)
{
  write("in.mesh", tangled_block());
  write("reference.off", "OFF\n8 6 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
                         "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  for (const std::string reference : {"", " --reference reference.off"}) {
    ASSERT_EQ(run("in.mesh first.mesh --threads 1" + reference), 0) << text("stderr");
    for (const char* threads : {"1", "2", "7"}) {
      ASSERT_EQ(run(std::string("in.mesh again.mesh --threads ") + threads + reference), 0) << text("stderr");
      EXPECT_EQ(text("again.mesh"), text("first.mesh"));
    }
    EXPECT_NE(text("first.mesh"), text("in.mesh"));
  }
}

TEST_F(Program, writes_the_best_so_far_when_the_time_is_over)
{
  write("in.mesh", tangled_block());
  const int code = run("in.mesh out.mesh --time-limit 0 --json out.json");
  const nlohmann::json status = json("out.json")["status"];
  EXPECT_EQ(code, status["valid_mesh"] ? 0 : 1);
  EXPECT_EQ(status["return_code"], "TIME_LIMIT");
  EXPECT_EQ(read("out.mesh").hexahedra.size(), 64u);
}

TEST_F(Program, writes_the_best_so_far_when_interrupted)
{
  write("in.mesh", tangled_block());
  // It has the mesh and listens for signals when it opens the pipe.
  const int code = shell("mkfifo fixed.txt; \"$PROGRAM\" in.mesh out.mesh --fixed-vertices fixed.txt --json out.json & "
                         "kill -INT $! > fixed.txt; wait $!");
  const nlohmann::json report = json("out.json");
  EXPECT_EQ(code, report["status"]["valid_mesh"] ? 0 : 1);
  EXPECT_EQ(report["status"]["return_code"], "STOPPED_BY_VISITOR");
  EXPECT_EQ(report["iterations"].size(), 1u);
  EXPECT_TRUE(contains(text("stdout"), "interrupted"));
  EXPECT_EQ(read("out.mesh").hexahedra.size(), 64u);
}

TEST_F(Program, tells_its_version)
{
  EXPECT_EQ(run("--version"), 0);
  EXPECT_EQ(text("stdout"), CGAL_HEX_MESH_OPTIMIZATION_VERSION "\n");
}

} // namespace
