// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SOLID_THICKNESS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SOLID_THICKNESS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How thick the solid is behind the faces of its boundary: the way through the
// hexahedra, from each face to the opposite one, to the next surface.

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Solid_thickness
{
public:
  // lengths: of the edges. Both must outlive the object.
  Solid_thickness(const Hexahedral_complex& complex, const std::vector<double>& lengths)
    : complex_(complex)
    , lengths_(lengths)
    , beyond_(6 * complex.hexahedra.size(), surface)
  {
    for (const auto& sides : complex.interior_faces) {
      beyond_[side(sides[0])] = side(sides[1]);
      beyond_[side(sides[1])] = side(sides[0]);
    }
    for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
      if (f.beyond >= 0)
        beyond_[side_on(f.vertices, f.hexahedron)] = beyond_[side_on(f.vertices, f.beyond)] = surface;
  }

  // Behind a boundary face, on the thinner side of one that is between two regions; not measured any farther than most.
  // O(hexahedra on the way).
  double at(const Hexahedral_complex::Boundary_face& f, double most) const
  {
    const double thickness = behind(side_on(f.vertices, f.hexahedron), most);
    return f.beyond < 0 ? thickness : behind(side_on(f.vertices, f.beyond), thickness);
  }

private:
  static constexpr int surface = -1;
  static constexpr int opposite[6] = {1, 0, 4, 5, 2, 3};     // of the faces of a hexahedron
  static constexpr int first_across[6] = {8, 8, 4, 0, 4, 0}; // of the four edges from a face to the opposite one

  static int side(const std::pair<int, int>& s) { return 6 * s.first + s.second; }

  int side_on(const std::array<int, 4>& face, int hexahedron) const
  {
    const Hexahedron& h = complex_.hexahedra[hexahedron];
    for (int s = 0; s < 6; ++s)
      if (std::all_of(std::begin(hexahedron_faces[s]), std::end(hexahedron_faces[s]),
                      [&](int corner) { return std::find(face.begin(), face.end(), h[corner]) != face.end(); }))
        return 6 * hexahedron + s;
    return surface;
  }

  double behind(int side, double most) const
  {
    double thickness = 0;
    while (side != surface && thickness < most) {
      for (int k = 0; k < 4; ++k)
        thickness += lengths_[complex_.hexahedron_edges[side / 6][first_across[side % 6] + k] / 2] / 4;
      side = beyond_[side - side % 6 + opposite[side % 6]];
    }
    return (std::min)(thickness, most);
  }

  const Hexahedral_complex& complex_;
  const std::vector<double>& lengths_;
  std::vector<int> beyond_; // of each side, that of the hexahedron on the other side, or surface
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_SOLID_THICKNESS_H
