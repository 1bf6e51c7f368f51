// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_GLOBAL_STEP_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_GLOBAL_STEP_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The global step: vertex positions that reconcile the target directions of all
// cones, the regularization and the boundary (eq. 25), by penalty reweighting.

#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Rectification_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Reference_links.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Global_step
{
public:
  // All but is_fixed, of the vertices, must outlive the object.
  Global_step(const Hexahedral_complex& complex, const Edge_relations& relations, const Edge_cones& cones,
              const std::vector<char>& is_fixed, const Rectification_parameters& parameters)
    : complex_(complex)
    , relations_(relations)
    , cones_(cones)
    , parameters_(parameters)
    , system_(complex.number_of_vertices(), couplings(complex, relations))
    , edge_slots_(complex.edges.size())
    , vertex_edges_(
        complex.number_of_vertices(), 2 * complex.edges.size(),
        [&](std::size_t k) { return complex.edges[k / 2][k % 2]; }, [](std::size_t k) { return static_cast<int>(k); })
    , quadratic_(complex.edges.size())
    , linear_(complex.edges.size())
    , penalty_weight_(2 * complex.edges.size(), 1.0)
  {
    system_.is_fixed = is_fixed;
    system_.ties = complex.ties;
    for (std::size_t e = 0; e < edge_slots_.size(); ++e)
      edge_slots_[e] = {system_.slot(complex.edges[e][0], complex.edges[e][1]),
                        system_.slot(complex.edges[e][1], complex.edges[e][0])};
  }

  // The regularization (eq. 19) depends on the target lengths alone: assembled once for them.
  void set_target_lengths(const std::vector<double>& lengths)
  {
    lengths_ = lengths;
    std::fill(system_.diagonal.begin(), system_.diagonal.end(), 0.0);
    std::fill(system_.couplings().begin(), system_.couplings().end(), 0.0);
    add_relation(relations_.parallel, relations_.parallel_degree);
    add_relation(relations_.consecutive, relations_.consecutive_degree);
    regularization_diagonal_ = system_.diagonal;
    regularization_couplings_ = system_.couplings();
  }

  // Sets the quadratic boundary terms at the current positions (eq. 21), each
  // times the weight of its vertex, and the pull towards the current place
  // within the surface. feet: the points of the surface closest to the vertices on it.
  void set_boundary(const Reference_surface& surface, const Boundary_attachment& attachment,
                    const std::vector<Foot_point>& feet, const std::vector<double>& weight, double tangential_anchor,
                    const Positions& points)
  {
    boundary_blocks_.assign(points.size(), Matrix_3::Zero());
    boundary_right_.assign(points.size(), Vector_3::Zero());
    boundary_constant_ = 0;
    links_.clear();
    const double alpha = parameters_.feature_weight, beta = parameters_.surface_weight;
    for (std::size_t v = 0; v < points.size(); ++v) {
      Matrix_3 block = Matrix_3::Zero();
      Vector_3 place = Vector_3::Zero();
      switch (attachment.kind[v]) {
      case Vertex_kind::SURFACE: {
        const Foot_point& q = feet[v];
        place = q.point;
        block = beta * weight[v] * q.normal * q.normal.transpose();
        break;
      }
      case Vertex_kind::FEATURE: {
        const Curve_point q = surface.curves[attachment.curve[v]]->closest_point(points[v]);
        place = q.point;
        // minimizing over the auxiliary a of eq. 21 leaves this block
        const double a = alpha * weight[v];
        block = a * Matrix_3::Identity() - a * a / (1 + a) * q.tangent * q.tangent.transpose();
        break;
      }
      case Vertex_kind::CORNER:
        place = attachment.corner[v];
        block = alpha * weight[v] * Matrix_3::Identity();
        break;
      default:
        continue;
      }
      block += tangential_anchor * weight[v] * Matrix_3::Identity();
      boundary_blocks_[v] = block;
      boundary_right_[v] = block * place;
      boundary_constant_ += place.dot(boundary_right_[v]);
    }
  }

  // Adds |Σ w_k v_k − sample|² for reference samples that the boundary has left
  // behind, each with its own weight. Equal in all directions, so that it stays a
  // scalar coupling.
  void set_reference_pull(const std::vector<Reference_links::Link>& links, const std::vector<double>& weights)
  {
    links_ = links;
    link_weights_ = weights;
    for (std::size_t l = 0; l < links.size(); ++l) {
      for (int i = 0; i < 3; ++i)
        boundary_right_[links[l].vertices[i]] += weights[l] * links[l].weights[i] * links[l].sample;
      boundary_constant_ += weights[l] * links[l].sample.squaredNorm();
    }
  }

  // One global step with its penalty iterations, for the lengths, the boundary and the pull set before. worst_cosine:
  // of all cones in eq. 27, and 0 makes eq. 16 of it. Returns the energy of eq. 25.
  double minimize(const std::vector<Target_direction>& targets, double worst_cosine, Positions& points)
  {
    worst_cosine_ = worst_cosine;
    std::fill(penalty_weight_.begin(), penalty_weight_.end(), 1.0);
    std::vector<double> start_length(complex_.edges.size()); // |e| at the beginning of the step
    for (std::size_t e = 0; e < start_length.size(); ++e)
      start_length[e] = edge_vector(points, 2 * static_cast<int>(e)).norm();
    double energy = 0;
    for (int iteration = 0; iteration < parameters_.penalty_iterations; ++iteration) {
      assemble(targets, start_length);
      const Positions before = points;
      system_.solve(points, parameters_.solver_tolerance, parameters_.solver_iterations);
      energy = system_.energy(points) + constant_;
      update_penalty_weights(targets, points);
      if (largest_move(before, points) < parameters_.convergence)
        break;
    }
    return energy;
  }

  static double largest_move(const Positions& a, const Positions& b)
  {
    double largest = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
      largest = (std::max)(largest, (a[v] - b[v]).squaredNorm());
    return std::sqrt(largest);
  }

  Vector_3 edge_vector(const Positions& points, int directed) const
  {
    return points[complex_.target(directed)] - points[complex_.source(directed)];
  }

private:
  static std::vector<std::array<int, 2>> couplings(const Hexahedral_complex& complex, const Edge_relations& relations)
  {
    std::vector<std::array<int, 2>> result;
    result.reserve(28 * complex.hexahedra.size() + 4 * relations.consecutive.size());
    const auto couple = [&](int a, int b) {
      if (a != b)
        result.push_back({(std::min)(a, b), (std::max)(a, b)});
    };
    for (const Hexahedron& h : complex.hexahedra)
      for (int i = 0; i < 8; ++i)
        for (int j = 0; j < i; ++j)
          couple(h[i], h[j]);
    for (const Edge_pair& p : relations.consecutive)
      for (int a : complex.edges[p.first / 2])
        for (int b : complex.edges[p.second / 2])
          couple(a, b);
    return result;
  }

  void add_relation(const std::vector<Edge_pair>& pairs, const std::vector<int>& degree)
  {
    for (const Edge_pair& p : pairs) {
      const int e = p.first / 2, f = p.second / 2;
      const double weight = parameters_.regularization_weight * (1.0 / degree[e] + 1.0 / degree[f]);
      const int vertex[4] = {complex_.target(p.first), complex_.source(p.first), complex_.target(p.second),
                             complex_.source(p.second)};
      const double factor[4] = {1 / lengths_[e], -1 / lengths_[e], -1 / lengths_[f], 1 / lengths_[f]};
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          if (vertex[i] == vertex[j])
            system_.diagonal[vertex[i]] += weight * factor[i] * factor[j];
          else
            system_.couplings()[system_.slot(vertex[i], vertex[j])] += weight * factor[i] * factor[j];
    }
  }

  double normalization(int e, double start_length) const { return (start_length + lengths_[e]) / 2; }

  // eq. 16 and 27
  double angle_weight(double cosine) const
  {
    const double x = (cosine - worst_cosine_) / parameters_.angle_weight_sigma;
    return 1 + parameters_.angle_weight_amplitude * std::exp(-x * x / 2);
  }

  double penalty_factor(const Target_direction& target, int directed) const
  {
    if (!target.is_valid())
      return 0;
    return angle_weight(target.worst_cosine) * penalty_weight_[directed];
  }

  void assemble(const std::vector<Target_direction>& targets, const std::vector<double>& start_length)
  {
    for_ranges(regularization_couplings_.size(), [&](std::size_t begin, std::size_t end) {
      std::copy(regularization_couplings_.begin() + begin, regularization_couplings_.begin() + end,
                system_.couplings().begin() + begin);
    });
    system_.blocks = boundary_blocks_;
    constant_ = boundary_constant_ + sum_of_ranges(complex_.edges.size(), [&](std::size_t begin, std::size_t end) {
                  double sum = 0;
                  for (std::size_t e = begin; e < end; ++e)
                    sum += set_edge(e, targets, start_length[e]);
                  return sum;
                });
    for_each(system_.size(), [&](std::size_t v) {
      double& diagonal = system_.diagonal[v] = regularization_diagonal_[v];
      Vector_3& right = system_.right[v] = boundary_right_[v];
      for (int k : vertex_edges_[v]) {
        diagonal += quadratic_[k / 2];
        right += k % 2 ? linear_[k / 2] : Vector_3(-linear_[k / 2]);
      }
    });
    for (std::size_t l = 0; l < links_.size(); ++l)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const Triangle_indices& vertices = links_[l].vertices;
          const double value = link_weights_[l] * links_[l].weights[i] * links_[l].weights[j];
          if (i == j)
            system_.diagonal[vertices[i]] += value;
          else
            system_.couplings()[system_.slot(vertices[i], vertices[j])] += value;
        }
  }

  // The terms of the cones around both directions of an edge. Returns what they add to the energy whatever the
  // positions.
  double set_edge(std::size_t e, const std::vector<Target_direction>& targets, double start_length)
  {
    const double length = lengths_[e], scale = normalization(static_cast<int>(e), start_length);
    double quadratic = 0, constant = 0;
    Vector_3 linear = Vector_3::Zero();
    for (int side = 0; side < 2; ++side) {
      const int directed = 2 * static_cast<int>(e) + side;
      const double count = parameters_.cone_weight * double(cones_.triangles(directed).size());
      const double factor = parameters_.cone_weight * penalty_factor(targets[directed], directed);
      const Vector_3 pull = parameters_.cone_weight / length * cones_.normal_sum(directed) +
                            factor / scale * targets[directed].direction;
      quadratic += count / (length * length) + factor / (scale * scale);
      linear += side == 0 ? pull : Vector_3(-pull);
      constant += count + factor;
    }
    system_.couplings()[edge_slots_[e][0]] -= quadratic;
    system_.couplings()[edge_slots_[e][1]] -= quadratic;
    quadratic_[e] = quadratic;
    linear_[e] = linear;
    return constant;
  }

  // eq. 15, with the difference of unit vectors: with the length normalization of
  // eq. 14 an edge much longer than its target would lose the upper bound of 2 that the
  // scheme rests on, and the weights of tangled inputs would explode.
  void update_penalty_weights(const std::vector<Target_direction>& targets, const Positions& points)
  {
    for_each(penalty_weight_.size(), [&](std::size_t directed) {
      const Vector_3 e = edge_vector(points, static_cast<int>(directed));
      const double length = e.norm();
      if (length == 0)
        return;
      const double difference = (e / length - targets[directed].direction).squaredNorm();
      penalty_weight_[directed] = (std::max)(penalty_weight_[directed], difference * difference * difference);
    });
  }

  const Hexahedral_complex& complex_;
  const Edge_relations& relations_;
  const Edge_cones& cones_;
  const Rectification_parameters& parameters_;
  Vertex_system system_;
  std::vector<std::array<std::size_t, 2>> edge_slots_;
  const Grouped_array vertex_edges_; // 2 e + end
  std::vector<double> quadratic_;    // of the cones of each edge
  Positions linear_;
  std::vector<double> penalty_weight_, lengths_;
  std::vector<double> regularization_diagonal_, regularization_couplings_;
  std::vector<Matrix_3> boundary_blocks_;
  Positions boundary_right_;
  std::vector<Reference_links::Link> links_;
  std::vector<double> link_weights_;
  double boundary_constant_ = 0, constant_ = 0, worst_cosine_ = 0;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_GLOBAL_STEP_H
