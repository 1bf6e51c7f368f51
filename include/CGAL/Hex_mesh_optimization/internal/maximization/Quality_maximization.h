// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H

// Newton's method on the energy of all hexahedra and of the attachment, from a
// mesh without inverted corners: the worst corners climb while the boundary is
// loosely attached, then the attachment tightens while they are held. What is to
// stand exactly on curves and faces comes to its place after that.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedra_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Sum_of_energies.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Arrivals.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/hold_corners.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Target_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/vertex_couplings.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Progress.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Quality_maximization
{
public:
  // Positions are in units of the mean boundary edge; targets are those of the edges, of which what is not certain may
  // be adapted. All but the numbers and the targets must outlive the object. distance: of the samples.
  Quality_maximization(const Hexahedral_complex& complex, Boundary_samples& samples, const Distance_energy& distance,
                       const Target_lengths& targets, const Edge_relations& relations, Sliding& sliding,
                       const Maximization_parameters& parameters)
    : complex_(complex)
    , parameters_(parameters)
    , samples_(samples)
    , relations_(relations)
    , matrix_(vertex_couplings(complex), complex.ties)
    , assembly_(complex, matrix_)
    , batches_(complex)
    , floor_(batches_, parameters.floor)
    , hexahedra_(complex, batches_, assembly_, floor_.floors(), targets.lengths, parameters.energy)
    , boundary_(samples, distance, complex.number_of_vertices())
    , sliding_(sliding)
    , targets_(targets)
    , arrivals_(complex, targets_.lengths, sliding, parameters.arrivals)
  {
    // a hexahedron keeps its lengths as closely as the most certain of them
    const double weight = targets.are_asked_for ? parameters.weight_of_lengths_asked_for : 1;
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      double certainty = 0;
      for (int directed : complex.hexahedron_edges[h])
        certainty = (std::max)(certainty, targets.certainty[directed / 2]);
      hexahedra_.set_certainty(h, weight * certainty);
    }
  }

  // Improves points until nothing is gained any more or control ends the run; leaves in them the best state met.
  // Does nothing if a hexahedron is inverted.
  Stage_end run(Positions& points, Run_control& control, double target_quality,
                Protection protection = Protection::OF_WHAT_IS_GOOD)
  {
    Mesh_quality quality(complex_, points);
    if (quality.inverted > 0)
      return Stage_end::CONVERGED;
    samples_.restore_walls();
    samples_.update(points, 1);
    double excess = samples_.excess(points), least_excess = std::numeric_limits<double>::infinity();
    const auto is_target_reached = [&] {
      return quality.invalid == 0 && quality.minimum >= target_quality && !(excess > 0) && !sliding_.are_some_away() &&
             sliding_.vertices_away().empty();
    };
    if (is_target_reached())
      return Stage_end::CONVERGED;
    Best_state best(points, quality, 1, parameters_.accepted_loss, excess, 1, sliding_.away(points), protection);
    // what stands exactly on curves and faces may leave them for a time, unless it would be worse off for good
    if (!best.is_protected())
      sliding_.let_go();
    // what is to stand exactly somewhere comes last, when it has not far to go; then all goes on around it
    const bool is_to_arrive = sliding_.holds_more_than_corners();
    const double change_of_average = samples_.is_bounded() || is_to_arrive
                                       ? parameters_.careful_climbing_change_of_average
                                       : parameters_.climbing_change_of_average;
    Progress climb(quality, parameters_.climbing_gain, change_of_average), settling = climb;
    Phase phase = Phase::CLIMBING;
    bool has_relaxed = false, recovers = false, has_raised = false, used_up = false; // the iterations of a phase
    std::size_t begun = 0, waited = 0, settled = 0; // begun: the iteration in which climbing has
    std::size_t stalled = 0, unrefined = 0;         // iterations
    std::size_t refinements = 0, last_refinements = 0;
    const auto climb_from = [&](std::size_t i) {
      phase = Phase::CLIMBING;
      boundary_.tightness = parameters_.start_tightness;
      begun = i;
      climb = Progress(quality, parameters_.climbing_gain, change_of_average);
    };
    const auto time_is_over = [&control] { return control.time_is_over(); };
    climb_from(0);
    for (std::size_t i = 0; !control.is_stopped(); ++i) {
      if (phase == Phase::ARRIVING) {
        if (!arrivals_.go_on(points, time_is_over))
          climb_from(i);
        floor_.restart();
      }
      else if (phase == Phase::CLIMBING) {
        const bool is_high = quality.minimum >= floor_.worth_holding(quality) &&
                             climb.iterations_without_change_of_average() >= parameters_.climbing_patience_for_average;
        const bool is_stalled = climb.iterations_without_gain_of_minimum() >= parameters_.climbing_patience &&
                                climb.iterations_without_change_of_average() >=
                                  parameters_.stalled_patience_for_average;
        const bool is_done = is_high || is_stalled;
        if (is_done || i == begun + parameters_.climbing_iterations) {
          phase = Phase::SETTLING;
          used_up = !is_done;
          waited = settled = 0;
          if (!has_relaxed)
            relax(quality, points);
          has_relaxed = true;
          if (!is_to_arrive)
            sliding_.call_all();
        }
      }
      if (phase != Phase::SETTLING)
        floor_.rise(quality);
      else {
        // within a close bound, quality comes before the average deviation (measured on voxels of a ball, bound to .5 %
        // of the diagonal of their surface: minimum and average are .817 and .958 instead of .680 and .929)
        if (samples_.is_closely_bounded())
          floor_.remember_worth(quality);
        floor_.hold(quality, points, (std::max)(best.least_minimum(), 0.0));
        // it waits for corners that fell behind, but not for ever
        if (quality.minimum >= parameters_.ready * floor_.held() || ++waited > parameters_.waiting_patience) {
          boundary_.tightness = (std::min)(1.0, boundary_.tightness * parameters_.tightening);
          waited = 0;
        }
      }
      const bool approaches = sliding_.are_some_away();
      if (approaches) {
        arrivals_.approach(quality.scaled_jacobians, least_scaled_jacobians(quality, 1),
                           parameters_.least_part_of_corner, points);
        quality = Mesh_quality(complex_, points);
      }
      if (approaches || (samples_.is_bounded() && boundary_.tightness < 1)) // walls move with the tightness
        samples_.update(points, boundary_.tightness);
      // the worst give nothing to arrivals: they would be worn down
      const Batched_values<1> least = least_scaled_jacobians(quality, phase == Phase::ARRIVING
                                                                        ? 1
                                                                        : parameters_.least_part_of_corner);
      const auto retract = [this](Positions& p) { sliding_.retract(p); };
      const auto restrict_step = [&](Positions& step) {
        sliding_.keep_within(points, step);
        hold_corners(
          complex_, batches_, points, least, parameters_.holding_rounds,
          arrivals_.have_begun() ? Last_resort::UNTIL_NONE_IS_RUINED : Last_resort::NONE, retract,
          [&](const Positions& reached, std::vector<char>& is_ruined) {
            samples_.find_leaving(points, reached, complex_, is_ruined);
            if (arrivals_.have_begun())
              find_invalidated(points, reached, is_ruined);
          },
          step);
      };
      const auto freedoms = [&](const Positions& forces) { return sliding_.freedoms(points, forces); };
      const Positions start = arrivals_.have_begun() ? points : Positions();
      const std::size_t invalid = quality.invalid;
      Newton_parameters newton = parameters_.newton;
      if (phase == Phase::CLIMBING && !samples_.is_bounded())
        newton.relaxation = parameters_.climbing_relaxation;
      const double energy = newton_step(Sum_of_energies(hexahedra_, boundary_), freedoms, restrict_step, retract,
                                        newton, matrix_, points);
      quality = Mesh_quality(complex_, points);
      if (arrivals_.have_begun() && quality.invalid > invalid) {
        take_back(start, points);
        quality = Mesh_quality(complex_, points);
      }
      samples_.update(points, boundary_.tightness);
      excess = samples_.excess(points);
      const bool is_outside = (samples_.is_bounded() && excess > 0) || sliding_.are_some_away();
      if (boundary_.tightness == 1 && phase == Phase::SETTLING) {
        samples_.adapt_walls(points);
        if (!is_outside) {
          if (std::isfinite(least_excess) && !recovers) {
            // what has yielded now recovers, once: else it could go back and forth for ever
            settled = 0;
            settling = Progress(quality, parameters_.least_gain_of_minimum, parameters_.least_change_of_average);
          }
          recovers = recovers || std::isfinite(least_excess);
          least_excess = std::numeric_limits<double>::infinity();
          floor_.recover(parameters_.recovery);
        }
        else if (excess < parameters_.excess_part * least_excess) {
          least_excess = excess;
          stalled = 0;
        }
        else if (samples_.is_bounded() && !samples_.is_bounded_everywhere() &&
                 shape_yield_ > parameters_.least_shape_yield) {
          shape_yield_ *= parameters_.shape_yielding;
          weigh_shape();
        }
        else if (++stalled >= parameters_.yielding_patience) {
          floor_.yield(parameters_.yielding);
          stalled = 0;
        }
        if (++unrefined >= parameters_.refinement_interval && refinements < parameters_.most_refinements) {
          unrefined = 0;
          ++refinements;
          refine(points, best);
          excess = samples_.excess(points);
        }
      }
      // what was good is left as it was rather than loosely attached, and what is on its way is no result
      if (arrivals_.have_begun() ? phase == Phase::SETTLING && boundary_.tightness == 1
                                 : boundary_.tightness == 1 || !best.is_protected())
        best.offer(points, quality, excess, looseness(settled), sliding_.away(points));
      climb.add(quality);
      if (boundary_.tightness < 1)
        settling = Progress(quality, parameters_.least_gain_of_minimum, parameters_.least_change_of_average);
      else
        settling.add(quality);
      control.after_iteration(Stage::MAXIMIZATION, i, energy, quality);
      const bool is_held = best.highest_minimum() >= parameters_.held_closely * floor_.held();
      const bool is_settled = !is_outside && is_held && settling.iterations_without_change() >= parameters_.patience;
      if (phase != Phase::SETTLING || boundary_.tightness < 1)
        continue;
      const bool is_over = ++settled >= settling_iterations(is_held, is_outside);
      if (!is_over && !is_settled && !is_target_reached())
        continue;
      if (!(best.excess() > 0) && last_refinements < parameters_.most_last_refinements) {
        ++last_refinements;
        points = best.points();
        sliding_.notice(points);
        if (refine(points, best)) {
          quality = Mesh_quality(complex_, points);
          settled = 0;
          settling = Progress(quality, parameters_.least_gain_of_minimum, parameters_.least_change_of_average);
          least_excess = std::numeric_limits<double>::infinity();
          recovers = false;
          continue;
        }
      }
      if (arrivals_.have_begun() && !is_target_reached() && !std::exchange(has_raised, true)) {
        // Newton's method goes on from where the search has led
        points = best.points();
        sliding_.notice(points);
        const double minimum = Mesh_quality(complex_, points).minimum;
        raise(points);
        quality = Mesh_quality(complex_, points);
        if (quality.minimum > minimum + parameters_.gain_of_raising) {
          samples_.update(points, 1);
          excess = samples_.excess(points);
          best.offer(points, quality, excess, looseness(settled), sliding_.away(points));
          floor_.restart();
          climb_from(i);
          continue;
        }
      }
      // what was let go may come after all, once those around it have given way
      if (!is_to_arrive || !arrivals_.call(points, quality.minimum, time_is_over)) {
        used_up = used_up || (is_over && !is_settled);
        break;
      }
      phase = Phase::ARRIVING;
    }
    points = best.points();
    if (arrivals_.have_begun() && !control.is_stopped())
      raise(points);
    return control.stage_end(used_up);
  }

private:
  enum class Phase {
    CLIMBING, // the worst corners, while the boundary may yield
    SETTLING, // the boundary tightens, or is tight, and the worst corners are held
    ARRIVING  // what is to stand exactly on curves and faces comes to its place
  };

  // Of a state of the boundary. settled: tight iterations up to now; what has been tight for few has not come near yet.
  double looseness(std::size_t settled) const
  {
    if (boundary_.tightness < 1)
      return 1 - boundary_.tightness;
    return settled < parameters_.least_settling_iterations ? (std::numeric_limits<double>::min)() : 0;
  }

  std::size_t settling_iterations(bool is_held, bool is_outside) const
  {
    if (is_outside)
      return parameters_.most_bounded_iterations;
    return is_held ? parameters_.settling_iterations : parameters_.longest_settling_iterations;
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

  // From the first phase to the second: the shape counts for more, for lengths that suit the mesh.
  void relax(const Mesh_quality& quality, const Positions& points)
  {
    bounded_shape_ = bounded_shape();
    shape_ = bounded_shape_ * parameters_.shape_balance / (parameters_.shape_balance_offset + 1 - quality.average);
    weigh_shape();
    adapt_lengths(points);
  }

  // Those that are certified at points, and not where they are reached: their corners may all be good.
  void find_invalidated(const Positions& points, const Positions& reached, std::vector<char>& is_ruined) const
  {
    const auto is_valid = [this](const Positions& p, std::size_t h) {
      return hexahedron_validity(hexahedron_coordinates(p, complex_.hexahedra[h])) == Validity::VALID;
    };
    for_each(is_ruined.size(), [&](std::size_t h) {
      if (!is_ruined[h] && !is_valid(reached, h) && is_valid(points, h))
        is_ruined[h] = true;
    });
  }

  // Vertices of hexahedra that a step has made invalid go back to its start: a part of a step can do so where all of it
  // does not.
  void take_back(const Positions& start, Positions& points) const
  {
    std::vector<char> is_ruined(complex_.hexahedra.size()), goes_back(points.size(), false);
    const auto find = [&] {
      std::fill(is_ruined.begin(), is_ruined.end(), false);
      find_invalidated(start, points, is_ruined);
      return std::count(is_ruined.begin(), is_ruined.end(), true) > 0;
    };
    while (find()) {
      for (std::size_t h = 0; h < is_ruined.size(); ++h)
        for (int v : complex_.hexahedra[h])
          goes_back[v] = goes_back[v] || is_ruined[h];
      complex_.ties.unite(goes_back);
      for (std::size_t v = 0; v < points.size(); ++v)
        if (goes_back[v])
          points[v] = start[v];
    }
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

  // Moves the target lengths of the interior towards those that the loosely attached mesh has found to suit it:
  // smoothly, so that they follow the shape of the model and not of single poor hexahedra.
  void adapt_lengths(const Positions& points)
  {
    const std::vector<double> reached = smooth_edge_lengths(relations_, edge_lengths(complex_, points));
    std::vector<double>& lengths = targets_.lengths;
    for (std::size_t e = 0; e < lengths.size(); ++e)
      if (!complex_.is_boundary_edge[e])
        lengths[e] *= std::pow(reached[e] / lengths[e], (1 - targets_.certainty[e]) * parameters_.length_adaptation);
    hexahedra_.set_target_lengths(lengths);
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
    hexahedra_.set_parameters(energy);
  }

  const Hexahedral_complex& complex_;
  const Maximization_parameters parameters_;
  Boundary_samples& samples_;
  const Edge_relations& relations_;
  Block_matrix matrix_;
  const Hexahedron_assembly assembly_;
  const Hexahedron_batches batches_;
  Quality_floor floor_;
  Hexahedra_energy hexahedra_;
  Boundary_energy boundary_;
  Sliding& sliding_;
  Target_lengths targets_; // of the edges
  Arrivals arrivals_;
  double shape_ = 1, shape_yield_ = 1; // factors of both weights of the shape
  double bounded_shape_ = 1;           // the part of the first that bounds ask for
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
