// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CONTACT_PLANES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CONTACT_PLANES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Parts that touch, or have flat sides in common, but for rounding: their vertices are put into the same planes, in exact numbers,
// so that neither gaps nor slivers are between them.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/meeting_pairs.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Contact_planes
{
public:
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

  // part: of each triangle. tolerance: the distance from a plane that counts as none.
  Contact_planes(const Positions& points, const std::vector<Triangle_indices>& triangles, const std::vector<int>& part,
                 double tolerance)
    : points_(points)
    , triangles_(triangles)
    , tolerance_(tolerance)
    , sets_(triangles.size())
  {
    find_contacts(part);
    if (!is_inexact_)
      return;
    grow();
    place_vertices();
  }

  // Of the vertices that are not where they were.
  std::map<int, Exact::Point_3> places;

private:
  void find_contacts(const std::vector<int>& part)
  {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
    const Soup_predicates<Predicate_points> predicates({points_}, triangles_);
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      Eigen::AlignedBox3d box;
      for (int v : triangles_[t])
        box.extend(points_[v]);
      const Vector_3 low = box.min().array() - tolerance_, high = box.max().array() + tolerance_;
      boxes.emplace_back(CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]), static_cast<int>(t));
    }
    is_member_.assign(triangles_.size(), false);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const int s = a.info(), t = b.info();
      if (part[s] == part[t] || !are_in_one_plane(s, t))
        return;
      is_member_[s] = is_member_[t] = true;
      sets_.unite(s, t);
      is_inexact_ = is_inexact_ || !predicates.are_coplanar(s, t);
    });
  }

  Vector_3 normal(int t) const
  {
    const Vector_3& a = points_[triangles_[t][0]];
    return (points_[triangles_[t][1]] - a).cross(points_[triangles_[t][2]] - a);
  }

  double height(int t) const
  {
    const Triangle_indices& v = triangles_[t];
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = (std::max)(longest, (points_[v[k]] - points_[v[(k + 1) % 3]]).norm());
    return normal(t).norm() / longest;
  }

  // The vertices of the smaller one are in the plane of the larger.
  bool are_in_one_plane(int s, int t) const
  {
    const double least_height = 20; // in tolerances: the plane of what is thinner is any
    if (height(s) < least_height * tolerance_ || height(t) < least_height * tolerance_)
      return false;
    const bool is_larger = normal(s).squaredNorm() > normal(t).squaredNorm();
    return is_in_plane(is_larger ? t : s, is_larger ? s : t);
  }

  bool is_in_plane(int t, int of) const
  {
    const Vector_3 n = normal(of).normalized();
    for (int v : triangles_[t])
      if (std::abs(n.dot(points_[v] - points_[triangles_[of][0]])) > tolerance_)
        return false;
    return true;
  }

  // What goes on in the same plane, triangle by triangle.
  void grow()
  {
    std::vector<std::vector<int>> neighbors(triangles_.size());
    for_soup_edges(triangles_, [&](auto first, auto last) {
      for (auto a = first; a != last; ++a)
        for (auto b = first; b != last; ++b)
          if (a->triangle != b->triangle)
            neighbors[a->triangle].push_back(b->triangle);
    });
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_member_[t]) {
        int& largest = largest_.emplace(sets_.find(t), static_cast<int>(t)).first->second;
        if (normal(static_cast<int>(t)).squaredNorm() > normal(largest).squaredNorm())
          largest = static_cast<int>(t);
      }
    std::vector<int> open;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_member_[t])
        open.push_back(static_cast<int>(t));
    for (std::size_t i = 0; i < open.size(); ++i)
      for (int other : neighbors[open[i]])
        if (is_member_[other])
          join(open[i], other);
        else if (is_in_plane(other, largest_[sets_.find(open[i])])) {
          is_member_[other] = true;
          unite(open[i], other, largest_[sets_.find(open[i])]);
          open.push_back(other);
        }
    for (int t : open)
      planes_of_[t].push_back(largest_[sets_.find(t)]);
  }

  // Several contacts in one plane of a part have that in common: a vertex between two of them cannot be in two planes
  // that are nearly the same.
  void join(int s, int t)
  {
    if (sets_.find(s) == sets_.find(t))
      return;
    int larger = largest_[sets_.find(s)], smaller = largest_[sets_.find(t)];
    if (normal(larger).squaredNorm() < normal(smaller).squaredNorm())
      std::swap(larger, smaller);
    if (is_in_plane(smaller, larger))
      unite(s, t, larger);
  }

  void unite(int s, int t, int largest)
  {
    sets_.unite(s, t);
    largest_[sets_.find(s)] = largest;
  }

  Exact::Point_3 exact(int v) const { return Exact::Point_3(points_[v][0], points_[v][1], points_[v][2]); }

  void place_vertices()
  {
    std::map<int, std::vector<int>> of_vertex; // planes, as their largest triangles
    for (const auto& [t, planes] : planes_of_)
      for (int v : triangles_[t])
        for (int plane : planes)
          if (std::vector<int>& list = of_vertex[v]; std::find(list.begin(), list.end(), plane) == list.end())
            list.push_back(plane);
    for (auto& [v, planes] : of_vertex)
      for (std::size_t n = (std::min)(planes.size(), std::size_t(3)); n > 0; --n) {
        const auto place = in_planes(v, planes, n);
        const double farthest = 100; // in tolerances: planes at a small angle meet far away
        if (place.second && (to_double(place.first) - points_[v]).norm() < farthest * tolerance_) {
          places.emplace(v, place.first);
          break;
        }
      }
  }

  static Vector_3 to_double(const Exact::Point_3& p)
  {
    return Vector_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }

  // The nearest place in the first n of the planes, if they have one in common.
  std::pair<Exact::Point_3, bool> in_planes(int v, const std::vector<int>& list, std::size_t n) const
  {
    const auto plane = [&](std::size_t i) {
      const Triangle_indices& t = triangles_[list[i]];
      return Exact::Plane_3(exact(t[0]), exact(t[1]), exact(t[2]));
    };
    if (n == 1)
      return {plane(0).projection(exact(v)), true};
    const auto crossing = CGAL::intersection(plane(0), plane(1));
    const Exact::Line_3* line = crossing ? aabb::get_if<Exact::Line_3>(&*crossing) : nullptr;
    if (!line)
      return {exact(v), false};
    if (n == 2)
      return {line->projection(exact(v)), true};
    const auto corner = CGAL::intersection(plane(2), *line);
    if (!corner)
      return {exact(v), false};
    if (const Exact::Point_3* p = aabb::get_if<Exact::Point_3>(&*corner))
      return {*p, true};
    return {line->projection(exact(v)), true}; // the third plane has the line
  }

  const Positions& points_;
  const std::vector<Triangle_indices>& triangles_;
  const double tolerance_;
  Disjoint_sets sets_; // of triangles in one plane
  bool is_inexact_ = false;
  std::vector<char> is_member_;               // of a plane
  std::map<std::size_t, int> largest_;        // triangle of each set
  std::map<int, std::vector<int>> planes_of_; // of triangles
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_CONTACT_PLANES_H
