// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Mends what Polygon_mesh_processing can of a surface that is to bound a volume.

#include <CGAL/Hex_mesh_optimization/Surface_repair.h>
#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/iterator.h>
#include <CGAL/version.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

namespace internal {

template <class TriangleMesh>
void fill_hole(TriangleMesh& tmesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor border)
{
#if CGAL_VERSION_NR >= 1050600000
  Polygon_mesh_processing::triangulate_hole(tmesh, border);
#else
  Polygon_mesh_processing::triangulate_hole(tmesh, border, CGAL::Emptyset_iterator());
#endif
}

// The vertex whose faces take part in the most intersections is left out, and the hole filled, as long as that makes
// intersections fewer: so a vertex that was pulled through the opposite side goes, and that side stays. The surface is
// closed.
template <class TriangleMesh>
void leave_out_intersecting_vertices(TriangleMesh& tmesh)
{
  namespace PMP = Polygon_mesh_processing;
  using Face = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  const auto intersections = [](const TriangleMesh& of) {
    std::vector<std::pair<Face, Face>> result;
    PMP::self_intersections(of, std::back_inserter(result));
    return result;
  };
  constexpr int most_vertices = 100; // more are no accident
  std::vector<std::pair<Face, Face>> pairs = intersections(tmesh);
  for (int i = 0; i < most_vertices && !pairs.empty(); ++i) {
    std::map<Vertex, std::size_t> number;
    for (const auto& pair : pairs) {
      std::set<Vertex> around; // a pair counts once
      for (const Face f : {pair.first, pair.second})
        for (const Vertex v : CGAL::vertices_around_face(CGAL::halfedge(f, tmesh), tmesh))
          around.insert(v);
      for (const Vertex v : around)
        ++number[v];
    }
    const Vertex worst = std::max_element(number.begin(), number.end(), [](const auto& a, const auto& b) {
                           return a.second < b.second;
                         })->first;
    TriangleMesh other = tmesh;
    const auto hole = CGAL::Euler::remove_center_vertex(CGAL::halfedge(worst, other), other);
    CGAL::Euler::make_hole(hole, other);
    fill_hole(other, hole);
    std::vector<std::pair<Face, Face>> left = CGAL::is_closed(other) ? intersections(other) : pairs;
    if (left.size() >= pairs.size())
      return;
    tmesh = std::move(other);
    pairs = std::move(left);
  }
}

} // namespace internal

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * stitches borders of a triangle surface that coincide, removes faces without an area, fills holes, leaves out vertices
 * that were pulled through the opposite side, removes other self-intersections with the faces around them where it can fill
 * what is missing, and orients the components so that they bound
 * a volume. Whether that went well is for `check_surface()` to say.
 *
 * \tparam TriangleMesh a model of `MutableFaceGraph`, `FaceListGraph` and `HalfedgeListGraph` with an internal point
 *         property of a kernel with exact predicates
 *
 * \param tmesh the surface
 */
template <class TriangleMesh>
void repair_surface(TriangleMesh& tmesh)
{
  namespace PMP = Polygon_mesh_processing;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  PMP::stitch_borders(tmesh);
  PMP::remove_degenerate_faces(tmesh);
  std::vector<Halfedge> borders;
  PMP::extract_boundary_cycles(tmesh, std::back_inserter(borders));
  for (const Halfedge h : borders)
    internal::fill_hole(tmesh, h);
  if (CGAL::is_closed(tmesh))
    internal::leave_out_intersecting_vertices(tmesh);
  if (CGAL::is_closed(tmesh) && PMP::does_self_intersect(tmesh))
    PMP::experimental::remove_self_intersections(tmesh);
  if (CGAL::is_closed(tmesh))
    PMP::orient_to_bound_a_volume(tmesh);
}

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * mends a triangle soup that is to bound a volume, where `CGAL::make_hex_mesh()` would refuse it: closes holes, whatever their
 * size, and leaves out vertices that were pulled through the opposite side. What that function understands by itself stays:
 * parts that overlap, touch or are turned, borders that nearly meet, copies.
 *
 * \tparam PointRange a `std::vector` of models of `HexMeshOptimizationPoint_3`
 * \tparam TriangleRange a `std::vector` of arrays of three integers
 *
 * \return what has changed, with the volume before and after
 *
 * \throws Input_error where the triangles do not bound a volume together
 */
template <class PointRange, class TriangleRange>
Surface_repair repair_surface(PointRange& points, TriangleRange& triangles)
{
  internal::Reference_input surface = internal::triangles_to_reference(points, triangles);
  const std::size_t n = surface.triangles.size();
  const internal::Positions before = surface.points;
  const Surface_repair result = internal::repair_triangles(surface);
  if (surface.triangles.size() == n && surface.points == before && result.number_of_skipped_vertices == 0)
    return result;
  points.clear();
  for (const internal::Vector_3& p : surface.points)
    points.push_back(typename PointRange::value_type(p[0], p[1], p[2]));
  triangles.clear();
  for (const internal::Triangle_indices& t : surface.triangles) {
    typename TriangleRange::value_type triangle;
    for (int k = 0; k < 3; ++k)
      triangle[k] = static_cast<std::decay_t<decltype(triangle[0])>>(t[k]);
    triangles.push_back(triangle);
  }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H
