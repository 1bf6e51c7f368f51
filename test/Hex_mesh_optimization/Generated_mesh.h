// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_MESH_H

// Generated meshes as the engine has them, and their boundaries as reference.

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

struct Generated_mesh
{
  Positions points;
  Hexahedral_complex complex;

  template <class Make>
  explicit Generated_mesh(Make make) : Generated_mesh(generated(make))
  {}

  explicit Generated_mesh(const std::pair<Positions, std::vector<Hexahedron>>& mesh)
    : points(mesh.first)
    , complex(points.size(), mesh.second)
  {}

  template <class Make>
  static std::pair<Positions, std::vector<Hexahedron>> generated(Make make)
  {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    make(points, hexahedra);
    std::pair<Positions, std::vector<Hexahedron>> result;
    for (const auto& p : points)
      result.first.emplace_back(p.x(), p.y(), p.z());
    for (const auto& h : hexahedra) {
      result.second.emplace_back();
      std::copy(h.begin(), h.end(), result.second.back().begin());
    }
    return result;
  }

  std::unique_ptr<Reference_surface> own_reference(double angle_bound = 45) const
  {
    return boundary_as_reference(complex, points, Feature_parameters{angle_bound});
  }
};

inline Generated_mesh block(std::size_t n)
{
  return Generated_mesh([&](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_block(p, h, {{n, n, n}}); });
}
inline Generated_mesh cylinder(std::size_t n)
{
  return Generated_mesh([&](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_cylinder(p, h, n, n); });
}
inline Generated_mesh l_shape(std::size_t n)
{
  return Generated_mesh([&](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_l_shape(p, h, n); });
}

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_GENERATED_MESH_H
