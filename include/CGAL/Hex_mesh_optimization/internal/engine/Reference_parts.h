// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_PARTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_PARTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The reference of a mesh whose surfaces do not all stay where they are, put together of what is given for some of them
// and the mesh as it came in for the others.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Reference_parts
{
public:
  // faces: of the complex, with one sheet for the outside, the first. All must outlive the object.
  Reference_parts(const Hexahedral_complex& complex, const Surface_faces& faces, const Positions& points,
                  const Feature_parameters& features)
    : complex_(complex)
    , faces_(faces)
    , points_(points)
    , features_(features)
    , is_given_(faces.labels.size(), false)
  {}

  // What is given for a sheet, before the rest: its features are the edges `sharp`.
  void add_given(int sheet, const Positions& points, const std::vector<Triangle_indices>& triangles,
                 const Edge_list& sharp)
  {
    const int first = static_cast<int>(reference_points_.size());
    is_given_[sheet] = true;
    reference_points_.insert(reference_points_.end(), points.begin(), points.end());
    for (const std::array<int, 2>& e : sharp)
      sharp_.push_back({e[0] + first, e[1] + first});
    if (sheet != outside)
      add_border(triangles);
    for (const Triangle_indices& t : triangles)
      add(t, first, sheet);
  }

  // What is given for all sheets at once, by their labels; triangles between labels that no faces are between are left out.
  void add_labelled(const Positions& points, const std::vector<Triangle_indices>& triangles,
                    const std::vector<std::array<int, 2>>& labels, const Edge_list& sharp)
  {
    reference_points_ = points;
    sharp_ = sharp;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto sheet = std::lower_bound(faces_.labels.begin(), faces_.labels.end(), labels[t]);
      if (sheet != faces_.labels.end() && *sheet == labels[t])
        add(triangles[t], 0, static_cast<int>(sheet - faces_.labels.begin()));
    }
  }

  // The mesh for all sheets for which nothing is given. Where an interface ends at a surface that goes elsewhere, it goes
  // along with that; no curve holds it where it was.
  void add_mesh()
  {
    const int first = static_cast<int>(reference_points_.size());
    reference_points_.insert(reference_points_.end(), points_.begin(), points_.end());
    const std::vector<Triangle_indices> of_faces = split_quads(faces_.quads);
    const Rims of_mesh = triangle_rims(faces_);
    std::vector<char> goes_along(points_.size(), false);
    for (std::size_t f = 0; f < faces_.quads.size(); ++f) {
      const int sheet = faces_.sheet(static_cast<int>(f));
      if (sheet == outside || is_given_[sheet])
        for (int v : faces_.quads[f])
          goes_along[v] = true;
      if (is_given_[sheet])
        continue;
      for (std::size_t t : {2 * f, 2 * f + 1}) {
        for (int k = 0; k < 3; ++k)
          if (of_mesh.has(t, k))
            rim_sides_.push_back(3 * triangles_.size() + k);
        add(of_faces[t], first, sheet);
      }
    }
    for (const std::array<int, 2>& e : sharp_boundary_edges(complex_, points_, features_.angle_bound))
      if (!goes_along[e[0]] && !goes_along[e[1]])
        sharp_.push_back({e[0] + first, e[1] + first});
    if (is_given_[outside])
      return;
    const Hexahedral_complex whole(points_.size(), complex_.hexahedra);
    for (const std::array<int, 2>& e : sharp_boundary_edges(whole, points_, features_.angle_bound))
      sharp_.push_back({e[0] + first, e[1] + first});
    for (int v : touching_vertices(whole))
      singular_.push_back(v + first);
  }

  // keep_all: the features are those given, none is noise.
  std::unique_ptr<const Reference_surface> joined(bool keep_all)
  {
    if (faces_.labels.size() < 2)
      sheets_.clear();
    Rims rims(triangles_, sheets_, rim_sides_, Beyond_rim::PLANE);
    return std::make_unique<const Reference_surface>(reference_points_, std::move(triangles_), std::move(sharp_),
                                                     keep_all, features_, std::move(sheets_), std::move(singular_),
                                                     std::move(rims));
  }

  static constexpr int outside = 0; // sheet

private:
  void add(const Triangle_indices& t, int first, int sheet)
  {
    triangles_.push_back({t[0] + first, t[1] + first, t[2] + first});
    sheets_.push_back(sheet);
  }

  // All of the border of a surface that is about to be added is a rim.
  void add_border(const std::vector<Triangle_indices>& triangles)
  {
    Triangle_adjacency(triangles).for_each_edge([&](const Triangle_adjacency::Sides& sides) {
      if (sides.size() == 1)
        rim_sides_.push_back(3 * (triangles_.size() + sides[0].triangle) + sides[0].corner);
    });
  }

  const Hexahedral_complex& complex_;
  const Surface_faces& faces_;
  const Positions& points_;
  const Feature_parameters& features_;
  std::vector<char> is_given_; // something for each sheet
  Positions reference_points_;
  std::vector<Triangle_indices> triangles_;
  std::vector<int> sheets_; // of the triangles
  std::vector<std::size_t> rim_sides_;
  Edge_list sharp_;
  std::vector<int> singular_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_REFERENCE_PARTS_H
