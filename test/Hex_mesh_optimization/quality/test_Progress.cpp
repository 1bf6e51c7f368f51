// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// When a stage has gained nothing for how long.

#include <CGAL/Hex_mesh_optimization/internal/quality/Progress.h>

#include "../mesh_families.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

Mesh_quality quality(double minimum, double average)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  Mesh_quality result(mesh.complex(), positions(mesh));
  result.minimum = minimum;
  result.average = average;
  return result;
}

TEST(Progress, counts_from_the_last_gain_and_the_last_change)
{
  Progress progress(quality(.5, .9), .01, .001);
  progress.add(quality(.509, .9005));
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 1u);
  EXPECT_EQ(progress.iterations_without_change_of_average(), 1u);
  progress.add(quality(.511, .9005)); // small gains add up
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 0u);
  EXPECT_EQ(progress.iterations_without_change(), 0u);
  progress.add(quality(.4, .898)); // the average may fall, too
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 1u);
  EXPECT_EQ(progress.iterations_without_change_of_average(), 0u);
  progress.add(quality(.511, .898));
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 2u);
  EXPECT_EQ(progress.iterations_without_change(), 1u);
}

TEST(Progress, of_a_minimum_near_zero_is_relative)
{
  Progress progress(quality(1e-4, .9), .01, .001);
  progress.add(quality(1.05e-4, .9));
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 1u);
  progress.add(quality(1.2e-4, .9));
  EXPECT_EQ(progress.iterations_without_gain_of_minimum(), 0u);
}

} // namespace
