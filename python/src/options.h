// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIONS_H

// The named parameters that optimize() and make() share, from a dictionary of those that are given.

#include "Watcher.h"
#include "arrays.h"

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Chosen_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <functional>
#include <set>
#include <string>
#include <utility>

template <class T>
T option(const py::dict& options, const char* name, T default_value)
{
  return options.contains(name) ? options[name].cast<T>() : default_value;
}

// The place of the name among the names of an enumeration, in the order of its declaration.
template <class Enumeration>
Enumeration enumerator(const py::dict& options, const char* name, std::initializer_list<const char*> names,
                       Enumeration default_value)
{
  if (!options.contains(name))
    return default_value;
  const std::string given = options[name].cast<std::string>();
  int i = 0;
  for (const char* of_enumerator : names) {
    if (given == of_enumerator)
      return static_cast<Enumeration>(i);
    ++i;
  }
  throw py::value_error(std::string(name) + ": there is no " + given);
}

inline auto common_parameters(const py::dict& o, Watcher& watcher)
{
  const HMO::internal::Chosen_parameters defaults;
  const HMO::internal::Rectification_parameters& of_cones = defaults.rectification;
  return CGAL::parameters::features_angle_bound(option(o, "features_angle_bound", defaults.features.angle_bound))
    .boundary_placement(
      enumerator(o, "boundary_placement", {"WITHIN_TOLERANCE", "ON_SURFACE"}, defaults.boundary_placement))
    .fixed_boundary(option(o, "fixed_boundary", defaults.fixed_boundary))
    .optimization_method(
      enumerator(o, "optimization_method", {"FULL", "RECTIFICATION", "MAXIMIZATION"}, defaults.method))
    .target_quality(option(o, "target_quality", defaults.target_quality))
    .maximum_deviation(option(o, "maximum_deviation", defaults.maximum_deviation))
    .maximum_running_time(option(o, "maximum_running_time", defaults.maximum_running_time))
    .target_edge_lengths(enumerator(o, "target_edge_lengths", {"ESTIMATED", "INPUT"}, defaults.target_edge_lengths))
    .edge_length_update(enumerator(o, "edge_length_update", {"NONE", "SELECTIVE", "FULL"}, of_cones.length_update))
    .number_of_iterations(option(o, "number_of_iterations", of_cones.iterations))
    .number_of_restarts(option(o, "number_of_restarts", of_cones.restarts))
    .surface_weight(option(o, "surface_weight", of_cones.surface_weight))
    .feature_weight(option(o, "feature_weight", of_cones.feature_weight))
    .regularization_weight(option(o, "regularization_weight", of_cones.regularization_weight))
    .cone_angle_bound(option(o, "cone_angle_bound", of_cones.cone_angle_bound))
    .maximize_minimum_quality(option(o, "maximize_minimum_quality", of_cones.maximize_minimum_quality))
    .verbose(option(o, "verbose", false))
    .visitor(std::ref(watcher));
}

using Edge = std::pair<std::size_t, std::size_t>; // the lower vertex first

inline Edge edge_of(std::int64_t a, std::int64_t b)
{
  return {static_cast<std::size_t>((std::min)(a, b)), static_cast<std::size_t>((std::max)(a, b))};
}

// The feature edges of a triangle soup. Throws what Python gets as a ValueError if one is no edge of a triangle.
std::set<Edge> feature_edges(const Table& edges, const Table& triangles);

// What work() returns; its parallel algorithms have so many threads, or one where there is no TBB. Nothing of this is
// global, so that runs do not meet.
template <class Work>
auto in_threads(int number, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::task_arena(number).execute(work);
#else
  (void)number;
  return work();
#endif
}

// Calls work() without the lock of the interpreter, and throws what has ended it.
template <class Work>
void run(Watcher& watcher, int threads, const Work& work)
{
  try {
    const py::gil_scoped_release unlocked;
    in_threads(threads, work);
  }
  catch (const Watcher::Failure&) { // finish() throws the cause
  }
  watcher.finish();
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIONS_H
