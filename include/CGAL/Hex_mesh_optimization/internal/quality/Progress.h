// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_PROGRESS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_PROGRESS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// For how long a stage has gained nothing to speak of.

#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Of the minimum, which rises, and the average, which falls while a boundary settles.
class Progress
{
public:
  Progress(const Mesh_quality& quality, double gain_of_minimum, double change_of_average)
    : minimum_(quality.minimum)
    , average_(quality.average)
    , gain_of_minimum_(gain_of_minimum)
    , change_of_average_(change_of_average)
  {}

  void add(const Mesh_quality& quality)
  {
    ++since_minimum_;
    ++since_average_;
    // a corner that is nearly inverted climbs slowly at first
    if (quality.minimum > minimum_ + (std::min)(gain_of_minimum_, relative_gain * minimum_)) {
      minimum_ = quality.minimum;
      since_minimum_ = 0;
    }
    if (std::abs(quality.average - average_) > change_of_average_) {
      average_ = quality.average;
      since_average_ = 0;
    }
  }

  std::size_t iterations_without_gain_of_minimum() const { return since_minimum_; }
  std::size_t iterations_without_change_of_average() const { return since_average_; }
  std::size_t iterations_without_change() const { return (std::min)(since_minimum_, since_average_); }

private:
  // Of a corner that is nearly inverted.
  static constexpr double relative_gain = .1;

  double minimum_, average_, gain_of_minimum_, change_of_average_;
  std::size_t since_minimum_ = 0, since_average_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_PROGRESS_H
