// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_COINCIDENT_VERTICES_H
#define CGAL_HEX_MESH_OPTIMIZATION_COINCIDENT_VERTICES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Finds vertices that a file or a generator has written twice.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/coincident_vertices.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationRef
 *
 * finds the vertices that faces of the boundary have in the same places: hexahedra that were to be neighbors, but have
 * vertices of their own, would part when they are optimized. To merge them, replace each index in `hexahedra` by what
 * is returned for it.
 *
 * Two faces coincide if their corners are in the same four different places. Vertices that are in one place
 * without a face in common are not merged: a hexahedron may have collapsed there.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type is a model of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a model of `RandomAccessContainer` whose value type is a range of eight indices of an
 *         integral type
 *
 * \param points the positions of the vertices
 * \param hexahedra the indices of their vertices
 * \param tolerance how far places may be apart that are the same, as a part of the shortest edge at either of the
 *        vertices: 0 for equal coordinates, 1e-4 for those that were rounded
 *
 * \return for each vertex the smallest index among those that it coincides with, mostly its own
 *
 * \throws Input_error naming the hexahedron if it does not have eight vertices that exist, or the vertex if it has a
 *         coordinate that is not finite
 *
 * Complexity: \f$ O(n \log n) \f$.
 */
template <class PointRange, class HexahedronRange>
std::vector<std::size_t> coincident_vertices(const PointRange& points, const HexahedronRange& hexahedra,
                                             double tolerance = 0)
{
  if (points.size() > std::size_t((std::numeric_limits<int>::max)()) / 8 ||
      hexahedra.size() > std::size_t((std::numeric_limits<int>::max)()) / 24)
    throw Input_error(Input_error::Element::MESH, 0, "the mesh is larger than its indices can count");
  internal::Positions positions;
  positions.reserve(points.size());
  for (const auto& p : points) {
    positions.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    if (!positions.back().allFinite())
      throw Input_error(Input_error::Element::VERTEX, positions.size() - 1,
                        "vertex " + std::to_string(positions.size() - 1) + " has a coordinate that is not finite");
  }
  std::vector<internal::Hexahedron> cells;
  cells.reserve(hexahedra.size());
  for (const auto& h : hexahedra) {
    internal::Hexahedron cell;
    std::size_t corner = 0;
    for (const auto& v : h) {
      const auto index = static_cast<unsigned long long>(v); // negative ones become huge
      if (corner == 8 || index >= points.size())
        throw Input_error(Input_error::Element::HEXAHEDRON, cells.size(),
                          "hexahedron " + std::to_string(cells.size()) + " does not have eight vertices that exist");
      cell[corner++] = static_cast<int>(index);
    }
    if (corner < 8)
      throw Input_error(Input_error::Element::HEXAHEDRON, cells.size(),
                        "hexahedron " + std::to_string(cells.size()) + " does not have eight vertices that exist");
    cells.push_back(cell);
  }
  const std::vector<int> result = internal::coincident_vertices(positions, internal::Face_neighbors(cells), tolerance);
  return std::vector<std::size_t>(result.begin(), result.end());
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_COINCIDENT_VERTICES_H
