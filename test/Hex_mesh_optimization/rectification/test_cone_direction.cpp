// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The convex program of the local step against its optimality conditions, a
// certificate of infeasibility, and a search of the whole ball.

#include <CGAL/Hex_mesh_optimization/internal/rectification/cone_direction.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace {

using CGAL::Hex_mesh_optimization::internal::Cone_direction;
using CGAL::Hex_mesh_optimization::internal::cone_direction;
using Vector = Eigen::Vector3d;

struct Cone
{
  std::vector<Vector> normals;
  double threshold = 0;
  double surface_weight = 0;
  Vector surface_normal = Vector::Zero();

  // eq. 9, and 20 where the surface weight is positive
  double energy(const Vector& x) const
  {
    double sum = surface_weight * std::pow(x.dot(surface_normal), 2);
    for (const Vector& n : normals)
      sum += (x - n).squaredNorm();
    return sum;
  }

  Vector gradient(const Vector& x) const
  {
    Vector sum = 2 * surface_weight * x.dot(surface_normal) * surface_normal;
    for (const Vector& n : normals)
      sum += 2 * (x - n);
    return sum;
  }

  double least_product(const Vector& x) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector& n : normals)
      least = (std::min)(least, x.dot(n));
    return least;
  }

  Cone_direction solved() const { return cone_direction(normals, threshold, surface_weight, surface_normal); }
};

Vector random_direction(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Vector v;
  do
    v = Vector(normal(random), normal(random), normal(random));
  while (v.norm() < 1e-3);
  return v.normalized();
}

// Half of the cones are fans of triangles around a tilted axis, as in a mesh; the
// others have independent normals in a cap of random width. Some repeat a
// normal, or have all normals in one plane.
Cone random_cone(std::mt19937& random, bool with_surface)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::size_t valence = 3 + random() % 8;
  Cone cone;
  if (random() % 2) {
    std::vector<Vector> rim;
    const double noise = 1.5 * uniform(random);
    for (std::size_t k = 0; k < valence; ++k) {
      const double angle = 2 * 3.14159265358979323846 * k / valence;
      rim.push_back(Vector(std::cos(angle), std::sin(angle), noise * (2 * uniform(random) - 1)) +
                    .5 * noise * random_direction(random));
    }
    for (std::size_t k = 0; k < valence; ++k)
      cone.normals.push_back(rim[k].cross(rim[(k + 1) % valence]).normalized());
  }
  else {
    const Vector axis = random_direction(random);
    const double lowest = 1.2 * uniform(random) - .2;
    while (cone.normals.size() < valence) {
      const Vector n = random_direction(random);
      if (n.dot(axis) >= lowest)
        cone.normals.push_back(n);
    }
  }
  switch (random() % 8) {
  case 0: // two hexahedra with parallel bases
    cone.normals[1] = cone.normals[0];
    break;
  case 2:
  case 3: { // all bases but one or two alike: planes cut the direction off near the sphere
    const Vector common = random_direction(random);
    for (Vector& n : cone.normals)
      n = (common + .1 * random_direction(random)).normalized();
    const Vector across = common.unitOrthogonal();
    cone.normals[0] = (across + .4 * random_direction(random)).normalized();
    if (random() % 2)
      cone.normals[1] = (common.cross(across) + .4 * random_direction(random)).normalized();
    break;
  }
  case 1: { // a fan around a ruled surface
    const Vector plane = random_direction(random);
    for (Vector& n : cone.normals)
      n = (n - n.dot(plane) * plane).normalized();
    break;
  }
  default:
    break;
  }
  const double thresholds[] = {0, std::cos(85 * 3.14159265358979323846 / 180), .2, .35, .5};
  cone.threshold = thresholds[random() % 5];
  if (with_surface) {
    cone.surface_weight = random() % 2 ? 10 : 100 * uniform(random);
    cone.surface_normal = random_direction(random);
  }
  return cone;
}

// Nonnegative coefficients that come nearest to target = Σ c_i generators_i. By
// Carathéodory, at most three generators are needed at a time.
double distance_to_conical_hull(const std::vector<Vector>& generators, const Vector& target)
{
  double nearest = target.norm();
  const int n = static_cast<int>(generators.size());
  for (int i = 0; i < n; ++i)
    for (int j = i; j < n; ++j)
      for (int k = j; k < n; ++k) {
        std::vector<int> chosen{i};
        if (j != i)
          chosen.push_back(j);
        if (k != j)
          chosen.push_back(k);
        Eigen::MatrixXd G(3, chosen.size());
        for (std::size_t c = 0; c < chosen.size(); ++c)
          G.col(c) = generators[chosen[c]];
        const Eigen::VectorXd coefficients = G.colPivHouseholderQr().solve(target);
        if (coefficients.minCoeff() >= -1e-9)
          nearest = (std::min)(nearest, (G * coefficients - target).norm());
      }
  return nearest;
}

// The norm of the shortest convex combination of the normals. Its minimum equals
// the largest least product of a unit vector with them: a cone is feasible
// exactly if it is at least the threshold.
double distance_to_convex_hull(const std::vector<Vector>& normals)
{
  double nearest = std::numeric_limits<double>::infinity();
  const unsigned int subsets = 1u << normals.size();
  for (unsigned int subset = 1; subset < subsets; ++subset) {
    std::vector<Vector> chosen;
    for (std::size_t k = 0; k < normals.size(); ++k)
      if (subset >> k & 1)
        chosen.push_back(normals[k]);
    if (chosen.size() > 4)
      continue;
    // the point of the affine hull nearest to the origin
    Eigen::MatrixXd D(3, chosen.size() - 1);
    for (std::size_t c = 1; c < chosen.size(); ++c)
      D.col(c - 1) = chosen[c] - chosen[0];
    Eigen::VectorXd c(0);
    Vector point = chosen[0];
    if (D.cols() > 0) {
      c = D.colPivHouseholderQr().solve(-chosen[0]);
      point += D * c;
    }
    if (c.size() == 0 || (c.minCoeff() >= -1e-9 && c.sum() <= 1 + 1e-9))
      nearest = (std::min)(nearest, point.norm());
  }
  return nearest;
}

struct Tally
{
  int feasible = 0, infeasible = 0, on_ball = 0, inside_ball = 0;
  std::array<int, 4> planes{{0, 0, 0, 0}}; // with so many tight ones, three or more in the last
  std::array<int, 4> planes_on_ball{{0, 0, 0, 0}};
};

// Primal feasibility, stationarity with nonnegative multipliers of the tight
// constraints alone (dual feasibility and complementary slackness).
void check_optimality(const Cone& cone, const Cone_direction& solved, Tally& tally)
{
  const Vector& x = solved.direction;
  ASSERT_TRUE(x.allFinite());
  EXPECT_LE(x.norm(), 1 + 1e-9);
  EXPECT_GE(cone.least_product(x), cone.threshold - 1e-9);

  std::vector<Vector> tight; // gradients of the constraints, inwards
  for (const Vector& n : cone.normals)
    if (x.dot(n) < cone.threshold + 1e-8)
      tight.push_back(n);
  const std::size_t planes = (std::min)(tight.size(), std::size_t(3));
  const bool on_ball = x.norm() > 1 - 1e-8;
  if (on_ball)
    tight.push_back(-x);
  EXPECT_LT(distance_to_conical_hull(tight, cone.gradient(x)), 1e-5 * (cone.normals.size() + cone.surface_weight));

  ++tally.planes[planes];
  ++(on_ball ? tally.on_ball : tally.inside_ball);
  tally.planes_on_ball[planes] += on_ball;
}

Tally check_random_cones(bool with_surface, int count)
{
  std::mt19937 random(with_surface ? 7 : 3);
  Tally tally;
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const Cone cone = random_cone(random, with_surface);
    const Cone_direction solved = cone.solved();
    const double reach = distance_to_convex_hull(cone.normals);
    if (reach > cone.threshold + 1e-9) {
      EXPECT_TRUE(solved.feasible) << reach << " " << cone.threshold;
    }
    else if (reach < cone.threshold - 1e-9) {
      EXPECT_FALSE(solved.feasible) << reach << " " << cone.threshold;
    }
    ++(solved.feasible ? tally.feasible : tally.infeasible);
    if (solved.feasible)
      check_optimality(cone, solved, tally);
  }
  return tally;
}

void expect_all_cases(const Tally& tally)
{
  EXPECT_GT(tally.feasible, 500);
  EXPECT_GT(tally.infeasible, 500);
  EXPECT_GT(tally.on_ball, 20);
  EXPECT_GT(tally.inside_ball, 500);
  for (int planes = 0; planes <= 3; ++planes)
    EXPECT_GT(tally.planes[planes], 20) << planes << " tight planes";
  for (int planes = 1; planes <= 2; ++planes)
    EXPECT_GT(tally.planes_on_ball[planes], 5) << planes << " tight planes and the ball";
}

TEST(Cone_direction, is_optimal_or_proved_infeasible) { expect_all_cases(check_random_cones(false, 6000)); }

TEST(Cone_direction, is_optimal_or_proved_infeasible_with_surface_term)
{
  expect_all_cases(check_random_cones(true, 6000));
}

// No theory: a lattice of the ball, then ever finer lattices around the best point.
TEST(Cone_direction, is_found_by_search)
{
  std::mt19937 random(11);
  int feasible = 0, infeasible = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Cone cone = random_cone(random, i % 2 == 1);
    const Cone_direction solved = cone.solved();
    Vector center = Vector::Zero();
    bool found = false;
    double best = std::numeric_limits<double>::infinity();
    const int n = 20;
    double step = 1. / n;
    for (int level = 0; level < 14; ++level, step /= 2) {
      const Vector around = center;
      const int m = level == 0 ? n : 4;
      for (int a = -m; a <= m; ++a)
        for (int b = -m; b <= m; ++b)
          for (int c = -m; c <= m; ++c) {
            const Vector x = around + step * Vector(a, b, c);
            if (x.squaredNorm() > 1 || cone.least_product(x) < cone.threshold)
              continue;
            found = true;
            EXPECT_TRUE(solved.feasible);
            const double energy = cone.energy(x);
            if (energy < best) {
              best = energy;
              center = x;
            }
          }
    }
    if (!found) {
      // the search may miss a sliver, but nothing with room to move
      if (solved.feasible) {
        EXPECT_LT(distance_to_convex_hull(cone.normals), cone.threshold + .1);
      }
      ++infeasible;
      continue;
    }
    ++feasible;
    ASSERT_TRUE(solved.feasible);
    const double energy = cone.energy(solved.direction);
    EXPECT_LE(energy, best + 1e-9);
    // the search can get stuck at an edge of the feasible set, never far from the minimum
    EXPECT_NEAR(energy, best, .02 * (1 + cone.surface_weight) * cone.normals.size());
  }
  EXPECT_GT(feasible, 30);
  EXPECT_GT(infeasible, 10);
}

TEST(Cone_direction, is_the_mean_normal_where_nothing_is_tight)
{
  const std::vector<Vector> normals = {Vector(.6, 0, .8), Vector(0, .6, .8), Vector(-.6, 0, .8), Vector(0, -.6, .8)};
  const Cone_direction solved = cone_direction(normals, .1);
  ASSERT_TRUE(solved.feasible);
  EXPECT_LT((solved.direction - Vector(0, 0, .8)).norm(), 1e-14);
}

TEST(Cone_direction, lies_along_the_surface_under_a_large_surface_weight)
{
  const std::vector<Vector> normals = {Vector(.6, 0, .8), Vector(.8, 0, .6)};
  const Cone_direction solved = cone_direction(normals, .1, 1e9, Vector(0, 0, 1));
  ASSERT_TRUE(solved.feasible);
  EXPECT_LT((solved.direction - Vector(.7, 0, 0)).norm(), 1e-6);
}

TEST(Cone_direction, of_opposite_normals_is_infeasible)
{
  const std::vector<Vector> normals = {Vector(0, 0, 1), Vector(0, 0, -1), Vector(1, 0, 0)};
  EXPECT_FALSE(cone_direction(normals, .1).feasible);
  EXPECT_FALSE(cone_direction(normals, .1, 10, Vector(1, 0, 0)).feasible);
}

// Three planes with one common point on the sphere
TEST(Cone_direction, of_a_single_feasible_point_is_found)
{
  const double s = 1 / std::sqrt(2.);
  const std::vector<Vector> normals = {Vector(s, 0, s), Vector(-s / 2, s * std::sqrt(.75), s),
                                       Vector(-s / 2, -s * std::sqrt(.75), s)};
  EXPECT_TRUE(cone_direction(normals, s - 1e-9).feasible);
  EXPECT_LT((cone_direction(normals, s - 1e-9).direction - Vector(0, 0, 1)).norm(), 1e-4);
  EXPECT_FALSE(cone_direction(normals, s + 1e-9).feasible);
}

} // namespace
