// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_FLOOR_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_FLOOR_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What the corners of the hexahedra are penalized below: first a floor that rises
// ahead of the worst corner, then one that holds what was reached.

#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Numbers without another source were chosen together by a coordinate search on organic and CAD models of 2,500 to
// 38,000 hexahedra.
struct Floor_parameters
{
  // While it rises it stands this far above the worst corner, at most, no higher than the limit, and where this part of
  // the hexahedra is worse, they are left in peace.
  double step = .2;
  double limit = .95;
  double fraction = .04;

  // Held is this part of the minimum reached, but no more than the limit or, if that is higher, than the gap below
  // the fraction of the hexahedra: a higher minimum than that is not worth the deviation. The gap is no more
  // than a multiple of what those lack of 1: nearly perfect meshes stay so.
  double hold = .98;
  double hold_limit = .694;
  double hold_gap = .115;
  double relative_hold_gap = 1.5;
  // The penalty acts from this far above what is held.
  double margin = .04;
  // Part of what a corner lacks that its multiplier grows by in an iteration; all of it overshoots and oscillates.
  double lift_rate = .5;
  // Bound of the multipliers, against hexahedra that cannot be held at all.
  double largest_lift = 2;
  // What is left of the multipliers when the floor yields: else they go on growing, as what is held is not reached, and
  // outweigh what it yields to (an organic model bound to .06 % of its diagonal ends with a minimum of .48 without).
  double yielded_lift = .85;
};

class Quality_floor
{
public:
  // hexahedra must outlive the floor.
  Quality_floor(const Hexahedron_batches& hexahedra, const Floor_parameters& parameters)
    : parameters_(parameters)
    , hexahedra_(hexahedra)
    , lifts_(hexahedra.number_of_hexahedra())
    , floors_(hexahedra.number_of_hexahedra())
  {}

  // One floor for all corners, a step above the worst one and never falling. Where the connectivity makes many
  // hexahedra poor it stays where a given part of them lies: to lift all of those would cost the average.
  void rise(const Mesh_quality& quality)
  {
    highest_ = (std::max)(highest_, quality.minimum);
    floor_ = (std::max)(floor_, (std::min)({parameters_.limit, quality.quantile(parameters_.fraction),
                                            quality.minimum + parameters_.step}));
    hexahedra_.for_each(
      [this](std::size_t i) { std::fill_n(floors_.batch(i), 8, Lanes{} + static_cast<float>(floor_)); });
  }

  // A floor at what has to be kept, from where the rising one stood: its forces fade, where they are not needed, rather
  // than vanish. Corners that stay below have their own floors lifted until they do not: the multipliers
  // of an augmented Lagrangian, over the weight of the floor.
  void hold(const Mesh_quality& quality, const Positions& points)
  {
    highest_ = (std::max)(highest_, quality.minimum);
    held_ = parameters_.hold * yield_ * (std::min)(highest_, (std::max)(worth_, worth_holding(quality)));
    const float carried = static_cast<float>((std::max)(0.0, floor_ - held_ - parameters_.margin));
    const bool is_first = floor_ > 0;
    floor_ = 0;
    const float held = static_cast<float>(held_), rate = static_cast<float>(parameters_.lift_rate);
    const Lanes largest = Lanes{} + static_cast<float>(parameters_.largest_lift);
    hexahedra_.for_each([&](std::size_t i) {
      const Hexahedron_frame<Lanes> frame = hexahedra_.frame(i, points);
      Lanes *lifts = lifts_.batch(i), *floors = floors_.batch(i);
      for (int c = 0; c < 8; ++c) {
        if (is_first)
          lifts[c] = Lanes{} + carried;
        const Lanes lifted = larger(Lanes{}, lifts[c] + rate * (held - Corner_frame<Lanes>(frame, c).scaled_jacobian));
        lifts[c] = smaller(lifted, largest);
        floors[c] = lifts[c] + (held + static_cast<float>(parameters_.margin));
      }
    });
  }

  // The same floor for all corners, whatever they are.
  void stand_at(double floor)
  {
    hexahedra_.for_each([&](std::size_t i) { std::fill_n(floors_.batch(i), 8, Lanes{} + static_cast<float>(floor)); });
  }

  // From now on no less is worth holding than for a mesh of this quality, however many hexahedra get worse.
  void remember_worth(const Mesh_quality& quality) { worth_ = (std::max)(worth_, worth_holding(quality)); }
  // Forgets how high it has risen.
  void restart() { floor_ = highest_ = 0; }

  double held() const { return held_; }
  // What is held gives way to something that comes before quality, by a factor below 1.
  void yield(double factor)
  {
    yield_ *= factor;
    const float left = static_cast<float>(parameters_.yielded_lift);
    hexahedra_.for_each([&](std::size_t i) {
      Lanes* lifts = lifts_.batch(i);
      for (int c = 0; c < 8; ++c)
        lifts[c] = left * lifts[c];
    });
  }

  // What is held recovers from that, by a factor above 1.
  void recover(double factor) { yield_ = (std::min)(1.0, factor * yield_); }
  // A higher minimum than this is not worth the deviation that it takes.
  double worth_holding(const Mesh_quality& quality) const
  {
    const double q = quality.quantile(parameters_.fraction),
                 gap = (std::min)(parameters_.hold_gap, parameters_.relative_hold_gap * (1 - q));
    return (std::max)(parameters_.hold_limit, q - gap);
  }
  // Of each corner of the hexahedra.
  const Batched_values<8>& floors() const { return floors_; }

private:
  const Floor_parameters parameters_;
  const Hexahedron_batches& hexahedra_;
  double floor_ = 0, highest_ = 0, held_ = 0, worth_ = 0, yield_ = 1;
  Batched_values<8> lifts_, floors_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_FLOOR_H
