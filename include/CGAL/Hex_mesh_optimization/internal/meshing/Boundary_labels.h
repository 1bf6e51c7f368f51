// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_LABELS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_LABELS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which patch of the surface each face of the boundary stands for.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_fans.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Boundary_labels
{
public:
  // Of the faces in the order of fans.sides.
  Boundary_labels(const Hexahedra& mesh, const Boundary_fans& fans, const Surface_partition& partition)
    : labels(fans.sides.size())
    , fans_(fans)
  {
    Positions foot(mesh.points.size());
    for (int v : fans.vertices)
      foot[v] = partition.surface.closest_point(mesh.points[v]).point;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      Vector_3 center = Vector_3::Zero();
      for (int v : fans.corners[i])
        center += foot[v] / 4;
      labels[i] = partition.patch_of_triangle(partition.surface.closest_point(center).triangle);
    }
    bool any = true;
    for (int round = 0; any && round < most_rounds; ++round) {
      any = smooth();
      any = drop_islands() || any;
      any = untouch() || any;
    }
  }

  std::vector<int> labels;

private:
  static constexpr int most_rounds = 20;

  // A face with another label on three sides takes it.
  bool smooth()
  {
    bool any = false;
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (int k = 0; k < 2; ++k) {
        const int other = labels[fans_.neighbors[i][k]];
        const auto has_it = [&](int j) { return labels[j] == other; };
        if (other != labels[i] && std::count_if(fans_.neighbors[i].begin(), fans_.neighbors[i].end(), has_it) >= 3) {
          labels[i] = other;
          any = true;
          break;
        }
      }
    return any;
  }

  // Of the faces with one label, those that do not hang together with the most of them take another one.
  bool drop_islands()
  {
    Disjoint_sets sets(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (int j : fans_.neighbors[i])
        if (labels[i] == labels[j])
          sets.unite(i, j);
    std::vector<int> size(labels.size(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i)
      ++size[sets.find(i)];
    std::map<int, std::size_t> largest; // set of each label
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (size[i] > 0) {
        const auto inserted = largest.emplace(labels[i], i);
        if (size[i] > size[inserted.first->second])
          inserted.first->second = i;
      }
    bool any = false;
    std::map<std::size_t, std::map<int, int>> around; // of an island: how often each label is beside it
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (sets.find(i) != largest[labels[i]])
        for (int j : fans_.neighbors[i])
          if (labels[j] != labels[i])
            ++around[sets.find(i)][labels[j]];
    std::vector<int> changed = labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto found = around.find(sets.find(i));
      if (found == around.end())
        continue;
      changed[i] = std::max_element(found->second.begin(), found->second.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
      any = true;
    }
    labels = std::move(changed);
    return any;
  }

  // Where faces with one label touch in a vertex only, the fewer ones between them take it.
  bool untouch()
  {
    bool any = false;
    for (const std::vector<int>& fan : fans_.fans)
      any = untouch(fan) || any;
    return any;
  }

  bool untouch(const std::vector<int>& fan)
  {
    const std::size_t n = fan.size();
    std::size_t start = 0; // of a run
    while (start < n && labels[fan[start]] == labels[fan[(start + n - 1) % n]])
      ++start;
    if (start == n)
      return false;
    std::vector<std::pair<std::size_t, std::size_t>> runs; // first, size
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t place = (start + i) % n;
      if (i == 0 || labels[fan[place]] != labels[fan[(place + n - 1) % n]])
        runs.emplace_back(place, 0);
      ++runs.back().second;
    }
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (std::size_t s = r + 2; s < runs.size(); ++s) {
        const int label = labels[fan[runs[r].first]];
        if (label != labels[fan[runs[s].first]])
          continue;
        std::size_t inner = 0, outer = 0; // faces between them
        for (std::size_t t = 0; t < runs.size(); ++t)
          (t > r && t < s ? inner : outer) += t == r || t == s ? 0 : runs[t].second;
        for (std::size_t t = 0; t < runs.size(); ++t)
          if (t != r && t != s && (t > r && t < s) == (inner <= outer))
            for (std::size_t i = 0; i < runs[t].second; ++i)
              labels[fan[(runs[t].first + i) % n]] = label;
        return true;
      }
    return false;
  }

  const Boundary_fans& fans_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_BOUNDARY_LABELS_H
