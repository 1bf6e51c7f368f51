// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The global step against eq. 25 of the paper, summed term by term.

#include <CGAL/Hex_mesh_optimization/internal/rectification/Global_step.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../Generated_mesh.h"
#include "../numerical_gradient.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

template <class Energy>
Eigen::MatrixXd hessian(const Energy& energy, std::size_t number_of_points)
{
  const Positions origin(number_of_points, Vector_3::Zero());
  const Eigen::VectorXd at_origin = gradient(energy, origin);
  Eigen::MatrixXd result(3 * number_of_points, 3 * number_of_points);
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    Positions p = origin;
    p[i / 3][i % 3] = 1;
    result.col(i) = gradient(energy, p) - at_origin;
  }
  return result;
}

std::vector<Foot_point> feet_on(const Reference_surface& surface, const Positions& points)
{
  std::vector<Foot_point> feet;
  for (const Vector_3& p : points)
    feet.push_back(surface.foot_point(p));
  return feet;
}

// A mesh with positions that are all over the place, and everything that the
// global step is given.
struct Setting
{
  Positions regular, tangled;
  Hexahedral_complex complex;
  Edge_relations relations;
  Edge_cones cones;
  std::unique_ptr<Reference_surface> surface;
  std::unique_ptr<Boundary_attachment> attachment;
  std::vector<Target_direction> targets;
  std::vector<double> lengths, weights;
  Rectification_parameters parameters;
  double anchor = 0;
  std::vector<Reference_links::Link> links;
  std::vector<double> link_weights;
  double worst_cosine = 0;

  template <class Make>
  Setting(unsigned int seed, Make make) : Setting(seed, Generated_mesh::generated(make))
  {}

  Setting(unsigned int seed, const std::pair<Positions, std::vector<Hexahedron>>& mesh)
    : regular(mesh.first)
    , complex(regular.size(), mesh.second)
    , relations(complex)
    , cones(complex)
  {
    std::mt19937 random(seed);
    surface = boundary_as_reference(complex, regular, Feature_parameters{60});
    attachment = std::make_unique<Boundary_attachment>(attach_to_own_boundary(complex, *surface));
    tangled = moved(regular, random, .4);
    cones.update_normals(tangled);
    std::uniform_real_distribution<double> uniform(.5, 1.5);
    for (std::size_t e = 0; e < complex.edges.size(); ++e)
      lengths.push_back(uniform(random));
    weights.assign(regular.size(), 1.0);
    // valid and invalid targets, tight and wide cones
    for (std::size_t d = 0; d < cones.size(); ++d) {
      Target_direction target;
      target.direction = random_vector(random, 1).normalized();
      target.worst_cosine = uniform(random) - .7;
      targets.push_back(target);
    }
    parameters.penalty_iterations = 1;
    parameters.solver_tolerance = 1e-12;
    parameters.solver_iterations = 100000;
  }

  // Eq. 5: over directed edges and the triangles of their cones. The cone of an
  // edge is gathered from the hexahedra, not asked of Edge_cones.
  double cone_energy(const Positions& x) const
  {
    double sum = 0;
    for (const Hexahedron& h : complex.hexahedra)
      for (int corner = 0; corner < 8; ++corner)
        for (int k = 0; k < 3; ++k) {
          const int i = h[corner], j = h[corner_neighbors[corner][k]];
          const Vector_3 u = tangled[h[corner_neighbors[corner][(k + 1) % 3]]] - tangled[i];
          const Vector_3 v = tangled[h[corner_neighbors[corner][(k + 2) % 3]]] - tangled[i];
          const Vector_3 n = u.cross(v).normalized();
          sum += ((x[j] - x[i]) / lengths[complex.find_edge(i, j) / 2] - n).squaredNorm();
        }
    return sum;
  }

  // Eq. 14, 16 (or 27) and 18; start: the positions whose edge lengths normalize
  double penalty_energy(const Positions& x, const Positions& start, const std::vector<double>& weight) const
  {
    double sum = 0;
    for (std::size_t d = 0; d < targets.size(); ++d) {
      if (targets[d].worst_cosine <= 0)
        continue; // the target is worse than 90 degrees
      const int i = complex.source(int(d)), j = complex.target(int(d));
      const double normalization = ((start[j] - start[i]).norm() + lengths[d / 2]) / 2;
      const double angle_weight = 1 +
                                  10 * std::exp(-std::pow(targets[d].worst_cosine - worst_cosine, 2) / (2 * .3 * .3));
      sum += angle_weight * weight[d] * ((x[j] - x[i]) / normalization - targets[d].direction).squaredNorm();
    }
    return sum;
  }

  // Eq. 19, over every edge and all edges like it
  double regularization_energy(const Positions& x) const
  {
    double sum = 0;
    for (const std::vector<Edge_pair>* pairs : {&relations.parallel, &relations.consecutive}) {
      std::vector<std::vector<Vector_3>> like(complex.edges.size());
      const auto scaled = [&](int directed) {
        return Vector_3((x[complex.target(directed)] - x[complex.source(directed)]) / lengths[directed / 2]);
      };
      for (const Edge_pair& p : *pairs) {
        like[p.first / 2].push_back(scaled(p.first) - scaled(p.second));
        like[p.second / 2].push_back(scaled(p.second) - scaled(p.first));
      }
      for (const std::vector<Vector_3>& differences : like)
        for (const Vector_3& difference : differences)
          sum += difference.squaredNorm() / differences.size();
    }
    return sum;
  }

  // Eq. 21, with the auxiliary a of feature vertices at its best value
  double boundary_energy(const Positions& x) const
  {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const double alpha = parameters.feature_weight * weights[v], beta = parameters.surface_weight * weights[v];
      Vector_3 place = x[v];
      switch (attachment->kind[v]) {
      case Vertex_kind::SURFACE: {
        const Foot_point q = surface->foot_point(tangled[v]);
        place = q.point;
        sum += beta * std::pow(q.normal.dot(x[v]) - q.normal.dot(q.point), 2);
        break;
      }
      case Vertex_kind::FEATURE: {
        const Curve_point q = surface->curves[attachment->curve[v]]->closest_point(tangled[v]);
        place = q.point;
        const auto with = [&](double a) { return alpha * (x[v] - (q.point + a * q.tangent)).squaredNorm() + a * a; };
        const double best = alpha * q.tangent.dot(x[v] - q.point) / (1 + alpha);
        EXPECT_LE(with(best), with(best + 1e-3));
        EXPECT_LE(with(best), with(best - 1e-3));
        sum += with(best);
        break;
      }
      case Vertex_kind::CORNER:
        place = attachment->corner[v];
        sum += alpha * (x[v] - place).squaredNorm();
        break;
      default:
        break;
      }
      sum += anchor * weights[v] * (x[v] - place).squaredNorm();
    }
    for (std::size_t l = 0; l < links.size(); ++l) {
      Vector_3 foot = Vector_3::Zero();
      for (int i = 0; i < 3; ++i)
        foot += links[l].weights[i] * x[links[l].vertices[i]];
      sum += link_weights[l] * (foot - links[l].sample).squaredNorm();
    }
    return sum;
  }

  double energy(const Positions& x, const Positions& start, const std::vector<double>& weight) const
  {
    return parameters.cone_weight * (cone_energy(x) + penalty_energy(x, start, weight)) +
           parameters.regularization_weight * regularization_energy(x) + boundary_energy(x);
  }

  double energy(const Positions& x, const Positions& start) const
  {
    return energy(x, start, std::vector<double>(targets.size(), 1.0));
  }

  // is_fixed: no vertex is if empty
  std::unique_ptr<Global_step> global_step(std::vector<char> is_fixed = {}) const
  {
    is_fixed.resize(complex.number_of_vertices(), false);
    auto step = std::make_unique<Global_step>(complex, relations, cones, is_fixed, parameters);
    step->set_target_lengths(lengths);
    step->set_boundary(*surface, *attachment, feet_on(*surface, tangled), weights, anchor, tangled);
    if (!links.empty())
      step->set_reference_pull(links, link_weights);
    return step;
  }

  // The energy that the system has at x: nothing may move there.
  double energy_of_system(Positions x) const
  {
    const Positions before = x;
    const double result = global_step(std::vector<char>(x.size(), true))->minimize(targets, worst_cosine, x);
    EXPECT_EQ(x, before);
    return result;
  }

  Positions minimized(const Positions& start, const std::vector<char>& is_fixed = {}) const
  {
    Positions x = start;
    global_step(is_fixed)->minimize(targets, worst_cosine, x);
    return x;
  }
};

Setting tangled_block(unsigned int seed)
{
  return Setting(seed, [](auto& p, auto& h) { HMO::make_block(p, h, {{3, 2, 2}}, {{3, 2, 2}}); });
}

Setting tangled_cylinder(unsigned int seed)
{
  return Setting(seed, [](auto& p, auto& h) { HMO::make_cylinder(p, h, 2, 2, 2., 3.); });
}

template <class Test>
void for_all_settings(Test test)
{
  for (unsigned int seed = 0; seed < 3; ++seed)
    for (int variant = 0; variant < 6; ++variant) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", variant " + std::to_string(variant));
      Setting s = seed == 2 ? tangled_cylinder(seed) : tangled_block(seed);
      std::mt19937 random(seed + 77);
      std::uniform_real_distribution<double> uniform(.1, 3);
      switch (variant) {
      case 1: // the weights of the paper
        s.parameters.feature_weight = 20;
        s.parameters.surface_weight = 10;
        break;
      case 2:
        for (double& w : s.weights)
          w = uniform(random);
        break;
      case 3:
        s.anchor = 2.5;
        for (double& w : s.weights)
          w = uniform(random);
        break;
      case 4:
        s.worst_cosine = .23; // eq. 27
        s.parameters.regularization_weight = .3;
        s.parameters.cone_weight = .1;
        break;
      case 5: {
        const auto& q = s.complex.boundary_faces[2].vertices;
        s.links.push_back(
          {{q[0], q[1], q[2]}, {.5, .2, .3}, random_vector(random, 2), 1., 0., 0, true, Vector_3::Zero()});
        s.links.push_back(
          {{q[0], q[2], q[3]}, {.1, .8, .1}, random_vector(random, 2), 1., 0., 0, true, Vector_3::Zero()});
        s.link_weights = {3., .7};
        break;
      }
      default:
        break;
      }
      test(s, random);
      if (::testing::Test::HasFailure())
        return;
    }
}

TEST(Global_step, has_the_energy_of_the_paper)
{
  for_all_settings([](const Setting& s, std::mt19937& random) {
    for (double size : {0., .3, 5.}) {
      const Positions x = moved(s.tangled, random, size);
      const double expected = s.energy(x, x);
      EXPECT_NEAR(s.energy_of_system(x), expected, 1e-10 * expected);
    }
  });
}

// All three kinds of boundary vertices and both kinds of targets must have been there
TEST(Global_step, is_tested_on_every_kind_of_vertex)
{
  std::map<Vertex_kind, int> kinds;
  const Setting s = tangled_cylinder(2), t = tangled_block(0);
  for (const Setting* setting : {&s, &t})
    for (Vertex_kind kind : setting->attachment->kind)
      ++kinds[kind];
  EXPECT_GT(kinds[Vertex_kind::INTERIOR], 0);
  EXPECT_GT(kinds[Vertex_kind::SURFACE], 0);
  EXPECT_GT(kinds[Vertex_kind::FEATURE], 0);
  EXPECT_EQ(kinds[Vertex_kind::CORNER], 8);
  const auto valid = std::count_if(t.targets.begin(), t.targets.end(),
                                   [](const Target_direction& d) { return d.is_valid(); });
  EXPECT_GT(valid, 10);
  EXPECT_LT(valid, int(t.targets.size()) - 10);
}

TEST(Global_step, ends_where_the_gradient_of_the_energy_vanishes)
{
  for_all_settings([](const Setting& s, std::mt19937& random) {
    const Positions x = s.minimized(s.tangled);
    const auto energy = [&](const Positions& p) { return s.energy(p, s.tangled); };
    const double scale = gradient(energy, s.tangled).norm();
    EXPECT_LT(gradient(energy, x).norm(), 1e-7 * scale);
    const double least = energy(x);
    for (std::size_t v = 0; v < x.size(); ++v) {
      Positions perturbed = x;
      perturbed[v] += random_vector(random, 1e-2);
      EXPECT_GT(energy(perturbed), least) << v;
    }
  });
}

TEST(Global_step, returns_the_energy_it_reached)
{
  for_all_settings([](const Setting& s, std::mt19937&) {
    Positions x = s.tangled;
    const double energy = s.global_step()->minimize(s.targets, s.worst_cosine, x);
    EXPECT_NEAR(energy, s.energy(x, s.tangled), 1e-9 * energy);
  });
}

TEST(Global_step, agrees_with_a_dense_solver)
{
  const Setting s = tangled_block(5);
  const auto energy = [&](const Positions& p) { return s.energy(p, s.tangled); };
  const std::size_t n = s.tangled.size();
  const Eigen::MatrixXd H = hessian(energy, n);
  EXPECT_LT((H - H.transpose()).norm(), 1e-6 * H.norm());
  const Eigen::VectorXd expected = H.ldlt().solve(-gradient(energy, Positions(n, Vector_3::Zero())));
  EXPECT_LT((flat(s.minimized(s.tangled)) - expected).norm(), 1e-6 * expected.norm());
}

TEST(Global_step, keeps_fixed_vertices_bit_for_bit)
{
  for_all_settings([](const Setting& s, std::mt19937&) {
    std::vector<char> is_fixed(s.tangled.size());
    for (std::size_t v = 0; v < is_fixed.size(); ++v)
      is_fixed[v] = v % 3 == 0;
    const Positions x = s.minimized(s.tangled, is_fixed);
    const auto energy = [&](const Positions& p) { return s.energy(p, s.tangled); };
    const Eigen::VectorXd slope = gradient(energy, x);
    const double scale = gradient(energy, s.tangled).norm();
    for (std::size_t v = 0; v < is_fixed.size(); ++v)
      if (is_fixed[v])
        EXPECT_EQ(x[v], s.tangled[v]);
      else {
        EXPECT_NE(x[v], s.tangled[v]);
        EXPECT_LT(slope.segment<3>(3 * v).norm(), 1e-7 * scale);
      }
  });
}

// Eq. 15, where the difference is one of directions
TEST(Global_step, reweights_penalties_between_its_iterations)
{
  for_all_settings([](Setting& s, std::mt19937&) {
    const Positions first = s.minimized(s.tangled);
    std::vector<double> weight(s.targets.size());
    double largest = 0;
    for (std::size_t d = 0; d < weight.size(); ++d) {
      const Vector_3 e = first[s.complex.target(int(d))] - first[s.complex.source(int(d))];
      weight[d] = (std::max)(1.0, std::pow((e.normalized() - s.targets[d].direction).norm(), 6));
      largest = (std::max)(largest, weight[d]);
    }
    EXPECT_GT(largest, 2);
    EXPECT_LE(largest, 64);
    s.parameters.penalty_iterations = 2;
    const Positions second = s.minimized(s.tangled);
    const auto energy = [&](const Positions& p) { return s.energy(p, s.tangled, weight); };
    EXPECT_LT(gradient(energy, second).norm(), 1e-7 * gradient(energy, s.tangled).norm());
  });
}

TEST(Global_step, forgets_what_it_was_set_before)
{
  const Setting s = tangled_block(1);
  const auto step = s.global_step();
  Positions x = s.tangled;
  step->minimize(s.targets, s.worst_cosine, x);
  // other lengths and another boundary in between
  step->set_target_lengths(std::vector<double>(s.lengths.size(), 2.0));
  step->set_boundary(*s.surface, *s.attachment, feet_on(*s.surface, s.regular),
                     std::vector<double>(s.weights.size(), 5.0), 3, s.regular);
  x = s.tangled;
  step->minimize(s.targets, s.worst_cosine, x);
  step->set_target_lengths(s.lengths);
  step->set_boundary(*s.surface, *s.attachment, feet_on(*s.surface, s.tangled), s.weights, s.anchor, s.tangled);
  x = s.tangled;
  step->minimize(s.targets, s.worst_cosine, x);
  EXPECT_EQ(x, s.minimized(s.tangled));
}

TEST(Global_step, keeps_a_perfect_mesh)
{
  Setting s = tangled_block(1);
  s.cones.update_normals(s.regular);
  s.lengths.assign(s.lengths.size(), 1.0);
  for (std::size_t d = 0; d < s.targets.size(); ++d)
    s.targets[d] = {s.regular[s.complex.target(int(d))] - s.regular[s.complex.source(int(d))], 1.0};
  s.tangled = s.regular;
  const Positions x = s.minimized(s.regular);
  for (std::size_t v = 0; v < x.size(); ++v)
    EXPECT_LT((x[v] - s.regular[v]).norm(), 1e-9);
}

} // namespace
