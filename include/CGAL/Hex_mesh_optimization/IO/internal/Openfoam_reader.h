// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OPENFOAM_READER_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OPENFOAM_READER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Reads the meshes of a case of OpenFOAM: all of its regions and, where it is decomposed, its parts.

#include <CGAL/Hex_mesh_optimization/IO/internal/Foam_scanner.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Number_places.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Solver_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Openfoam_reader
{
public:
  explicit Openfoam_reader(const std::string& folder) : folder_(folder), places_(std::make_shared<Number_places>())
  {
    places_->folder = folder;
  }

  CGAL::IO::Hex_mesh_file read()
  {
    const std::vector<std::filesystem::path> meshes = find_meshes();
    if (meshes.empty())
      throw CGAL::IO::Hex_mesh_file_error(
        folder_, 0, "the folder is no case of OpenFOAM: there is no constant/polyMesh with faces");
    mesh_.format = "OpenFOAM";
    for (const std::filesystem::path& mesh : meshes)
      read_mesh(mesh);
    note_moved_points();
    return mesh_.finish(places_);
  }

private:
  using Path = std::filesystem::path;
  using Faces = std::vector<std::vector<std::int64_t>>;

  struct Patch
  {
    std::string name, type;
    std::int64_t first = 0, size = 0;
  };

  // With the ending .gz where it is compressed; empty if there is none.
  static Path file_in(const Path& folder, const char* name)
  {
    std::error_code ignored;
    for (const char* ending : {"", ".gz"})
      if (std::filesystem::is_regular_file(folder / (std::string(name) + ending), ignored))
        return folder / (std::string(name) + ending);
    return Path();
  }

  static bool is_mesh(const Path& folder)
  {
    return !file_in(folder, "points").empty() && !file_in(folder, "faces").empty() && !file_in(folder, "owner").empty();
  }

  static std::vector<Path> folders_in(const Path& folder)
  {
    std::vector<Path> result;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
      if (entry.is_directory(error))
        result.push_back(entry.path());
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<Path> find_meshes() const
  {
    std::vector<Path> result;
    const Path folder(folder_);
    if (is_mesh(folder))
      result.push_back(folder);
    std::vector<Path> cases(1, folder);
    for (const Path& part : folders_in(folder))
      if (part.filename().string().compare(0, 9, "processor") == 0)
        cases.push_back(part);
    for (const Path& one : cases)
      for (const Path& time : folders_in(one)) {
        if (is_mesh(time / "polyMesh"))
          result.push_back(time / "polyMesh");
        for (const Path& region : folders_in(time))
          if (region.filename() != "polyMesh" && is_mesh(region / "polyMesh"))
            result.push_back(region / "polyMesh");
      }
    return result;
  }

  // Those of another time without faces of their own.
  void note_moved_points()
  {
    for (const Path& time : folders_in(folder_)) {
      const Path mesh = time / "polyMesh";
      if (!file_in(mesh, "points").empty() && !is_mesh(mesh))
        mesh_.notes.push_back("the points of time " + time.filename().string() + " stay as they are");
    }
  }

  Source_file read_file(const Path& folder, const char* name) const
  {
    const Path path = file_in(folder, name);
    if (path.empty())
      throw CGAL::IO::Hex_mesh_file_error((folder / name).string(), 0, "cannot open the file for reading");
    return Source_file(path.string(), path.lexically_relative(folder_).string());
  }

  void read_mesh(const Path& folder)
  {
    first_point_ = mesh_.points.size();
    first_cell_ = mesh_.cells.size();
    if (places_->files.size() >= 60000)
      throw CGAL::IO::Hex_mesh_file_error(folder_, 0, "the case has too many meshes");
    places_->files.push_back(read_file(folder, "points"));
    read_points(places_->files.size() - 1);

    const Source_file faces_file = read_file(folder, "faces"), owner_file = read_file(folder, "owner");
    Foam_scanner of_faces(faces_file), of_owner(owner_file);
    const Faces faces = of_faces.faces();
    const std::vector<std::int64_t> owner = of_owner.labels();
    std::vector<std::int64_t> neighbor;
    if (!file_in(folder, "neighbour").empty()) {
      const Source_file neighbor_file = read_file(folder, "neighbour");
      neighbor = Foam_scanner(neighbor_file).labels();
    }
    check(faces, owner, neighbor, of_faces, of_owner);
    const std::string region = region_of(folder);
    add_cells(faces, owner, neighbor);
    if (!file_in(folder, "boundary").empty())
      add_patches(faces, read_file(folder, "boundary"), region);
    tie_plane_case();
    for (const char* zones : {"cellZones", "faceZones", "pointZones"})
      if (!file_in(folder, zones).empty())
        add_zones(zones, faces, read_file(folder, zones), region);
  }

  // What tells the names of several meshes apart.
  std::string region_of(const Path& folder) const
  {
    const std::string relative = folder.parent_path().lexically_relative(folder_).string();
    return relative == "constant" || relative == "." || relative == ".." || relative.empty() ? std::string()
                                                                                             : relative + "/";
  }

  void read_points(std::size_t f)
  {
    const Source_file& file = places_->files[f];
    Foam_scanner scanner(file);
    const std::size_t n = scanner.count(scanner.is_binary() ? 3 * scanner.scalar_size() : 5);
    if (n == 0)
      return;
    scanner.expect('(');
    using Form = Number_place::Form;
    const Form binary = scanner.scalar_size() == 8 ? (scanner.is_big() ? Form::BIG_DOUBLE : Form::LITTLE_DOUBLE)
                                                   : (scanner.is_big() ? Form::BIG_FLOAT : Form::LITTLE_FLOAT);
    for (std::size_t v = 0; v < n; ++v) {
      std::array<Number_place, 3> places;
      std::array<double, 3> point{};
      if (!scanner.is_binary())
        scanner.expect('(');
      for (std::size_t i = 0; i < 3; ++i) {
        places[i].file = static_cast<std::uint16_t>(f);
        places[i].form = scanner.is_binary() ? binary : Form::FREE;
        bool is_number = true;
        if (scanner.is_binary()) {
          places[i].begin = scanner.position();
          scanner.skip(scanner.scalar_size());
          places[i].length = static_cast<std::uint32_t>(scanner.scalar_size());
          point[i] = binary_value(&file.content[places[i].begin], binary);
        }
        else {
          const std::string_view word = scanner.number_word();
          places[i].begin = static_cast<std::size_t>(word.data() - file.content.data());
          places[i].length = static_cast<std::uint32_t>(word.size());
          is_number = parse_number(word, point[i]);
        }
        if (!is_number || !std::isfinite(point[i]))
          scanner.fail("point " + std::to_string(v) + " has no finite coordinates");
      }
      if (!scanner.is_binary())
        scanner.expect(')');
      mesh_.points.push_back(point);
      places_->places.push_back(places);
    }
    scanner.expect(')');
  }

  void check(const Faces& faces, const std::vector<std::int64_t>& owner, const std::vector<std::int64_t>& neighbor,
             const Foam_scanner& of_faces, const Foam_scanner& of_owner) const
  {
    const auto number = static_cast<std::int64_t>(mesh_.points.size() - first_point_);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::int64_t v : faces[f])
        if (v < 0 || v >= number)
          of_faces.fail("face " + std::to_string(f) + " refers to point " + std::to_string(v) +
                        ", which does not exist");
    if (owner.size() != faces.size() || neighbor.size() > faces.size())
      of_owner.fail("there are " + std::to_string(owner.size()) + " owners of " + std::to_string(faces.size()) +
                    " faces");
    for (const auto* cells : {&owner, &neighbor})
      for (std::int64_t c : *cells)
        if (c >= static_cast<std::int64_t>(faces.size()))
          of_owner.fail("a face belongs to cell " + std::to_string(c) + ", more than there can be");
  }

  void add_cells(const Faces& faces, const std::vector<std::int64_t>& owner, const std::vector<std::int64_t>& neighbor)
  {
    std::vector<std::vector<std::size_t>> sides; // of cells: twice the face, and 1 more for the neighbor
    const auto add = [&](std::int64_t cell, std::size_t side) {
      if (cell < 0)
        return;
      if (sides.size() <= static_cast<std::size_t>(cell))
        sides.resize(static_cast<std::size_t>(cell) + 1);
      sides[static_cast<std::size_t>(cell)].push_back(side);
    };
    for (std::size_t f = 0; f < faces.size(); ++f) {
      add(owner[f], 2 * f);
      if (f < neighbor.size())
        add(neighbor[f], 2 * f + 1);
    }
    for (const std::vector<std::size_t>& of_cell : sides) {
      std::vector<std::size_t> nodes = hexahedron(faces, of_cell);
      const bool is_hexahedron = !nodes.empty();
      if (!is_hexahedron) {
        for (std::size_t side : of_cell)
          for (std::int64_t v : faces[side / 2])
            nodes.push_back(first_point_ + static_cast<std::size_t>(v));
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      }
      mesh_.add_cell(is_hexahedron ? Cell_kind::HEXAHEDRON : Cell_kind::SOLID, is_hexahedron ? 12 : 0, 0, nodes);
    }
  }

  // The corners in the order of VTK; none if the cell is no hexahedron.
  std::vector<std::size_t> hexahedron(const Faces& faces, const std::vector<std::size_t>& sides) const
  {
    std::vector<std::size_t> result;
    if (sides.size() != 6)
      return result;
    for (std::size_t side : sides)
      if (faces[side / 2].size() != 4)
        return result;
    std::vector<std::int64_t> bottom = faces[sides[0] / 2];
    if (sides[0] % 2 == 0) // it is seen from outside
      std::reverse(bottom.begin(), bottom.end());
    std::vector<std::int64_t> top;
    for (std::int64_t corner : bottom) {
      std::int64_t above = -1;
      for (std::size_t i = 1; i < 6; ++i) {
        const std::vector<std::int64_t>& face = faces[sides[i] / 2];
        for (std::size_t k = 0; k < 4; ++k)
          if (face[k] == corner)
            for (std::int64_t next : {face[(k + 1) % 4], face[(k + 3) % 4]})
              if (std::find(bottom.begin(), bottom.end(), next) == bottom.end()) {
                if (above >= 0 && above != next)
                  return result;
                above = next;
              }
      }
      if (above < 0)
        return result;
      top.push_back(above);
    }
    std::vector<std::int64_t> all = bottom;
    all.insert(all.end(), top.begin(), top.end());
    std::vector<std::int64_t> of_faces;
    for (std::size_t side : sides)
      of_faces.insert(of_faces.end(), faces[side / 2].begin(), faces[side / 2].end());
    for (std::int64_t v : of_faces)
      if (std::find(all.begin(), all.end(), v) == all.end())
        return result;
    for (std::int64_t v : all)
      result.push_back(first_point_ + static_cast<std::size_t>(v));
    return result;
  }

  void add_patches(const Faces& faces, const Source_file& file, const std::string& region)
  {
    Foam_scanner scanner(file);
    const std::int64_t n = scanner.label();
    if (n <= 0)
      return;
    scanner.expect('(');
    for (std::int64_t p = 0; p < n; ++p) {
      Patch patch;
      patch.name = scanner.word();
      scanner.expect('{');
      while (!scanner.accepts('}')) {
        const std::string key = scanner.word();
        if (key == "nFaces")
          patch.size = scanner.label();
        else if (key == "startFace")
          patch.first = scanner.label();
        else if (key == "type")
          patch.type = scanner.word();
        skip_entry(scanner);
      }
      if (patch.first < 0 || patch.size < 0 || patch.first > static_cast<std::int64_t>(faces.size()) - patch.size)
        scanner.fail("patch " + patch.name + " has faces that do not exist");
      std::vector<std::size_t> of_patch;
      for (std::int64_t f = patch.first; f < patch.first + patch.size; ++f)
        of_patch.push_back(static_cast<std::size_t>(f));
      add_set_of_faces(faces, region + patch.name, of_patch);
      // Points on two sides that have to match
      if (patch.type.compare(0, 6, "cyclic") == 0 || patch.type.compare(0, 9, "processor") == 0)
        mesh_.held.insert(mesh_.held.end(), mesh_.sets.back().vertices.begin(), mesh_.sets.back().vertices.end());
      if (patch.type == "empty" || patch.type == "wedge" || patch.type.compare(0, 8, "symmetry") == 0)
        mesh_.has_exact_surfaces = true;
      (patch.type == "empty" ? empty_patches_ : other_patches_).push_back(mesh_.sets.size() - 1);
    }
  }

  // The two sides of a plane case, one cell apart, move together, and its outline is held.
  void tie_plane_case()
  {
    std::set<std::array<std::size_t, 4>> sides;
    for (std::size_t s : empty_patches_)
      for (std::array<std::size_t, 4> face : mesh_.sets[s].faces) {
        std::sort(face.begin(), face.end());
        sides.insert(face);
      }
    std::set<std::array<std::size_t, 2>> tied;
    for (std::size_t c = first_cell_; c < mesh_.cells.size() && !sides.empty(); ++c)
      for (int f = 0; f < 6 && mesh_.cells[c].kind == Cell_kind::HEXAHEDRON;
           f += 2) { // opposite sides follow each other
        const std::array<std::size_t, 4> one = mesh_.side(c, hexahedron_faces[f]),
                                         other = mesh_.side(c, hexahedron_faces[f + 1]);
        std::array<std::size_t, 4> sorted_one = one, sorted_other = other;
        std::sort(sorted_one.begin(), sorted_one.end());
        std::sort(sorted_other.begin(), sorted_other.end());
        if (sides.count(sorted_one) == 0 || sides.count(sorted_other) == 0)
          continue;
        for (std::size_t i = 0; i < 4; ++i) { // they are listed in opposite directions
          const std::size_t a = one[i], b = other[(4 - i) % 4];
          tied.insert({{std::min(a, b), std::max(a, b)}});
        }
      }
    for (const auto& [a, b] : tied) {
      const std::array<double, 3>&p = mesh_.points[a], &q = mesh_.points[b];
      mesh_.periodic_pairs.push_back({a, b, {{q[0] - p[0], q[1] - p[1], q[2] - p[2]}}});
    }
    for (std::size_t s : other_patches_)
      if (!tied.empty())
        mesh_.held.insert(mesh_.held.end(), mesh_.sets[s].vertices.begin(), mesh_.sets[s].vertices.end());
    empty_patches_.clear();
    other_patches_.clear();
  }

  // The rest of an entry: up to its semicolon, or a dictionary
  static void skip_entry(Foam_scanner& scanner)
  {
    int depth = 0;
    while (true) {
      if (scanner.at_end())
        scanner.fail("';' is expected, but the file ends here");
      const char c = scanner.text()[scanner.position()];
      if (c == '}' && depth == 0)
        return;
      scanner.skip(1);
      if (c == '{' || c == '(')
        ++depth;
      if (c == '}' || c == ')')
        --depth;
      if (depth == 0 && (c == ';' || c == '}'))
        return;
    }
  }

  void add_set_of_faces(const Faces& faces, const std::string& name, const std::vector<std::size_t>& of_set)
  {
    CGAL::IO::Hex_mesh_set& set = mesh_.add_set(CGAL::IO::Hex_mesh_set::Kind::FACES, name);
    set.size = of_set.size();
    for (std::size_t f : of_set) {
      for (std::int64_t v : faces[f])
        set.vertices.push_back(first_point_ + static_cast<std::size_t>(v));
      if (faces[f].size() == 4) {
        set.faces.emplace_back();
        std::copy(set.vertices.end() - 4, set.vertices.end(), set.faces.back().begin());
      }
    }
  }

  void add_zones(const std::string& kind, const Faces& faces, const Source_file& file, const std::string& region)
  {
    Foam_scanner scanner(file);
    if (scanner.at_end())
      return;
    const std::int64_t n = scanner.label();
    if (n <= 0)
      return;
    scanner.expect('(');
    for (std::int64_t z = 0; z < n; ++z) {
      const std::string name = scanner.word();
      scanner.expect('{');
      std::vector<std::int64_t> labels;
      while (!scanner.accepts('}')) {
        const std::string key = scanner.word();
        if (key == "cellLabels" || key == "faceLabels" || key == "pointLabels") {
          if (scanner.text().substr(position_of_word(scanner), 4) == "List")
            scanner.word();
          labels = scanner.labels();
        }
        else if (key == "flipMap" && scanner.is_binary())
          skip_flips(scanner);
        skip_entry(scanner);
      }
      add_zone(kind, faces, region + name, labels, scanner);
    }
  }

  static std::size_t position_of_word(Foam_scanner& scanner)
  {
    scanner.skip_blank();
    return scanner.position();
  }

  static void skip_flips(Foam_scanner& scanner)
  {
    if (scanner.text().substr(position_of_word(scanner), 4) == "List")
      scanner.word();
    const std::int64_t n = scanner.label();
    if (scanner.accepts('('))
      scanner.skip(static_cast<std::size_t>(std::max<std::int64_t>(n, 0)) + 1);
  }

  void add_zone(const std::string& kind, const Faces& faces, const std::string& name,
                const std::vector<std::int64_t>& labels, const Foam_scanner& scanner)
  {
    const std::size_t number = kind == "cellZones"   ? mesh_.cells.size() - first_cell_
                               : kind == "faceZones" ? faces.size()
                                                     : mesh_.points.size() - first_point_;
    std::vector<std::size_t> members;
    for (std::int64_t l : labels) {
      if (l < 0 || static_cast<std::size_t>(l) >= number)
        scanner.fail("zone " + name + " has the member " + std::to_string(l) + ", which does not exist");
      members.push_back(static_cast<std::size_t>(l));
    }
    if (kind == "faceZones")
      return add_set_of_faces(faces, name, members);
    for (std::size_t& m : members)
      m += kind == "cellZones" ? first_cell_ : first_point_;
    if (kind == "pointZones") {
      mesh_.add_set(CGAL::IO::Hex_mesh_set::Kind::VERTICES, name).vertices = members;
      return;
    }
    const std::int64_t label = static_cast<std::int64_t>(mesh_.label_names.size()) + 1;
    mesh_.label_names[label] = name;
    for (std::size_t c : members)
      mesh_.cells[c].label = label;
    mesh_.add_set_of_cells(name, members);
  }

  std::string folder_;
  std::shared_ptr<Number_places> places_;
  Solver_mesh mesh_;
  std::size_t first_point_ = 0, first_cell_ = 0;           // of the mesh that is read
  std::vector<std::size_t> empty_patches_, other_patches_; // among the sets
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_OPENFOAM_READER_H
