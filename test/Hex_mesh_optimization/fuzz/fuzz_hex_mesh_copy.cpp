// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target of the readers of solvers' files, --format=inp, msh, bdf, e, med or foam: whatever is in the file, it is
// refused by the documented exception, or gives a consistent mesh whose copy has the same bytes, and whose copy with points
// moved reads back with them. A case of OpenFOAM is one file here: "== name" begins each of its files.

#include "Input_file.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh_copy.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
namespace fs = std::filesystem;

std::unique_ptr<fuzz::Input_file> input_file;
bool is_case = false;

std::string bytes(const std::string& name)
{
  std::ifstream in(name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

// The folder of a case with the files that stand in one.
std::string unpacked(const std::string& file)
{
  const fs::path folder = file + ".case";
  fs::remove_all(folder);
  fs::create_directories(folder / "constant" / "polyMesh");
  const std::string text = "\n" + bytes(file);
  for (std::size_t begin = text.find("\n== "); begin != std::string::npos;) {
    const std::size_t next = text.find("\n== ", begin + 1);
    const std::size_t line = text.find('\n', begin + 1);
    if (line == std::string::npos)
      break;
    const std::string name = text.substr(begin + 4, line - begin - 4);
    for (const char* known :
         {"points", "faces", "owner", "neighbour", "boundary", "cellZones", "faceZones", "pointZones"})
      if (name == known)
        std::ofstream(folder / "constant" / "polyMesh" / name, std::ios::binary)
          << text.substr(line + 1, next == std::string::npos ? next : next - line - 1);
    begin = next;
  }
  return folder.string();
}

void check_copies(const std::string& input, const CGAL::IO::Hex_mesh_file& file)
{
  std::vector<Point> points;
  for (const auto& p : file.points)
    points.emplace_back(p[0], p[1], p[2]);
  const std::string output = is_case ? input + ".out" : input_file->name("output");
  if (is_case)
    fs::remove_all(output);
  CGAL::IO::copy_hex_mesh_file(file, output, points);
  fuzz::require(is_case || bytes(input) == bytes(output), "a copy with the same points has the same bytes");
  for (const auto& h : file.hexahedra)
    points[h[0]] = Point(points[h[0]].x(), points[h[0]].y() + .5, points[h[0]].z());
  try {
    CGAL::IO::copy_hex_mesh_file(file, output, points);
  }
  catch (const CGAL::IO::Hex_mesh_file_error&) { // a number may stand where two points have theirs
  }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  const std::string format = fuzz::format(*argc, *argv);
  is_case = format == "foam";
  input_file = std::make_unique<fuzz::Input_file>(format);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::string input = (*input_file)(data, size);
  if (is_case)
    input = unpacked(input);
  CGAL::IO::Hex_mesh_file file;
  try {
    file = CGAL::IO::read_hex_mesh_file(input);
  }
  catch (const CGAL::IO::Hex_mesh_file_error&) {
    return 0;
  }
  for (const auto& p : file.points)
    for (double x : p)
      fuzz::require(std::isfinite(x), "all coordinates are finite");
  for (const auto& h : file.hexahedra)
    for (std::size_t v : h)
      fuzz::require(v < file.points.size(), "all vertices exist");
  fuzz::require(file.labels.size() == file.hexahedra.size(), "each hexahedron has a label");
  for (const auto& set : file.sets)
    for (std::size_t v : set.vertices)
      fuzz::require(v < file.points.size(), "all vertices of sets exist");
  for (std::size_t v : file.held_points)
    fuzz::require(v < file.points.size(), "all points that are held exist");
  check_copies(input, file);
  return 0;
}
