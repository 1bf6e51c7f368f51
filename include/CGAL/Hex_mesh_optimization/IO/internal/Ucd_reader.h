// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_UCD_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_UCD_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads a mesh of AVS UCD, whose files end in .inp as those of Abaqus do.

#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/split_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

// Its first line, but for comments, is five numbers.
inline bool is_ucd(std::string_view text)
{
  std::size_t position = 0;
  while (position < text.size()) {
    const std::size_t end = std::min(text.find('\n', position), text.size());
    const std::string_view line = trimmed(text.substr(position, end - position));
    position = end + 1;
    if (line.empty() || line[0] == '#')
      continue;
    const std::vector<std::string_view> w = words(line);
    if (w.size() != 5)
      return false;
    for (const std::string_view word : w) {
      std::int64_t value = 0;
      if (!parse_number(word, value))
        return false;
    }
    return true;
  }
  return false;
}

class Ucd_reader
{
public:
  explicit Ucd_reader(const std::string& filename) : places_(std::make_shared<Number_places>())
  {
    places_->files.emplace_back(filename, std::filesystem::path(filename).filename().string());
  }

  CGAL::IO::Hex_mesh_file read()
  {
    const Source_file& file = places_->files[0];
    Text_scanner scanner(file.filename, file.content, '#');
    mesh_.format = "AVS UCD";
    const std::size_t points = scanner.count("the number of points", 8);
    const std::size_t cells = scanner.count("the number of cells", 8);
    for (int i = 0; i < 3; ++i)
      scanner.integer("a number of data");
    for (std::size_t v = 0; v < points; ++v)
      read_point(scanner);
    for (std::size_t c = 0; c < cells; ++c)
      read_cell(scanner);
    return mesh_.finish(places_);
  }

private:
  void read_point(Text_scanner& scanner)
  {
    const std::int64_t number = scanner.integer("the number of a point");
    std::array<Number_place, 3> places;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view word = scanner.word();
      if (!parse_number(word, point[i]) || !std::isfinite(point[i]))
        scanner.fail("a coordinate is expected, not \"" + Text_scanner::printable(word) + '"');
      places[i].begin = static_cast<std::size_t>(word.data() - scanner.text().data());
      places[i].length = static_cast<std::uint32_t>(word.size());
      places[i].form = Number_place::Form::FREE;
    }
    point_of_[number] = mesh_.points.size();
    mesh_.points.push_back(point);
    places_->places.push_back(places);
  }

  void read_cell(Text_scanner& scanner)
  {
    struct Kind
    {
      std::size_t nodes;
      Cell_kind kind;
      int vtk_type;
    };
    static const std::map<std::string, Kind> kinds = {
      {"hex", {8, Cell_kind::HEXAHEDRON, 12}}, {"tet", {4, Cell_kind::SOLID, 10}}, {"prism", {6, Cell_kind::SOLID, 13}},
      {"pyr", {5, Cell_kind::SOLID, 0}},       {"quad", {4, Cell_kind::OTHER, 9}}, {"tri", {3, Cell_kind::OTHER, 5}},
      {"line", {2, Cell_kind::OTHER, 3}},      {"pt", {1, Cell_kind::OTHER, 1}}};
    scanner.integer("the number of a cell");
    const std::int64_t material = scanner.integer("the material of a cell");
    const std::string type(scanner.word());
    const auto kind = kinds.find(type);
    if (kind == kinds.end())
      scanner.fail("cells of the kind \"" + Text_scanner::printable(type) + "\" are not known");
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < kind->second.nodes; ++i) {
      const std::int64_t number = scanner.integer("the number of a point");
      const auto found = point_of_.find(number);
      if (found == point_of_.end())
        scanner.fail("a cell refers to point " + std::to_string(number) + ", which does not exist");
      nodes.push_back(found->second);
    }
    mesh_.add_cell(kind->second.kind, kind->second.vtk_type, material, nodes);
  }

  std::shared_ptr<Number_places> places_;
  Solver_mesh mesh_;
  std::unordered_map<std::int64_t, std::size_t> point_of_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_UCD_READER_H
