// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_CONFLICT_FREE_RANGES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_CONFLICT_FREE_RANGES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Elements that add to what belongs to their vertices, in ranges of which those
// without a common vertex can be visited at once.

#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Conflict_free_ranges
{
public:
  // vertices_of(i) is a range of the vertices of element i. Ranges get the first color that none of those
  // with a common vertex has.
  template <class VerticesOf>
  Conflict_free_ranges(std::size_t number_of_elements, std::size_t number_of_vertices, std::size_t size_of_range,
                       const VerticesOf& vertices_of)
    : number_of_elements_(number_of_elements)
    , size_of_range_(size_of_range)
  {
    std::vector<std::uint64_t> taken(number_of_vertices, 0); // colors at each vertex
    for (std::size_t first = 0; first < number_of_elements; first += size_of_range) {
      const std::size_t last = (std::min)(first + size_of_range, number_of_elements);
      std::uint64_t conflicts = 0;
      for (std::size_t i = first; i < last; ++i)
        for (int v : vertices_of(i))
          conflicts |= taken[v];
      std::size_t color = 0;
      while (color < most_colors - 1 && (conflicts >> color & 1))
        ++color;
      if (colors_.size() <= color)
        colors_.resize(color + 1);
      colors_[color].push_back(first);
      color_of_range_.push_back(color);
      for (std::size_t i = first; i < last; ++i)
        for (int v : vertices_of(i))
          taken[v] |= std::uint64_t(1) << color;
    }
  }

  // Calls work(begin, end) for all ranges, never at once for two with a common vertex, and for those in the same order
  // whatever the number of threads.
  template <class Work>
  void for_ranges(const Work& work) const
  {
    for (std::size_t color = 0; color < colors_.size(); ++color)
      for_ranges_of(color, work, false);
  }

  // The same in the opposite order.
  template <class Work>
  void for_ranges_backwards(const Work& work) const
  {
    for (std::size_t color = colors_.size(); color-- > 0;)
      for_ranges_of(color, work, true);
  }

  // The color of the range of an element; lower ones come first.
  std::size_t color(std::size_t element) const { return color_of_range_[element / size_of_range_]; }
  std::size_t number_of_colors() const { return colors_.size(); }

private:
  template <class Work>
  void for_ranges_of(std::size_t color, const Work& work, bool backwards) const
  {
    const std::vector<std::size_t>& firsts = colors_[color];
    const auto visit = [&](std::size_t i) {
      work(firsts[i], (std::min)(firsts[i] + size_of_range_, number_of_elements_));
    };
    if (color < most_colors - 1)
      return for_each_index(firsts.size(), visit);
    for (std::size_t i = 0; i < firsts.size(); ++i)
      visit(backwards ? firsts.size() - 1 - i : i);
  }

  static constexpr std::size_t most_colors = 64; // the last one takes what is left, one after the other

  const std::size_t number_of_elements_, size_of_range_;
  std::vector<std::vector<std::size_t>> colors_; // first elements of the ranges
  std::vector<std::size_t> color_of_range_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_CONFLICT_FREE_RANGES_H
