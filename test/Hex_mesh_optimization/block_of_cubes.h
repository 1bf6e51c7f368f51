// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_BLOCK_OF_CUBES_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_BLOCK_OF_CUBES_H

// Unit cubes on a lattice, small enough to count by hand.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include <vector>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

// Unit cubes on a lattice, vertex (i, j, k) at number i + (nx+1) (j + (ny+1) k).
struct Block
{
  int nx, ny, nz;
  Positions points;
  std::vector<Hexahedron> hexahedra;

  Block(int nx, int ny, int nz) : nx(nx), ny(ny), nz(nz)
  {
    for (int k = 0; k <= nz; ++k)
      for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
          points.emplace_back(i, j, k);
    for (int k = 0; k < nz; ++k)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          hexahedra.push_back({vertex(i, j, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k), vertex(i, j + 1, k),
                               vertex(i, j, k + 1), vertex(i + 1, j, k + 1), vertex(i + 1, j + 1, k + 1),
                               vertex(i, j + 1, k + 1)});
  }

  int vertex(int i, int j, int k) const { return i + (nx + 1) * (j + (ny + 1) * k); }

  Hexahedral_complex complex() const { return Hexahedral_complex(points.size(), hexahedra); }
};

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_BLOCK_OF_CUBES_H
