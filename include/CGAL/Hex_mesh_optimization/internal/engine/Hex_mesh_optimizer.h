// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H

// The whole optimization on flat arrays: from positions, hexahedra and a
// reference to better positions and a status.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Checked_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Model.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Report.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_maximization.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Raising_within_bound.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Standing.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cone_rectification.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/harmonic_start.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
    , bound_(parameters_.maximum_deviation / model_.unit)
  {}

  // Optimizes, one stage after the other: here, and in reach(), is all that decides whether one starts, when it has done
  // enough, and whether it is repeated. positions() are then the best found.
  Status run()
  {
    const bool is_full = parameters_.method == Method::FULL;
    // Interfaces cross the whole mesh (measured on a ball in a block: they end .087 edges off from a rectified start, and
    // .113 edges untangled where they are).
    const bool has_interface = boundary_samples().is_bounded() && !boundary_samples().is_bounded_everywhere();
    Reached reached = reach(parameters_.method == Method::RECTIFICATION || (is_full && has_interface) ? Start::RECTIFIED
                                                                                                      : Start::GIVEN);
    if (is_full && reached.start == Start::GIVEN && !control_.is_stopped() &&
        (boundary_samples().is_bounded_everywhere() ? is_held_down(reached.points) : are_some_off(reached.points))) {
      // what jams on its way from one start may come in from another
      Reached other = reach(Start::RECTIFIED);
      if (is_better(other.points, reached.points))
        reached = std::move(other);
    }
    if (is_full && boundary_samples().is_bounded_everywhere() && come_within_bound(reached))
      raise_within_bound(reached.points);
    if (is_full && is_left_as_it_was(reached.points) && !control_.is_stopped())
      try_unprotected(reached);

    if (is_full && may_spend_quality())
      spend_spare_quality(reached);

    const double excess_before = excess(model_.points), excess_now = excess(reached.points);
    samples_.reset();
    report_.certify(model_.in_coordinates(reached.points), excess_before, excess_now);
    Status& status = report_.status;
    status.return_code = control_.is_stopped() ? control_.return_code()
                                               : report_.return_code(reached.end == Stage_end::ITERATION_LIMIT
                                                                       ? Return_code::ITERATION_LIMIT
                                                                       : Return_code::CONVERGED);
    status.iterations = control_.iterations;
    status.total_seconds = control_.seconds();
    return status;
  }

  // In the coordinates and the order of the input.
  Positions positions() const { return mesh_.order.as_given(report_.positions()); }

private:
  enum class Start {
    GIVEN,    // what is inverted is untangled where it is: most vertices stay where they were
    RECTIFIED // all is brought into shape before
  };

  struct Reached
  {
    Positions points;
    Stage_end end = Stage_end::CONVERGED; // of the last stage that the points come from
    Start start;
  };

  // From the input through the stages that the method asks for. In a full run rectification takes over where untangling
  // fails.
  Reached reach(Start start)
  {
    const bool is_full = parameters_.method == Method::FULL;
    const double target = parameters_.target_quality;
    // In a full run rectification has done enough in any valid state, and where only a few hexahedra are inverted.
    const double enough = is_full ? (std::min)(0.0, target) : target;
    const std::size_t few = is_full ? static_cast<std::size_t>(parameters_.left_to_untangling *
                                                               double(mesh_.complex.hexahedra.size()))
                                    : 0;
    Reached reached{model_.points, Stage_end::CONVERGED, start};
    const std::size_t given = number_of_inverted(reached.points);
    if (is_full && start == Start::GIVEN && given > 0 && !control_.check_time()) {
      const double part = double(given) / double(mesh_.complex.hexahedra.size());
      const bool starts_harmonic = part > .5; // then the interior tells nothing
      if (starts_harmonic)
        reached.points = harmonic_positions();
      if ((starts_harmonic || part <= parameters_.untangled_as_given) && number_of_inverted(reached.points) > 0)
        reached.end = untangle(reached.points, Untangling::Attempt::FIRST);
      if (number_of_inverted(reached.points) > 0 && !control_.is_stopped())
        reached = {model_.points, Stage_end::CONVERGED, Start::RECTIFIED};
    }
    if (reached.start == Start::RECTIFIED && !control_.check_time())
      rectify_well(reached, enough, few);

    if (parameters_.method == Method::RECTIFICATION || control_.check_time())
      return reached;
    if (const std::size_t inverted = number_of_inverted(reached.points); inverted > 0) {
      reached.end = untangle(reached.points);
      if (is_full && inverted <= few && number_of_inverted(reached.points) > 0 && !control_.is_stopped()) {
        // those few are too much for untangling
        rectify(reached.points, enough, 0);
        reached.end = untangle(reached.points);
      }
    }
    const Mesh_quality quality(mesh_.complex, reached.points);
    // good angles off the reference are not what was asked for
    const bool is_good = quality.minimum >= target && standing_of(reached.points).is_good();
    if (quality.inverted == 0 && !is_good && !control_.is_stopped())
      reached.end = maximize(reached.points);
    return reached;
  }

  // Where a bound is not met: what does not come back within it does not leave it (measured on two organic models
  // bound to .1 % of their diagonals: they are beyond it by factors of 2.2 and 1.3 otherwise, and within it after this).
  // Whether the bound is shown to be met.
  bool come_within_bound(Reached& reached)
  {
    bool is_within = is_shown_within_bound(reached.points);
    const auto try_also = [&](const auto& reach_another_way) {
      if (control_.is_stopped() || is_within)
        return;
      Reached other = reach_another_way();
      attach(model_.attachment, false);
      is_within = Mesh_quality(mesh_.complex, other.points).invalid == 0 && is_shown_within_bound(other.points);
      if (is_within || is_better(other.points, reached.points))
        reached = std::move(other);
    };
    for (Start start : {Start::RECTIFIED, Start::GIVEN})
      try_also([&] {
        attach(model_.attachment, true);
        return reach(start);
      });
    if (!is_within && is_shown_within_bound(model_.points))
      try_also([&] { return reach_from_boundary(); });
    return is_within;
  }

  // By search, what maximization has not raised within a bound.
  void raise_within_bound(Positions& points)
  {
    const Timer timer(control_, report_.status.maximization_seconds);
    const double most = (std::min)(parameters_.maximization.floor.hold_limit, parameters_.target_quality);
    if (parameters_.boundary_placement == Boundary_placement::ON_SURFACE ||
        Mesh_quality(mesh_.complex, points).minimum >= most)
      return; // maximization has raised what stands exactly
    raise(points, most, [this](const Positions& raised) { return is_shown_within_bound(raised); });
  }

  template <class IsWithin>
  void raise(Positions& points, double limit, const IsWithin& is_within)
  {
    const Sliding held = sliding(points);
    Raising_within_bound(mesh_.complex, model_.targets.lengths, *model_.surface, model_.attachment, held,
                         boundary_samples(), parameters_.maximization.arrivals.search, parameters_.raising)
      .raise(
        limit, is_within, [this] { return control_.check_time(); }, points);
  }

  // Whether nothing was found, though there is much to gain.
  bool is_left_as_it_was(const Positions& points)
  {
    return points == model_.points && !boundary_samples().is_bounded_everywhere() &&
           parameters_.boundary_placement != Boundary_placement::ON_SURFACE && standing_of(points).is_good() &&
           Mesh_quality(mesh_.complex, points).minimum <
             (std::min)(parameters_.maximization.floor.hold_limit, parameters_.target_quality);
  }

  // A minimum that may not fall for a time can keep all from rising; search raises what has fallen behind at the end.
  void try_unprotected(Reached& reached)
  {
    const Mesh_quality before(mesh_.complex, reached.points);
    const Standing standing = standing_of(reached.points);
    Reached other = reached;
    other.end = maximize(other.points, Protection::NONE);
    const auto is_standing = [&](const Positions& points) { return !(standing < standing_of(points)); };
    const double gain = parameters_.least_gain_of_unprotected;
    if (Mesh_quality(mesh_.complex, other.points).minimum < before.minimum) {
      const Timer timer(control_, report_.status.maximization_seconds);
      raise(other.points, before.minimum + gain, is_standing);
    }
    const Mesh_quality after(mesh_.complex, other.points);
    if (is_standing(other.points) && after.minimum >= before.minimum &&
        (std::max)(after.minimum - before.minimum, after.average - before.average) >= gain)
      reached = std::move(other);
  }

  // Everywhere: samples keep to a little less than the bound, and see nothing between them.
  bool is_shown_within_bound(const Positions& points) const
  {
    return certified_deviation(model_.faces, points, *model_.surface, bound_, parameters_.certification).is_shown;
  }

  // The boundary stays as it is, which is within the bound, while the interior is brought into shape, and within the
  // bound from then on.
  Reached reach_from_boundary()
  {
    Boundary_attachment held = model_.attachment;
    for (std::size_t v = 0; v < held.kind.size(); ++v)
      if (mesh_.complex.is_on_boundary[v])
        held.kind[v] = Vertex_kind::FIXED;
    attach(held, true);
    Reached reached = reach(Start::GIVEN);
    attach(model_.attachment, true);
    if (number_of_inverted(reached.points) > 0 && !control_.is_stopped())
      reached.end = untangle(reached.points);
    if (number_of_inverted(reached.points) > 0 || control_.is_stopped())
      return reached;
    const Reached start = reached;
    reached.end = maximize(reached.points);
    return is_shown_within_bound(reached.points) || !is_shown_within_bound(start.points) ? reached : start;
  }

  // What all stages attach the boundary with from now on. stays_within: they do not loosen the bound for a time.
  void attach(const Boundary_attachment& attachment, bool stays_within)
  {
    attachment_ = &attachment;
    stays_within_ = stays_within;
    samples_.reset();
  }

  // From the interior that suits it better.
  void rectify_well(Reached& reached, double enough, std::size_t few)
  {
    const bool starts_harmonic = 2 * report_.status.before.number_of_inverted > mesh_.complex.hexahedra.size();
    if (starts_harmonic)
      reached.points = harmonic_positions();
    reached.end = rectify(reached.points, enough, few);
    const Mesh_quality quality(mesh_.complex, reached.points);
    const bool is_rectified = few > 0 ? quality.inverted <= few : quality.invalid == 0;
    if (is_rectified || starts_harmonic || control_.is_stopped())
      return;
    // what the given interior locks, another start may not
    Positions other = harmonic_positions();
    const Stage_end end_of_other = rectify(other, enough, few);
    if (number_of_inverted(other) < quality.inverted) {
      reached.points = std::move(other);
      reached.end = end_of_other;
    }
  }

  std::size_t number_of_inverted(const Positions& points) const { return Mesh_quality(mesh_.complex, points).inverted; }

  Standing standing_of(const Positions& points)
  {
    const Mesh_quality quality(mesh_.complex, points);
    return {quality.inverted, quality.invalid, excess(points), sliding(points).away(points)};
  }

  // Whether a bound is not met, or was at the cost of the quality that is worth holding without one.
  bool is_held_down(const Positions& points)
  {
    return excess(points) > 0 ||
           Mesh_quality(mesh_.complex, points).minimum < parameters_.maximization.floor.hold_limit;
  }

  // Whether all of the boundary is to be on the surface, and some of it is not, or not on its features (measured on an
  // organic model, with a least regularization of untangling of 3e-5: after the first start 3 vertices are not at their
  // places, after the second one, which is on the surface).
  bool are_some_off(const Positions& points) const
  {
    return parameters_.boundary_placement == Boundary_placement::ON_SURFACE && sliding(points).away(points).in_all > 0;
  }

  // Of two results.
  bool is_better(const Positions& first, const Positions& second)
  {
    const Standing a = standing_of(first), b = standing_of(second);
    return a < b ||
           (!(b < a) && Mesh_quality(mesh_.complex, first).minimum > Mesh_quality(mesh_.complex, second).minimum);
  }

  // Whether the boundary is brought to a reference of its own, and neither a bound nor a quality is asked for.
  bool may_spend_quality()
  {
    return boundary_samples().has_reference_of_its_own() && !std::isfinite(bound_) &&
           !std::isfinite(parameters_.target_quality);
  }

  // What quality there is to spare goes into the largest deviation.
  void spend_spare_quality(Reached& reached)
  {
    Mesh_quality quality(mesh_.complex, reached.points);
    if (quality.minimum < parameters_.spare_above)
      return;
    // nor may a mesh that came in as good as it is to be get worse
    const double least = (std::max)(parameters_.spare_above, standing_of(model_.points).is_good()
                                                               ? Mesh_quality(mesh_.complex, model_.points).minimum
                                                               : 0);
    double expected_loss = 0; // of the minimum
    for (std::size_t i = 0; i < parameters_.most_spared && !control_.check_time(); ++i) {
      const double largest =
        deviations(model_.faces, reached.points, *model_.surface, parameters_.measuring_spacing).all.maximum;
      if (quality.invalid > 0 || quality.minimum - expected_loss < least || excess(reached.points) > 0 ||
          largest < parameters_.boundary.samples.still_distance)
        break;
      bind(parameters_.spared_deviation * largest);
      Positions points = reached.points;
      maximize(points);
      const bool is_within = !(excess(points) > 0);
      bind(parameters_.maximum_deviation / model_.unit);
      const Mesh_quality spent(mesh_.complex, points);
      if (!is_within || spent.invalid > 0 || spent.minimum < least ||
          spent.average < quality.average - parameters_.spared_average)
        break;
      expected_loss = parameters_.growth_of_cost * (quality.minimum - spent.minimum);
      quality = spent;
      reached.points = std::move(points);
    }
  }

  // Bounds the deviation from now on. In mean boundary edges.
  void bind(double bound)
  {
    bound_ = bound;
    samples_.reset();
  }

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
    return Untangling(mesh_.complex, boundary_samples(), distance_energy(), model_.targets.lengths, held,
                      parameters_.untangling)
      .run(points, control_, attempt);
  }

  Stage_end maximize(Positions& points, Protection protection = Protection::OF_WHAT_IS_GOOD)
  {
    const Timer timer(control_, report_.status.maximization_seconds);
    Sliding held = sliding(points);
    return Quality_maximization(mesh_.complex, boundary_samples(), distance_energy(), model_.targets, model_.relations,
                                held, parameters_.maximization)
      .run(points, control_, parameters_.target_quality, protection);
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

  double excess(const Positions& points)
  {
    Boundary_samples& samples = boundary_samples();
    if (samples.has_tolerance())
      samples.update(points, 1);
    return samples.excess(points);
  }

  // What untangling finds of the boundary, maximization goes on with.
  Boundary_samples& boundary_samples()
  {
    // where all vertices are to be on the surface, those that are not are counted instead
    const bool has_tolerance = model_.reference_is_given &&
                               parameters_.boundary_placement != Boundary_placement::ON_SURFACE;
    if (!samples_) {
      Boundary_sample_parameters of_samples = parameters_.boundary.samples;
      if (stays_within_)
        of_samples.loosening = 0;
      samples_.emplace(mesh_.complex, model_.faces, *model_.surface, *attachment_, model_.targets.lengths,
                       has_tolerance, bound_, of_samples);
    }
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
  double bound_; // of the deviation, in mean boundary edges
  const Boundary_attachment* attachment_ = &model_.attachment;
  bool stays_within_ = false; // the bound, which may be loosened for a time otherwise
  std::optional<Boundary_samples> samples_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
