// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MAXIMIZATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MAXIMIZATION_H

// Newton's method on the scaled Jacobians of all corners, with a floor that rises
// ahead of the worst one, from a mesh without inverted hexahedra.

#include <CGAL/Hex_mesh_optimization/internal/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/Surface_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/corner_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/deviation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

class Quality_maximization
{
public:
  // Positions are in units of the mean boundary edge; lengths are the targets of the edges.
  Quality_maximization(const Hexahedral_complex& complex, const Reference_surface& surface, const Boundary_attachment& attachment,
                       const std::vector<double>& lengths, const Maximization_parameters& parameters)
    : complex_(complex)
    , parameters_(parameters)
    , attachment_(complex, surface, attachment, parameters.edge_sample_weight, parameters.reference_spacing)
    , matrix_(complex)
    , lengths_(lengths)
    , is_fixed_(complex.number_of_vertices())
    , multiplier_(complex.number_of_vertices(), parameters.start_multiplier)
  {
    scale_ = parameters.attachment_scale * bounding_box_diagonal(surface);
    for (std::size_t v = 0; v < is_fixed_.size(); ++v)
      is_fixed_[v] = attachment.kind[v] == Vertex_kind::FIXED;
  }

  void run(Positions& points, Run_control& control, double target_quality)
  {
    Mesh_quality quality(complex_, points);
    if (quality.inverted > 0)
      return;
    Positions best = points;
    double best_minimum = quality.minimum;
    std::size_t best_invalid = quality.invalid;
    double highest = quality.minimum, highest_average = quality.average;
    std::size_t progress = 0; // the last iteration that brought some
    for (std::size_t i = 0; i < parameters_.iterations && !control.is_stopped(); ++i) {
      floor_ = floor_above(quality);
      attachment_.update(points, quality.minimum > .1, parameters_.pull_tolerance, parameters_.pull_weight);
      adapt_multipliers(quality, points);
      const double energy = step(points);
      quality = Mesh_quality(complex_, points);
      if (quality.invalid < best_invalid || (quality.invalid == best_invalid && quality.minimum >= best_minimum - .02)) {
        best = points;
        best_minimum = (std::max)(best_minimum, quality.minimum);
        best_invalid = quality.invalid;
      }
      if (quality.minimum > highest + parameters_.least_gain_of_minimum) {
        highest = quality.minimum;
        progress = i;
      }
      if (quality.average > highest_average + parameters_.least_gain_of_average) {
        highest_average = quality.average;
        progress = i;
      }
      control.after_iteration(Stage::MAXIMIZATION, i, energy, quality);
      if (i - progress >= parameters_.patience)
        break;
      if (quality.invalid == 0 && quality.minimum >= target_quality)
        break;
    }
    points = std::move(best);
  }

private:
  // The floor stands above the worst corner, but no higher than a given part of the hexahedra lies: where the
  // connectivity makes many of them poor, lifting all of those would cost the average.
  double floor_above(const Mesh_quality& quality) const
  {
    std::vector<double> sorted = quality.scaled_jacobians;
    const std::size_t rank = static_cast<std::size_t>(parameters_.floor_fraction * sorted.size());
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    return (std::min)({parameters_.floor_limit, sorted[rank], quality.minimum + parameters_.floor_step});
  }

  // f(s) of one corner besides the norm over the hexahedron: barrier and floor.
  double corner_energy(double s) const
  {
    const double below = (std::max)(0.0, floor_ - s);
    return -parameters_.barrier_weight * std::log(s) + parameters_.floor_weight / 2 * below * below;
  }

  double hexahedron_energy(const Positions& points, const Hexahedron& h, std::size_t index) const
  {
    double sum = 0, norm = 0;
    for (int c = 0; c < 8; ++c) {
      const Corner corner = corner_at(points, h, c);
      if (!(corner.scaled_jacobian > 0))
        return std::numeric_limits<double>::infinity();
      double target[3];
      target_lengths(index, c, target);
      sum += corner_energy(corner.scaled_jacobian) + parameters_.shape_weight * mean_ratio(corner, target);
      norm += std::pow(1 - corner.scaled_jacobian + parameters_.norm_offset, parameters_.norm_exponent);
    }
    return sum + 8 * std::pow(norm / 8, 1 / parameters_.norm_exponent);
  }

  Corner corner_at(const Positions& points, const Hexahedron& h, int c) const
  {
    const Vector_3& p = points[h[c]];
    return Corner(points[h[corner_neighbors[c][0]]] - p, points[h[corner_neighbors[c][1]]] - p, points[h[corner_neighbors[c][2]]] - p);
  }

  void target_lengths(std::size_t h, int c, double* target) const
  {
    for (int k = 0; k < 3; ++k)
      target[k] = lengths_[complex_.hexahedron_edges[h][corner_edges[c][k] / 2] / 2];
  }

  // Grows with the sixth power of the distance up to five times the scale, to keep the maximum of the deviation low, and
  // with the square beyond, so that a sample whose target jumps does not outweigh everything else.
  double sample_energy(double squared_distance) const
  {
    const double x = squared_distance / (scale_ * scale_), knee = 25;
    const double y = (std::min)(x, knee);
    return parameters_.attachment_weight * (y * (1 + y * y / 625) + 4 * (x - y));
  }

  double sample_factor(const Attachment_sample& s) const
  {
    double multiplier = std::numeric_limits<double>::infinity();
    for (int k = 0; k < s.count; ++k)
      multiplier = (std::min)(multiplier, multiplier_[s.vertices[k]]);
    return s.weight * multiplier;
  }

  double energy(const Positions& points) const
  {
    double sum = 0;
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h) {
      sum += hexahedron_energy(points, complex_.hexahedra[h], h);
      if (!std::isfinite(sum))
        return std::numeric_limits<double>::infinity();
    }
    for (const Attachment_sample& s : attachment_.samples)
      sum += sample_factor(s) * sample_energy(s.offset(points).squaredNorm());
    return sum;
  }

  void assemble(const Positions& points, Positions& gradient)
  {
    matrix_.set_zero();
    gradient.assign(points.size(), Vector_3::Zero());
    const double p = parameters_.norm_exponent;
    Corner_derivatives d;
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h) {
      const Hexahedron& hex = complex_.hexahedra[h];
      double norm = 0, base[8];
      for (int c = 0; c < 8; ++c) {
        base[c] = 1 - corner_at(points, hex, c).scaled_jacobian + parameters_.norm_offset;
        norm += std::pow(base[c], p);
      }
      const double outer = std::pow(norm / 8, 1 / p - 1);
      for (int c = 0; c < 8; ++c) {
        const Corner corner = corner_at(points, hex, c);
        const double s = corner.scaled_jacobian, below = (std::max)(0.0, floor_ - s);
        const double f1 = -outer * std::pow(base[c], p - 1) - parameters_.barrier_weight / s - parameters_.floor_weight * below;
        const double f2 = outer * (p - 1) * std::pow(base[c], p - 2) + parameters_.barrier_weight / (s * s) +
                          (below > 0 ? parameters_.floor_weight : 0);
        double target[3];
        target_lengths(h, c, target);
        corner_derivatives(corner, f1, f2, parameters_.shape_weight, target, d);
        const int center = hex[c];
        Matrix_3 total = Matrix_3::Zero();
        Matrix_3 row[3] = {Matrix_3::Zero(), Matrix_3::Zero(), Matrix_3::Zero()};
        for (int i = 0; i < 3; ++i) {
          const int a = hex[corner_neighbors[c][i]];
          gradient[a] += d.gradient[i];
          gradient[center] -= d.gradient[i];
          for (int j = i; j < 3; ++j) {
            matrix_.add(a, hex[corner_neighbors[c][j]], d.hessian[i][j]);
            row[i] += d.hessian[i][j];
            if (i != j)
              row[j] += d.hessian[i][j].transpose();
          }
        }
        for (int i = 0; i < 3; ++i) {
          matrix_.add(hex[corner_neighbors[c][i]], center, -row[i]);
          total += row[i];
        }
        matrix_.add(center, center, total);
      }
    }
    const double e = scale_ * scale_;
    for (const Attachment_sample& s : attachment_.samples) {
      const Vector_3 offset = s.offset(points);
      const double x = offset.squaredNorm() / e, factor = sample_factor(s) * parameters_.attachment_weight * 2 / e;
      // derivative of the energy by the offset, and its growth along the offset
      const bool is_near = x < 25;
      const double slope = factor * (is_near ? 1 + 3 * x * x / 625 : 4);
      const double growth = is_near && x > 0 ? factor * 12 * x * x / 625 / offset.squaredNorm() : 0;
      const Matrix_3 hessian = slope * s.projector + growth * offset * offset.transpose();
      for (int i = 0; i < s.count; ++i) {
        gradient[s.vertices[i]] += slope * s.shares[i] * offset;
        for (int j = 0; j <= i; ++j)
          matrix_.add(s.vertices[i], s.vertices[j], s.shares[i] * s.shares[j] * hessian);
      }
    }
  }

  // One Newton step with line search. Returns the energy reached.
  double step(Positions& points)
  {
    Positions gradient, direction;
    assemble(points, gradient);
    for (Vector_3& g : gradient)
      g = -g;
    solver_iterations += matrix_.solve(gradient, is_fixed_, parameters_.solver_tolerance, parameters_.solver_iterations, direction);
    double slope = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
      slope -= gradient[v].dot(direction[v]);
    const double start = energy(points);
    Positions trial(points.size());
    double t = 1;
    for (int i = 0; i < parameters_.line_search_steps; ++i, t /= 2) {
      for (std::size_t v = 0; v < points.size(); ++v)
        trial[v] = points[v] + t * direction[v];
      const double reached = energy(trial);
      if (reached <= start + parameters_.armijo * t * slope) {
        points.swap(trial);
        return reached;
      }
    }
    return start;
  }

  // The attachment of a vertex gives way where quality lags behind the floor and deviation is left to spend; it
  // tightens where the deviation is above the budget, or where the quality does not need it.
  void adapt_multipliers(const Mesh_quality& quality, const Positions& points)
  {
    std::vector<double> deviation(points.size(), 0.0);
    for (const Attachment_sample& s : attachment_.samples) {
      const double d = s.offset(points).norm();
      for (int k = 0; k < s.count; ++k)
        deviation[s.vertices[k]] = (std::max)(deviation[s.vertices[k]], d);
    }
    const double relax = (std::min)(floor_ - parameters_.relaxed_step, parameters_.relaxed_quality);
    for (std::size_t v = 0; v < points.size(); ++v)
      if (complex_.is_on_boundary[v]) {
        const double q = quality.worst_around(complex_, static_cast<int>(v));
        double& m = multiplier_[v];
        // the more of the budget is overdrawn, the poorer a hexahedron must be to draw more
        const double wanted = relax * (std::min)(1.0, std::sqrt(parameters_.deviation_budget / (std::max)(deviation[v], 1e-9)));
        if (deviation[v] > parameters_.demotion_distance && attachment_.demote(static_cast<int>(v)))
          m = parameters_.start_multiplier;
        else if (q < wanted) {
          m = (std::max)(m * parameters_.relaxation, parameters_.least_multiplier);
          if (m < parameters_.demotion_multiplier && attachment_.demote(static_cast<int>(v)))
            m = parameters_.start_multiplier;
        }
        else if (q > wanted + parameters_.relaxed_margin)
          m = (std::min)(m * parameters_.tightening, parameters_.largest_multiplier);
      }
  }

  const Hexahedral_complex& complex_;
  const Maximization_parameters parameters_;
  Surface_attachment attachment_;
  Block_matrix matrix_;
  const std::vector<double> lengths_;
  std::vector<char> is_fixed_;
  std::vector<double> multiplier_;
  double scale_;
  double floor_ = 0;
  long solver_iterations = 0;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_QUALITY_MAXIMIZATION_H
