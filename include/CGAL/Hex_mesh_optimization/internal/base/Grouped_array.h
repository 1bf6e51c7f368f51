// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_GROUPED_ARRAY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_GROUPED_ARRAY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Lists of integers of different lengths, one a group, in one contiguous array
// (compressed row storage).

#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Grouped_array
{
public:
  struct Group
  {
    const int* first;
    const int* last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
    std::size_t size() const { return last - first; }
    int operator[](std::size_t i) const { return first[i]; }
  };

  Grouped_array() : offsets_(1, 0) {}

  // Sorts the items 0 … number_of_items-1 into groups by counting; within a
  // group they keep their order. O(groups + items).
  template <class GroupOf, class ValueOf>
  Grouped_array(std::size_t number_of_groups, std::size_t number_of_items, GroupOf group_of, ValueOf value_of)
    : offsets_(number_of_groups + 1, 0)
    , values_(number_of_items)
  {
    for (std::size_t i = 0; i < number_of_items; ++i)
      ++offsets_[group_of(i) + 1];
    for (std::size_t g = 0; g < number_of_groups; ++g)
      offsets_[g + 1] += offsets_[g];
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t i = 0; i < number_of_items; ++i)
      values_[next[group_of(i)]++] = value_of(i);
  }

  std::size_t size() const { return offsets_.size() - 1; }

  Group operator[](std::size_t group) const
  {
    return {values_.data() + offsets_[group], values_.data() + offsets_[group + 1]};
  }

private:
  std::vector<std::size_t> offsets_;
  std::vector<int> values_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_GROUPED_ARRAY_H
