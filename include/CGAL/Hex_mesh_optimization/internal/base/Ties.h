// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_TIES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_TIES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Points that are tied to each other: they make the same step, so that the differences of their places stay as they are.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Ties
{
public:
  Ties() = default;

  // pairs: of so many points; who is tied to the same one is tied.
  Ties(std::size_t points, const std::vector<std::array<int, 2>>& pairs)
  {
    if (pairs.empty())
      return;
    Disjoint_sets sets(points);
    for (const std::array<int, 2>& p : pairs)
      sets.unite(p[0], p[1]);
    leader_.resize(points);
    std::vector<int> group(points, -1); // of the leaders
    for (std::size_t v = 0; v < points; ++v) {
      const std::size_t leader = sets.find(v); // the smallest index
      leader_[v] = static_cast<int>(leader);
      if (leader == v)
        continue;
      if (group[leader] < 0) {
        group[leader] = static_cast<int>(groups_.size());
        groups_.push_back({leader_[v]});
      }
      groups_[group[leader]].push_back(static_cast<int>(v));
    }
  }

  bool is_empty() const { return groups_.empty(); }

  // Of each point the first one of those that are tied to it.
  int leader(int v) const { return is_empty() ? v : leader_[v]; }

  // Of two or more points each, the leader first.
  const std::vector<std::vector<int>>& groups() const { return groups_; }

  // Gives all points of a group what the leader has.
  template <class T>
  void follow(std::vector<T>& values) const
  {
    for (const std::vector<int>& group : groups_)
      for (int v : group)
        values[v] = values[group.front()];
  }

  // Gives all points of a group their mean.
  template <class T>
  void average(std::vector<T>& values) const
  {
    for (const std::vector<int>& group : groups_) {
      T sum = values[group.front()];
      for (std::size_t i = 1; i < group.size(); ++i)
        sum += values[group[i]];
      values[group.front()] = sum / double(group.size());
    }
    follow(values);
  }

  // Marks all points of a group of which one is marked.
  void unite(std::vector<char>& is_marked) const
  {
    for (const std::vector<int>& group : groups_)
      for (int v : group)
        is_marked[group.front()] = is_marked[group.front()] || is_marked[v];
    follow(is_marked);
  }

private:
  std::vector<int> leader_; // of the points, or none
  std::vector<std::vector<int>> groups_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_TIES_H
