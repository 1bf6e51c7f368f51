// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The faces of the mesh that lie on a surface, with their edges and vertices: what
// is attached to a reference.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// A sheet is what one reference is searched for: the faces between the same two regions, or all that have nothing beyond.
struct Surface_faces
{
  struct Edge
  {
    int edge; // of the mesh
    int face; // one of those beside it
  };

  struct Vertex
  {
    int vertex;
    int face; // one of those around it
  };

  std::vector<std::array<int, 4>> quads;  // the boundary faces
  std::vector<int> sheets;                // of the quads, counted from 0; none: all are in one
  std::vector<std::array<int, 2>> labels; // of each sheet, on either side; nothing beyond: no_label
  // Of each quad, the sides (from each corner to the next) where an interface ends at another surface, as at the outer
  // boundary, and one of them goes elsewhere: it goes along. None: there are no such.
  std::vector<std::array<bool, 4>> rims;
  std::vector<Edge> edges;      // one for each sheet that an edge belongs to
  std::vector<Vertex> vertices; // one for each sheet that a vertex belongs to, in the order of the vertices

  static constexpr int no_label = (std::numeric_limits<int>::max)();

  int sheet(int face) const { return sheets.empty() ? 0 : sheets[face]; }

  // Whether a face is between two regions.
  bool is_interface(int face) const { return labels[sheet(face)][1] != no_label; }

  std::size_t size_of_sheet(int s) const
  {
    return sheets.empty() ? quads.size() : std::count(sheets.begin(), sheets.end(), s);
  }
};

// The sides of the quads in edges where sheets meet of which one goes elsewhere.
inline std::vector<std::array<bool, 4>> rims_of_interfaces(const Hexahedral_complex& complex,
                                                           const Surface_faces& faces,
                                                           const std::vector<char>& goes_elsewhere)
{
  const auto edge = [&](std::size_t f, int k) {
    return complex.find_edge(faces.quads[f][k], faces.quads[f][(k + 1) % 4]) / 2;
  };
  constexpr int none = -1, several = -2;
  std::vector<int> sheet(complex.edges.size(), none);
  std::vector<char> has_elsewhere(complex.edges.size(), false);
  for (std::size_t f = 0; f < faces.quads.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const int s = faces.sheet(static_cast<int>(f)), e = edge(f, k);
      sheet[e] = sheet[e] == none || sheet[e] == s ? s : several;
      has_elsewhere[e] = has_elsewhere[e] || goes_elsewhere[s];
    }
  std::vector<std::array<bool, 4>> rims(faces.quads.size());
  for (std::size_t f = 0; f < faces.quads.size(); ++f)
    for (int k = 0; k < 4; ++k)
      rims[f][k] = faces.is_interface(static_cast<int>(f)) && sheet[edge(f, k)] == several && has_elsewhere[edge(f, k)];
  return rims;
}

// The sides of the quads where a part ends, and the surface of the larger mesh goes on.
inline std::vector<std::array<bool, 4>> rims_of_part(const Hexahedral_complex& complex, const Surface_faces& faces)
{
  std::vector<std::array<int, 4>> sides; // edge, sheet, face, corner
  for (std::size_t f = 0; f < faces.quads.size(); ++f)
    for (int k = 0; k < 4; ++k) {
      const int edge = complex.find_edge(faces.quads[f][k], faces.quads[f][(k + 1) % 4]) / 2;
      if (complex.is_open_edge[edge])
        sides.push_back({edge, faces.sheet(static_cast<int>(f)), static_cast<int>(f), k});
    }
  std::sort(sides.begin(), sides.end());
  const auto are_together = [&](std::size_t i, std::size_t j) {
    return sides[i][0] == sides[j][0] && sides[i][1] == sides[j][1];
  };
  std::vector<std::array<bool, 4>> rims(faces.quads.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    if ((i == 0 || !are_together(i, i - 1)) && (i + 1 == sides.size() || !are_together(i, i + 1)))
      rims[sides[i][2]][sides[i][3]] = true;
  return rims;
}

// outside_is_one: all faces with nothing beyond are one sheet, the first, whichever regions they bound; it may go
// elsewhere, as may the interfaces between the moving pairs of labels.
inline Surface_faces boundary_surface_faces(const Hexahedral_complex& complex, bool outside_is_one = false,
                                            const std::vector<std::array<int, 2>>& moving = {})
{
  Surface_faces faces;
  std::vector<std::array<int, 2>> labels;
  for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces) {
    faces.quads.push_back(f.vertices);
    if (f.beyond >= 0)
      labels.push_back({complex.label(f.hexahedron), complex.label(f.beyond)});
    else if (outside_is_one)
      labels.push_back({(std::numeric_limits<int>::min)(), Surface_faces::no_label});
    else
      labels.push_back({complex.label(f.hexahedron), Surface_faces::no_label});
  }
  faces.labels = labels;
  std::sort(faces.labels.begin(), faces.labels.end());
  faces.labels.erase(std::unique(faces.labels.begin(), faces.labels.end()), faces.labels.end());
  if (faces.labels.size() > 1)
    for (const std::array<int, 2>& l : labels)
      faces.sheets.push_back(
        static_cast<int>(std::lower_bound(faces.labels.begin(), faces.labels.end(), l) - faces.labels.begin()));

  if (outside_is_one && faces.labels.size() > 1) {
    std::vector<char> goes_elsewhere;
    for (const std::array<int, 2>& l : faces.labels)
      goes_elsewhere.push_back(l[1] == Surface_faces::no_label ||
                               std::find(moving.begin(), moving.end(), l) != moving.end());
    faces.rims = rims_of_interfaces(complex, faces, goes_elsewhere);
  }
  else if (!complex.is_open_edge.empty())
    faces.rims = rims_of_part(complex, faces);

  std::vector<std::array<int, 3>> sides; // edge, sheet, face, without those that follow another one in both
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
    if (e.right >= 0)
      sides.push_back({e.edge, faces.sheet(e.left), e.left});
  if (sides.size() < complex.boundary_edges.size()) {
    for (std::size_t f = 0; f < faces.quads.size(); ++f)
      for (int k = 0; k < 4; ++k) {
        const int e = complex.find_edge(faces.quads[f][k], faces.quads[f][(k + 1) % 4]) / 2;
        if (complex.is_singular_edge[e])
          sides.push_back({e, faces.sheet(static_cast<int>(f)), static_cast<int>(f)});
      }
    std::sort(sides.begin(), sides.end());
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (i == 0 || sides[i][0] != sides[i - 1][0] || sides[i][1] != sides[i - 1][1])
      faces.edges.push_back({sides[i][0], sides[i][2]});

  std::vector<int> seen; // sheets around one vertex
  for (std::size_t v = 0; v < complex.number_of_vertices(); ++v) {
    seen.clear();
    for (int f : complex.vertex_boundary_faces[v])
      if (std::find(seen.begin(), seen.end(), faces.sheet(f)) == seen.end()) {
        seen.push_back(faces.sheet(f));
        faces.vertices.push_back({static_cast<int>(v), f});
      }
  }
  return faces;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SURFACE_FACES_H
