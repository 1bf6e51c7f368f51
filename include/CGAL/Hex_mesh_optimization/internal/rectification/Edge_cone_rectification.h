// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONE_RECTIFICATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONE_RECTIFICATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Algorithm 1 of "Practical Hex-Mesh Optimization via Edge-Cone Rectification"
// (Livesu, Sheffer, Vining, Tarini; SIGGRAPH 2015): local and global steps in
// turn, restarts with updated lengths, and the maximization of the worst cones.

#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Global_step.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hold_back.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Rectification_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Reference_links.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Edge_cone_rectification
{
public:
  // Positions are in units of the mean boundary edge; lengths are the targets. faces: of the complex, with the sheets of
  // the surface
  Edge_cone_rectification(const Hexahedral_complex& complex, const Edge_relations& relations,
                          const Surface_faces& faces, const Reference_surface& surface,
                          const Boundary_attachment& attachment, const std::vector<char>& is_fixed,
                          std::vector<double> lengths, const Rectification_parameters& parameters)
    : complex_(complex)
    , surface_(surface)
    , attachment_(attachment)
    , parameters_(parameters)
    , lengths_(std::move(lengths))
    , cones_(complex)
    , global_(complex, relations, cones_, is_fixed, parameters_)
    , links_(faces, surface, parameters.reference_spacing)
    , weights_(complex.number_of_vertices(), 1.0)
    , feet_(complex.number_of_vertices())
    , targets_(cones_.size())
  {}

  // Improves points until nothing moves, the target is reached or no more hexahedra are inverted than tolerated, or
  // control ends the run; leaves in them the best state met, the one that came in included.
  Stage_end run(Positions& points, Run_control& control, double target_quality, std::size_t tolerated = 0)
  {
    const Mesh_quality given(complex_, points);
    // later states lie closer to the surface
    Best_state best(points, given, parameters_.accepted_part_of_minimum, 0);
    iteration_ = 0;
    is_valid_ = given.invalid == 0;
    const auto is_enough = [&] {
      return best.reaches(target_quality) || (tolerated > 0 && best.inverted() <= tolerated);
    };
    bool used_up = false; // of what ran last
    for (std::size_t restart = 0; restart <= parameters_.restarts && !control.is_stopped(); ++restart) {
      global_.set_target_lengths(lengths_);
      used_up = true;
      for (std::size_t i = 0; i < parameters_.iterations; ++i) {
        const double anchor = parameters_.tangential_anchor * std::pow(parameters_.tangential_fade, double(i));
        const bool moved = iterate(points, anchor, best, control, false);
        used_up = !control.is_stopped() && moved && !is_enough();
        if (!used_up)
          break;
      }
      if (is_enough())
        break;
      if (restart < parameters_.restarts && !update_lengths(points))
        break;
    }
    if (parameters_.maximize_minimum_quality && best.invalid() == 0)
      used_up = !maximize_minimum(points, best, control, target_quality);
    points = best.points();
    return control.stage_end(used_up);
  }

private:
  // One local and one global step. False when nothing moved any more.
  bool iterate(Positions& points, double anchor, Best_state& best, Run_control& control, bool maximizing)
  {
    for_each(
      points.size(),
      [&](std::size_t v) {
        if (is_smooth(static_cast<int>(v)))
          feet_[v] = surface_.foot_point(points[v], feet_[v].triangle, attachment_.sheet[v]);
      },
      64);
    const double worst_cosine = local_step(points, maximizing);
    global_.set_boundary(surface_, attachment_, feet_, weights_, anchor, points);
    if (best.invalid() == 0)
      pull_reference(points);
    const Positions before = points;
    const double energy = global_.minimize(targets_, worst_cosine, points);
    if (is_valid_)
      hold_back_ruinous(before, points);
    const Mesh_quality quality(complex_, points);
    is_valid_ = quality.invalid == 0;
    adapt_weights(quality);
    best.offer(points, quality);
    control.after_iteration(Stage::RECTIFICATION, iteration_++, energy, points, quality);
    return Global_step::largest_move(before, points) >= parameters_.convergence;
  }

  // From a valid state, vertices whose move would make a hexahedron invalid, or would lose most of the quality of a
  // poor one, go only part of the way: otherwise single hexahedra keep flipping for ever.
  void hold_back_ruinous(const Positions& before, Positions& points) const
  {
    Positions step(points.size());
    for_each(step.size(), [&](std::size_t v) { step[v] = points[v] - before[v]; });
    hold_back(
      complex_, before, step, parameters_.hold_back_attempts, Last_resort::IN_LAST_TWO_ROUNDS,
      [&](const Positions& reached, std::vector<char>& is_ruined) {
        for_each(is_ruined.size(), [&](std::size_t h) {
          const Hexahedron_coordinates x = hexahedron_coordinates(reached, complex_.hexahedra[h]);
          const double q = scaled_jacobian(x);
          is_ruined[h] = q <= parameters_.hold_back_quality &&
                         (q < parameters_.hold_back_loss *
                                scaled_jacobian(hexahedron_coordinates(before, complex_.hexahedra[h])) ||
                          hexahedron_validity(x) != Validity::VALID);
        });
      },
      points);
  }

  // The pull gives way where the vertices had to be let go.
  void pull_reference(const Positions& points)
  {
    std::vector<Reference_links::Link> links;
    std::vector<double> weights;
    for (const Reference_links::Link& link : links_.update(points, 0)) {
      if (link.distance <= parameters_.pull_tolerance)
        continue;
      links.push_back(link);
      double weight = 1;
      for (int v : link.vertices)
        weight = (std::min)(weight, weights_[v]);
      weights.push_back(parameters_.pull_weight * weight * link.area);
    }
    global_.set_reference_pull(links, weights);
  }

  bool is_smooth(int v) const { return attachment_.kind[v] == Vertex_kind::SURFACE; }

  // Returns the cosine of the worst cone when maximizing, once all are valid, and else 0.
  double local_step(const Positions& points, bool maximizing)
  {
    cones_.update_normals(points);
    const double threshold = std::cos(parameters_.cone_angle_bound * CGAL_PI / 180);
    double worst_of_mesh = 1;
    for (double worst : results_of_ranges<double>(
           targets_.size(),
           [&](std::size_t begin, std::size_t end) {
             double worst_of_range = 1;
             for (std::size_t i = begin; i < end; ++i)
               worst_of_range = (std::min)(worst_of_range,
                                           set_target(static_cast<int>(i), points, threshold, maximizing));
             return worst_of_range;
           },
           256))
      worst_of_mesh = (std::min)(worst_of_mesh, worst);
    return maximizing ? (std::max)(0.0, worst_of_mesh) : 0;
  }

  // Decides for one cone. Returns the worst cosine that it has now, when maximizing.
  double set_target(int directed, const Positions& points, double threshold, bool maximizing)
  {
    Vector_3 normal = Vector_3::Zero();
    double surface_weight = 0;
    // an edge at a feature lies in no one tangent plane
    if (complex_.is_boundary_edge[directed / 2] && is_smooth(complex_.source(directed)) &&
        is_smooth(complex_.target(directed))) {
      normal = feet_[complex_.source(directed)].normal + feet_[complex_.target(directed)].normal;
      if (normal.norm() > parameters_.opposite_normals) {
        normal.normalize();
        surface_weight = parameters_.direction_surface_weight;
      }
    }
    const Vector_3 edge = global_.edge_vector(points, directed);
    double wanted = threshold, worst = 1;
    if (maximizing) {
      const double current = cones_.worst_cosine(directed, edge.normalized());
      worst = current;
      if (current > threshold && current < parameters_.sufficient_quality)
        wanted = current + parameters_.minimum_quality_step; // eq. 26
    }
    const Target_direction target = target_direction(cones_, directed, edge, wanted, surface_weight, normal);
    // no room for a better axis: the previous target stays (Section 3.6)
    if (!maximizing || target.worst_cosine >= wanted - 1e-9 || !targets_[directed].is_valid())
      targets_[directed] = target;
    else
      targets_[directed].worst_cosine = cones_.worst_cosine(directed, targets_[directed].direction);
    return worst;
  }

  void adapt_weights(const Mesh_quality& quality)
  {
    for (std::size_t v = 0; v < weights_.size(); ++v)
      if (complex_.is_on_boundary[v]) {
        const double q = quality.worst_around(complex_, static_cast<int>(v));
        if (q < parameters_.wanted_quality)
          weights_[v] = (std::max)(weights_[v] * parameters_.weight_relaxation, parameters_.least_weight);
        else if (q > parameters_.wanted_quality + parameters_.wanted_margin)
          weights_[v] = (std::min)(weights_[v] * parameters_.weight_tightening, parameters_.largest_weight);
      }
  }

  // False when the targets stay, so that a restart would change nothing.
  bool update_lengths(const Positions& points)
  {
    if (parameters_.length_update == Edge_length_update::NONE)
      return false;
    if (parameters_.length_update == Edge_length_update::SELECTIVE)
      update_edge_lengths(complex_, points, Mesh_quality(complex_, points).scaled_jacobians,
                          parameters_.length_update_sigma, lengths_);
    else
      lengths_ = edge_lengths(complex_, points);
    double mean = 0;
    for (double l : lengths_)
      mean += l;
    mean /= double(lengths_.size());
    for (double& l : lengths_)
      l = (std::max)(l, parameters_.least_length * mean);
    return true;
  }

  // Section 3.6. Stops when the worst cone of the mesh no longer improves; false if the iterations are used up before.
  bool maximize_minimum(Positions& points, Best_state& best, Run_control& control, double target_quality)
  {
    points = best.points();
    is_valid_ = true;
    double highest = best.minimum();
    std::size_t since = 0;
    for (std::size_t i = 0; i < parameters_.maximization_iterations && since < parameters_.maximization_patience; ++i) {
      if (control.check_time() || best.reaches(target_quality))
        return true;
      const bool moved = iterate(points, 0, best, control, true);
      ++since;
      if (best.minimum() > highest + parameters_.maximization_gain) {
        highest = best.minimum();
        since = 0;
      }
      if (control.is_stopped() || !moved)
        return true;
    }
    return since >= parameters_.maximization_patience;
  }

  const Hexahedral_complex& complex_;
  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  const Rectification_parameters parameters_;
  std::vector<double> lengths_;
  Edge_cones cones_;
  Global_step global_;
  Reference_links links_;
  std::vector<double> weights_;
  std::vector<Foot_point> feet_; // of the vertices on the smooth surface
  std::vector<Target_direction> targets_;
  std::size_t iteration_ = 0;
  bool is_valid_ = false;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONE_RECTIFICATION_H
