// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_CHECK_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_CHECK_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Whether a triangle surface bounds a volume that can be meshed, and if not, what is wrong and where.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Throws Input_error when constructed, unless the surface bounds a volume.
class Surface_check
{
public:
  explicit Surface_check(const Reference_input& surface) : surface_(surface)
  {
    require_finite();
    for (const Vector_3& p : surface.points)
      mesh_.add_vertex(Point(p[0], p[1], p[2]));
    for (const Triangle_indices& t : surface.triangles)
      mesh_.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    require_closed();
    require_area();
    require_no_intersection();
    require_volume();
  }

private:
  using Point = Exact_predicates_inexact_constructions_kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>; // exact, whatever the kernel of the caller
  using Element = Input_error::Element;

  static Mesh::Vertex_index vertex(int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); }

  std::string place(int v) const
  {
    std::ostringstream out;
    const Vector_3& p = surface_.points[v];
    out << "vertex " << v << " at (" << p[0] << ' ' << p[1] << ' ' << p[2] << ')';
    return out.str();
  }

  void require_finite() const
  {
    if (surface_.triangles.empty())
      throw Input_error(Element::MESH, 0, "the surface has no faces");
    for (std::size_t v = 0; v < surface_.points.size(); ++v)
      if (!surface_.points[v].allFinite())
        throw Input_error(Element::REFERENCE_VERTEX, v,
                          "vertex " + std::to_string(v) + " of the surface has a coordinate that is not finite");
  }

  void require_closed() const
  {
    std::size_t count = 0;
    Mesh::Halfedge_index first;
    for (const auto h : mesh_.halfedges())
      if (mesh_.is_border(h) && count++ == 0)
        first = h;
    if (count == 0)
      return;
    const int a = static_cast<int>(mesh_.source(first)), b = static_cast<int>(mesh_.target(first));
    throw Input_error(Element::REFERENCE_FACE, mesh_.face(mesh_.opposite(first)),
                      "the surface is open: " + std::to_string(count) +
                        " of its edges have a face on one side only, "
                        "the first from " +
                        place(a) + " to " + place(b));
  }

  void require_area() const
  {
    for (std::size_t f = 0; f < surface_.triangles.size(); ++f) {
      const Triangle_indices& t = surface_.triangles[f];
      const auto p = [&](int k) { return mesh_.point(vertex(t[k])); };
      if (CGAL::collinear(p(0), p(1), p(2)))
        throw Input_error(Element::REFERENCE_FACE, f,
                          "face " + std::to_string(f) + " of the surface has no area, at " + place(t[0]));
    }
  }

  void require_no_intersection() const
  {
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    Polygon_mesh_processing::self_intersections(mesh_, std::back_inserter(pairs));
    if (pairs.empty())
      return;
    for (auto& pair : pairs)
      pair = std::minmax({pair.first, pair.second});
    const auto first = *std::min_element(pairs.begin(), pairs.end());
    throw Input_error(Element::REFERENCE_FACE, first.first,
                      "the surface intersects itself: " + std::to_string(pairs.size()) + " pairs of faces, the first " +
                        std::to_string(std::size_t(first.first)) + " and " + std::to_string(std::size_t(first.second)) +
                        ", near " + place(surface_.triangles[first.first][0]));
  }

  // Inside out, a surface bounds a volume as well for CGAL: all the rest of space.
  void require_volume() const
  {
    if (!Polygon_mesh_processing::is_outward_oriented(mesh_))
      throw Input_error(Element::MESH, 0, "the surface is oriented inwards: its faces run clockwise seen from outside");
    if (!Polygon_mesh_processing::does_bound_a_volume(mesh_))
      throw Input_error(
        Element::MESH, 0,
        "the components of the surface are not oriented so that they bound a volume: one within another "
        "has to be oriented the other way");
  }

  const Reference_input& surface_;
  Mesh mesh_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_CHECK_H
