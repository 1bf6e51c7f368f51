// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H

// The faces of the mesh that lie on a surface, with their edges and vertices: what
// is attached to a reference.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Surface_faces
{
  struct Edge
  {
    int edge; // of the mesh
    int face; // one of those beside it
  };

  std::vector<std::array<int, 4>> quads;
  std::vector<Edge> edges;
  std::vector<int> face_of_vertex; // one of those around each vertex of the mesh, or -1
};

inline Surface_faces boundary_surface_faces(const Hexahedral_complex& complex)
{
  Surface_faces faces;
  faces.quads.reserve(complex.boundary_faces.size());
  for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
    faces.quads.push_back(f.vertices);
  faces.edges.reserve(complex.boundary_edges.size());
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
    faces.edges.push_back({e.edge, e.left});
  faces.face_of_vertex.assign(complex.number_of_vertices(), -1);
  for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    if (complex.is_on_boundary[v])
      faces.face_of_vertex[v] = complex.vertex_boundary_faces[v][0];
  return faces;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H
