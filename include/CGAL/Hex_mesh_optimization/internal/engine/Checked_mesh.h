// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H

// The mesh of the caller with everything checked that can be wrong with it, turned the
// right way out and in an order in which neighbors are close in memory.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/quality_statistics.h>

#include <algorithm>
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
  Checked_mesh(const Positions& points, const std::vector<Hexahedron>& hexahedra, const Regions& regions = {})
    : Checked_mesh(points, regions, numbering(points, hexahedra))
  {}

  // As the caller finds it, sums in the same order.
  Quality_statistics statistics(const Positions& positions) const
  {
    return quality_statistics(order.as_given(positions), given_hexahedra_);
  }

  const bool is_reversed;   // they were numbered inside out: bottom and top are exchanged
  const Memory_order order; // in which all that follows is
  const Positions points;
  const Hexahedral_complex complex;

private:
  struct Numbering
  {
    bool is_reversed;
    Memory_order order;
    std::vector<Hexahedron> hexahedra;
  };

  Checked_mesh(const Positions& given, const Regions& regions, Numbering numbering)
    : is_reversed(numbering.is_reversed)
    , order(std::move(numbering.order))
    , points(order.ordered(given))
    , complex(given.size(), order.ordered(numbering.hexahedra), order.ordered(regions))
    , given_hexahedra_(std::move(numbering.hexahedra))
  {}

  static Numbering numbering(const Positions& points, const std::vector<Hexahedron>& hexahedra)
  {
    check(points, hexahedra);
    const Hexahedral_complex complex(points.size(), hexahedra);
    if (complex.boundary_faces.empty())
      throw Input_error(Input_error::Element::MESH, 0, "the mesh has no boundary: every face belongs to two hexahedra");
    if (!(enclosed_volume(points, complex) < 0))
      return {false, Memory_order(complex), hexahedra};
    std::vector<Hexahedron> outwards = reversed(hexahedra);
    Memory_order order(Hexahedral_complex(points.size(), outwards));
    return {true, std::move(order), std::move(outwards)};
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

  static std::vector<Hexahedron> reversed(std::vector<Hexahedron> hexahedra)
  {
    for (Hexahedron& h : hexahedra)
      for (int i = 0; i < 4; ++i)
        std::swap(h[i], h[i + 4]);
    return hexahedra;
  }

  // Six times the volume within the boundary, up to scale: a tangled interior, however far out, does not matter.
  static double enclosed_volume(const Positions& points, const Hexahedral_complex& complex)
  {
    const Vector_3 origin = points[complex.boundary_faces[0].vertices[0]];
    double extent = 0;
    for (const auto& f : complex.boundary_faces)
      for (int v : f.vertices)
        extent = (std::max)(extent, (points[v] - origin).cwiseAbs().maxCoeff());
    double volume = 0;
    for (const auto& f : complex.boundary_faces) {
      Vector_3 p[4];
      for (int i = 0; i < 4; ++i)
        p[i] = (points[f.vertices[i]] - origin) / extent;
      volume += p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3])) + p[1].dot(p[2].cross(p[3])) +
                p[0].dot(p[1].cross(p[3]));
    }
    return volume;
  }

  const std::vector<Hexahedron> given_hexahedra_; // in the caller's order and numbering, but for the orientation
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_CHECKED_MESH_H
