// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_AABB_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_AABB_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The trees of CGAL that triangles and segments are searched with, for all of its
// versions.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <boost/variant/get.hpp>
#endif

#include <variant>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

namespace aabb {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle_iterator = std::vector<Kernel::Triangle_3>::const_iterator;
using Segment_iterator = std::vector<Kernel::Segment_3>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
using Triangle_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Triangle_iterator>>;
using Segment_traits = CGAL::AABB_traits_3<Kernel, CGAL::AABB_segment_primitive_3<Kernel, Segment_iterator>>;
#else
using Triangle_traits = CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangle_iterator>>;
using Segment_traits = CGAL::AABB_traits<Kernel, CGAL::AABB_segment_primitive<Kernel, Segment_iterator>>;
#endif

inline Kernel::Point_3 point(const Vector_3& p) { return Kernel::Point_3(p[0], p[1], p[2]); }
inline Vector_3 vector(const Kernel::Point_3& p) { return Vector_3(p.x(), p.y(), p.z()); }

// What an intersection is, if it is a T, else null: CGAL 6 has variants of the standard library, before of Boost.
template <class T, class Variant>
const T* get_if(const Variant* intersection)
{
#if CGAL_VERSION_NR >= 1060000000
  return std::get_if<T>(intersection);
#else
  return boost::get<T>(intersection);
#endif
}

// Traversal traits that visit all primitives whose bounding boxes may overlap a box.
template <class Visit>
struct Box_traversal
{
  const Visit& visit;

  bool go_further() const { return true; }

  template <class Primitive>
  void intersection(const CGAL::Bbox_3&, const Primitive& primitive) const
  {
    visit(primitive.id());
  }

  template <class Node>
  bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const
  {
    return CGAL::do_overlap(box, node.bbox());
  }
};

} // namespace aabb

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_AABB_H
