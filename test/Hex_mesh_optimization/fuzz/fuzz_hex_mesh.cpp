// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fuzz target of the readers of hexahedral meshes, --format=mesh, vtk or vtu: whatever is in the file, it is refused
// by the documented exception, or gives a consistent mesh that comes back bit by bit when it is written and read again.

#include "Input_file.h"

#include "../mesh_checks.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Points = std::vector<Point>;
using Hexahedra = std::vector<std::array<std::size_t, 8>>;

std::unique_ptr<fuzz::Input_file> input_file;

template <class Value>
bool is_same(const Value& a, const Value& b)
{
  return a == b || (a != a && b != b); // not a number
}

// Names, shapes, types and values
bool are_same(const std::vector<CGAL::IO::Hex_mesh_data_array>& a, const std::vector<CGAL::IO::Hex_mesh_data_array>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return (x.name == y.name || x.name.empty()) && x.number_of_components == y.number_of_components &&
           x.values.index() == y.values.index() &&
           std::visit(
             [&](const auto& values) {
               const auto& others = std::get<std::decay_t<decltype(values)>>(y.values);
               using Value = typename std::decay_t<decltype(values)>::value_type;
               return std::equal(values.begin(), values.end(), others.begin(), others.end(), is_same<Value>);
             },
             x.values);
  });
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
  input_file = std::make_unique<fuzz::Input_file>(fuzz::format(*argc, *argv));
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Points points(1, Point(7, 8, 9));
  Hexahedra hexahedra(2);
  CGAL::IO::Hex_mesh_data mesh_data;
  try {
    CGAL::IO::read_hex_mesh((*input_file)(data, size), points, hexahedra, mesh_data);
  }
  catch (const CGAL::IO::Hex_mesh_file_error&) {
    fuzz::require(points.size() == 1 && hexahedra.size() == 2, "what is refused changes nothing");
    return 0;
  }
  for (const Point& p : points)
    for (int d = 0; d < 3; ++d)
      fuzz::require(std::isfinite(p[d]), "all coordinates are finite");
  for (const auto& h : hexahedra)
    for (std::size_t v : h)
      fuzz::require(v < points.size(), "all vertices exist");

  Points points_back;
  Hexahedra hexahedra_back;
  CGAL::IO::Hex_mesh_data mesh_data_back;
  const std::string output = input_file->name("output");
  CGAL::IO::write_hex_mesh(output, points, hexahedra, mesh_data);
  CGAL::IO::read_hex_mesh(output, points_back, hexahedra_back, mesh_data_back);
  fuzz::require(same_points(points, points_back), "the points come back");
  fuzz::require(hexahedra == hexahedra_back, "the hexahedra come back");
  fuzz::require(mesh_data.hexahedron_labels == mesh_data_back.hexahedron_labels, "the labels come back");
  fuzz::require(mesh_data_back.skipped.empty(), "what is written can be read");
  fuzz::require(are_same(mesh_data.point_data, mesh_data_back.point_data) &&
                  are_same(mesh_data.cell_data, mesh_data_back.cell_data) &&
                  are_same(mesh_data.field_data, mesh_data_back.field_data),
                "the data come back");
  fuzz::require(std::equal(mesh_data.other_cells.begin(), mesh_data.other_cells.end(),
                           mesh_data_back.other_cells.begin(), mesh_data_back.other_cells.end(),
                           [](const auto& a, const auto& b) { return a.vertices.size() == b.vertices.size(); }) ||
                  input_file->name("output").find(".mesh") != std::string::npos, // there they are sorted by their kinds
                "the other cells come back");
  fuzz::require(mesh_data.other_cells.size() == mesh_data_back.other_cells.size(), "all other cells come back");
  return 0;
}
