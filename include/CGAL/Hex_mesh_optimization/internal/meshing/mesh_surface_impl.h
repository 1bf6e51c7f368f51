// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_IMPL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_IMPL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The definitions of what mesh_surface.h declares.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Hex_mesher.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_mesher.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_surfaces.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_repair.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_check.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/grid_planes.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/insert_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/surface_components.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/thin_walls.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

CGAL_HEX_MESH_OPTIMIZATION_INLINE
void require_volume(const Reference_input& surface) { Surface_check check(surface); }

// Of the boundary, where it is a manifold of quadrilaterals: these have twice as many edges.
inline std::ptrdiff_t euler_characteristic(const Hexahedra& mesh)
{
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  std::set<int> vertices;
  std::ptrdiff_t faces = 0;
  for (std::size_t side = 0; side < opposite.size(); ++side)
    if (opposite[side] < 0) {
      ++faces;
      for (int v : mesh.face(side))
        vertices.insert(v);
    }
  return static_cast<std::ptrdiff_t>(vertices.size()) - faces;
}

// Sets the rest of a body with a surface and parameters.
inline void mesh_body(Meshed_body& body)
{
  const Matrix_3 axes = grid_axes(body.surface.points, body.surface.triangles, body.parameters.grid);
  Reference_input turned = body.surface;
  for (Vector_3& p : turned.points)
    p = axes.transpose() * p;
  const auto take = [&](const auto& mesher) {
    body.points.clear();
    for (const Vector_3& p : mesher.mesh.points)
      body.points.push_back(axes * p);
    body.hexahedra = mesher.mesh.hexahedra;
    body.euler_characteristic = euler_characteristic(mesher.mesh);
    body.area = surface_area(body.surface.points, body.surface.triangles);
  };
  if (!body.surface.labels.empty()) {
    const Region_mesher mesher(turned, body.materials, body.parameters);
    take(mesher);
    body.labels = mesher.region;
    body.status = {mesher.spacing, mesher.unresolved.empty(), {}};
    for (Material_report& material : body.materials)
      material.has_topology = !std::binary_search(mesher.unresolved.begin(), mesher.unresolved.end(), material.label);
    return;
  }
  const Hex_mesher mesher(turned, body.parameters);
  if (!mesher.has_topology_of_surface)
    throw Input_error(Input_error::Element::MESH, 0, mesher.unresolved(axes));
  take(mesher);
  body.status = {mesher.spacing, mesher.has_topology_of_surface, {}};
  for (std::size_t t : mesher.thin_triangles)
    body.status.thin_faces.push_back(body.face_of[t]);
}

// Of all parts, each with its label.
inline Meshed_solid mesh_parts(const Reference_input& surface, const Meshing_parameters& parameters,
                               const std::vector<int>& parts)
{
  Region_surfaces regions(surface, parts, double(parameters.number_of_hexahedra), parameters.spacing);
  Meshed_body meshed;
  meshed.parameters = parameters;
  meshed.surface = std::move(regions.surface);
  meshed.face_of = std::move(regions.face_of);
  meshed.materials = std::move(regions.materials);
  mesh_body(meshed);
  Meshed_solid result;
  result.bodies.push_back(std::move(meshed));
  result.report = std::move(regions.report);
  return result;
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Meshed_solid mesh_solid(const Reference_input& surface, const Meshing_parameters& parameters,
                        const std::vector<int>& parts)
{
  const double diagonal = bounding_box(surface.points, surface.triangles).diagonal().norm();
  if (!parts.empty()) {
    Meshed_solid result = mesh_parts(surface, parameters, parts);
    result.diagonal = diagonal;
    return result;
  }
  Solid_of_surface solid(surface, double(parameters.number_of_hexahedra), parameters.spacing);
  const double h = spacing_for(solid.report.volume, solid.report.area, double(parameters.number_of_hexahedra));
  Meshed_solid result;
  for (Solid_of_surface::Body& body : solid.bodies) {
    Meshed_body meshed;
    meshed.parameters = parameters;
    if (solid.bodies.size() > 1) {
      const double share = number_for(body.volume, surface_area(body.surface.points, body.surface.triangles), h);
      meshed.parameters.number_of_hexahedra = (std::max)(std::size_t(1), static_cast<std::size_t>(share));
    }
    meshed.surface = std::move(body.surface);
    meshed.face_of = std::move(body.face_of);
    mesh_body(meshed);
    result.bodies.push_back(std::move(meshed));
  }
  result.report = solid.report;
  result.diagonal = diagonal;
  return result;
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
std::vector<int> closed_parts(const Reference_input& surface)
{
  return surface_components(surface.points, surface.triangles);
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Meshed_surface voxelize_surface(const Reference_input& surface, double spacing, std::size_t minimum_cells_across)
{
  require_volume(surface);
  const Triangle_surface solid(surface.points, surface.triangles);
  const std::vector<Wall_distance> walls = wall_distances(surface.points, surface.triangles, spacing);
  const Voxel_grid grid = solid_voxels(solid, walls, even_grid(solid, spacing));
  require_cells_inside(grid, spacing);
  Hexahedra mesh = voxel_hexahedra(grid);
  return {std::move(mesh.points),
          std::move(mesh.hexahedra),
          {grid.mean_spacing(), euler_characteristic(grid) == euler_characteristic(surface.triangles),
           thin_triangles(walls, grid, minimum_cells_across)}};
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
std::optional<Meshed_body> mesh_again(const Meshed_body& body, double factor)
{
  Meshed_body result;
  result.parameters = body.parameters;
  result.parameters.number_of_hexahedra = static_cast<std::size_t>(factor *
                                                                   double(body.parameters.number_of_hexahedra));
  result.surface = body.surface;
  result.face_of = body.face_of;
  result.materials = body.materials;
  try {
    mesh_body(result);
  }
  catch (const Input_error&) { // its cells do not resolve the surface, though others do
    return std::nullopt;
  }
  return result;
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Surface_repair repair_triangles(Reference_input& surface)
{
  Soup_repair repaired(surface);
  surface = std::move(repaired.surface);
  return std::move(repaired.report);
}

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Padded_mesh pad_mesh(const Positions& points, const std::vector<Hexahedron>& hexahedra, const std::vector<int>& labels,
                     double thickness)
{
  Hexahedra mesh;
  mesh.points = points;
  mesh.hexahedra = hexahedra;
  mesh.label.assign(6 * mesh.hexahedra.size(), Hexahedra::no_label);
  check_hexahedra(mesh);
  const std::vector<std::ptrdiff_t> opposite = opposite_sides(mesh);
  std::vector<char> is_marked(opposite.size(), false);
  std::vector<std::size_t> source;
  for (std::size_t side = 0; side < opposite.size(); ++side) {
    is_marked[side] = opposite[side] < 0 || (!labels.empty() && labels[side / 6] != labels[opposite[side] / 6]);
    if (is_marked[side])
      source.push_back(side / 6);
  }
  insert_layers(mesh, opposite, is_marked, thickness);
  return {std::move(mesh.points), std::move(mesh.hexahedra), std::move(source)};
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_IMPL_H
