// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H

// Reads and writes hexahedral meshes in the Medit format (.mesh, text).

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_attachments.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file_error.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Mesh_file_content.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

class Medit_reader
{
public:
  Medit_reader(const std::string& filename, Wanted_cells wanted)
    : filename_(filename)
    , wanted_(wanted)
  {}

  Mesh_file_content read()
  {
    text_ = read_whole_file(filename_);
    find_sections();
    for(const Section& section : sections_)
      if(section.name == "Vertices")
        read_vertices(section);
    if(number_of_vertices_sections_ == 0)
      throw Hex_mesh_file_error(filename_, last_line_, "there is no Vertices section");
    // Only now: the cells may come before the vertices.
    for(const Section& section : sections_)
      if(section.name != "Vertices")
        read_cells(section);
    if(wanted_ == Wanted_cells::HEXAHEDRA && number_of_hexahedra_sections_ == 0)
      throw Hex_mesh_file_error(filename_, last_line_, "there is no Hexahedra section");
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
    return word.front() >= 'A' && word.front() <= 'Z' && lowered(word) != "nan" && lowered(word) != "inf"
           && lowered(word) != "infinity";
  }

  void find_sections()
  {
    Text_scanner scanner(filename_, text_, '#');
    for(std::string_view word = scanner.word(); ; word = scanner.word())
    {
      if(!word.empty() && !is_keyword(word))
      {
        if(sections_.empty())
          break;
        continue;
      }
      const std::size_t begin = scanner.position() - word.size();
      if(!sections_.empty())
        sections_.back().end = begin;
      if(word.empty() || word == "End")
        break;
      if(sections_.empty() && word != "MeshVersionFormatted")
        break;
      sections_.push_back({word, scanner.line(), begin, scanner.position(), 0});
    }
    last_line_ = scanner.line();
    if(sections_.empty())
      scanner.fail("this is no Medit mesh: it does not begin with MeshVersionFormatted");
  }

  Text_scanner body(const Section& section) const
  {
    return Text_scanner(filename_, std::string_view(text_).substr(section.body, section.end - section.body),
                        '#', section.line);
  }

  void check_end(Text_scanner& scanner, const Section& section) const
  {
    if(!scanner.at_end())
      scanner.fail("section " + std::string(section.name) + " is longer than it should be");
  }

  void read_vertices(const Section& section)
  {
    Text_scanner scanner = body(section);
    if(++number_of_vertices_sections_ > 1)
      scanner.fail("there is a second Vertices section");
    const std::size_t count = scanner.count("the number of vertices", 8);
    content_.points.resize(count);
    content_.attachments.vertex_labels.resize(count);
    for(std::size_t i = 0; i < count; ++i)
    {
      for(double& x : content_.points[i])
        x = scanner.coordinate("a coordinate");
      content_.attachments.vertex_labels[i] = scanner.integer("the label of a vertex");
    }
    check_end(scanner, section);
  }

  // The vertices of the next cell; its label follows.
  template <class Indices>
  void read_indices(Text_scanner& scanner, Indices& indices) const
  {
    for(std::size_t& index : indices)
    {
      const std::int64_t i = scanner.integer("the number of a vertex");
      if(i < 1 || static_cast<std::uint64_t>(i) > content_.points.size())
        scanner.fail("vertex " + std::to_string(i) + " does not exist, there are "
                     + std::to_string(content_.points.size()) + " vertices");
      index = static_cast<std::size_t>(i - 1);
    }
  }

  void read_cells(const Section& section)
  {
    Text_scanner scanner = body(section);
    const std::string name(section.name);
    if(name == "MeshVersionFormatted")
    {
      const std::int64_t version = scanner.integer("the version of the format");
      if(version < 1 || version > 4)
        scanner.fail("version " + std::to_string(version) + " of the format is unknown");
      check_end(scanner, section);
    }
    else if(name == "Dimension")
    {
      const std::int64_t dimension = scanner.integer("the dimension");
      if(dimension != 3)
        scanner.fail("the dimension is " + std::to_string(dimension) + ", not 3");
      check_end(scanner, section);
    }
    else if(wanted_ == Wanted_cells::POLYGONS)
    {
      if(name == "Triangles" || name == "Quadrilaterals")
        read_polygons(section, scanner, name == "Triangles" ? 3 : 4);
    }
    else if(name == "Hexahedra")
      read_hexahedra(section, scanner);
    else if(name == "Tetrahedra" || name == "TetrahedraP2" || name == "Prisms" || name == "PrismsP2"
            || name == "Pyramids" || name == "PyramidsP2" || name == "HexahedraQ2")
    {
      if(scanner.integer("the number of cells") != 0)
        throw Hex_mesh_file_error(filename_, section.line, "the mesh has " + name + ": all cells must be hexahedra "
                                                           "with eight vertices");
      keep(section);
    }
    else
      keep(section);
  }

  void read_hexahedra(const Section& section, Text_scanner& scanner)
  {
    if(++number_of_hexahedra_sections_ > 1)
      scanner.fail("there is a second Hexahedra section");
    const std::size_t count = scanner.count("the number of hexahedra", 18);
    content_.hexahedra.resize(count);
    content_.attachments.hexahedron_labels.resize(count);
    for(std::size_t i = 0; i < count; ++i)
    {
      read_indices(scanner, content_.hexahedra[i]);
      content_.attachments.hexahedron_labels[i] = scanner.integer("the label of a hexahedron");
    }
    check_end(scanner, section);
  }

  void read_polygons(const Section& section, Text_scanner& scanner, std::size_t size)
  {
    const std::size_t count = scanner.count("the number of polygons", 2 * (size + 1));
    for(std::size_t i = 0; i < count; ++i)
    {
      content_.polygons.emplace_back(size);
      read_indices(scanner, content_.polygons.back());
      scanner.integer("the label of a polygon");
    }
    check_end(scanner, section);
  }

  void keep(const Section& section)
  {
    std::string& kept = content_.attachments.other_sections;
    kept.append(text_, section.begin, section.end - section.begin);
    if(kept.back() != '\n')
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

inline void append_label(std::string& text, const std::vector<std::int64_t>& labels, std::size_t i)
{
  append_number(text, labels.empty() ? std::int64_t(0) : labels[i]);
  text += '\n';
}

} // namespace internal

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * reads a hexahedral mesh from a Medit file (`.mesh`, text).
 *
 * The order of the sections is free. All vertices are read, also those no hexahedron refers to. Every section but
 * `Vertices` and `Hexahedra` is kept verbatim in `attachments`.
 *
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type can be constructed from
 *         three `double`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 *
 * \param filename the name of the file
 * \param points the points, replaced
 * \param hexahedra the hexahedra, replaced
 * \param attachments what else is in the file, replaced
 *
 * \throws Hex_mesh_file_error naming the line if the file cannot be read, is malformed or truncated, has a coordinate
 *         that is not finite, an index out of range, or a cell that is not a hexahedron. The parameters
 *         are unchanged then.
 *
 * Complexity: linear in the size of the file.
 */
template <class PointRange, class HexahedronRange>
void read_medit_hex_mesh(const std::string& filename, PointRange& points, HexahedronRange& hexahedra,
                         Hex_mesh_attachments& attachments)
{
  internal::Mesh_file_content content
    = internal::Medit_reader(filename, internal::Wanted_cells::HEXAHEDRA).read();
  internal::copy_hex_mesh(content, points, hexahedra);
  attachments = std::move(content.attachments);
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * writes a hexahedral mesh to a Medit file (`.mesh`, text).
 *
 * Coordinates are written with as many digits, up to 17, as it takes to read back the same `double`. The file appears
 * complete or not at all.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type has coordinates `x()`, `y()` and `z()`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices of an
 *         integral type
 *
 * \param filename the name of the file
 * \param points the points
 * \param hexahedra the hexahedra
 * \param attachments what else to write; `other_sections` must be a sequence of sections in the Medit format
 *
 * \throws Hex_mesh_file_error if the file cannot be written, or if there are labels but not one per element
 */
template <class PointRange, class HexahedronRange>
void write_medit_hex_mesh(const std::string& filename, const PointRange& points, const HexahedronRange& hexahedra,
                          const Hex_mesh_attachments& attachments = Hex_mesh_attachments())
{
  const auto fits = [](const std::vector<std::int64_t>& labels, std::size_t size)
    { return labels.empty() || labels.size() == size; };
  if(!fits(attachments.vertex_labels, points.size()) || !fits(attachments.hexahedron_labels, hexahedra.size()))
    throw Hex_mesh_file_error(filename, 0, "the number of labels is not the number of elements");

  internal::Atomic_file file(filename);
  std::string& text = file.text();
  // Version 2 stands for coordinates in double precision.
  text = "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(points.size()) + "\n";
  std::size_t i = 0;
  for(const auto& p : points)
  {
    for(const double x : internal::coordinates(p))
    {
      internal::append_number(text, x);
      text += ' ';
    }
    internal::append_label(text, attachments.vertex_labels, i++);
    file.write_if_large();
  }
  text += "Hexahedra\n" + std::to_string(hexahedra.size()) + "\n";
  i = 0;
  for(const auto& hexahedron : hexahedra)
  {
    for(const auto& v : hexahedron)
    {
      internal::append_number(text, static_cast<std::size_t>(v) + 1);
      text += ' ';
    }
    internal::append_label(text, attachments.hexahedron_labels, i++);
    file.write_if_large();
  }
  text += attachments.other_sections;
  if(!attachments.other_sections.empty() && attachments.other_sections.back() != '\n')
    text += '\n';
  text += "End\n";
  file.commit();
}

} } // namespace CGAL::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_MEDIT_H
