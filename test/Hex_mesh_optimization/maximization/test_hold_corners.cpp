// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A step is shortened where corners would get too poor, and nowhere else.

#include <CGAL/Hex_mesh_optimization/internal/maximization/hold_corners.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>

#include "../Corner.h"
#include "../mesh_families.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

Batched_values<1> same_for_all(const Hexahedral_complex& complex, double value)
{
  Batched_values<1> result(complex.hexahedra.size());
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
    result.set(h, 0, value);
  return result;
}

const auto not_retracted = [](Positions&) {};
const auto no_more = [](const Positions&, std::vector<char>&) {};

// Only vertices of hexahedra that would get too poor are held back, and these until none is
TEST(Hold_corners, is_shortened_only_where_corners_would_get_too_poor)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions points = positions(mesh);
  const Batched_values<1> least = same_for_all(complex, .6);
  std::mt19937 random(3);
  Positions step(points.size());
  for (Vector_3& d : step)
    d = random_vector(random, .02);
  const int moved = complex.hexahedra[0][0];
  step[moved] = Vector_3(1, .8, .9);
  const Positions given = step;
  const int rounds = 20;
  hold_corners(complex, Hexahedron_batches(complex), points, least, rounds, Last_resort::NONE, not_retracted, no_more,
               step);

  std::vector<char> is_near(points.size(), false);
  for (int h : complex.vertex_hexahedra[moved])
    for (int v : complex.hexahedra[h])
      is_near[v] = true;
  Positions reached = points;
  for (std::size_t v = 0; v < points.size(); ++v) {
    reached[v] += step[v];
    if (!is_near[v]) {
      EXPECT_EQ(step[v], given[v]) << v;
    }
  }
  EXPECT_GE(Mesh_quality(complex, reached).minimum, .6);
  const double part = step[moved].norm() / given[moved].norm();
  EXPECT_LT(part, 1);
  EXPECT_GT(part, 0);
  EXPECT_NEAR(std::log2(part), std::round(std::log2(part)), 1e-12) << "halved, and halved again";
  // once less would not have done
  Positions longer = points;
  for (std::size_t v = 0; v < points.size(); ++v)
    longer[v] += is_near[v] ? Vector_3(2 * step[v]) : step[v];
  EXPECT_LT(Mesh_quality(complex, longer).minimum, .6);
}

TEST(Hold_corners, ends_after_the_rounds)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Batched_values<1> unreachable = same_for_all(complex, 2);
  Positions step(mesh.points.size(), Vector_3(1, 2, 3));
  hold_corners(complex, Hexahedron_batches(complex), positions(mesh), unreachable, 3, Last_resort::NONE, not_retracted,
               no_more, step);
  for (const Vector_3& d : step)
    EXPECT_EQ(d, Vector_3(1, 2, 3) / 8);
}

TEST(Hold_corners, is_shortened_where_more_is_found_in_what_is_retracted)
{
  const Indexed_mesh mesh = mesh_families()[0]();
  const Hexahedral_complex complex = mesh.complex();
  const Positions points = positions(mesh);
  const Batched_values<1> least = same_for_all(complex, -1);
  const int watched = 0, v = complex.hexahedra[watched][0];
  Positions step(points.size(), Vector_3(.1, 0, 0));
  hold_corners(
    complex, Hexahedron_batches(complex), points, least, 20, Last_resort::NONE, [&](Positions& p) { p[v].z() += 1; },
    [&](const Positions& reached, std::vector<char>& is_ruined) {
      EXPECT_EQ(reached[v].z(), points[v].z() + 1);
      if (reached[v].x() - points[v].x() > .03)
        is_ruined[watched] = true;
    },
    step);
  for (std::size_t u = 0; u < points.size(); ++u) {
    const Hexahedron& h = complex.hexahedra[watched];
    const bool is_held = std::find(h.begin(), h.end(), static_cast<int>(u)) != h.end();
    EXPECT_EQ(step[u], Vector_3(is_held ? .025 : .1, 0, 0)) << u;
  }
}

} // namespace
