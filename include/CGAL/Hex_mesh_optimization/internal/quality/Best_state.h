// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The best of the states of a mesh that a stage has met.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Hex_mesh_optimization::internal {

// Of the minimum of a mesh that came in good.
enum class Protection { OF_WHAT_IS_GOOD, NONE };

// The first of these that differs decides which of two states is better:
//   1. their merits,
//   2. how loosely the boundary is attached, where the stage varies that,
//   3. the later one, unless its minimum falls behind the highest of those states by more than is accepted.
// And a mesh that came in valid, with its boundary where it is to be, never gets a lower minimum, unless it is unprotected.
class Best_state
{
public:
  // Accepted is a minimum down to part · highest − loss. excess and away: as in Merit. looseness: the greater, the
  // looser.
  Best_state(const Positions& points, const Mesh_quality& quality, double accepted_part, double accepted_loss,
             double excess = 0, double looseness = 0, const Away& away = Away(),
             Protection protection = Protection::OF_WHAT_IS_GOOD)
    : points_(points)
    , merit_{quality.inverted, quality.invalid, excess, away}
    , looseness_(looseness)
    , minimum_(quality.minimum)
    , highest_minimum_(quality.minimum)
    , least_minimum_(protection == Protection::OF_WHAT_IS_GOOD && merit_.is_good() ? quality.minimum : -1)
    , accepted_part_(accepted_part)
    , accepted_loss_(accepted_loss)
  {}

  void offer(const Positions& points, const Mesh_quality& quality, double excess = 0, double looseness = 0,
             const Away& away = Away())
  {
    const Merit merit{quality.inverted, quality.invalid, excess, away};
    const bool is_worse = merit_ < merit || (!(merit < merit_) && looseness > looseness_);
    if (is_worse || quality.minimum < least_minimum_)
      return;
    if (merit < merit_ || looseness < looseness_)
      highest_minimum_ = quality.minimum;
    else if (quality.minimum < accepted_part_ * highest_minimum_ - accepted_loss_)
      return;
    points_ = points;
    merit_ = merit;
    looseness_ = looseness;
    minimum_ = quality.minimum;
    highest_minimum_ = (std::max)(highest_minimum_, quality.minimum);
  }

  // The excess of the state that is the best turns out to be this, and that of other states to be incomparable: any that
  // is not worse than it follows.
  void reassess(double excess)
  {
    merit_.excess = excess;
    highest_minimum_ = minimum_;
  }

  bool reaches(double target) const { return merit_.is_good() && minimum_ >= target; }

  const Positions& points() const { return points_; }
  std::size_t inverted() const { return merit_.inverted; }
  std::size_t invalid() const { return merit_.invalid; }
  double excess() const { return merit_.excess; }
  double minimum() const { return minimum_; }
  // Of the states that differ in the minimum only.
  double highest_minimum() const { return highest_minimum_; }
  // That a mesh that came in good keeps, and -1 for one that did not, or is unprotected.
  double least_minimum() const { return least_minimum_; }
  bool is_protected() const { return least_minimum_ >= 0; }

private:
  Positions points_;
  Merit merit_;
  double looseness_, minimum_, highest_minimum_;
  const double least_minimum_, accepted_part_, accepted_loss_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H
