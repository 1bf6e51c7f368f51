// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Mends what Polygon_mesh_processing can of a surface that is to bound a volume.

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/iterator.h>
#include <CGAL/version.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 *
 * stitches borders of a triangle surface that coincide, removes faces without an area, fills holes, removes
 * self-intersections with the faces around them where it can fill what is missing, and orients the components so that they bound
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
#if CGAL_VERSION_NR >= 1050600000
    PMP::triangulate_hole(tmesh, h);
#else
    PMP::triangulate_hole(tmesh, h, CGAL::Emptyset_iterator());
#endif
  if (CGAL::is_closed(tmesh) && PMP::does_self_intersect(tmesh))
    PMP::experimental::remove_self_intersections(tmesh);
  if (CGAL::is_closed(tmesh))
    PMP::orient_to_bound_a_volume(tmesh);
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_REPAIR_SURFACE_H
