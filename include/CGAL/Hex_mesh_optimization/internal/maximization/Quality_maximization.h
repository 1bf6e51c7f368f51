// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Newton's method on the energy of all hexahedra and of the attachment, from a
// mesh without inverted corners: the worst corners climb while the boundary is
// loosely attached, then the attachment tightens while they are held. What is to
// stand exactly on curves and faces comes to its place after that.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Arrivals.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_problem.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Progress.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Quality_maximization
{
public:
  // When vertices with exact placement are projected onto their curves and patches; the other phases follow, with these
  // vertices on them.
  enum class Projection {
    FIRST, // the boundary came from there: they are near
    LAST   // after the other phases have brought them near
  };

  // problem must outlive the object.
  Quality_maximization(Maximization_problem& problem, Projection projection)
    : problem_(problem)
    , projection_(projection)
    , parameters_(problem.parameters)
    , samples_(problem.samples)
    , sliding_(problem.sliding)
    , boundary_(problem.boundary)
    , floor_(problem.floor)
    , arrivals_(problem.complex, problem.targets.lengths, problem.sliding, parameters_.arrivals)
  {}

  // Improves points until nothing is gained any more or control ends the run; leaves in them the best state met, whose
  // minimum may be lower than what they came with: see Interior_point_maximization for what may not lose any. Does
  // nothing if a hexahedron is inverted. To be called once.
  Stage_end run(Positions& points, Run_control& control, double target_quality)
  {
    Mesh_quality quality(problem_.complex, points);
    if (quality.inverted > 0)
      return Stage_end::CONVERGED;
    samples_.restore_walls();
    samples_.update(points, 1);
    excess_ = samples_.excess(points);
    start_minimum_ = quality.minimum;
    target_quality_ = target_quality;
    if (is_target_reached(quality))
      return Stage_end::CONVERGED;
    Best_state best(points, quality, 1, parameters_.accepted_loss, excess_, 1, sliding_.away(points), Protection::NONE);
    sliding_.let_go(); // what stands exactly on curves and faces may leave them for a time
    is_to_arrive_ = sliding_.holds_more_than_corners();
    time_is_over_ = [&control] { return control.time_is_over(); };
    start_maximin(0, quality);
    if (is_to_arrive_ && projection_ == Projection::FIRST && arrivals_.call(points, quality.minimum, time_is_over_))
      phase_ = Phase::PROJECTION;
    for (std::size_t i = 0; !control.is_stopped(); ++i) {
      start_iteration(i, quality, points);
      const double energy = iterate(quality, points);
      excess_ = samples_.excess(points);
      if (is_tight())
        update_multipliers(best, points);
      if (!arrivals_.have_begun() || is_tight()) // what is on its way is no result
        best.offer(points, quality, excess_, looseness(quality), sliding_.away(points));
      add_to_progress(quality);
      control.after_iteration(Stage::MAXIMIZATION, i, energy, points, quality, excess_);
      if (is_tight() && !goes_on_after(i, best, quality, points))
        break;
    }
    points = best.points();
    if (arrivals_.have_begun() && !control.is_stopped())
      raise(points);
    return control.stage_end(used_up_);
  }

private:
  enum class Phase {
    MAXIMIN,      // the worst corners are raised, while the boundary may yield
    CONTINUATION, // the weight of the boundary grows, or is at its largest, and the worst corners are held
    PROJECTION    // what is to stand exactly on curves and faces comes to its place
  };

  bool is_tight() const { return phase_ == Phase::CONTINUATION && boundary_.tightness == 1; }

  bool is_outside() const { return (samples_.is_bounded() && excess_ > 0) || sliding_.are_some_away(); }

  bool is_target_reached(const Mesh_quality& quality) const
  {
    return quality.invalid == 0 && quality.minimum >= target_quality_ && !(excess_ > 0) && !sliding_.are_some_away() &&
           sliding_.vertices_away().empty();
  }

  void start_maximin(std::size_t i, const Mesh_quality& quality)
  {
    phase_ = Phase::MAXIMIN;
    boundary_.tightness = samples_.is_held() ? 1 : parameters_.start_tightness;
    begun_ = i;
    const bool is_careful = samples_.is_bounded() || is_to_arrive_;
    maximin_ = Progress(quality, parameters_.climbing_gain,
                        is_careful ? parameters_.careful_climbing_change_of_average
                                   : parameters_.climbing_change_of_average);
  }

  void restart_settling(const Mesh_quality& quality)
  {
    settling_ = Progress(quality, parameters_.least_gain_of_minimum, parameters_.least_change_of_average);
  }

  // Decides about the phase, and what the corners are held to in it.
  void start_iteration(std::size_t i, const Mesh_quality& quality, Positions& points)
  {
    if (phase_ == Phase::PROJECTION) {
      if (!arrivals_.go_on(points, time_is_over_))
        start_maximin(i, quality);
      floor_.restart();
    }
    else if (phase_ == Phase::MAXIMIN) {
      const bool is_done = is_maximin_done(quality);
      if (is_done || i == begun_ + parameters_.climbing_iterations)
        start_continuation(is_done, quality, points);
    }
    if (phase_ != Phase::CONTINUATION) {
      floor_.rise(quality);
      return;
    }
    // within a close bound, quality comes before the average deviation (measured on voxels of a ball, bound to .5 %
    // of the diagonal of their surface: minimum and average are .817 and .958 instead of .680 and .929)
    if (samples_.is_closely_bounded())
      floor_.remember_worth(quality);
    floor_.hold(quality, points);
    // it waits for corners that fell behind, but not for ever
    if (quality.minimum >= parameters_.ready * floor_.held() || ++waited_ > parameters_.waiting_patience) {
      boundary_.tightness = (std::min)(1.0, boundary_.tightness * parameters_.tightening);
      waited_ = 0;
    }
  }

  bool is_maximin_done(const Mesh_quality& quality) const
  {
    const std::size_t without_change = maximin_->iterations_without_change_of_average();
    const bool is_high = quality.minimum >= floor_.worth_holding(quality) &&
                         without_change >= parameters_.climbing_patience_for_average;
    const bool is_stalled = maximin_->iterations_without_gain_of_minimum() >= parameters_.climbing_patience &&
                            without_change >= parameters_.stalled_patience_for_average;
    return is_high || is_stalled;
  }

  void start_continuation(bool is_done, const Mesh_quality& quality, const Positions& points)
  {
    phase_ = Phase::CONTINUATION;
    used_up_ = !is_done;
    waited_ = settled_ = 0;
    if (!has_relaxed_) {
      bounded_shape_ = bounded_shape();
      shape_ = bounded_shape_ * problem_.balanced_shape(quality.average);
      weigh_shape();
      problem_.adapt_lengths(points);
    }
    has_relaxed_ = true;
    if (!is_to_arrive_)
      sliding_.call_all();
  }

  // One step, after those that are on their way to their places have gone on. Returns the energy.
  double iterate(Mesh_quality& quality, Positions& points)
  {
    const bool approaches = sliding_.are_some_away();
    if (approaches) {
      arrivals_.approach(quality.scaled_jacobians, least_scaled_jacobians(quality, 1), parameters_.least_part_of_corner,
                         points);
      quality = Mesh_quality(problem_.complex, points);
    }
    if (approaches || (samples_.is_bounded() && boundary_.tightness < 1)) // walls move with the tightness
      samples_.update(points, boundary_.tightness);
    const Positions start = arrivals_.have_begun() ? points : Positions();
    const std::size_t invalid = quality.invalid;
    const bool is_over_relaxed = phase_ == Phase::MAXIMIN && !samples_.is_bounded();
    // the worst give nothing to arrivals: they would be worn down
    const double energy = problem_.step(
      least_scaled_jacobians(quality, phase_ == Phase::PROJECTION ? 1 : parameters_.least_part_of_corner),
      arrivals_.have_begun() ? Last_resort::UNTIL_NONE_IS_RUINED : Last_resort::NONE,
      is_over_relaxed ? parameters_.climbing_relaxation : parameters_.newton.relaxation,
      [&](const Positions& reached, std::vector<char>& is_ruined) {
        if (arrivals_.have_begun())
          problem_.find_invalidated(start, reached, is_ruined);
      },
      points);
    quality = Mesh_quality(problem_.complex, points);
    if (arrivals_.have_begun() && quality.invalid > invalid) {
      problem_.take_back(
        start,
        [&](const Positions& reached, std::vector<char>& is_ruined) {
          problem_.find_invalidated(start, reached, is_ruined);
        },
        points);
      quality = Mesh_quality(problem_.complex, points);
    }
    samples_.update(points, boundary_.tightness);
    return energy;
  }

  // Of the bound and of what is held, once the boundary has its largest weight.
  void update_multipliers(Best_state& best, const Positions& points)
  {
    samples_.adapt_walls(points);
    if (!is_outside()) {
      if (std::isfinite(least_excess_) && !recovers_) {
        // what has yielded now recovers, once: else it could go back and forth for ever
        settled_ = 0;
        restart_settling(Mesh_quality(problem_.complex, points));
      }
      recovers_ = recovers_ || std::isfinite(least_excess_);
      least_excess_ = std::numeric_limits<double>::infinity();
      floor_.recover(parameters_.recovery);
    }
    else if (excess_ < parameters_.excess_part * least_excess_) {
      least_excess_ = excess_;
      stalled_ = 0;
    }
    else if (samples_.is_bounded() && !samples_.is_bounded_everywhere() &&
             shape_yield_ > parameters_.least_shape_yield) {
      shape_yield_ *= parameters_.shape_yielding;
      weigh_shape();
    }
    else if (++stalled_ >= parameters_.yielding_patience) {
      floor_.yield(parameters_.yielding);
      stalled_ = 0;
    }
    if (++unrefined_ >= parameters_.refinement_interval && refinements_ < parameters_.most_refinements) {
      unrefined_ = 0;
      ++refinements_;
      refine(points, best);
      excess_ = samples_.excess(points);
    }
  }

  void add_to_progress(const Mesh_quality& quality)
  {
    maximin_->add(quality);
    if (boundary_.tightness < 1 || !settling_)
      restart_settling(quality);
    else
      settling_->add(quality);
  }

  // Whether an iteration follows one with the largest weight of the boundary, from where it has led or from elsewhere.
  bool goes_on_after(std::size_t i, Best_state& best, Mesh_quality& quality, Positions& points)
  {
    settled_minimum_ = (std::max)(settled_minimum_, quality.minimum);
    const bool is_held = best.highest_minimum() >= parameters_.held_closely * floor_.held() &&
                         settled_minimum_ >= start_minimum_;
    const bool is_settled = !is_outside() && is_held && settling_->iterations_without_change() >= parameters_.patience;
    const bool is_over = ++settled_ >= settling_iterations();
    if (!is_over && !is_settled && !is_target_reached(quality))
      return true;
    if (refines_at_last(best, quality, points) || raises_once(i, best, quality, points))
      return true;
    // what was let go may come after all, once those around it have given way
    if (is_to_arrive_ && arrivals_.call(points, quality.minimum, time_is_over_)) {
      phase_ = Phase::PROJECTION;
      return true;
    }
    used_up_ = used_up_ || (is_over && !is_settled);
    return false;
  }

  // Goes on from the best state where that is beyond the bound between the samples.
  bool refines_at_last(Best_state& best, Mesh_quality& quality, Positions& points)
  {
    if (best.excess() > 0 || last_refinements_ >= parameters_.most_last_refinements)
      return false;
    ++last_refinements_;
    points = best.points();
    sliding_.notice(points);
    if (!refine(points, best))
      return false;
    quality = Mesh_quality(problem_.complex, points);
    settled_ = 0;
    restart_settling(quality);
    least_excess_ = std::numeric_limits<double>::infinity();
    recovers_ = false;
    return true;
  }

  // Newton's method goes on from where a search has led that gains enough, once.
  bool raises_once(std::size_t i, Best_state& best, Mesh_quality& quality, Positions& points)
  {
    if (!arrivals_.have_begun() || is_target_reached(quality) || std::exchange(has_raised_, true))
      return false;
    points = best.points();
    sliding_.notice(points);
    const double minimum = Mesh_quality(problem_.complex, points).minimum;
    raise(points);
    quality = Mesh_quality(problem_.complex, points);
    if (!(quality.minimum > minimum + parameters_.gain_of_raising))
      return false;
    samples_.update(points, 1);
    excess_ = samples_.excess(points);
    best.offer(points, quality, excess_, looseness(quality), sliding_.away(points));
    floor_.restart();
    start_maximin(i, quality);
    return true;
  }

  // How far from tight the boundary is attached; what has been tight for few iterations has not come near yet, and what is
  // worse than the start not at all.
  double looseness(const Mesh_quality& quality) const
  {
    if (boundary_.tightness < 1)
      return 1 - boundary_.tightness;
    const bool has_come = settled_ >= parameters_.least_settling_iterations && quality.minimum >= start_minimum_;
    return has_come ? 0 : (std::numeric_limits<double>::min)();
  }

  std::size_t settling_iterations() const
  {
    if (is_outside() || settled_minimum_ < start_minimum_) // it would come to nothing
      return parameters_.most_bounded_iterations;
    return parameters_.settling_iterations;
  }

  // Adds samples where points are beyond the bound between those that there are, and judges the best state by them too.
  // Whether there are such places; there are none without a bound, nor while what is to stand exactly somewhere is not
  // there.
  bool refine(const Positions& points, Best_state& best)
  {
    if (sliding_.are_some_away() || !samples_.add_where_beyond(points))
      return false;
    samples_.update(best.points(), 1);
    best.reassess(samples_.excess(best.points()));
    samples_.update(points, boundary_.tightness);
    return true;
  }

  // The worst, unless faces leave a bound by that.
  void raise(Positions& points)
  {
    samples_.update(points, 1);
    const double excess = samples_.excess(points);
    Positions raised = points;
    arrivals_.raise(raised);
    samples_.update(raised, 1);
    if (!(samples_.excess(raised) > excess))
      points = std::move(raised);
  }

  // What no corner of each hexahedron may drop below in the next step. part: of its own.
  Batched_values<1> least_scaled_jacobians(const Mesh_quality& quality, double part) const
  {
    const double level = arrivals_.level() > 0 ? arrivals_.level()
                         : floor_.held() > 0   ? floor_.held()
                                               : quality.minimum;
    Batched_values<1> least(quality.scaled_jacobians.size());
    for (std::size_t h = 0; h < quality.scaled_jacobians.size(); ++h)
      least.set(h, 0, (std::min)(parameters_.least_part_of_corner * level, part * quality.scaled_jacobians[h]));
    return least;
  }

  double bounded_shape() const
  {
    if (!samples_.is_bounded_everywhere())
      return 1;
    const double tenths = 10 * samples_.maximum_deviation();
    return (std::max)(1.0, (std::min)(parameters_.bounded_shape * std::pow(tenths, parameters_.bounded_shape_exponent),
                                      parameters_.most_bounded_shape));
  }

  void weigh_shape()
  {
    Hexahedron_energy_parameters energy = parameters_.energy;
    energy.shape_weight *= shape_ * shape_yield_;
    energy.poor_shape_weight *= shape_ * shape_yield_;
    if (samples_.has_reference_of_its_own() && !samples_.is_bounded_everywhere())
      energy.poor_shape_weight *= parameters_.poor_shape_of_own;
    energy.poor_shape_weight *= (std::max)(1.0, (std::min)(bounded_shape_ / parameters_.dearer_poor_shape,
                                                           parameters_.most_bounded_poor_shape));
    problem_.set_energy(energy);
  }

  Maximization_problem& problem_;
  const Projection projection_;
  const Maximization_parameters& parameters_;
  Boundary_samples& samples_;
  Sliding& sliding_;
  Boundary_energy& boundary_;
  Quality_floor& floor_;
  Arrivals arrivals_;
  double target_quality_ = 0, start_minimum_ = 0;
  double settled_minimum_ = -1; // the highest with the largest weight of the boundary
  std::function<bool()> time_is_over_;
  double shape_ = 1, shape_yield_ = 1; // factors of both weights of the shape
  double bounded_shape_ = 1;           // the part of the first that bounds ask for

  // Of the schedule: what was done, and iterations that count
  Phase phase_ = Phase::MAXIMIN;
  bool is_to_arrive_ = false, has_relaxed_ = false, recovers_ = false, has_raised_ = false;
  bool used_up_ = false; // the iterations of a phase
  double excess_ = 0, least_excess_ = std::numeric_limits<double>::infinity();
  std::size_t begun_ = 0, waited_ = 0, settled_ = 0; // begun: the iteration in which the phase has
  std::size_t stalled_ = 0, unrefined_ = 0, refinements_ = 0, last_refinements_ = 0;
  std::optional<Progress> maximin_, settling_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
