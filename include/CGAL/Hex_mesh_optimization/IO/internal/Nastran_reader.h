// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NASTRAN_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NASTRAN_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads bulk data of Nastran, with the files that they include.

#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Text_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/lowered.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/number_in_width.h>
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
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Nastran_reader
{
public:
  explicit Nastran_reader(const std::string& filename) : places_(std::make_shared<Number_places>())
  {
    places_->files.reserve(most_files); // views of lines stay valid: the files do not move in memory
    places_->files.emplace_back(filename, std::filesystem::path(filename).filename().string());
  }

  CGAL::IO::Hex_mesh_file read()
  {
    mesh_.format = "Nastran";
    read_file(0, 0);
    end_card();
    place_points();
    add_cells();
    add_sets();
    return mesh_.finish(places_);
  }

private:
  struct Field
  {
    std::string_view text; // trimmed
    std::size_t begin = 0;
    std::size_t length = 0;
    std::uint8_t width = 0; // what may be written there; 0: nothing
    Number_place::Form form = Number_place::Form::NASTRAN_COLUMN;
  };

  struct Card
  {
    std::string name; // in upper case, without *
    std::vector<Field> fields;
    std::size_t file = 0, line = 0;
  };

  struct Point
  {
    std::int64_t number, system;
  };

  struct Element
  {
    Cell_kind kind;
    int vtk_type;
    std::int64_t number, property;
    std::vector<std::int64_t> nodes;
    std::size_t file, line;
  };

  struct System
  {
    Coordinate_frame::Kind kind = Coordinate_frame::Kind::RECTANGULAR;
    std::int64_t reference = 0;
    std::array<double, 9> points{};
    std::vector<std::int64_t> nodes; // of a system that nodes define
  };

  void read_file(std::size_t f, int depth)
  {
    if (depth > 20)
      places_->files[f].fail(0, "files include each other");
    const std::string_view text = places_->files[f].content; // the bytes stay where they are
    bool is_bulk = f > 0 || !has_begin_bulk(text);
    for (std::size_t position = 0; position < text.size();) {
      const std::size_t begin = position;
      std::string_view line = next_line(text, position);
      line = line.substr(0, line.find('$'));
      const std::string_view content = trimmed(line);
      if (content.empty())
        continue;
      if (starts_with(content, "include")) {
        end_card();
        include(text, content, position, f, depth);
        continue;
      }
      if (!is_bulk) {
        is_bulk = starts_with(content, "begin") && lowered(std::string(content)).find("bulk") != std::string::npos;
        continue;
      }
      if (starts_with(content, "enddata")) {
        end_card();
        is_ended_ = true;
      }
      if (is_ended_)
        return;
      read_line(line, f, begin);
    }
  }

  static std::string_view next_line(std::string_view text, std::size_t& position)
  {
    const std::size_t begin = position, end = std::min(text.find('\n', begin), text.size());
    position = std::min(end + 1, text.size());
    std::string_view line = text.substr(begin, end - begin);
    while (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  static bool starts_with(std::string_view text, const char* lower_case)
  {
    for (std::size_t i = 0; lower_case[i] != '\0'; ++i)
      if (i >= text.size() || (text[i] | 0x20) != lower_case[i])
        return false;
    return true;
  }

  static bool has_begin_bulk(std::string_view text)
  {
    for (std::size_t position = 0; position < text.size();) {
      const std::string_view line = trimmed(next_line(text, position));
      if (starts_with(line, "begin") && starts_with(trimmed(line.substr(5)), "bulk"))
        return true;
    }
    return false;
  }

  void include(std::string_view text, std::string_view line, std::size_t& position, std::size_t from, int depth)
  {
    namespace fs = std::filesystem;
    std::string name(trimmed(line.substr(7)));
    const auto is_open = [&name] {
      return (name[0] == '\'' || name[0] == '"') && name.find(name[0], 1) == std::string::npos;
    };
    while (!name.empty() && is_open() && position < text.size())
      name += trimmed(next_line(text, position));
    name = unquoted(name);
    const fs::path relative = fs::path(name).is_absolute() ? fs::path(name) : fs::path(name).lexically_normal();
    fs::path path = fs::path(places_->files[0].filename).parent_path() / relative;
    fs::path known = relative;
    if (!fs::is_regular_file(path) && from > 0) {
      path = fs::path(places_->files[from].filename).parent_path() / relative;
      known = fs::path(places_->files[from].name).parent_path() / relative;
    }
    if (!fs::is_regular_file(path)) {
      mesh_.notes.push_back("the included file " + name + " was not found");
      return;
    }
    if (places_->files.size() == most_files)
      places_->files[from].fail(0, "too many files are included");
    places_->files.emplace_back(path.string(), known.string());
    read_file(places_->files.size() - 1, depth + 1);
  }

  void read_line(std::string_view line, std::size_t f, std::size_t begin)
  {
    bool is_large = false;
    std::vector<Field> fields = line.find(',') != std::string_view::npos ? free_fields(line, begin, is_large)
                                                                         : columns(line, begin, is_large);
    const std::string_view first = fields[0].text;
    const bool continues = first.empty() || first[0] == '+' || first[0] == '*';
    if (!continues) {
      end_card();
      card_.name.clear();
      for (char c : first)
        if (c != '*')
          card_.name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
      card_.file = f;
      card_.line = begin;
      card_.fields.clear();
    }
    else if (card_.name.empty() || card_.file != f)
      return;
    fields.resize(is_large ? 5 : 9, Field());
    card_.fields.insert(card_.fields.end(), fields.begin() + 1, fields.end());
  }

  static std::vector<Field> free_fields(std::string_view line, std::size_t begin, bool& is_large)
  {
    std::vector<Field> result;
    const std::vector<std::string_view> parts = split(line, ',');
    is_large = trimmed(parts[0]).find('*') != std::string_view::npos;
    for (const std::string_view part : parts) {
      Field field;
      field.text = trimmed(part);
      field.begin = begin +
                    static_cast<std::size_t>((field.text.empty() ? part.data() : field.text.data()) - line.data());
      field.length = field.text.size();
      field.width = is_large || field.length > 8 ? 16 : 8;
      field.form = Number_place::Form::NASTRAN_FREE;
      result.push_back(field);
    }
    return result;
  }

  // Columns, with tabs as far as the next field.
  static std::vector<Field> columns(std::string_view line, std::size_t begin, bool& is_large)
  {
    is_large = line[0] == '*' ||
               trimmed(line.substr(0, std::min<std::size_t>(8, line.find('\t')))).find('*') != std::string_view::npos;
    const std::size_t width = is_large ? 16 : 8;
    const bool has_tabs = line.find('\t') != std::string_view::npos;
    std::vector<Field> result(is_large ? 5 : 9);
    std::size_t column = 0;
    std::size_t reached = 0; // fields that have begun
    for (std::size_t i = 0; i <= line.size(); ++i) {
      const std::size_t f = column < 8 ? 0 : 1 + (column - 8) / width;
      for (; reached <= std::min(f, result.size() - 1); ++reached) {
        result[reached].begin = begin + i;
        result[reached].width = static_cast<std::uint8_t>(has_tabs ? width - 1 : width);
      }
      if (i == line.size())
        break;
      if (line[i] == '\t') {
        column = (column / 8 + 1) * 8;
        continue;
      }
      if (f < result.size()) {
        if (result[f].length == 0)
          result[f].begin = begin + i;
        result[f].length = begin + i + 1 - result[f].begin;
      }
      ++column;
    }
    for (Field& field : result) {
      if (field.width > 0)
        field.text = trimmed(line.substr(field.begin - begin, field.length));
      if (has_tabs) { // nothing around it is changed
        if (!field.text.empty())
          field.begin = begin + static_cast<std::size_t>(field.text.data() - line.data());
        field.length = field.text.size();
        field.form = Number_place::Form::NASTRAN_FREE;
      }
    }
    return result;
  }

  std::int64_t integer(std::size_t field, std::int64_t otherwise = 0) const
  {
    if (field >= card_.fields.size() || card_.fields[field].text.empty())
      return otherwise;
    std::int64_t value = 0;
    if (!parse_number(card_.fields[field].text, value))
      fail("an integer is expected in " + card_.name + ", not \"" + Text_scanner::printable(card_.fields[field].text) +
           '"');
    return value;
  }

  double real(std::size_t field) const
  {
    double value = 0;
    if (field < card_.fields.size() && (!parse_solver_number(card_.fields[field].text, value) || !std::isfinite(value)))
      fail("a number is expected in " + card_.name + ", not \"" + Text_scanner::printable(card_.fields[field].text) +
           '"');
    return value;
  }

  [[noreturn]] void fail(const std::string& reason) const { places_->files[card_.file].fail(card_.line, reason); }

  void end_card()
  {
    if (card_.name.empty())
      return;
    const std::string name = card_.name;
    if (name == "GRID")
      add_grid();
    else if (name == "GRDSET")
      default_system_ = integer(1);
    else if (name == "CHEXA")
      add_element(Cell_kind::HEXAHEDRON, 12, 2, 20);
    else if (name == "CTETRA")
      add_element(Cell_kind::SOLID, 10, 2, 10);
    else if (name == "CPENTA")
      add_element(Cell_kind::SOLID, 13, 2, 15);
    else if (name == "CPYRAM" || name == "CPYRA")
      add_element(Cell_kind::SOLID, 14, 2, 13);
    else if (name == "CQUAD4" || name == "CQUADR")
      add_element(Cell_kind::OTHER, 9, 2, 4);
    else if (name == "CTRIA3" || name == "CTRIAR")
      add_element(Cell_kind::OTHER, 5, 2, 3);
    else if (name == "CROD" || name == "CBAR" || name == "CBEAM")
      add_element(Cell_kind::OTHER, 3, 2, 2);
    else if (name.compare(0, 5, "CORD2") == 0 || name.compare(0, 5, "CORD1") == 0)
      add_system();
    else if (name == "SPC1" || name == "SPC" || name == "SET1")
      add_set();
    card_.name.clear();
  }

  void add_grid()
  {
    const std::int64_t number = integer(0);
    std::array<Number_place, 3> places;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = real(2 + i);
      if (2 + i >= card_.fields.size())
        continue;
      const Field& field = card_.fields[2 + i];
      if (field.width == 0)
        continue;
      places[i].file = static_cast<std::uint16_t>(card_.file);
      places[i].begin = field.begin;
      places[i].length = static_cast<std::uint32_t>(field.length);
      places[i].width = field.width;
      places[i].form = field.form;
    }
    point_of_[number] = mesh_.points.size();
    mesh_.points.push_back(point);
    places_->places.push_back(places);
    const bool is_given = card_.fields.size() > 1 && !card_.fields[1].text.empty();
    grids_.push_back({number, is_given ? integer(1) : -1});
  }

  void add_element(Cell_kind kind, int vtk_type, std::size_t first, std::size_t most)
  {
    Element element{kind, vtk_type, integer(0), integer(1), {}, card_.file, card_.line};
    if (card_.fields.size() > 1 && card_.fields[1].text.empty())
      element.property = element.number;
    for (std::size_t i = first; i < std::min(first + most, card_.fields.size()); ++i)
      element.nodes.push_back(integer(i));
    while (!element.nodes.empty() && element.nodes.back() == 0)
      element.nodes.pop_back();
    if (kind == Cell_kind::HEXAHEDRON && element.nodes.size() < 8)
      fail("CHEXA " + std::to_string(element.number) + " has fewer than eight nodes");
    elements_.push_back(std::move(element));
  }

  void add_system()
  {
    const char letter = card_.name.back();
    System system;
    system.kind = letter == 'C'   ? Coordinate_frame::Kind::CYLINDRICAL
                  : letter == 'S' ? Coordinate_frame::Kind::SPHERICAL
                                  : Coordinate_frame::Kind::RECTANGULAR;
    if (card_.name[4] == '1') {
      for (std::size_t half = 0; half < 8; half += 4)
        if (half < card_.fields.size() && !card_.fields[half].text.empty()) {
          system.nodes = {integer(half + 1), integer(half + 2), integer(half + 3)};
          systems_[integer(half)] = system;
        }
      return;
    }
    system.reference = integer(1);
    for (std::size_t i = 0; i < 9; ++i)
      system.points[i] = real(2 + i);
    systems_[integer(0)] = system;
  }

  void add_set()
  {
    std::vector<std::int64_t>& numbers = sets_[(card_.name == "SET1" ? "SET1 " : "SPC ") + std::to_string(integer(0))];
    if (card_.name == "SPC") {
      for (std::size_t i : {std::size_t(1), std::size_t(4)})
        if (integer(i) > 0)
          numbers.push_back(integer(i));
      return;
    }
    for (std::size_t i = card_.name == "SPC1" ? 2 : 1; i < card_.fields.size(); ++i) {
      const std::string_view text = card_.fields[i].text;
      if (starts_with(text, "thru") && i + 1 < card_.fields.size() && !numbers.empty()) {
        const std::int64_t last = integer(++i); // points may come later
        thru_.push_back({&numbers, {numbers.back(), last}});
      }
      else if (!text.empty() && (text[0] >= '0' && text[0] <= '9'))
        numbers.push_back(integer(i));
    }
  }

  // Coordinates of one rectangular system are as good as those of the basic one.
  void place_points()
  {
    bool is_one = true;
    std::vector<std::int64_t> system(grids_.size());
    for (std::size_t v = 0; v < grids_.size(); ++v) {
      system[v] = grids_[v].system < 0 ? default_system_ : grids_[v].system;
      is_one = is_one && system[v] == system[0];
    }
    if (grids_.empty() || (is_one && (system[0] == 0 || systems_.count(system[0]) == 0 ||
                                      systems_[system[0]].kind == Coordinate_frame::Kind::RECTANGULAR)))
      return;
    raw_ = mesh_.points;
    places_->frame_of.resize(grids_.size());
    for (std::size_t v = 0; v < grids_.size(); ++v) {
      const std::int32_t f = frame(system[v], 0);
      places_->frame_of[v] = f;
      if (f >= 0)
        mesh_.points[v] = places_->frames[static_cast<std::size_t>(f)].to_basic(raw_[v]);
    }
  }

  // Its number among the frames of the places; -1 for the basic system.
  std::int32_t frame(std::int64_t number, int depth)
  {
    if (number <= 0)
      return -1;
    const auto known = frames_.find(number);
    if (known != frames_.end())
      return known->second;
    const auto found = systems_.find(number);
    if (found == systems_.end() || depth > 100) {
      mesh_.notes.push_back("coordinate system " + std::to_string(number) + " is not defined: taken as the basic one");
      return frames_[number] = -1;
    }
    const System& system = found->second;
    std::array<std::array<double, 3>, 3> p{};
    if (system.nodes.empty()) {
      const std::int32_t reference = frame(system.reference, depth + 1);
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = {{system.points[3 * i], system.points[3 * i + 1], system.points[3 * i + 2]}};
        if (reference >= 0)
          p[i] = places_->frames[static_cast<std::size_t>(reference)].to_basic(p[i]);
      }
    }
    else
      for (std::size_t i = 0; i < 3; ++i) {
        const auto node = point_of_.find(system.nodes[i]);
        if (node == point_of_.end())
          continue;
        mesh_.held.push_back(node->second); // else the system would turn
        const std::int64_t of_node = grids_[node->second].system < 0 ? default_system_ : grids_[node->second].system;
        const std::int32_t reference = frame(of_node, depth + 1);
        p[i] = raw_[node->second];
        if (reference >= 0)
          p[i] = places_->frames[static_cast<std::size_t>(reference)].to_basic(p[i]);
      }
    const Coordinate_frame result(system.kind, p[0], p[1], p[2]);
    if (result.is_degenerate())
      throw CGAL::IO::Hex_mesh_file_error(places_->files[0].filename, 0,
                                          "coordinate system " + std::to_string(number) + " has no axes");
    places_->frames.push_back(result);
    return frames_[number] = static_cast<std::int32_t>(places_->frames.size() - 1);
  }

  void add_cells()
  {
    for (const auto& [number, system] : systems_) // also where displacements refer to it
      for (std::int64_t node : system.nodes)
        if (point_of_.count(node) > 0)
          mesh_.held.push_back(point_of_[node]);
    for (const Element& element : elements_) {
      std::vector<std::size_t> nodes;
      for (std::size_t i = 0; i < element.nodes.size(); ++i) {
        const auto found = point_of_.find(element.nodes[i]);
        if (found != point_of_.end())
          nodes.push_back(found->second);
        else if (element.nodes[i] == 0 && i >= 8 && element.kind == Cell_kind::HEXAHEDRON)
          nodes.push_back(nodes[0]); // left out
        else if (element.kind == Cell_kind::HEXAHEDRON)
          places_->files[element.file].fail(element.line,
                                            "CHEXA " + std::to_string(element.number) + " refers to grid point " +
                                              std::to_string(element.nodes[i]) + ", which does not exist");
      }
      if (element.kind == Cell_kind::HEXAHEDRON && nodes.size() > 8)
        nodes.resize(20, nodes[0]);
      static const std::map<int, std::size_t> corners = {{10, 4}, {13, 6}, {14, 5}, {9, 4}, {5, 3}, {3, 2}, {12, 0}};
      const bool is_plain = nodes.size() == corners.at(element.vtk_type) || element.kind == Cell_kind::HEXAHEDRON;
      const std::size_t cell = mesh_.add_cell(element.kind, is_plain ? element.vtk_type : 0, element.property, nodes);
      by_property_[element.property].push_back(cell);
    }
  }

  void add_sets()
  {
    using Kind = CGAL::IO::Hex_mesh_set::Kind;
    for (const auto& [numbers, range] : thru_)
      for (auto it = point_of_.lower_bound(range.first + 1); it != point_of_.end() && it->first <= range.second; ++it)
        numbers->push_back(it->first);
    for (const auto& [name, numbers] : sets_) {
      CGAL::IO::Hex_mesh_set& set = mesh_.add_set(Kind::VERTICES, name);
      for (std::int64_t number : numbers)
        if (point_of_.count(number) > 0)
          set.vertices.push_back(point_of_[number]);
    }
    for (const auto& [property, cells] : by_property_) {
      mesh_.label_names[property] = "property " + std::to_string(property);
      mesh_.add_set_of_cells("property " + std::to_string(property), cells);
    }
  }

  static constexpr std::size_t most_files = 2000;

  std::shared_ptr<Number_places> places_;
  Solver_mesh mesh_;
  Card card_;
  bool is_ended_ = false;
  std::int64_t default_system_ = 0;
  std::map<std::int64_t, std::size_t> point_of_;
  std::vector<Point> grids_;
  std::vector<Element> elements_;
  std::map<std::int64_t, System> systems_;
  std::map<std::int64_t, std::int32_t> frames_;
  std::vector<std::array<double, 3>> raw_;
  std::map<std::string, std::vector<std::int64_t>> sets_;
  std::vector<std::pair<std::vector<std::int64_t>*, std::pair<std::int64_t, std::int64_t>>> thru_;
  std::map<std::int64_t, std::vector<std::size_t>> by_property_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_NASTRAN_READER_H
