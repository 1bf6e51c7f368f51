// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_SUM_OF_ENERGIES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_SUM_OF_ENERGIES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Two energies as one.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>

namespace CGAL::Hex_mesh_optimization::internal {

// Both must outlive the sum.
template <class First, class Second>
class Sum_of_energies
{
public:
  Sum_of_energies(const First& first, const Second& second) : first_(first), second_(second) {}

  double value(const Positions& points) const { return first_.value(points) + second_.value(points); }

  double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    const double first = first_.add_derivatives(points, gradient, matrix);
    return first + second_.add_derivatives(points, gradient, matrix);
  }

private:
  const First& first_;
  const Second& second_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_SUM_OF_ENERGIES_H
