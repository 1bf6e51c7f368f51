// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Triangles behind trees: the closest point, and all triangles near a point. It is
// the reference as well as the boundary of the mesh, or a part of it.
//
// A surface may consist of sheets, each of which is searched for itself: what belongs to one is not mistaken for
// another that is close, or that meets it.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Not copyable: the trees point into the triangles.
class Triangle_surface
{
public:
  // its_sheets: of the triangles, counted from 0; none: all are in one.
  Triangle_surface(Positions its_points, std::vector<Triangle_indices> its_triangles, std::vector<int> its_sheets = {},
                   Rims its_rims = {})
    : points(std::move(its_points))
    , triangles(std::move(its_triangles))
    , sheets(std::move(its_sheets))
    , rims(std::move(its_rims))
  {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (has_area(points, triangles[t]))
        index_.push_back(t);
    if (!sheets.empty())
      std::sort(index_.begin(), index_.end(),
                [&](std::size_t a, std::size_t b) { return sheet(a) < sheet(b) || (sheet(a) == sheet(b) && a < b); });
    soup_.reserve(index_.size());
    places_.resize(triangles.size(), nowhere);
    for (std::size_t t : index_) {
      places_[t] = soup_.size();
      soup_.push_back(triangle(points, triangles[t]));
    }
    const int count = sheets.empty() ? 1 : 1 + *std::max_element(sheets.begin(), sheets.end());
    sheets_.resize(count);
    for (std::size_t i = 0; i < index_.size(); ++i)
      ++sheets_[sheet(index_[i])].size;
    std::size_t begin = 0;
    for (Sheet& of : sheets_) {
      of.begin = begin;
      begin += of.size;
      of.tree = std::make_unique<Tree>(soup_.begin() + of.begin, soup_.begin() + begin);
      of.tree->build();
    }
  }

  Triangle_surface(const Triangle_surface&) = delete;
  Triangle_surface& operator=(const Triangle_surface&) = delete;

  static bool has_area(const Positions& points, const Triangle_indices& t)
  {
    return triangle(points, t).squared_area() > 0;
  }

  // Whether no triangle has an area.
  bool is_empty() const { return soup_.empty(); }

  std::size_t number_of_sheets() const { return sheets_.size(); }
  int sheet(std::size_t triangle) const { return sheets.empty() ? 0 : sheets[triangle]; }

  // In a sheet; if nothing of that has an area, in one that has. The surface must not be empty.
  // near: a triangle, as that of an earlier result nearby; it saves time, whatever it is. The first search without
  // one takes much longer than the next ones.
  Surface_point closest_point(const Vector_3& query, std::size_t near = Surface_point::no_triangle, int sheet = 0) const
  {
    const Sheet& s = searched(sheet);
    const aabb::Kernel::Point_3 q = aabb::point(query);
    if (near >= places_.size() || !s.has(places_[near]))
      return surface_point(s.tree->closest_point_and_primitive(q));
    const Surface_point bound = closest_point_of_triangle(query, near, points, triangles);
    if (is_near(query, bound))
      return closest_point_in_box(query, bound, s);
    return surface_point(
      s.tree->closest_point_and_primitive(q, {aabb::point(bound.point), soup_.begin() + places_[near]}));
  }

  // The point of a sheet closest to the query, if it is closer than the given one.
  std::optional<Surface_point> closer_point(const Vector_3& query, const Vector_3& given, int sheet = 0) const
  {
    if (std::size_t(sheet) >= sheets_.size() || sheets_[sheet].size == 0)
      return std::nullopt;
    const Sheet& s = sheets_[sheet];
    const aabb::Kernel::Point_3 bound = aabb::point(given);
    const auto found = s.tree->closest_point_and_primitive(aabb::point(query), {bound, soup_.begin() + s.begin});
    if (found.first == bound)
      return std::nullopt;
    return surface_point(found);
  }

  // Calls visit(triangle) for those of a sheet that are not degenerate and whose bounding boxes overlap that of a ball.
  template <class Visit>
  void for_triangles_near(const Vector_3& center, double radius, const Visit& visit, int sheet = 0) const
  {
    for_triangles_near(center, radius, visit, sheets_[sheet]);
  }

  // Of the way from its foot, a closest point, to the query what counts: all of it, but where the surface goes on beyond a
  // rim.
  Vector_3 way(const Vector_3& query, const Surface_point& foot) const
  {
    const Vector_3 all = query - foot.point;
    const int at_rim = rims.triangle_at(foot);
    if (at_rim == Rims::none)
      return all;
    if (rims.beyond == Beyond_rim::ANYTHING)
      return Vector_3::Zero();
    const Vector_3 normal = plane_normal(at_rim);
    return normal.dot(all) * normal;
  }

  // Of a triangle with an area.
  Vector_3 plane_normal(std::size_t triangle) const
  {
    const Vector_3& a = corner(triangle, 0);
    return (corner(triangle, 1) - a).cross(corner(triangle, 2) - a).normalized();
  }

  const Vector_3& corner(std::size_t triangle, int k) const { return points[triangles[triangle][k]]; }

  const Positions points;
  const std::vector<Triangle_indices> triangles;
  const std::vector<int> sheets; // of the triangles, or none
  const Rims rims;

private:
  using Tree = CGAL::AABB_tree<aabb::Triangle_traits>;

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  struct Sheet
  {
    std::size_t begin = 0, size = 0; // in the soup
    std::unique_ptr<Tree> tree;

    bool has(std::size_t place) const { return place >= begin && place - begin < size; }
  };

  template <class Visit>
  void for_triangles_near(const Vector_3& center, double radius, const Visit& visit, const Sheet& sheet) const
  {
    const Vector_3 low = center.array() - radius, high = center.array() + radius;
    const CGAL::Bbox_3 box(low[0], low[1], low[2], high[0], high[1], high[2]);
    const auto visit_primitive = [&](const aabb::Triangle_iterator& triangle) {
      if (CGAL::do_overlap(box, triangle->bbox()))
        visit(index_[triangle - soup_.begin()]);
    };
    aabb::Box_traversal<decltype(visit_primitive)> traversal{visit_primitive};
    sheet.tree->traversal(box, traversal);
  }

  // Whether a point is no farther from a point of a triangle than that is long.
  bool is_near(const Vector_3& query, const Surface_point& foot) const
  {
    const Vector_3 &a = corner(foot.triangle, 0), &b = corner(foot.triangle, 1), &c = corner(foot.triangle, 2);
    return (query - foot.point).squaredNorm() <
           (std::max)({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }

  // Searches a box of the size of the distance to a point of the sheet. It takes a third of the time of CGAL's search where
  // that is near: the box holds few other triangles.
  Surface_point closest_point_in_box(const Vector_3& query, const Surface_point& bound, const Sheet& sheet) const
  {
    Surface_point best = bound;
    double least = (best.point - query).squaredNorm();
    for_triangles_near(
      query, std::sqrt(least),
      [&](std::size_t t) {
        const Surface_point candidate = closest_point_of_triangle(query, t, points, triangles);
        const double square = (candidate.point - query).squaredNorm();
        if (square < least) {
          least = square;
          best = candidate;
        }
      },
      sheet);
    return best;
  }

  const Sheet& searched(int sheet) const
  {
    if (std::size_t(sheet) < sheets_.size() && sheets_[sheet].size > 0)
      return sheets_[sheet];
    return *std::find_if(sheets_.begin(), sheets_.end(), [](const Sheet& s) { return s.size > 0; });
  }

  static aabb::Kernel::Triangle_3 triangle(const Positions& points, const Triangle_indices& t)
  {
    return aabb::Kernel::Triangle_3(aabb::point(points[t[0]]), aabb::point(points[t[1]]), aabb::point(points[t[2]]));
  }

  Surface_point surface_point(const std::pair<aabb::Kernel::Point_3, aabb::Triangle_iterator>& found) const
  {
    const std::size_t t = index_[found.second - soup_.begin()];
    const Vector_3 point = aabb::vector(found.first);
    const Vector_3 u = corner(t, 1) - corner(t, 0), v = corner(t, 2) - corner(t, 0), w = point - corner(t, 0);
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    const double b = (vv * u.dot(w) - uv * v.dot(w)) / determinant, c = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    return {point, {1 - b - c, b, c}, t};
  }

  std::vector<aabb::Kernel::Triangle_3> soup_; // sheet by sheet, without the degenerate triangles: they have no normal
  std::vector<std::size_t> index_;             // of each, in triangles
  std::vector<std::size_t> places_;            // of the triangles, in the soup
  std::vector<Sheet> sheets_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
