// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ASSEMBLY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ASSEMBLY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Where the derivatives of each hexahedron go in the gradient and the matrix of
// all vertices.

#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Hexahedron_assembly
{
public:
  // For matrices with the couplings of this one, which must be those of the complex. The complex must outlive the
  // object.
  Hexahedron_assembly(const Hexahedral_complex& complex, const Block_matrix& matrix)
    : hexahedra_(complex.hexahedra)
    , slots_(complex.hexahedra.size())
  {
    for (std::size_t h = 0; h < hexahedra_.size(); ++h)
      for (int k = 0; k < Hexahedron_couplings::number; ++k)
        slots_[h][k] = matrix.slot(hexahedra_[h][hexahedron_couplings.first[k]],
                                   hexahedra_[h][hexahedron_couplings.second[k]]);
  }

  // Adds what one lane holds for a hexahedron.
  template <class Real>
  void add(std::size_t hexahedron, const Hexahedron_derivatives<Real>& derivatives, int lane_of_hexahedron,
           Positions& gradient, Block_matrix& matrix) const
  {
    const Hexahedron& h = hexahedra_[hexahedron];
    const auto entry = [lane_of_hexahedron](const Real& x) { return lane(x, lane_of_hexahedron); };
    for (int i = 0; i < 8; ++i) {
      for (int a = 0; a < 3; ++a)
        gradient[h[i]][a] += entry(derivatives.gradient[i][a]);
      Matrix_3& D = matrix.diagonal[h[i]];
      int n = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++n) {
          const auto value = entry(derivatives.diagonal[i][n]);
          D(a, b) += value;
          if (a != b)
            D(b, a) += value;
        }
    }
    for (int k = 0; k < Hexahedron_couplings::number; ++k) {
      const Real* block = derivatives.coupling[k];
      matrix.add(slots_[hexahedron][k], [&](int r, int c) { return entry(block[3 * r + c]); });
    }
  }

private:
  const std::vector<Hexahedron>& hexahedra_;
  std::vector<std::array<Block_matrix::Slot, Hexahedron_couplings::number>> slots_; // of each coupling
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_ASSEMBLY_H
