// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H
#define CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the functions that make a mesh from a surface report.

#include <CGAL/Hex_mesh_optimization/Status.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * What a surface bounds, and what had to be understood to find that: the union of its closed parts, which may overlap,
 * touch, be turned, or have copies.
 */
struct Surface_report
{
  double volume = 0;                       ///< That the surface bounds: of the union of its parts.
  double area = 0;                         ///< Of the boundary of that.
  std::size_t number_of_bodies = 0;        ///< Pieces of the volume that do not hang together.
  std::ptrdiff_t euler_characteristic = 0; ///< Of the boundary of the volume.

  std::size_t number_of_parts = 0;            ///< Closed parts of the surface.
  std::size_t number_of_reoriented_parts = 0; ///< Those that were oriented inwards, and were taken outwards.
  std::size_t number_of_copies = 0;           ///< Faces that are there again, and were taken once.
  std::size_t number_without_area = 0;        ///< Faces that are not there, as they have no area.
  std::size_t number_of_faces_within = 0;     ///< Pieces of faces within the volume, or with nothing on both sides.
  std::size_t number_of_stitched_vertices =
    0;                                        ///< Vertices that were merged with, or put on the edge of, what was near.
  std::size_t number_of_aligned_vertices = 0; ///< Put into the planes where parts touch but for rounding.
  double farthest_moved = 0;                  ///< The farthest that one of these moved, a length.
  std::size_t number_of_filled_holes = 0;     ///< Holes smaller than a cell, which were closed.
  double largest_filled_hole = 0;             ///< How large the largest of them is, a length.
  std::size_t number_of_small_components = 0; ///< Bodies and cavities of less than a thousandth of a cell: left out.
  double volume_of_small_components = 0;      ///< Their volume, that of cavities negative.

  /// `true` if nothing was left out, closed or moved.
  bool is_taken_as_given() const
  {
    return number_of_reoriented_parts == 0 && number_of_copies == 0 && number_without_area == 0 &&
           number_of_faces_within == 0 && number_of_stitched_vertices == 0 && number_of_aligned_vertices == 0 &&
           number_of_filled_holes == 0 && number_of_small_components == 0;
  }
};

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * One of the closed parts of a surface that stay apart, see `face_label_map()`: what it bounds where no part with a higher
 * label is, and what the mesh has of that.
 */
struct Material_report
{
  int label = 0;                           ///< Of the faces of the part, and of its hexahedra.
  double volume = 0;                       ///< That the part bounds outside of those with higher labels.
  double area = 0;                         ///< Of the boundary of that.
  std::size_t number_of_bodies = 0;        ///< Pieces of that which do not hang together.
  std::ptrdiff_t euler_characteristic = 0; ///< Of its boundary.

  double volume_after = 0;             ///< Of the hexahedra with the label.
  std::size_t number_of_hexahedra = 0; ///< With the label.
  /// `false` if the boundary of these has another Euler characteristic: holes are closed, or pieces are lost.
  bool has_topology = true;
};

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * The result of `CGAL::voxel_mesh()`.
 */
struct Voxel_status
{
  double spacing = 0; ///< The length of the cells, the geometric mean of the three axes.

  /// `false` if the boundary of the cells and the surface have different Euler characteristics: holes are closed, walls
  /// have holes, or components are lost.
  bool has_topology_of_surface = true;

  /// The faces of the surface, in increasing order, that have fewer cells between them and the opposite wall than
  /// `minimum_cells_across` asks for: there thin parts are coarser than wanted, or lost.
  std::vector<std::size_t> thin_faces;
};

/*!
 * \ingroup PkgHexMeshOptimizationMeshing
 * The result of `CGAL::make_hex_mesh()`: that of the optimization, where `Status::before` is the mesh that it started
 * from, and that of the grid.
 */
struct Meshing_status : Status, Voxel_status
{
  Surface_report surface; ///< What the surface bounds.

  std::size_t number_of_bodies = 0;           ///< Of the mesh: pieces that hang together by faces.
  std::ptrdiff_t euler_characteristic = 0;    ///< Of the boundary of the mesh.
  std::size_t number_of_hexahedra_wanted = 0; ///< 0 if a spacing was given instead.

  std::vector<int> labels;                ///< Of each hexahedron, if parts stay apart; else empty.
  std::vector<Material_report> materials; ///< Then, those parts, in increasing order of labels.

  /// How much more or less volume than the surface's the mesh may have for the size of its cells.
  double volume_tolerance() const { return .05 * (std::min)(spacing * surface.area, surface.volume); }

  /// The same for one part.
  double volume_tolerance(const Material_report& part) const
  {
    return .05 * (std::min)(spacing * part.area, (std::max)(part.volume, spacing * spacing * spacing));
  }

  /// `true` if the volume of each part is within `volume_tolerance()`.
  bool has_volumes_of_parts() const
  {
    return std::all_of(materials.begin(), materials.end(), [this](const Material_report& part) {
      return std::abs(part.volume_after - part.volume) <= volume_tolerance(part);
    });
  }

  /// `true` if the mesh has as many bodies as the surface bounds, the Euler characteristic of their boundary, their volume
  /// and those of parts that stay apart, within `volume_tolerance()`, and is nowhere farther from the surface than a cell is
  /// long.
  bool matches_surface() const
  {
    return number_of_bodies == surface.number_of_bodies && has_topology_of_surface &&
           euler_characteristic == surface.euler_characteristic &&
           std::abs(volume_after - surface.volume) <= volume_tolerance() && has_volumes_of_parts() &&
           deviation.maximum <= spacing;
  }
};

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_MESHING_STATUS_H
