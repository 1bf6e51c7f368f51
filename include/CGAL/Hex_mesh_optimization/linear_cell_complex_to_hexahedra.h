// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_LINEAR_CELL_COMPLEX_TO_HEXAHEDRA_H
#define CGAL_HEX_MESH_OPTIMIZATION_LINEAR_CELL_COMPLEX_TO_HEXAHEDRA_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Lists the points and the hexahedra of a linear cell complex by indices.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/Linear_cell_complex_traits.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <CGAL/Container_helper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization {
namespace internal {

// A Boolean mark of the darts, freed on every way out.
template <class LCC>
class Dart_mark
{
public:
  explicit Dart_mark(const LCC& lcc) : lcc_(lcc), mark_(lcc.get_new_mark()) {}
  ~Dart_mark() { lcc_.free_mark(mark_); }
  Dart_mark(const Dart_mark&) = delete;
  Dart_mark& operator=(const Dart_mark&) = delete;

  template <class Dart>
  bool is_set(Dart dart) const
  {
    return lcc_.is_marked(dart, mark_);
  }
  template <class Dart>
  void set(Dart dart) const
  {
    lcc_.mark(dart, mark_);
  }

private:
  const LCC& lcc_;
  typename LCC::size_type mark_;
};

// Dart 4 * face + i starts at corner i of hexahedron_faces[face] counted
// backwards; this is the dart of the neighboring face on the same edge.
struct Opposite_darts
{
  int of[24] = {};

  constexpr Opposite_darts()
  {
    for (int d = 0; d < 24; ++d)
      for (int e = 0; e < 24; ++e)
        if (corner(d) == corner(next(e)) && corner(e) == corner(next(d)))
          of[d] = e;
  }

  static constexpr int corner(int dart) { return hexahedron_faces[dart / 4][(4 - dart % 4) % 4]; }
  static constexpr int next(int dart) { return 4 * (dart / 4) + (dart + 1) % 4; }
};

// The 24 darts (of one orientation) of the volume whose dart from corner 0 to
// corner 4 in face 2 is given; false if it is not a combinatorial hexahedron.
template <class LCC, class Dart>
bool darts_of_hexahedron(const LCC& lcc, Dart dart, std::array<Dart, 24>& darts)
{
  static constexpr Opposite_darts opposite{};
  for (std::size_t f = 0; f < 6; ++f) {
    Dart d = dart_of_face(lcc, dart, f);
    const Dart first = d;
    for (std::size_t i = 0; i < 4; ++i, d = lcc.next(d)) {
      if (lcc.template is_free<0>(d) || lcc.template is_free<1>(d) || lcc.template is_free<2>(d))
        return false;
      darts[4 * f + i] = d;
    }
    if (d != first)
      return false;
  }
  for (std::size_t d = 0; d < 24; ++d)
    if (lcc.opposite2(darts[d]) != darts[opposite.of[d]])
      return false;
  return true;
}

// One dart per volume, from corner 0 to corner 4 in face 2, in the order in
// which the volumes appear in the container of darts.
template <class LCC>
class Hexahedra_of_linear_cell_complex
{
  using Dart = typename Linear_cell_complex_types<LCC>::Dart;

public:
  explicit Hexahedra_of_linear_cell_complex(const LCC& lcc) : lcc_(lcc)
  {
    list_volumes();
    if constexpr (is_generalized_map_v<LCC>)
      orient();
  }

  std::size_t size() const { return first_darts_.size(); }

  // The darts that start at the corners 0 to 7.
  std::array<Dart, 8> corners(std::size_t h) const
  {
    const Dart d04 = first_darts_[h];
    const Dart d45 = lcc_.next(d04), d51 = lcc_.next(d45), d10 = lcc_.next(d51);
    const Dart d15 = lcc_.opposite2(d51);
    const Dart d26 = lcc_.opposite2(lcc_.next(lcc_.next(d15)));
    const Dart d67 = lcc_.next(d26), d73 = lcc_.next(d67), d32 = lcc_.next(d73);
    return {d04, d10, d26, d32, d45, d51, d67, d73};
  }

private:
  [[noreturn]] static void refuse(std::size_t h, const std::string& reason)
  {
    throw Input_error(Input_error::Element::HEXAHEDRON, h, "volume " + std::to_string(h) + ": " + reason);
  }

  void list_volumes()
  {
    const Dart_mark<LCC> visited(lcc_);
    std::array<Dart, 24> darts;
    const auto end = lcc_.darts().end();
    for (auto it = lcc_.darts().begin(); it != end; ++it) {
      if (visited.is_set(it))
        continue;
      if (!darts_of_hexahedron(lcc_, Dart(it), darts))
        refuse(first_darts_.size(), "it is not a combinatorial hexahedron");
      for (const Dart& d : darts) {
        visited.set(d);
        if constexpr (is_generalized_map_v<LCC>)
          visited.set(lcc_.template alpha<0>(d));
      }
      first_darts_.push_back(it);
    }
  }

  // In a generalized map a dart tells nothing about the orientation: that of
  // the first dart is carried over to the whole connected component.
  void orient()
  {
    const Dart_mark<LCC> positive(lcc_);
    std::vector<Dart> stack;
    std::array<Dart, 24> darts;
    for (std::size_t h = 0; h < first_darts_.size(); ++h) {
      Dart& first = first_darts_[h];
      if (positive.is_set(lcc_.template alpha<0>(first))) {
        first = lcc_.template alpha<0>(first);
        continue;
      }
      stack.push_back(first);
      while (!stack.empty()) {
        const Dart dart = stack.back();
        stack.pop_back();
        if (positive.is_set(dart))
          continue;
        if (positive.is_set(lcc_.template alpha<0>(dart)))
          refuse(h, "its connected component is not orientable");
        darts_of_hexahedron(lcc_, dart, darts);
        for (const Dart& d : darts)
          positive.set(d);
        for (std::size_t i = 0; i < 24; i += 4)
          if (!lcc_.template is_free<3>(darts[i]))
            stack.push_back(lcc_.template opposite<3>(darts[i]));
      }
    }
  }

  const LCC& lcc_;
  std::vector<Dart> first_darts_;
};

template <class LCC, class PointRange, class HexahedronRange>
void list_points_and_hexahedra(const LCC& lcc, PointRange& points, HexahedronRange& hexahedra)
{
  const Hexahedra_of_linear_cell_complex<LCC> volumes(lcc);

  points.clear();
  hexahedra.clear();
  points.reserve(lcc.number_of_vertex_attributes());
  hexahedra.reserve(volumes.size());

  // A point lies inside its attribute: its address identifies the vertex for
  // every kind of descriptor.
  std::unordered_map<const void*, std::size_t> index_of;
  index_of.reserve(lcc.number_of_vertex_attributes());
  const auto end = lcc.vertex_attributes().end();
  for (auto it = lcc.vertex_attributes().begin(); it != end; ++it) {
    const typename LCC::Point& p = lcc.point_of_vertex_attribute(it);
    index_of.emplace(&p, points.size());
    points.push_back(p);
  }

  for (std::size_t h = 0; h < volumes.size(); ++h) {
    typename HexahedronRange::value_type hexahedron;
    CGAL::internal::resize(hexahedron, 8);
    using Index = std::decay_t<decltype(hexahedron[0])>;
    std::array<std::size_t, 8> sorted;
    std::size_t i = 0;
    for (const auto& dart : volumes.corners(h)) {
      if (Linear_cell_complex_types<LCC>::is_null(lcc.vertex_attribute(dart)))
        throw Input_error(Input_error::Element::HEXAHEDRON, h,
                          "volume " + std::to_string(h) + ": a dart has no vertex attribute");
      sorted[i] = index_of.find(&lcc.point(dart))->second;
      hexahedron[i] = static_cast<Index>(sorted[i]);
      ++i;
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      throw Input_error(Input_error::Element::HEXAHEDRON, h,
                        "volume " + std::to_string(h) + ": vertex " + std::to_string(*twice) + " occurs twice");
    hexahedra.push_back(std::move(hexahedron));
  }
}

} // namespace internal

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * lists the points and the hexahedra of a linear cell complex.
 *
 * The points come in the order of `lcc.vertex_attributes()`, also those that
 * no dart refers to. The hexahedra come in the order in which their first
 * darts appear in `lcc.darts()`, and the first dart of a hexahedron goes from
 * corner 0 to corner 4. In a generalized map, which has no
 * orientation of its own, all hexahedra of a connected component are oriented
 * as the first one. For a linear cell complex made by
 * `hexahedra_to_linear_cell_complex()`, and for one whose volumes were made by
 * `make_hexahedron()`, this is the order and the numbering they were made
 * with, as long as no element was erased before.
 *
 * `lcc` is not changed; but as one or two of its Boolean marks are in use in the
 * meantime, no other thread may use its marks.
 *
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 * \tparam PointRange a model of `BackInsertionSequence` with `reserve()` whose value type can be constructed from
 *         `LCC::Point`
 * \tparam HexahedronRange a model of `BackInsertionSequence` with `reserve()` whose value type is a random access
 *         container of indices of an integral type, either an array of size 8 or resizable
 *
 * \param lcc the linear cell complex
 * \param points the points, replaced
 * \param hexahedra the hexahedra, replaced
 *
 * \throws Input_error naming the volume if one is not a combinatorial hexahedron with eight different vertices,
 *         or if a component of a generalized map is not orientable.
 *
 * Complexity: linear in the number of darts and vertex attributes.
 */
template <class LCC, class PointRange, class HexahedronRange>
void linear_cell_complex_to_hexahedra(const LCC& lcc, PointRange& points, HexahedronRange& hexahedra)
{
  internal::list_points_and_hexahedra(lcc, points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * lists the points and the hexahedra of a linear cell complex as above, and for each point its vertex attribute:
 * `lcc.point_of_vertex_attribute(vertices[i]) = points[i]` writes a point back.
 *
 * \tparam VertexRange a model of `BackInsertionSequence` whose value type is the descriptor of a vertex attribute,
 *         `LCC::Vertex_attribute_descriptor` (before \cgal 5.6, `LCC::Vertex_attribute_handle`)
 *
 * \param lcc the linear cell complex
 * \param points the points, replaced
 * \param hexahedra the hexahedra, replaced
 * \param vertices the vertex attributes in the order of `points`, replaced
 */
template <class LCC, class PointRange, class HexahedronRange, class VertexRange>
void linear_cell_complex_to_hexahedra(LCC& lcc, PointRange& points, HexahedronRange& hexahedra, VertexRange& vertices)
{
  internal::list_points_and_hexahedra(lcc, points, hexahedra);
  vertices.clear();
  const auto end = lcc.vertex_attributes().end();
  for (auto it = lcc.vertex_attributes().begin(); it != end; ++it)
    vertices.push_back(it);
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_LINEAR_CELL_COMPLEX_TO_HEXAHEDRA_H
