// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Vertices that stand exactly on what they are attached to, and move along it
// only: not at all on a corner, along a curve, within the surface.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Freedom.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Sliding
{
public:
  // Corners where curves meet are held; other corners, curves and the surface where the boundary has to be on the
  // surface. What already stands on its place at the points is held from the start, the rest once all of it is called.
  // ties: of the vertices; where one of those that are tied goes, the one with the least freedom, all go. surface and
  // attachment must outlive the object.
  Sliding(const Reference_surface& surface, const Boundary_attachment& attachment, Boundary_placement placement,
          const Positions& points, const Ties& ties = Ties())
    : surface_(surface)
    , attachment_(attachment)
    , kind_(points.size(), Kind::FREE)
    , is_there_(points.size(), false)
    , last_triangles_(points.size(), Surface_point::no_triangle)
    , tied_(ties.groups())
    , goes_with_(points.size())
  {
    const bool on_surface = placement == Boundary_placement::ON_SURFACE;
    for (std::size_t v = 0; v < points.size(); ++v) {
      switch (attachment.kind[v]) {
      case Vertex_kind::CORNER:
        if (attachment.corner_rank[v] == Corner_rank::JUNCTION || on_surface)
          kind_[v] = Kind::CORNER;
        break;
      case Vertex_kind::FEATURE:
        if (on_surface)
          kind_[v] = Kind::CURVE;
        break;
      case Vertex_kind::SURFACE:
        if (on_surface)
          kind_[v] = Kind::SURFACE;
        break;
      case Vertex_kind::FIXED:
        kind_[v] = Kind::FIXED;
        break;
      case Vertex_kind::INTERIOR:
        break;
      }
    }
    tie();
    for (std::size_t v = 0; v < points.size(); ++v)
      if (kind_[v] != Kind::FREE && kind_[v] != Kind::FIXED)
        held_.push_back(static_cast<int>(v));
    notice_arrivals(points);
  }

  // Whether it holds vertices on curves or faces too.
  bool holds_more_than_corners() const
  {
    return std::any_of(held_.begin(), held_.end(), [this](int v) { return kind_[v] != Kind::CORNER; });
  }

  // From now on, all that is attached is to come to its place, and to stay there.
  void call_all() { are_all_called_ = true; }

  // Until then, what stands on its place already may leave it, but for corners where curves meet.
  void let_go()
  {
    for (int v : held_)
      is_there_[v] = is_there_[v] && kind_[v] == Kind::CORNER && attachment_.corner_rank[v] == Corner_rank::JUNCTION;
  }

  // Whether some that are called have not yet come.
  bool are_some_away() const
  {
    return are_all_called_ && std::any_of(held_.begin(), held_.end(), [this](int v) { return !is_there_[v]; });
  }

  // Those that are not where they are to stand, released or not, in increasing order.
  std::vector<int> vertices_away() const
  {
    std::vector<int> result;
    for (const Release& r : released_)
      result.push_back(r.vertex);
    std::copy_if(held_.begin(), held_.end(), std::back_inserter(result), [this](int v) { return !is_there_[v]; });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  Away away(const Positions& points) const
  {
    const std::vector<int> vertices = vertices_away();
    const auto off_surface = std::count_if(vertices.begin(), vertices.end(), [&](int v) {
      return (place_on_surface(v, points[v]) - points[v]).norm() > arrival;
    });
    return {static_cast<std::size_t>(off_surface), vertices.size()};
  }

  // Lets go of features what has not come to them: it is to come to the surface then.
  void release_from_features(const Positions& points)
  {
    for (int v : held_)
      if (!is_there_[v])
        release_from_feature(v);
    notice_arrivals(points);
  }

  // Lets go altogether what has not come.
  void release_those_away()
  {
    const auto away = std::stable_partition(held_.begin(), held_.end(), [this](int v) { return is_there_[v]; });
    for (auto v = away; v != held_.end(); ++v) {
      if (std::none_of(released_.begin(), released_.end(), [v](const Release& r) { return r.vertex == *v; }))
        released_.push_back({*v, kind_[*v]});
      kind_[*v] = Kind::FREE;
    }
    held_.erase(away, held_.end());
  }

  // Calls again what was let go, to where it was to stand.
  void recall_released(const Positions& points)
  {
    for (const Release& r : released_) {
      if (kind_[r.vertex] == Kind::FREE)
        held_.push_back(r.vertex);
      kind_[r.vertex] = r.kind;
      is_there_[r.vertex] = false;
    }
    released_.clear();
    notice_arrivals(points);
  }

  // Looks anew who stands on its place: to be called with points that are not those of the last call moved on.
  void notice(const Positions& points)
  {
    for (int v : held_)
      is_there_[v] = false;
    notice_arrivals(points);
  }

  // Whether a vertex does not move at all.
  bool is_at_rest(std::size_t v) const
  {
    const int u = goes_with_[v];
    return kind_[u] == Kind::FIXED || (kind_[u] == Kind::CORNER && is_bound(u));
  }

  // Along the smooth tangents of what vertices slide on: at the kinks between its triangles and segments a vertex that
  // followed those would be stopped (measured on octree meshes, all vertices on the surface: the average rises to .832
  // instead of .828).
  Freedoms freedoms(const Positions& points) const
  {
    Freedoms result(points.size(), Freedom::everywhere());
    for_each(
      points.size(),
      [&](std::size_t v) {
        if (kind_[v] == Kind::FIXED)
          result[v] = Freedom::nowhere();
        else if (is_bound(v))
          switch (kind_[v]) {
          case Kind::CORNER:
            result[v] = Freedom::nowhere();
            break;
          case Kind::CURVE:
            result[v] = Freedom::along_line(curve(v).closest_point(points[v]).tangent);
            break;
          case Kind::SURFACE:
            result[v] = Freedom::along_plane(smooth_normal(foot(v, points[v])));
            break;
          default:
            break;
          }
      },
      searches_of_range);
    for (const std::vector<int>& group : tied_)
      for (int v : group)
        result[v] = result[group.front()];
    return result;
  }

  // Moves those that stood on their places before a step back onto them after it.
  void retract(Positions& points) const
  {
    Positions before; // of the first of those that are tied
    for (const std::vector<int>& group : tied_)
      before.push_back(points[group.front()]);
    for_each(
      held_.size(),
      [&](std::size_t i) {
        const std::size_t v = held_[i];
        if (is_there_[v] && is_bound(v))
          points[v] = place(v, points[v]);
      },
      searches_of_range);
    for (std::size_t i = 0; i < tied_.size(); ++i)
      for (std::size_t k = 1; k < tied_[i].size(); ++k)
        points[tied_[i][k]] += points[tied_[i][0]] - before[i];
  }

  // Lets each of those that are called go the way to its place, the nearest first: go(vertices, way), of those that move
  // together, moves them along the way, or to another place that reached() allows, and tells whether they have come.
  template <class Go>
  void approach(Positions& points, const Go& go)
  {
    if (!are_all_called_)
      return;
    std::vector<std::pair<double, int>> order; // by the squared distance
    for (int v : held_)
      if (!is_there_[v])
        order.emplace_back((place(v, points[v]) - points[v]).squaredNorm(), v);
    std::sort(order.begin(), order.end());
    for (const auto& [distance, v] : order) {
      const Vector_3 way = place(v, points[v]) - points[v];
      is_there_[v] = true; // so that reached() keeps it there
      is_there_[v] = go(vertices_with(v), way);
      if (is_there_[v])
        points[v] = place(v, points[v]);
    }
  }

  // The vertices that move where v goes, v the first of them; none if it stays, or goes with another. What was let go
  // altogether stays: nothing would keep it near its place.
  std::vector<int> movable_with(int v) const
  {
    const bool stays = kind_[v] == Kind::FIXED || (kind_[v] == Kind::CORNER && is_there_[v]) || has_left(v);
    return stays || goes_with_[v] != v ? std::vector<int>() : vertices_with(v);
  }

  // Where v comes to if it is to go from where it departs to another place: on its curve or face if it stands there.
  using Departure = Vector_3;
  Departure departure(int, const Vector_3& from) const { return from; }
  Vector_3 reached(int v, const Departure&, const Vector_3& to) const { return is_there_[v] ? place(v, to) : to; }
  // Wherever vertices come to, they may stand.
  bool allows(const std::vector<int>&, const Positions&) const { return true; }

private:
  enum class Kind : char { FIXED, CORNER, CURVE, SURFACE, FREE }; // the less freedom, the lower

  struct Release
  {
    int vertex;
    Kind kind; // before it
  };

  static constexpr std::size_t searches_of_range = 64; // a search takes some microseconds
  static constexpr double arrival = 1e-11;             // mean boundary edges: what rounding leaves

  // Of those that are tied, the one with the least freedom comes first and alone has a place; the others go with it.
  void tie()
  {
    for (std::size_t v = 0; v < goes_with_.size(); ++v)
      goes_with_[v] = static_cast<int>(v);
    for (std::vector<int>& group : tied_) {
      const auto first = std::min_element(group.begin(), group.end(),
                                          [this](int a, int b) { return kind_[a] < kind_[b]; });
      std::swap(*group.begin(), *first);
      for (std::size_t k = 1; k < group.size(); ++k)
        kind_[group[k]] = Kind::FREE;
      for (int v : group)
        goes_with_[v] = group.front();
    }
  }

  std::vector<int> vertices_with(int v) const
  {
    const auto group = std::find_if(tied_.begin(), tied_.end(), [v](const std::vector<int>& g) { return g[0] == v; });
    return group == tied_.end() ? std::vector<int>{v} : *group;
  }

  bool has_left(int v) const
  {
    return kind_[v] == Kind::FREE &&
           std::any_of(released_.begin(), released_.end(), [v](const Release& r) { return r.vertex == v; });
  }

  bool is_bound(std::size_t v) const { return are_all_called_ || is_there_[v]; }

  void notice_arrivals(const Positions& points)
  {
    for (int v : held_)
      if (!is_there_[v])
        is_there_[v] = (place(v, points[v]) - points[v]).norm() <= arrival;
  }

  void release_from_feature(int v)
  {
    if (kind_[v] == Kind::CORNER || kind_[v] == Kind::CURVE) {
      released_.push_back({v, std::exchange(kind_[v], Kind::SURFACE)});
      is_there_[v] = false;
    }
  }

  const Feature_curve& curve(std::size_t v) const { return *surface_.curves[attachment_.curve[v]]; }

  Vector_3 place(std::size_t v, const Vector_3& p) const
  {
    switch (kind_[v]) {
    case Kind::CORNER:
      return attachment_.corner[v];
    case Kind::CURVE:
      return curve(v).closest_point(p).point;
    default:
      return place_on_surface(v, p);
    }
  }

  Vector_3 place_on_surface(std::size_t v, const Vector_3& p) const { return foot(v, p).point; }

  // Searched for around the last one, where that is near.
  Surface_point foot(std::size_t v, const Vector_3& p) const
  {
    const Surface_point q = surface_.closest_point(p, last_triangles_[v], attachment_.sheet[v]);
    last_triangles_[v] = q.triangle;
    return q;
  }

  Vector_3 smooth_normal(const Surface_point& q) const { return surface_.normal(q.triangle, q.coordinates); }

  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  std::vector<Kind> kind_;
  std::vector<int> held_;         // vertices that are to stand on their places
  std::vector<Release> released_; // those that were to
  std::vector<char> is_there_;    // of each vertex
  bool are_all_called_ = false;
  mutable std::vector<std::size_t> last_triangles_; // of the feet of vertices
  std::vector<std::vector<int>> tied_;     // vertices that move together
  std::vector<int> goes_with_;             // each vertex, itself or the first of those that it is tied to
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H
