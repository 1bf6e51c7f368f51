// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_DEVIATIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_DEVIATIONS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How far the boundary of a mesh that is distributed over ranks has gone from where it was. Every rank has all of the boundary,
// which is small against the mesh.

#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/parts/Distributed_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// With the vertices at these places; certified if the bound, a length, is finite. spacing: in mean boundary edges. Collective.
inline Deviations distributed_deviations(const Distributed_mesh& mesh, const Block_array<Triple>& places, double bound,
                                         double spacing, const Certification_parameters& certification)
{
  const auto in_units = [&](const Block_array<Triple>& of_vertices) {
    Positions result;
    for (const Triple& p : mesh.ranks.fetch<Triple>(mesh.number_of_vertices, of_vertices, mesh.boundary_vertices))
      result.push_back(as_vector(p) / mesh.unit);
    return result;
  };
  Positions given = in_units(mesh.given), points = in_units(places);
  const Vector_3 center = given.front();
  for (Positions* of : {&given, &points})
    for (Vector_3& p : *of)
      p -= center;
  const Triangle_surface reference(given, split_quads(mesh.boundary.quads), triangle_sheets(mesh.boundary));
  if (reference.is_empty())
    throw Input_error(Input_error::Element::MESH, 0, "the boundary of the mesh has no face with an area");
  Deviations result = deviations(mesh.boundary, points, reference, spacing);
  const auto scale = [&](Deviation& d) {
    d.average *= mesh.unit;
    d.maximum *= mesh.unit;
  };
  scale(result.all);
  for (Deviation& d : result.of_sheet)
    scale(d);
  for (const std::array<int, 4>& q : mesh.boundary.quads)
    result.all.bilinear = (std::max)(result.all.bilinear,
                                     mesh.unit * (points[q[0]] - points[q[1]] + points[q[2]] - points[q[3]]).norm() /
                                       4);
  if (std::isfinite(bound))
    result.all.certified =
      mesh.unit * certified_deviation(mesh.boundary, points, reference, bound / mesh.unit, certification).upper_bound;
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_DISTRIBUTED_DEVIATIONS_H
