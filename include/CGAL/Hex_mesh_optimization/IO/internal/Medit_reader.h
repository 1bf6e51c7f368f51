// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads hexahedra or polygons from a Medit file (.mesh, text).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/read_whole_file.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Medit_reader
{
public:
  Medit_reader(const std::string& filename, Wanted_cells wanted) : filename_(filename), wanted_(wanted) {}

  Mesh_file_content read()
  {
    text_ = read_whole_file(filename_);
    find_sections();
    for (const Section& section : sections_)
      if (section.name == "Vertices")
        read_vertices(section);
    if (number_of_vertices_sections_ == 0)
      throw CGAL::IO::Hex_mesh_file_error(filename_, last_line_, "there is no Vertices section");
    // Only now: the cells may come before the vertices.
    for (const Section& section : sections_)
      if (section.name != "Vertices")
        read_cells(section);
    if (wanted_ == Wanted_cells::HEXAHEDRA && number_of_hexahedra_sections_ == 0)
      throw CGAL::IO::Hex_mesh_file_error(filename_, last_line_, "there is no Hexahedra section");
    for (CGAL::IO::Hex_mesh_cell& cell : content_.mesh_data.other_cells)
      cell.number_of_hexahedra_before = content_.hexahedra.size();
    return std::move(content_);
  }

private:
  struct Section
  {
    std::string_view name;
    std::size_t line, begin, body, end;
  };

  // All keywords begin with a capital letter; so may a number that is none.
  static bool is_keyword(std::string_view word)
  {
    return word.front() >= 'A' && word.front() <= 'Z' && lowered(word) != "nan" && lowered(word) != "inf" &&
           lowered(word) != "infinity";
  }

  void find_sections()
  {
    Text_scanner scanner(filename_, text_, '#');
    for (std::string_view word = scanner.word();; word = scanner.word()) {
      if (!word.empty() && !is_keyword(word)) {
        if (sections_.empty())
          break;
        continue;
      }
      const std::size_t begin = scanner.position() - word.size();
      if (!sections_.empty())
        sections_.back().end = begin;
      if (word.empty() || word == "End")
        break;
      if (sections_.empty() && word != "MeshVersionFormatted")
        break;
      sections_.push_back({word, scanner.line(), begin, scanner.position(), 0});
    }
    last_line_ = scanner.line();
    if (sections_.empty())
      scanner.fail("this is no Medit mesh: it does not begin with MeshVersionFormatted");
  }

  Text_scanner body(const Section& section) const
  {
    return Text_scanner(filename_, std::string_view(text_).substr(section.body, section.end - section.body), '#',
                        section.line);
  }

  void check_end(Text_scanner& scanner, const Section& section) const
  {
    if (!scanner.at_end())
      scanner.fail("section " + std::string(section.name) + " is longer than it should be");
  }

  void read_vertices(const Section& section)
  {
    Text_scanner scanner = body(section);
    if (++number_of_vertices_sections_ > 1)
      scanner.fail("there is a second Vertices section");
    const std::size_t count = scanner.count("the number of vertices", 8);
    content_.points.resize(count);
    content_.mesh_data.vertex_labels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (double& x : content_.points[i])
        x = scanner.coordinate("a coordinate");
      content_.mesh_data.vertex_labels[i] = scanner.integer("the label of a vertex");
    }
    check_end(scanner, section);
  }

  // The vertices of the next cell; its label follows.
  template <class Indices>
  void read_indices(Text_scanner& scanner, Indices& indices) const
  {
    for (std::size_t& index : indices) {
      const std::int64_t i = scanner.integer("the number of a vertex");
      if (i < 1 || static_cast<std::uint64_t>(i) > content_.points.size())
        scanner.fail("vertex " + std::to_string(i) + " does not exist, there are " +
                     std::to_string(content_.points.size()) + " vertices");
      index = static_cast<std::size_t>(i - 1);
    }
  }

  void read_cells(const Section& section)
  {
    Text_scanner scanner = body(section);
    const std::string name(section.name);
    if (name == "MeshVersionFormatted") {
      const std::int64_t version = scanner.integer("the version of the format");
      if (version < 1 || version > 4)
        scanner.fail("version " + std::to_string(version) + " of the format is unknown");
      check_end(scanner, section);
    }
    else if (name == "Dimension") {
      const std::int64_t dimension = scanner.integer("the dimension");
      if (dimension != 3)
        scanner.fail("the dimension is " + std::to_string(dimension) + ", not 3");
      check_end(scanner, section);
    }
    else if (wanted_ == Wanted_cells::POLYGONS) {
      if (name == "Triangles" || name == "Quadrilaterals")
        read_polygons(section, scanner, name == "Triangles" ? 3 : 4);
      else if (name == "Hexahedra") // they tell which polygons are within
        read_hexahedra(section, scanner);
    }
    else if (name == "Hexahedra")
      read_hexahedra(section, scanner);
    else if (name == "Tetrahedra" || name == "TetrahedraP2" || name == "Prisms" || name == "PrismsP2" ||
             name == "Pyramids" || name == "PyramidsP2" || name == "HexahedraQ2") {
      if (scanner.integer("the number of cells") != 0)
        throw CGAL::IO::Hex_mesh_file_error(filename_, section.line,
                                            "the mesh has " + name +
                                              ": all cells must be "
                                              "hexahedra with eight vertices");
      keep(section);
    }
    else if (name == "Edges")
      read_other_cells(section, scanner, 3, 2);
    else if (name == "Triangles")
      read_other_cells(section, scanner, 5, 3);
    else if (name == "Quadrilaterals")
      read_other_cells(section, scanner, 9, 4);
    else
      keep(section);
  }

  void read_other_cells(const Section& section, Text_scanner& scanner, int vtk_type, std::size_t size)
  {
    const std::size_t count = scanner.count("the number of cells", 2 * (size + 1));
    for (std::size_t i = 0; i < count; ++i) {
      CGAL::IO::Hex_mesh_cell cell;
      cell.type = vtk_type;
      cell.vertices.resize(size);
      read_indices(scanner, cell.vertices);
      cell.label = scanner.integer("the label of a cell");
      content_.mesh_data.other_cells.push_back(std::move(cell));
    }
    check_end(scanner, section);
  }

  void read_hexahedra(const Section& section, Text_scanner& scanner)
  {
    if (++number_of_hexahedra_sections_ > 1)
      scanner.fail("there is a second Hexahedra section");
    const std::size_t count = scanner.count("the number of hexahedra", 18);
    content_.hexahedra.resize(count);
    content_.mesh_data.hexahedron_labels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      read_indices(scanner, content_.hexahedra[i]);
      content_.mesh_data.hexahedron_labels[i] = scanner.integer("the label of a hexahedron");
    }
    check_end(scanner, section);
  }

  void read_polygons(const Section& section, Text_scanner& scanner, std::size_t size)
  {
    const std::size_t count = scanner.count("the number of polygons", 2 * (size + 1));
    for (std::size_t i = 0; i < count; ++i) {
      content_.polygons.emplace_back(size);
      read_indices(scanner, content_.polygons.back());
      scanner.integer("the label of a polygon");
    }
    check_end(scanner, section);
  }

  void keep(const Section& section)
  {
    std::string& kept = content_.mesh_data.other_sections;
    kept.append(text_, section.begin, section.end - section.begin);
    if (kept.back() != '\n')
      kept += '\n';
  }

  std::string filename_;
  Wanted_cells wanted_;
  std::string text_;
  std::vector<Section> sections_;
  std::size_t last_line_ = 0;
  std::size_t number_of_vertices_sections_ = 0;
  std::size_t number_of_hexahedra_sections_ = 0;
  Mesh_file_content content_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_MEDIT_READER_H
