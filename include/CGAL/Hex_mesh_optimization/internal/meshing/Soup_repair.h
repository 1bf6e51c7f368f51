// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_REPAIR_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_REPAIR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Mends what keeps a triangle soup from bounding a volume, and tells what that changes: holes of any size are closed, and
// vertices that were pulled through the opposite side are left out.

#include <CGAL/Hex_mesh_optimization/Surface_repair.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_boundary.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_stitching.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/meeting_pairs.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Soup_repair
{
public:
  explicit Soup_repair(const Reference_input& given)
    : surface(given)
    , tolerance_(relative_tolerance * bounding_diagonal(given))
  {
    fill_holes();
    report.volume_before = report.volume_after = bounded_volume();
    if (volume_inside_out_ > least_part * report.volume_before && leave_out_vertices()) {
      report.volume_after = bounded_volume();
      measure_what_is_left_out();
    }
  }

  Reference_input surface;
  Surface_repair report;

private:
  static constexpr double relative_tolerance = 1e-5; // of borders that belong together: over the diagonal
  static constexpr double least_part = 1e-6;         // of the volume that is inside out: less is rounding
  static constexpr int most_vertices = 100;          // more are no accident

  static double bounding_diagonal(const Reference_input& given)
  {
    Eigen::AlignedBox3d box;
    for (const Vector_3& p : given.points)
      box.extend(p);
    return box.diagonal().norm();
  }

  void fill_holes()
  {
    Soup_stitching stitched(surface.points, surface.triangles, tolerance_, std::numeric_limits<double>::infinity());
    report.number_of_filled_holes = stitched.holes.size();
    for (const Soup_stitching::Hole& hole : stitched.holes)
      report.largest_filled_hole = (std::max)(report.largest_filled_hole, hole.size);
    if (stitched.holes.empty()) // the rest is for the mesher, which reports it
      return;
    surface.points = std::move(stitched.points);
    surface.triangles = std::move(stitched.triangles);
  }

  double bounded_volume()
  {
    const Soup_stitching stitched(surface.points, surface.triangles, tolerance_, 0);
    const Soup_parts parts(stitched.points, stitched.triangles);
    const Solid_boundary boundary(stitched.points, parts, tolerance_ / 10);
    volume_inside_out_ = boundary.volume_inside_out;
    return enclosed_volume(boundary.points, boundary.triangles);
  }

  // The vertex whose faces take part in the most intersections goes, as long as that makes intersections fewer: so a vertex
  // that was pulled through the opposite side goes, and that side stays.
  bool leave_out_vertices()
  {
    Soup_stitching stitched(surface.points, surface.triangles, tolerance_, 0);
    std::vector<Soup_pair> pairs = pairs_within_parts(stitched.points, stitched.triangles);
    for (int i = 0; i < most_vertices && !pairs.empty(); ++i) {
      std::vector<Soup_pair> best = pairs;
      std::vector<Triangle_indices> triangles;
      int worst = 0;
      for (int v : most_involved(pairs, stitched.triangles)) {
        const Soup_stitching without = left_out(v, stitched);
        std::vector<Soup_pair> left = pairs_within_parts(without.points, without.triangles);
        if (left.size() >= best.size())
          continue;
        best = std::move(left);
        triangles = without.triangles;
        worst = v;
      }
      if (triangles.empty())
        break;
      left_out_.push_back(stitched.points[worst]);
      stitched.triangles = std::move(triangles);
      pairs = std::move(best);
    }
    if (left_out_.empty())
      return false;
    report.number_of_skipped_vertices = left_out_.size();
    surface.points = stitched.points;
    surface.triangles = stitched.triangles;
    surface.sharp.clear();
    surface.sharp_is_given = false;
    return true;
  }

  // Parts may cross each other.
  static std::vector<Soup_pair> pairs_within_parts(const Positions& points,
                                                   const std::vector<Triangle_indices>& triangles)
  {
    const Soup_parts parts(points, triangles);
    std::vector<Soup_pair> result = meeting_pairs(Predicate_points{points}, triangles);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [&](const Soup_pair& p) { return parts.part[p.first] != parts.part[p.second]; }),
                 result.end());
    return result;
  }

  Soup_stitching left_out(int vertex, const Soup_stitching& from) const
  {
    std::vector<Triangle_indices> others;
    for (const Triangle_indices& t : from.triangles)
      if (std::find(t.begin(), t.end(), vertex) == t.end())
        others.push_back(t);
    return Soup_stitching(from.points, others, tolerance_, std::numeric_limits<double>::infinity());
  }

  // In the most pairs; a few, as on the opposite side one can be in as many.
  static std::vector<int> most_involved(const std::vector<Soup_pair>& pairs,
                                        const std::vector<Triangle_indices>& triangles)
  {
    constexpr std::size_t few = 4;
    std::map<int, std::size_t> number;
    for (const Soup_pair& pair : pairs) {
      std::set<int> around; // a pair counts once
      for (int t : {pair.first, pair.second})
        around.insert(triangles[t].begin(), triangles[t].end());
      for (int v : around)
        ++number[v];
    }
    std::vector<std::pair<std::size_t, int>> sorted;
    for (const auto& [v, n] : number)
      sorted.emplace_back(n, v);
    std::sort(sorted.rbegin(), sorted.rend());
    std::vector<int> result;
    for (std::size_t i = 0; i < (std::min)(few, sorted.size()); ++i)
      result.push_back(sorted[i].second);
    return result;
  }

  void measure_what_is_left_out()
  {
    const Triangle_surface tree(surface.points, surface.triangles);
    for (const Vector_3& p : left_out_) {
      report.skipped_vertices.push_back({p[0], p[1], p[2]});
      report.farthest = (std::max)(report.farthest, (tree.closest_point(p).point - p).norm());
    }
  }

  const double tolerance_;
  double volume_inside_out_ = 0;
  Positions left_out_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOUP_REPAIR_H
