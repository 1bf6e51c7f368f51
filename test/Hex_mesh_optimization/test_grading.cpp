// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Layers that grow away from a wall keep their heights in whole runs.

#include <CGAL/optimize_hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/quality.h>

#include "mesh_families.h"
#include "random_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

namespace HMO = CGAL::Hex_mesh_optimization;
namespace params = CGAL::parameters;
using Point = Indexed_mesh::Point;

// Columns of hexahedra on a bumpy wall, the first a twentieth as high as wide and each next one higher by the factor
class Layers
{
public:
  Indexed_mesh mesh;

  explicit Layers(double growth)
  {
    HMO::make_block(mesh.points, mesh.hexahedra, {{columns, columns, layers}}, {{columns, columns, layers}});
    const auto height = [&](int layer) { return .05 * (std::pow(growth, layer) - 1) / (growth - 1); };
    for (Point& p : mesh.points) {
      const double r = std::hypot(p.x() - columns / 2., p.y() - columns / 2.), bump = .3 * std::exp(-r * r / 8);
      const double z = height(static_cast<int>(std::lround(p.z())));
      p = Point(p.x(), p.y(), z + bump * (height(layers) - z));
    }
  }

  // Moves the vertices inside by up to this part of the heights of hexahedra
  void scramble(unsigned int seed, double part)
  {
    std::mt19937 random(seed);
    const auto complex = mesh.complex();
    std::vector<double> below(mesh.points.size()); // the heights of the hexahedra under the vertices
    for (const auto& h : mesh.hexahedra)
      for (int i = 0; i < 4; ++i)
        below[h[i + 4]] = mesh.points[h[i + 4]].z() - mesh.points[h[i]].z();
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (!complex.is_on_boundary[v]) {
        const Point p = mesh.points[v];
        const Vector_3 moved = random_vector(random, part * below[v]);
        mesh.points[v] = Point(p.x() + moved[0], p.y() + moved[1], p.z() + moved[2]);
      }
  }

  // Of each hexahedron, the mean of its four edges that go up
  std::vector<double> heights() const
  {
    std::vector<double> result;
    for (const auto& h : mesh.hexahedra) {
      double sum = 0;
      for (int i = 0; i < 4; ++i)
        sum += std::sqrt(CGAL::squared_distance(mesh.points[h[i]], mesh.points[h[i + 4]]));
      result.push_back(sum / 4);
    }
    return result;
  }

private:
  static constexpr int columns = 8, layers = 10;
};

// The percentiles 1 and 99 of the heights as parts of those that were made
void expect_heights(const Layers& layers, const std::vector<double>& made, double least, double most)
{
  std::vector<double> parts = layers.heights();
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] /= made[i];
  std::sort(parts.begin(), parts.end());
  EXPECT_GE(parts[parts.size() / 100], least);
  EXPECT_LE(parts[parts.size() * 99 / 100], most);
}

class Grading : public ::testing::TestWithParam<double>
{};

INSTANTIATE_TEST_SUITE_P(Growth, Grading, ::testing::Values(1.2, 1.3, 1.4, 1.5));

TEST_P(Grading, of_a_valid_mesh_is_kept)
{
  Layers layers(GetParam());
  const std::vector<double> made = layers.heights();
  layers.scramble(1, .15);
  const HMO::Status status = CGAL::optimize_hex_mesh(layers.mesh.points, layers.mesh.hexahedra);
  EXPECT_EQ(status.after.number_of_inverted, 0u);
  EXPECT_GT(status.after.minimum, status.before.minimum);
  expect_heights(layers, made, .6, 2.1);
}

TEST_P(Grading, is_kept_closely_if_asked_for)
{
  Layers layers(GetParam());
  const std::vector<double> made = layers.heights();
  layers.scramble(2, .1);
  CGAL::optimize_hex_mesh(layers.mesh.points, layers.mesh.hexahedra,
                          params::target_edge_lengths(HMO::Target_edge_lengths::INPUT));
  expect_heights(layers, made, .75, 1.2);
}

TEST_P(Grading, comes_back_where_layers_are_tangled)
{
  Layers layers(GetParam());
  const std::vector<double> made = layers.heights();
  layers.scramble(3, 1.2);
  const HMO::Status status = CGAL::optimize_hex_mesh(layers.mesh.points, layers.mesh.hexahedra);
  EXPECT_GT(status.before.number_of_inverted, 0u);
  EXPECT_EQ(status.after.number_of_inverted, 0u);
  expect_heights(layers, made, .5, 2.1); // within the boundary, which stays
}

} // namespace
