// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse system of the global step against eq. 25 of the paper, summed term
// by term, and the target lengths against eq. 22 to 24.

#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cones.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Global_step.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Vertex_system.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

Vector_3 random_vector(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return Vector_3(x, y, z);
}

Positions moved(Positions points, std::mt19937& random, double size)
{
  for (Vector_3& p : points)
    p += random_vector(random, size);
  return points;
}

// All positions as 3 n numbers.
Eigen::VectorXd flat(const Positions& points)
{
  Eigen::VectorXd x(3 * points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    x.segment<3>(3 * v) = points[v];
  return x;
}

// Exact for quadratic functions, up to rounding
template <class Energy>
Eigen::VectorXd gradient(const Energy& energy, const Positions& points)
{
  const double h = 1e-2;
  Eigen::VectorXd result(3 * points.size());
  Positions p = points;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    double& x = p[i / 3][i % 3];
    const double at = x;
    x = at + h;
    const double after = energy(p);
    x = at - h;
    const double before = energy(p);
    x = at;
    result[i] = (after - before) / (2 * h);
  }
  return result;
}

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

// --- The sparse system itself ---------------------------------------------------

std::vector<Foot_point> feet_on(const Reference_surface& surface, const Positions& points)
{
  std::vector<Foot_point> feet;
  for (const Vector_3& p : points)
    feet.push_back(surface.foot_point(p));
  return feet;
}

struct Random_system
{
  static constexpr std::size_t n = 12;
  Vertex_system system;
  Eigen::MatrixXd A;
  Eigen::VectorXd b;

  explicit Random_system(unsigned int seed)
    : system(n, {{{0, 1}}, {{0, 2}}, {{1, 2}}, {{2, 3}}, {{3, 4}}, {{3, 7}}, {{4, 5}}, {{0, 5}}, {{5, 6}}, {{6, 7}}, {{7, 8}},
                 {{1, 8}}, {{8, 9}}, {{9, 10}}, {{10, 11}}, {{2, 11}}, {{0, 1}}, {{3, 4}}})
    , A(Eigen::MatrixXd::Zero(3 * n, 3 * n))
    , b(3 * n)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(.1, 2);
    const std::array<int, 2> pairs[] = {{{0, 1}}, {{0, 2}}, {{1, 2}}, {{2, 3}}, {{3, 4}}, {{3, 7}}, {{4, 5}}, {{0, 5}},
                                        {{5, 6}}, {{6, 7}}, {{7, 8}}, {{1, 8}}, {{8, 9}}, {{9, 10}}, {{10, 11}}, {{2, 11}}};
    for (const auto& p : pairs) {
      const double w = uniform(random);
      for (int end = 0; end < 2; ++end) {
        system.diagonal[p[end]] += w;
        system.couplings()[system.slot(p[end], p[1 - end])] -= w;
        for (int d = 0; d < 3; ++d) {
          A(3 * p[end] + d, 3 * p[end] + d) += w;
          A(3 * p[end] + d, 3 * p[1 - end] + d) -= w;
        }
      }
    }
    for (std::size_t v = 0; v < n; ++v) {
      system.right[v] = random_vector(random, 3);
      b.segment<3>(3 * v) = system.right[v];
      if (v % 3)
        continue;
      const Vector_3 normal = random_vector(random, 1).normalized();
      system.blocks[v] = 5 * normal * normal.transpose() + .5 * Matrix_3::Identity();
      A.block<3, 3>(3 * v, 3 * v) += system.blocks[v];
    }
  }
};

TEST(Vertex_system, has_the_energy_and_gradient_of_its_matrix)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Random_system s(seed);
    std::mt19937 random(seed + 10);
    const Positions points = moved(Positions(s.n, Vector_3::Zero()), random, 2);
    const Eigen::VectorXd x = flat(points);
    EXPECT_NEAR(s.system.energy(points), x.dot(s.A * x) - 2 * s.b.dot(x), 1e-10);
    const Eigen::VectorXd difference =
      gradient([&](const Positions& p) { return s.system.energy(p); }, points) - 2 * (s.A * x - s.b);
    EXPECT_LT(difference.norm(), 1e-8);
  }
}

TEST(Vertex_system, is_solved_as_a_dense_system)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Random_system s(seed);
    Positions points(s.n, Vector_3::Zero());
    const int iterations = s.system.solve(points, 1e-13, 1000);
    EXPECT_GT(iterations, 0);
    EXPECT_LE(iterations, 3 * int(s.n) + 5);
    EXPECT_LT((flat(points) - s.A.ldlt().solve(s.b)).norm(), 1e-9);
    EXPECT_EQ(s.system.solve(points, 1e-6, 1000), 0) << "started at the solution";
  }
}

TEST(Vertex_system, keeps_fixed_rows_and_solves_for_the_others)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    Random_system s(seed);
    std::mt19937 random(seed);
    const Positions start = moved(Positions(s.n, Vector_3::Zero()), random, 2);
    Positions points = start;
    std::vector<int> free;
    for (std::size_t v = 0; v < s.n; ++v)
      if (v % 4 == 1)
        s.system.is_fixed[v] = true;
      else
        free.push_back(static_cast<int>(v));
    s.system.solve(points, 1e-13, 1000);
    const Eigen::VectorXd residual = s.A * flat(points) - s.b;
    for (std::size_t v = 0; v < s.n; ++v)
      if (s.system.is_fixed[v])
        EXPECT_EQ(points[v], start[v]);
      else
        EXPECT_LT(residual.segment<3>(3 * v).norm(), 1e-9);
  }
}

TEST(Vertex_system, honors_the_limit_of_iterations)
{
  const Random_system s(1);
  Positions points(s.n, Vector_3::Zero());
  EXPECT_EQ(s.system.solve(points, 1e-13, 3), 3);
  EXPECT_LT(s.system.energy(points), 0) << "three steps downhill from zero";
}

// --- Eq. 25 ---------------------------------------------------------------------

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
  std::vector<Reference_pull::Link> links;
  std::vector<double> link_weights;
  double worst_cosine_of_mesh = std::numeric_limits<double>::quiet_NaN();

  template <class Make>
  Setting(unsigned int seed, Make make) : Setting(seed, generated(make)) {}

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

  template <class Make>
  static std::pair<Positions, std::vector<Hexahedron>> generated(Make make)
  {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::array<std::size_t, 8>> hexahedra;
    make(points, hexahedra);
    std::pair<Positions, std::vector<Hexahedron>> result;
    for (const auto& p : points)
      result.first.emplace_back(p.x(), p.y(), p.z());
    for (const auto& h : hexahedra) {
      result.second.emplace_back();
      std::copy(h.begin(), h.end(), result.second.back().begin());
    }
    return result;
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
      const double omega = std::isnan(worst_cosine_of_mesh) ? 0 : worst_cosine_of_mesh;
      const double angle_weight = 1 + 10 * std::exp(-std::pow(targets[d].worst_cosine - omega, 2) / (2 * .3 * .3));
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
    return parameters.cone_weight * cone_energy(x) + penalty_energy(x, start, weight) +
           parameters.regularization_weight * regularization_energy(x) + boundary_energy(x);
  }

  double energy(const Positions& x, const Positions& start) const
  {
    return energy(x, start, std::vector<double>(targets.size(), 1.0));
  }

  std::unique_ptr<Global_step> global_step() const
  {
    auto step = std::make_unique<Global_step>(complex, relations, cones, parameters);
    step->set_target_lengths(lengths);
    step->set_boundary(*surface, *attachment, feet_on(*surface, tangled), weights, anchor, tangled);
    if (!links.empty())
      step->set_reference_pull(links, link_weights);
    step->worst_cosine_of_mesh = worst_cosine_of_mesh;
    return step;
  }

  // The energy that the system has at x: nothing may move there.
  double energy_of_system(Positions x) const
  {
    const Positions before = x;
    const auto step = global_step();
    step->fix(std::vector<char>(x.size(), true));
    const double result = step->minimize(targets, x);
    EXPECT_EQ(x, before);
    return result;
  }

  Positions minimized(const Positions& start, const std::vector<char>& is_fixed = {}) const
  {
    Positions x = start;
    const auto step = global_step();
    if (!is_fixed.empty())
      step->fix(is_fixed);
    step->minimize(targets, x);
    return x;
  }
};

Setting block(unsigned int seed)
{
  return Setting(seed, [](auto& p, auto& h) { HMO::make_block(p, h, {{3, 2, 2}}, {{3, 2, 2}}); });
}

Setting cylinder(unsigned int seed)
{
  return Setting(seed, [](auto& p, auto& h) { HMO::make_cylinder(p, h, 2, 2, 2., 3.); });
}

template <class Test>
void for_all_settings(Test test)
{
  for (unsigned int seed = 0; seed < 3; ++seed)
    for (int variant = 0; variant < 6; ++variant) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", variant " + std::to_string(variant));
      Setting s = seed == 2 ? cylinder(seed) : block(seed);
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
        s.worst_cosine_of_mesh = .23; // eq. 27
        s.parameters.regularization_weight = .3;
        s.parameters.cone_weight = .1;
        break;
      case 5: {
        const auto& q = s.complex.boundary_faces[2].vertices;
        s.links.push_back({{q[0], q[1], q[2]}, {.5, .2, .3}, random_vector(random, 2), 1., 0., 0, true, Vector_3::Zero()});
        s.links.push_back({{q[0], q[2], q[3]}, {.1, .8, .1}, random_vector(random, 2), 1., 0., 0, true, Vector_3::Zero()});
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
  const Setting s = cylinder(2), t = block(0);
  for (const Setting* setting : {&s, &t})
    for (Vertex_kind kind : setting->attachment->kind)
      ++kinds[kind];
  EXPECT_GT(kinds[Vertex_kind::INTERIOR], 0);
  EXPECT_GT(kinds[Vertex_kind::SURFACE], 0);
  EXPECT_GT(kinds[Vertex_kind::FEATURE], 0);
  EXPECT_EQ(kinds[Vertex_kind::CORNER], 8);
  const auto valid = std::count_if(t.targets.begin(), t.targets.end(), [](const Target_direction& d) { return d.is_valid(); });
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
    const double energy = s.global_step()->minimize(s.targets, x);
    EXPECT_NEAR(energy, s.energy(x, s.tangled), 1e-9 * energy);
  });
}

TEST(Global_step, agrees_with_a_dense_solver)
{
  const Setting s = block(5);
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
  const Setting s = block(1);
  const auto step = s.global_step();
  Positions x = s.tangled;
  step->minimize(s.targets, x);
  // other lengths and another boundary in between
  step->set_target_lengths(std::vector<double>(s.lengths.size(), 2.0));
  step->set_boundary(*s.surface, *s.attachment, feet_on(*s.surface, s.regular), std::vector<double>(s.weights.size(), 5.0), 3, s.regular);
  x = s.tangled;
  step->minimize(s.targets, x);
  step->set_target_lengths(s.lengths);
  step->set_boundary(*s.surface, *s.attachment, feet_on(*s.surface, s.tangled), s.weights, s.anchor, s.tangled);
  x = s.tangled;
  step->minimize(s.targets, x);
  EXPECT_EQ(x, s.minimized(s.tangled));
}

TEST(Global_step, keeps_a_perfect_mesh)
{
  Setting s = block(1);
  s.cones.update_normals(s.regular);
  s.lengths.assign(s.lengths.size(), 1.0);
  for (std::size_t d = 0; d < s.targets.size(); ++d)
    s.targets[d] = {s.regular[s.complex.target(int(d))] - s.regular[s.complex.source(int(d))], 1.0};
  s.tangled = s.regular;
  const Positions x = s.minimized(s.regular);
  for (std::size_t v = 0; v < x.size(); ++v)
    EXPECT_LT((x[v] - s.regular[v]).norm(), 1e-9);
}

// --- Target lengths -------------------------------------------------------------

TEST(Target_edge_lengths, minimize_eq_22)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Setting s = seed == 2 ? cylinder(seed) : block(seed);
    const std::size_t n = s.complex.edges.size();
    const auto length = [&](std::size_t e) { return (s.tangled[s.complex.edges[e][0]] - s.tangled[s.complex.edges[e][1]]).norm(); };
    double mean = 0;
    std::size_t on_boundary = 0;
    for (std::size_t e = 0; e < n; ++e)
      if (s.complex.is_boundary_edge[e]) {
        mean += length(e);
        ++on_boundary;
      }
    mean /= on_boundary;
    EXPECT_NEAR(mean_boundary_edge_length(s.complex, s.tangled), mean, 1e-13);

    // eq. 22 as squares of rows of a matrix; its last two sums run over e, so each pair counts twice
    std::vector<Eigen::VectorXd> rows;
    std::vector<double> right;
    for (std::size_t e = 0; e < n; ++e) {
      rows.push_back(Eigen::VectorXd::Unit(n, e));
      right.push_back(s.complex.is_boundary_edge[e] ? length(e) : mean);
    }
    for (const std::vector<Edge_pair>* pairs : {&s.relations.parallel, &s.relations.consecutive})
      for (const Edge_pair& p : *pairs)
        for (int twice = 0; twice < 2; ++twice) {
          rows.push_back(Eigen::VectorXd::Unit(n, p.first / 2) - Eigen::VectorXd::Unit(n, p.second / 2));
          right.push_back(0);
        }
    Eigen::MatrixXd M(rows.size(), n);
    for (std::size_t r = 0; r < rows.size(); ++r)
      M.row(r) = rows[r];
    const Eigen::VectorXd expected =
      M.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()));
    const std::vector<double> lengths = estimate_edge_lengths(s.complex, s.relations, s.tangled);
    for (std::size_t e = 0; e < n; ++e)
      EXPECT_NEAR(lengths[e], expected[e], 1e-4 * mean) << e;
  }
}

TEST(Target_edge_lengths, of_equal_edges_are_their_length)
{
  Setting s = block(0);
  for (double l : estimate_edge_lengths(s.complex, s.relations, s.regular))
    EXPECT_NEAR(l, 1, 1e-12);
  // whatever the interior looks like
  for (std::size_t v = 0; v < s.regular.size(); ++v)
    if (!s.complex.is_on_boundary[v])
      s.regular[v] = Vector_3(7, 8, 9);
  for (double l : estimate_edge_lengths(s.complex, s.relations, s.regular))
    EXPECT_NEAR(l, 1, 1e-12);
}

TEST(Target_edge_lengths, grow_with_the_mesh)
{
  const Setting s = cylinder(0);
  Positions large = s.tangled;
  for (Vector_3& p : large)
    p *= 1024;
  const std::vector<double> lengths = estimate_edge_lengths(s.complex, s.relations, s.tangled);
  const std::vector<double> of_large = estimate_edge_lengths(s.complex, s.relations, large);
  for (std::size_t e = 0; e < lengths.size(); ++e)
    EXPECT_EQ(of_large[e], 1024 * lengths[e]);
}

TEST(Target_edge_lengths, are_updated_by_eq_23_and_24)
{
  const Setting s = block(4);
  const double sigma = .15;
  std::vector<double> quality(s.complex.hexahedra.size(), .4);
  quality[2] = .1;
  quality[5] = .2;
  quality[7] = -.5;
  quality[9] = 1;
  std::vector<double> lengths = s.lengths;
  update_edge_lengths(s.complex, s.tangled, quality, sigma, lengths);
  std::set<double> seen;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    double q = std::numeric_limits<double>::infinity();
    for (std::size_t h = 0; h < s.complex.hexahedra.size(); ++h)
      for (const auto& local : hexahedron_edges) {
        const int a = s.complex.hexahedra[h][local[0]], b = s.complex.hexahedra[h][local[1]];
        if ((std::min)(a, b) == s.complex.edges[e][0] && (std::max)(a, b) == s.complex.edges[e][1])
          q = (std::min)(q, quality[h]);
      }
    seen.insert(q);
    const double reached = (s.tangled[s.complex.edges[e][0]] - s.tangled[s.complex.edges[e][1]]).norm();
    const double w = q <= 0 ? 1 : std::exp(-.5 * std::pow(q / sigma, 2)); // an inverted one is as poor as can be
    EXPECT_NEAR(lengths[e], (1 - w) * s.lengths[e] + w * reached, 1e-13) << e;
  }
  EXPECT_GE(seen.size(), 4u);
}

} // namespace
