// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The order of the states of a mesh, rule by rule.

#include <CGAL/Hex_mesh_optimization/internal/quality/Best_state.h>

#include "../mesh_families.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Of some mesh, but with these figures
Mesh_quality quality(std::size_t inverted, std::size_t invalid, double minimum)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  Mesh_quality result(mesh.complex(), positions(mesh));
  result.inverted = inverted;
  result.invalid = invalid;
  result.minimum = minimum;
  return result;
}

// States tell themselves apart by the x of their only point
Positions state(double x) { return {Vector_3(x, 0, 0)}; }

double best(const Best_state& b) { return b.points()[0].x(); }

TEST(Best_state, keeps_to_the_order_of_goals_and_then_to_how_loosely_the_boundary_is_attached)
{
  Best_state b(state(0), quality(2, 3, -.5), 1, 0, 5, .5);
  b.offer(state(1), quality(3, 3, .9), 0, 0);
  EXPECT_EQ(best(b), 0);
  b.offer(state(2), quality(1, 9, -.9), 9, .9);
  EXPECT_EQ(best(b), 2);
  b.offer(state(3), quality(1, 8, -.95), 9.5, .9);
  EXPECT_EQ(best(b), 3);
  b.offer(state(4), quality(1, 8, -.99), 1, .95);
  EXPECT_EQ(best(b), 4);
  b.offer(state(5), quality(1, 8, .5), 1, .96);
  EXPECT_EQ(best(b), 4);
  b.offer(state(6), quality(1, 8, -1), 1, .94);
  EXPECT_EQ(best(b), 6);
  EXPECT_EQ(b.inverted(), 1u);
  EXPECT_EQ(b.invalid(), 8u);
  EXPECT_EQ(b.minimum(), -1);
}

TEST(Best_state, gives_way_to_others_once_it_turns_out_to_exceed)
{
  Best_state b(state(0), quality(0, 0, .9), 1, 0, 0, .5);
  b.reassess(.2);
  EXPECT_EQ(b.excess(), .2);
  b.offer(state(1), quality(0, 0, .95), .3, .5);
  EXPECT_EQ(best(b), 0) << "one that exceeds more does not count";
  b.offer(state(2), quality(0, 0, .9), .1, .5);
  EXPECT_EQ(best(b), 2);
  EXPECT_EQ(b.excess(), .1);
  b.offer(state(3), quality(0, 0, .8), 0, .5);
  EXPECT_EQ(best(b), 2) << "what came in good keeps its minimum";
}

TEST(Best_state, gives_up_a_minimum_that_is_not_protected)
{
  for (Protection protection : {Protection::OF_WHAT_IS_GOOD, Protection::NONE}) {
    const bool is_protected = protection == Protection::OF_WHAT_IS_GOOD;
    Best_state b(state(0), quality(0, 0, .9), 1, 0, 0, .5, Away(), protection);
    EXPECT_EQ(b.is_protected(), is_protected);
    b.offer(state(1), quality(0, 0, .8), 0, .4);
    EXPECT_EQ(best(b), is_protected ? 0 : 1);
  }
}

TEST(Best_state, of_equals_is_the_latest_that_does_not_fall_behind_the_highest)
{
  Best_state b(state(0), quality(0, 1, .5), 1, .01);
  b.offer(state(1), quality(0, 1, .495));
  EXPECT_EQ(best(b), 1);
  EXPECT_EQ(b.highest_minimum(), .5);
  b.offer(state(2), quality(0, 1, .4875)); // no farther behind the best, but behind the highest
  EXPECT_EQ(best(b), 1);
  b.offer(state(3), quality(0, 1, .6));
  EXPECT_EQ(best(b), 3);
  EXPECT_EQ(b.highest_minimum(), .6);

  Best_state relative(state(0), quality(0, 1, .5), .9, 0);
  relative.offer(state(1), quality(0, 1, .46));
  EXPECT_EQ(best(relative), 1);
  relative.offer(state(2), quality(0, 1, .44));
  EXPECT_EQ(best(relative), 1);
}

TEST(Best_state, of_a_mesh_that_came_in_valid_and_in_place_never_has_a_lower_minimum)
{
  Best_state b(state(0), quality(0, 0, .5), .9, 0, 0, 1);
  EXPECT_EQ(b.least_minimum(), .5);
  EXPECT_TRUE(b.is_protected());
  b.offer(state(1), quality(0, 0, .49));
  EXPECT_EQ(best(b), 0);
  b.offer(state(2), quality(0, 0, .51));
  EXPECT_EQ(best(b), 2);
  b.offer(state(3), quality(0, 0, .9), .1);
  EXPECT_EQ(best(b), 2) << "nor does its boundary leave what is tolerated";
  EXPECT_EQ(Best_state(state(0), quality(0, 1, .5), 1, 0).least_minimum(), -1);
  EXPECT_FALSE(Best_state(state(0), quality(0, 0, .5), 1, 0, 0, 0, {0, 1}).is_protected()) << "with a vertex away";
}

// Its angles do not protect it
TEST(Best_state, of_a_mesh_that_came_in_off_its_reference_comes_nearer)
{
  Best_state b(state(0), quality(0, 0, .9), 1, 0, 2);
  EXPECT_FALSE(b.is_protected());
  b.offer(state(1), quality(0, 0, .3), 1);
  EXPECT_EQ(best(b), 1);
  b.offer(state(2), quality(0, 1, .9), 0);
  EXPECT_EQ(best(b), 1) << "but stays valid";
  b.offer(state(3), quality(0, 0, .2), 0);
  EXPECT_EQ(best(b), 3);
}

TEST(Best_state, reaches_a_target_only_if_it_is_valid_and_in_place)
{
  EXPECT_TRUE(Best_state(state(0), quality(0, 0, .5), 1, 0).reaches(.5));
  EXPECT_FALSE(Best_state(state(0), quality(0, 0, .5), 1, 0).reaches(.51));
  EXPECT_FALSE(Best_state(state(0), quality(0, 1, .5), 1, 0).reaches(.5));
  EXPECT_FALSE(Best_state(state(0), quality(0, 0, .5), 1, 0, .1).reaches(.5));
}

} // namespace
