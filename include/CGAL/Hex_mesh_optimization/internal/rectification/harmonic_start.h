// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_HARMONIC_START_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_HARMONIC_START_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A start for meshes most of whose hexahedra are inverted: where the given
// interior says nothing, the boundary says more.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>

#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Moves every free interior vertex to the mean of its neighbors, the others held.
inline void harmonic_start(const Hexahedral_complex& complex, const Boundary_attachment& attachment, Positions& points)
{
  Vertex_system system(complex.number_of_vertices(), complex.edges);
  for (const std::array<int, 2>& e : complex.edges) {
    ++system.diagonal[e[0]];
    ++system.diagonal[e[1]];
    system.couplings()[system.slot(e[0], e[1])] = -1;
    system.couplings()[system.slot(e[1], e[0])] = -1;
  }
  for (std::size_t v = 0; v < points.size(); ++v)
    system.is_fixed[v] = attachment.kind[v] != Vertex_kind::INTERIOR;
  system.ties = complex.ties;
  system.ties.unite(system.is_fixed);
  const double tolerance = 1e-3;
  const int iterations = 1000;
  system.solve(points, tolerance, iterations);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_HARMONIC_START_H
