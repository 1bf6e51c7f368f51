// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The floor that corners are held above: when it rises and fades, and whom it lifts.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_floor.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include "../Corner.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

TEST(Quality_floor, never_falls_while_it_rises)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  std::mt19937 random(2);
  double before = 0, best = -1;
  for (int i = 0; i < 100; ++i) {
    Positions points = positions(mesh);
    for (Vector_3& p : points)
      p += random_vector(random, uniform(random, .2, .5) * (1 - i / 100.));
    const Mesh_quality quality(complex, points);
    best = (std::max)(best, quality.minimum);
    floor.rise(quality);
    const double now = floor.floors().get(0, 0);
    EXPECT_GE(now, before);
    EXPECT_GE(now, 0);
    EXPECT_LE(now, parameters.limit + 1e-6);
    EXPECT_LE(now, (std::max)(0., best + parameters.step) + 1e-6);
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
      for (int c = 0; c < 8; ++c)
        EXPECT_EQ(floor.floors().get(h, c), now);
    before = now;
  }
  EXPECT_FLOAT_EQ(before, parameters.limit);
}

// Where the connectivity makes many hexahedra poor
TEST(Quality_floor, rises_no_higher_than_a_part_of_the_hexahedra)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  Mesh_quality quality(complex, positions(mesh));
  const std::size_t poor = static_cast<std::size_t>(parameters.fraction * complex.hexahedra.size()) + 1;
  for (std::size_t h = 0; h < poor; ++h)
    quality.scaled_jacobians[h] = .5;
  quality.minimum = .45;
  floor.rise(quality);
  EXPECT_FLOAT_EQ(floor.floors().get(0, 0), .5);
  quality.scaled_jacobians[0] = 1;
  floor.rise(quality);
  EXPECT_FLOAT_EQ(floor.floors().get(0, 0), .45 + parameters.step);
}

// As long as a corner stays below, its floor rises, up to a limit; once it does not, its floor comes down again
TEST(Quality_floor, lifts_only_corners_below_what_it_holds)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions good = positions(mesh);
  Positions poor = good;
  const auto interior = std::find(complex.is_on_boundary.begin(), complex.is_on_boundary.end(), false);
  poor[interior - complex.is_on_boundary.begin()] += Vector_3(.4, .4, .3);

  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  floor.rise(Mesh_quality(complex, good));
  std::vector<std::array<double, 8>> before(complex.hexahedra.size()); // floors of the corners
  const auto hold = [&](const Positions& points) {                     // returns how many corners are lifted
    floor.hold(Mesh_quality(complex, points), points);
    int lifted = 0;
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
      const auto corners = hexahedron_corners(points, complex.hexahedra[h]);
      for (int c = 0; c < 8; ++c) {
        double lift = floor.floors().get(h, c) - (floor.held() + parameters.margin);
        if (std::abs(lift) < 1e-6) // floors are in single precision
          lift = 0;
        if (corner_at(corners.data(), c).scaled_jacobian < floor.held()) {
          EXPECT_GT(lift, 0);
          EXPECT_TRUE(lift > before[h][c] || lift > parameters.largest_lift - 1e-6) << lift;
        }
        else {
          EXPECT_GE(lift, 0);
          EXPECT_TRUE(lift < before[h][c] || lift == 0) << lift;
        }
        EXPECT_LE(lift, parameters.largest_lift + 1e-6);
        lifted += lift > 0;
        before[h][c] = lift;
      }
    }
    return lifted;
  };
  EXPECT_EQ(hold(good), 0); // where nothing had to be lifted while it rose
  const int lifted = hold(poor);
  EXPECT_GT(lifted, 0);
  EXPECT_LT(lifted, 8 * 8) << "of the corners around one vertex";
  for (int round = 0; round < 40; ++round)
    EXPECT_EQ(hold(poor), lifted);
  for (int round = 0; round < 400;
       ++round) // a floor comes down by a part of what the corner has above the one that is held
    EXPECT_LE(hold(good), lifted);
  EXPECT_EQ(hold(good), 0);
}

// Forces that held the worst corners up do not vanish at once
TEST(Quality_floor, fades_from_where_it_had_risen)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  std::mt19937 random(7);
  Positions points = positions(mesh);
  for (Vector_3& p : points)
    p += random_vector(random, .1);
  const Mesh_quality quality(complex, points);
  ASSERT_GT(quality.minimum, 0);
  const Hexahedron_batches batches(complex);
  Quality_floor floor(batches, parameters);
  floor.rise(quality);
  const double risen = floor.floors().get(0, 0);
  floor.hold(quality, points);
  ASSERT_GT(risen, floor.held() + parameters.margin);
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h) {
    const auto corners = hexahedron_corners(points, complex.hexahedra[h]);
    for (int c = 0; c < 8; ++c) {
      const double above = corner_at(corners.data(), c).scaled_jacobian - floor.held();
      EXPECT_NEAR(floor.floors().get(h, c),
                  (std::max)(floor.held() + parameters.margin, risen - parameters.lift_rate * above), 1e-6);
    }
  }
}

TEST(Quality_floor, holds_no_more_than_was_reached)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    Positions points = positions(mesh);
    for (Vector_3& p : points)
      p += random_vector(random, .004 * trial);
    const Mesh_quality quality(complex, points);
    const Hexahedron_batches batches(complex);
    Quality_floor floor(batches, parameters);
    floor.hold(quality, points);
    EXPECT_LE(floor.held(), (std::max)(0., quality.minimum));
    for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
      for (int c = 0; c < 8; ++c)
        EXPECT_NEAR(floor.floors().get(h, c), floor.held() + parameters.margin, 1e-6)
          << "nothing is below what is held";
  }
}

TEST(Quality_floor, remembers_what_was_worth_holding)
{
  const Floor_parameters parameters;
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  std::mt19937 random(9);
  const Positions good = positions(mesh);
  Positions poor = good;
  for (Vector_3& p : poor)
    p += random_vector(random, .12);
  const Mesh_quality quality_of_good(complex, good), quality_of_poor(complex, poor);
  const Hexahedron_batches batches(complex);
  Quality_floor forgets(batches, parameters), remembers(batches, parameters);
  ASSERT_LT(forgets.worth_holding(quality_of_poor), forgets.worth_holding(quality_of_good) - .05);
  for (Quality_floor* floor : {&forgets, &remembers})
    floor->hold(quality_of_good, good);
  remembers.remember_worth(quality_of_good);
  const double held = remembers.held();
  for (Quality_floor* floor : {&forgets, &remembers}) {
    floor->hold(quality_of_poor, poor);
    floor->yield(.9);
  }
  EXPECT_LT(forgets.held(), held - .05);
  EXPECT_EQ(remembers.held(), held);
  remembers.hold(quality_of_poor, poor);
  EXPECT_NEAR(remembers.held(), .9 * held, 1e-12) << "what it yields is lost all the same";
}

} // namespace
