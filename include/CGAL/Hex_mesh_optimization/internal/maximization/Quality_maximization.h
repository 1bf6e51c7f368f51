// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H

// Newton's method on the energy of all hexahedra and of the attachment, from a
// mesh without inverted corners: the worst corners climb while the boundary is
// loosely attached, then the attachment tightens while they are held.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/hold_back.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/newton_step.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

class Quality_maximization
{
public:
  // Positions are in units of the mean boundary edge; lengths are the targets of the edges. With relations they are only
  // estimates and may be adapted; without (null) they are kept. All but the numbers must outlive the object.
  Quality_maximization(const Hexahedral_complex& complex, Surface_attachment& attachment, const std::vector<double>& lengths,
                       const Edge_relations* relations, const std::vector<char>& is_fixed, const Maximization_parameters& parameters)
    : complex_(complex)
    , parameters_(parameters)
    , attachment_(attachment)
    , relations_(relations)
    , matrix_(vertex_couplings(complex))
    , assembly_(complex, matrix_)
    , energy_(parameters)
    , hexahedra_(complex)
    , floor_(hexahedra_, parameters)
    , inverse_targets_(complex.hexahedra.size())
    , is_fixed_(is_fixed)
    , lengths_(lengths)
  {
    set_inverse_targets();
  }

  // Improves points until nothing is gained any more or control ends the run; leaves in them the best state met.
  // Does nothing if a hexahedron is inverted.
  void run(Positions& points, Run_control& control, double target_quality)
  {
    Mesh_quality quality(complex_, points);
    if (quality.inverted > 0 || (quality.invalid == 0 && quality.minimum >= target_quality))
      return;
    Best best{points, quality.invalid, quality.minimum, 0, 0, quality.invalid == 0 ? quality.minimum : -1};
    Progress climb(quality, parameters_.climbing_gain, parameters_.climbing_change_of_average), settling = climb;
    bool tightens = false;
    std::size_t waited = 0, settled = 0;
    attachment_.tightness = parameters_.start_tightness;
    for (std::size_t i = 0; !control.is_stopped(); ++i) {
      const bool is_high = quality.minimum >= floor_.worth_holding(quality) &&
                           climb.iterations_without_change_of_average() >= parameters_.climbing_patience_for_average;
      const bool is_done = is_high || climb.iterations_without_gain_of_minimum() >= parameters_.climbing_patience;
      if (!tightens && (is_done || i == parameters_.climbing_iterations)) {
        tightens = true;
        energy_.set_shape_factor(parameters_.shape_balance / (parameters_.shape_balance_offset + 1 - quality.average));
        if (relations_)
          adapt_lengths(points);
      }
      if (!tightens)
        floor_.rise(quality);
      else {
        floor_.hold(quality, points, (std::max)(best.least_minimum, 0.0));
        // it waits for corners that fell behind, but not for ever
        if (quality.minimum >= parameters_.ready * floor_.held() || ++waited > parameters_.waiting_patience) {
          attachment_.tightness = (std::min)(1.0, attachment_.tightness * parameters_.tightening);
          waited = 0;
        }
      }
      attachment_.update(points);
      const double energy = newton_step([this](const Positions& p) { return value(p); },
                                        [this](const Positions& p, Positions& g, Block_matrix& m) { assemble(p, g, m); },
                                        [&](Positions& d) { hold_back(complex_, hexahedra_, points, least_scaled_jacobians(quality), parameters_.holding_rounds, d); },
                                        is_fixed_, parameters_.newton, matrix_, points);
      quality = Mesh_quality(complex_, points);
      const double excess = (std::max)(0.0, attachment_.largest_distance(points) - parameters_.maximum_deviation);
      best.offer(points, quality, attachment_.tightness, excess, parameters_.accepted_loss);
      climb.add(quality);
      if (attachment_.tightness < 1)
        settling = Progress(quality, parameters_.least_gain_of_minimum, parameters_.least_change_of_average);
      else
        settling.add(quality);
      control.after_iteration(Stage::MAXIMIZATION, i, energy, quality);
      const bool is_held = best.minimum >= parameters_.held_closely * floor_.held();
      if (attachment_.tightness == 1 && ++settled >= (is_held ? parameters_.settling_iterations : parameters_.longest_settling_iterations))
        break;
      if (excess > 0)
        continue;
      if (is_held && settling.iterations_without_change() >= parameters_.patience)
        break;
      if (attachment_.tightness == 1 && quality.invalid == 0 && quality.minimum >= target_quality)
        break;
    }
    points = std::move(best.points);
  }

private:
  // Tighter states win, of equally tight ones that with less deviation in excess of the bound, then the latest whose
  // minimum does not fall behind.
  struct Best
  {
    Positions points;
    std::size_t invalid;
    double minimum, tightness, excess;
    double least_minimum; // of a valid mesh that came in, -1 for one that was not valid

    void offer(const Positions& candidate, const Mesh_quality& quality, double tight, double more, double accepted_loss)
    {
      if (quality.invalid > invalid || quality.minimum < least_minimum)
        return;
      // what was valid is left as it was rather than far from the surface
      if (tight < 1 && least_minimum >= 0)
        return;
      if (quality.invalid == invalid && tight == tightness && more > excess)
        return;
      const bool is_equal = quality.invalid == invalid && tight == tightness && more == excess;
      if (is_equal && quality.minimum < minimum - accepted_loss)
        return;
      points = candidate;
      minimum = is_equal ? (std::max)(minimum, quality.minimum) : quality.minimum;
      invalid = quality.invalid;
      tightness = tight;
      excess = more;
    }
  };

  // For how long the minimum has not gained, and the average not changed, by anything to speak of. While the attachment
  // settles the average falls.
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
    static constexpr double relative_gain = .1;

    double minimum_, average_, gain_of_minimum_, change_of_average_;
    std::size_t since_minimum_ = 0, since_average_ = 0;
  };

  // What no corner of each hexahedron may drop below in the next step.
  Batched_values<1> least_scaled_jacobians(const Mesh_quality& quality) const
  {
    const double level = floor_.held() > 0 ? floor_.held() : quality.minimum;
    Batched_values<1> least(quality.scaled_jacobians.size());
    for (std::size_t h = 0; h < quality.scaled_jacobians.size(); ++h)
      least.set(h, 0, parameters_.least_part_of_corner * (std::min)(level, quality.scaled_jacobians[h]));
    return least;
  }

  // Moves the target lengths of the interior towards those that the loosely attached mesh has found to suit it: smoothly, so that they
  // follow the shape of the model and not of single poor hexahedra.
  void adapt_lengths(const Positions& points)
  {
    const std::vector<double> reached = smooth_edge_lengths(*relations_, edge_lengths(complex_, points));
    for (std::size_t e = 0; e < lengths_.size(); ++e)
      if (!complex_.is_boundary_edge[e])
        lengths_[e] *= std::pow(reached[e] / lengths_[e], parameters_.length_adaptation);
    set_inverse_targets();
  }

  void set_inverse_targets()
  {
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h)
      for (int k = 0; k < 12; ++k)
        inverse_targets_.set(h, k, 1 / lengths_[complex_.hexahedron_edges[h][k] / 2]);
  }

  double value(const Positions& points) const
  {
    const double sum = attachment_.energy(points);
    return sum + hexahedra_.sum([&](std::size_t i) {
      const Lanes values = energy_.value(hexahedra_.frame(i, points), inverse_targets_.batch(i), floor_.floors().batch(i));
      double of_batch = 0;
      for (int l = 0; l < hexahedra_.number_of_hexahedra(i); ++l)
        of_batch += lane(values, l);
      return of_batch;
    });
  }

  void assemble(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    hexahedra_.for_each_without_conflict([&](std::size_t i) {
      Hexahedron_derivatives<Lanes> d;
      energy_.derivatives(hexahedra_.frame(i, points), inverse_targets_.batch(i), floor_.floors().batch(i), d);
      hexahedra_.add(i, d, assembly_, gradient, matrix);
    });
    attachment_.add_derivatives(points, gradient, matrix);
  }

  const Hexahedral_complex& complex_;
  const Maximization_parameters parameters_;
  Surface_attachment& attachment_;
  const Edge_relations* relations_;
  Block_matrix matrix_;
  const Hexahedron_assembly assembly_;
  Hexahedron_energy energy_;
  const Hexahedron_batches hexahedra_;
  Quality_floor floor_;
  Batched_values<12> inverse_targets_; // of the edges
  const std::vector<char> is_fixed_;
  std::vector<double> lengths_;        // targets of the edges
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_QUALITY_MAXIMIZATION_H
