// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PART_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PART_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A part of a mesh as the engine takes it, with its vertices held where others go on.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/run_engine.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// As it is sent to the rank that has the part.
struct Hexahedron_of_part
{
  Global_index hexahedron;
  std::array<Global_index, 8> vertices;
  int part, label;
  std::uint8_t outer_faces;
};

class Part
{
public:
  // What the vertices of a part are asked for: in increasing order of the vertices.
  struct Vertices
  {
    std::vector<Triple> given, points;
    std::vector<int> valence;
    std::vector<char> is_fixed;
  };

  // In increasing order of the hexahedra.
  explicit Part(std::vector<Hexahedron_of_part> hexahedra) : hexahedra_(std::move(hexahedra))
  {
    vertices.reserve(8 * hexahedra_.size());
    for (const Hexahedron_of_part& h : hexahedra_)
      vertices.insert(vertices.end(), h.vertices.begin(), h.vertices.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

  // Runs the engine. drops_locked: hexahedra that are inverted whatever the vertices do that may move, do not count.
  // features: of the whole mesh
  Status run(Vertices of_vertices, double unit, const std::vector<std::array<Global_index, 2>>& features,
             bool has_labels, bool drops_locked, const Chosen_parameters& parameters)
  {
    const std::size_t n = vertices.size();
    std::vector<Hexahedron> cells;
    std::vector<int> count(n, 0);
    for (const Hexahedron_of_part& h : hexahedra_) {
      Hexahedron cell;
      for (int i = 0; i < 8; ++i) {
        cell[i] = place(h.vertices[i]);
        ++count[cell[i]];
      }
      cells.push_back(cell);
    }
    is_shared.resize(n);
    std::vector<char> is_held(n);
    for (std::size_t v = 0; v < n; ++v) {
      is_shared[v] = count[v] < of_vertices.valence[v];
      is_held[v] = is_shared[v] || of_vertices.is_fixed[v];
    }
    Regions regions;
    Positions start;
    for (std::size_t v = 0; v < n; ++v) {
      start.push_back(as_vector(of_vertices.points[v]));
      regions.surroundings.given.push_back(as_vector(of_vertices.given[v]));
    }
    of_vertices = {};
    regions.surroundings.unit = unit;
    for (const std::array<Global_index, 2>& edge : features) {
      const int a = place(edge[0]), b = a < 0 ? -1 : place(edge[1]);
      if (b >= 0)
        regions.surroundings.features.push_back({a, b});
    }
    std::vector<Hexahedron> kept;
    std::vector<std::uint8_t> outer_faces;
    bool has_boundary = false;
    for (std::size_t h = 0; h < cells.size(); ++h) {
      if (drops_locked && is_locked(cells[h], start, is_held))
        continue;
      kept.push_back(cells[h]);
      outer_faces.push_back(hexahedra_[h].outer_faces);
      has_boundary = has_boundary || hexahedra_[h].outer_faces != 0;
      if (has_labels)
        regions.labels.push_back(hexahedra_[h].label);
    }
    std::vector<Hexahedron>().swap(cells);
    std::vector<Hexahedron_of_part>().swap(hexahedra_);
    if (kept.empty() || std::find(is_held.begin(), is_held.end(), false) == is_held.end())
      return {};
    {
      const Face_neighbors neighbors(kept);
      for (int side = 0; side < neighbors.number_of_sides(); ++side)
        if (neighbors.opposite(side) == Face_neighbors::ALONE && !(outer_faces[side / 6] >> side % 6 & 1))
          regions.surroundings.faces.push_back(neighbors.vertices(side));
    }
    Chosen_parameters of_part = parameters;
    for (std::size_t h = 1; h < regions.labels.size(); ++h)
      has_boundary = has_boundary || regions.labels[h] != regions.labels[0];
    if (!has_boundary)
      of_part.maximum_deviation = std::numeric_limits<double>::infinity();
    Positions points = start;
    const Status status = run_engine(points, kept, regions, nullptr, is_held, of_part);
    for (std::size_t v = 0; v < n; ++v)
      if (!is_held[v] && points[v] != start[v]) {
        moved.push_back(vertices[v]);
        places.push_back({points[v][0], points[v][1], points[v][2]});
      }
    return status;
  }

  std::vector<Global_index> vertices; // in increasing order
  std::vector<char> is_shared;        // of those, after run(): hexahedra of other parts have them too
  std::vector<Global_index> moved;    // after run()
  std::vector<Triple> places;         // of those

private:
  // Among the vertices; -1 for others.
  int place(Global_index v) const
  {
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), v);
    return found == vertices.end() || *found != v ? -1 : static_cast<int>(found - vertices.begin());
  }

  static bool is_locked(const Hexahedron& h, const Positions& points, const std::vector<char>& is_held)
  {
    for (int c = 0; c < 8; ++c) {
      const int(&next)[3] = corner_neighbors[c];
      if (!is_held[h[c]] || !is_held[h[next[0]]] || !is_held[h[next[1]]] || !is_held[h[next[2]]])
        continue;
      const auto edge = [&](int k) { return Vector_3(points[h[next[k]]] - points[h[c]]); };
      if (!(edge(0).dot(edge(1).cross(edge(2))) > 0))
        return true;
    }
    return false;
  }

  std::vector<Hexahedron_of_part> hexahedra_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PART_H
