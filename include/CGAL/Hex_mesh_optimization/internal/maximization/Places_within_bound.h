// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PLACES_WITHIN_BOUND_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PLACES_WITHIN_BOUND_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where a search may take vertices whose faces keep to a bound of the deviation.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Places_within_bound
{
public:
  // points: how many the mesh has. All but that must outlive the object; samples must be up to date.
  Places_within_bound(const Reference_surface& surface, const Boundary_attachment& attachment, const Sliding& sliding,
                      Boundary_samples& samples, std::size_t points)
    : surface_(surface)
    , attachment_(attachment)
    , sliding_(sliding)
    , samples_(samples)
    , faces_around_(
        points, 4 * samples.faces().size(), [&](std::size_t i) { return samples.faces()[i / 4][i % 4]; },
        [](std::size_t i) { return static_cast<int>(i / 4); })
  {}

  std::vector<int> movable_with(int v) const { return sliding_.movable_with(v); }

  struct Departure
  {
    Vector_3 from, way; // to `from`, from the closest point of the curve or the surface
    std::size_t triangle = Surface_point::no_triangle; // of that
  };

  Departure departure(int v, const Vector_3& from) const
  {
    if (attachment_.kind[v] == Vertex_kind::FEATURE)
      return {from, from - on_curve(v, from)};
    if (attachment_.kind[v] != Vertex_kind::SURFACE)
      return {from, Vector_3::Zero()};
    const Surface_point foot = on_surface(v, from, Surface_point::no_triangle);
    return {from, from - foot.point, foot.triangle};
  }

  // Along its curve or the surface, and as far from it as before: steps in other directions soon leave the bound.
  Vector_3 reached(int v, const Departure& departure, const Vector_3& to) const
  {
    switch (attachment_.kind[v]) {
    case Vertex_kind::FEATURE:
      return on_curve(v, to) + departure.way;
    case Vertex_kind::SURFACE:
      return on_surface(v, to, departure.triangle).point + departure.way;
    default:
      return sliding_.reached(v, departure.from, to);
    }
  }

  bool allows(const std::vector<int>& vertices, const Positions& points) const
  {
    std::vector<int> faces;
    for (int v : vertices)
      faces.insert(faces.end(), faces_around_[v].begin(), faces_around_[v].end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return samples_.are_within(faces, points);
  }

private:
  Vector_3 on_curve(int v, const Vector_3& p) const
  {
    return surface_.curves[attachment_.curve[v]]->closest_point(p).point;
  }

  Surface_point on_surface(int v, const Vector_3& p, std::size_t near) const
  {
    return surface_.closest_point(p, near, attachment_.sheet[v]);
  }

  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  const Sliding& sliding_;
  Boundary_samples& samples_;
  const Grouped_array faces_around_; // the vertices
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PLACES_WITHIN_BOUND_H
