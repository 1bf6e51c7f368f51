// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_MEMORY_ORDER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_MEMORY_ORDER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A numbering in which neighbors are close in memory, whatever the order in which
// the mesh was given.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Memory_order
{
public:
  // Breadth first from a vertex at one end of each component, as by Cuthill and McKee (1969), but without their order
  // by degree; hexahedra by their first vertex; unused vertices at the end. O(vertices + hexahedra).
  explicit Memory_order(const Hexahedral_complex& complex) : new_vertex_(complex.number_of_vertices(), -1)
  {
    std::vector<int> mark(complex.number_of_vertices(), 0);
    for (std::size_t v = 0; v < new_vertex_.size(); ++v)
      if (complex.is_used[v] && mark[v] == 0) {
        const std::vector<int> forth = breadth_first(complex, static_cast<int>(v), 1, mark);
        const std::vector<int> back = breadth_first(complex, forth.back(), 2, mark);
        vertices_.insert(vertices_.end(), back.begin(), back.end());
      }
    for (std::size_t v = 0; v < new_vertex_.size(); ++v)
      if (!complex.is_used[v])
        vertices_.push_back(static_cast<int>(v));
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      new_vertex_[vertices_[i]] = static_cast<int>(i);
    const auto first_vertex = [&](std::size_t h) {
      int first = new_vertex_[complex.hexahedra[h][0]];
      for (int v : complex.hexahedra[h])
        first = (std::min)(first, new_vertex_[v]);
      return first;
    };
    const Grouped_array by_first_vertex(vertices_.size(), complex.hexahedra.size(), first_vertex,
                                        [](std::size_t h) { return static_cast<int>(h); });
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      hexahedra_.insert(hexahedra_.end(), by_first_vertex[i].begin(), by_first_vertex[i].end());
  }

  int given_vertex(std::size_t v) const { return vertices_[v]; }
  int given_hexahedron(std::size_t h) const { return hexahedra_[h]; }

  // What belongs to the vertices as given, in this order; nothing stays nothing.
  template <class T>
  std::vector<T> ordered(const std::vector<T>& of_given_vertices) const
  {
    std::vector<T> result;
    result.reserve(of_given_vertices.size());
    for (std::size_t i = 0; i < of_given_vertices.size(); ++i)
      result.push_back(of_given_vertices[vertices_[i]]);
    return result;
  }

  std::vector<Hexahedron> ordered(const std::vector<Hexahedron>& given) const
  {
    std::vector<Hexahedron> result;
    result.reserve(given.size());
    for (int h : hexahedra_) {
      result.push_back(given[h]);
      for (int& v : result.back())
        v = new_vertex_[v];
    }
    return result;
  }

  Regions ordered(const Regions& given) const
  {
    Regions result;
    for (std::size_t h = 0; h < given.labels.size(); ++h)
      result.labels.push_back(given.labels[hexahedra_[h]]);
    for (std::array<int, 4> face : given.faces) {
      for (int& v : face)
        v = new_vertex_[v];
      result.faces.push_back(face);
    }
    for (const Tie& t : given.ties)
      result.ties.push_back({new_vertex_[t.vertex], new_vertex_[t.partner], t.translation});
    result.surroundings = given.surroundings;
    result.surroundings.given = ordered(given.surroundings.given);
    for (std::array<int, 2>& edge : result.surroundings.features)
      for (int& v : edge)
        v = new_vertex_[v];
    for (std::array<int, 4>& face : result.surroundings.faces)
      for (int& v : face)
        v = new_vertex_[v];
    return result;
  }

  template <class T>
  std::vector<T> as_given(const std::vector<T>& of_vertices) const
  {
    std::vector<T> result(of_vertices);
    for (std::size_t i = 0; i < of_vertices.size(); ++i)
      result[vertices_[i]] = of_vertices[i];
    return result;
  }

private:
  static std::vector<int> breadth_first(const Hexahedral_complex& complex, int start, int visit, std::vector<int>& mark)
  {
    std::vector<int> order(1, start);
    mark[start] = visit;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (int h : complex.vertex_hexahedra[order[i]])
        for (int u : complex.hexahedra[h])
          if (mark[u] < visit) {
            mark[u] = visit;
            order.push_back(u);
          }
    return order;
  }

  std::vector<int> vertices_, hexahedra_; // the given index of each
  std::vector<int> new_vertex_;           // of each given one
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_MEMORY_ORDER_H
