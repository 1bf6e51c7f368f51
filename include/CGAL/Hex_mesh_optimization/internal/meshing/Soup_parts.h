// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_PARTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_PARTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The closed parts that a triangle soup consists of, each oriented for itself, and how often they wind around a point.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/aabb.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

inline std::string in_words(const Vector_3& p)
{
  std::ostringstream out;
  out << '(' << p[0] << ' ' << p[1] << ' ' << p[2] << ')';
  return out.str();
}

inline std::string in_digits(double x)
{
  std::ostringstream out;
  out.precision(4);
  out << x;
  return out.str();
}

// The angle under which a triangle is seen, over that of all directions; positive from behind.
inline double solid_angle(const Vector_3& from, const Vector_3& p, const Vector_3& q, const Vector_3& r)
{
  const Vector_3 a = p - from, b = q - from, c = r - from;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return std::atan2(a.dot(b.cross(c)), below) / (2 * CGAL_PI);
}

class Soup_parts
{
public:
  // No edge has one triangle only. may_have_cavities: a part within others that is oriented against them is one. Throws
  // Input_error where triangles do not bound anything together.
  Soup_parts(const Positions& its_points, std::vector<Triangle_indices> its_triangles, bool may_have_cavities = true)
    : triangles(std::move(its_triangles))
    , part(triangles.size(), none)
    , points_(its_points)
  {
    for (const Triangle_indices& t : triangles)
      for (int v : t)
        box_.extend(points_[v]);
    number_patches();
    orient_patches();
    find_closed_patches();
    for (const std::vector<int>& group : open_groups())
      orient_group(group);
    number_parts();
    orient_parts(may_have_cavities);
  }

  std::vector<Triangle_indices> triangles; // turned so that they belong together
  std::vector<int> part;                   // of each triangle; none: it bounds nothing, or the same on both sides
  std::size_t number_of_parts = 0;
  std::size_t number_of_reoriented_parts = 0; // that were inside out
  bool is_oriented_as_given = true;           // within each part
  std::vector<int> cavities;                  // parts that bound what is not inside

  static constexpr int none = -1;

  // The sum over the triangles of a part but those that are left out.
  double winding(int of_part, const Vector_3& p, const std::vector<int>& left_out = {}) const
  {
    if (left_out.empty() && !boxes_[of_part].contains(p))
      return 0;
    double sum = 0;
    for (int t : of_part_[of_part])
      if (std::find(left_out.begin(), left_out.end(), t) == left_out.end())
        sum += solid_angle(p, points_[triangles[t][0]], points_[triangles[t][1]], points_[triangles[t][2]]);
    return sum;
  }

  double volume(int of_part) const
  {
    double sum = 0;
    for (int t : of_part_[of_part])
      sum += (points_[triangles[t][0]] - box_.center())
               .dot((points_[triangles[t][1]] - box_.center()).cross(points_[triangles[t][2]] - box_.center())) /
             6;
    return sum;
  }

private:
  void turn(int t) { std::swap(triangles[t][1], triangles[t][2]); }

  // Patches: triangles that hang together by edges of two triangles.
  void number_patches()
  {
    neighbors_.resize(triangles.size());
    for_soup_edges(triangles, [&](auto first, auto last) {
      if (last - first == 2) {
        const bool agree = first->is_reversed != (first + 1)->is_reversed;
        neighbors_[first->triangle].push_back({(first + 1)->triangle, agree});
        neighbors_[(first + 1)->triangle].push_back({first->triangle, agree});
      }
    });
    patch_.assign(triangles.size(), none);
  }

  void orient_patches()
  {
    for (std::size_t start = 0; start < triangles.size(); ++start) {
      if (patch_[start] != none)
        continue;
      std::vector<int> members = {static_cast<int>(start)};
      std::map<int, bool> is_turned = {{static_cast<int>(start), false}};
      patch_[start] = number_of_patches_;
      for (std::size_t i = 0; i < members.size(); ++i) {
        const int t = members[i];
        const bool turned = is_turned[t];
        for (const auto& [other, agree] : neighbors_[t])
          if (patch_[other] == none) {
            patch_[other] = number_of_patches_;
            is_turned[other] = turned == agree;
            members.push_back(other);
          }
          else if (is_turned[other] != (turned == agree))
            throw Input_error(Input_error::Element::REFERENCE_FACE, t,
                              "the surface has only one side, near " + in_words(points_[triangles[t][0]]) +
                                ": it bounds no volume");
      }
      std::size_t number = 0;
      for (const auto& entry : is_turned)
        number += entry.second;
      is_oriented_as_given = is_oriented_as_given && (number == 0 || number == members.size());
      const bool fewer = 2 * number > members.size();
      for (const auto& [t, turned] : is_turned)
        if (turned != fewer)
          turn(t);
      of_patch_.push_back(std::move(members));
      ++number_of_patches_;
    }
  }

  // Visits edges of patches where these do not end in pairs: visit(first, last)
  template <class Visit>
  void for_open_edges(const Visit& visit) const
  {
    for_soup_edges(triangles, [&](auto first, auto last) {
      if (last - first == 2)
        return;
      std::map<int, int> sum;
      for (auto s = first; s != last; ++s)
        sum[patch_[s->triangle]] += s->is_reversed ? -1 : 1;
      for (const auto& entry : sum)
        if (entry.second != 0) {
          visit(first, last, sum);
          return;
        }
    });
  }

  void find_closed_patches()
  {
    is_closed_.assign(number_of_patches_, true);
    is_counted_.assign(number_of_patches_, true);
    for_open_edges([&](auto, auto, const std::map<int, int>& sum) {
      for (const auto& entry : sum)
        if (entry.second != 0)
          is_closed_[entry.first] = false;
    });
    group_ = std::vector<int>(number_of_patches_);
    std::iota(group_.begin(), group_.end(), 0);
  }

  // Of patches that meet in edges and are not closed alone.
  std::vector<std::vector<int>> open_groups()
  {
    Disjoint_sets sets(number_of_patches_);
    for_open_edges([&](auto, auto, const std::map<int, int>& sum) {
      int before = none;
      for (const auto& entry : sum)
        if (!is_closed_[entry.first]) {
          if (before != none)
            sets.unite(before, entry.first);
          before = entry.first;
        }
    });
    std::map<std::size_t, std::vector<int>> groups;
    for (int p = 0; p < number_of_patches_; ++p) {
      group_[p] = static_cast<int>(sets.find(p));
      if (!is_closed_[p])
        groups[sets.find(p)].push_back(p);
    }
    std::vector<std::vector<int>> result;
    for (auto& entry : groups)
      result.push_back(std::move(entry.second));
    return result;
  }

  // Whether each edge has as many triangles in one direction as in the other.
  bool is_balanced(const std::vector<int>& group) const
  {
    std::vector<Triangle_indices> counted;
    for (int p : group)
      if (is_counted_[p])
        for (int t : of_patch_[p])
          counted.push_back(triangles[t]);
    bool result = true;
    for_soup_edges(counted, [&](auto first, auto last) {
      int sum = 0;
      for (auto s = first; s != last; ++s)
        sum += s->is_reversed ? -1 : 1;
      result = result && sum == 0;
    });
    return result;
  }

  // As given, if that closes it; or by what is seen from far away: what bounds it is seen on one side.
  void orient_group(const std::vector<int>& group)
  {
    if (is_oriented_as_given && is_balanced(group))
      return;
    std::vector<aabb::Kernel::Triangle_3> soup;
    std::vector<int> index;
    for (int p : group)
      for (int t : of_patch_[p]) {
        soup.emplace_back(aabb::point(points_[triangles[t][0]]), aabb::point(points_[triangles[t][1]]),
                          aabb::point(points_[triangles[t][2]]));
        index.push_back(t);
      }
    CGAL::AABB_tree<aabb::Triangle_traits> tree(soup.cbegin(), soup.cend());
    tree.build();
    const auto escapes = [&](const Vector_3& place, const Vector_3& direction) {
      return !tree.do_intersect(
        aabb::Kernel::Ray_3(aabb::point(place), aabb::Kernel::Vector_3(direction[0], direction[1], direction[2])));
    };
    for (int p : group) {
      const bool in_front = is_seen(p, 1, escapes), behind = is_seen(p, -1, escapes);
      if (in_front == behind)
        is_counted_[p] = false;
      else if (behind)
        for (int t : of_patch_[p])
          turn(t);
    }
    if (!is_balanced(group))
      throw Input_error(Input_error::Element::REFERENCE_FACE, of_patch_[group[0]][0],
                        "more than two faces of the surface meet in edges, and do not bound a volume together, near " +
                          in_words(points_[triangles[of_patch_[group[0]][0]][0]]));
  }

  // From the largest triangles of the patch, in directions that are spread evenly over those to one side.
  template <class Escapes>
  bool is_seen(int p, double side, const Escapes& escapes) const
  {
    constexpr std::size_t most_triangles = 8;
    constexpr int number_of_directions = 100;
    std::vector<std::pair<double, int>> by_area;
    for (int t : of_patch_[p])
      by_area.emplace_back(-normal(t).norm(), t);
    std::sort(by_area.begin(), by_area.end());
    for (std::size_t i = 0; i < by_area.size() && i < most_triangles; ++i) {
      const Triangle_indices& t = triangles[by_area[i].second];
      const Vector_3 n = side * normal(by_area[i].second).normalized(), u = n.unitOrthogonal(), v = n.cross(u);
      const Vector_3 start = (points_[t[0]] + points_[t[1]] + points_[t[2]]) / 3 + 1e-9 * box_.diagonal().norm() * n;
      for (int k = 0; k < number_of_directions; ++k) {
        const double height = (k + .5) / number_of_directions, angle = k * 2.399963; // of the golden section
        const double radius = std::sqrt(1 - height * height);
        if (escapes(start, height * n + radius * (std::cos(angle) * u + std::sin(angle) * v)))
          return true;
      }
    }
    return false;
  }

  Vector_3 normal(int t) const
  {
    const Vector_3& a = points_[triangles[t][0]];
    return (points_[triangles[t][1]] - a).cross(points_[triangles[t][2]] - a);
  }

  void number_parts()
  {
    std::map<int, int> number; // of each group of patches
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (is_counted_[patch_[t]]) {
        part[t] = number.emplace(group_[patch_[t]], static_cast<int>(number.size())).first->second;
        of_part_.resize(number.size());
        boxes_.resize(number.size());
        of_part_[part[t]].push_back(static_cast<int>(t));
        for (int v : triangles[t])
          boxes_[part[t]].extend(points_[v]);
      }
    number_of_parts = number.size();
  }

  // Outwards; but a part that lies within others and is oriented against them, where all are oriented as given, is a
  // cavity.
  void orient_parts(bool may_have_cavities)
  {
    double total = 0;
    std::vector<double> volumes;
    for (std::size_t p = 0; p < number_of_parts; ++p) {
      volumes.push_back(volume(static_cast<int>(p)));
      total += volumes.back();
    }
    const double sign = total < 0 ? -1 : 1;
    for (std::size_t p = 0; p < number_of_parts; ++p)
      if (volumes[p] < 0)
        for (int t : of_part_[p])
          turn(t);
    for (std::size_t p = 0; p < number_of_parts; ++p) {
      if (may_have_cavities && is_oriented_as_given && volumes[p] * sign < 0 &&
          is_within_others(static_cast<int>(p), volumes, sign)) {
        cavities.push_back(static_cast<int>(p));
        number_of_reoriented_parts += volumes[p] > 0;
      }
      else
        number_of_reoriented_parts += volumes[p] < 0;
    }
    for (int p : cavities)
      for (int t : of_part_[p])
        turn(t);
  }

  bool is_within_others(int p, const std::vector<double>& volumes, double sign) const
  {
    const std::size_t step = of_part_[p].size() / 20 + 1;
    for (std::size_t i = 0; i < of_part_[p].size(); i += step) {
      const Triangle_indices& t = triangles[of_part_[p][i]];
      const Vector_3 middle = (points_[t[0]] + points_[t[1]] + points_[t[2]]) / 3;
      double sum = 0;
      for (std::size_t q = 0; q < number_of_parts; ++q)
        if (static_cast<int>(q) != p && volumes[q] * sign > 0)
          sum += winding(static_cast<int>(q), middle);
      if (sum < .5)
        return false;
    }
    return true;
  }

  const Positions& points_;
  Eigen::AlignedBox3d box_;
  std::vector<std::vector<std::pair<int, bool>>> neighbors_; // of a triangle: another one, and whether they agree
  std::vector<int> patch_;                                   // of each triangle
  std::vector<std::vector<int>> of_patch_;
  int number_of_patches_ = 0;
  std::vector<char> is_closed_;            // of each patch, alone
  std::vector<int> group_;                 // of each patch
  std::vector<char> is_counted_;           // of each patch
  std::vector<std::vector<int>> of_part_;  // triangles
  std::vector<Eigen::AlignedBox3d> boxes_; // of the parts
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_PARTS_H
