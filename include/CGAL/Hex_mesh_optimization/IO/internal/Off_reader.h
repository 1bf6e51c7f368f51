// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OFF_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OFF_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the points and polygons of an OFF file. What a file announces is never believed
// before its size allows for it.

#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Not CGAL's reader: it allocates what each polygon announces, reads beyond its buffer where one vertex has a color and
// the next has none, wants every point in a line of its own, and names no line.
class Off_reader
{
public:
  explicit Off_reader(const std::string& filename) : text_(read_whole_file(filename)), scanner_(filename, text_, '#') {}

  Mesh_file_content read()
  {
    read_keyword();
    const std::size_t number_of_points = scanner_.count("the number of vertices", 6);
    const std::size_t number_of_polygons = scanner_.count("the number of faces", 2);
    scanner_.rest_of_line(); // the number of edges, which need not be right
    content_.points.reserve(number_of_points);
    for (std::size_t i = 0; i < number_of_points; ++i)
      read_point();
    for (std::size_t i = 0; i < number_of_polygons; ++i)
      read_polygon();
    return std::move(content_);
  }

private:
  // OFF after any of ST, C, N and 4: texture coordinates, colors, normals, and homogeneous coordinates.
  void read_keyword()
  {
    std::string_view keyword = scanner_.word();
    const auto has = [&](std::string_view prefix) {
      const bool result = keyword.substr(0, prefix.size()) == prefix;
      if (result)
        keyword.remove_prefix(prefix.size());
      return result;
    };
    has_more_than_coordinates_ = has("ST");
    has_more_than_coordinates_ |= has("C");
    has_more_than_coordinates_ |= has("N");
    is_homogeneous_ = has("4");
    if (keyword != "OFF")
      scanner_.fail("this is no OFF file: it does not begin with OFF, nor with COFF, NOFF, STOFF or 4OFF");
    Text_scanner ahead = scanner_;
    if (lowered(ahead.word()) == "binary")
      scanner_.fail("binary OFF files cannot be read");
  }

  void read_point()
  {
    std::array<double, 3> point;
    for (double& x : point)
      x = scanner_.coordinate("a coordinate");
    if (is_homogeneous_) {
      const double w = scanner_.coordinate("a coordinate");
      for (double& x : point)
        if (!std::isfinite(x /= w))
          scanner_.fail("a point is at infinity");
    }
    if (has_more_than_coordinates_)
      scanner_.rest_of_line();
    content_.points.push_back(point);
  }

  void read_polygon()
  {
    std::vector<std::size_t> polygon(scanner_.count("the number of vertices of a face", 2));
    for (std::size_t& v : polygon) {
      const std::int64_t i = scanner_.integer("the number of a vertex");
      if (i < 0 || static_cast<std::uint64_t>(i) >= content_.points.size())
        scanner_.fail("vertex " + std::to_string(i) + " does not exist, there are " +
                      std::to_string(content_.points.size()) + " vertices");
      v = static_cast<std::size_t>(i);
    }
    scanner_.rest_of_line(); // its color
    content_.polygons.push_back(std::move(polygon));
  }

  std::string text_;
  Text_scanner scanner_;
  bool has_more_than_coordinates_ = false;
  bool is_homogeneous_ = false;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OFF_READER_H
