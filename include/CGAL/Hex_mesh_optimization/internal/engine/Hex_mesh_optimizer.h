// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The whole optimization on flat arrays: from positions, hexahedra and a
// reference to better positions and a status.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/limit_of_held_boundary.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Checked_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Judge.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Model.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Report.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Interior_point_maximization.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_problem.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_maximization.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Raising_within_bound.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Merit.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cone_rectification.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/harmonic_start.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/projected_start.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Hex_mesh_optimizer
{
public:
  // Everything that can be wrong with the input is refused here, by Input_error.
  // reference: null when the boundary of the mesh is its own reference, as what is between regions always is.
  Hex_mesh_optimizer(const Positions& points, const std::vector<Hexahedron>& hexahedra, const Regions& regions,
                     const Reference_input* reference, const std::vector<char>& is_frozen,
                     const Optimization_parameters& parameters)
    : parameters_(parameters)
    , control_(parameters.maximum_running_time, parameters.on_iteration)
    , mesh_(points, hexahedra, regions)
    , model_(mesh_, reference, is_frozen, parameters_)
    , report_(mesh_, model_, parameters_)
    , judge_(mesh_, model_, parameters_)
    , bound_(bound_asked_for())
  {}

  // Optimizes, one attempt after the other. positions() are then the best found.
  Status run()
  {
    control_.on_state = [this](const Positions& points, const Mesh_quality& quality, std::optional<double> excess) {
      return incumbent(points, quality, is_as_asked_for() ? excess : std::nullopt);
    };
    State best{judge_.judged(model_.points)};
    incumbent(best.points, best.quality, best.merit.excess);
    came_in_good_ = best.merit.is_good();
    for (const Attempt& attempt : attempts())
      if (!control_.check_time() && attempt.is_needed(best)) {
        const double begun = control_.seconds();
        const std::size_t iterations = control_.iterations;
        const Reached result = attempt.run(best);
        attach(model_.attachment, false);
        State reached{judge_.judged(result.points), result.end, result.is_maximized};
        const bool is_taken = attempt.accepts(reached, best);
        report_.status.attempts.push_back({attempt.name, is_taken, control_.iterations - iterations,
                                           control_.seconds() - begun, reached.quality.inverted,
                                           reached.quality.minimum, reached.quality.average});
        if (is_taken)
          best = std::move(reached);
      }
    if (control_.is_stopped()) {
      Judge::Judged shown = judge_.judged(incumbent_.points);
      if (judge_.is_better(shown, best))
        static_cast<Judge::Judged&>(best) = std::move(shown);
    }
    return finish(best);
  }

  // In the coordinates and the order of the input.
  Positions positions() const { return mesh_.order.as_given(report_.positions()); }

private:
  struct Reached
  {
    Positions points;
    Stage_end end = Stage_end::CONVERGED; // of the last stage that the points come from
    bool is_maximized = false;
  };

  struct State : Judge::Judged
  {
    Stage_end end = Stage_end::CONVERGED;
    bool is_maximized = false;
  };

  // One way from the best state so far to a better one.
  struct Attempt
  {
    const char* name; // in the status
    std::function<bool(const State& best)> is_needed;
    std::function<Reached(const State& best)> run;
    std::function<bool(const State& reached, const State& best)> accepts;
  };

  // In the order in which they are made. What moves least comes first: what is sound stays where it is, unless that fails.
  std::vector<Attempt> attempts()
  {
    using First = Untangling::Attempt;
    const auto always = [](const State&) { return true; };
    const auto whatever = [](const State&, const State&) { return true; };
    const auto if_better = [this](const State& a, const State& b) { return judge_.is_better(a, b); };
    const auto if_good = [](const State& reached, const State&) { return reached.merit.is_good(); };
    const auto is_inverted = [](const State& best) { return best.quality.inverted > 0; };
    const auto is_beyond_bound = [this](const State& best) { return judge_.is_beyond_bound(best); };
    const Attempt last_untangling{"untangling", [this](const State& best) { return is_tangled(best.quality); },
                                  [this](const State& best) { return untangled(start(best), First::LAST); }, whatever};
    const Attempt maximin{"maximin", [this](const State& best) { return needs_maximin(best); },
                          [this](const State& best) { return maximized(start(best)); }, if_better};
    if (parameters_.method == Method::RECTIFICATION)
      return {{"rectification", always, [this](const State&) { return rectified(parameters_.target_quality, 0); }, whatever}};
    if (parameters_.method == Method::MAXIMIZATION)
      return {last_untangling, maximin};
    return {
      {"projection", [this](const State& best) { return is_off_reference(best); },
       [this](const State& best) { return projected(best.points); },
       [this](const State& reached, const State& best) { return is_as_good(reached, best); }},
      {"untangling within the boundary", [this](const State& best) { return may_hold_boundary(best); },
       [this](const State& best) { return untangled_within_boundary(best.points); }, if_better},
      {"untangling where it is", [this](const State& best) { return tells_where_to_go(best); },
       [this](const State& best) { return untangled(start(best), First::FIRST); }, if_better},
      {"rectification", is_inverted, [this](const State&) { return rectified_and_untangled(); }, if_better},
      {"interior point within the boundary", [this](const State& best) { return may_step_within_boundary(best.quality); },
       [this](const State& best) { return improved_within_boundary(start(best)); }, if_good},
      {"interior point", [this](const State& best) { return may_step_feasibly(best.quality); },
       [this](const State& best) { return improved_within(start(best)); }, if_good},
      maximin,
      {"interior point on the surface", [this](const State& best) { return may_be_polished(best); },
       [this](const State& best) { return improved_within(start(best)); }, if_good},
      {"rectified start", [this](const State& best) { return is_missed(best.merit); },
       [this](const State&) { return maximized(rectified_and_untangled()); }, if_better},
      {"start within the bound", is_beyond_bound, [this](const State&) { return reached_within_bound(); }, if_better},
      {"boundary as it came in", [this](const State& best) { return is_short_of_goals(best); },
       [this](const State&) { return untangled_within_boundary(model_.points); }, if_better},
      {"search within the bound", [this](const State& best) { return may_raise_within_bound(best); },
       [this](const State& best) { return raised_within_bound(start(best)); }, if_better},
      {"spare quality", [this](const State&) { return may_spend_quality(); },
       [this](const State& best) { return spent(best); }, whatever},
    };
  }

  static Reached start(const State& best) { return {best.points, best.end, best.is_maximized}; }

  Status finish(const State& best)
  {
    samples_.reset();
    report_.certify(model_.in_coordinates(best.points), judge_.excess(model_.points), best.merit.excess);
    Status& status = report_.status;
    status.return_code = control_.is_stopped()
                           ? control_.return_code()
                           : report_.return_code(best.end == Stage_end::ITERATION_LIMIT ? Return_code::ITERATION_LIMIT
                                                                                        : Return_code::CONVERGED);
    status.iterations = control_.iterations;
    status.total_seconds = control_.seconds();
    return status;
  }

  // --- When attempts are needed ---

  bool is_exact() const { return parameters_.boundary_placement == Boundary_placement::ON_SURFACE; }
  double worth_raising_to() const
  {
    return (std::min)(parameters_.maximization.floor.hold_limit, parameters_.target_quality);
  }

  // Whether the mesh has to be brought to a reference.
  bool is_off_reference(const State& best) const
  {
    return model_.reference_is_given && (best.merit.excess > 0 || best.merit.away.in_all > 0);
  }

  // Whether hexahedra are inverted, or nearly so: maximization does not lead away from there.
  bool is_tangled(const Mesh_quality& quality) const
  {
    return quality.inverted > 0 || quality.minimum < parameters_.untangling.untangled;
  }

  // Whether hexahedra are tangled, and the boundary is good enough to stay where it is.
  bool may_hold_boundary(const State& best) const
  {
    return is_tangled(best.quality) && !model_.reference_is_given &&
           limit_of_held_boundary(mesh_.complex, best.points) >= parameters_.worth_holding_boundary &&
           std::any_of(model_.attachment.kind.begin(), model_.attachment.kind.end(),
                       [](Vertex_kind kind) { return kind != Vertex_kind::INTERIOR && kind != Vertex_kind::FIXED; });
  }

  // Whether hexahedra are tangled, and most of the mesh tells where they should be. Interfaces cross the whole mesh
  // (measured on a ball in a block: they end .087 edges off from a rectified start, and .113 edges untangled where they are).
  bool tells_where_to_go(const State& best)
  {
    const bool may_be_torn = samples().has_interface() && !judge_.has_bound();
    return is_tangled(best.quality) && !may_be_torn &&
           double(best.quality.inverted) <= parameters_.untangled_as_given * double(mesh_.complex.hexahedra.size());
  }

  // Whether the mesh came in valid; one that has to be brought to a reference has to give way for that, unless its minimum is
  // limited anyway.
  bool may_step_feasibly(const Mesh_quality& quality) const
  {
    return report_.status.before.number_of_invalid == 0 && quality.invalid == 0 &&
           (!model_.reference_is_given || is_limited(quality));
  }

  // Whether that is to begin with the interior: within a close bound, and where vertices stay on their surface, what moves
  // on the boundary is often held back, and hexahedra beside it are with it.
  bool may_step_within_boundary(const Mesh_quality& quality) const
  {
    return may_step_feasibly(quality) && !model_.reference_is_given && (judge_.has_bound() || is_exact());
  }

  // Whether the mesh misses what a fixed boundary may reach.
  bool is_short_of_goals(const State& best) const
  {
    return !model_.reference_is_given && (!best.merit.is_good() || judge_.is_beyond_bound(best));
  }

  // Whether all vertices have come to their places on the surface, which has cost their hexahedra quality.
  bool may_be_polished(const State& best) const
  {
    return is_exact() && best.is_maximized && best.merit.is_good();
  }

  // Whether the minimum is to be raised while the boundary is loose. What was brought to its best within its boundary leaves
  // that only where it is poor.
  bool needs_maximin(const State& best) const
  {
    const Mesh_quality& quality = best.quality;
    if (quality.inverted > 0)
      return false;
    if (!best.merit.is_good())
      return true;
    if (quality.minimum >= parameters_.target_quality)
      return false;
    if (best.is_maximized)
      return quality.minimum < worth_raising_to();
    return report_.status.before.number_of_invalid > 0 || !is_limited(quality);
  }

  // Whether the connectivity seems to limit the minimum: it is poor, and so are many hexahedra, but not most.
  bool is_limited(const Mesh_quality& quality) const
  {
    return quality.minimum < worth_raising_to() && quality.average >= worth_raising_to() &&
           quality.quantile(parameters_.maximization.floor.fraction) <
             quality.minimum + parameters_.maximization.accepted_loss;
  }

  // Whether what comes before quality is not met.
  bool is_missed(const Merit& merit) const
  {
    return (judge_.has_bound() && merit.excess > 0) || (is_exact() && merit.away.in_all > 0);
  }

  // Whether a mesh is where it has to be, at hardly any cost of the minimum.
  bool is_as_good(const State& state, const State& than) const
  {
    return state.merit.is_good() &&
           state.quality.minimum >= than.quality.minimum - parameters_.maximization.accepted_loss;
  }

  bool may_raise_within_bound(const State& best) const
  {
    return judge_.has_bound() && !is_exact() && best.quality.minimum < worth_raising_to() &&
           !judge_.is_beyond_bound(best);
  }

  // --- Attempts ---

  Reached projected(const Positions& points) const
  {
    return {Projected_start(mesh_.complex, *model_.surface, model_.attachment)(points)};
  }

  // Nothing of the boundary moves. Where the most is inverted, the interior tells nothing.
  Reached untangled_within_boundary(const Positions& points)
  {
    const Boundary_attachment held = held_boundary();
    attach(held, false);
    bind(std::numeric_limits<double>::infinity()); // what does not move is not beyond it either
    Reached reached{points};
    if (2 * number_of_inverted(points) > mesh_.complex.hexahedra.size())
      reached.points = harmonic_positions();
    reached = maximized(untangled(reached, Untangling::Attempt::FIRST));
    bind(bound_asked_for());
    return reached;
  }

  Boundary_attachment held_boundary() const
  {
    Boundary_attachment held = model_.attachment;
    for (std::size_t v = 0; v < held.kind.size(); ++v)
      if (mesh_.complex.is_on_boundary[v])
        held.kind[v] = Vertex_kind::FIXED;
    return held;
  }

  // From the input. Rectification has done enough where only a few hexahedra are inverted: it takes many iterations for the
  // last ones.
  Reached rectified_and_untangled()
  {
    const double target = (std::min)(0.0, parameters_.target_quality);
    const auto few = static_cast<std::size_t>(parameters_.left_to_untangling * double(mesh_.complex.hexahedra.size()));
    Reached reached = rectified(target, few);
    const std::size_t inverted = number_of_inverted(reached.points);
    reached = untangled(reached, Untangling::Attempt::LAST);
    if (inverted <= few && number_of_inverted(reached.points) > 0 && !control_.is_stopped()) {
      // those few are too much for untangling
      rectify(reached.points, target, 0);
      reached = untangled(reached, Untangling::Attempt::LAST);
    }
    return reached;
  }

  // From the interior that suits it better.
  Reached rectified(double target, std::size_t few)
  {
    Reached reached{model_.points};
    const bool starts_harmonic = 2 * report_.status.before.number_of_inverted > mesh_.complex.hexahedra.size();
    if (starts_harmonic)
      reached.points = harmonic_positions();
    reached.end = rectify(reached.points, target, few);
    const Mesh_quality quality(mesh_.complex, reached.points);
    const bool is_rectified = few > 0 ? quality.inverted <= few : quality.invalid == 0;
    if (is_rectified || starts_harmonic || control_.is_stopped())
      return reached;
    // what the given interior locks, another start may not
    Reached other{harmonic_positions()};
    other.end = rectify(other.points, target, few);
    return number_of_inverted(other.points) < quality.inverted ? other : reached;
  }

  Reached untangled(const Reached& best, Untangling::Attempt attempt)
  {
    Reached reached = best;
    if (is_tangled(Mesh_quality(mesh_.complex, best.points)) && !control_.check_time())
      reached.end = untangle(reached.points, attempt);
    return reached;
  }

  // By feasible steps only. A given reference weighs as much as one of its own at first; if the boundary is off it then, as
  // much as it is trusted.
  Reached improved_within(const Reached& best)
  {
    const Timer timer(control_, report_.status.maximization_seconds);
    Reached reached = best;
    Sliding held = sliding(reached.points);
    Maximization_problem problem = maximization_problem(held);
    Interior_point_maximization maximization(problem, parameters_.interior_point);
    const auto improve = [&](double tightness) {
      problem.boundary.tightness = tightness;
      reached.end = maximization.run(reached.points, control_, parameters_.target_quality);
    };
    improve(model_.reference_is_given ? 1 / parameters_.boundary.trust : 1);
    if (model_.reference_is_given && judge_.excess(reached.points) > 0 && !control_.check_time())
      improve(1);
    return reached;
  }

  // Nothing of the boundary moves.
  Reached improved_within_boundary(const Reached& best)
  {
    const Boundary_attachment held = held_boundary();
    attach(held, false);
    bind(std::numeric_limits<double>::infinity());
    const Reached reached = improved_within(best);
    bind(bound_asked_for());
    return reached;
  }

  // The boundary is loosely attached at first.
  Reached maximized(const Reached& best)
  {
    Reached reached = best;
    if (number_of_inverted(best.points) == 0 && !control_.check_time()) {
      reached.end = maximize(reached.points);
      reached.is_maximized = true;
    }
    return reached;
  }

  // What comes back within the bound does not leave it: from the boundary as it came in, if that is within, or else from a
  // rectified start.
  Reached reached_within_bound()
  {
    if (!judge_.is_shown_within_bound(model_.points)) {
      attach(model_.attachment, true);
      return maximized(rectified_and_untangled());
    }
    Reached reached = untangled_within_boundary(model_.points);
    attach(model_.attachment, true);
    reached = untangled(reached, Untangling::Attempt::LAST);
    return improved_within(reached);
  }

  // By search, what maximization has not raised within a bound.
  Reached raised_within_bound(const Reached& best)
  {
    const Timer timer(control_, report_.status.maximization_seconds);
    Reached reached = best;
    const Sliding held = sliding(reached.points);
    Raising_within_bound(mesh_.complex, model_.targets.lengths, *model_.surface, model_.attachment, held,
                         samples(), parameters_.maximization.arrivals.search, parameters_.raising)
      .raise(
        worth_raising_to(), [this](const Positions& raised) { return judge_.is_shown_within_bound(raised); },
        [this] { return control_.check_time(); }, reached.points);
    return reached;
  }

  // Whether the boundary is brought to a reference of its own, and neither a bound nor a quality is asked for.
  bool may_spend_quality()
  {
    return samples().has_reference_of_its_own() && !judge_.has_bound() &&
           !std::isfinite(parameters_.target_quality);
  }

  // What quality there is to spare goes into the largest deviation.
  Reached spent(const State& best)
  {
    Reached reached = start(best);
    Mesh_quality quality = best.quality;
    if (quality.minimum < parameters_.spare_above)
      return reached;
    // nor may a mesh that came in as good as it is to be get worse
    const double least = (std::max)(parameters_.spare_above, came_in_good_ ? report_.status.before.minimum : 0);
    double expected_loss = 0; // of the minimum
    for (std::size_t i = 0; i < parameters_.most_spared && !control_.check_time(); ++i) {
      const double largest =
        deviations(model_.faces, reached.points, *model_.surface, parameters_.measuring_spacing).all.maximum;
      if (quality.invalid > 0 || quality.minimum - expected_loss < least || stage_excess(reached.points) > 0 ||
          largest < parameters_.boundary.samples.still_distance)
        break;
      bind(parameters_.spared_deviation * largest);
      Positions points = reached.points;
      maximize(points);
      const bool is_within = !(stage_excess(points) > 0);
      bind(bound_asked_for());
      const Mesh_quality spent(mesh_.complex, points);
      if (!is_within || spent.invalid > 0 || spent.minimum < least ||
          spent.average < quality.average - parameters_.spared_average)
        break;
      expected_loss = parameters_.growth_of_cost * (quality.minimum - spent.minimum);
      quality = spent;
      reached.points = std::move(points);
    }
    return reached;
  }

  // Bounds the deviation from now on. In mean boundary edges.
  void bind(double bound)
  {
    bound_ = bound;
    samples_.reset();
  }

  std::size_t number_of_inverted(const Positions& points) const { return Mesh_quality(mesh_.complex, points).inverted; }

  // The best state of any stage in the order of goals: what is written if the run ends now. Returns what is shown of it.
  // known_excess: of the points, where a stage has found it.
  Run_control::Shown incumbent(const Positions& points, const Mesh_quality& quality, std::optional<double> known_excess)
  {
    const bool is_behind = incumbent_.merit.is_good() &&
                           (quality.invalid > 0 || quality.minimum <= incumbent_.shown.minimum);
    if (incumbent_.points.empty() || !is_behind) {
      const Merit merit = judge_.merit(points, quality,
                                                known_excess ? *known_excess : judge_.excess(points));
      if (incumbent_.points.empty() || merit < incumbent_.merit ||
          (!(incumbent_.merit < merit) && quality.minimum > incumbent_.shown.minimum))
        incumbent_ = {points, merit, {quality.inverted, quality.minimum, quality.average}};
    }
    return incumbent_.shown;
  }

  // What all stages attach the boundary with from now on. stays_within: they do not loosen the bound for a time.
  void attach(const Boundary_attachment& attachment, bool stays_within)
  {
    attachment_ = &attachment;
    stays_within_ = stays_within;
    samples_.reset();
  }

  double bound_asked_for() const { return parameters_.maximum_deviation / model_.unit; }

  // Whether stages attach and bound the boundary as the caller asks.
  bool is_as_asked_for() const { return attachment_ == &model_.attachment && bound_ == bound_asked_for(); }

  // Adds the time of its life.
  class Timer
  {
  public:
    Timer(const Run_control& control, double& seconds) : control_(control), seconds_(seconds), start_(control.seconds())
    {}
    ~Timer() { seconds_ += control_.seconds() - start_; }

  private:
    const Run_control& control_;
    double& seconds_;
    const double start_;
  };

  // The input with a smooth interior.
  Positions harmonic_positions() const
  {
    Positions points = model_.points;
    harmonic_start(mesh_.complex, *attachment_, points);
    return points;
  }

  Stage_end rectify(Positions& points, double target, std::size_t tolerated)
  {
    const Timer timer(control_, report_.status.rectification_seconds);
    return Edge_cone_rectification(mesh_.complex, model_.relations, model_.faces, *model_.surface, *attachment_,
                                   vertices_at_rest(points), model_.targets.lengths, parameters_.rectification)
      .run(points, control_, target, tolerated);
  }

  Stage_end untangle(Positions& points, Untangling::Attempt attempt = Untangling::Attempt::LAST)
  {
    const Timer timer(control_, report_.status.untangling_seconds);
    Sliding held = sliding(points);
    held.let_go(); // within the surface, some do not untangle
    return Untangling(mesh_.complex, samples(), distance_energy(), model_.targets.lengths, held,
                      parameters_.untangling)
      .run(points, control_, attempt);
  }

  Stage_end maximize(Positions& points)
  {
    const Timer timer(control_, report_.status.maximization_seconds);
    Sliding held = sliding(points);
    Maximization_problem problem = maximization_problem(held);
    using Projection = Quality_maximization::Projection;
    return Quality_maximization(problem, model_.reference_is_given ? Projection::LAST : Projection::FIRST)
      .run(points, control_, parameters_.target_quality);
  }

  Maximization_problem maximization_problem(Sliding& held)
  {
    return Maximization_problem(mesh_.complex, samples(), distance_energy(), model_.targets, model_.relations,
                                held, parameters_.maximization);
  }

  Sliding sliding(const Positions& points) const
  {
    return Sliding(*model_.surface, *attachment_, parameters_.boundary_placement, points, mesh_.complex.ties);
  }

  std::vector<char> vertices_at_rest(const Positions& points) const
  {
    const Sliding held = sliding(points);
    std::vector<char> result(points.size());
    for (std::size_t v = 0; v < result.size(); ++v)
      result[v] = held.is_at_rest(v);
    return result;
  }

  // Over what stages are bounded by now.
  double stage_excess(const Positions& points)
  {
    if (samples().has_tolerance())
      samples().update(points, 1);
    return samples().excess(points);
  }

  // What untangling finds of the boundary, maximization goes on with.
  Boundary_samples& samples()
  {
    if (!samples_)
      samples_.emplace(boundary_samples(mesh_, model_, parameters_, *attachment_, bound_, stays_within_));
    return *samples_;
  }

  Distance_energy distance_energy() const
  {
    return boundary_distance_energy(*model_.surface, model_.reference_is_given, parameters_.boundary);
  }

  const Optimization_parameters parameters_;
  Run_control control_;
  const Checked_mesh mesh_;
  const Model model_;
  Report report_;
  Judge judge_;
  double bound_; // of the deviation, in mean boundary edges
  const Boundary_attachment* attachment_ = &model_.attachment;
  bool stays_within_ = false; // the bound, which may be loosened for a time otherwise
  std::optional<Boundary_samples> samples_;
  bool came_in_good_ = false;

  struct Incumbent
  {
    Positions points;
    Merit merit{};
    Run_control::Shown shown{};
  };
  Incumbent incumbent_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
