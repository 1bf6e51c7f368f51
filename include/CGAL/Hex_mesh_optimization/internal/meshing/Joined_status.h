// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_JOINED_STATUS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_JOINED_STATUS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// One status for several meshes that were optimized one after the other and are now one.

#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/quality_statistics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Of hexahedra, those that hang together by faces.
inline std::size_t number_of_pieces(const std::vector<Hexahedron>& hexahedra)
{
  const Face_neighbors neighbors(hexahedra);
  Disjoint_sets sets(hexahedra.size());
  std::size_t result = hexahedra.size();
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    if (neighbors.opposite(side) > side && sets.find(side / 6) != sets.find(neighbors.opposite(side) / 6)) {
      sets.unite(side / 6, neighbors.opposite(side) / 6);
      --result;
    }
  return result;
}

class Joined_status
{
public:
  // diagonal: of the box of all
  explicit Joined_status(double diagonal) : diagonal_(diagonal) {}

  Status status;
  Voxel_status of_grids;
  Positions points;
  std::vector<Hexahedron> hexahedra;

  // area: of the boundary
  void add(Status part, Voxel_status of_grid, const Positions& positions, const std::vector<Hexahedron>& corners,
           double area)
  {
    const std::size_t n = hexahedra.size(), first_vertex = points.size();
    shift(part, first_vertex, n);
    join(of_grid, corners.size());
    if (n == 0) {
      status = std::move(part);
      area_ = area;
    }
    else
      join(part, area, n, corners.size());
    points.insert(points.end(), positions.begin(), positions.end());
    for (Hexahedron h : corners) {
      for (int& v : h)
        v += static_cast<int>(first_vertex);
      hexahedra.push_back(h);
    }
    is_one_ = n == 0;
  }

  // After the last one.
  void finish()
  {
    std::sort(of_grids.thin_faces.begin(), of_grids.thin_faces.end());
    of_grids.thin_faces.erase(std::unique(of_grids.thin_faces.begin(), of_grids.thin_faces.end()),
                              of_grids.thin_faces.end());
    if (is_one_)
      return;
    status.after = quality_statistics(points, hexahedra);
    status.deviation.average_relative = status.deviation.average / diagonal_;
    status.deviation.maximum_relative = status.deviation.maximum / diagonal_;
  }

private:
  static void append(std::vector<std::size_t>& list, const std::vector<std::size_t>& more)
  {
    list.insert(list.end(), more.begin(), more.end());
  }

  static void shift(Status& part, std::size_t vertices, std::size_t of_hexahedra)
  {
    for (std::vector<std::size_t>* list : {&part.invalid_hexahedra, &part.locked_hexahedra, &part.reoriented_hexahedra})
      for (std::size_t& h : *list)
        h += of_hexahedra;
    for (std::size_t& v : part.vertices_off_reference)
      v += vertices;
    for (Connectivity_limit& limit : part.connectivity_limits)
      limit.hexahedron += of_hexahedra;
  }

  // By their labels.
  void join(const std::vector<Region_volume>& regions)
  {
    for (const Region_volume& region : regions) {
      const auto at = std::lower_bound(status.regions.begin(), status.regions.end(), region.label,
                                       [](const Region_volume& r, int label) { return r.label < label; });
      if (at == status.regions.end() || at->label != region.label)
        status.regions.insert(at, region);
      else {
        at->before += region.before;
        at->after += region.after;
      }
    }
  }

  // The mean over as many cells.
  void join(Voxel_status& of_grid, std::size_t cells)
  {
    const double before = double(hexahedra.size()), all = before + double(cells);
    of_grids.spacing = std::cbrt(
      (before * std::pow(of_grids.spacing, 3) + double(cells) * std::pow(of_grid.spacing, 3)) / all);
    of_grids.has_topology_of_surface = of_grids.has_topology_of_surface && of_grid.has_topology_of_surface;
    append(of_grids.thin_faces, of_grid.thin_faces);
  }

  void join(const Status& part, double area, std::size_t n, std::size_t m)
  {
    status.return_code = (std::max)(status.return_code, part.return_code,
                                    [](Return_code a, Return_code b) { return severity(a) < severity(b); });
    join(status.before, part.before, double(n), double(m));
    status.deviation.average = (status.deviation.average * area_ + part.deviation.average * area) / (area_ + area);
    area_ += area;
    status.deviation.maximum = (std::max)(status.deviation.maximum, part.deviation.maximum);
    status.deviation.certified = (std::max)(status.deviation.certified, part.deviation.certified);
    status.deviation.bilinear = (std::max)(status.deviation.bilinear, part.deviation.bilinear);
    join(part.regions);
    status.interfaces.insert(status.interfaces.end(), part.interfaces.begin(), part.interfaces.end());
    std::sort(status.interfaces.begin(), status.interfaces.end(),
              [](const auto& a, const auto& b) { return a.labels < b.labels; });
    status.volume_before += part.volume_before;
    status.volume_after += part.volume_after;
    status.iterations += part.iterations;
    status.rectification_seconds += part.rectification_seconds;
    status.untangling_seconds += part.untangling_seconds;
    status.maximization_seconds += part.maximization_seconds;
    status.total_seconds += part.total_seconds;
    status.volume_changes.insert(status.volume_changes.end(), part.volume_changes.begin(), part.volume_changes.end());
    status.attempts.insert(status.attempts.end(), part.attempts.begin(), part.attempts.end());
    append(status.invalid_hexahedra, part.invalid_hexahedra);
    append(status.locked_hexahedra, part.locked_hexahedra);
    append(status.reoriented_hexahedra, part.reoriented_hexahedra);
    append(status.vertices_off_reference, part.vertices_off_reference);
    status.connectivity_limits.insert(status.connectivity_limits.end(), part.connectivity_limits.begin(),
                                      part.connectivity_limits.end());
    status.number_of_coincident_vertices += part.number_of_coincident_vertices;
  }

  // Of a mesh of which the positions are not there any more: the median is the mean of both.
  static void join(Quality_statistics& a, const Quality_statistics& b, double n, double m)
  {
    const auto mean = [&](double x, double y) { return (n * x + m * y) / (n + m); };
    const double average = mean(a.average, b.average);
    const auto squares = [&](const Quality_statistics& s) {
      return s.standard_deviation * s.standard_deviation + (s.average - average) * (s.average - average);
    };
    a.standard_deviation = std::sqrt(mean(squares(a), squares(b)));
    a.average = average;
    a.average_with_center = mean(a.average_with_center, b.average_with_center);
    a.median_edge_ratio = mean(a.median_edge_ratio, b.median_edge_ratio);
    a.number_of_hexahedra += b.number_of_hexahedra;
    a.number_of_inverted += b.number_of_inverted;
    a.number_of_invalid += b.number_of_invalid;
    a.minimum = (std::min)(a.minimum, b.minimum);
    a.minimum_with_center = (std::min)(a.minimum_with_center, b.minimum_with_center);
    a.maximum_edge_ratio = (std::max)(a.maximum_edge_ratio, b.maximum_edge_ratio);
    a.edge_ratio_99 = (std::max)(a.edge_ratio_99, b.edge_ratio_99);
  }

  // What is worth saying of all, if one of them ended so.
  static int severity(Return_code code)
  {
    switch (code) {
    case Return_code::STOPPED_BY_VISITOR:
      return 6;
    case Return_code::TIME_LIMIT:
      return 5;
    case Return_code::DEVIATION_BOUND_NOT_MET:
      return 4;
    case Return_code::ITERATION_LIMIT:
      return 3;
    case Return_code::CONVERGED:
      return 2;
    case Return_code::TARGET_QUALITY_REACHED:
      return 1;
    case Return_code::NO_IMPROVEMENT:
      return 0;
    }
    return 0;
  }

  const double diagonal_;
  double area_ = 0;
  bool is_one_ = true;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_JOINED_STATUS_H
