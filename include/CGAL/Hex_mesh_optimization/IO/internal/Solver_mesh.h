// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the readers of solvers' files collect, cell by cell, and what becomes of it: hexahedra, what is held, what goes along.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_places.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

enum class Cell_kind {
  HEXAHEDRON, // corners in the order of VTK, or mirrored, then other nodes in any order
  SOLID,      // held
  OTHER       // goes along
};

// The faces of a hexahedron, in the order of VTK.
constexpr int hexahedron_faces[6][4] = {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
                                        {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}};

class Solver_mesh
{
public:
  using Triple = std::array<double, 3>;

  struct Cell
  {
    Cell_kind kind;
    int vtk_type; // 0: unknown
    std::int64_t label;
    std::size_t begin, end; // in `nodes`
  };

  std::string format;
  std::vector<Triple> points;
  std::vector<Cell> cells;
  std::vector<std::size_t> nodes;
  std::map<std::int64_t, std::string> label_names;
  std::vector<CGAL::IO::Hex_mesh_set> sets;
  std::vector<CGAL::IO::Hex_mesh_file::Periodic_pair> periodic_pairs;
  std::vector<std::size_t> held; // beside the points of solids
  std::vector<std::string> notes;
  bool has_exact_surfaces = false;

  std::size_t add_cell(Cell_kind kind, int vtk_type, std::int64_t label, const std::vector<std::size_t>& of_cell)
  {
    cells.push_back({kind, vtk_type, label, nodes.size(), nodes.size() + of_cell.size()});
    nodes.insert(nodes.end(), of_cell.begin(), of_cell.end());
    return cells.size() - 1;
  }

  // The corners of one side of a hexahedron.
  std::array<std::size_t, 4> side(std::size_t cell, const int (&corners)[4]) const
  {
    std::array<std::size_t, 4> result{};
    for (int i = 0; i < 4; ++i)
      result[i] = nodes[cells[cell].begin + static_cast<std::size_t>(corners[i])];
    return result;
  }

  CGAL::IO::Hex_mesh_set& add_set(CGAL::IO::Hex_mesh_set::Kind kind, const std::string& name)
  {
    sets.emplace_back();
    sets.back().kind = kind;
    sets.back().name = name;
    return sets.back();
  }

  // A set of cells knows its number of cells, and their points; one of quadrilaterals is a set of faces.
  void add_set_of_cells(const std::string& name, const std::vector<std::size_t>& of_set)
  {
    using Kind = CGAL::IO::Hex_mesh_set::Kind;
    CGAL::IO::Hex_mesh_set& set = add_set(Kind::CELLS, name);
    bool all_are_faces = !of_set.empty();
    for (std::size_t c : of_set) {
      const Cell& cell = cells[c];
      set.vertices.insert(set.vertices.end(), nodes.begin() + static_cast<std::ptrdiff_t>(cell.begin),
                          nodes.begin() + static_cast<std::ptrdiff_t>(cell.end));
      all_are_faces = all_are_faces && is_quadrilateral(cell);
    }
    if (all_are_faces) {
      set.kind = Kind::FACES;
      for (std::size_t c : of_set)
        set.faces.push_back(side(c, {0, 1, 2, 3}));
    }
    set.size = of_set.size();
  }

  // All that is known of the file; the mesh is used up.
  CGAL::IO::Hex_mesh_file finish(std::shared_ptr<const Coordinate_places> places)
  {
    CGAL::IO::Hex_mesh_file file;
    file.format = std::move(format);
    file.places = std::move(places);
    std::vector<char> is_held(points.size(), false);
    for (std::size_t v : held)
      is_held[v] = true;
    take_hexahedra(file, is_held);
    for (const Cell& cell : cells)
      if (cell.kind == Cell_kind::SOLID) {
        ++file.number_of_other_solids;
        hold(cell, is_held);
      }
    find_followers(file);
    collect_held(file, is_held);
    for (CGAL::IO::Hex_mesh_set& set : sets)
      tidy(set);
    file.points = std::move(points);
    file.sets = std::move(sets);
    file.label_names = std::move(label_names);
    file.has_exact_surfaces = has_exact_surfaces;
    file.periodic_pairs = std::move(periodic_pairs);
    file.notes.insert(file.notes.end(), notes.begin(), notes.end());
    return file;
  }

private:
  static bool is_quadrilateral(const Cell& cell)
  {
    return (cell.vtk_type == 9 || cell.vtk_type == 23 || cell.vtk_type == 28) && cell.end - cell.begin >= 4;
  }

  void hold(const Cell& cell, std::vector<char>& is_held) const
  {
    for (std::size_t i = cell.begin; i < cell.end; ++i)
      is_held[nodes[i]] = true;
  }

  std::array<std::size_t, 8> corners(const Cell& cell) const
  {
    std::array<std::size_t, 8> result{};
    std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(cell.begin), 8, result.begin());
    return result;
  }

  // Hexahedra with corners that fall together are held, and so is the third one at a face; one that repeats another goes
  // along with it.
  void take_hexahedra(CGAL::IO::Hex_mesh_file& file, std::vector<char>& is_held)
  {
    std::set<std::array<std::size_t, 8>> known;
    const std::set<std::array<std::size_t, 8>> crowded = third_at_a_face();
    std::size_t degenerate = 0, repeated = 0, at_full_faces = 0;
    for (Cell& cell : cells) {
      if (cell.kind != Cell_kind::HEXAHEDRON) {
        add_other(file, cell);
        continue;
      }
      const std::array<std::size_t, 8> hexahedron = corners(cell);
      std::array<std::size_t, 8> sorted = hexahedron;
      std::sort(sorted.begin(), sorted.end());
      const bool is_degenerate = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
      const bool is_crowded = crowded.count(sorted) > 0;
      if (!is_degenerate && !is_crowded && known.insert(sorted).second) {
        file.hexahedra.push_back(hexahedron);
        file.labels.push_back(cell.label);
        hexahedra_.push_back(cell);
        continue;
      }
      (is_degenerate ? degenerate : is_crowded ? at_full_faces : repeated)++;
      cell.kind = is_degenerate || is_crowded ? Cell_kind::SOLID : Cell_kind::OTHER;
      add_other(file, cell);
    }
    note(file, degenerate, "hexahedra have corners that fall together: they are held");
    note(file, repeated, "hexahedra repeat others and go along with them");
    note(file, at_full_faces, "hexahedra share a face with two others: they are held");
    for (const Cell& cell : cells)
      if (cell.kind == Cell_kind::SOLID)
        hold(cell, is_held);
  }

  static void note(CGAL::IO::Hex_mesh_file& file, std::size_t count, const char* what)
  {
    if (count > 0)
      file.notes.push_back(std::to_string(count) + " " + what);
  }

  // The corners of the hexahedra, sorted, that come to a face after two others.
  std::set<std::array<std::size_t, 8>> third_at_a_face() const
  {
    struct Side
    {
      std::array<std::size_t, 4> corners;
      std::size_t cell;
    };
    std::vector<Side> sides;
    std::set<std::array<std::size_t, 8>> known, result;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].kind != Cell_kind::HEXAHEDRON)
        continue;
      std::array<std::size_t, 8> sorted = corners(cells[c]);
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end() || !known.insert(sorted).second)
        continue;
      for (const auto& face : hexahedron_faces) {
        sides.push_back({side(c, face), c});
        std::sort(sides.back().corners.begin(), sides.back().corners.end());
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return a.corners != b.corners ? a.corners < b.corners : a.cell < b.cell;
    });
    for (std::size_t i = 2; i < sides.size(); ++i)
      if (sides[i].corners == sides[i - 2].corners) {
        std::array<std::size_t, 8> sorted = corners(cells[sides[i].cell]);
        std::sort(sorted.begin(), sorted.end());
        result.insert(sorted);
      }
    return result;
  }

  void add_other(CGAL::IO::Hex_mesh_file& file, const Cell& cell) const
  {
    if (cell.vtk_type <= 0)
      return;
    CGAL::IO::Hex_mesh_cell other;
    other.type = cell.vtk_type;
    other.vertices.assign(nodes.begin() + static_cast<std::ptrdiff_t>(cell.begin),
                          nodes.begin() + static_cast<std::ptrdiff_t>(cell.end));
    other.label = cell.label;
    other.number_of_hexahedra_before = file.hexahedra.size();
    file.other_cells.push_back(std::move(other));
  }

  // Nodes that are no corners. Their order differs from format to format, and from writer to writer: which corners one is
  // between is found from where most of its kind are.
  void find_followers(CGAL::IO::Hex_mesh_file& file) const
  {
    std::map<std::size_t, std::vector<std::size_t>> by_size; // number of nodes: hexahedra
    std::vector<char> is_known(points.size(), false);
    for (std::size_t h = 0; h < hexahedra_.size(); ++h) {
      for (std::size_t v : file.hexahedra[h])
        is_known[v] = true;
      if (hexahedra_[h].end - hexahedra_[h].begin > 8)
        by_size[hexahedra_[h].end - hexahedra_[h].begin].push_back(h);
    }
    for (const auto& [size, hexahedra] : by_size) {
      file.number_of_high_order_hexahedra += hexahedra.size();
      const std::vector<std::array<double, 8>> lattice = weights(order(size));
      for (std::size_t node = 8; node < size; ++node) {
        const std::array<double, 8> weight = lattice[place_in_lattice(hexahedra, node, lattice)];
        for (std::size_t h : hexahedra) {
          const std::size_t v = nodes[hexahedra_[h].begin + node];
          if (is_known[v])
            continue;
          is_known[v] = true;
          file.followers.push_back({v, file.hexahedra[h], weight});
        }
      }
    }
  }

  static std::size_t order(std::size_t number_of_nodes)
  {
    std::size_t p = 2;
    while (p < 12 && std::max((p + 1) * (p + 1) * (p + 1), 12 * p - 4) < number_of_nodes)
      ++p;
    return p;
  }

  // Trilinear, of all places of a lattice that are no corners.
  static std::vector<std::array<double, 8>> weights(std::size_t p)
  {
    static const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    std::vector<std::array<double, 8>> result;
    for (std::size_t i = 0; i <= p; ++i)
      for (std::size_t j = 0; j <= p; ++j)
        for (std::size_t k = 0; k <= p; ++k) {
          if (i % p == 0 && j % p == 0 && k % p == 0)
            continue;
          const double at[3] = {double(i) / double(p), double(j) / double(p), double(k) / double(p)};
          result.emplace_back();
          for (int c = 0; c < 8; ++c) {
            result.back()[c] = 1;
            for (int d = 0; d < 3; ++d)
              result.back()[c] *= corner[c][d] == 1 ? at[d] : 1 - at[d];
          }
        }
    return result;
  }

  std::size_t place_in_lattice(const std::vector<std::size_t>& hexahedra, std::size_t node,
                               const std::vector<std::array<double, 8>>& lattice) const
  {
    constexpr std::size_t enough = 2000;
    std::vector<std::size_t> votes(lattice.size(), 0);
    const std::size_t step = hexahedra.size() / enough + 1;
    for (std::size_t i = 0; i < hexahedra.size(); i += step) {
      const Cell& cell = hexahedra_[hexahedra[i]];
      const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(cell.begin);
      if (std::find(first, first + 8, first[static_cast<std::ptrdiff_t>(node)]) == first + 8) // it is not left out
        ++votes[nearest(cell, node, lattice)];
    }
    return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
  }

  std::size_t nearest(const Cell& cell, std::size_t node, const std::vector<std::array<double, 8>>& lattice) const
  {
    const Triple& at = points[nodes[cell.begin + node]];
    std::size_t result = 0;
    double least = 0;
    for (std::size_t l = 0; l < lattice.size(); ++l) {
      Triple d = at;
      for (std::size_t c = 0; c < 8; ++c)
        for (int k = 0; k < 3; ++k)
          d[k] -= lattice[l][c] * points[nodes[cell.begin + c]][k];
      const double distance = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (l == 0 || distance < least) {
        least = distance;
        result = l;
      }
    }
    return result;
  }

  // Of the corners of hexahedra; the others do not move by themselves.
  static void collect_held(CGAL::IO::Hex_mesh_file& file, std::vector<char>& is_held)
  {
    for (const auto& hexahedron : file.hexahedra)
      for (std::size_t v : hexahedron)
        if (is_held[v]) {
          is_held[v] = false;
          file.held_points.push_back(v);
        }
    std::sort(file.held_points.begin(), file.held_points.end());
  }

  static void tidy(CGAL::IO::Hex_mesh_set& set)
  {
    if (set.size == 0)
      set.size = set.faces.empty() ? set.vertices.size() : set.faces.size();
    for (const auto& face : set.faces)
      set.vertices.insert(set.vertices.end(), face.begin(), face.end());
    std::sort(set.vertices.begin(), set.vertices.end());
    set.vertices.erase(std::unique(set.vertices.begin(), set.vertices.end()), set.vertices.end());
  }

  std::vector<Cell> hexahedra_; // those of the file that is made
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_SOLVER_MESH_H
