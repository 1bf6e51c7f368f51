// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_FACET_FREEDOMS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_FACET_FREEDOMS_H

// Where a point of a triangle surface can go without leaving it: within its
// triangle; at a kink, where a force pulls it, into one of the triangles around, or
// along an edge, if it is pulled into the edge from both sides.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Freedom.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Hex_mesh_optimization::internal {

class Facet_freedoms
{
public:
  // The surface must outlive the object. O(triangles).
  explicit Facet_freedoms(const Triangle_surface& surface)
    : surface_(surface)
    , fans_(
        surface.points.size(), 3 * surface.triangles.size(),
        [&](std::size_t corner) { return surface.triangles[corner / 3][corner % 3]; },
        [](std::size_t corner) { return static_cast<int>(corner / 3); })
  {}

  // Of a point on the surface. O(triangles around it). A tangent plane of the surface that is meant would be no good: what
  // leaves the triangle is undone, and with it what the step was to gain (measured on a CAD part, all of it on its
  // reference: the minimum was .40 instead of .04).
  Freedom freedom(const Surface_point& p, const Vector_3& force) const
  {
    const Carrier at = carrier(p);
    if (at.size == 3) {
      const auto normal = normal_of(p.triangle);
      return normal ? Freedom::along_plane(*normal) : Freedom::everywhere();
    }
    std::optional<Freedom> result;
    double strongest = 0; // pull within the facet or along the edge
    for_facets(p, at, [&](std::size_t t, const Vector_3& normal) {
      const Vector_3 pull = force - normal.dot(force) * normal;
      if (leads_into(t, normal, at, pull) && (!result || pull.norm() > strongest)) {
        strongest = pull.norm();
        result = Freedom::along_plane(normal);
      }
    });
    if (result)
      return *result;
    if (at.size == 2)
      return Freedom::along_line(direction(at.vertices[0], at.vertices[1]));
    result = Freedom::nowhere();
    for_facets(p, at, [&](std::size_t t, const Vector_3&) {
      for (int v : surface_.triangles[t]) {
        const Vector_3 edge = v == at.vertices[0] ? Vector_3::Zero() : direction(at.vertices[0], v);
        if (edge.dot(force) > strongest) {
          strongest = edge.dot(force);
          result = Freedom::along_line(edge);
        }
      }
    });
    return *result;
  }

  // What is left of a step with such a freedom that leads the other way: coupled with others, a point need not go where it is
  // pulled.
  Vector_3 within(const Surface_point& p, const Vector_3& step) const
  {
    const Carrier at = carrier(p);
    if (at.size == 3 || step.isZero(0))
      return step;
    bool is_within = false;
    for_facets(p, at, [&](std::size_t t, const Vector_3& normal) {
      is_within = is_within ||
                  (std::abs(normal.dot(step)) <= rounding_of_step * step.norm() && leads_into(t, normal, at, step));
    });
    if (is_within)
      return step;
    if (at.size == 1)
      return Vector_3::Zero();
    const Vector_3 edge = direction(at.vertices[0], at.vertices[1]);
    return edge.dot(step) * edge;
  }

private:
  // The vertex, the edge or the triangle that a point is in the inside of.
  struct Carrier
  {
    std::array<int, 3> vertices{};
    int size = 0; // number of the vertices

    bool has(int v) const
    {
      for (int k = 0; k < size; ++k)
        if (vertices[k] == v)
          return true;
      return false;
    }
  };

  static constexpr double rounding = 1e-9;         // of barycentric coordinates
  static constexpr double rounding_of_step = 1e-6; // the system is solved in single precision

  Carrier carrier(const Surface_point& p) const
  {
    Carrier result;
    for (int k = 0; k < 3; ++k)
      if (!(p.coordinates[k] <= rounding))
        result.vertices[result.size++] = surface_.triangles[p.triangle][k];
    return result;
  }

  // None without an area.
  std::optional<Vector_3> normal_of(std::size_t t) const
  {
    const Vector_3& a = surface_.corner(t, 0);
    const Vector_3 normal = (surface_.corner(t, 1) - a).cross(surface_.corner(t, 2) - a);
    if (!(normal.norm() > 0))
      return std::nullopt;
    return normal.normalized();
  }

  Vector_3 direction(int from, int to) const { return (surface_.points[to] - surface_.points[from]).normalized(); }

  // Calls visit(triangle, normal) for those of the point's sheet that have its carrier.
  template <class Visit>
  void for_facets(const Surface_point& p, const Carrier& at, const Visit& visit) const
  {
    for (int t : fans_[at.vertices[0]]) {
      if (!surface_.sheets.empty() && surface_.sheets[t] != surface_.sheets[p.triangle])
        continue;
      int common = 0;
      for (int v : surface_.triangles[t])
        common += at.has(v);
      if (common < at.size)
        continue;
      if (const auto normal = normal_of(t))
        visit(static_cast<std::size_t>(t), *normal);
    }
  }

  // Whether a direction in the plane of a triangle leads from the carrier into it.
  bool leads_into(std::size_t t, const Vector_3& normal, const Carrier& at, const Vector_3& d) const
  {
    const Triangle_indices& corners = surface_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 3];
      if (at.size == 1 ? !at.has(a) && !at.has(b) : !at.has(a) || !at.has(b))
        continue; // that side is elsewhere
      const Vector_3 inwards = normal.cross(surface_.points[b] - surface_.points[a]);
      if (inwards.dot(d) < -rounding * inwards.norm() * d.norm())
        return false;
    }
    return true;
  }

  const Triangle_surface& surface_;
  const Grouped_array fans_; // the triangles around each vertex
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_FACET_FREEDOMS_H
