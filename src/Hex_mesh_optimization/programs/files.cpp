// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#include "files.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/hex_mesh_copy.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Places_of_points.h>
#include <CGAL/Hex_mesh_optimization/IO/surface.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

void read(const std::string& filename, Points& points, Hexahedra& hexahedra)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra);
}

void read(const std::string& filename, Points& points, Hexahedra& hexahedra, CGAL::IO::Hex_mesh_data& mesh_data)
{
  CGAL::IO::read_hex_mesh(filename, points, hexahedra, mesh_data);
}

void read(const std::string& filename, Surface& surface) { CGAL::IO::read_surface(filename, surface); }

namespace io = CGAL::Hex_mesh_optimization::internal::IO;

std::vector<int> closed_parts(const Soup& soup)
{
  namespace internal = CGAL::Hex_mesh_optimization::internal;
  return internal::closed_parts(internal::triangles_to_reference(soup.points, soup.triangles));
}

Solver_file read_solver_file(const std::string& filename)
{
  if (!CGAL::IO::is_hex_mesh_file(filename))
    return nullptr;
  return std::make_shared<const CGAL::IO::Hex_mesh_file>(CGAL::IO::read_hex_mesh_file(filename));
}

bool is_copy(const std::string& input, const std::string& output)
{
  const io::Solver_format format = io::solver_format(input);
  if (format == io::Solver_format::NONE)
    return false;
  if (format != io::Solver_format::OPENFOAM)
    return io::solver_format(output) == format;
  const std::string extension = io::extension_of(output); // the name of a folder has no other meaning
  return extension != "mesh" && extension != "vtk" && extension != "vtu" &&
         (io::solver_format(output) == io::Solver_format::NONE || std::filesystem::is_directory(output));
}

void check_copy(const CGAL::IO::Hex_mesh_file& file, const std::string& output)
{
  std::vector<char> may_move(file.points.size(), false);
  for (const auto& h : file.hexahedra)
    for (std::size_t v : h)
      may_move[v] = true;
  for (const auto& follower : file.followers)
    may_move[follower.point] = true;
  file.places->check_output(output, may_move);
}

Points copy(const CGAL::IO::Hex_mesh_file& file, const std::string& output, const Points& points)
{
  Points result;
  for (const auto& p : CGAL::IO::copy_hex_mesh_file(file, output, points))
    result.emplace_back(p[0], p[1], p[2]);
  return result;
}

static std::vector<std::array<double, 3>> triples(const Points& points)
{
  std::vector<std::array<double, 3>> result;
  result.reserve(points.size());
  for (const auto& p : points)
    result.push_back({{p.x(), p.y(), p.z()}});
  return result;
}

struct File_places
{
  std::shared_ptr<const io::Coordinate_places> of_coordinates;
};

Places places_in(const std::string& input, const std::string& output, const Points& points)
{
  std::error_code ignored;
  if (io::extension_of(input) != io::extension_of(output) || !std::filesystem::is_regular_file(input, ignored))
    return nullptr;
  auto places = io::Places_of_points(input, triples(points)).places();
  return places ? std::make_shared<const File_places>(File_places{std::move(places)}) : nullptr;
}

void copy(const Places& places, const std::string& output, const Points& before, const Points& after)
{
  places->of_coordinates->write(output, triples(before), triples(after));
}

void check_writable(const std::string& filename)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(filename, ignored);
  if (std::filesystem::is_other(status)) // to open a pipe is to use it
    return;
  io::Atomic_file unused(filename);
}

void check_output(const std::string& filename)
{
  if (!io::is_output_format(filename))
    io::refuse_extension(filename);
  check_writable(filename);
}

void write_text(const std::string& filename, const std::string& text)
{
  io::Atomic_file file(filename);
  file.text() = text;
  file.commit();
}

CGAL::IO::Hex_mesh_data mesh_data_of(const CGAL::IO::Hex_mesh_file& file) { return io::mesh_data_of(file); }

void read(const std::string& filename, Soup& soup)
{
  CGAL::IO::read_triangle_soup(filename, soup.points, soup.triangles);
}

std::vector<int> solids_of_stl(const std::string& filename)
{
  std::vector<int> result;
  if (io::extension_of(filename) != "stl")
    return result;
  std::ifstream in(filename);
  int solid = 0;
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    words >> word;
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (word == "solid")
      ++solid;
    else if (word == "facet")
      result.push_back(solid);
    word.clear();
  }
  return result;
}

void write(const std::string& filename, const Points& points, const Hexahedra& hexahedra,
           const CGAL::IO::Hex_mesh_data& mesh_data)
{
  CGAL::IO::write_hex_mesh(filename, points, hexahedra, mesh_data);
}
