// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of a distance against finite differences, and where it is smooth, flat and linear.

#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

const Distance_energy distance_energies[] = {{1.65, .03, .2, .19}, {8, .03, .2, .6}, {1, 1, 0, 1}, {1e-3, .1, 5, .01}};

TEST(Distance_energy, has_the_slope_of_its_value)
{
  for (const Distance_energy& energy : distance_energies)
    for (double d = .01 * energy.linear_distance; d < 100; d *= 1.37) { // below, rounding of the value dominates
      const double h = 1e-4 * d, difference = (energy.value(d + h) - energy.value(d - h)) / (2 * h);
      EXPECT_NEAR(energy.derivatives(d).slope, difference / d, 1e-6 * difference / d) << d;
    }
}

TEST(Distance_energy, is_least_and_smooth_at_zero)
{
  for (const Distance_energy& energy : distance_energies) {
    EXPECT_EQ(energy.value(0), 0);
    EXPECT_NEAR(energy.derivatives(0).slope, energy.linear_weight / energy.linear_distance,
                1e-12 * energy.derivatives(0).slope);
    EXPECT_NEAR(energy.derivatives(1e-9).slope, energy.derivatives(0).slope, 1e-9 * energy.derivatives(0).slope);
  }
}

TEST(Distance_energy, goes_smoothly_over_to_its_tangent)
{
  for (const Distance_energy& energy : distance_energies) {
    const double d = 2 * energy.steep_distance, h = 1e-9;
    EXPECT_NEAR(energy.value((1 - h) * d), energy.value((1 + h) * d), 1e-7 * energy.value(d));
    EXPECT_NEAR(energy.derivatives((1 - h) * d).slope, energy.derivatives((1 + h) * d).slope,
                1e-7 * energy.derivatives(d).slope);
  }
}

TEST(Distance_energy, grows_and_is_not_underestimated_by_its_model)
{
  for (const Distance_energy& energy : distance_energies) {
    double before = 0;
    for (double d = 1e-4; d < 100; d *= 1.13) {
      const Distance_energy::Derivatives now = energy.derivatives(d);
      EXPECT_GT(energy.value(d), before);
      before = energy.value(d);
      EXPECT_GT(now.slope, 0);
      EXPECT_GE(now.growth, 0);
      const double h = 1e-4 * d;
      const double second = (energy.derivatives(d + h).slope * (d + h) - energy.derivatives(d - h).slope * (d - h)) /
                            (2 * h);
      EXPECT_GE(now.slope + now.growth * d * d, second * (1 - 1e-5)) << d;
    }
  }
}

TEST(Distance_energy, is_linear_far_away)
{
  for (const Distance_energy& energy : distance_energies) {
    const double rate = energy.linear_weight + 192 * energy.steep_weight / energy.steep_distance; // 192 is ψ'(2)
    for (double d : {1e4, 1e6}) {
      EXPECT_NEAR((energy.value(2 * d) - energy.value(d)) / d, rate, 1e-6 * rate);
      EXPECT_NEAR(energy.derivatives(d).slope * d, rate, 1e-6 * rate);
      EXPECT_EQ(energy.derivatives(d).growth, 0);
    }
  }
}

} // namespace
