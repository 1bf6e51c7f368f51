// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_PARTITION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_PARTITION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A surface cut along its feature curves into patches: the nearest patch, and the nearest place of a patch, of what two
// patches share, or of what several do.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Surface_partition
{
public:
  using Patch_pair = std::pair<int, int>; // the smaller one first

  // What two patches share.
  struct Border
  {
    std::vector<int> curves;
    double length = 0;
    double angle = 0; // between the two, through the inside, in degrees: the mean over the length
  };

  // Points in units of the spacing of the mesh to be made, for which feature parameters are meant. sharp, keep_all, sheets: as
  // of Reference_surface. A patch is of one sheet.
  Surface_partition(const Positions& points, const std::vector<Triangle_indices>& triangles, Edge_list sharp,
                    bool keep_all, const Feature_parameters& parameters, std::vector<int> sheets = {})
    : surface(points, triangles, std::move(sharp), keep_all, parameters, std::move(sheets))
    , patch_of_triangle_(triangles.size())
  {
    const Triangle_adjacency adjacency(triangles);
    number_patches(adjacency);
    collect_borders(adjacency);
  }

  std::size_t number_of_patches() const { return patches_.size(); }
  int patch_of_triangle(std::size_t t) const { return patch_of_triangle_[t]; }
  const std::map<Patch_pair, Border>& borders() const { return borders_; }

  static Patch_pair ordered(int a, int b) { return {(std::min)(a, b), (std::max)(a, b)}; }

  const Border* border(int a, int b) const
  {
    const auto found = borders_.find(ordered(a, b));
    return found == borders_.end() ? nullptr : &found->second;
  }

  // The place nearest to p that belongs to all of the patches, sorted; none where they have no such place.
  std::optional<Vector_3> nearest(const std::vector<int>& patches, const Vector_3& p) const
  {
    if (patches.size() == 1)
      return patches_[patches[0]]->closest_point(p).point;
    std::optional<Vector_3> best;
    const auto propose = [&](const Vector_3& q) {
      if (!best || (q - p).squaredNorm() < (*best - p).squaredNorm())
        best = q;
    };
    if (patches.size() == 2) {
      if (const Border* shared = border(patches[0], patches[1]))
        for (int c : shared->curves)
          propose(surface.curves[c]->closest_point(p).point);
      return best;
    }
    for (std::size_t i = 0; i < surface.corners.size(); ++i)
      if (std::includes(patches_at_corner_[i].begin(), patches_at_corner_[i].end(), patches.begin(), patches.end()))
        propose(surface.points[surface.corners[i]]);
    return best;
  }

  // Of the sheet of a patch.
  Vector_3 closest_point(int patch, const Vector_3& p) const
  {
    return surface.closest_point(p, Surface_point::no_triangle, sheet_of_patch_[patch]).point;
  }
  Foot_point foot_point(int patch, const Vector_3& p) const
  {
    return surface.foot_point(p, Surface_point::no_triangle, sheet_of_patch_[patch]);
  }

  const Reference_surface surface;

private:
  void number_patches(const Triangle_adjacency& adjacency)
  {
    for (std::size_t c = 0; c < surface.curves.size(); ++c)
      for (std::size_t i = 0; i + 1 < surface.curves[c]->vertices.size(); ++i)
        curve_of_edge_[Triangle_adjacency::ordered(
          {surface.curves[c]->vertices[i], surface.curves[c]->vertices[i + 1]})] = static_cast<int>(c);
    Disjoint_sets sets(surface.triangles.size());
    adjacency.for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      if (!curve_of_edge_.count(sides[0].edge))
        for (std::size_t i = 1; i < sides.size(); ++i)
          if (surface.sheet(sides[i].triangle) == surface.sheet(sides[0].triangle))
            sets.unite(sides[i].triangle, sides[0].triangle);
    });
    std::map<std::size_t, int> number;
    std::vector<std::vector<Triangle_indices>> of_patch;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto inserted = number.emplace(sets.find(t), static_cast<int>(of_patch.size()));
      if (inserted.second) {
        of_patch.emplace_back();
        sheet_of_patch_.push_back(surface.sheet(t));
      }
      patch_of_triangle_[t] = inserted.first->second;
      of_patch[inserted.first->second].push_back(surface.triangles[t]);
    }
    std::vector<int> local(surface.points.size(), -1);
    for (std::vector<Triangle_indices>& triangles : of_patch) {
      Positions points;
      std::vector<int> used;
      for (Triangle_indices& t : triangles)
        for (int& v : t) {
          if (local[v] < 0) {
            local[v] = static_cast<int>(points.size());
            points.push_back(surface.points[v]);
            used.push_back(v);
          }
          v = local[v];
        }
      for (int v : used)
        local[v] = -1;
      patches_.push_back(std::make_unique<const Triangle_surface>(std::move(points), std::move(triangles)));
    }
  }

  void collect_borders(const Triangle_adjacency& adjacency)
  {
    std::map<int, std::set<int>> at_vertex;
    for (const auto& [edge, curve] : curve_of_edge_) {
      const Triangle_adjacency::Sides sides = adjacency.sides(edge);
      for (const Triangle_adjacency::Side& side : sides)
        for (int v : edge)
          at_vertex[v].insert(patch_of_triangle_[side.triangle]);
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j)
          add_to_border(sides[i], sides[j], curve, edge);
    }
    for (auto& of_pair : borders_)
      if (of_pair.second.length > 0)
        of_pair.second.angle /= of_pair.second.length;
    for (int corner : surface.corners)
      patches_at_corner_.emplace_back(at_vertex[corner].begin(), at_vertex[corner].end());
  }

  void add_to_border(const Triangle_adjacency::Side& a, const Triangle_adjacency::Side& b, int curve,
                     const std::array<int, 2>& edge)
  {
    if (patch_of_triangle_[a.triangle] == patch_of_triangle_[b.triangle])
      return;
    Border& border = borders_[ordered(patch_of_triangle_[a.triangle], patch_of_triangle_[b.triangle])];
    if (std::find(border.curves.begin(), border.curves.end(), curve) == border.curves.end())
      border.curves.push_back(curve);
    const double length = (surface.points[edge[1]] - surface.points[edge[0]]).norm();
    border.length += length;
    border.angle += length * interior_angle(a, b);
  }

  double interior_angle(const Triangle_adjacency::Side& a, const Triangle_adjacency::Side& b) const
  {
    const auto normal = [&](const Triangle_adjacency::Side& side) {
      const Vector_3& origin = surface.corner(side.triangle, 0);
      return Vector_3((surface.corner(side.triangle, 1) - origin).cross(surface.corner(side.triangle, 2) - origin));
    };
    const Vector_3 m = normal(a), n = normal(b);
    // along the edge as the first triangle runs
    const Vector_3 edge = surface.corner(a.triangle, (a.corner + 1) % 3) - surface.corner(a.triangle, a.corner);
    const double bend = std::atan2(m.cross(n).dot(edge.normalized()), m.dot(n)); // positive where convex
    return 180 - bend * 180 / CGAL_PI;
  }

  std::map<std::array<int, 2>, int> curve_of_edge_;
  std::vector<int> patch_of_triangle_;
  std::vector<int> sheet_of_patch_;
  std::vector<std::unique_ptr<const Triangle_surface>> patches_;
  std::map<Patch_pair, Border> borders_;
  std::vector<std::vector<int>> patches_at_corner_; // of each corner of the surface, sorted
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SURFACE_PARTITION_H
