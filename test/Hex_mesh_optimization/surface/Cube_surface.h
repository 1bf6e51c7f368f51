// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_CUBE_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_CUBE_SURFACE_H

// The surface of a cube of any size that stands for a mesh of 27 hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include "../mesh_families.h"

#include <cstddef>
#include <vector>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

constexpr double spacing = .5;
constexpr std::size_t number_of_faces = 54; // of the mesh that the surface stands for, with edges of length 1

struct Surface
{
  Positions points;
  std::vector<Triangle_indices> triangles;

  // a cube with as many faces as the mesh
  explicit Surface(double scale)
  {
    Indexed_mesh block;
    CGAL::Hex_mesh_optimization::make_block(block.points, block.hexahedra, {{3, 3, 3}}, {{3, 3, 3}});
    for_boundary(
      block,
      [&](const Indexed_mesh::Point& p) {
        points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
        return static_cast<int>(points.size()) - 1;
      },
      [&](int a, int b, int c) {
        triangles.push_back({a, b, c});
      });
  }

  std::vector<Surface_sample> samples() const
  {
    return spread_samples(Triangle_surface(points, triangles), number_of_faces, spacing);
  }
};

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_CUBE_SURFACE_H
