// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H

// Vertices that stand exactly on what they are attached to, and move along it
// only: not at all on a corner, along a curve, within the surface.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Ties.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
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
    , hints_(points.size(), Surface_point::no_hint)
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
    notice_arrivals(points, true);
  }

  // Whether it holds vertices on curves or faces too.
  bool holds_more_than_corners() const
  {
    return std::any_of(held_.begin(), held_.end(), [this](int v) { return kind_[v] != Kind::CORNER; });
  }

  // From now on, all that is attached is to come to its place, and to stay there.
  void call_all() { are_all_called_ = true; }

  // Whether some that are called have not yet come.
  bool are_some_away() const
  {
    return are_all_called_ && std::any_of(held_.begin(), held_.end(), [this](int v) { return !is_there_[v]; });
  }

  // Those that are not where they are to stand, released or not.
  std::vector<int> vertices_away() const
  {
    std::vector<int> result = released_;
    std::copy_if(held_.begin(), held_.end(), std::back_inserter(result), [this](int v) { return !is_there_[v]; });
    return result;
  }

  // Lets go what has not come.
  void release_those_away()
  {
    const auto away = std::stable_partition(held_.begin(), held_.end(), [this](int v) { return is_there_[v]; });
    for (auto v = away; v != held_.end(); ++v) {
      released_.push_back(*v);
      kind_of_released_.push_back(std::exchange(kind_[*v], Kind::FREE));
    }
    held_.erase(away, held_.end());
  }

  // Calls again what was let go. Tells whether there is some.
  bool recall_released()
  {
    for (std::size_t i = 0; i < released_.size(); ++i)
      kind_[released_[i]] = kind_of_released_[i];
    held_.insert(held_.end(), released_.begin(), released_.end());
    const bool is_some = !released_.empty();
    released_.clear();
    kind_of_released_.clear();
    return is_some;
  }

  // Whether a vertex does not move at all.
  bool is_at_rest(std::size_t v) const
  {
    const int u = goes_with_[v];
    return kind_[u] == Kind::FIXED || (kind_[u] == Kind::CORNER && is_bound(u));
  }

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
            result[v] = Freedom::along_plane(surface_.foot_point(points[v], hints_[v], attachment_.sheet[v]).normal);
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

  // The ways that those which are called have to their places; zero for all others.
  Positions ways(const Positions& points) const
  {
    Positions result(points.size(), Vector_3::Zero());
    for (int v : held_)
      if (!is_there_[v] && are_all_called_)
        result[v] = place(v, points[v]) - points[v];
    for (const std::vector<int>& group : tied_)
      for (int v : group)
        result[v] = result[group.front()];
    return result;
  }

  // Tells that the ways have been gone, as far as they could be.
  void arrive(const Positions& points) { notice_arrivals(points, are_all_called_); }

private:
  enum class Kind : char { FIXED, CORNER, CURVE, SURFACE, FREE }; // the less freedom, the lower

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

  bool is_bound(std::size_t v) const { return are_all_called_ || is_there_[v]; }

  void notice_arrivals(const Positions& points, bool counts)
  {
    for (int v : held_)
      if (counts && !is_there_[v])
        is_there_[v] = (place(v, points[v]) - points[v]).norm() <= arrival;
  }

  const Feature_curve& curve(std::size_t v) const { return *surface_.curves[attachment_.curve[v]]; }

  Vector_3 place(std::size_t v, const Vector_3& p) const
  {
    switch (kind_[v]) {
    case Kind::CORNER:
      return attachment_.corner[v];
    case Kind::CURVE:
      return curve(v).closest_point(p).point;
    default: {
      const Surface_point q = surface_.closest_point(p, hints_[v], attachment_.sheet[v]);
      hints_[v] = q.hint;
      return q.point;
    }
    }
  }

  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  std::vector<Kind> kind_;
  std::vector<int> held_;     // vertices that are to stand on their places
  std::vector<int> released_; // vertices that were to
  std::vector<Kind> kind_of_released_;
  std::vector<char> is_there_; // of each vertex
  bool are_all_called_ = false;
  mutable std::vector<std::size_t> hints_; // for searches; whatever they are, the results are the same
  std::vector<std::vector<int>> tied_;     // vertices that move together
  std::vector<int> goes_with_;             // each vertex, itself or the first of those that it is tied to
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SLIDING_H
