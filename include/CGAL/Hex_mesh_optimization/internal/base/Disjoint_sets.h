// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_DISJOINT_SETS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_DISJOINT_SETS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A partition of the numbers below a size into sets that grow together, each
// known by its least number.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t size) : parent_(size)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }

  std::size_t find(std::size_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    if (i != j)
      parent_[(std::max)(i, j)] = (std::min)(i, j);
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_DISJOINT_SETS_H
