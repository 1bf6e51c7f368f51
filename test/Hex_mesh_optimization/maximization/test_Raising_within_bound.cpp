// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is raised within a bound stays within it, or nothing is kept.

#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Raising_within_bound.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "Bounded_mesh.h"

#include "../mesh_families.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

// Faces are so oblique that corners are poor, and that samples see little of what vertices do to them.
const double slope = 2;

struct Raised_mesh : Bounded_mesh
{
  const double bound;

  Raised_mesh(const Indexed_mesh& mesh, double bound) : Bounded_mesh(mesh, bound), bound(bound) {}

  bool is_within(const Positions& at) const
  {
    return certified_deviation(faces, at, *surface, bound, Certification_parameters()).is_shown;
  }

  template <class IsWithin>
  void raise(const IsWithin& accepts, std::size_t most_searches)
  {
    Raising_parameters parameters;
    parameters.most_searches = most_searches;
    Pattern_search_parameters of_search;
    of_search.most_rounds = 6; // the first ones gain the most
    Raising_within_bound(complex, lengths, *surface, attachment, its_sliding, its_samples, of_search, parameters)
      .raise(
        .6, [&](const Positions& at) { return accepts(at); }, [] { return false; }, points);
  }
};

class Raising_within_bound_of_families : public ::testing::TestWithParam<Mesh_family>
{};

INSTANTIATE_TEST_SUITE_P(Families, Raising_within_bound_of_families, ::testing::ValuesIn(mesh_families()),
                         Family_name());

TEST_P(Raising_within_bound_of_families, keeps_what_is_within)
{
  Raised_mesh s(sheared(GetParam()(), slope), .1);
  const Positions start = s.points;
  const Mesh_quality before(s.complex, s.points);
  ASSERT_EQ(before.invalid, 0u);
  ASSERT_TRUE(s.is_within(s.points));
  std::size_t asked = 0;
  bool is_within = false;
  s.raise(
    [&](const Positions& at) {
      ++asked;
      return is_within = s.is_within(at);
    },
    1);
  const Mesh_quality after(s.complex, s.points);
  EXPECT_EQ(after.invalid, 0u);
  if (asked == 0)
    EXPECT_EQ(s.points, start);
  else {
    EXPECT_TRUE(is_within);
    EXPECT_TRUE(s.is_within(s.points));
    EXPECT_GE(after.minimum, before.minimum + Raising_parameters().least_gain);
  }
}

// Where faces are flat and meet along features, or the corners of a block are as good as they can be, nothing is.
TEST(Raising_within_bound, gains_what_the_bound_has_to_give)
{
  for (int family : {2, 4, 5}) {
    Raised_mesh s(sheared(mesh_families()[family](), slope), .1);
    const double before = Mesh_quality(s.complex, s.points).minimum;
    s.raise([&](const Positions& at) { return s.is_within(at); }, 2);
    EXPECT_GE(Mesh_quality(s.complex, s.points).minimum, before + .02) << mesh_families()[family].name;
  }
}

TEST_P(Raising_within_bound_of_families, keeps_nothing_that_is_not_shown_to_be_within)
{
  Raised_mesh s(sheared(GetParam()(), slope), .1);
  const Positions before = s.points;
  s.raise([](const Positions&) { return false; }, 1);
  EXPECT_EQ(s.points, before);
}

} // namespace
