// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PATCH_LAYERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PATCH_LAYERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A layer of hexahedra behind each patch of the boundary, so that every face of the boundary has a hexahedron of its own,
// and every sharp edge the number of hexahedra that suits its angle.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_fans.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Layer_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/insert_layers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// mesh.label are patches. Patches are in groups, each with a layer of its own. Where two groups meet their layers cross
// and each ends on the patches of the other. O(n log n) for each of the few rounds that it takes if groups that touch come
// one after the other.
class Patch_layers
{
public:
  Patch_layers(Hexahedra& mesh, const Surface_partition& partition, const Layer_parameters& parameters)
    : mesh_(mesh)
    , partition_(partition)
    , parameters_(parameters)
  {
    const std::vector<int> group = groups();
    const std::set<int> needing = groups_in_need(group);
    for (const std::vector<int>& patches : apart(group)) {
      const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh_);
      std::vector<char> is_marked(opposite.size(), false);
      for (std::size_t side = 0; side < opposite.size(); ++side)
        is_marked[side] = opposite[side] < 0 && needing.count(group[mesh_.label[side]]) &&
                          std::binary_search(patches.begin(), patches.end(), mesh_.label[side]);
      insert_layers(mesh_, opposite, is_marked, parameters_.thickness);
    }
  }

private:
  Boundary_fans fans() const { return Boundary_fans(mesh_, opposite_sides(mesh_)); }

  // Of each patch.
  std::vector<int> groups() const
  {
    const Boundary_fans fans = this->fans();
    const auto label = [&](int f) { return mesh_.label[fans.sides[f]]; };
    Disjoint_sets sets(partition_.number_of_patches());
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      for (int g : fans.neighbors[f])
        if (label(static_cast<int>(f)) < label(g)) {
          const Surface_partition::Border* border = partition_.border(label(static_cast<int>(f)), label(g));
          if (!border || border->angle > parameters_.largest_crossing)
            sets.unite(label(static_cast<int>(f)), label(g));
        }
    // Around a vertex there may be three groups, each in one piece: more than three layers do not cross in a hexahedron.
    for (bool any = true; any;) {
      any = false;
      for (const std::vector<int>& fan : fans.fans) {
        std::vector<std::array<int, 2>> meeting; // labels beside an edge between groups
        std::set<std::size_t> distinct;
        for (std::size_t i = 0; i < fan.size(); ++i) {
          const int a = label(fan[i]), b = label(fan[(i + 1) % fan.size()]);
          distinct.insert(sets.find(a));
          if (sets.find(a) != sets.find(b))
            meeting.push_back({a, b});
        }
        if (meeting.empty() || (meeting.size() <= 3 && meeting.size() == distinct.size()))
          continue;
        const auto widest = std::max_element(meeting.begin(), meeting.end(),
                                             [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
        sets.unite((*widest)[0], (*widest)[1]);
        any = true;
      }
    }
    std::vector<int> result;
    for (std::size_t p = 0; p < partition_.number_of_patches(); ++p)
      result.push_back(static_cast<int>(sets.find(p)));
    return result;
  }

  // Those whose faces cannot do with the hexahedra that they have: too few or too many share the angle at an edge, or a
  // face has two edges on one curve.
  std::set<int> groups_in_need(const std::vector<int>& group) const
  {
    const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh_);
    const Boundary_fans fans(mesh_, opposite);
    const auto label = [&](int f) { return mesh_.label[fans.sides[f]]; };
    const std::vector<int> meeting = patches_meeting(fans);
    std::set<int> result;
    for (std::size_t i = 0; i < fans.sides.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const int f = static_cast<int>(i), g = fans.neighbors[f][k];
        const int n = hexahedra_around(opposite, fans.sides[f], fans.corners[f][k], fans.corners[f][(k + 1) % 4]);
        const double theta = label(f) == label(g) ? 180 : angle({label(f), label(g)});
        const bool is_bent = label(f) != label(g) && label(g) == label(fans.neighbors[f][(k + 3) % 4]) &&
                             meeting[fans.corners[f][k]] == 2;
        if (is_bent || theta / n > parameters_.largest_crossing || theta / n < parameters_.smallest_angle)
          result.insert({group[label(f)], group[label(g)]});
      }
    return result;
  }

  // That share the boundary edge from a to b of a side.
  int hexahedra_around(const std::vector<std::ptrdiff_t>& opposite, std::size_t side, int a, int b) const
  {
    for (int n = 1;; ++n) {
      side = side_beside(mesh_, side, a, b);
      if (opposite[side] < 0)
        return n;
      side = static_cast<std::size_t>(opposite[side]);
    }
  }

  // How many meet at each vertex of the boundary.
  std::vector<int> patches_meeting(const Boundary_fans& fans) const
  {
    std::vector<int> result(mesh_.points.size(), 0);
    for (std::size_t i = 0; i < fans.vertices.size(); ++i) {
      std::set<int> distinct;
      for (int f : fans.fans[i])
        distinct.insert(mesh_.label[fans.sides[f]]);
      result[fans.vertices[i]] = static_cast<int>(distinct.size());
    }
    return result;
  }

  double angle(const std::array<int, 2>& patches) const
  {
    const Surface_partition::Border* border = partition_.border(patches[0], patches[1]);
    return border ? border->angle : 180;
  }

  // The patches, sorted, of groups no two of which share a vertex, for few sets of groups.
  std::vector<std::vector<int>> apart(const std::vector<int>& group) const
  {
    const Boundary_fans fans = this->fans();
    std::map<int, std::set<int>> touching;
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      touching[group[mesh_.label[fans.sides[f]]]];
    for (const std::vector<int>& fan : fans.fans)
      for (int f : fan)
        for (int g : fan)
          if (group[mesh_.label[fans.sides[f]]] != group[mesh_.label[fans.sides[g]]])
            touching[group[mesh_.label[fans.sides[f]]]].insert(group[mesh_.label[fans.sides[g]]]);
    std::map<int, std::size_t> round;
    std::vector<std::vector<int>> result;
    for (const auto& [g, others] : touching) {
      std::set<std::size_t> taken;
      for (int other : others)
        if (round.count(other))
          taken.insert(round[other]);
      std::size_t r = 0;
      while (taken.count(r))
        ++r;
      round[g] = r;
      if (r == result.size())
        result.emplace_back();
      for (std::size_t p = 0; p < group.size(); ++p)
        if (group[p] == g)
          result[r].push_back(static_cast<int>(p));
    }
    for (std::vector<int>& patches : result)
      std::sort(patches.begin(), patches.end());
    return result;
  }

  Hexahedra& mesh_;
  const Surface_partition& partition_;
  const Layer_parameters parameters_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_PATCH_LAYERS_H
