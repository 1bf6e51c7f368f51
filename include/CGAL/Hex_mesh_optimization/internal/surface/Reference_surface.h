// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The surface that the boundary of the mesh has to stay on, with its feature curves:
// closest point and normal, closest point of a curve and tangent.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve_tracer.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Smooth_normals.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The point of the reference closest to a vertex.
struct Foot_point : Surface_point
{
  Vector_3 normal = Vector_3::Zero(); // unit length, outwards; smooth between feature curves
};

// What makes a corner: a curve that ends, one that turns, or several that meet, as do sheets that touch in a vertex.
enum class Corner_rank : char { END, TURN, JUNCTION };

class Reference_surface : public Triangle_surface
{
public:
  // sharp: the edges that can belong to features. keep_all: they were named by the user, none is noise. its_sheets: as for
  // Triangle_surface, as are its_rims. singular: vertices that are corners, whether or not curves meet there.
  Reference_surface(const Positions& its_points, std::vector<Triangle_indices> its_triangles, Edge_list sharp,
                    bool keep_all, const Feature_parameters& parameters, std::vector<int> its_sheets = {},
                    std::vector<int> singular = {}, Rims its_rims = {})
    : Reference_surface(its_points, std::move(its_triangles), std::move(its_sheets), std::move(singular),
                        std::move(its_rims),
                        Feature_curve_tracer(its_points, its_triangles, std::move(sharp), keep_all, parameters))
  {}

  // At a point of a triangle that is not degenerate, given by barycentric coordinates.
  Vector_3 normal(std::size_t triangle, const std::array<double, 3>& coordinates) const
  {
    return normals_.at(triangle, coordinates);
  }

  // near, sheet: as for closest_point()
  Foot_point foot_point(const Vector_3& query, std::size_t near = Surface_point::no_triangle, int sheet = 0) const
  {
    const Surface_point q = closest_point(query, near, sheet);
    return {q, normal(q.triangle, q.coordinates)};
  }

  Corner_rank corner_rank(int corner) const
  {
    if (std::binary_search(singular_.begin(), singular_.end(), corner))
      return Corner_rank::JUNCTION;
    const std::size_t ends = std::count(curve_ends_.begin(), curve_ends_.end(), corner);
    return ends < 2 ? Corner_rank::END : ends == 2 ? Corner_rank::TURN : Corner_rank::JUNCTION;
  }

  const std::vector<std::unique_ptr<const Feature_curve>> curves;
  const std::vector<int> corners; // vertices where curves meet, end or turn sharply

private:
  // features: of the points and triangles
  Reference_surface(const Positions& its_points, std::vector<Triangle_indices>&& its_triangles,
                    std::vector<int>&& its_sheets, std::vector<int>&& singular, Rims&& its_rims,
                    const Feature_curve_tracer& features)
    : Triangle_surface(its_points, std::move(its_triangles), std::move(its_sheets), std::move(its_rims))
    , curves(curves_through(features.curves(), its_points))
    , corners(united(features.corners(), singular))
    , curve_ends_(ends_of(features.curves()))
    , singular_(std::move(singular))
    , normals_(*this, edges_of(features.curves()))
  {}

  // Of two sorted lists.
  static std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b)
  {
    std::vector<int> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  static std::vector<int> ends_of(const std::vector<std::vector<int>>& curves)
  {
    std::vector<int> result;
    for (const std::vector<int>& vertices : curves)
      result.insert(result.end(), {vertices.front(), vertices.back()});
    return result;
  }

  static std::vector<std::unique_ptr<const Feature_curve>> curves_through(const std::vector<std::vector<int>>& curves,
                                                                          const Positions& points)
  {
    std::vector<std::unique_ptr<const Feature_curve>> result;
    for (const std::vector<int>& vertices : curves)
      result.push_back(std::make_unique<const Feature_curve>(vertices, points));
    return result;
  }

  // Sorted, the smaller index first.
  static Edge_list edges_of(const std::vector<std::vector<int>>& curves)
  {
    Edge_list result;
    for (const std::vector<int>& vertices : curves)
      for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        result.push_back(Triangle_adjacency::ordered({vertices[i], vertices[i + 1]}));
    std::sort(result.begin(), result.end());
    return result;
  }

  const std::vector<int> curve_ends_; // vertices, each as often as a curve begins or ends there
  const std::vector<int> singular_;   // sorted
  const Smooth_normals normals_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_REFERENCE_SURFACE_H
