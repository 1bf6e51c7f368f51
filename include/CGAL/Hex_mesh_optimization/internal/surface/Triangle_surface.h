// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H

// Triangles behind a tree: the closest point, and all triangles near a point. It is
// the reference as well as the boundary of the mesh, or a part of it.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Not copyable: the tree points into the triangles.
class Triangle_surface
{
public:
  Triangle_surface(Positions points, std::vector<Triangle_indices> triangles)
    : points(std::move(points))
    , triangles(std::move(triangles))
  {
    for (std::size_t t = 0; t < this->triangles.size(); ++t) {
      if (!has_area(this->points, this->triangles[t]))
        continue;
      soup_.push_back(triangle(this->points, this->triangles[t]));
      index_.push_back(t);
    }
    tree_.insert(soup_.begin(), soup_.end());
    tree_.build();
  }

  Triangle_surface(const Triangle_surface&) = delete;
  Triangle_surface& operator=(const Triangle_surface&) = delete;

  static bool has_area(const Positions& points, const Triangle_indices& t)
  {
    return triangle(points, t).squared_area() > 0;
  }

  // Whether no triangle has an area.
  bool is_empty() const { return soup_.empty(); }

  // hint: that of an earlier result nearby; it saves time, whatever it is. The first search without
  // one takes much longer than the next ones.
  Surface_point closest_point(const Vector_3& query, std::size_t hint = Surface_point::no_hint) const
  {
    const aabb::Kernel::Point_3 q = aabb::point(query);
    const auto found = hint < soup_.size() ? tree_.closest_point_and_primitive(
                                               q, {aabb::Kernel().construct_projected_point_3_object()(soup_[hint], q),
                                                   soup_.begin() + hint})
                                           : tree_.closest_point_and_primitive(q);
    return surface_point(found);
  }

  // The point closest to the query, if it is closer than the given one.
  std::optional<Surface_point> closer_point(const Vector_3& query, const Vector_3& given) const
  {
    if (is_empty())
      return std::nullopt;
    const aabb::Kernel::Point_3 bound = aabb::point(given);
    const auto found = tree_.closest_point_and_primitive(aabb::point(query), {bound, soup_.begin()});
    if (found.first == bound)
      return std::nullopt;
    return surface_point(found);
  }

  // Calls visit(triangle) for those that are not degenerate and whose bounding boxes overlap that of a ball.
  template <class Visit>
  void for_triangles_near(const Vector_3& center, double radius, const Visit& visit) const
  {
    const Vector_3 low = center.array() - radius, high = center.array() + radius;
    const CGAL::Bbox_3 box(low[0], low[1], low[2], high[0], high[1], high[2]);
    const auto visit_primitive = [&](const aabb::Triangle_iterator& triangle) {
      if (CGAL::do_overlap(box, triangle->bbox()))
        visit(index_[triangle - soup_.begin()]);
    };
    aabb::Box_traversal<decltype(visit_primitive)> traversal{visit_primitive};
    tree_.traversal(box, traversal);
  }

  const Vector_3& corner(std::size_t triangle, int k) const { return points[triangles[triangle][k]]; }

  const Positions points;
  const std::vector<Triangle_indices> triangles;

private:
  static aabb::Kernel::Triangle_3 triangle(const Positions& points, const Triangle_indices& t)
  {
    return aabb::Kernel::Triangle_3(aabb::point(points[t[0]]), aabb::point(points[t[1]]), aabb::point(points[t[2]]));
  }

  Surface_point surface_point(const std::pair<aabb::Kernel::Point_3, aabb::Triangle_iterator>& found) const
  {
    const std::size_t place = found.second - soup_.begin(), t = index_[place];
    const Vector_3 point = aabb::vector(found.first);
    const Vector_3 u = corner(t, 1) - corner(t, 0), v = corner(t, 2) - corner(t, 0), w = point - corner(t, 0);
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    const double b = (vv * u.dot(w) - uv * v.dot(w)) / determinant, c = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    return {point, {1 - b - c, b, c}, t, place};
  }

  std::vector<aabb::Kernel::Triangle_3> soup_; // without the degenerate triangles, which have no normal
  std::vector<std::size_t> index_;             // of each, in triangles
  CGAL::AABB_tree<aabb::Triangle_traits> tree_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
