// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_PARAMETERS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_PARAMETERS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How a mesh is divided into parts. It includes nothing of the engine, so that a caller need not compile that.

#include <cstddef>
#include <string>

namespace CGAL::Hex_mesh_optimization::internal {

// The most rounds and sweeps end what does not end otherwise. The other numbers were tried with tangled balls of 32,000 and
// 256,000 hexahedra (make_ball(), scramble_interior()) in two and four parts, and not chosen by a search.
struct Parts_parameters
{
  int number_of_parts = 1;
  // Of hexahedra around what parts of the last round have held, or have left invalid, which those of the next one have.
  int layers = 4;
  // Below that a part is not worth a run of its own, in a round that has only some of the hexahedra.
  std::size_t least_size = 3000;
  // The most rounds that untangle, and as many that improve. What is held in one is free in the next, but where those of the
  // next meet: three rounds leave next to nothing. More are for the worst hexahedra, those that near the minimum, as long as
  // they gain that much in a round.
  int most_rounds = 8;
  double near_worst = .02;
  double least_gain = .005;
  // A round that raises neither the minimum nor the average by more is the last one.
  double least_raise = 1e-5;
  // Of the vertices of tangled hexahedra, before there are parts: the most sweeps, and how many in vain are the last ones.
  int most_sweeps = 30;
  int patience_of_sweeps = 3;
  std::string folder; // of temporary files, for what need not be in memory; empty: there are none
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_PARTS_PARAMETERS_H
