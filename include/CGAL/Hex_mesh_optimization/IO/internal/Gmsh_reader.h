// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads a mesh of Gmsh, of the versions 1, 2, 4.0 and 4.1 of its format, as text or binary.

#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/gmsh_elements.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/split_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Gmsh_reader
{
public:
  explicit Gmsh_reader(const std::string& filename) : places_(std::make_shared<Number_places>())
  {
    places_->files.emplace_back(filename, std::filesystem::path(filename).filename().string());
    text_ = places_->files[0].content;
  }

  CGAL::IO::Hex_mesh_file read()
  {
    while (position_ < text_.size()) {
      line_begin_ = position_;
      const std::string_view line = trimmed(next_line());
      if (line.empty() || line[0] != '$')
        continue;
      read_section(line);
    }
    if (places_->places.empty())
      places_->files[0].fail(0, "there are no nodes: this is no mesh of Gmsh");
    mesh_.format = "Gmsh " + version_text_ + (is_binary_ ? ", binary" : "");
    add_sets();
    add_periodic_pairs();
    return mesh_.finish(places_);
  }

private:
  struct Group
  {
    std::vector<std::size_t> cells;
  };

  struct Periodic_entity
  {
    std::vector<std::array<std::size_t, 2>> pairs; // first: the master
  };

  void read_section(std::string_view name)
  {
    if (name == "$MeshFormat")
      read_format();
    else if (name == "$PhysicalNames")
      read_names();
    else if (name == "$Entities")
      is_binary_ ? read_binary_entities(false) : read_entities(false);
    else if (name == "$PartitionedEntities")
      is_binary_ ? read_binary_entities(true) : read_entities(true);
    else if (name == "$Nodes" || name == "$ParametricNodes" || name == "$NOD")
      read_nodes(name == "$NOD");
    else if (name == "$Elements" || name == "$ELM")
      read_elements(name == "$ELM");
    else if (name == "$Periodic")
      read_periodic();
    else
      skip_section(name);
  }

  void skip_section(std::string_view name)
  {
    if (name.substr(0, 4) == "$End" || name.substr(0, 4) == "$END")
      return;
    const std::string end = "\n$End" + std::string(name.substr(1));
    const std::size_t found = text_.find(end, position_ > 0 ? position_ - 1 : 0);
    if (found != std::string_view::npos)
      position_ = found + 1;
  }

  void read_format()
  {
    const std::vector<std::string_view> format = words(next_line());
    double version = 0;
    std::int64_t is_binary = 0, size = 8;
    if (format.size() < 3 || !parse_number(format[0], version) || !parse_number(format[1], is_binary) ||
        !parse_number(format[2], size))
      fail("the version, the type and the size of numbers are expected");
    version_ = version;
    version_text_ = std::string(format[0]);
    is_binary_ = is_binary != 0;
    if (!(version >= 2 && version < 5) || (version > 2.25 && version < 4))
      fail("version " + version_text_ + " of the format is not supported");
    if (!is_binary_)
      return;
    if (size != 8)
      fail("numbers of " + std::to_string(size) + " bytes are not supported");
    need(4);
    is_big_ = text_[position_] == 0 && text_[position_ + 3] == 1;
    position_ += 4;
  }

  void read_names()
  {
    const std::int64_t n = number(next_line());
    for (std::int64_t i = 0; i < n && position_ < text_.size(); ++i) {
      line_begin_ = position_;
      const std::string_view line = next_line();
      const std::vector<std::string_view> w = words(line);
      std::int64_t dimension = 0, tag = 0;
      const std::size_t begin = line.find('"'), end = line.rfind('"');
      if (w.size() < 3 || !parse_number(w[0], dimension) || !parse_number(w[1], tag) || end <= begin)
        fail("a dimension, a number and a name are expected");
      names_[{dimension, tag}] = std::string(line.substr(begin + 1, end - begin - 1));
    }
  }

  // dimension, entity: physical groups
  void read_entities(bool is_partitioned)
  {
    if (is_partitioned) {
      next_line();
      const std::int64_t ghosts = number(next_line());
      for (std::int64_t i = 0; i < ghosts && position_ < text_.size(); ++i)
        next_line();
    }
    const std::vector<std::string_view> counts = words(next_line());
    if (counts.size() < 4)
      fail("four numbers of entities are expected");
    for (int dimension = 0; dimension < 4; ++dimension) {
      std::int64_t n = 0;
      if (!parse_number(counts[static_cast<std::size_t>(dimension)], n))
        fail("a number of entities is expected");
      for (std::int64_t i = 0; i < n && position_ < text_.size(); ++i) {
        line_begin_ = position_;
        const std::vector<std::string_view> w = words(next_line());
        std::size_t at = 0;
        const auto next = [&] {
          std::int64_t value = 0;
          if (at >= w.size() || !parse_number(w[at++], value))
            fail("an entity is expected");
          return value;
        };
        const std::int64_t tag = next();
        if (is_partitioned) {
          next();
          next();
          for (std::int64_t p = next(); p > 0; --p)
            next();
        }
        // in 4.0 points have a box as well
        at += dimension == 0 && version_ >= 4.05 ? 3 : 6;
        std::vector<std::int64_t>& groups = groups_[{dimension, tag}];
        for (std::int64_t p = next(); p > 0; --p)
          groups.push_back(std::abs(next()));
      }
    }
  }

  void read_binary_entities(bool is_partitioned)
  {
    if (is_partitioned) {
      size_number();
      for (std::uint64_t ghosts = size_number(); ghosts > 0; --ghosts)
        skip(8);
    }
    std::array<std::uint64_t, 4> counts{};
    for (auto& n : counts)
      n = size_number();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::uint64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        const std::int64_t tag = integer();
        if (is_partitioned) {
          skip(8);
          for (std::uint64_t p = size_number(); p > 0; --p)
            skip(4);
        }
        skip(dimension == 0 && version_ >= 4.05 ? 24 : 48);
        std::vector<std::int64_t>& groups = groups_[{dimension, tag}];
        for (std::uint64_t p = size_number(); p > 0; --p)
          groups.push_back(std::abs(std::int64_t(integer())));
        if (dimension > 0)
          for (std::uint64_t b = size_number(); b > 0; --b)
            skip(4);
      }
  }

  void read_nodes(bool is_first_version)
  {
    if (version_ >= 4) {
      is_binary_ ? read_binary_blocks_of_nodes() : read_blocks_of_nodes();
      return;
    }
    (void)is_first_version;
    const std::int64_t n = number(next_line());
    for (std::int64_t i = 0; i < n; ++i)
      if (is_binary_) {
        const std::int64_t tag = integer();
        add_binary_node(tag);
      }
      else
        read_node(0);
  }

  // A line with a tag, unless it is given, and coordinates.
  void read_node(std::int64_t tag)
  {
    std::string_view line;
    do {
      if (position_ >= text_.size())
        fail("a node is expected, but the file ends here");
      line_begin_ = position_;
      line = next_line();
    } while (trimmed(line).empty());
    const std::vector<std::string_view> w = words(line);
    std::size_t at = 0;
    if (tag == 0 && (w.empty() || !parse_number(w[at++], tag)))
      fail("the number of a node is expected");
    if (w.size() < at + 3)
      fail("three coordinates are expected");
    std::array<Number_place, 3> places;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view word = w[at + i];
      if (!parse_number(word, point[i]) || !std::isfinite(point[i]))
        fail("a coordinate is expected, not \"" + Text_scanner::printable(word) + '"');
      places[i].begin = static_cast<std::size_t>(word.data() - text_.data());
      places[i].length = static_cast<std::uint32_t>(word.size());
      places[i].form = Number_place::Form::FREE;
    }
    add_node(tag, point, places);
  }

  void add_binary_node(std::int64_t tag)
  {
    std::array<Number_place, 3> places;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      need(8);
      places[i].begin = position_;
      places[i].length = 8;
      places[i].form = is_big_ ? Number_place::Form::BIG_DOUBLE : Number_place::Form::LITTLE_DOUBLE;
      point[i] = binary_value(&text_[position_], places[i].form);
      if (!std::isfinite(point[i]))
        fail("a coordinate of node " + std::to_string(tag) + " is not finite");
      position_ += 8;
    }
    add_node(tag, point, places);
  }

  void add_node(std::int64_t tag, const std::array<double, 3>& point, const std::array<Number_place, 3>& places)
  {
    point_of_[tag] = mesh_.points.size();
    mesh_.points.push_back(point);
    places_->places.push_back(places);
  }

  void read_blocks_of_nodes()
  {
    const std::int64_t blocks = first_number(next_line());
    for (std::int64_t b = 0; b < blocks; ++b) {
      std::int64_t header[4];
      read_header(header);
      if (version_ < 4.05) {
        for (std::int64_t i = 0; i < header[3]; ++i)
          read_node(0);
        continue;
      }
      if (header[3] > static_cast<std::int64_t>(text_.size()))
        fail("more nodes are announced than the file can hold");
      std::vector<std::int64_t> tags;
      for (std::int64_t i = 0; i < header[3]; ++i) {
        line_begin_ = position_;
        tags.push_back(number(next_line()));
        if (tags.back() == 0)
          fail("the number of a node is expected");
      }
      for (std::int64_t tag : tags)
        read_node(tag);
    }
  }

  void read_binary_blocks_of_nodes()
  {
    const std::uint64_t blocks = size_number();
    size_number();
    if (version_ >= 4.05)
      skip(16);
    for (std::uint64_t b = 0; b < blocks; ++b) {
      // in 4.0 the entity comes before its dimension
      const std::int32_t first = integer(), second = integer(), is_parametric = integer();
      const int dimension = version_ >= 4.05 ? first : second;
      const std::uint64_t n = size_number();
      if (n > text_.size())
        fail("more nodes are announced than the file can hold");
      std::vector<std::int64_t> tags;
      if (version_ >= 4.05)
        for (std::uint64_t i = 0; i < n; ++i)
          tags.push_back(static_cast<std::int64_t>(size_number()));
      for (std::uint64_t i = 0; i < n; ++i) {
        add_binary_node(version_ >= 4.05 ? tags[static_cast<std::size_t>(i)] : integer());
        if (is_parametric != 0)
          skip(8 * static_cast<std::size_t>(std::max(0, std::min(dimension, 3))));
      }
    }
  }

  void read_elements(bool is_first_version)
  {
    if (version_ >= 4) {
      is_binary_ ? read_binary_blocks_of_elements() : read_blocks_of_elements();
      return;
    }
    const std::int64_t n = number(next_line());
    if (is_binary_ && !is_first_version)
      return read_binary_elements(n);
    for (std::int64_t i = 0; i < n; ++i) {
      line_begin_ = position_;
      const std::vector<std::int64_t> w = integers(next_line());
      // number, type, number of tags, tags, nodes; in version 1: number, type, two tags, number of nodes, nodes
      const std::size_t tags = is_first_version ? 2 : w.size() > 2 && w[2] >= 0 ? static_cast<std::size_t>(w[2]) : 0;
      const std::size_t begin = is_first_version ? 5 : 3 + tags;
      if (w.size() < begin || w.size() < 4)
        fail("an element is expected");
      const std::int64_t group = is_first_version ? w[2] : tags > 0 ? w[3] : 0;
      add_element(w[1], {std::abs(group)}, w.data() + begin, w.size() - begin);
    }
  }

  void read_binary_elements(std::int64_t n)
  {
    for (std::int64_t done = 0; done < n;) {
      const std::int32_t type = integer(), count = integer(), tags = integer();
      const std::size_t nodes = gmsh_number_of_nodes(type);
      if (nodes == 0)
        fail("elements of type " + std::to_string(type) + " are not supported");
      if (count <= 0 || tags < 0)
        fail("a number of elements is expected");
      std::vector<std::int64_t> of_element(nodes);
      for (std::int32_t i = 0; i < count; ++i) {
        integer();
        std::int64_t group = 0;
        for (std::int32_t t = 0; t < tags; ++t) {
          const std::int32_t tag = integer();
          group = t == 0 ? tag : group;
        }
        for (std::int64_t& node : of_element)
          node = integer();
        add_element(type, {std::abs(group)}, of_element.data(), nodes);
      }
      done += count;
    }
  }

  void read_blocks_of_elements()
  {
    const std::int64_t blocks = first_number(next_line());
    for (std::int64_t b = 0; b < blocks; ++b) {
      std::int64_t header[4];
      read_header(header);
      // in 4.0 the entity comes before its dimension
      const std::int64_t dimension = version_ >= 4.05 ? header[0] : header[1];
      const std::int64_t entity = version_ >= 4.05 ? header[1] : header[0];
      const std::vector<std::int64_t> groups = groups_of(dimension, entity);
      for (std::int64_t i = 0; i < header[3]; ++i) {
        if (position_ >= text_.size())
          fail("an element is expected, but the file ends here");
        line_begin_ = position_;
        const std::vector<std::int64_t> w = integers(next_line());
        if (w.size() < 2)
          fail("an element is expected");
        add_element(header[2], groups, w.data() + 1, w.size() - 1);
      }
    }
  }

  void read_binary_blocks_of_elements()
  {
    const std::uint64_t blocks = size_number();
    size_number();
    if (version_ >= 4.05)
      skip(16);
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::int32_t first = integer(), second = integer(), type = integer();
      const std::uint64_t n = size_number();
      const std::vector<std::int64_t> groups = version_ >= 4.05 ? groups_of(first, second) : groups_of(second, first);
      const std::size_t nodes = gmsh_number_of_nodes(type);
      if (nodes == 0)
        fail("elements of type " + std::to_string(type) + " are not supported");
      std::vector<std::int64_t> of_element(nodes);
      for (std::uint64_t i = 0; i < n; ++i) {
        tag_number();
        for (std::int64_t& node : of_element)
          node = tag_number();
        add_element(type, groups, of_element.data(), nodes);
      }
    }
  }

  std::vector<std::int64_t> groups_of(std::int64_t dimension, std::int64_t entity) const
  {
    const auto found = groups_.find({dimension, entity});
    return found == groups_.end() ? std::vector<std::int64_t>() : found->second;
  }

  void add_element(std::int64_t type, const std::vector<std::int64_t>& groups, const std::int64_t* first,
                   std::size_t size)
  {
    const int dimension = gmsh_dimension(type);
    const bool is_hexahedron = gmsh_is_hexahedron(type);
    const std::size_t expected = gmsh_number_of_nodes(type);
    if ((is_hexahedron && size < 8) || (expected > 0 && size != expected))
      fail("an element of type " + std::to_string(type) + " has " + std::to_string(size) + " nodes");
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < size; ++i) {
      const auto found = point_of_.find(first[i]);
      if (found == point_of_.end())
        fail("an element refers to node " + std::to_string(first[i]) + ", which does not exist");
      nodes.push_back(found->second);
    }
    const std::int64_t label = groups.empty() ? 0 : groups[0];
    const Cell_kind kind = is_hexahedron ? Cell_kind::HEXAHEDRON : dimension == 3 ? Cell_kind::SOLID : Cell_kind::OTHER;
    const std::size_t cell = mesh_.add_cell(kind, gmsh_vtk_type(type), label, nodes);
    for (std::int64_t group : groups)
      if (group != 0)
        sets_[{dimension, group}].cells.push_back(cell);
  }

  void read_periodic()
  {
    if (is_binary_ && version_ >= 4)
      return read_binary_periodic();
    const std::int64_t n = number(next_line());
    for (std::int64_t i = 0; i < n && position_ < text_.size(); ++i) {
      next_line(); // dimension, entity, its master
      std::string_view line = trimmed(next_line());
      if (version_ >= 4.05 || line.substr(0, 6) == "Affine")
        line = trimmed(next_line());
      const std::int64_t count = number(line);
      Periodic_entity entity;
      for (std::int64_t p = 0; p < count && position_ < text_.size(); ++p) {
        line_begin_ = position_;
        const std::vector<std::int64_t> w = integers(next_line());
        if (w.size() < 2)
          fail("a pair of nodes is expected");
        add_pair(entity, w[1], w[0]);
      }
      periodic_.push_back(std::move(entity));
    }
  }

  void read_binary_periodic()
  {
    if (version_ < 4.05) {
      mesh_.notes.push_back("the section $Periodic is not read in this version of the format");
      return;
    }
    for (std::uint64_t n = size_number(); n > 0; --n) {
      skip(12);
      for (std::uint64_t a = size_number(); a > 0; --a)
        skip(8);
      Periodic_entity entity;
      for (std::uint64_t p = size_number(); p > 0; --p) {
        const std::int64_t slave = tag_number(), master = tag_number();
        add_pair(entity, master, slave);
      }
      periodic_.push_back(std::move(entity));
    }
  }

  void add_pair(Periodic_entity& entity, std::int64_t master, std::int64_t slave)
  {
    const auto a = point_of_.find(master), b = point_of_.find(slave);
    if (a != point_of_.end() && b != point_of_.end() && a->second != b->second)
      entity.pairs.push_back({{a->second, b->second}});
  }

  // Where they are not translated, they are held.
  void add_periodic_pairs()
  {
    for (const Periodic_entity& entity : periodic_) {
      std::vector<std::array<double, 3>> translations;
      double size = 0;
      for (const auto& [a, b] : entity.pairs) {
        translations.emplace_back();
        for (int i = 0; i < 3; ++i) {
          translations.back()[i] = mesh_.points[b][i] - mesh_.points[a][i];
          size = std::max(size, std::abs(translations.back()[i]));
        }
      }
      bool is_translation = true;
      for (const auto& t : translations)
        for (int i = 0; i < 3; ++i)
          is_translation = is_translation && std::abs(t[i] - translations[0][i]) <= 1e-9 * size;
      for (std::size_t p = 0; p < entity.pairs.size(); ++p) {
        const auto [a, b] = entity.pairs[p];
        if (is_translation)
          mesh_.periodic_pairs.push_back({a, b, translations[p]});
        else
          mesh_.held.insert(mesh_.held.end(), {a, b});
      }
    }
  }

  void add_sets()
  {
    using Kind = CGAL::IO::Hex_mesh_set::Kind;
    static const char* const kinds[] = {"point ", "curve ", "surface ", "volume "};
    for (const auto& [key, group] : sets_) {
      const auto name = names_.find(key);
      const std::string title = name != names_.end() ? name->second : kinds[key.first] + std::to_string(key.second);
      mesh_.add_set_of_cells(title, group.cells);
      if (key.first < 2)
        mesh_.sets.back().kind = Kind::VERTICES;
      if (key.first == 3)
        mesh_.label_names[key.second] = title;
    }
  }

  void read_header(std::int64_t (&header)[4])
  {
    line_begin_ = position_;
    const std::vector<std::int64_t> w = integers(next_line());
    if (w.size() < 4 || w[3] < 0)
      fail("four numbers are expected");
    std::copy_n(w.begin(), 4, header);
  }

  std::vector<std::int64_t> integers(std::string_view line) const
  {
    std::vector<std::int64_t> result;
    for (const std::string_view word : words(line)) {
      std::int64_t value = 0;
      if (!parse_number(word, value))
        fail("an integer is expected, not \"" + Text_scanner::printable(word) + '"');
      result.push_back(value);
    }
    return result;
  }

  std::int64_t first_number(std::string_view line) const
  {
    const std::vector<std::int64_t> w = integers(line);
    if (w.empty() || w[0] < 0)
      fail("a number is expected");
    return w[0];
  }

  std::int64_t number(std::string_view line) const { return first_number(line); }

  std::string_view next_line()
  {
    const std::size_t begin = position_, end = std::min(text_.find('\n', begin), text_.size());
    position_ = std::min(end + 1, text_.size());
    std::string_view line = text_.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  void need(std::size_t bytes) const
  {
    if (text_.size() - position_ < bytes)
      fail("the file ends too early");
  }

  void skip(std::size_t bytes)
  {
    need(bytes);
    position_ += bytes;
  }

  template <class Integer>
  Integer binary()
  {
    need(sizeof(Integer));
    unsigned char bytes[sizeof(Integer)];
    std::memcpy(bytes, &text_[position_], sizeof(Integer));
    position_ += sizeof(Integer);
    Integer value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i)
      value = static_cast<Integer>(value << 8 | bytes[is_big_ ? i : sizeof(Integer) - 1 - i]);
    return value;
  }

  std::int32_t integer() { return static_cast<std::int32_t>(binary<std::uint32_t>()); }
  std::uint64_t size_number() { return binary<std::uint64_t>(); }
  std::int64_t tag_number() // of an element or a node
  {
    return version_ >= 4.05 ? static_cast<std::int64_t>(size_number()) : integer();
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    if (is_binary_)
      throw CGAL::IO::Hex_mesh_file_error(places_->files[0].filename, 0, reason);
    places_->files[0].fail(line_begin_, reason);
  }

  std::shared_ptr<Number_places> places_;
  Solver_mesh mesh_;
  std::string_view text_;
  std::size_t position_ = 0, line_begin_ = 0;
  double version_ = 1;
  std::string version_text_ = "1";
  bool is_binary_ = false, is_big_ = false;
  std::unordered_map<std::int64_t, std::size_t> point_of_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::string> names_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::int64_t>> groups_;
  std::map<std::pair<int, std::int64_t>, Group> sets_;
  std::vector<Periodic_entity> periodic_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_GMSH_READER_H
