// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H

// The surface that the boundary of the mesh has to stay on, and its feature
// curves, both behind AABB trees: closest point and normal, closest point of a
// curve and tangent.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

using Triangle_indices = std::array<int, 3>;

struct Surface_point
{
  Vector_3 point;
  Vector_3 normal; // unit length, outwards; smooth between feature curves
  std::array<double, 3> coordinates; // barycentric, in the triangle
  std::size_t triangle;
  std::size_t hint; // for a search nearby
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

// Traversal traits that visit all primitives whose bounding boxes may overlap a box.
template <class Visit>
struct Box_traversal
{
  const Visit& visit;

  bool go_further() const { return true; }

  template <class Primitive>
  void intersection(const CGAL::Bbox_3&, const Primitive& primitive) const { visit(primitive.id()); }

  template <class Node>
  bool do_intersect(const CGAL::Bbox_3& box, const Node& node) const { return CGAL::do_overlap(box, node.bbox()); }
};

} // namespace aabb

// A polyline of feature edges between two corners, or closed. Not copyable: the
// tree points into the segments.
class Feature_curve
{
public:
  Feature_curve(std::vector<int> reference_vertices, const Positions& points)
    : vertices(std::move(reference_vertices))
    , place_(points[vertices.front()])
  {
    std::vector<Vector_3> directions;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const Vector_3 &a = points[vertices[i]], &b = points[vertices[i + 1]];
      length += (b - a).norm();
      if (a != b) {
        segments_.emplace_back(aabb::point(a), aabb::point(b));
        directions.push_back((b - a).normalized());
      }
    }
    // a point between two segments has one tangent, whichever of them the search returns
    const std::size_t n = directions.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool first = i == 0 && !is_closed(), last = i + 1 == n && !is_closed();
      tangents_.push_back({first ? directions[i] : Vector_3(directions[i] + directions[(i + n - 1) % n]).normalized(),
                           last ? directions[i] : Vector_3(directions[i] + directions[(i + 1) % n]).normalized()});
    }
    tree_.insert(segments_.begin(), segments_.end());
    tree_.build();
  }

  Feature_curve(const Feature_curve&) = delete;
  Feature_curve& operator=(const Feature_curve&) = delete;

  bool is_closed() const { return vertices.front() == vertices.back(); }

  // A curve that is shrunk to a point has no direction.
  Curve_point closest_point(const Vector_3& query) const
  {
    if (segments_.empty())
      return {place_, Vector_3::Zero()};
    const auto found = tree_.closest_point_and_primitive(aabb::point(query));
    const Vector_3 a = aabb::vector(found.second->source()), b = aabb::vector(found.second->target());
    const Vector_3 p = aabb::vector(found.first);
    const std::array<Vector_3, 2>& ends = tangents_[found.second - segments_.begin()];
    const double t = (p - a).norm() / (b - a).norm();
    const Vector_3 tangent = (1 - t) * ends[0] + t * ends[1];
    return {p, tangent.norm() > 1e-6 ? Vector_3(tangent.normalized()) : Vector_3((b - a).normalized())};
  }

  std::vector<int> vertices; // of the reference, in order; first equals last on a closed curve
  double length = 0;

private:
  Vector_3 place_; // of its first vertex
  std::vector<aabb::Kernel::Segment_3> segments_; // without those of no length
  std::vector<std::array<Vector_3, 2>> tangents_; // at both ends of each
  CGAL::AABB_tree<aabb::Segment_traits> tree_;
};

class Reference_surface
{
public:
  // A temporary one is cheaper to build: its normals are those of the triangles, and searches should be given a hint.
  explicit Reference_surface(Positions points, std::vector<Triangle_indices> triangles, bool is_temporary = false)
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
    if (!is_temporary) {
      tree_.accelerate_distance_queries();
      smooth_normals(); // until curves are known
    }
  }

  // Averages the normals around every vertex, but not across feature curves. A point on an edge or a vertex then has
  // one normal, whichever of the triangles around it the search returns. Call it when the curves have changed.
  void smooth_normals()
  {
    std::vector<std::array<int, 2>> barriers;
    for (const std::unique_ptr<Feature_curve>& curve : curves)
      for (std::size_t i = 0; i + 1 < curve->vertices.size(); ++i)
        barriers.push_back({(std::min)(curve->vertices[i], curve->vertices[i + 1]), (std::max)(curve->vertices[i], curve->vertices[i + 1])});
    std::sort(barriers.begin(), barriers.end());
    std::vector<std::array<int, 4>> sides; // low vertex, high vertex, triangle, its corner before the edge
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = triangles[t][k], b = triangles[t][(k + 1) % 3];
        sides.push_back({(std::min)(a, b), (std::max)(a, b), static_cast<int>(t), k});
      }
    std::sort(sides.begin(), sides.end());
    std::vector<int> group(3 * triangles.size()); // a forest over the corners of triangles
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](int c) {
      while (group[c] != c)
        c = group[c] = group[group[c]];
      return c;
    };
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const std::array<int, 4> &s = sides[i - 1], &t = sides[i];
      if (s[0] != t[0] || s[1] != t[1] || std::binary_search(barriers.begin(), barriers.end(), std::array<int, 2>{s[0], s[1]}))
        continue;
      for (int end = 0; end < 2; ++end) {
        const int c = 3 * s[2] + (s[3] + end) % 3;
        const int v = triangles[s[2]][(s[3] + end) % 3];
        for (int k = 0; k < 3; ++k)
          if (triangles[t[2]][k] == v)
            group[root(3 * t[2] + k)] = root(c);
      }
    }
    Positions sums(group.size(), Vector_3::Zero());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Vector_3 normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
      if (!(normal.norm() > 0))
        continue;
      for (int k = 0; k < 3; ++k) {
        const Vector_3 a = corner(t, (k + 1) % 3) - corner(t, k), b = corner(t, (k + 2) % 3) - corner(t, k);
        sums[root(static_cast<int>(3 * t) + k)] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal.normalized();
      }
    }
    normals_.resize(group.size());
    for (std::size_t c = 0; c < group.size(); ++c)
      normals_[c] = sums[root(static_cast<int>(c))].normalized(); // stays zero where the normals cancel
  }

  Reference_surface(const Reference_surface&) = delete;
  Reference_surface& operator=(const Reference_surface&) = delete;

  bool is_empty() const { return soup_.empty(); }

  static constexpr std::size_t no_hint = static_cast<std::size_t>(-1);

  // hint: that of an earlier result nearby; it saves time, whatever it is.
  Surface_point closest_point(const Vector_3& query, std::size_t hint = no_hint) const
  {
    const aabb::Kernel::Point_3 q = aabb::point(query);
    const auto found = hint < soup_.size()
                         ? tree_.closest_point_and_primitive(q, {aabb::Kernel().construct_projected_point_3_object()(soup_[hint], q), soup_.begin() + hint})
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

  // At a point of a triangle that is not degenerate, given by barycentric coordinates.
  Vector_3 normal(std::size_t triangle, const std::array<double, 3>& coordinates) const
  {
    Vector_3 sum = Vector_3::Zero();
    for (int k = 0; k < 3 && !normals_.empty(); ++k)
      sum += coordinates[k] * normals_[3 * triangle + k];
    const double length = sum.norm();
    if (length > 1e-6)
      return sum / length;
    return (corner(triangle, 1) - corner(triangle, 0)).cross(corner(triangle, 2) - corner(triangle, 0)).normalized();
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

  Positions points;
  std::vector<Triangle_indices> triangles;
  std::vector<std::unique_ptr<Feature_curve>> curves;
  std::vector<int> corners; // vertices where curves meet, end or turn sharply

private:
  Surface_point surface_point(const std::pair<aabb::Kernel::Point_3, aabb::Triangle_iterator>& found) const
  {
    const std::size_t place = found.second - soup_.begin(), t = index_[place];
    const Vector_3 point = aabb::vector(found.first);
    const Vector_3 u = corner(t, 1) - corner(t, 0), v = corner(t, 2) - corner(t, 0), w = point - corner(t, 0);
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), determinant = uu * vv - uv * uv;
    const double b = (vv * u.dot(w) - uv * v.dot(w)) / determinant, c = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    return {point, normal(t, {1 - b - c, b, c}), {1 - b - c, b, c}, t, place};
  }

  void add(const aabb::Kernel::Triangle_3& triangle, std::size_t index)
  {
    soup_.push_back(triangle);
    index_.push_back(index);
  }

  std::vector<aabb::Kernel::Triangle_3> soup_; // without the degenerate triangles, which have no normal
  std::vector<std::size_t> index_;             // of each, in triangles
  Positions normals_;                          // at the corners of triangles; none in a temporary surface
  CGAL::AABB_tree<aabb::Triangle_traits> tree_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H
