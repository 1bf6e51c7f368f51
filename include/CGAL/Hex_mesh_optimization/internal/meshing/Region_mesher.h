// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_MESHER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_MESHER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// From the surfaces around and between several regions to hexahedra with their labels, whose faces between labels
// stand for the interfaces: the connectivity, and positions to start from.

#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Hexahedra.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_layers.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Region_voxels.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Surface_partition.h>
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
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Region_mesher
{
public:
  // regions: with labels. materials: what is known of each, in increasing order of labels. Throws Input_error if no
  // cell is inside.
  Region_mesher(const Reference_input& regions, const std::vector<Material_report>& materials,
                const Meshing_parameters& parameters)
    : regions_(regions)
    , materials_(materials)
    , parameters_(parameters)
    , surface_(regions.points, regions.triangles)
    , box_(bounding_box(regions.points, regions.triangles))
    , pairs_(regions.labels)
  {
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    for (const std::array<int, 2>& pair : pairs_)
      for (int l : pair)
        if (l != Reference_input::no_label)
          labels_.push_back(l);
    std::sort(labels_.begin(), labels_.end());
    labels_.erase(std::unique(labels_.begin(), labels_.end()), labels_.end());
    double volume = 0;
    for (int l : labels_)
      volume += enclosed_volume(regions.points, triangles_around(regions, l));
    const double h = parameters.spacing > 0 ? parameters.spacing
                                            : spacing_for(volume, surface_area(regions.points, regions.triangles),
                                                          double(parameters.number_of_hexahedra));
    if (parameters.spacing > 0)
      make(h);
    else
      make_number(h);
  }

  Hexahedra mesh; // in the coordinates of the surface
  std::vector<int> region;
  double spacing = 0;          // mean of the three axes
  std::vector<int> unresolved; // labels of regions whose cells have another topology
  std::vector<std::size_t>
    thin_triangles; // with fewer cells of a region between them and its opposite wall than wanted

private:
  // Until there are about as many hexahedra as wanted.
  void make_number(double h)
  {
    meet_number(h, double(parameters_.number_of_hexahedra), parameters_, [&](double of_grid) {
      make(of_grid);
      return is_refined_ ? std::nullopt // there are as many as it takes
                         : std::optional<std::size_t>(mesh.hexahedra.size());
    });
  }

  Region_voxels voxels(double h) const
  {
    require_countable_cells(box_, h);
    return Region_voxels(regions_, labels_, surface_,
                         Voxel_grid(grid_planes(regions_.points, regions_.triangles, box_, h, parameters_.grid)),
                         parameters_.annealing);
  }

  std::vector<int> wrong_regions(const Region_voxels& voxels) const
  {
    std::vector<int> result;
    Voxel_grid grid = voxels.grid;
    for (const Material_report& material : materials_) {
      if (!std::binary_search(labels_.begin(), labels_.end(), material.label) || material.number_of_bodies == 0)
        continue;
      for (std::size_t cell = 0; cell < voxels.label.size(); ++cell)
        grid.is_inside[cell] = voxels.label[cell] == material.label;
      if (euler_characteristic(grid) != material.euler_characteristic)
        result.push_back(material.label);
    }
    return result;
  }

  std::vector<std::size_t> thin_triangles_of(const Region_voxels& voxels) const
  {
    const double density = .7; // in cells
    std::vector<std::size_t> result;
    Voxel_grid grid = voxels.grid;
    for (int l : labels_) {
      std::vector<std::size_t> triangle; // of the surface, of each around the region
      for (std::size_t t = 0; t < regions_.labels.size(); ++t)
        if (regions_.labels[t][0] == l || regions_.labels[t][1] == l)
          triangle.push_back(t);
      for (std::size_t cell = 0; cell < voxels.label.size(); ++cell)
        grid.is_inside[cell] = voxels.label[cell] == l;
      const std::vector<Wall_distance> walls = wall_distances(regions_.points, triangles_around(regions_, l),
                                                              density * spacing);
      for (std::size_t t : internal::thin_triangles(walls, grid, parameters_.minimum_cells_across))
        result.push_back(triangle[t]);
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Where regions have another topology, a finer grid may do: the first with the fewest of them. Changes the spacing.
  Region_voxels resolved(double& h)
  {
    Region_voxels best = voxels(h);
    std::size_t wrong = wrong_regions(best).size();
    const double first = h;
    for (double factor = .97; wrong > 0 && parameters_.spacing <= 0 && std::pow(factor, -2.5) < most_excess;
         factor *= .94) {
      Region_voxels other = voxels(factor * first);
      const std::size_t of_other = wrong_regions(other).size();
      if (of_other < wrong) {
        wrong = of_other;
        best = std::move(other);
        h = factor * first;
        is_refined_ = true;
      }
    }
    return best;
  }

  void make(double h)
  {
    const Region_voxels voxels = resolved(h);
    unresolved = wrong_regions(voxels);
    require_cells_inside(voxels.grid, h);
    spacing = voxels.grid.mean_spacing();
    thin_triangles = thin_triangles_of(voxels);
    mesh = voxel_hexahedra(voxels.grid);
    region.clear();
    for (std::size_t cell = 0; cell < voxels.label.size(); ++cell)
      if (voxels.grid.is_inside[cell])
        region.push_back(voxels.label[cell]);

    // in units of the spacing, to which what is said of features refers
    const auto scaled = [&](Positions points) {
      for (Vector_3& p : points)
        p = (p - box_.center()) / h;
      return points;
    };
    Positions points = scaled(regions_.points);
    mesh.points = scaled(std::move(mesh.points));
    const Surface_partition partition(points, regions_.triangles, sharp(points), regions_.sharp_is_given,
                                      parameters_.features, sheets());
    const Region_layers layers(mesh, region, partition, pairs_, parameters_.layers);
    const std::vector<std::vector<int>> patches = layers.patches_of_vertices();
    std::vector<int> vertices;
    for (std::size_t v = 0; v < patches.size(); ++v)
      if (!patches[v].empty())
        vertices.push_back(static_cast<int>(v));
    place_vertices(mesh, patches, vertices, partition, parameters_.smoothing_rounds);
    for (Vector_3& p : mesh.points)
      p = p * h + box_.center();
  }

  // Where the surface bends, and where more than two of its triangles meet.
  Edge_list sharp(const Positions& points) const
  {
    Edge_list result = sharp_edges(points, regions_.triangles,
                                   regions_.sharp_is_given ? 180 : parameters_.features.angle_bound);
    for (const std::array<int, 2>& e : regions_.sharp)
      result.push_back(Triangle_adjacency::ordered(e));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<int> sheets() const
  {
    std::vector<int> result;
    for (const std::array<int, 2>& pair : regions_.labels)
      result.push_back(static_cast<int>(std::lower_bound(pairs_.begin(), pairs_.end(), pair) - pairs_.begin()));
    return result;
  }

  static constexpr double most_excess = 3; // of hexahedra, for the topology

  const Reference_input& regions_;
  const std::vector<Material_report>& materials_;
  const Meshing_parameters parameters_;
  const Triangle_surface surface_;
  const Eigen::AlignedBox3d box_;
  std::vector<std::array<int, 2>> pairs_; // of labels that have a surface between them, sorted
  std::vector<int> labels_;               // sorted
  bool is_refined_ = false;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_MESHER_H
