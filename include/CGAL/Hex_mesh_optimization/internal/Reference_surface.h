// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_SURFACE_H

// The surface that the boundary of the mesh has to stay on, and its feature
// curves, both behind AABB trees: closest point and normal, closest point of a
// curve and tangent.

#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>

#include <CGAL/AABB_tree.h>
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
#endif

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

using Triangle_indices = std::array<int, 3>;

struct Surface_point
{
  Vector_3 point;
  Vector_3 normal; // unit length, outwards
  std::size_t triangle;
};

struct Curve_point
{
  Vector_3 point;
  Vector_3 tangent; // unit length
};

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

} // namespace aabb

// A polyline of feature edges between two corners, or closed. Not copyable: the
// tree points into the segments.
class Feature_curve
{
public:
  Feature_curve(std::vector<int> reference_vertices, const Positions& points)
    : vertices(std::move(reference_vertices))
  {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const Vector_3 &a = points[vertices[i]], &b = points[vertices[i + 1]];
      length += (b - a).norm();
      if (a != b)
        segments_.emplace_back(aabb::point(a), aabb::point(b));
    }
    tree_.insert(segments_.begin(), segments_.end());
    tree_.build();
  }

  Feature_curve(const Feature_curve&) = delete;
  Feature_curve& operator=(const Feature_curve&) = delete;

  bool is_closed() const { return vertices.front() == vertices.back(); }

  Curve_point closest_point(const Vector_3& query) const
  {
    const auto found = tree_.closest_point_and_primitive(aabb::point(query));
    const Vector_3 a = aabb::vector(found.second->source()), b = aabb::vector(found.second->target());
    return {aabb::vector(found.first), (b - a).normalized()};
  }

  std::vector<int> vertices; // of the reference, in order; first equals last on a closed curve
  double length = 0;

private:
  std::vector<aabb::Kernel::Segment_3> segments_;
  CGAL::AABB_tree<aabb::Segment_traits> tree_;
};

class Reference_surface
{
public:
  Reference_surface(Positions points, std::vector<Triangle_indices> triangles)
    : points(std::move(points))
    , triangles(std::move(triangles))
  {
    for (std::size_t t = 0; t < this->triangles.size(); ++t) {
      const aabb::Kernel::Triangle_3 triangle(aabb::point(corner(t, 0)), aabb::point(corner(t, 1)), aabb::point(corner(t, 2)));
      if (triangle.squared_area() > 0)
        add(triangle, t);
    }
    tree_.insert(soup_.begin(), soup_.end());
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  Reference_surface(const Reference_surface&) = delete;
  Reference_surface& operator=(const Reference_surface&) = delete;

  bool is_empty() const { return soup_.empty(); }

  Surface_point closest_point(const Vector_3& query) const
  {
    const auto found = tree_.closest_point_and_primitive(aabb::point(query));
    const aabb::Kernel::Triangle_3& t = *found.second;
    const Vector_3 a = aabb::vector(t[0]);
    return {aabb::vector(found.first), (aabb::vector(t[1]) - a).cross(aabb::vector(t[2]) - a).normalized(),
            index_[found.second - soup_.begin()]};
  }

  const Vector_3& corner(std::size_t triangle, int k) const { return points[triangles[triangle][k]]; }

  Positions points;
  std::vector<Triangle_indices> triangles;
  std::vector<std::unique_ptr<Feature_curve>> curves;
  std::vector<int> corners; // vertices where curves meet, end or turn sharply

private:
  void add(const aabb::Kernel::Triangle_3& triangle, std::size_t index)
  {
    soup_.push_back(triangle);
    index_.push_back(index);
  }

  std::vector<aabb::Kernel::Triangle_3> soup_; // without the degenerate triangles, which have no normal
  std::vector<std::size_t> index_;             // of each, in triangles
  CGAL::AABB_tree<aabb::Triangle_traits> tree_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_SURFACE_H
