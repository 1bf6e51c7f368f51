// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the templates on the caller's types hand over to what makes meshes, which has no template parameters.

#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/Surface_repair.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/separate_compilation.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Meshed_surface
{
  Positions points;
  std::vector<Hexahedron> hexahedra;
  Voxel_status status;
};

// Of what a surface bounds, one body.
struct Meshed_body
{
  Positions points;
  std::vector<Hexahedron> hexahedra;
  Voxel_status status;
  Reference_input surface;                 // closed: that of the body alone
  std::vector<std::size_t> face_of;        // of each of its triangles, a face of the surface as given
  Meshing_parameters parameters;           // with the number that is the body's share
  std::vector<int> labels;                 // of the hexahedra; none: all are of one
  std::vector<Material_report> materials;  // then, what was asked for
  double area = 0;                         // of that
  std::ptrdiff_t euler_characteristic = 0; // of the boundary of the hexahedra
};

struct Meshed_solid
{
  std::vector<Meshed_body> bodies; // if its parts stay apart, one for those that hang together
  Surface_report report;
  double diagonal = 0; // of the box of the surface
};

struct Padded_mesh
{
  Positions points;
  std::vector<Hexahedron> hexahedra;
  std::vector<std::size_t> source; // of each hexahedron of the layer, the one that had its face
};

// Each throws Input_error: those with a surface unless it bounds a volume.

CGAL_HEX_MESH_OPTIMIZATION_INLINE
void require_volume(const Reference_input& surface);

// Voxels, layers, and positions to start the optimization from, of each body. Throws Input_error as well where the
// cells do not resolve the surface: the topology would not be its. parts: of each face a label, of those that stay
// apart; none: all are united.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
Meshed_solid mesh_solid(const Reference_input& surface, const Meshing_parameters& parameters,
                        const std::vector<int>& parts = {});

// Of each face of a surface, the number of the closed part that it belongs to, from 1.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
std::vector<int> closed_parts(const Reference_input& surface);

CGAL_HEX_MESH_OPTIMIZATION_INLINE
Meshed_surface voxelize_surface(const Reference_input& surface, double spacing, std::size_t minimum_cells_across);

// The same body once more, with so many times the hexahedra; none if that has not its topology.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
std::optional<Meshed_body> mesh_again(const Meshed_body& body, double factor);

// Changes the surface.
CGAL_HEX_MESH_OPTIMIZATION_INLINE
Surface_repair repair_triangles(Reference_input& surface);

// labels: of the hexahedra, or empty
CGAL_HEX_MESH_OPTIMIZATION_INLINE
Padded_mesh pad_mesh(const Positions& points, const std::vector<Hexahedron>& hexahedra, const std::vector<int>& labels,
                     double thickness);

} // namespace CGAL::Hex_mesh_optimization::internal

#ifndef CGAL_HEX_MESH_OPTIMIZATION_SEPARATE_ENGINE
#include <CGAL/Hex_mesh_optimization/internal/meshing/mesh_surface_impl.h>
#endif

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MESH_SURFACE_H
