// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Files of solvers: every construct is read, a copy with the same points has the same bytes, and a copy with one point moved
// differs in the numbers of that point alone.

#include "Io_test.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh_copy.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_output.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using CGAL::IO::Hex_mesh_file;
using CGAL::IO::read_hex_mesh_file;
using Set = CGAL::IO::Hex_mesh_set;
namespace io = CGAL::Hex_mesh_optimization::internal::IO;
namespace fs = std::filesystem;

constexpr std::size_t center = 13;

// Two hexahedra in each direction, from (0, 0, 0) to (2, 2, 2); the point in the middle is the `center`.
struct Block
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;

  Block()
  {
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          points.push_back({{double(i), double(j), double(k)}});
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t j = 0; j < 2; ++j)
        for (std::size_t i = 0; i < 2; ++i) {
          const std::size_t v = i + 3 * j + 9 * k;
          hexahedra.push_back({{v, v + 1, v + 4, v + 3, v + 9, v + 10, v + 13, v + 12}});
        }
  }
};

const Block block;

// Numbers separated by `separator`, counted from `first`
std::string corners(std::size_t h, const char* separator, std::size_t first = 1)
{
  std::string text;
  for (std::size_t v : block.hexahedra[h])
    text += (text.empty() ? "" : separator) + std::to_string(v + first);
  return text;
}

std::string coordinates(std::size_t v, const char* separator)
{
  std::ostringstream text;
  text << block.points[v][0] << ".0" << separator << block.points[v][1] << ".0" << separator << block.points[v][2]
       << ".0";
  return text.str();
}

class Hex_mesh_copy : public Io_test
{
protected:
  std::string write(const std::string& name, const std::string& text)
  {
    fs::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name).string();
  }

  fs::path path(const std::string& name) const { return folder_ / name; }

  static std::string bytes(const fs::path& file)
  {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  static std::vector<std::string> lines(const std::string& text)
  {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      result.push_back(line);
    return result;
  }

  static Points points_of(const Hex_mesh_file& file)
  {
    Points result;
    for (const auto& p : file.points)
      result.emplace_back(p[0], p[1], p[2]);
    return result;
  }

  // The file has the block; a copy of it is equal; another one has the center elsewhere.
  void check(const std::string& input, const std::string& output, std::size_t changed_lines)
  {
    const Hex_mesh_file file = read_hex_mesh_file(input);
    ASSERT_EQ(file.hexahedra.size(), 8u) << input;
    Points points = points_of(file);
    CGAL::IO::copy_hex_mesh_file(file, output, points);
    if (fs::is_regular_file(input)) {
      EXPECT_EQ(bytes(input), bytes(output)) << input;
    }
    points[center] = Simple::Point_3(1. + 1. / 3, 1, 1 - 1e-3);
    const auto back = CGAL::IO::copy_hex_mesh_file(file, output, points);
    EXPECT_NEAR(back[center][0], 4. / 3, 1e-6) << input;
    EXPECT_EQ(back[center][1], 1) << input;
    EXPECT_NEAR(back[center][2], 1 - 1e-3, 1e-6) << input;
    for (std::size_t v = 0; v < back.size(); ++v)
      if (v != center) {
        EXPECT_EQ(back[v], file.points[v]) << input;
      }
    if (changed_lines == 0)
      return;
    const std::vector<std::string> before = lines(bytes(input)), after = lines(bytes(output));
    ASSERT_EQ(before.size(), after.size());
    std::size_t changed = 0;
    for (std::size_t l = 0; l < before.size(); ++l)
      changed += before[l] != after[l];
    EXPECT_EQ(changed, changed_lines) << input;
  }

  static void expect_error(const std::string& file, std::size_t line, const std::string& part)
  {
    try {
      read_hex_mesh_file(file);
      FAIL() << file << " is accepted";
    }
    catch (const CGAL::IO::Hex_mesh_file_error& error) {
      EXPECT_EQ(error.line(), line) << error.what();
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }

  fs::path folder_ = Io_test::folder_;
};

std::string abaqus_nodes(std::size_t first, std::size_t last)
{
  std::string text;
  for (std::size_t v = first; v < last; ++v)
    text += std::to_string(v + 1) + ",  " + coordinates(v, ", ") + "\n";
  return text;
}

std::string abaqus_mesh()
{
  std::string text = "*Heading\n ** this is a title\n** a comment\n*NODE , NSET = Nall,\n SYSTEM=R\n" +
                     abaqus_nodes(0, 13) + "*node\n" + abaqus_nodes(13, 27) + "*NODE PRINT, NSET=NALL\nU\n";
  for (std::size_t h = 0; h < 8; ++h) // continued lines
    text += "*ELEMENT, TYPE=C3D8R   ,\n ELSET=E" + std::to_string(h / 4) + "\n" + std::to_string(h + 1) + ", " +
            corners(h, ", ").insert(corners(h, ", ").find(',') + 1, "\n") + "\n";
  return text;
}

TEST_F(Hex_mesh_copy, abaqus)
{
  const std::string text = abaqus_mesh() +
                           "*ELEMENT, TYPE=S4, ELSET=SKIN\n101, 1, 2, 5, 4\n"
                           "*NSET, NSET=FIX, GENERATE\n1, 9, 1\n*NSET, NSET=ALSO\nFIX, 27\n"
                           "*SURFACE, NAME=TOP\nE1, S2\n"
                           "*SOLID SECTION, ELSET=E0, MATERIAL=Steel\n*SOLID SECTION, ELSET=E1, MATERIAL=Rubber\n"
                           "*MATERIAL, NAME=Steel\n*ELASTIC\n2.1e11, .3\n*STEP\n*NODE FILE\nU\n*END STEP\n";
  const std::string input = write("a.inp", text);
  check(input, path("b.inp").string(), 1);
  const Hex_mesh_file file = read_hex_mesh_file(input);
  EXPECT_EQ(file.find_set("fix")->vertices.size(), 9u);
  EXPECT_EQ(file.find_set("ALSO")->vertices.size(), 10u);
  EXPECT_EQ(file.find_set("TOP")->faces.size(), 4u);
  for (const auto& face : file.find_set("TOP")->faces)
    for (std::size_t v : face)
      EXPECT_EQ(file.points[v][2], 2);
  EXPECT_EQ(file.find_set("SKIN")->faces.size(), 1u);
  EXPECT_EQ(file.label_names.at(file.labels[0]), "Steel");
  EXPECT_EQ(file.label_names.at(file.labels[7]), "Rubber");
  EXPECT_TRUE(file.held_points.empty());
}

TEST_F(Hex_mesh_copy, abaqus_with_windows_lines)
{
  std::string text;
  for (char c : abaqus_mesh())
    text += c == '\n' ? "\r\n" : std::string(1, c);
  check(write("a.inp", text), path("b.inp").string(), 1);
}

// CalculiX reads no more of a number
TEST_F(Hex_mesh_copy, numbers_of_abaqus_have_at_most_twenty_characters)
{
  const std::string input = write("a.inp", abaqus_mesh());
  const Hex_mesh_file file = read_hex_mesh_file(input);
  Points points = points_of(file);
  points[center] = Simple::Point_3(-1.2345678901234567e-5, 1 + 1. / 3, -1e-300 / 3);
  const auto back = CGAL::IO::copy_hex_mesh_file(file, path("b.inp").string(), points);
  EXPECT_NEAR(back[center][0], points[center].x(), 1e-18);
  EXPECT_NEAR(back[center][1], points[center].y(), 1e-15);
  for (const std::string& line : lines(bytes(path("b.inp")))) {
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');)
      EXPECT_LE(field.size(), 24u) << line; // with blanks
  }
}

TEST_F(Hex_mesh_copy, parts_and_instances_of_abaqus_have_numbers_of_their_own)
{
  std::string mesh = "*Node\n" + abaqus_nodes(0, 27) + "*Element, type=C3D8\n";
  for (std::size_t h = 0; h < 8; ++h)
    mesh += std::to_string(h + 1) + ", " + corners(h, ", ") + "\n";
  const std::string input = write("a.inp", "*Part, name=One\n" + mesh +
                                             "*End Part\n*Assembly, name=A\n"
                                             "*Instance, name=One-1, part=One\n 10., 0., 0.\n*End Instance\n"
                                             "*Instance, name=Two\n" +
                                             mesh +
                                             "*End Instance\n*Node\n 1, 5., 5., 5.\n"
                                             "*Nset, nset=S, instance=Two\n 14\n*End Assembly\n");
  const Hex_mesh_file file = read_hex_mesh_file(input);
  EXPECT_EQ(file.points.size(), 55u);
  EXPECT_EQ(file.hexahedra.size(), 16u);
  EXPECT_EQ(file.find_set("S")->vertices, std::vector<std::size_t>(1, 27 + center));
}

TEST_F(Hex_mesh_copy, included_files_are_written_beside_the_output)
{
  const std::string mesh = abaqus_mesh();
  const std::size_t cut = mesh.find("*node\n") + 6;
  write("in/sub/nodes.txt", abaqus_nodes(13, 27));
  write("in/fix.nam", "*NSET, NSET=FIX\n1, 2\n");
  const std::string input = write("in/a.inp", mesh.substr(0, cut) + "*INCLUDE, INPUT=sub/nodes.txt\n" +
                                                mesh.substr(cut + abaqus_nodes(13, 27).size()) +
                                                "*INCLUDE, INPUT=fix.nam\n*INCLUDE, INPUT=none\n");
  const Hex_mesh_file file = read_hex_mesh_file(input);
  ASSERT_EQ(file.hexahedra.size(), 8u);
  EXPECT_EQ(file.notes.size(), 1u); // of the file that is not there
  Points points = points_of(file);
  points[center] = Simple::Point_3(1.5, 1, 1);
  fs::create_directories(path("out"));
  CGAL::IO::copy_hex_mesh_file(file, path("out/b.inp").string(), points);
  EXPECT_EQ(bytes(input), bytes(path("out/b.inp")));
  EXPECT_EQ(bytes(path("in/fix.nam")), bytes(path("out/fix.nam")));
  EXPECT_NE(bytes(path("in/sub/nodes.txt")), bytes(path("out/sub/nodes.txt")));
  // it would overwrite what the input includes
  EXPECT_THROW(CGAL::IO::copy_hex_mesh_file(file, path("in/c.inp").string(), points), CGAL::IO::Hex_mesh_file_error);
  EXPECT_FALSE(fs::exists(path("in/c.inp")));
  CGAL::IO::copy_hex_mesh_file(file, input, points); // this was asked for
  EXPECT_EQ(read_hex_mesh_file(input).points[center][0], 1.5);
}

TEST_F(Hex_mesh_copy, nodes_of_second_order_go_along)
{
  // Twenty nodes, bent outwards at one
  const int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                            {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  std::string nodes = "*NODE\n" + abaqus_nodes(0, 27), elements = "*ELEMENT, TYPE=C3D20\n";
  std::map<std::pair<std::size_t, std::size_t>, int> number;
  for (std::size_t h = 0; h < 8; ++h) {
    elements += std::to_string(h + 1) + ", " + corners(h, ", ") + ",\n";
    for (int e = 0; e < 12; ++e) {
      const auto [a, b] = std::minmax(block.hexahedra[h][edges[e][0]], block.hexahedra[h][edges[e][1]]);
      int& n = number[{a, b}];
      if (n == 0) {
        n = 27 + static_cast<int>(number.size());
        nodes += std::to_string(n);
        for (int i = 0; i < 3; ++i)
          nodes += ", " + std::to_string((block.points[a][i] + block.points[b][i]) / 2);
        nodes += '\n';
      }
      elements += std::to_string(n) + (e == 11 ? "\n" : ", ");
    }
  }
  const std::string input = write("a.inp", nodes + elements);
  const Hex_mesh_file file = read_hex_mesh_file(input);
  EXPECT_EQ(file.followers.size(), number.size());
  Points points = points_of(file);
  points[center] = Simple::Point_3(1.25, 1, 1);
  const auto back = CGAL::IO::copy_hex_mesh_file(file, path("b.inp").string(), points);
  for (const auto& [ends, n] : number)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(back[n - 1][i], (back[ends.first][i] + back[ends.second][i]) / 2, 1e-12);
}

TEST_F(Hex_mesh_copy, vertices_of_other_solids_are_held)
{
  const std::string input = write("a.inp", abaqus_mesh() + "*NODE\n28, 3.0, 0.5, 0.5\n*ELEMENT, TYPE=C3D5\n"
                                                           "50, 3, 6, 15, 12, 28\n*ELEMENT, TYPE=B31\n51, 1, 28\n");
  const Hex_mesh_file file = read_hex_mesh_file(input);
  EXPECT_EQ(file.number_of_other_solids, 1u);
  EXPECT_EQ(file.held_points, (std::vector<std::size_t>{2, 5, 11, 14}));
}

TEST_F(Hex_mesh_copy, bad_abaqus_is_named_by_its_line)
{
  expect_error(write("a.inp", "*NODE\n1, 0., x, 0.\n"), 2, "node 1");
  expect_error(write("b.inp", "*NODE\n1, 0., 0., 0.\n*ELEMENT, TYPE=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"), 4, "node 2");
  expect_error(write("c.inp", "*NODE\n1, 0., 0., 0.\n*NGEN\n1, 2\n"), 3, "*ngen");
  expect_error(path("none.inp").string(), 0, "cannot open");
}

TEST_F(Hex_mesh_copy, avs_ucd)
{
  std::string text = "# comment\n27 8 0 0 0\n";
  for (std::size_t v = 0; v < 27; ++v)
    text += std::to_string(v + 1) + " " + coordinates(v, "  ") + "\n";
  for (std::size_t h = 0; h < 8; ++h)
    text += std::to_string(h + 1) + " 3 hex " + corners(h, " ") + "\n";
  check(write("a.inp", text), path("b.inp").string(), 1);
}

std::string gmsh_physical_names()
{
  return "$PhysicalNames\n2\n2 7 \"the bottom\"\n3 9 \"solid\"\n$EndPhysicalNames\n";
}

std::string gmsh_2(bool is_binary)
{
  std::ostringstream out;
  const auto integer = [&out](std::int32_t n) { out.write(reinterpret_cast<const char*>(&n), 4); };
  out << "$MeshFormat\n2.2 " << is_binary << " 8\n";
  if (is_binary) {
    integer(1);
    out << '\n';
  }
  out << "$EndMeshFormat\n" << gmsh_physical_names() << "$Nodes\n27\n";
  for (std::size_t v = 0; v < 27; ++v)
    if (is_binary) {
      integer(static_cast<int>(v) + 1);
      out.write(reinterpret_cast<const char*>(block.points[v].data()), 24);
    }
    else
      out << v + 1 << ' ' << coordinates(v, " ") << '\n';
  out << (is_binary ? "\n" : "") << "$EndNodes\n$Elements\n9\n";
  if (is_binary) {
    for (int n : {3, 1, 2, 1, 7, 1, 1, 2, 5, 4, 5, 8, 2})
      integer(n);
    for (std::size_t h = 0; h < 8; ++h) {
      for (int n : {static_cast<int>(h) + 2, 9, 1})
        integer(n);
      for (std::size_t v : block.hexahedra[h])
        integer(static_cast<int>(v) + 1);
    }
    out << '\n';
  }
  else {
    out << "1 3 2 7 1 1 2 5 4\n";
    for (std::size_t h = 0; h < 8; ++h)
      out << h + 2 << " 5 2 9 1 " << corners(h, " ") << '\n';
  }
  out << "$EndElements\n$Periodic\n1\n2 1 2\n1\n3 1\n$EndPeriodic\n$Comments\nkept\n$EndComments\n";
  return out.str();
}

TEST_F(Hex_mesh_copy, gmsh_2)
{
  for (bool is_binary : {false, true}) {
    const std::string input = write("a.msh", gmsh_2(is_binary));
    check(input, path("b.msh").string(), is_binary ? 0 : 1);
    const Hex_mesh_file file = read_hex_mesh_file(input);
    EXPECT_EQ(file.find_set("the bottom")->faces.size(), 1u);
    EXPECT_EQ(file.label_names.at(9), "solid");
    ASSERT_EQ(file.periodic_pairs.size(), 1u);
    EXPECT_EQ(file.periodic_pairs[0].translation, (std::array<double, 3>{{2, 0, 0}}));
  }
}

TEST_F(Hex_mesh_copy, gmsh_1)
{
  std::string text = "$NOD\n27\n";
  for (std::size_t v = 0; v < 27; ++v)
    text += std::to_string(v + 1) + " " + coordinates(v, " ") + "\n";
  text += "$ENDNOD\n$ELM\n8\n";
  for (std::size_t h = 0; h < 8; ++h)
    text += std::to_string(h + 1) + " 5 9 1 8 " + corners(h, " ") + "\n";
  check(write("a.msh", text + "$ENDELM\n"), path("b.msh").string(), 1);
}

// As text, with parametric coordinates in one block
std::string gmsh_4(bool is_4_1)
{
  std::string text = std::string("$MeshFormat\n") + (is_4_1 ? "4.1" : "4") + " 0 8\n$EndMeshFormat\n" +
                     gmsh_physical_names() + "$Entities\n1 0 0 1\n" + (is_4_1 ? "1 0 0 0 0\n" : "1 0 0 0 0 0 0 0\n") +
                     "1 0 0 0 2 2 2 1 9 0\n$EndEntities\n$Nodes\n" +
                     (is_4_1 ? "2 27 1 27\n2 1 1 13\n" : "2 27\n1 2 1 13\n");
  const auto nodes = [&](std::size_t first, std::size_t last, const char* more) {
    for (std::size_t v = first; v < last && is_4_1; ++v)
      text += std::to_string(v + 1) + "\n";
    for (std::size_t v = first; v < last; ++v)
      text += (is_4_1 ? "" : std::to_string(v + 1) + " ") + coordinates(v, " ") + more + "\n";
  };
  nodes(0, 13, " .5 .5");
  text += is_4_1 ? "3 1 0 14\n" : "1 3 0 14\n";
  nodes(13, 27, "");
  text += std::string("$EndNodes\n$Elements\n") + (is_4_1 ? "1 8 1 8\n3 1 5 8\n" : "1 8\n1 3 5 8\n");
  for (std::size_t h = 0; h < 8; ++h)
    text += std::to_string(h + 1) + " " + corners(h, " ") + "\n";
  return text + "$EndElements\n";
}

TEST_F(Hex_mesh_copy, gmsh_4)
{
  for (bool is_4_1 : {false, true}) {
    const std::string input = write("a.msh", gmsh_4(is_4_1));
    check(input, path("b.msh").string(), 1);
    EXPECT_EQ(read_hex_mesh_file(input).labels, std::vector<std::int64_t>(8, 9));
  }
}

TEST_F(Hex_mesh_copy, bad_gmsh_is_named_by_its_line)
{
  expect_error(write("a.msh", "$MeshFormat\n3.1 0 8\n$EndMeshFormat\n"), 1, "version 3.1");
  expect_error(write("b.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 z\n$EndNodes\n"), 6, "\"z\"");
  expect_error(write("c.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n"
                              "1 5 2 1 1 1 2 3 4 5 6 7 8\n"),
               10, "node 2");
  std::string text = gmsh_2(true);
  for (std::size_t size : {text.size() - 200, text.size() / 2})
    expect_error(write("d.msh", text.substr(0, size)), 0, "ends");
}

// Short, long and free fields in one file; fields that touch, blank ones, a tab
TEST_F(Hex_mesh_copy, nastran)
{
  std::string text = "SOL 101\nCEND\nBEGIN BULK\n$ a comment\n";
  char line[200];
  for (std::size_t v = 0; v < 27; ++v) {
    const auto& p = block.points[v];
    const int n = static_cast<int>(v) + 1;
    if (v % 4 == 0)
      std::snprintf(line, sizeof(line), "GRID,%d,,%.1f,%.1f,%.1f\n", n, p[0], p[1], p[2]);
    else if (v % 4 == 1 && v != center)
      std::snprintf(line, sizeof(line), "GRID*   %-16d%-16s%16.9f%16.9f\n*       %16.9f\n", n, "", p[0], p[1], p[2]);
    else if (v % 4 == 2)
      std::snprintf(line, sizeof(line), "GRID    %8d\t%8.5f%8.4f%8.5f\n", n, p[0], p[1], p[2]);
    else
      std::snprintf(line, sizeof(line), "GRID    %-8d%8s%8.6f%8.5f%8.6f\n", n, "", p[0], p[1], p[2]);
    text += line;
  }
  for (std::size_t h = 0; h < 8; ++h) {
    const auto& c = block.hexahedra[h];
    std::snprintf(line, sizeof(line), "CHEXA   %8d%8d%8zu%8zu%8zu%8zu%8zu%8zu+\n+       %8zu%8zu\n", int(h) + 1,
                  h < 4 ? 1 : 2, c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1, c[4] + 1, c[5] + 1, c[6] + 1, c[7] + 1);
    text += line;
  }
  text += "SPC1    5       123     1       THRU    9\nENDDATA\nwhat follows does not matter\nGRID    1\n";
  const std::string input = write("a.bdf", text);
  check(input, path("b.bdf").string(), 1);
  const Hex_mesh_file file = read_hex_mesh_file(input);
  EXPECT_EQ(file.find_set("SPC 5")->vertices.size(), 9u);
  EXPECT_EQ(file.labels, (std::vector<std::int64_t>{1, 1, 1, 1, 2, 2, 2, 2}));
  EXPECT_EQ(file.points[1], block.points[1]);
  EXPECT_EQ(file.points[26], block.points[26]);
}

TEST_F(Hex_mesh_copy, coordinate_systems_of_nastran)
{
  std::string text = "CORD2C  9               0.      0.      0.      0.      0.      1.\n"
                     "        1.      0.      0.\n";
  char line[200];
  for (std::size_t v = 0; v < 27; ++v) { // points of the side x = 0 in cylindrical coordinates
    const auto& p = block.points[v];
    if (p[0] == 0)
      std::snprintf(line, sizeof(line), "GRID,%zu,9,%.1f,90.,%.1f\n", v + 1, p[1], p[2]);
    else
      std::snprintf(line, sizeof(line), "GRID,%zu,,%.1f,%.1f,%.1f\n", v + 1, p[0], p[1], p[2]);
    text += line;
  }
  for (std::size_t h = 0; h < 8; ++h) {
    std::string c = corners(h, ",");
    std::size_t comma = 0;
    for (int i = 0; i < 6; ++i)
      comma = c.find(',', comma + 1);
    text += "CHEXA," + std::to_string(h + 1) + ",1," + c.substr(0, comma) + "\n," + c.substr(comma + 1) + "\n";
  }
  const std::string input = write("a.bdf", text);
  const Hex_mesh_file file = read_hex_mesh_file(input);
  ASSERT_EQ(file.hexahedra.size(), 8u);
  for (std::size_t v = 0; v < 27; ++v)
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(file.points[v][i], block.points[v][i], 1e-12);
  check(input, path("b.bdf").string(), 1);
  Points points = points_of(file);
  points[3] = Simple::Point_3(-.5, 1, .25);
  const auto back = CGAL::IO::copy_hex_mesh_file(file, path("b.bdf").string(), points);
  EXPECT_NEAR(back[3][0], -.5, 1e-5);
  EXPECT_NEAR(back[3][1], 1, 1e-5);
}

TEST_F(Hex_mesh_copy, bad_nastran_is_named_by_its_line)
{
  expect_error(write("a.bdf", "GRID,1,,0.,y,0.\n"), 1, "\"y\"");
  expect_error(write("b.bdf", "GRID,1,,0.,0.,0.\nCHEXA,1,1,1,2,3,4,5,6\n,7,8\n"), 2, "grid point 2");
}

TEST(Number_in_width, is_as_near_as_the_width_allows)
{
  for (double value : {1., -1., 1. / 3, -1. / 3, 123456.789, -123456.789, 1.23456789e-9, -9.87654321e12, 99999.96,
                       -.00012345678, 9.9999999999})
    for (std::size_t width : {8, 16, 20})
      for (io::Number_style style : {io::Number_style::GENERAL, io::Number_style::NASTRAN}) {
        const std::string text = io::number_in_width(value, width, style);
        double back = 0;
        EXPECT_LE(text.size(), width);
        EXPECT_TRUE(io::parse_solver_number(text, back)) << text;
        EXPECT_NEAR(back, value, std::abs(value) * (width == 8 ? 6e-3 : 1e-9)) << text;
        if (style == io::Number_style::NASTRAN) {
          EXPECT_NE(text.find('.'), std::string::npos) << text;
        }
      }
}

std::string foam_header(const std::string& type, const char* object, const char* format = "ascii")
{
  return "FoamFile\n{\n    version 2.0;\n    format " + std::string(format) +
         ";\n    arch \"LSB;label=32;scalar=64\";\n    class " + type + ";\n    object " + object +
         ";\n}\n// * * * //\n\n";
}

// The faces of the block, as OpenFOAM wants them
struct Foam_faces
{
  std::vector<std::array<std::size_t, 4>> faces;
  std::vector<int> owner, neighbor;

  Foam_faces()
  {
    std::map<std::array<std::size_t, 4>, std::vector<int>> cells;
    std::map<std::array<std::size_t, 4>, std::array<std::size_t, 4>> seen;
    for (std::size_t h = 0; h < 8; ++h)
      for (const auto& side : io::hexahedron_faces) {
        std::array<std::size_t, 4> face{};
        for (int i = 0; i < 4; ++i)
          face[3 - i] = block.hexahedra[h][side[i]];
        std::array<std::size_t, 4> sorted = face;
        std::sort(sorted.begin(), sorted.end());
        cells[sorted].push_back(static_cast<int>(h));
        seen.emplace(sorted, face);
      }
    for (std::size_t sides : {2, 1})
      for (const auto& [sorted, of_face] : cells)
        if (of_face.size() == sides) {
          faces.push_back(seen[sorted]);
          owner.push_back(of_face[0]);
          if (sides == 2)
            neighbor.push_back(of_face[1]);
        }
  }
};

TEST_F(Hex_mesh_copy, openfoam)
{
  const Foam_faces f;
  const auto binary = [](const auto& values) {
    std::string text;
    for (auto value : values) {
      const std::int32_t n = static_cast<std::int32_t>(value);
      text.append(reinterpret_cast<const char*>(&n), 4);
    }
    return std::to_string(values.size()) + "\n(" + text + ")\n";
  };
  for (bool is_binary : {false, true}) {
    const std::string folder = is_binary ? "binary/" : "text/", mesh = folder + "constant/polyMesh/";
    const char* format = is_binary ? "binary" : "ascii";
    std::string points = foam_header("vectorField", "points", format) + "27\n(", faces, owner, neighbor;
    for (const auto& p : block.points) {
      std::ostringstream text;
      text << "\n( " << p[0] << " " << p[1] << "  " << p[2] << ")";
      points += is_binary ? std::string(reinterpret_cast<const char*>(p.data()), 24) : text.str();
    }
    std::vector<std::size_t> offsets(1, 0), corners_of;
    for (const auto& face : f.faces) {
      faces += "4(";
      for (std::size_t v : face) {
        faces += std::to_string(v) + " ";
        corners_of.push_back(v);
      }
      faces += ") // a face\n";
      offsets.push_back(corners_of.size());
    }
    for (int c : f.owner)
      owner += std::to_string(c) + "\n";
    for (int c : f.neighbor)
      neighbor += std::to_string(c) + "\n";
    write(mesh + "points", points + ")\n\n// the end\n");
    write(mesh + "faces",
          is_binary ? foam_header("faceCompactList", "faces", format) + binary(offsets) + binary(corners_of)
                    : foam_header("faceList", "faces") + std::to_string(f.faces.size()) + "\n(\n" + faces + ")\n");
    write(mesh + "owner", foam_header("labelList", "owner", format) +
                            (is_binary ? binary(f.owner) : std::to_string(f.owner.size()) + "(" + owner + ")\n"));
    write(mesh + "neighbour",
          foam_header("labelList", "neighbour", format) +
            (is_binary ? binary(f.neighbor) : std::to_string(f.neighbor.size()) + "(" + neighbor + ")\n"));
    write(mesh + "boundary",
          foam_header("polyBoundaryMesh", "boundary") +
            "1\n(\n  walls\n  {\n    type wall;\n    inGroups 1(wall);\n    nFaces 24;\n    startFace 12;\n  }\n)\n");
    write(mesh + "cellZones", foam_header("regIOobject", "cellZones", format) +
                                "1\n(\nhalf\n{\n type cellZone;\ncellLabels List<label> " +
                                (is_binary ? binary(std::vector<int>{0, 1, 2, 3}) : "\n4(0 1 2 3)") + ";\n}\n)\n");
    write(folder + "system/controlDict", "// as it is\n");
    check(path(folder).string(), path(folder + "../out" + format).string(), 0);
    const Hex_mesh_file file = read_hex_mesh_file(path(folder).string());
    EXPECT_EQ(file.find_set("walls")->faces.size(), 24u);
    EXPECT_EQ(std::count(file.labels.begin(), file.labels.end(), 1), 4);
    EXPECT_EQ(bytes(path(folder + "system/controlDict")),
              bytes(path(std::string("out") + format + "/system/controlDict")));
    EXPECT_EQ(bytes(path(mesh + "faces")), bytes(path(std::string("out") + format + "/constant/polyMesh/faces")));
#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_ZLIB
    for (const char* name : {"points", "faces", "owner", "neighbour"}) {
      const std::string content = bytes(path(mesh + name));
      fs::remove(path(mesh + name));
      write(mesh + name + ".gz", io::gzip(name, content));
    }
    check(path(folder).string(), path(std::string("gzip") + format).string(), 0);
#endif
  }
  write("bad/constant/polyMesh/points", foam_header("vectorField", "points") + "1((0 0 zero))");
  write("bad/constant/polyMesh/faces", "");
  write("bad/constant/polyMesh/owner", "");
  expect_error(path("bad").string(), 11, "point 0");
}

// What is written for solvers is read with the same points, hexahedra, labels and faces.
TEST_F(Hex_mesh_copy, what_is_written_for_solvers_comes_back)
{
  std::vector<std::int64_t> labels = {4, 4, 4, 4, 7, 7, 7, 7};
  std::vector<Mesh_data::Labelled_quadrilateral> faces;
  for (std::size_t h = 0; h < 4; ++h)
    faces.push_back(
      {{{block.hexahedra[h][0], block.hexahedra[h][1], block.hexahedra[h][2], block.hexahedra[h][3]}}, 3});
  const io::Solver_output output(block.points, block.hexahedra, labels, faces);
  std::vector<std::string> names;
  io::write_abaqus(path("a.inp").string(), output);
  io::write_gmsh(path("a.msh").string(), output);
  names = {"a.inp", "a.msh"};
#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF
  io::write_exodus(path("a.e").string(), output);
  names.push_back("a.e");
#endif
  for (const std::string& name : names) {
    const Hex_mesh_file file = read_hex_mesh_file(path(name).string());
    EXPECT_EQ(file.points, block.points);
    EXPECT_EQ(file.hexahedra, block.hexahedra);
    const Set* set = file.find_set("surface_3");
    ASSERT_NE(set, nullptr) << name;
    EXPECT_EQ(set->faces.size(), 4u);
    for (std::size_t v : set->vertices)
      EXPECT_EQ(file.points[v][2], 0);
    EXPECT_EQ(file.find_set("block_4")->size, 4u) << name;
    check(path(name).string(), path("copy" + name.substr(1)).string(), 0);
  }
}

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_NETCDF

TEST_F(Hex_mesh_copy, exodus_in_all_its_forms)
{
  for (int form : {NC_CLASSIC_MODEL, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4})
    for (bool are_together : {false, true})
      for (nc_type type : {NC_DOUBLE, NC_FLOAT}) {
        const std::string input = path("a.exo").string();
        int id, nodes, dimensions, elements, corners_of, blocks, strings, coordinates[3], connectivity, named;
        ASSERT_EQ(nc_create(input.c_str(), NC_CLOBBER | form, &id), NC_NOERR);
        nc_def_dim(id, "num_nodes", 27, &nodes);
        nc_def_dim(id, "num_dim", 3, &dimensions);
        nc_def_dim(id, "num_el_in_blk1", 8, &elements);
        nc_def_dim(id, "num_nod_per_el1", 8, &corners_of);
        nc_def_dim(id, "num_el_blk", 1, &blocks);
        nc_def_dim(id, "len_string", 33, &strings);
        const int both[2] = {dimensions, nodes}, of_elements[2] = {elements, corners_of},
                  of_names[2] = {blocks, strings};
        if (are_together)
          nc_def_var(id, "coord", type, 2, both, coordinates);
        else
          for (int i = 0; i < 3; ++i)
            nc_def_var(id, (std::string("coord") + "xyz"[i]).c_str(), type, 1, &nodes, coordinates + i);
        nc_def_var(id, "connect1", NC_INT, 2, of_elements, &connectivity);
        nc_put_att_text(id, connectivity, "elem_type", 3, "HEX");
        nc_def_var(id, "eb_names", NC_CHAR, 2, of_names, &named);
        nc_enddef(id);
        std::vector<int> all;
        for (const auto& h : block.hexahedra)
          for (std::size_t v : h)
            all.push_back(static_cast<int>(v) + 1);
        nc_put_var_int(id, connectivity, all.data());
        std::string name = "steel";
        name.resize(33, '\0');
        nc_put_var_text(id, named, name.data());
        for (std::size_t i = 0; i < 3; ++i) {
          std::vector<double> values;
          for (const auto& p : block.points)
            values.push_back(p[i]);
          const std::size_t first[2] = {are_together ? i : 0, 0}, count[2] = {are_together ? std::size_t(1) : 27, 27};
          nc_put_vara_double(id, coordinates[are_together ? 0 : i], first, count, values.data());
        }
        ASSERT_EQ(nc_close(id), NC_NOERR);
        check(input, path("b.exo").string(), 0);
        const Hex_mesh_file file = read_hex_mesh_file(input);
        EXPECT_EQ(file.label_names.at(1), "steel");
        // a name of a variable in the error
        ASSERT_EQ(nc_open(input.c_str(), NC_WRITE, &id), NC_NOERR);
        all[10] = 28;
        nc_put_var_int(id, connectivity, all.data());
        nc_close(id);
        expect_error(input, 0, "connect1");
      }
  expect_error(write("c.exo", "no netCDF"), 0, "cannot open");
}

#endif

#ifdef CGAL_HEX_MESH_OPTIMIZATION_USE_HDF5

TEST_F(Hex_mesh_copy, med)
{
  const std::string input = path("a.med").string();
  const hid_t file = H5Fcreate(input.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const auto group = [&](const std::string& name) {
    H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  };
  const auto array = [&](const std::string& name, hid_t type, hid_t memory, hsize_t size, const void* data) {
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t set = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
    H5Dclose(set);
    H5Sclose(space);
  };
  const auto attribute = [&](const std::string& object, const char* name, int value) {
    const hid_t of = H5Oopen(file, object.c_str(), H5P_DEFAULT), space = H5Screate(H5S_SCALAR);
    const hid_t a = H5Acreate2(of, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(a, H5T_NATIVE_INT, &value);
    H5Aclose(a);
    H5Sclose(space);
    H5Oclose(of);
  };
  const std::string step = "/ENS_MAA/Mesh/-1-1";
  for (const std::string& name :
       {std::string("/ENS_MAA"), std::string("/ENS_MAA/Mesh"), step, step + "/NOE", step + "/MAI", step + "/MAI/HE8",
        std::string("/FAS"), std::string("/FAS/Mesh"), std::string("/FAS/Mesh/NOEUD"), std::string("/FAS/Mesh/NOEUD/F"),
        std::string("/FAS/Mesh/NOEUD/F/GRO")})
    group(name);
  std::vector<double> coordinates;
  for (int i = 0; i < 3; ++i)
    for (const auto& p : block.points)
      coordinates.push_back(p[i]);
  array(step + "/NOE/COO", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, coordinates.size(), coordinates.data());
  attribute(step + "/NOE/COO", "NBR", 27);
  std::vector<int> nodes; // all first corners, then all second ones; mirrored
  for (int c : {0, 3, 2, 1, 4, 7, 6, 5})
    for (const auto& h : block.hexahedra)
      nodes.push_back(static_cast<int>(h[c]) + 1);
  array(step + "/MAI/HE8/NOD", H5T_STD_I32LE, H5T_NATIVE_INT, nodes.size(), nodes.data());
  std::vector<int> families(27, 0);
  families[0] = families[1] = 5;
  array(step + "/NOE/FAM", H5T_STD_I32LE, H5T_NATIVE_INT, 27, families.data());
  attribute("/FAS/Mesh/NOEUD/F", "NUM", 5);
  std::vector<signed char> name(80, 0);
  std::memcpy(name.data(), "fixed", 5);
  const hsize_t length = 80;
  const hid_t type = H5Tarray_create2(H5T_NATIVE_SCHAR, 1, &length);
  array("/FAS/Mesh/NOEUD/F/GRO/NOM", type, type, 1, name.data());
  H5Tclose(type);
  H5Fclose(file);
  check(input, path("b.med").string(), 0);
  EXPECT_EQ(read_hex_mesh_file(input).find_set("fixed")->vertices, (std::vector<std::size_t>{0, 1}));
  expect_error(write("c.med", "no HDF5"), 0, "HDF5");
}

#endif

} // namespace
