// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_PARALLEL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_PARALLEL_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Loops that several threads share. What they compute does not depend on how many
// there are: work is cut into the same ranges, and sums are taken in their order.

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Calls work() so that the loops in it run in one thread, or else in those of the caller's task arena.
template <class Work>
void run_concurrently(bool is_parallel, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (is_parallel)
    work();
  else
    tbb::task_arena(1).execute(work);
#else
  (void)is_parallel;
  work();
#endif
}

// Calls work(i) for 0 … n-1, in any order: a task each.
template <class Work>
void for_each_index(std::size_t n, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_for(std::size_t(0), n, work);
#else
  for (std::size_t i = 0; i < n; ++i)
    work(i);
#endif
}

// Ranges of so many elements are worth a task, if each takes some tens of nanoseconds.
constexpr std::size_t default_grain = 2048;

// Calls work(begin, end) for ranges that together are 0 … n-1, in any order.
template <class Work>
void for_ranges(std::size_t n, const Work& work, std::size_t grain = default_grain)
{
  if (n <= grain)
    return work(std::size_t(0), n);
  for_each_index((n + grain - 1) / grain, [&](std::size_t i) { work(i * grain, (std::min)(n, (i + 1) * grain)); });
}

// Calls work(i) for 0 … n-1, in any order, where each takes some tens of nanoseconds.
template <class Work>
void for_each(std::size_t n, const Work& work, std::size_t grain = default_grain)
{
  for_ranges(
    n,
    [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        work(i);
    },
    grain);
}

// The results of work(begin, end) for ranges that together are 0 … n-1, in order.
template <class Value, class Work>
std::vector<Value> results_of_ranges(std::size_t n, const Work& work, std::size_t grain = default_grain)
{
  std::vector<Value> results((n + grain - 1) / grain);
  for_each_index(results.size(), [&](std::size_t i) { results[i] = work(i * grain, (std::min)(n, (i + 1) * grain)); });
  return results;
}

template <class Work>
double sum_of_ranges(std::size_t n, const Work& work, std::size_t grain = default_grain)
{
  double sum = 0;
  for (double value : results_of_ranges<double>(n, work, grain))
    sum += value;
  return sum;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BASE_PARALLEL_H
