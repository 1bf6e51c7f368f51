// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CONNECTIVITY_LIMITS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CONNECTIVITY_LIMITS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Upper bounds of the scaled Jacobian that follow from connectivity alone: from
// how many hexahedra or faces share the angle around an edge or a vertex.

#include <CGAL/number_type_config.h>
#include <CGAL/Hex_mesh_optimization/Connectivity_limit.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The determinant d of the unit edges of a corner is sin α · sin β · sin γ, with α and β the angles that one edge makes
// with the other two and γ the dihedral angle at it. So d is at most the sine of each plane and each dihedral
// angle, and an angle of a corner with d > 0 is less than 180°.
//
// Where n such angles sum up to half_turns · 180°, the least of their sines is at most the mean of the sines, which is
// at most the sine of the mean angle, as the sine is concave. With n ≤ half_turns, some angle is 180° or more.
inline double largest_sine(int half_turns, int n) { return n <= half_turns ? 0 : std::sin(CGAL_PI * half_turns / n); }

// The largest determinant of three unit vectors that span a solid angle. While two of them and the solid angle are
// kept, the third one moves on a circle that is symmetric to both (Lexell), and the determinant grows with its height
// above their plane: the highest place is symmetric to both. So the best corner is symmetric in all three. With c the
// cosine between its edges, d² = (1 - c)² (1 + 2c), and its three dihedral angles a, with cos a = c / (1 + c), sum up
// to the solid angle plus 180°.
inline double largest_determinant(double solid_angle)
{
  if (solid_angle >= 2 * CGAL_PI)
    return 0;
  const double cos_a = std::cos((solid_angle + CGAL_PI) / 3), c = cos_a / (1 - cos_a);
  return (1 - c) * std::sqrt((std::max)(0.0, 1 + 2 * c));
}

class Connectivity_limit_search
{
public:
  Connectivity_limit_search(const Hexahedral_complex& complex, const Boundary_attachment& attachment)
    : complex_(complex)
    , attachment_(attachment)
    , limits_(complex.hexahedra.size(), Limit(1.0, Connectivity_limit_reason()))
  {
    limit_at_edges();
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      switch (attachment.kind[v]) {
      case Vertex_kind::INTERIOR:
        limit_at_interior_vertex(v);
        break;
      case Vertex_kind::SURFACE:
        limit_at_smooth_vertex(v);
        break;
      case Vertex_kind::FEATURE:
        limit_at_curve_vertex(static_cast<int>(v));
        break;
      case Vertex_kind::CORNER:
      case Vertex_kind::FIXED:
        break;
      }
  }

  std::vector<Connectivity_limit> limits() const
  {
    std::vector<Connectivity_limit> result;
    for (std::size_t h = 0; h < limits_.size(); ++h)
      if (limits_[h].first < 1)
        result.push_back({h, limits_[h].second, limits_[h].first});
    return result;
  }

private:
  using Limit = std::pair<double, Connectivity_limit_reason>;

  void limit(int hexahedron, Connectivity_limit_reason reason, double bound)
  {
    limits_[hexahedron] = (std::min)(limits_[hexahedron], Limit(bound, reason));
  }

  void limit_beside(int face, Connectivity_limit_reason reason, double bound)
  {
    for (int h : {complex_.boundary_faces[face].hexahedron, complex_.boundary_faces[face].beyond})
      if (h >= 0)
        limit(h, reason, bound);
  }

  // Around an interior edge the dihedral angles sum up to 360°, at either end. On a boundary edge that is not
  // on a curve, both boundary faces are tangent to the same plane at an end with a tangent plane, and
  // still so at an end on a curve, of which they are on the same side: 180°.
  void limit_at_edges()
  {
    std::vector<int> count(complex_.edges.size(), 0);
    for (const std::array<int, 12>& edges : complex_.hexahedron_edges)
      for (int directed : edges)
        ++count[directed / 2];
    // of an edge between regions that has hexahedra all around only this is known, of one where the boundary is no
    // manifold nothing
    std::vector<char> is_outside(complex_.edges.size(), false);
    for (const Hexahedral_complex::Boundary_face& f : complex_.boundary_faces)
      for (int k = 0; k < 4 && f.beyond < 0; ++k)
        is_outside[complex_.find_edge(f.vertices[k], f.vertices[(k + 1) % 4]) / 2] = true;
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h)
      for (int directed : complex_.hexahedron_edges[h]) {
        const int e = directed / 2, n = count[e];
        const Vertex_kind a = attachment_.kind[complex_.edges[e][0]], b = attachment_.kind[complex_.edges[e][1]];
        if (!is_outside[e]) {
          if (n != 4 && (a != Vertex_kind::FIXED || b != Vertex_kind::FIXED))
            limit(static_cast<int>(h), Connectivity_limit_reason::INTERIOR_EDGE, largest_sine(2, n));
        }
        else if (n != 2 && !complex_.is_singular_edge[e] && attachment_.curve_of_edge[e] < 0 &&
                 (is_on_smooth_patch(a) || is_on_smooth_patch(b)))
          limit(static_cast<int>(h),
                n == 1 ? Connectivity_limit_reason::FLAT_EDGE : Connectivity_limit_reason::SMOOTH_EDGE,
                largest_sine(1, n));
      }
  }

  // At corners there may be no tangent plane, as at the apex of a cone.
  static bool is_on_smooth_patch(Vertex_kind kind)
  {
    return kind == Vertex_kind::SURFACE || kind == Vertex_kind::FEATURE;
  }

  // The solid angles sum up to 4 pi. The largest determinant grows up to the right-angled corner, one of eight, and
  // falls beyond. So the least of more than eight solid angles, and the largest of fewer, allow no more than the mean
  // one.
  void limit_at_interior_vertex(std::size_t v)
  {
    const auto hexahedra = complex_.vertex_hexahedra[v];
    if (hexahedra.size() != 8)
      for (int h : hexahedra)
        limit(h, Connectivity_limit_reason::INTERIOR_VERTEX,
              largest_determinant(4 * CGAL_PI / double(hexahedra.size())));
  }

  // The angles of the faces in the tangent plane sum up to 360°. Hexahedra without a face in it are not concerned.
  void limit_at_smooth_vertex(std::size_t v)
  {
    const auto faces = complex_.vertex_boundary_faces[v];
    if (faces.size() != 4 && !complex_.is_singular[v])
      for (int f : faces)
        limit_beside(f, Connectivity_limit_reason::SMOOTH_VERTEX, largest_sine(2, static_cast<int>(faces.size())));
  }

  // A curve that passes the vertex makes an angle of 180° there: a corner with edges along both of its directions is
  // flat, and the angles of the faces on either side of the curve sum up to 180°.
  void limit_at_curve_vertex(int v)
  {
    if (complex_.is_singular[v])
      return;
    const auto faces = complex_.vertex_boundary_faces[v];
    const auto is_passing = [&](int edge) { return attachment_.curve_of_edge[edge] == attachment_.curve[v]; };
    const auto neighbor = [&](int f, int step) {
      const std::array<int, 4>& q = complex_.boundary_faces[f].vertices;
      return q[(std::find(q.begin(), q.end(), v) - q.begin() + step) % 4];
    };
    const auto starts_at_curve = [&](int f) { return is_passing(complex_.find_edge(v, neighbor(f, 1)) / 2); };
    if (std::count_if(faces.begin(), faces.end(), starts_at_curve) != 2)
      return; // the curve ends here, or is not represented

    for (int h : complex_.vertex_hexahedra[v]) {
      const Hexahedron& vertices = complex_.hexahedra[h];
      const std::size_t corner = std::find(vertices.begin(), vertices.end(), v) - vertices.begin();
      int passing = 0;
      for (int local : corner_edges[corner])
        passing += is_passing(complex_.hexahedron_edges[h][local / 2] / 2);
      if (passing == 2)
        limit(h, Connectivity_limit_reason::FLAT_CURVE, 0);
    }

    for (int start : faces) {
      if (!starts_at_curve(start))
        continue;
      std::vector<int> side{start};
      for (;;) {
        const int last = neighbor(side.back(), 3);
        const auto next = std::find_if(faces.begin(), faces.end(), [&](int f) { return neighbor(f, 1) == last; });
        if (starts_at_curve(*next))
          break;
        side.push_back(*next);
      }
      if (side.size() > 2)
        for (int f : side)
          limit_beside(f, Connectivity_limit_reason::CURVE_VERTEX, largest_sine(1, static_cast<int>(side.size())));
    }
  }

  const Hexahedral_complex& complex_;
  const Boundary_attachment& attachment_;
  std::vector<Limit> limits_; // of each hexahedron
};

// The limits below 1, in increasing order of the hexahedra and one for each at most. O(hexahedra).
inline std::vector<Connectivity_limit> connectivity_limits(const Hexahedral_complex& complex,
                                                           const Boundary_attachment& attachment)
{
  return Connectivity_limit_search(complex, attachment).limits();
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CONNECTIVITY_LIMITS_H
