// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_HEXAHEDRA_TO_LINEAR_CELL_COMPLEX_H
#define CGAL_HEX_MESH_OPTIMIZATION_HEXAHEDRA_TO_LINEAR_CELL_COMPLEX_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Builds the volumes of a linear cell complex from points and hexahedra given
// by indices, sewing by the identity of the vertices and never by position.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

namespace Hex_mesh_optimization {
namespace internal {

// Two faces, numbered 6 * hexahedron + face, that carry the same vertices in
// opposite cyclic order: corner `turn` of `second` is corner 3 of `first`.
struct Face_match
{
  std::size_t first;
  std::size_t second;
  int turn;
};

// The error of the hexahedron that comes first in the input, whatever order
// the checks run in.
class First_hexahedron_error
{
public:
  template <class Make_message>
  void report(std::size_t hexahedron, const Make_message& make_message)
  {
    if (hexahedron < hexahedron_) {
      hexahedron_ = hexahedron;
      message_ = "hexahedron " + std::to_string(hexahedron) + ": " + make_message();
    }
  }

  void throw_if_any() const
  {
    if (hexahedron_ != (std::numeric_limits<std::size_t>::max)())
      throw Input_error(Input_error::Element::HEXAHEDRON, hexahedron_, message_);
  }

private:
  std::size_t hexahedron_ = (std::numeric_limits<std::size_t>::max)();
  std::string message_;
};

// Finds which faces to sew, and refuses what a linear cell complex with one
// vertex attribute per index cannot carry.
class Hexahedra_sewing
{
public:
  template <class HexahedronRange>
  Hexahedra_sewing(std::size_t number_of_points, const HexahedronRange& hexahedra) : number_of_points_(number_of_points)
  {
    copy(hexahedra);
    match_faces();
    check_vertices();
    check_edges();
  }

  const std::vector<std::array<std::size_t, 8>>& hexahedra() const { return hexahedra_; }
  const std::vector<Face_match>& face_matches() const { return face_matches_; }

private:
  template <class HexahedronRange>
  void copy(const HexahedronRange& hexahedra)
  {
    First_hexahedron_error error;
    hexahedra_.reserve(hexahedra.size());
    for (const auto& hexahedron : hexahedra) {
      const std::size_t h = hexahedra_.size();
      std::array<std::size_t, 8> corners{};
      std::size_t count = 0;
      for (const auto& index : hexahedron) {
        // A negative index becomes a large one.
        const std::size_t v = static_cast<std::size_t>(index);
        if (count < 8) {
          if (v >= number_of_points_)
            error.report(h, [&] {
              return "vertex index " + std::to_string(index) + " is out of range, there are " +
                     std::to_string(number_of_points_) + " points";
            });
          if (std::find(corners.begin(), corners.begin() + count, v) != corners.begin() + count)
            error.report(h, [&] { return "vertex " + std::to_string(v) + " occurs twice"; });
          corners[count] = v;
        }
        ++count;
      }
      if (count != 8)
        error.report(h, [&] { return "it has " + std::to_string(count) + " vertices, not 8"; });
      error.throw_if_any();
      hexahedra_.push_back(corners);
    }
  }

  std::size_t face_vertex(std::size_t face, int i) const
  {
    return hexahedra_[face / 6][hexahedron_faces[face % 6][i & 3]];
  }

  std::size_t edge_vertex(std::size_t edge, int i) const
  {
    return hexahedra_[edge / 12][hexahedron_edges[edge % 12][i]];
  }

  // Lists the elements 0..size-1 by their smallest vertex, each list in
  // ascending order: a counting sort, linear in the size of the mesh.
  template <class Smallest_vertex>
  void sort_by_smallest_vertex(std::size_t size, const Smallest_vertex& smallest_vertex,
                               std::vector<std::size_t>& begin, std::vector<std::size_t>& elements) const
  {
    begin.assign(number_of_points_ + 2, 0);
    elements.resize(size);
    for (std::size_t e = 0; e < size; ++e)
      ++begin[smallest_vertex(e) + 2];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::size_t e = 0; e < size; ++e)
      elements[begin[smallest_vertex(e) + 1]++] = e;
  }

  void match_faces()
  {
    std::vector<std::size_t> begin, faces;
    sort_by_smallest_vertex(
      6 * hexahedra_.size(),
      [this](std::size_t f) {
        return (std::min)((std::min)(face_vertex(f, 0), face_vertex(f, 1)),
                          (std::min)(face_vertex(f, 2), face_vertex(f, 3)));
      },
      begin, faces);

    First_hexahedron_error error;
    std::vector<std::pair<std::array<std::size_t, 4>, std::size_t>> around;
    for (std::size_t v = 0; v < number_of_points_; ++v) {
      around.clear();
      for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
        std::array<std::size_t, 4> key;
        for (int j = 0; j < 4; ++j)
          key[j] = face_vertex(faces[i], j);
        std::sort(key.begin(), key.end());
        around.emplace_back(key, faces[i]);
      }
      std::sort(around.begin(), around.end());
      for (std::size_t i = 0, j; i < around.size(); i = j) {
        for (j = i + 1; j < around.size() && around[j].first == around[i].first; ++j) {
        }
        if (j - i == 2)
          match(around[i].second, around[i + 1].second, error);
        else if (j - i > 2)
          error.report(around[i + 2].second / 6, [&] {
            return "its face " + name_of_face(around[i].second) + " already belongs to the hexahedra " +
                   std::to_string(around[i].second / 6) + " and " + std::to_string(around[i + 1].second / 6);
          });
      }
    }
    error.throw_if_any();
  }

  std::string name_of_face(std::size_t face) const
  {
    std::string name = "(";
    for (int i = 0; i < 4; ++i)
      name += (i == 0 ? "" : " ") + std::to_string(face_vertex(face, i));
    return name + ")";
  }

  void match(std::size_t first, std::size_t second, First_hexahedron_error& error)
  {
    int j = 0;
    while (face_vertex(second, j) != face_vertex(first, 0))
      ++j;
    if (face_vertex(second, j + 2) != face_vertex(first, 2))
      error.report(second / 6, [&] {
        return "it connects the vertices of face " + name_of_face(first) + " by other edges than hexahedron " +
               std::to_string(first / 6) + " does";
      });
    else if (face_vertex(second, j + 1) != face_vertex(first, 3))
      error.report(second / 6, [&] {
        return "its orientation is opposite to that of hexahedron " + std::to_string(first / 6) +
               ", with which it shares the face " + name_of_face(first);
      });
    else
      face_matches_.push_back({first, second, (j + 1) & 3});
  }

  // Around a vertex, the hexahedra must hang together through faces at this
  // vertex: otherwise the complex has several vertices there.
  void check_vertices() const
  {
    Disjoint_sets corners(8 * hexahedra_.size());
    for (const Face_match& m : face_matches_)
      for (int i = 0; i < 4; ++i)
        corners.unite(8 * (m.first / 6) + hexahedron_faces[m.first % 6][i],
                      8 * (m.second / 6) + hexahedron_faces[m.second % 6][(m.turn + 3 - i) & 3]);

    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> first_corner(number_of_points_, none);
    First_hexahedron_error error;
    for (std::size_t h = 0; h < hexahedra_.size(); ++h) {
      for (std::size_t c = 0; c < 8; ++c) {
        const std::size_t v = hexahedra_[h][c];
        const std::size_t root = corners.find(8 * h + c);
        if (first_corner[v] == none)
          first_corner[v] = root;
        else if (first_corner[v] != root)
          error.report(h, [&] {
            return "at vertex " + std::to_string(v) + " it is not connected through faces to hexahedron " +
                   std::to_string(first_corner[v] / 8) + ", the vertex is non-manifold";
          });
      }
      error.throw_if_any();
    }
  }

  void check_edges() const
  {
    int edge_of[8][8] = {};
    for (int e = 0; e < 12; ++e)
      for (int i = 0; i < 2; ++i)
        edge_of[hexahedron_edges[e][i]][hexahedron_edges[e][1 - i]] = e;
    const auto face_edge = [&](std::size_t face, int i) {
      const int* corners = hexahedron_faces[face % 6];
      return 12 * (face / 6) + edge_of[corners[i & 3]][corners[(i + 1) & 3]];
    };

    Disjoint_sets sets(12 * hexahedra_.size());
    for (const Face_match& m : face_matches_)
      for (int i = 0; i < 4; ++i)
        sets.unite(face_edge(m.first, i), face_edge(m.second, m.turn + 2 - i));

    std::vector<std::size_t> begin, edges;
    sort_by_smallest_vertex(
      12 * hexahedra_.size(), [this](std::size_t e) { return (std::min)(edge_vertex(e, 0), edge_vertex(e, 1)); }, begin,
      edges);
    First_hexahedron_error error;
    std::vector<std::pair<std::size_t, std::size_t>> around;
    for (std::size_t v = 0; v < number_of_points_; ++v) {
      around.clear();
      for (std::size_t i = begin[v]; i < begin[v + 1]; ++i)
        around.emplace_back((std::max)(edge_vertex(edges[i], 0), edge_vertex(edges[i], 1)), edges[i]);
      std::sort(around.begin(), around.end());
      for (std::size_t i = 1; i < around.size(); ++i)
        if (around[i].first == around[i - 1].first && sets.find(around[i].second) != sets.find(around[i - 1].second))
          error.report(around[i].second / 12, [&] {
            return "at edge (" + std::to_string(v) + " " + std::to_string(around[i].first) +
                   ") it is not connected through faces to hexahedron " + std::to_string(around[i - 1].second / 12) +
                   ", the edge is non-manifold";
          });
    }
    error.throw_if_any();
  }

  std::size_t number_of_points_;
  std::vector<std::array<std::size_t, 8>> hexahedra_;
  std::vector<Face_match> face_matches_;
};

template <class PointRange, class LCC>
void make_volumes(const PointRange& points, const Hexahedra_sewing& sewing, LCC& lcc)
{
  using Vertex = decltype(lcc.create_vertex_attribute(*points.begin()));
  std::vector<Vertex> vertices;
  vertices.reserve(points.size());
  for (const auto& p : points)
    vertices.push_back(lcc.create_vertex_attribute(p));

  using Dart = decltype(lcc.create_dart());
  std::vector<Dart> darts;
  darts.reserve(sewing.hexahedra().size());
  // make_hexahedron() numbers the top differently: its corner 4 is above corner 3.
  for (const std::array<std::size_t, 8>& h : sewing.hexahedra())
    darts.push_back(lcc.make_hexahedron(vertices[h[0]], vertices[h[1]], vertices[h[2]], vertices[h[3]], vertices[h[7]],
                                        vertices[h[4]], vertices[h[5]], vertices[h[6]]));

  for (const Face_match& m : sewing.face_matches()) {
    const Dart first = dart_of_face(lcc, darts[m.first / 6], m.first % 6);
    Dart second = dart_of_face(lcc, darts[m.second / 6], m.second % 6);
    for (int i = m.turn; i % 4 != 0; ++i)
      second = lcc.next(second);
    // The two faces share their vertex attributes already: the topological
    // sewing leaves nothing to merge.
    if constexpr (is_generalized_map_v<LCC>)
      lcc.template topo_sew<3>(first, lcc.template alpha<0>(second));
    else
      lcc.template topo_sew<3>(first, second);
  }
}

} // namespace internal

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * builds the volumes of a linear cell complex from points and hexahedra.
 *
 * One vertex attribute is created per point, in the order of `points`, also
 * for points that no hexahedron refers to. One volume is created per
 * hexahedron, in the order of `hexahedra`. Volumes are sewn along faces that
 * carry the same four indices; coordinates are never compared. No attribute
 * other than vertex attributes is created.
 *
 * If `lcc` was empty, newly constructed or cleared, then
 * `linear_cell_complex_to_hexahedra()` gives back the same points, the same
 * hexahedra and the same corners, each in the same order. Cells that `lcc`
 * contains already stay, and are not sewn to the new ones.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type is `LCC::Point`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices
 *         of an integral type
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 *
 * \param points the points
 * \param hexahedra the hexahedra: corners 0 to 3 of the bottom, counter-clockwise seen from inside the
 *        hexahedron, and 4 to 7 above them
 * \param lcc the linear cell complex that the hexahedra are added to
 *
 * \throws Input_error before `lcc` is changed, naming the hexahedron, if an index is out of range or repeated,
 *         if a face belongs to three hexahedra or to two of opposite orientation, or if the hexahedra at a vertex
 *         or an edge are not connected through faces there.
 *
 * Complexity: linear in the number of points and hexahedra for a bounded number of hexahedra per vertex.
 */
template <class PointRange, class HexahedronRange, class LCC>
void hexahedra_to_linear_cell_complex(const PointRange& points, const HexahedronRange& hexahedra, LCC& lcc)
{
  internal::make_volumes(points, internal::Hexahedra_sewing(points.size(), hexahedra), lcc);
}

}
} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_HEXAHEDRA_TO_LINEAR_CELL_COMPLEX_H
