// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HEX_MESH_OPTIMIZATION_TEST_BOUNDARY_SURFACE_MESH_H
#define HEX_MESH_OPTIMIZATION_TEST_BOUNDARY_SURFACE_MESH_H

// The boundary of a mesh as a surface that a caller has.

#include "mesh_families.h"

#include <CGAL/Surface_mesh.h>

inline CGAL::Surface_mesh<Indexed_mesh::Point> surface_of(const Indexed_mesh& mesh)
{
  using Surface_mesh = CGAL::Surface_mesh<Indexed_mesh::Point>;
  using Vertex = Surface_mesh::Vertex_index;
  Surface_mesh surface;
  for_boundary(
    mesh, [&](const Indexed_mesh::Point& p) { return surface.add_vertex(p); },
    [&](Vertex a, Vertex b, Vertex c) { surface.add_face(a, b, c); });
  return surface;
}

#endif // HEX_MESH_OPTIMIZATION_TEST_BOUNDARY_SURFACE_MESH_H
