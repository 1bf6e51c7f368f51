// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The volume of hexahedra against solids of known volume and against a fine subdivision.

#include <CGAL/Hex_mesh_optimization/internal/quality/volume.h>

#include "../Generated_mesh.h"
#include "../random_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace CGAL::Hex_mesh_optimization::internal;

double volume(const Generated_mesh& mesh, const Positions& points)
{
  double sum = 0;
  for (const Hexahedron& h : mesh.complex.hexahedra) {
    Vector_3 corners[8];
    for (int k = 0; k < 8; ++k)
      corners[k] = points[h[k]];
    sum += CGAL::Hex_mesh_optimization::internal::volume(corners);
  }
  return sum;
}

TEST(Volume, of_a_block_is_that_of_its_outside_wherever_the_interior_is)
{
  std::mt19937 random(1);
  const Generated_mesh mesh = block(4);
  for (int trial = 0; trial < 20; ++trial) {
    Positions points = mesh.points;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!mesh.complex.is_on_boundary[v])
        points[v] += random_vector(random, .3);
    EXPECT_NEAR(volume(mesh, points), 1, 1e-13);
  }
}

TEST(Volume, is_that_of_the_image_of_an_affine_map)
{
  std::mt19937 random(2);
  const Generated_mesh mesh = l_shape(2);
  const double before = volume(mesh, mesh.points);
  for (int trial = 0; trial < 20; ++trial) {
    Matrix_3 A;
    A << random_vector(random, 1), random_vector(random, 1), random_vector(random, 1);
    const Vector_3 shift = random_vector(random, 10);
    Positions points = mesh.points;
    for (Vector_3& p : points)
      p = A * p + shift;
    EXPECT_NEAR(volume(mesh, points), A.determinant() * before, 1e-11);
  }
}

// One hexahedron with warped faces, cut along its trilinear map: sums of its parts do not change
TEST(Volume, of_a_warped_hexahedron_is_that_of_its_parts)
{
  std::mt19937 random(3);
  const Generated_mesh one = block(1), fine = block(3);
  for (int trial = 0; trial < 20; ++trial) {
    Positions points = one.points;
    for (Vector_3& p : points)
      p += random_vector(random, .4);
    Positions parts;
    for (const Vector_3& x : fine.points) {
      Vector_3 p = Vector_3::Zero();
      for (std::size_t v = 0; v < 8; ++v) {
        double share = 1;
        for (int d = 0; d < 3; ++d)
          share *= one.points[v][d] > .5 ? x[d] : 1 - x[d];
        p += share * points[v];
      }
      parts.push_back(p);
    }
    EXPECT_NEAR(volume(one, points), volume(fine, parts), 1e-13);
  }
}

} // namespace
