// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEX_MESHER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEX_MESHER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// From a closed surface to hexahedra whose boundary stands for it: the connectivity, and positions to start from.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_fans.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Boundary_labels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Patch_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Shell_sweep.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_annealing.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Voxel_grid.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Wall_distances.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/grid_planes.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/meet_number.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/place_vertices.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/solid_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/thin_walls.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/voxel_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Hex_mesher
{
public:
  // The surface is closed and oriented outwards, and no face intersects another. Throws Input_error if no cell is inside.
  Hex_mesher(const Reference_input& reference, const Meshing_parameters& parameters)
    : parameters_(parameters)
    , reference_(reference)
    , surface_(reference.points, reference.triangles)
    , box_(bounding_box(reference.points, reference.triangles))
  {
    const double h = parameters.spacing > 0 ? parameters.spacing
                                            : spacing_for(enclosed_volume(reference.points, reference.triangles),
                                                          surface_area(reference.points, reference.triangles), wanted_);
    measure_walls(h);
    is_shell_ = parameters.minimum_cells_across == 1 &&
                thin_part(walls_, parameters.shell_thickness * h) > parameters.least_shell_area;
    if (is_shell_) {
      make_shell(h);
      if (is_swept_)
        return;
      is_shell_ = false;
      is_refined_ = false;
      has_topology_of_surface = false;
      measure_walls(h);
    }
    if (parameters.spacing > 0)
      make_with(h);
    else
      make_number(thin_spacing(h));
  }

  Hexahedra mesh;                          // with labels, in the coordinates of the surface
  double spacing = 0;                      // mean of the three axes
  bool has_topology_of_surface = false;    // as far as the Euler characteristic tells
  std::vector<std::size_t> thin_triangles; // with fewer cells between them and the opposite wall than wanted

  // In words, where the cells are too large for the surface to keep its topology, and which would do. The columns of `axes` are
  // those of the coordinates of the surface in those of the caller.
  std::string unresolved(const Matrix_3& axes) const
  {
    const Voxel_grid grid = voxels(spacing);
    const std::vector<Wall_distance> gaps = gap_distances(density * spacing);
    const Wall_distance* thinnest = nullptr;
    bool is_wall = true;
    const auto propose = [&](const Wall_distance& p, bool wall) {
      if (p.distance > 0 && (!thinnest || p.distance < thinnest->distance)) {
        thinnest = &p;
        is_wall = wall;
      }
    };
    for (const Wall_distance& p : walls_)
      if (p.distance < 2 * spacing && cells_behind(p, grid).empty())
        propose(p, true);
    for (const Wall_distance& p : gaps)
      if (p.distance < 2 * spacing && is_gap_closed(p, grid))
        propose(p, false);
    const std::string text = "the mesh would not have the topology of the surface: cells about " + in_digits(spacing) +
                             " long close holes or gaps, or leave holes in walls.";
    if (!thinnest)
      return text + " A smaller spacing, or a larger number of hexahedra, may do";
    const double enough = thinnest->distance / 2;
    const double number = number_for(enclosed_volume(reference_.points, reference_.triangles),
                                     surface_area(reference_.points, reference_.triangles), enough);
    return text + " The thinnest " + (is_wall ? "wall" : "gap") + " that is lost is " + in_digits(thinnest->distance) +
           " wide, at " + in_words(axes * thinnest->place) + ": a spacing of " + in_digits(enough) + ", or about " +
           in_digits(number) + " hexahedra, would do";
  }

private:
  // One layer of cells on the half of the surface.
  void make_shell(double h)
  {
    if (parameters_.spacing <= 0)
      h = std::sqrt(larger_than_flat * surface_area(reference_.points, reference_.triangles) / 2 / wanted_);
    measure_walls(h / 4);
    if (parameters_.spacing > 0)
      make_with(h);
    else
      make_number(h);
  }

  void make_with(double h)
  {
    const Voxel_grid grid = voxels(h);
    describe(grid);
    if (has_topology_of_surface)
      make(grid, h);
  }

  // Until there are about as many hexahedra as wanted.
  void make_number(double h)
  {
    meet_number(h, wanted_, parameters_, [&](double spacing_of_grid) -> std::optional<std::size_t> {
      double resolving = spacing_of_grid;
      Voxel_grid grid = voxels(resolving);
      if (!resolve(grid, resolving)) {
        if (!has_topology_of_surface) // no grid before had it either
          describe(grid);
        return std::nullopt;
      }
      make(grid, resolving);
      if (is_refined_ || (is_shell_ && !is_swept_)) // for the topology: there are as many as it takes
        return std::nullopt;
      return mesh.hexahedra.size();
    });
  }

  // The spacing that thin parts need, or as much of it as they may have. What is wanted grows with it.
  double thin_spacing(double h)
  {
    const double thinnest = distance_of_thinnest(walls_, parameters_.tolerated_thin_area);
    const double needed = thinnest / double(parameters_.minimum_cells_across);
    if (needed >= h)
      return h;
    const double excess = (std::min)(std::pow(h / needed, 2.5), parameters_.most_excess);
    wanted_ *= excess;
    return h * std::pow(excess, -1 / 2.5);
  }

  // gaps: those that stay open, if cells as long can keep them.
  Voxel_grid voxels(double h, const std::vector<Wall_distance>& gaps = {}) const
  {
    require_countable_cells(box_, h);
    Voxel_grid grid = solid_voxels(surface_, walls_,
                                   Voxel_grid(
                                     grid_planes(reference_.points, reference_.triangles, box_, h, parameters_.grid)),
                                   is_shell_, gaps);
    Voxel_annealing(
      grid, [&](std::size_t cell) { return distance_from(surface_, grid.center(cell)); }, parameters_.annealing);
    return grid;
  }

  void measure_walls(double h) { walls_ = wall_distances(reference_.points, reference_.triangles, density * h); }

  // Through what is outside.
  std::vector<Wall_distance> gap_distances(double distance_of_places) const
  {
    std::vector<Triangle_indices> inside_out = reference_.triangles;
    for (Triangle_indices& t : inside_out)
      std::swap(t[1], t[2]);
    return wall_distances(reference_.points, inside_out, distance_of_places);
  }

  // Where holes are closed or walls have holes, a grid that is a little different may do, or a finer one. If none does, one of
  // them may in which gaps keep cells outside.
  // Tells whether there is one with the topology of the surface.
  bool resolve(Voxel_grid& grid, double& h)
  {
    const bool is_right = euler_characteristic(grid) == euler_characteristic(reference_.triangles);
    if (is_right && lost_part(walls_, grid) <= parameters_.tolerated_thin_area)
      return true;
    if (refine(grid, h, {}) || is_right)
      return true;
    const std::vector<Wall_distance> gaps = gap_distances(density * h);
    Voxel_grid other = voxels(h, gaps);
    if (euler_characteristic(other) == euler_characteristic(reference_.triangles)) {
      grid = std::move(other);
      return true;
    }
    return refine(grid, h, gaps);
  }

  // The first grid that loses next to no wall, or else the one that loses least of those with the right topology. Tells whether
  // there is any.
  bool refine(Voxel_grid& grid, double& h, const std::vector<Wall_distance>& gaps)
  {
    const std::ptrdiff_t wanted = euler_characteristic(reference_.triangles);
    const double tolerated = 1e-3; // part of the surface
    const double h_before = h;
    bool is_found = false;
    double least = std::numeric_limits<double>::infinity();
    for (double factor = .97; least > tolerated && std::pow(factor, -2.5) < parameters_.most_excess; factor *= .94) {
      Voxel_grid other = voxels(factor * h_before, gaps);
      if (euler_characteristic(other) != wanted)
        continue;
      const double lost = lost_part(walls_, other);
      if (lost < least) {
        least = lost;
        grid = std::move(other);
        h = factor * h_before;
        is_found = is_refined_ = true;
      }
    }
    return is_found;
  }

  void describe(const Voxel_grid& grid)
  {
    spacing = grid.mean_spacing();
    has_topology_of_surface = euler_characteristic(grid) == euler_characteristic(reference_.triangles);
    thin_triangles = internal::thin_triangles(walls_, grid, parameters_.minimum_cells_across);
  }

  void make(const Voxel_grid& grid, double h)
  {
    require_cells_inside(grid, h);
    describe(grid);
    mesh = voxel_hexahedra(grid);

    // in units of the spacing, to which what is said of features refers
    const auto scaled = [&](Positions points) {
      for (Vector_3& p : points)
        p = (p - box_.center()) / h;
      return points;
    };
    Positions points = scaled(reference_.points);
    mesh.points = scaled(std::move(mesh.points));
    Edge_list sharp = reference_.sharp_is_given
                        ? reference_.sharp
                        : sharp_edges(points, reference_.triangles, parameters_.features.angle_bound);
    const Surface_partition partition(points, reference_.triangles, std::move(sharp), reference_.sharp_is_given,
                                      parameters_.features);
    const Boundary_fans fans(mesh, opposite_sides(mesh));
    const Boundary_labels labels(mesh, fans, partition);
    for (std::size_t f = 0; f < fans.sides.size(); ++f)
      mesh.label[fans.sides[f]] = labels.labels[f];
    is_swept_ = is_shell_ && sweep_shell(partition);
    if (!is_swept_) {
      Patch_layers(mesh, partition, parameters_.layers);
      place_vertices(mesh, partition, parameters_.smoothing_rounds);
    }
    for (Vector_3& p : mesh.points)
      p = p * h + box_.center();
  }

  bool sweep_shell(const Surface_partition& partition)
  {
    Hexahedra placed = mesh;
    place_vertices(placed, partition, parameters_.smoothing_rounds);
    Shell_sweep sweep(placed, partition, walls_, spacing);
    if (sweep.result)
      mesh = std::move(*sweep.result);
    return sweep.result.has_value();
  }

  const Meshing_parameters parameters_;
  const Reference_input& reference_;
  const Triangle_surface surface_;
  const Eigen::AlignedBox3d box_;
  std::vector<Wall_distance> walls_;
  static constexpr double density = .7;           // of places on the surface, in cells
  static constexpr double larger_than_flat = 1.4; // a surface of steps than a surface
  bool is_shell_ = false;                         // most of it is a wall thinner than a cell
  bool is_swept_ = false;
  bool is_refined_ = false;
  double wanted_ = double(parameters_.number_of_hexahedra); // number of hexahedra
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_HEX_MESHER_H
