// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MESH_FILE_CONTENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MESH_FILE_CONTENT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the readers of all formats produce, and its way into the containers of
// the caller, who sees either the whole file or none of it.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>

#include <CGAL/Container_helper.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

enum class Wanted_cells { HEXAHEDRA, POLYGONS };

struct Mesh_file_content
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::vector<std::vector<std::size_t>> polygons;
  CGAL::IO::Hex_mesh_data mesh_data;
};

template <class PointRange>
void copy_points(const std::vector<std::array<double, 3>>& from, PointRange& points)
{
  using Point = typename PointRange::value_type;
  points.clear();
  points.reserve(from.size());
  for (const std::array<double, 3>& p : from)
    points.push_back(Point(p[0], p[1], p[2]));
}

template <class PointRange, class HexahedronRange>
void copy_hex_mesh(const Mesh_file_content& content, PointRange& points, HexahedronRange& hexahedra)
{
  copy_points(content.points, points);
  hexahedra.clear();
  hexahedra.reserve(content.hexahedra.size());
  for (const std::array<std::size_t, 8>& h : content.hexahedra) {
    typename HexahedronRange::value_type hexahedron;
    CGAL::internal::resize(hexahedron, 8);
    using Index = std::decay_t<decltype(hexahedron[0])>;
    for (std::size_t c = 0; c < 8; ++c)
      hexahedron[c] = static_cast<Index>(h[c]);
    hexahedra.push_back(std::move(hexahedron));
  }
}

// Reader: of files with hexahedra and mesh_data
template <class Reader, class PointRange, class HexahedronRange>
void read_hex_mesh_with(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                        CGAL::IO::Hex_mesh_data& mesh_data)
{
  Mesh_file_content content = Reader(filename, Wanted_cells::HEXAHEDRA).read();
  copy_hex_mesh(content, points, hexahedra);
  mesh_data = std::move(content.mesh_data);
}

template <class Point>
std::array<double, 3> coordinates(const Point& p)
{
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MESH_FILE_CONTENT_H
