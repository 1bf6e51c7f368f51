// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which part of the reference each boundary vertex belongs to: a corner, a
// feature curve or the smooth surface (the sets C, F, S of eq. 21).

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

enum class Vertex_kind : char { INTERIOR, SURFACE, FEATURE, CORNER, FIXED };

struct Boundary_attachment
{
  std::vector<Vertex_kind> kind;
  std::vector<int> curve;               // of a FEATURE vertex
  Positions corner;                     // the place of a CORNER vertex
  std::vector<Corner_rank> corner_rank; // of a CORNER vertex
  std::vector<int> curve_of_edge;       // the curve that an edge of the boundary represents, or -1
  std::vector<int> sheet;               // of the surface, that a SURFACE vertex belongs to; the first of several

  explicit Boundary_attachment(const Hexahedral_complex& complex)
    : kind(complex.number_of_vertices(), Vertex_kind::INTERIOR)
    , curve(complex.number_of_vertices(), -1)
    , corner(complex.number_of_vertices(), Vector_3::Zero())
    , corner_rank(complex.number_of_vertices(), Corner_rank::END)
    , curve_of_edge(complex.edges.size(), -1)
    , sheet(complex.number_of_vertices(), 0)
  {
    for (std::size_t v = 0; v < kind.size(); ++v)
      if (!complex.is_used[v])
        kind[v] = Vertex_kind::FIXED;
      else if (complex.is_on_boundary[v])
        kind[v] = Vertex_kind::SURFACE;
  }

  void set_sheets(const Surface_faces& faces)
  {
    for (auto v = faces.vertices.rbegin(); v != faces.vertices.rend(); ++v)
      sheet[v->vertex] = faces.sheet(v->face);
  }

  std::vector<char> fixed_vertices() const
  {
    std::vector<char> is_fixed(kind.size());
    for (std::size_t v = 0; v < kind.size(); ++v)
      is_fixed[v] = kind[v] == Vertex_kind::FIXED;
    return is_fixed;
  }

  // c: a corner of the reference.
  void to_corner(int v, const Reference_surface& reference, int c)
  {
    kind[v] = Vertex_kind::CORNER;
    corner[v] = reference.points[c];
    corner_rank[v] = reference.corner_rank(c);
  }

  // The vertices, one boundary edge apart, represent a curve; corners among them stay corners.
  void to_curve(const Hexahedral_complex& complex, const std::vector<int>& vertices, int c)
  {
    for (int v : vertices)
      if (kind[v] == Vertex_kind::SURFACE) {
        kind[v] = Vertex_kind::FEATURE;
        curve[v] = c;
      }
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      curve_of_edge[complex.find_edge(vertices[i], vertices[i + 1]) / 2] = c;
  }
};

// By identity: vertex v of the mesh is vertex `first` + v of the surface. Nothing is attached to features of what the
// surface has before.
inline void attach_by_identity(const Hexahedral_complex& complex, const Reference_surface& surface, int first,
                               Boundary_attachment& attachment)
{
  for (int v : surface.corners)
    if (v >= first)
      attachment.to_corner(v - first, surface, v);
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
    if (surface.curves[c]->vertices.front() >= first) {
      std::vector<int> vertices = surface.curves[c]->vertices;
      for (int& v : vertices)
        v -= first;
      attachment.to_curve(complex, vertices, static_cast<int>(c));
    }
}

// Attachment when the reference is the boundary itself.
inline Boundary_attachment attach_to_own_boundary(const Hexahedral_complex& complex, const Reference_surface& surface)
{
  Boundary_attachment attachment(complex);
  attach_by_identity(complex, surface, 0, attachment);
  return attachment;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H
