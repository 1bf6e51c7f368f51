// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MERIT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MERIT_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The order of goals: what comes before quality when two states of a mesh are
// compared, by a stage, by the best state so far, and at the end.

#include <cstddef>
#include <tuple>

namespace CGAL::Hex_mesh_optimization::internal {

// Vertices that do not stand exactly where they are to stand.
struct Away
{
  std::size_t off_surface = 0; // and not only off its features
  std::size_t in_all = 0;
};

struct Merit
{
  std::size_t inverted, invalid; // hexahedra
  double excess;                 // of the boundary over what is tolerated, at its worst place; 0 within the tolerance
  Away away;

  bool is_good() const { return invalid == 0 && !(excess > 0) && away.in_all == 0; }
};

// Whether the first comes before the second: the fewest inverted hexahedra, the fewest invalid ones, the least excess,
// the fewest vertices away from corners, and from curves and faces where those are exact.
inline bool operator<(const Merit& a, const Merit& b)
{
  return std::tie(a.inverted, a.invalid, a.excess, a.away.off_surface, a.away.in_all) <
         std::tie(b.inverted, b.invalid, b.excess, b.away.off_surface, b.away.in_all);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MERIT_H
