// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SHELL_SWEEP_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SHELL_SWEEP_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Of a shell, a solid that is mostly a thin wall, hexahedra from one side of the wall to the other: the faces of the boundary on
// one side, and each vertex of these once more on the opposite side.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_fans.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Shell_sweep
{
public:
  // mesh: its labels are patches, its boundary stands on them. walls: of the surface of the partition, in another unit;
  // thin: those that are closer, in that unit.
  Shell_sweep(const Hexahedra& mesh, const Surface_partition& partition, const std::vector<Wall_distance>& walls,
              double thin)
    : partition_(partition)
    , side_(partition.number_of_patches(), NONE)
  {
    find_opposite_patches(walls, thin);
    if (find_sides())
      sweep(mesh);
  }

  // None where the patches do not make two sides of a wall.
  std::optional<Hexahedra> result;

private:
  enum Side { NONE, FRONT, BACK }; // none: a rim, which joins the two sides

  void find_opposite_patches(const std::vector<Wall_distance>& walls, double thin)
  {
    const std::size_t n = partition_.number_of_patches();
    area_.assign(n, 0);
    opposite_.assign(n, none);
    std::vector<std::map<int, double>> votes(n);
    for (const Wall_distance& p : walls) {
      const int patch = partition_.patch_of_triangle(p.triangle);
      area_[patch] += p.area;
      if (p.distance < thin)
        votes[patch][partition_.patch_of_triangle(p.opposite)] += p.area;
    }
    for (std::size_t p = 0; p < n; ++p)
      for (const auto& [other, area] : votes[p])
        if (area > area_[p] / 2)
          opposite_[p] = other;
  }

  // Patches beside each other are on the same side, opposite ones on different sides.
  bool find_sides()
  {
    const int n = static_cast<int>(partition_.number_of_patches());
    for (int start = 0; start < n; ++start) {
      if (opposite_[start] == none || side_[start] != NONE)
        continue;
      std::vector<int> members = {start};
      side_[start] = FRONT;
      for (std::size_t i = 0; i < members.size(); ++i) {
        const int p = members[i];
        if (!assign(opposite_[p], side_[p] == FRONT ? BACK : FRONT, members))
          return false;
        for (const auto& entry : partition_.borders())
          for (int k = 0; k < 2; ++k) {
            const int other = k == 0 ? entry.first.second : entry.first.first;
            if ((k == 0 ? entry.first.first : entry.first.second) == p && opposite_[other] != none &&
                !assign(other, side_[p], members))
              return false;
          }
      }
      double front = 0, back = 0;
      for (int p : members)
        (side_[p] == FRONT ? front : back) += area_[p];
      if (front < back) // the larger side is in front
        for (int p : members)
          side_[p] = side_[p] == FRONT ? BACK : FRONT;
    }
    return true;
  }

  bool assign(int patch, Side side, std::vector<int>& members)
  {
    if (opposite_[patch] == none)
      return false;
    if (side_[patch] == NONE) {
      side_[patch] = side;
      members.push_back(patch);
    }
    return side_[patch] == side;
  }

  void sweep(const Hexahedra& mesh)
  {
    const Boundary_fans fans(mesh, opposite_sides(mesh));
    std::vector<std::vector<int>> patches(mesh.points.size());
    for (std::size_t i = 0; i < fans.vertices.size(); ++i)
      for (int f : fans.fans[i])
        patches[fans.vertices[i]].push_back(mesh.label[fans.sides[f]]);
    Hexahedra swept;
    std::map<int, std::array<int, 2>> copies; // behind, in front
    for (std::size_t f = 0; f < fans.sides.size(); ++f) {
      if (side_[mesh.label[fans.sides[f]]] != FRONT)
        continue;
      Hexahedron h;
      for (int k = 0; k < 4; ++k) {
        const int v = fans.corners[f][k];
        auto found = copies.find(v);
        if (found == copies.end()) {
          const std::optional<Vector_3> behind = place_behind(patches[v], mesh.points[v]);
          if (!behind)
            return;
          const int first = static_cast<int>(swept.points.size());
          found = copies.emplace(v, std::array<int, 2>{first, first + 1}).first;
          swept.points.push_back(*behind);
          swept.points.push_back(mesh.points[v]);
        }
        h[k] = found->second[0];
        h[k + 4] = found->second[1];
      }
      swept.hexahedra.push_back(h);
    }
    orient(swept);
    swept.label.assign(6 * swept.hexahedra.size(), Hexahedra::no_label);
    if (!swept.hexahedra.empty())
      result = std::move(swept);
  }

  // On the patches opposite to those of the vertex, and the same rims.
  std::optional<Vector_3> place_behind(const std::vector<int>& patches, const Vector_3& p) const
  {
    std::vector<int> rims, walls;
    for (int patch : patches)
      if (side_[patch] == NONE)
        rims.push_back(patch);
      else if (side_[patch] == FRONT)
        walls.push_back(opposite_[patch]);
    std::vector<int> all = walls;
    all.insert(all.end(), rims.begin(), rims.end());
    for (std::vector<int> wanted : {all, walls}) {
      std::sort(wanted.begin(), wanted.end());
      wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
      if (const std::optional<Vector_3> place = partition_.nearest(wanted, p))
        return place;
    }
    return walls.empty() ? std::nullopt : partition_.nearest({walls[0]}, p);
  }

  // From behind to the front.
  static void orient(Hexahedra& swept)
  {
    double sum = 0;
    const auto& p = swept.points;
    for (const Hexahedron& h : swept.hexahedra)
      sum += (p[h[1]] - p[h[0]]).cross(p[h[3]] - p[h[0]]).dot(p[h[4]] - p[h[0]]) > 0 ? 1 : -1;
    if (sum < 0)
      for (Hexahedron& h : swept.hexahedra) {
        std::swap(h[1], h[3]);
        std::swap(h[5], h[7]);
      }
  }

  static constexpr int none = -1;

  const Surface_partition& partition_;
  std::vector<Side> side_;    // of each patch
  std::vector<double> area_;  // of each patch
  std::vector<int> opposite_; // patch, if most of a patch has one
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SHELL_SWEEP_H
