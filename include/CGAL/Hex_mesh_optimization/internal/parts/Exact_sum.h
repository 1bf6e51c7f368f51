// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_EXACT_SUM_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_EXACT_SUM_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A sum that does not depend on the order of what is added, nor on how that is divided among processes.

#include <CGAL/Hex_mesh_optimization/internal/parts/Ranks.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Values are rounded to multiples of 2⁻⁵⁰, and there may be 2³⁰ of them of up to 2¹² each, or fewer larger ones.
class Exact_sum
{
public:
  void add(double value)
  {
    const double of_high = std::floor(value * unit_of_high);
    high_ += static_cast<std::int64_t>(of_high);
    low_ += static_cast<std::int64_t>((value - of_high / unit_of_high) * unit_of_low);
  }

  double value() const { return double(high_) / unit_of_high + double(low_) / unit_of_low; }

  // Collective.
  static void sum(Ranks& ranks, const std::vector<Exact_sum*>& sums)
  {
    std::vector<std::int64_t> values;
    for (const Exact_sum* s : sums)
      values.insert(values.end(), {s->high_, s->low_});
    ranks.sum(values);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i]->high_ = values[2 * i];
      sums[i]->low_ = values[2 * i + 1];
    }
  }

private:
  static constexpr double unit_of_high = 1 << 20, unit_of_low = 1024. * 1024 * 1024 * 1024 * 1024;

  std::int64_t high_ = 0, low_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_PARTS_EXACT_SUM_H
