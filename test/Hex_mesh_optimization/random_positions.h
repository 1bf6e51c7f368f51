// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_POSITIONS_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_POSITIONS_H

// Numbers, vectors and positions at random.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>

#include <random>

namespace test {

using namespace CGAL::Hex_mesh_optimization::internal;

inline double uniform(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vector_3 random_vector(std::mt19937& random, double size)
{
  const double x = uniform(random, -size, size), y = uniform(random, -size, size), z = uniform(random, -size, size);
  return Vector_3(x, y, z);
}

inline Positions moved(Positions points, std::mt19937& random, double size)
{
  for (Vector_3& p : points)
    p += random_vector(random, size);
  return points;
}

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_POSITIONS_H
