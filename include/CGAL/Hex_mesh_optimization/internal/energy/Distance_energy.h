// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_DISTANCE_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_DISTANCE_ENERGY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The energy of one sample in its distance from where it should be.

#include <algorithm>
#include <cmath>

namespace CGAL::Hex_mesh_optimization::internal {

//   φ(d) = w ε (√(1 + (d/ε)²) − 1) + v ψ(d/D),   ψ(x) = x⁶ up to x = 2, and its tangent beyond.
// Linear in the distance, it prefers few samples that are far to all of them a little; D bounds how far; the tangent
// keeps a sample whose target has jumped from outweighing everything else.
struct Distance_energy
{
  double linear_weight;   // w
  double linear_distance; // ε
  double steep_weight;    // v
  double steep_distance;  // D

  struct Derivatives
  {
    double slope;  // φ'(d) / d
    double growth; // of the slope, over d²: never negative
  };

  double value(double d) const
  {
    const double e = d / linear_distance, x = d / steep_distance, y = (std::min)(x, 2.0), y4 = y * y * y * y;
    return linear_weight * linear_distance * (std::sqrt(1 + e * e) - 1) + steep_weight * y4 * y * (6 * x - 5 * y);
  }

  Derivatives derivatives(double d) const
  {
    const double e = d / linear_distance, x = d / steep_distance, y = (std::min)(x, 2.0), y4 = y * y * y * y;
    const double D2 = steep_distance * steep_distance;
    return {linear_weight / (linear_distance * std::sqrt(1 + e * e)) +
              (x > 0 ? steep_weight * 6 * y4 * y / (x * D2) : 0),
            x < 2 ? steep_weight * 24 * x * x / (D2 * D2) : 0};
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_DISTANCE_ENERGY_H
