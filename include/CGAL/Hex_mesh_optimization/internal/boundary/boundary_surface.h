// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The boundary of a mesh as a triangle surface, and its sharp edges.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

inline Vector_3 face_area_vector(const Hexahedral_complex& complex, const Positions& points, int face)
{
  const std::array<int, 4>& q = complex.boundary_faces[face].vertices;
  return (points[q[2]] - points[q[0]]).cross(points[q[3]] - points[q[1]]);
}

// The edges of the boundary whose two faces deviate from flat by more than the bound, and those where it is no manifold.
inline Edge_list sharp_boundary_edges(const Hexahedral_complex& complex, const Positions& points, double angle_bound)
{
  const double bound = std::cos(angle_bound * CGAL_PI / 180);
  Edge_list sharp;
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
    if (e.right < 0) {
      if (complex.is_open_edge.empty() || !complex.is_open_edge[e.edge])
        sharp.push_back(complex.edges[e.edge]);
      continue;
    }
    const Vector_3 left = face_area_vector(complex, points, e.left), right = face_area_vector(complex, points, e.right);
    if (left.dot(right) < bound * left.norm() * right.norm())
      sharp.push_back(complex.edges[e.edge]);
  }
  return sharp;
}

inline double bounding_box_diagonal(const Triangle_surface& surface)
{
  Eigen::AlignedBox3d box;
  for (const Triangle_indices& t : surface.triangles)
    for (int v : t)
      box.extend(surface.points[v]);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

// Quads of the mesh in triangles: 2f and 2f + 1 for face f. Its vertices keep the indices of the mesh; a quad is split
// from its first corner, which in the order of hexahedron_faces is the split that most readers of boundary quads apply.
inline std::vector<Triangle_indices> split_quads(const std::vector<std::array<int, 4>>& quads)
{
  std::vector<Triangle_indices> triangles;
  triangles.reserve(2 * quads.size());
  for (const std::array<int, 4>& q : quads) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  return triangles;
}

inline std::vector<Triangle_indices> boundary_triangles(const Hexahedral_complex& complex)
{
  std::vector<std::array<int, 4>> quads;
  for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
    quads.push_back(f.vertices);
  return split_quads(quads);
}

// The sheets of the triangles that the faces are split into; none: all are in one.
inline std::vector<int> triangle_sheets(const Surface_faces& faces)
{
  std::vector<int> sheets;
  for (int s : faces.sheets)
    sheets.insert(sheets.end(), {s, s});
  return sheets;
}

// The sides of the triangles that the faces are split into where those have rims, as Rims takes them.
inline std::vector<std::size_t> rim_sides(const Surface_faces& faces)
{
  constexpr std::array<int, 4> in_both{{0, 1, 4, 5}}; // triangles
  std::vector<std::size_t> sides;
  for (std::size_t f = 0; f < faces.rims.size(); ++f)
    for (int k = 0; k < 4; ++k)
      if (faces.rims[f][k])
        sides.push_back(6 * f + in_both[k]);
  return sides;
}

// The rims of faces of the mesh: what of the reference is beyond, the mesh does not reach.
inline Rims triangle_rims(const Surface_faces& faces)
{
  return Rims(split_quads(faces.quads), triangle_sheets(faces), rim_sides(faces), Beyond_rim::ANYTHING);
}

// Faces with the vertices at these places.
inline Triangle_surface as_triangle_surface(const Surface_faces& faces, const Positions& points)
{
  return Triangle_surface(points, split_quads(faces.quads), triangle_sheets(faces), triangle_rims(faces));
}

// Vertices in which parts of the boundary touch that share no edge there.
inline std::vector<int> touching_vertices(const Hexahedral_complex& complex)
{
  std::vector<char> has_singular_edge(complex.number_of_vertices(), false);
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
    if (e.right < 0)
      for (int v : complex.edges[e.edge])
        has_singular_edge[v] = true;
  std::vector<int> result;
  for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    if (complex.is_singular[v] && !has_singular_edge[v])
      result.push_back(static_cast<int>(v));
  return result;
}

// The boundary of the mesh as a reference of its own. faces: of the complex
inline std::unique_ptr<Reference_surface> boundary_as_reference(const Hexahedral_complex& complex,
                                                                const Surface_faces& faces, const Positions& points,
                                                                const Feature_parameters& features)
{
  return std::make_unique<Reference_surface>(points, split_quads(faces.quads),
                                             sharp_boundary_edges(complex, points, features.angle_bound), false,
                                             features, triangle_sheets(faces), touching_vertices(complex));
}

// The same of a part of a mesh: it goes on beyond the rims. The edges of its features are known.
inline std::unique_ptr<Reference_surface>
boundary_of_part_as_reference(const Hexahedral_complex& complex, const Surface_faces& faces, const Positions& points,
                              const Edge_list& edges_of_features, const Feature_parameters& features)
{
  return std::make_unique<Reference_surface>(points, split_quads(faces.quads), edges_of_features, true, features,
                                             triangle_sheets(faces), touching_vertices(complex),
                                             Rims(split_quads(faces.quads), triangle_sheets(faces), rim_sides(faces),
                                                  Beyond_rim::PLANE));
}

inline std::unique_ptr<Reference_surface>
boundary_as_reference(const Hexahedral_complex& complex, const Positions& points, const Feature_parameters& features)
{
  return boundary_as_reference(complex, boundary_surface_faces(complex), points, features);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_SURFACE_H
