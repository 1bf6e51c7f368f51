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

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
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
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
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

// What no optimization mends: a part that is thinner than a cell, and lost or in pieces. Throws Input_error with what would
// do for the thinnest.
inline void require_thick_parts(const Region_mesher& mesher, const Meshed_body& body)
{
  double volume = 0, thinnest = mesher.spacing;
  int label = Reference_input::no_label;
  for (const Material_report& material : body.materials) {
    volume += material.volume;
    const double thickness = material.area > 0 ? 2 * material.volume / material.area : 0;
    if (thickness < thinnest &&
        std::binary_search(mesher.unresolved.begin(), mesher.unresolved.end(), material.label)) {
      thinnest = thickness;
      label = material.label;
    }
  }
  if (label == Reference_input::no_label)
    return;
  const double enough = thinnest / 2;
  const double number = number_for(volume, surface_area(body.surface.points, body.surface.triangles), enough);
  throw Input_error(Input_error::Element::MESH, 0,
                    "part " + std::to_string(label) + " is about " + in_digits(thinnest) +
                      " thick where no part with a higher label is; cells about " + in_digits(mesher.spacing) +
                      " long lose it, or do not have its topology. A spacing of " + in_digits(enough) + ", or about " +
                      in_digits(number) + " hexahedra, would do");
}

// Sets the rest of a body with a surface and parameters.
inline void mesh_body(Meshed_body& body)
{
  const Matrix_3 axes = grid_axes(body.surface.points, body.surface.triangles, body.parameters.grid);
  Reference_input turned = body.surface;
  for (Vector_3& p : turned.points)
    p = axes.transpose() * p;
  const auto take = [&](const auto& mesher) {
    body.status = {mesher.spacing, true, {}};
    for (std::size_t t : mesher.thin_triangles)
      body.status.thin_faces.push_back(body.face_of[t]);
    body.points.clear();
    for (const Vector_3& p : mesher.mesh.points)
      body.points.push_back(axes * p);
    body.hexahedra = mesher.mesh.hexahedra;
    body.euler_characteristic = euler_characteristic(mesher.mesh);
    body.area = surface_area(body.surface.points, body.surface.triangles);
  };
  if (!body.surface.labels.empty()) {
    const Region_mesher mesher(turned, body.materials, body.parameters);
    require_thick_parts(mesher, body);
    take(mesher);
    body.labels = mesher.region;
    body.status.has_topology_of_surface = mesher.unresolved.empty();
    for (Material_report& material : body.materials)
      material.has_topology = !std::binary_search(mesher.unresolved.begin(), mesher.unresolved.end(), material.label);
    return;
  }
  const Hex_mesher mesher(turned, body.parameters);
  if (!mesher.has_topology_of_surface)
    throw Input_error(Input_error::Element::MESH, 0, mesher.unresolved(axes));
  take(mesher);
}

// Labels of parts that hang together by interfaces: what is only near has a grid of its own, and stays apart however
// narrow the gap is. Those without any volume are with the first.
inline std::vector<std::vector<int>> groups_of_parts(const Region_surfaces& regions)
{
  std::vector<int> labels;
  for (const Material_report& material : regions.materials)
    labels.push_back(material.label);
  const auto index = [&](int label) {
    return static_cast<std::size_t>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
  };
  Disjoint_sets sets(labels.size());
  std::vector<char> has_volume(labels.size(), false);
  for (const auto& [a, b] : regions.surface.labels) {
    for (int label : {a, b})
      if (label != Reference_input::no_label)
        has_volume[index(label)] = true;
    if (a != Reference_input::no_label && b != Reference_input::no_label)
      sets.unite(index(a), index(b));
  }
  std::map<std::size_t, std::vector<int>> of_root;
  std::vector<int> others;
  for (std::size_t i = 0; i < labels.size(); ++i)
    (has_volume[i] ? of_root[sets.find(i)] : others).push_back(labels[i]);
  std::vector<std::vector<int>> result;
  for (auto& entry : of_root)
    result.push_back(std::move(entry.second));
  if (result.empty())
    return {others};
  result[0].insert(result[0].end(), others.begin(), others.end());
  std::sort(result[0].begin(), result[0].end());
  return result;
}

// The regions of a group, with the surfaces around and between them.
inline Meshed_body body_of_parts(const Region_surfaces& regions, const std::vector<int>& group)
{
  const auto has = [&](int label) { return std::binary_search(group.begin(), group.end(), label); };
  Meshed_body result;
  result.surface.points = regions.surface.points;
  result.surface.sharp_is_given = regions.surface.sharp_is_given;
  std::vector<char> is_used(regions.surface.points.size(), false);
  for (std::size_t t = 0; t < regions.surface.triangles.size(); ++t) {
    const std::array<int, 2>& labels = regions.surface.labels[t];
    if (!has(labels[0]) && !has(labels[1]))
      continue;
    result.surface.triangles.push_back(regions.surface.triangles[t]);
    result.surface.labels.push_back(labels);
    result.face_of.push_back(regions.face_of[t]);
    for (int v : regions.surface.triangles[t])
      is_used[v] = true;
  }
  for (const std::array<int, 2>& e : regions.surface.sharp)
    if (is_used[e[0]] && is_used[e[1]])
      result.surface.sharp.push_back(e);
  for (const Material_report& material : regions.materials)
    if (has(material.label))
      result.materials.push_back(material);
  return result;
}

// Of all parts, each with its label.
inline Meshed_solid mesh_parts(const Reference_input& surface, const Meshing_parameters& parameters,
                               const std::vector<int>& parts)
{
  const Region_surfaces regions(surface, parts, double(parameters.number_of_hexahedra), parameters.spacing);
  const auto extent = [](const Meshed_body& body) {
    double volume = 0;
    for (const Material_report& material : body.materials)
      volume += material.volume;
    return std::make_pair(volume, surface_area(body.surface.points, body.surface.triangles));
  };
  Meshed_solid result;
  double volume = 0, area = 0;
  for (const std::vector<int>& group : groups_of_parts(regions)) {
    result.bodies.push_back(body_of_parts(regions, group));
    volume += extent(result.bodies.back()).first;
    area += extent(result.bodies.back()).second;
  }
  const double h = spacing_for(volume, area, double(parameters.number_of_hexahedra));
  for (Meshed_body& body : result.bodies) {
    body.parameters = parameters;
    if (result.bodies.size() > 1) {
      const double share = number_for(extent(body).first, extent(body).second, h);
      body.parameters.number_of_hexahedra = (std::max)(std::size_t(1), static_cast<std::size_t>(share));
    }
    mesh_body(body);
  }
  result.report = regions.report;
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
