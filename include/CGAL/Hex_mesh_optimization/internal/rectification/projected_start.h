// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_PROJECTED_START_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_PROJECTED_START_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A mesh deformed onto its reference: corners are displaced first, curves, faces
// and the interior follow by harmonic displacements and projections.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Projected_start
{
public:
  Projected_start(const Hexahedral_complex& complex, const Reference_surface& surface,
                  const Boundary_attachment& attachment)
    : complex_(complex)
    , surface_(surface)
    , attachment_(attachment)
  {}

  // An affine map of the mesh is found again to rounding where all of its corners are attached.
  // O(n^(4/3)), by conjugate gradients.
  Positions operator()(const Positions& points) const
  {
    Positions displacement(points.size(), Vector_3::Zero());
    std::vector<char> is_placed(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      const Vertex_kind kind = attachment_.kind[v];
      is_placed[v] = kind == Vertex_kind::FIXED || kind == Vertex_kind::CORNER;
      if (kind == Vertex_kind::CORNER)
        displacement[v] = attachment_.corner[v] - points[v];
    }
    for (const Vertex_kind kind : {Vertex_kind::FEATURE, Vertex_kind::SURFACE, Vertex_kind::INTERIOR}) {
      extend(kind, points, is_placed, displacement);
      for (std::size_t v = 0; v < points.size(); ++v)
        if (attachment_.kind[v] == kind) {
          displacement[v] = projection(v, points[v] + displacement[v]) - points[v];
          is_placed[v] = true;
        }
    }
    Positions result = points;
    for (std::size_t v = 0; v < points.size(); ++v)
      result[v] += displacement[v];
    return result;
  }

private:
  // Displacements of the vertices of this kind that are harmonic along the edges between them and those that are placed.
  void extend(Vertex_kind kind, const Positions& points, const std::vector<char>& is_placed,
              Positions& displacement) const
  {
    std::vector<std::array<int, 2>> edges;
    for (std::size_t e = 0; e < complex_.edges.size(); ++e) {
      const auto& [a, b] = complex_.edges[e];
      const bool is_along = kind == Vertex_kind::FEATURE   ? attachment_.curve_of_edge[e] >= 0
                            : kind == Vertex_kind::SURFACE ? complex_.is_boundary_edge[e] != 0
                                                           : true;
      const auto takes_part = [&](int v) { return is_placed[v] || attachment_.kind[v] == kind; };
      if (is_along && takes_part(a) && takes_part(b))
        edges.push_back(complex_.edges[e]);
    }
    Vertex_system system(points.size(), edges);
    for (const auto& [a, b] : edges) {
      const double weight = 1 / (std::max)((points[a] - points[b]).norm(), least_length);
      system.diagonal[a] += weight;
      system.diagonal[b] += weight;
      system.couplings()[system.slot(a, b)] = system.couplings()[system.slot(b, a)] = -weight;
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      system.is_fixed[v] = attachment_.kind[v] != kind;
    system.ties = complex_.ties;
    system.ties.unite(system.is_fixed);
    system.solve(displacement, tolerance, most_iterations);
  }

  Vector_3 projection(std::size_t v, const Vector_3& p) const
  {
    switch (attachment_.kind[v]) {
    case Vertex_kind::FEATURE:
      return surface_.curves[attachment_.curve[v]]->closest_point(p).point;
    case Vertex_kind::SURFACE:
      return surface_.closest_point(p, Surface_point::no_triangle, attachment_.sheet[v]).point;
    default:
      return p;
    }
  }

  static constexpr double least_length = 1e-6, tolerance = 1e-9; // mean boundary edges
  static constexpr int most_iterations = 2000;

  const Hexahedral_complex& complex_;
  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_PROJECTED_START_H
