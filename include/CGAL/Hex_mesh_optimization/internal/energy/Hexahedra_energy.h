// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRA_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRA_ENERGY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The energy of all hexahedra of a mesh without inverted corners.

#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Hexahedra_energy
{
public:
  // floors: what each corner is penalized below. assembly: for the matrix that the derivatives are added to. All but
  // the numbers must outlive the object.
  Hexahedra_energy(const Hexahedral_complex& complex, const Hexahedron_batches& hexahedra,
                   const Hexahedron_assembly& assembly, const Batched_values<8>& floors,
                   const std::vector<double>& target_lengths, const Hexahedron_energy_parameters& parameters)
    : complex_(complex)
    , hexahedra_(hexahedra)
    , assembly_(assembly)
    , floors_(floors)
    , inverse_targets_(complex.hexahedra.size())
    , certainties_(complex.hexahedra.size())
    , energy_(parameters)
  {
    set_target_lengths(target_lengths);
  }

  void set_parameters(const Hexahedron_energy_parameters& parameters) { energy_ = Hexahedron_energy(parameters); }

  // Of the edges of the mesh.
  void set_target_lengths(const std::vector<double>& lengths)
  {
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h)
      for (int k = 0; k < 12; ++k)
        inverse_targets_.set(h, k, 1 / lengths[complex_.hexahedron_edges[h][k] / 2]);
  }

  // c, of the target lengths of the hexahedron; 0 if not set.
  void set_certainty(std::size_t hexahedron, double certainty) { certainties_.set(hexahedron, 0, certainty); }

  double value(const Positions& points) const
  {
    return hexahedra_.sum([&](std::size_t i) {
      return sum_of_batch(i, energy_.value(hexahedra_.frame(i, points), inverse_targets_.batch(i), floors_.batch(i),
                                           *certainties_.batch(i)));
    });
  }

  double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    std::vector<double> values(hexahedra_.size()); // of the batches
    hexahedra_.for_each_without_conflict([&](std::size_t i) {
      Hexahedron_derivatives<Lanes> d;
      values[i] = sum_of_batch(i, energy_.derivatives(hexahedra_.frame(i, points), inverse_targets_.batch(i),
                                                      floors_.batch(i), d, *certainties_.batch(i)));
      hexahedra_.add(i, d, assembly_, gradient, matrix);
    });
    return hexahedra_.sum([&](std::size_t i) { return values[i]; });
  }

private:
  double sum_of_batch(std::size_t i, const Lanes& values) const
  {
    double sum = 0;
    for (int l = 0; l < hexahedra_.number_of_hexahedra(i); ++l)
      sum += lane(values, l);
    return sum;
  }

  const Hexahedral_complex& complex_;
  const Hexahedron_batches& hexahedra_;
  const Hexahedron_assembly& assembly_;
  const Batched_values<8>& floors_;
  Batched_values<12> inverse_targets_; // of the edges
  Batched_values<1> certainties_;
  Hexahedron_energy energy_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRA_ENERGY_H
