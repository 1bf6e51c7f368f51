// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ABAQUS_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ABAQUS_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads an input file of Abaqus or CalculiX, with the files that it includes.

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

class Abaqus_reader
{
public:
  explicit Abaqus_reader(const std::string& filename) : places_(std::make_shared<Number_places>())
  {
    places_->files.emplace_back(filename, std::filesystem::path(filename).filename().string());
  }

  CGAL::IO::Hex_mesh_file read()
  {
    mesh_.format = "Abaqus/CalculiX";
    scope_ = &scopes_[std::string()];
    read_file(0, 0);
    end_block();
    finish_sets();
    label_cells();
    return mesh_.finish(places_);
  }

private:
  static constexpr int most_digits = 20; // that CalculiX and Abaqus read of a number

  enum class Block { NONE, NODE, ELEMENT, NSET, ELSET, SURFACE, SYSTEM, IGNORED };

  using Parameters = std::map<std::string, std::string>; // in lower case, and as they are

  struct Set
  {
    std::string name; // as first written
    std::vector<std::size_t> members;
  };

  // The names of a part or an instance.
  struct Scope
  {
    std::unordered_map<std::int64_t, std::size_t> points, cells;
    std::map<std::string, Set> point_sets, cell_sets;
    std::vector<std::array<std::string, 2>> sections; // set, material
  };

  struct Surface
  {
    std::string name;
    bool is_of_nodes = false;
    std::vector<std::array<std::size_t, 4>> faces;
    std::vector<std::size_t> vertices;
  };

  // The line at `position`, which moves behind it.
  static std::string_view next_line(std::string_view text, std::size_t& position)
  {
    const std::size_t begin = position, end = std::min(text.find('\n', begin), text.size());
    position = std::min(end + 1, text.size());
    std::string_view line = text.substr(begin, end - begin);
    if (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  // `f`: the file, `depth`: of files that include each other
  void read_file(std::size_t f, int depth)
  {
    std::size_t position = 0;
    while (position < places_->files[f].content.size()) {
      file_ = f;
      line_ = position;
      const std::string_view line = next_line(places_->files[f].content, position);
      const std::string_view text = trimmed(line);
      if (text.empty() || text.substr(0, 2) == "**")
        continue;
      if (text[0] != '*') {
        read_data(line);
        continue;
      }
      std::string keyword(text);
      while (!keyword.empty() && keyword.back() == ',' && position < places_->files[f].content.size())
        keyword += trimmed(next_line(places_->files[f].content, position));
      const std::string included = read_keyword(keyword);
      if (!included.empty())
        include(included, f, depth);
    }
  }

  void include(const std::string& name, std::size_t from, int depth)
  {
    namespace fs = std::filesystem;
    if (depth > 20)
      fail("files include each other");
    const fs::path relative = fs::path(name).is_absolute() ? fs::path(name) : fs::path(name).lexically_normal();
    // Included names are relative to the folder of the first file; some programs write them relative to the including one.
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
    if (places_->files.size() > 60000)
      fail("too many files are included");
    places_->files.emplace_back(path.string(), known.string());
    read_file(places_->files.size() - 1, depth + 1);
  }

  // Returns the name of a file that is to be read now.
  std::string read_keyword(const std::string& line)
  {
    const std::vector<std::string_view> fields = split(line, ',');
    std::string keyword;
    for (char c : lowered(std::string(fields[0])))
      if (c != ' ' && c != '\t')
        keyword += c;
    Parameters parameters;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const std::size_t equals = fields[i].find('=');
      std::string name;
      for (char c : lowered(std::string(fields[i].substr(0, equals))))
        if (c != ' ' && c != '\t')
          name += c;
      parameters[name] = equals == std::string_view::npos ? std::string()
                                                          : unquoted(trimmed(fields[i].substr(equals + 1)));
    }
    if (keyword == "*include")
      return parameters["input"]; // the block goes on
    end_block();
    begin_block(keyword, parameters);
    return block_ == Block::NONE || block_ == Block::IGNORED ? std::string() : parameters["input"];
  }

  void begin_block(const std::string& keyword, Parameters& parameters)
  {
    block_ = Block::IGNORED;
    for (const char* generates : {"*ngen", "*nfill", "*ncopy", "*nmap", "*elgen", "*elcopy"})
      if (keyword == generates)
        fail(keyword + " makes nodes or elements that do not stand in the file: this is not supported");
    if (keyword == "*node")
      begin_nodes(parameters);
    else if (keyword == "*element")
      begin_elements(parameters);
    else if (keyword == "*nset" || keyword == "*elset") {
      block_ = keyword == "*nset" ? Block::NSET : Block::ELSET;
      const std::string name = parameters[keyword.substr(1)];
      is_generated_ = parameters.count("generate") > 0;
      instance_ = parameters.count("instance") > 0 ? scope_of_instance(parameters["instance"]) : scope_;
      set_ = &named(block_ == Block::NSET ? scope_->point_sets : scope_->cell_sets, name);
      if (block_ == Block::NSET && parameters.count("elset") > 0)
        add_points_of_cells(parameters["elset"]);
    }
    else if (keyword == "*surface") {
      block_ = Block::SURFACE;
      surfaces_.emplace_back();
      surfaces_.back().name = parameters["name"];
      surfaces_.back().is_of_nodes = lowered(parameters["type"]) == "node";
    }
    else if (keyword == "*solidsection")
      scope_->sections.push_back({{lowered(parameters["elset"]), parameters["material"]}});
    else if (keyword == "*system") {
      block_ = Block::SYSTEM;
      system_ = -1;
      system_numbers_.clear();
    }
    else
      change_scope(keyword, parameters);
  }

  void change_scope(const std::string& keyword, Parameters& parameters)
  {
    if (keyword == "*part")
      scope_ = &scopes_["part " + lowered(parameters["name"])];
    else if (keyword == "*instance") {
      const std::string instance = lowered(parameters["name"]);
      part_of_instance_[instance] = lowered(parameters["part"]);
      scope_ = &scopes_["instance " + instance];
    }
    else if (keyword == "*endpart" || keyword == "*endinstance" || keyword == "*assembly")
      scope_ = &scopes_[std::string()];
    if (scope_ != system_scope_) {
      system_scope_ = scope_;
      system_ = -1;
    }
  }

  // The nodes of an instance are its own, or those of its part.
  Scope* scope_of_instance(const std::string& name)
  {
    const std::string instance = lowered(name);
    Scope& own = scopes_["instance " + instance];
    Scope& of_part = scopes_["part " + part_of_instance_[instance]];
    return !own.points.empty() ? &own : !of_part.points.empty() ? &of_part : &scopes_[std::string()];
  }

  void begin_nodes(Parameters& parameters)
  {
    block_ = Block::NODE;
    set_ = parameters.count("nset") > 0 ? &named(scope_->point_sets, parameters["nset"]) : nullptr;
    const std::string system = lowered(parameters["system"]);
    node_frame_ = system_;
    if (system == "c" || system == "s") {
      const auto kind = system == "c" ? Coordinate_frame::Kind::CYLINDRICAL : Coordinate_frame::Kind::SPHERICAL;
      node_frame_ = add_frame(Coordinate_frame(kind, {{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}));
    }
  }

  std::int32_t add_frame(const Coordinate_frame& frame)
  {
    if (frame.is_degenerate())
      fail("the coordinate system has no axes");
    places_->frames.push_back(frame);
    return static_cast<std::int32_t>(places_->frames.size() - 1);
  }

  void begin_elements(Parameters& parameters)
  {
    block_ = Block::ELEMENT;
    std::string type;
    for (char c : parameters["type"])
      if (c != ' ' && c != '\t')
        type += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    set_ = parameters.count("elset") > 0 ? &named(scope_->cell_sets, parameters["elset"]) : nullptr;
    classify(type);
    record_.clear();
  }

  // What the name of a type says: the kind of its elements, and how many nodes they have, or 0 where that is unknown.
  void classify(const std::string& type)
  {
    kind_ = Cell_kind::SOLID;
    number_of_nodes_ = 0;
    vtk_type_ = 0;
    const std::size_t solid = type.find("3D");
    const std::string prefix = type.substr(0, solid);
    std::size_t digits = solid == std::string::npos ? 0 : solid + 2;
    while (solid != std::string::npos && digits < type.size() && type[digits] >= '0' && type[digits] <= '9')
      number_of_nodes_ = number_of_nodes_ * 10 + static_cast<std::size_t>(type[digits++] - '0');
    for (const char* of_hexahedra : {"C", "DC", "AC", "F", "FC", "Q", "EC", "EMC", "EDC"})
      if (prefix == of_hexahedra && (number_of_nodes_ == 8 || number_of_nodes_ == 20 || number_of_nodes_ == 27)) {
        kind_ = Cell_kind::HEXAHEDRON;
        vtk_type_ = 12;
        return;
      }
    for (const char* of_lower :
         {"T3D",   "B2",   "B3",   "U1",   "S3",     "S4",      "S6",      "S8",     "S9",  "STRI", "M3D",
          "R3D",   "SFM",  "DS",   "CONN", "SPRING", "DASHPOT", "MASS",    "ROTARY", "GAP", "PIPE", "ELBOW",
          "FRAME", "CPS",  "CPE",  "CAX",  "AX",     "ITT",     "DCOUP",   "RAX",    "RB",  "D",    "MCL",
          "SAX",   "F3D2", "F3D3", "F3D4", "F2D",    "AC2D",    "HEATCAP", "POINT"})
      if (type.compare(0, std::string(of_lower).size(), of_lower) == 0 &&
          !(type[0] == 'D' && type.compare(0, 4, "DC3D") == 0))
        kind_ = Cell_kind::OTHER;
    if (kind_ == Cell_kind::SOLID && solid != std::string::npos)
      vtk_type_ = number_of_nodes_ == 4 ? 10 : number_of_nodes_ == 5 ? 14 : number_of_nodes_ == 6 ? 13 : 0;
    else
      classify_shell(type);
  }

  void classify_shell(const std::string& type)
  {
    if (type.compare(0, 2, "S4") == 0 || type.compare(0, 4, "R3D4") == 0 || type.compare(0, 4, "M3D4") == 0)
      vtk_type_ = 9, number_of_nodes_ = 4;
    else if (type.compare(0, 2, "S3") == 0 || type.compare(0, 4, "R3D3") == 0 || type.compare(0, 4, "M3D3") == 0)
      vtk_type_ = 5, number_of_nodes_ = 3;
    else if (type.compare(0, 2, "S8") == 0)
      vtk_type_ = 23, number_of_nodes_ = 8;
    else if (type.compare(0, 4, "T3D2") == 0 || type.compare(0, 3, "B31") == 0)
      vtk_type_ = 3, number_of_nodes_ = 2;
    else if (vtk_type_ == 0)
      number_of_nodes_ = kind_ == Cell_kind::OTHER ? 0 : number_of_nodes_;
  }

  void read_data(std::string_view line)
  {
    switch (block_) {
    case Block::NODE:
      return read_node(line);
    case Block::ELEMENT:
      return read_element(line);
    case Block::NSET:
    case Block::ELSET:
      return read_members(line);
    case Block::SURFACE:
      return read_surface(line);
    case Block::SYSTEM:
      for (const std::string_view field : split(line, ',')) {
        double value = 0;
        if (!parse_solver_number(field, value))
          fail("a coordinate is expected, not \"" + printable(field) + "\"");
        system_numbers_.push_back(value);
      }
      return;
    default:
      return;
    }
  }

  void read_node(std::string_view line)
  {
    const std::vector<std::string_view> fields = split(line, ',');
    std::int64_t number = 0;
    if (!parse_number(trimmed(fields[0]), number))
      fail("the number of a node is expected, not \"" + printable(fields[0]) + "\"");
    std::array<Number_place, 3> places;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (i + 1 >= fields.size())
        continue;
      const std::string_view field = trimmed(fields[i + 1]);
      if (!parse_solver_number(field, point[i]) || !std::isfinite(point[i]))
        fail("a coordinate of node " + std::to_string(number) + " is expected, not \"" + printable(field) + "\"");
      Number_place& place = places[i];
      place.file = static_cast<std::uint16_t>(file_);
      place.begin = static_cast<std::size_t>(field.data() - places_->files[file_].content.data());
      place.length = static_cast<std::uint32_t>(field.size());
      place.form = Number_place::Form::LIMITED;
      place.width = most_digits;
    }
    add_node(number, point, places);
  }

  void add_node(std::int64_t number, const std::array<double, 3>& point, const std::array<Number_place, 3>& places)
  {
    const std::size_t v = mesh_.points.size();
    places_->places.push_back(places);
    places_->frame_of.push_back(node_frame_);
    mesh_.points.push_back(node_frame_ < 0 ? point
                                           : places_->frames[static_cast<std::size_t>(node_frame_)].to_basic(point));
    scope_->points[number] = v;
    if (set_ != nullptr)
      set_->members.push_back(v);
  }

  void read_element(std::string_view line)
  {
    const bool continues = !trimmed(line).empty() && trimmed(line).back() == ',';
    for (const std::string_view field : split(line, ','))
      if (!trimmed(field).empty())
        record_.push_back(std::string(trimmed(field)));
    if (number_of_nodes_ > 0 ? record_.size() > number_of_nodes_ : !continues)
      end_record();
  }

  void end_record()
  {
    if (record_.empty())
      return;
    std::int64_t number = 0;
    if (!parse_number(std::string_view(record_[0]), number))
      fail("the number of an element is expected, not \"" + printable(record_[0]) + "\"");
    if (kind_ == Cell_kind::HEXAHEDRON && record_.size() < number_of_nodes_ + 1)
      fail("element " + record_[0] + " has " + std::to_string(record_.size() - 1) + " nodes, not " +
           std::to_string(number_of_nodes_));
    std::vector<std::size_t> nodes;
    for (std::size_t i = 1; i < record_.size(); ++i) {
      std::int64_t node = 0;
      const bool is_number = parse_number(std::string_view(record_[i]), node);
      const auto found = scope_->points.find(node);
      if (is_number && found != scope_->points.end())
        nodes.push_back(found->second);
      else if (kind_ == Cell_kind::HEXAHEDRON) // also where the nodes come later
        pending_.push_back({mesh_.cells.size(), i - 1, node, scope_, file_, line_}), nodes.push_back(0);
    }
    const int vtk_type = nodes.size() == number_of_nodes_ || kind_ == Cell_kind::HEXAHEDRON ? vtk_type_ : 0;
    const std::size_t cell = mesh_.add_cell(kind_, vtk_type, 0, nodes);
    scope_->cells[number] = cell;
    if (set_ != nullptr)
      set_->members.push_back(cell);
    record_.clear();
  }

  void read_members(std::string_view line)
  {
    const auto& numbers = block_ == Block::NSET ? instance_->points : instance_->cells;
    const auto& sets = block_ == Block::NSET ? instance_->point_sets : instance_->cell_sets;
    const std::vector<std::string_view> fields = split(line, ',');
    if (is_generated_) {
      std::int64_t range[3] = {0, 0, 1};
      for (std::size_t i = 0; i < 3 && i < fields.size(); ++i)
        if (!trimmed(fields[i]).empty() && !parse_number(trimmed(fields[i]), range[i]))
          fail("a number is expected, not \"" + printable(fields[i]) + "\"");
      add_range(numbers, range[0], range[1], range[2]);
      return;
    }
    for (std::string_view field : fields) {
      field = trimmed(field);
      std::int64_t number = 0;
      if (parse_number(field, number))
        add_member(numbers, number);
      else if (!field.empty()) {
        const auto other = sets.find(lowered(unquoted(field)));
        if (other != sets.end() && &other->second != set_)
          set_->members.insert(set_->members.end(), other->second.members.begin(), other->second.members.end());
      }
    }
  }

  void add_member(const std::unordered_map<std::int64_t, std::size_t>& numbers, std::int64_t number)
  {
    const auto found = numbers.find(number);
    if (found != numbers.end())
      set_->members.push_back(found->second);
  }

  // However long it is, no longer than what there is.
  void add_range(const std::unordered_map<std::int64_t, std::size_t>& numbers, std::int64_t first, std::int64_t last,
                 std::int64_t step)
  {
    constexpr std::int64_t most = std::int64_t(1) << 40;
    if (step <= 0 || first > last || first < -most || last > most)
      return;
    if ((last - first) / step < static_cast<std::int64_t>(2 * numbers.size()))
      for (std::int64_t n = first; n <= last; n += step)
        add_member(numbers, n);
    else
      for (const auto& [number, index] : numbers)
        if (number >= first && number <= last && (number - first) % step == 0)
          set_->members.push_back(index);
  }

  void add_points_of_cells(const std::string& cells)
  {
    const auto found = instance_->cell_sets.find(lowered(cells));
    if (found == instance_->cell_sets.end())
      return;
    for (std::size_t c : found->second.members)
      set_->members.insert(set_->members.end(), mesh_.nodes.begin() + static_cast<std::ptrdiff_t>(mesh_.cells[c].begin),
                           mesh_.nodes.begin() + static_cast<std::ptrdiff_t>(mesh_.cells[c].end));
  }

  // A set or an element, and a side.
  void read_surface(std::string_view line)
  {
    const std::vector<std::string_view> fields = split(line, ',');
    const std::string what = lowered(unquoted(trimmed(fields[0])));
    Surface& surface = surfaces_.back();
    std::int64_t number = 0;
    const bool is_number = parse_number(std::string_view(what), number);
    if (surface.is_of_nodes) {
      const auto set = scope_->point_sets.find(what);
      if (is_number && scope_->points.count(number) > 0)
        surface.vertices.push_back(scope_->points[number]);
      else if (set != scope_->point_sets.end())
        surface.vertices.insert(surface.vertices.end(), set->second.members.begin(), set->second.members.end());
      return;
    }
    const std::string side = fields.size() > 1 ? lowered(std::string(trimmed(fields[1]))) : std::string();
    std::vector<std::size_t> cells;
    const auto set = scope_->cell_sets.find(what);
    if (is_number && scope_->cells.count(number) > 0)
      cells.push_back(scope_->cells[number]);
    else if (set != scope_->cell_sets.end())
      cells = set->second.members;
    if (side.size() != 2 || side[0] != 's' || side[1] < '1' || side[1] > '6')
      return;
    for (std::size_t c : cells)
      if (mesh_.cells[c].kind == Cell_kind::HEXAHEDRON)
        faces_of_surfaces_.push_back({surfaces_.size() - 1, c, side[1] - '1'});
  }

  void end_block()
  {
    if (block_ == Block::ELEMENT)
      end_record();
    if (block_ == Block::SYSTEM && !system_numbers_.empty()) {
      const std::vector<double>& n = system_numbers_;
      if (n.size() < 6)
        system_ = add_frame(translated({{n[0], n.size() > 1 ? n[1] : 0., n.size() > 2 ? n[2] : 0.}}));
      else
        system_ = add_frame(rotated(n));
    }
    block_ = Block::NONE;
  }

  static Coordinate_frame translated(const std::array<double, 3>& o)
  {
    return Coordinate_frame(Coordinate_frame::Kind::RECTANGULAR, o, {{o[0], o[1], o[2] + 1}}, {{o[0] + 1, o[1], o[2]}});
  }

  // An origin, a point of the first axis, and one of the plane of the first two.
  static Coordinate_frame rotated(const std::vector<double>& n)
  {
    const std::array<double, 3> o = {{n[0], n[1], n[2]}}, x = {{n[3] - n[0], n[4] - n[1], n[5] - n[2]}};
    std::array<double, 3> p = {{n[0] - n[0], 1, 0}};
    for (std::size_t i = 6; i < std::min<std::size_t>(n.size(), 9); ++i)
      p[i - 6] = n[i] - n[i - 6];
    const std::array<double, 3> z = {{x[1] * p[2] - x[2] * p[1], x[2] * p[0] - x[0] * p[2], x[0] * p[1] - x[1] * p[0]}};
    return Coordinate_frame(Coordinate_frame::Kind::RECTANGULAR, o, {{o[0] + z[0], o[1] + z[1], o[2] + z[2]}},
                            {{n[3], n[4], n[5]}});
  }

  void finish_sets()
  {
    for (const Pending& p : pending_) {
      const auto found = p.scope->points.find(p.node);
      if (found == p.scope->points.end())
        places_->files[p.file].fail(p.line,
                                    "an element refers to node " + std::to_string(p.node) + ", which does not exist");
      mesh_.nodes[mesh_.cells[p.cell].begin + p.place] = found->second;
    }
    static const int sides[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
    for (const auto& [surface, cell, side] : faces_of_surfaces_)
      surfaces_[surface].faces.push_back(mesh_.side(cell, sides[side]));
    using Kind = CGAL::IO::Hex_mesh_set::Kind;
    for (auto& [name, scope] : scopes_) {
      for (auto& [key, set] : scope.point_sets)
        mesh_.add_set(Kind::VERTICES, set.name).vertices = set.members;
      for (auto& [key, set] : scope.cell_sets)
        mesh_.add_set_of_cells(set.name, set.members);
    }
    for (Surface& surface : surfaces_) {
      CGAL::IO::Hex_mesh_set& set = mesh_.add_set(surface.is_of_nodes ? Kind::VERTICES : Kind::FACES, surface.name);
      set.faces = std::move(surface.faces);
      set.vertices = std::move(surface.vertices);
    }
    bool has_frames = false;
    for (std::int32_t f : places_->frame_of)
      has_frames = has_frames || f >= 0;
    if (!has_frames)
      places_->frame_of.clear();
  }

  // A label for each material; a section without one has a label of its own.
  void label_cells()
  {
    std::map<std::string, std::int64_t> labels;
    for (auto& [name, scope] : scopes_)
      for (const auto& [set, material] : scope.sections) {
        const auto found = scope.cell_sets.find(set);
        if (found == scope.cell_sets.end())
          continue;
        const std::string title = material.empty() ? found->second.name : material;
        const std::int64_t label =
          labels.emplace(lowered(title), static_cast<std::int64_t>(labels.size()) + 1).first->second;
        mesh_.label_names[label] = title;
        for (std::size_t c : found->second.members)
          mesh_.cells[c].label = label;
      }
  }

  static Set& named(std::map<std::string, Set>& sets, const std::string& name)
  {
    Set& set = sets[lowered(name)];
    if (set.name.empty())
      set.name = name;
    return set;
  }

  static std::string printable(std::string_view word) { return Text_scanner::printable(trimmed(word)); }

  [[noreturn]] void fail(const std::string& reason) const { places_->files[file_].fail(line_, reason); }

  struct Pending // a node of a hexahedron that comes after it
  {
    std::size_t cell, place;
    std::int64_t node;
    Scope* scope;
    std::size_t file, line;
  };

  struct Face_of_surface
  {
    std::size_t surface, cell;
    int side;
  };

  std::shared_ptr<Number_places> places_;
  Solver_mesh mesh_;
  std::map<std::string, Scope> scopes_;
  std::map<std::string, std::string> part_of_instance_;
  std::vector<Surface> surfaces_;
  std::vector<Face_of_surface> faces_of_surfaces_;
  std::vector<Pending> pending_;
  Scope* scope_ = nullptr;

  std::size_t file_ = 0, line_ = 0;
  Block block_ = Block::NONE;
  Set* set_ = nullptr;
  Scope* instance_ = nullptr;
  Scope* system_scope_ = nullptr;
  bool is_generated_ = false;
  Cell_kind kind_ = Cell_kind::OTHER;
  int vtk_type_ = 0;
  std::size_t number_of_nodes_ = 0;
  std::vector<std::string> record_;
  std::int32_t system_ = -1, node_frame_ = -1;
  std::vector<double> system_numbers_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_ABAQUS_READER_H
