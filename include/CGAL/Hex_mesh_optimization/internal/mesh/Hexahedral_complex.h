// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRAL_COMPLEX_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRAL_COMPLEX_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The connectivity of a hexahedral mesh in flat arrays: edges, boundary faces
// and the incidences that the optimization walks along.
//
// A mesh may have several regions. Its boundary is all of their boundaries, each face once: those with nothing beyond,
// and those between two regions. Nowhere need it be a manifold.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Two vertices that move together: the partner is where the translation takes the vertex.
struct Tie
{
  int vertex, partner;
  Vector_3 translation;
};

// What a mesh has to know that is a part of a larger one.
struct Surroundings
{
  std::vector<std::array<int, 4>> faces =
    {};                 // where the larger mesh goes on, in any order: no boundary, though nothing is beyond
  Positions given = {}; // where the vertices were when the larger mesh came in
  std::vector<std::array<int, 2>> features = {}; // the edges that are on feature curves of the larger mesh
  double unit = 0;                               // its mean boundary edge; 0: there is no larger mesh

  bool has_any() const { return unit > 0; }
};

// What divides a mesh, and what ties it together.
struct Regions
{
  std::vector<int> labels;               // of the hexahedra; none: all are in one region
  std::vector<std::array<int, 4>> faces; // within a region that belong to the boundary all the same, in any order
  std::vector<Tie> ties = {};
  Surroundings surroundings = {};
};

// A directed edge is 2e when it runs from edges[e][0] to edges[e][1], else 2e+1.
inline int opposite_edge(int directed) { return directed ^ 1; }

class Hexahedral_complex
{
public:
  struct Boundary_face
  {
    std::array<int, 4> vertices; // counter-clockwise seen from outside
    int hexahedron;
    int beyond; // the hexahedron on the other side, which is in the region of the higher label; or -1
  };

  // An edge of the boundary surface; left holds the face that runs along the
  // edge in its own direction, right the other one. Where the boundary is not a
  // manifold, left is one of the faces, right -1.
  struct Boundary_edge
  {
    int edge;
    int left, right;
  };

  Hexahedral_complex(std::size_t number_of_vertices, std::vector<Hexahedron> cells, const Regions& regions = {})
    : hexahedra(std::move(cells))
    , labels(regions.labels)
    , is_on_boundary(number_of_vertices, false)
    , is_used(number_of_vertices, false)
    , ties(number_of_vertices, pairs(regions.ties))
  {
    number_edges();
    pair_faces(keys_of(regions.faces), keys_of(regions.surroundings.faces));
    number_boundary_edges();
    mark_open_edges(regions.surroundings.faces);
    vertex_hexahedra = Grouped_array(
      number_of_vertices, hexahedra.size() * 8, [this](std::size_t k) { return hexahedra[k / 8][k % 8]; },
      [](std::size_t k) { return static_cast<int>(k / 8); });
    vertex_boundary_faces = Grouped_array(
      number_of_vertices, boundary_faces.size() * 4,
      [this](std::size_t k) { return boundary_faces[k / 4].vertices[k % 4]; },
      [](std::size_t k) { return static_cast<int>(k / 4); });
    find_singular_vertices();
  }

  std::size_t number_of_vertices() const { return is_on_boundary.size(); }
  int label(int hexahedron) const { return labels.empty() ? 0 : labels[hexahedron]; }

  int source(int directed) const { return edges[directed / 2][directed & 1]; }
  int target(int directed) const { return edges[directed / 2][1 - (directed & 1)]; }

  std::vector<Hexahedron> hexahedra;
  std::vector<int> labels;                                        // of the hexahedra, or none
  std::vector<std::array<int, 2>> edges;                          // sorted; the smaller index first
  std::vector<std::array<int, 12>> hexahedron_edges;              // directed edges, in the order of the table
  std::vector<std::array<std::pair<int, int>, 2>> interior_faces; // (hexahedron, local face) of either side
  std::vector<Boundary_face> boundary_faces;                      // those with nothing beyond first
  std::vector<Boundary_edge> boundary_edges;
  std::vector<char> is_singular;      // of a vertex: around it the boundary is not one disk
  std::vector<char> is_on_boundary;   // of a vertex
  std::vector<char> is_boundary_edge; // of an edge
  std::vector<char> is_singular_edge; // of an edge of the boundary: it is no manifold there
  std::vector<char> is_open_edge;     // of an edge: a larger mesh goes on there; none: nowhere
  std::vector<char> is_used;          // of a vertex: has a hexahedron
  Ties ties;                          // of the vertices
  Grouped_array vertex_hexahedra, vertex_boundary_faces;

private:
  static std::vector<std::array<int, 2>> pairs(const std::vector<Tie>& ties)
  {
    std::vector<std::array<int, 2>> result;
    for (const Tie& t : ties)
      result.push_back({t.vertex, t.partner});
    return result;
  }

  void number_edges()
  {
    using Key = std::pair<std::uint64_t, std::uint32_t>; // (edge, 12 hexahedron + local edge)
    std::vector<Key> keys;
    keys.reserve(12 * hexahedra.size());
    for (std::size_t h = 0; h < hexahedra.size(); ++h) {
      for (int v : hexahedra[h])
        is_used[v] = true;
      for (int k = 0; k < 12; ++k) {
        const std::uint64_t a = hexahedra[h][hexahedron_edges_table(k, 0)];
        const std::uint64_t b = hexahedra[h][hexahedron_edges_table(k, 1)];
        keys.emplace_back((std::min)(a, b) << 32 | (std::max)(a, b), static_cast<std::uint32_t>(12 * h + k));
      }
    }
    std::sort(keys.begin(), keys.end());
    hexahedron_edges.resize(hexahedra.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const int low = static_cast<int>(keys[i].first >> 32), high = static_cast<int>(keys[i].first & 0xffffffffu);
      if (i == 0 || keys[i].first != keys[i - 1].first)
        edges.push_back({low, high});
      const std::size_t h = keys[i].second / 12;
      const int k = keys[i].second % 12, e = static_cast<int>(edges.size()) - 1;
      hexahedron_edges[h][k] = 2 * e + (hexahedra[h][hexahedron_edges_table(k, 0)] == low ? 0 : 1);
    }
  }

  static int hexahedron_edges_table(int k, int end) { return internal::hexahedron_edges[k][end]; }

  using Face_key = std::array<int, 4>; // its vertices, sorted

  static Face_key key_of(Face_key face)
  {
    std::sort(face.begin(), face.end());
    return face;
  }

  // Sorted.
  static std::vector<Face_key> keys_of(const std::vector<std::array<int, 4>>& faces)
  {
    std::vector<Face_key> keys;
    for (const std::array<int, 4>& face : faces)
      keys.push_back(key_of(face));
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  // listed: faces that belong to the boundary though they do not divide regions. open: where a larger mesh goes on.
  void pair_faces(const std::vector<Face_key>& listed, const std::vector<Face_key>& open)
  {
    const auto is_among = [](const std::vector<Face_key>& keys, const std::array<int, 4>& face) {
      return !keys.empty() && std::binary_search(keys.begin(), keys.end(), key_of(face));
    };
    const Face_neighbors neighbors(hexahedra);
    std::vector<std::array<int, 2>> dividing; // sides, that of the lower label first
    for (int side = 0; side < neighbors.number_of_sides(); ++side) {
      const int opposite = neighbors.opposite(side);
      if (opposite == Face_neighbors::ALONE) {
        if (!is_among(open, neighbors.vertices(side)))
          boundary_faces.push_back({neighbors.vertices(side), side / 6, -1});
      }
      else if (opposite == Face_neighbors::UNSOUND || !neighbors.is_agreed(side))
        refuse(neighbors.sides_with_vertices_of(side));
      else if (opposite > side) {
        interior_faces.push_back({std::make_pair(side / 6, side % 6), std::make_pair(opposite / 6, opposite % 6)});
        const int a = label(side / 6), b = label(opposite / 6);
        if (a != b || is_among(listed, neighbors.vertices(side)))
          dividing.push_back(b < a ? std::array{opposite, side} : std::array{side, opposite});
      }
    }
    std::sort(dividing.begin(), dividing.end());
    for (const std::array<int, 2>& sides : dividing)
      boundary_faces.push_back({neighbors.vertices(sides[0]), sides[0] / 6, sides[1] / 6});
    for (const Boundary_face& face : boundary_faces)
      for (int v : face.vertices)
        is_on_boundary[v] = true;
  }

  // sides: with the same vertices
  [[noreturn]] static void refuse(const std::vector<int>& sides)
  {
    const auto hexahedron = [&](int i) { return std::to_string(sides[i] / 6); };
    if (sides.size() > 2)
      throw Input_error(Input_error::Element::HEXAHEDRON, sides[2] / 6,
                        "hexahedron " + hexahedron(2) + " is the third one on a face that hexahedra " + hexahedron(0) +
                          " and " + hexahedron(1) + " already share");
    throw Input_error(Input_error::Element::HEXAHEDRON, sides[1] / 6,
                      "hexahedra " + hexahedron(0) + " and " + hexahedron(1) +
                        " share four vertices but not a face with opposite orientations");
  }

  struct Boundary_side
  {
    int edge;
    bool is_reversed; // it runs from the higher to the lower vertex
    int face;

    bool operator<(const Boundary_side& other) const
    {
      return std::tie(edge, is_reversed, face) < std::tie(other.edge, other.is_reversed, other.face);
    }
  };

  // Sorted.
  std::vector<Boundary_side> boundary_sides() const
  {
    std::vector<Boundary_side> sides;
    sides.reserve(4 * boundary_faces.size());
    for (std::size_t f = 0; f < boundary_faces.size(); ++f)
      for (int k = 0; k < 4; ++k) {
        const int a = boundary_faces[f].vertices[k], b = boundary_faces[f].vertices[(k + 1) % 4];
        sides.push_back({find_edge(a, b) / 2, b < a, static_cast<int>(f)});
      }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  void number_boundary_edges()
  {
    orient_faces_within_regions();
    is_boundary_edge.assign(edges.size(), false);
    is_singular_edge.assign(edges.size(), false);
    const std::vector<Boundary_side> sides = boundary_sides();
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
      for (end = i + 1; end < sides.size() && sides[end].edge == sides[i].edge;)
        ++end;
      const bool is_manifold = end - i == 2 && !sides[i].is_reversed && sides[i + 1].is_reversed;
      is_boundary_edge[sides[i].edge] = true;
      is_singular_edge[sides[i].edge] = !is_manifold;
      boundary_edges.push_back({sides[i].edge, sides[i].face, is_manifold ? sides[i + 1].face : -1});
    }
  }

  void mark_open_edges(const std::vector<std::array<int, 4>>& open_faces)
  {
    if (open_faces.empty())
      return;
    is_open_edge.assign(edges.size(), false);
    for (const std::array<int, 4>& face : open_faces)
      for (int k = 0; k < 4; ++k)
        is_open_edge[find_edge(face[k], face[(k + 1) % 4]) / 2] = true;
  }

  // What divides two regions is seen from that of the lower label. Faces within a region have no such side: each sheet
  // of them takes that of its first face.
  void orient_faces_within_regions()
  {
    const auto is_within = [&](int f) {
      return boundary_faces[f].beyond >= 0 && label(boundary_faces[f].hexahedron) == label(boundary_faces[f].beyond);
    };
    const int n = static_cast<int>(boundary_faces.size());
    int first = 0;
    while (first < n && !is_within(first))
      ++first;
    if (first == n)
      return;
    struct Neighbor
    {
      int face;
      bool is_opposite; // it runs along the common edge in the same direction
    };
    std::vector<std::vector<Neighbor>> neighbors(n);
    const std::vector<Boundary_side> sides = boundary_sides();
    for (std::size_t i = 0, end; i < sides.size(); i = end) {
      for (end = i + 1; end < sides.size() && sides[end].edge == sides[i].edge;)
        ++end;
      const int a = sides[i].face, b = sides[end - 1].face;
      if (end - i != 2 || !is_within(a) || !is_within(b))
        continue;
      const bool is_opposite = sides[i].is_reversed == sides[i + 1].is_reversed;
      neighbors[a].push_back({b, is_opposite});
      neighbors[b].push_back({a, is_opposite});
    }
    std::vector<char> is_done(n, false);
    std::vector<std::pair<int, bool>> reached; // a face, and whether it is to be turned
    for (int start = first; start < n; ++start) {
      if (!is_within(start) || is_done[start])
        continue;
      is_done[start] = true;
      reached.assign(1, {start, false});
      while (!reached.empty()) {
        const auto [f, turns] = reached.back();
        reached.pop_back();
        if (turns) {
          Boundary_face& face = boundary_faces[f];
          std::swap(face.vertices[1], face.vertices[3]);
          std::swap(face.hexahedron, face.beyond);
        }
        for (const Neighbor& next : neighbors[f])
          if (!is_done[next.face]) {
            is_done[next.face] = true;
            reached.emplace_back(next.face, turns != next.is_opposite);
          }
      }
    }
  }

  // Around a vertex of a manifold, one closed fan holds all boundary faces.
  void find_singular_vertices()
  {
    is_singular.assign(number_of_vertices(), false);
    for (const Boundary_edge& e : boundary_edges)
      if (e.right < 0)
        for (int v : edges[e.edge])
          is_singular[v] = true;
    for (std::size_t v = 0; v < number_of_vertices(); ++v) {
      const auto faces = vertex_boundary_faces[v];
      if (faces.size() == 0 || is_singular[v])
        continue;
      const int v_index = static_cast<int>(v);
      const auto corner = [&](int f) {
        const std::array<int, 4>& q = boundary_faces[f].vertices;
        return static_cast<int>(std::find(q.begin(), q.end(), v_index) - q.begin());
      };
      std::size_t visited = 0;
      int f = faces[0];
      do {
        const int previous = boundary_faces[f].vertices[(corner(f) + 3) % 4];
        ++visited;
        int next = -1;
        for (int g : faces)
          if (boundary_faces[g].vertices[(corner(g) + 1) % 4] == previous)
            next = g;
        f = next;
      } while (f != faces[0] && f >= 0 && visited <= faces.size());
      is_singular[v] = visited != faces.size();
    }
  }

public:
  // The directed edge from vertex a to vertex b, which must exist. O(log edges).
  int find_edge(int a, int b) const
  {
    const std::array<int, 2> key{(std::min)(a, b), (std::max)(a, b)};
    const auto it = std::lower_bound(edges.begin(), edges.end(), key);
    return 2 * static_cast<int>(it - edges.begin()) + (a < b ? 0 : 1);
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_HEXAHEDRAL_COMPLEX_H
