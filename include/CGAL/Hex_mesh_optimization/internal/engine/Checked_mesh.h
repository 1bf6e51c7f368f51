// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The mesh of the caller with everything checked that can be wrong with it, turned the
// right way out and in an order in which neighbors are close in memory.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Translations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/orientation.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/quality_statistics.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Checked_mesh
{
public:
  // Throws Input_error, with elements numbered as the caller knows them.
  Checked_mesh(const Positions& given, const std::vector<Hexahedron>& hexahedra, const Regions& regions = {})
    : Checked_mesh(given, regions, numbering(given, hexahedra, regions))
  {}

  // As the caller finds it, sums in the same order.
  Quality_statistics statistics(const Positions& positions) const
  {
    return quality_statistics(order.as_given(positions), given_hexahedra_);
  }

  const std::vector<std::size_t> reoriented_hexahedra; // as the caller numbers them: bottom and top are exchanged
  const std::size_t number_of_coincident_vertices;     // that would be gone if vertices that coincide were merged
  const Memory_order order;                            // in which all that follows is
  const Positions points;
  const Surroundings surroundings; // if this is a part of a larger mesh
  const Translations translations; // from vertices to those that move with them
  const Hexahedral_complex complex;

private:
  struct Numbering
  {
    std::vector<std::size_t> reoriented_hexahedra;
    std::size_t number_of_coincident_vertices;
    Memory_order order;
    std::vector<Hexahedron> hexahedra;
  };

  Checked_mesh(const Positions& given, const Regions& regions, Numbering numbering)
    : reoriented_hexahedra(std::move(numbering.reoriented_hexahedra))
    , number_of_coincident_vertices(numbering.number_of_coincident_vertices)
    , order(std::move(numbering.order))
    , points(order.ordered(given))
    , surroundings(order.ordered(regions).surroundings)
    , translations(given.size(), order.ordered(regions).ties)
    , complex(given.size(), order.ordered(numbering.hexahedra), order.ordered(regions))
    , given_hexahedra_(std::move(numbering.hexahedra))
  {}

  static Numbering numbering(const Positions& points, const std::vector<Hexahedron>& hexahedra, const Regions& regions)
  {
    check(points, hexahedra);
    check(regions.faces, points.size());
    check(regions.ties, points.size());
    const Face_neighbors neighbors(hexahedra);
    std::vector<std::size_t> reoriented_hexahedra;
    std::vector<Hexahedron> outwards = hexahedra;
    // which way is out, only all of a mesh tells
    if (!regions.surroundings.has_any()) {
      const Orientation orientation(points, hexahedra, neighbors);
      for (std::size_t h = 0; h < hexahedra.size(); ++h)
        if (orientation.is_turned()[h]) {
          reoriented_hexahedra.push_back(h);
          outwards[h] = turned(hexahedra[h]);
        }
    }
    const Hexahedral_complex complex(points.size(), outwards);
    if (complex.boundary_faces.empty())
      throw Input_error(Input_error::Element::MESH, 0, "the mesh has no boundary: every face belongs to two hexahedra");
    const std::vector<int> coincident = coincident_vertices(points, neighbors);
    std::size_t number_of_coincident_vertices = 0;
    for (std::size_t v = 0; v < coincident.size(); ++v)
      number_of_coincident_vertices += coincident[v] != static_cast<int>(v);
    return {std::move(reoriented_hexahedra), number_of_coincident_vertices, Memory_order(complex), std::move(outwards)};
  }

  static void check(const Positions& points, const std::vector<Hexahedron>& hexahedra)
  {
    using Element = Input_error::Element;
    if (hexahedra.empty())
      throw Input_error(Element::MESH, 0, "the mesh has no hexahedra");
    if (points.size() > std::size_t((std::numeric_limits<int>::max)()) / 8 ||
        hexahedra.size() > std::size_t((std::numeric_limits<int>::max)()) / 24)
      throw Input_error(Element::MESH, 0, "the mesh is larger than its indices can count");
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!points[v].allFinite())
        throw Input_error(Element::VERTEX, v, "vertex " + std::to_string(v) + " has a coordinate that is not finite");
    for (std::size_t h = 0; h < hexahedra.size(); ++h)
      for (int i = 0; i < 8; ++i) {
        if (hexahedra[h][i] < 0 || std::size_t(hexahedra[h][i]) >= points.size())
          throw Input_error(Element::HEXAHEDRON, h,
                            "hexahedron " + std::to_string(h) + " refers to a vertex that does not exist");
        for (int j = 0; j < i; ++j)
          if (hexahedra[h][i] == hexahedra[h][j])
            throw Input_error(Element::HEXAHEDRON, h,
                              "hexahedron " + std::to_string(h) + " has vertex " + std::to_string(hexahedra[h][i]) +
                                " at two corners");
      }
  }

  static void check(const std::vector<std::array<int, 4>>& internal_faces, std::size_t number_of_vertices)
  {
    for (std::size_t f = 0; f < internal_faces.size(); ++f)
      for (int v : internal_faces[f])
        if (v < 0 || std::size_t(v) >= number_of_vertices)
          throw Input_error(Input_error::Element::PARAMETER, f,
                            "internal face " + std::to_string(f) + " refers to a vertex that does not exist");
  }

  static void check(const std::vector<Tie>& ties, std::size_t number_of_vertices)
  {
    for (std::size_t i = 0; i < ties.size(); ++i) {
      for (int v : {ties[i].vertex, ties[i].partner})
        if (v < 0 || std::size_t(v) >= number_of_vertices)
          throw Input_error(Input_error::Element::PARAMETER, i,
                            "periodic pair " + std::to_string(i) + " refers to a vertex that does not exist");
      if (!ties[i].translation.allFinite())
        throw Input_error(Input_error::Element::PARAMETER, i,
                          "the translation of periodic pair " + std::to_string(i) + " is not finite");
    }
  }

  const std::vector<Hexahedron> given_hexahedra_; // in the caller's order and numbering, but for the orientation
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H
