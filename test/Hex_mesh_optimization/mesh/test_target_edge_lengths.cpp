// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The target lengths of edges against eq. 22 to 24 of the paper.

#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>

#include "../Generated_mesh.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
using namespace CGAL::Hex_mesh_optimization::internal;

// A mesh with positions that are all over the place, and lengths at random.
struct Tangled_mesh
{
  Positions regular;
  Hexahedral_complex complex;
  Edge_relations relations;
  Positions tangled;
  std::vector<double> lengths;

  Tangled_mesh(unsigned int seed, const Generated_mesh& mesh)
    : regular(mesh.points)
    , complex(mesh.complex)
    , relations(complex)
  {
    std::mt19937 random(seed);
    tangled = moved(regular, random, .4);
    for (std::size_t e = 0; e < complex.edges.size(); ++e)
      lengths.push_back(uniform(random, .5, 1.5));
  }
};

Tangled_mesh tangled_block(unsigned int seed)
{
  return Tangled_mesh(seed, Generated_mesh([](auto& p, auto& h) { HMO::make_block(p, h, {{3, 2, 2}}, {{3, 2, 2}}); }));
}

Tangled_mesh tangled_cylinder(unsigned int seed)
{
  return Tangled_mesh(seed, Generated_mesh([](auto& p, auto& h) { HMO::make_cylinder(p, h, 2, 2, 2., 3.); }));
}

TEST(Target_edge_lengths, minimize_eq_22)
{
  for (unsigned int seed = 0; seed < 3; ++seed) {
    const Tangled_mesh s = seed == 2 ? tangled_cylinder(seed) : tangled_block(seed);
    const std::size_t n = s.complex.edges.size();
    const auto length = [&](std::size_t e) {
      return (s.tangled[s.complex.edges[e][0]] - s.tangled[s.complex.edges[e][1]]).norm();
    };
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
    const Eigen::VectorXd expected = M.colPivHouseholderQr().solve(
      Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()));
    const std::vector<double> lengths = estimate_edge_lengths(s.complex, s.relations, s.tangled);
    for (std::size_t e = 0; e < n; ++e)
      EXPECT_NEAR(lengths[e], expected[e], 1e-4 * mean) << e;
  }
}

TEST(Target_edge_lengths, of_equal_edges_are_their_length)
{
  Tangled_mesh s = tangled_block(0);
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
  const Tangled_mesh s = tangled_cylinder(0);
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
  const Tangled_mesh s = tangled_block(4);
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
