// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEET_NUMBER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEET_NUMBER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The spacing of a grid that makes about as many hexahedra as wanted.

#include <CGAL/Hex_mesh_optimization/internal/meshing/Meshing_parameters.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Hex_mesh_optimization::internal {

// make(h): makes the mesh with that spacing and returns its number of hexahedra, or none if it is final whatever that
// is. The last one that is made is the nearest to the number that was found.
template <class Make>
void meet_number(double h, double wanted, const Meshing_parameters& parameters, const Make& make)
{
  double best = h, miss_of_best = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < parameters.most_attempts; ++attempt) {
    const std::optional<std::size_t> number = make(h);
    if (!number)
      return;
    const double ratio = double(*number) / wanted;
    if (std::abs(std::log(ratio)) < miss_of_best) {
      miss_of_best = std::abs(std::log(ratio));
      best = h;
    }
    if (std::abs(ratio - 1) <= parameters.number_tolerance)
      return;
    if (attempt + 1 == parameters.most_attempts && best != h)
      make(best);
    h *= std::pow(ratio, 1 / 2.7); // between that of surfaces and volumes
  }
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_MEET_NUMBER_H
