// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H

// The best of the states of a mesh that a stage has met.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// The first of these that differs decides which of two states is better:
//   1. fewer inverted hexahedra,
//   2. fewer invalid ones,
//   3. lower demerits, if the stage gives any, the first of them first,
//   4. the later one, unless its minimum falls behind the highest of those states by more than is accepted.
// And a mesh that came in valid never gets a lower minimum.
class Best_state
{
public:
  using Demerits = std::array<double, 2>;

  // Accepted is a minimum down to part · highest − loss.
  Best_state(const Positions& points, const Mesh_quality& quality, double accepted_part, double accepted_loss,
             const Demerits& demerits = {})
    : points_(points)
    , inverted_(quality.inverted)
    , invalid_(quality.invalid)
    , demerits_(demerits)
    , minimum_(quality.minimum)
    , highest_minimum_(quality.minimum)
    , least_minimum_(quality.invalid == 0 ? quality.minimum : -1)
    , accepted_part_(accepted_part)
    , accepted_loss_(accepted_loss)
  {}

  void offer(const Positions& points, const Mesh_quality& quality, const Demerits& demerits = {})
  {
    const auto present = std::make_tuple(inverted_, invalid_, demerits_);
    const auto offered = std::make_tuple(quality.inverted, quality.invalid, demerits);
    if (present < offered || quality.minimum < least_minimum_)
      return;
    if (offered < present)
      highest_minimum_ = quality.minimum;
    else if (quality.minimum < accepted_part_ * highest_minimum_ - accepted_loss_)
      return;
    points_ = points;
    inverted_ = quality.inverted;
    invalid_ = quality.invalid;
    demerits_ = demerits;
    minimum_ = quality.minimum;
    highest_minimum_ = (std::max)(highest_minimum_, quality.minimum);
  }

  bool reaches(double target) const { return invalid_ == 0 && minimum_ >= target; }

  const Positions& points() const { return points_; }
  std::size_t inverted() const { return inverted_; }
  std::size_t invalid() const { return invalid_; }
  double minimum() const { return minimum_; }
  // Of the states that differ in the minimum only.
  double highest_minimum() const { return highest_minimum_; }
  // That a mesh that came in valid keeps, and -1 for one that did not.
  double least_minimum() const { return least_minimum_; }

private:
  Positions points_;
  std::size_t inverted_, invalid_;
  Demerits demerits_;
  double minimum_, highest_minimum_;
  const double least_minimum_, accepted_part_, accepted_loss_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_BEST_STATE_H
