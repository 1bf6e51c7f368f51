// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H
#define CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Stress tests: tangles a hexahedral mesh reproducibly, without touching its
// connectivity.

#include <CGAL/number_type_config.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization {
namespace internal {

// SplitMix64 (Steele, Lea, Flood 2014). The distributions are written out here
// because those of the standard library differ between implementations.
class Corruption_random
{
public:
  explicit Corruption_random(std::uint64_t seed) : state_(seed) {}

  // Uniform in [0,1)
  double operator()()
  {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-53;
  }

  // Uniform in {0, ..., n-1}, up to a bias of n / 2^53
  std::size_t index(std::size_t n) { return static_cast<std::size_t>((*this)() * static_cast<double>(n)); }

  // Uniform in the unit ball
  std::array<double, 3> in_ball()
  {
    for (;;) {
      const double x = 2 * (*this)() - 1;
      const double y = 2 * (*this)() - 1;
      const double z = 2 * (*this)() - 1;
      if (x * x + y * y + z * z <= 1)
        return {{x, y, z}};
    }
  }

  // Uniform on the unit sphere
  std::array<double, 3> on_sphere()
  {
    for (;;) {
      const std::array<double, 3> p = in_ball();
      const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      if (length > 1e-3)
        return {{p[0] / length, p[1] / length, p[2] / length}};
    }
  }

private:
  std::uint64_t state_;
};

template <class HexahedronRange>
Hexahedral_complex hexahedral_complex(std::size_t number_of_vertices, const HexahedronRange& hexahedra)
{
  std::vector<Hexahedron> copies;
  copies.reserve(hexahedra.size());
  for (const auto& hexahedron : hexahedra) {
    Hexahedron copy;
    for (int corner = 0; corner < 8; ++corner)
      copy[corner] = static_cast<int>(hexahedron[corner]);
    copies.push_back(copy);
  }
  return Hexahedral_complex(number_of_vertices, std::move(copies));
}

// The vertices inside the mesh: used, and not on its boundary.
inline std::vector<std::size_t> interior_vertices(const Hexahedral_complex& complex)
{
  std::vector<std::size_t> vertices;
  for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
    if (complex.is_used[v] && !complex.is_on_boundary[v])
      vertices.push_back(v);
  return vertices;
}

template <class PointRange>
double edge_length(const PointRange& points, const std::array<int, 2>& edge)
{
  return std::sqrt(CGAL::to_double((points[edge[1]] - points[edge[0]]).squared_length()));
}

template <class Point>
Point displaced(const Point& p, const std::array<double, 3>& direction, double length)
{
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;
  return p + Vector(length * direction[0], length * direction[1], length * direction[2]);
}

} // namespace internal

/*!
 * \addtogroup PkgHexMeshOptimizationGenerators
 *
 * The functions that corrupt a mesh are determined by their `seed`, on every
 * platform. They change coordinates only.
 *
 * `PointRange` is a model of `RandomAccessContainer` with value type
 * `Kernel::Point_3`, `HexahedronRange` one of ranges of 8 vertex indices. As
 * everywhere, `Input_error` is thrown if three hexahedra share a face.
 */

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * moves every interior vertex to a random position, uniform in the bounding box
 * of the mesh; on all but the coarsest meshes most hexahedra end up inverted.
 * The boundary is untouched.
 */
template <class PointRange, class HexahedronRange>
void scramble_interior(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed)
{
  using Point = typename PointRange::value_type;

  if (points.empty())
    return;
  std::array<double, 3> lower, upper;
  for (int d = 0; d < 3; ++d) {
    lower[d] = upper[d] = CGAL::to_double(points[0][d]);
    for (const Point& p : points) {
      lower[d] = (std::min)(lower[d], CGAL::to_double(p[d]));
      upper[d] = (std::max)(upper[d], CGAL::to_double(p[d]));
    }
  }

  internal::Corruption_random random(seed);
  for (std::size_t v : internal::interior_vertices(internal::hexahedral_complex(points.size(), hexahedra))) {
    std::array<double, 3> p;
    for (int d = 0; d < 3; ++d)
      p[d] = lower[d] + random() * (upper[d] - lower[d]);
    points[v] = Point(p[0], p[1], p[2]);
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * moves every interior vertex by a random vector, uniform in the ball of radius
 * `amplitude` times the mean length of the edges at the vertex. Around 1, many
 * hexahedra are inverted. The boundary is untouched.
 */
template <class PointRange, class HexahedronRange>
void scramble_interior(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed, double amplitude)
{
  const internal::Hexahedral_complex complex = internal::hexahedral_complex(points.size(), hexahedra);
  std::vector<double> sums(points.size(), 0), counts(points.size(), 0);
  for (const std::array<int, 2>& edge : complex.edges)
    for (int v : edge) {
      sums[v] += internal::edge_length(points, edge);
      ++counts[v];
    }

  internal::Corruption_random random(seed);
  for (std::size_t v : internal::interior_vertices(complex))
    points[v] = internal::displaced(points[v], random.in_ball(), amplitude * sums[v] / counts[v]);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * rotates a random selection of hexahedra about their centers, each as a rigid
 * body in its original shape, by a random angle about a random axis. Where
 * rotated hexahedra share a vertex, the last one wins. Vertices on the boundary
 * stay where they are.
 *
 * \param points the vertices of the mesh
 * \param hexahedra the hexahedra of the mesh
 * \param seed the seed of the random numbers
 * \param fraction the part of the hexahedra that is rotated, from 0 to 1
 * \param maximum_angle angles are uniform between 0 and this, in radians
 */
template <class PointRange, class HexahedronRange>
void rotate_hexahedra(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed, double fraction,
                      double maximum_angle = CGAL_PI)
{
  using Point = typename PointRange::value_type;
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  const internal::Hexahedral_complex complex = internal::hexahedral_complex(points.size(), hexahedra);

  // The selection: the head of a Fisher-Yates shuffle
  internal::Corruption_random random(seed);
  const std::size_t n = hexahedra.size();
  const double wanted = (std::min)(1., (std::max)(0., fraction)) * static_cast<double>(n);
  const std::size_t number_of_rotations = (std::min)(n, static_cast<std::size_t>(wanted + .5));
  std::vector<std::size_t> order(n);
  for (std::size_t h = 0; h < n; ++h)
    order[h] = h;

  const PointRange original = points;
  for (std::size_t i = 0; i < number_of_rotations; ++i) {
    std::swap(order[i], order[i + random.index(n - i)]);
    const auto& hexahedron = hexahedra[order[i]];

    const std::array<double, 3> direction = random.on_sphere();
    const Vector axis(direction[0], direction[1], direction[2]);
    const double angle = random() * maximum_angle;
    const double c = std::cos(angle), s = std::sin(angle);

    Vector sum(0, 0, 0);
    for (int corner = 0; corner < 8; ++corner)
      sum = sum + (original[hexahedron[corner]] - CGAL::ORIGIN);
    const Point center = CGAL::ORIGIN + sum / 8;

    for (int corner = 0; corner < 8; ++corner) {
      const std::size_t v = hexahedron[corner];
      if (complex.is_on_boundary[v])
        continue;
      // Rodrigues' formula
      const Vector arm = original[v] - center;
      points[v] = center + (c * arm + s * cross_product(axis, arm) + ((1 - c) * (axis * arm)) * axis);
    }
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * slides vertices along the boundary: each one goes to a random place on one of
 * its boundary quads (as a bilinear patch), at most the fraction `amplitude` of
 * the way to the far corner in either direction. Above 1/4, boundary
 * quads may fold. A vertex whose quads' normals differ by more than
 * `features_angle` (in radians) is on a feature and stays.
 */
template <class PointRange, class HexahedronRange>
void jitter_boundary(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed, double amplitude,
                     double features_angle = .5)
{
  using Point = typename PointRange::value_type;
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  const internal::Hexahedral_complex complex = internal::hexahedral_complex(points.size(), hexahedra);
  std::vector<Vector> normals;
  normals.reserve(complex.boundary_faces.size());
  for (const auto& face : complex.boundary_faces) {
    const std::array<int, 4>& quad = face.vertices;
    const Vector normal = cross_product(points[quad[2]] - points[quad[0]], points[quad[3]] - points[quad[1]]);
    const double length = std::sqrt(CGAL::to_double(normal.squared_length()));
    normals.push_back(length > 0 ? Vector(normal / length) : Vector(0, 0, 0));
  }

  internal::Corruption_random random(seed);
  const double minimum_cosine = std::cos(features_angle);
  const PointRange original = points;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto faces = complex.vertex_boundary_faces[v];
    bool is_feature = false;
    for (int f : faces)
      for (int g : faces)
        if (CGAL::to_double(normals[f] * normals[g]) < minimum_cosine)
          is_feature = true;
    if (is_feature || !complex.is_on_boundary[v])
      continue;

    const std::array<int, 4>& quad = complex.boundary_faces[faces[random.index(faces.size())]].vertices;
    const int i = static_cast<int>(std::find(quad.begin(), quad.end(), static_cast<int>(v)) - quad.begin());
    const double s = random() * amplitude, t = random() * amplitude;
    const Point& p = original[v];
    const Vector a = original[quad[(i + 1) % 4]] - p;
    const Vector b = original[quad[(i + 3) % 4]] - p;
    const Vector opposite = original[quad[(i + 2) % 4]] - p;
    points[v] = p + (s * (1 - t) * a + (1 - s) * t * b + s * t * opposite);
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * moves one random interior vertex in a random direction by `factor` times the
 * average length of the interior edges (those with an end inside the mesh).
 *
 * \return the index of the vertex, so that the caller can hold it where it is
 * \throws Input_error if the mesh has no interior vertex
 */
template <class PointRange, class HexahedronRange>
std::size_t displace_vertex(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed, double factor = 4)
{
  const internal::Hexahedral_complex complex = internal::hexahedral_complex(points.size(), hexahedra);
  const std::vector<std::size_t> interior = internal::interior_vertices(complex);
  if (interior.empty())
    throw Input_error(Input_error::Element::MESH, 0, "the mesh has no interior vertex to displace");

  double sum = 0;
  std::size_t number_of_edges = 0;
  for (const std::array<int, 2>& edge : complex.edges)
    if (!complex.is_on_boundary[edge[0]] || !complex.is_on_boundary[edge[1]]) {
      sum += internal::edge_length(points, edge);
      ++number_of_edges;
    }

  internal::Corruption_random random(seed);
  const std::size_t v = interior[random.index(interior.size())];
  points[v] = internal::displaced(points[v], random.on_sphere(), factor * sum / static_cast<double>(number_of_edges));
  return v;
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H
