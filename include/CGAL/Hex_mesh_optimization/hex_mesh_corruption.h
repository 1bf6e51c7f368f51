// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H
#define CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H

// Stress tests: tangles a hexahedral mesh reproducibly, without touching its
// connectivity.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/hexahedron.h>
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

namespace CGAL {
namespace Hex_mesh_optimization {
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
  std::size_t index(std::size_t n)
  {
    return static_cast<std::size_t>((*this)() * static_cast<double>(n));
  }

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

// The faces that only one hexahedron has, each as in `hexahedron_faces`.
template <class HexahedronRange>
std::vector<std::array<std::size_t, 4>> boundary_quads(const HexahedronRange& hexahedra)
{
  struct Face
  {
    std::array<std::size_t, 4> sorted, quad;
  };
  std::vector<Face> faces;
  faces.reserve(6 * hexahedra.size());
  for (const auto& hexahedron : hexahedra)
    for (const auto& corners : hexahedron_faces) {
      Face face;
      for (int i = 0; i < 4; ++i)
        face.quad[i] = static_cast<std::size_t>(hexahedron[corners[i]]);
      face.sorted = face.quad;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  // Stable, so that the order of the quads does not depend on the library
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.sorted < b.sorted; });

  std::vector<std::array<std::size_t, 4>> quads;
  for (std::size_t first = 0, last; first < faces.size(); first = last) {
    for (last = first + 1; last < faces.size() && faces[last].sorted == faces[first].sorted; ++last) {}
    if (last == first + 1)
      quads.push_back(faces[first].quad);
  }
  return quads;
}

// The vertices that are inside the mesh: used, and not on its boundary.
template <class HexahedronRange>
std::vector<std::size_t> interior_vertices(std::size_t number_of_vertices, const HexahedronRange& hexahedra)
{
  std::vector<char> is_interior(number_of_vertices, 0);
  for (const auto& hexahedron : hexahedra)
    for (int corner = 0; corner < 8; ++corner)
      is_interior[hexahedron[corner]] = 1;
  for (const auto& quad : boundary_quads(hexahedra))
    for (std::size_t v : quad)
      is_interior[v] = 0;

  std::vector<std::size_t> vertices;
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    if (is_interior[v])
      vertices.push_back(v);
  return vertices;
}

template <class Point>
Point displaced(const Point& p, const std::array<double, 3>& direction, double length)
{
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;
  return p + Vector(length * direction[0], length * direction[1], length * direction[2]);
}

// The mean length of the edges at each vertex; an edge counts once for each
// hexahedron around it.
template <class PointRange, class HexahedronRange>
std::vector<double> mean_edge_lengths(const PointRange& points, const HexahedronRange& hexahedra)
{
  std::vector<double> sums(points.size(), 0);
  std::vector<std::size_t> counts(points.size(), 0);
  for (const auto& hexahedron : hexahedra)
    for (const auto& edge : hexahedron_edges) {
      const std::size_t a = hexahedron[edge[0]], b = hexahedron[edge[1]];
      const double length = std::sqrt(CGAL::to_double((points[b] - points[a]).squared_length()));
      for (std::size_t v : {a, b}) {
        sums[v] += length;
        ++counts[v];
      }
    }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (counts[v] != 0)
      sums[v] /= static_cast<double>(counts[v]);
  return sums;
}

} // namespace internal

/*!
 * \addtogroup PkgHexMeshOptimizationGenerators
 *
 * The functions that corrupt a mesh are determined by their `seed`, on every
 * platform. They change coordinates only.
 *
 * `PointRange` is a model of `RandomAccessContainer` with value type
 * `Kernel::Point_3`, `HexahedronRange` one of ranges of 8 vertex indices.
 */

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * Moves every interior vertex to a random position, uniform in the bounding box
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
  for (std::size_t v : internal::interior_vertices(points.size(), hexahedra)) {
    std::array<double, 3> p;
    for (int d = 0; d < 3; ++d)
      p[d] = lower[d] + random() * (upper[d] - lower[d]);
    points[v] = Point(p[0], p[1], p[2]);
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * Moves every interior vertex by a random vector, uniform in the ball of radius
 * `amplitude` times the mean length of the edges at the vertex. Around 1, many
 * hexahedra are inverted. The boundary is untouched.
 */
template <class PointRange, class HexahedronRange>
void scramble_interior(PointRange& points, const HexahedronRange& hexahedra, std::uint64_t seed, double amplitude)
{
  const std::vector<double> lengths = internal::mean_edge_lengths(points, hexahedra);
  internal::Corruption_random random(seed);
  for (std::size_t v : internal::interior_vertices(points.size(), hexahedra))
    points[v] = internal::displaced(points[v], random.in_ball(), amplitude * lengths[v]);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * Rotates a random selection of hexahedra about their centers, each as a rigid
 * body in its original shape, by a random angle about a random axis. Where
 * rotated hexahedra share a vertex, the last one wins. Vertices on the boundary
 * stay where they are.
 *
 * \param fraction the part of the hexahedra that is rotated, from 0 to 1
 * \param maximum_angle angles are uniform between 0 and this, in radians
 */
template <class PointRange, class HexahedronRange>
void rotate_hexahedra(PointRange& points,
                      const HexahedronRange& hexahedra,
                      std::uint64_t seed,
                      double fraction,
                      double maximum_angle = 3.14159265358979323846)
{
  using Point = typename PointRange::value_type;
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  std::vector<char> is_interior(points.size(), 0);
  for (std::size_t v : internal::interior_vertices(points.size(), hexahedra))
    is_interior[v] = 1;

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
      if (!is_interior[v])
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
 * Slides vertices along the boundary: each one goes to a random place on one of
 * its boundary quads (as a bilinear patch), at most the fraction `amplitude` of
 * the way to the far corner in either direction. Above 1/4, boundary
 * quads may fold. A vertex whose quads' normals differ by more than
 * `features_angle` (in radians) is on a feature and stays.
 */
template <class PointRange, class HexahedronRange>
void jitter_boundary(PointRange& points,
                     const HexahedronRange& hexahedra,
                     std::uint64_t seed,
                     double amplitude,
                     double features_angle = .5)
{
  using Point = typename PointRange::value_type;
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  const std::vector<std::array<std::size_t, 4>> quads = internal::boundary_quads(hexahedra);
  std::vector<Vector> normals;
  normals.reserve(quads.size());
  // Corners of quads, grouped by the vertex that is there
  std::vector<std::vector<std::pair<std::size_t, int>>> corners(points.size());
  for (std::size_t q = 0; q < quads.size(); ++q) {
    const Vector normal = cross_product(points[quads[q][2]] - points[quads[q][0]],
                                        points[quads[q][3]] - points[quads[q][1]]);
    const double length = std::sqrt(CGAL::to_double(normal.squared_length()));
    normals.push_back(length > 0 ? Vector(normal / length) : Vector(0, 0, 0));
    for (int i = 0; i < 4; ++i)
      corners[quads[q][i]].emplace_back(q, i);
  }

  internal::Corruption_random random(seed);
  const double minimum_cosine = std::cos(features_angle);
  const PointRange original = points;
  for (std::size_t v = 0; v < corners.size(); ++v) {
    bool is_feature = corners[v].empty();
    for (std::size_t i = 0; i < corners[v].size() && !is_feature; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (CGAL::to_double(normals[corners[v][i].first] * normals[corners[v][j].first]) < minimum_cosine)
          is_feature = true;
    if (is_feature)
      continue;

    const auto [q, i] = corners[v][random.index(corners[v].size())];
    const double s = random() * amplitude, t = random() * amplitude;
    const Point& p = original[v];
    const Vector a = original[quads[q][(i + 1) % 4]] - p;
    const Vector b = original[quads[q][(i + 3) % 4]] - p;
    const Vector opposite = original[quads[q][(i + 2) % 4]] - p;
    points[v] = p + (s * (1 - t) * a + (1 - s) * t * b + s * t * opposite);
  }
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * Moves one random interior vertex in a random direction by `factor` times the
 * average length of the interior edges (those with an end inside the mesh).
 *
 * \return the index of the vertex, so that the caller can hold it where it is
 * \throws Input_error if the mesh has no interior vertex
 */
template <class PointRange, class HexahedronRange>
std::size_t displace_vertex(PointRange& points,
                            const HexahedronRange& hexahedra,
                            std::uint64_t seed,
                            double factor = 4)
{
  const std::vector<std::size_t> interior = internal::interior_vertices(points.size(), hexahedra);
  if (interior.empty())
    throw Input_error(Input_error::Element::MESH, 0, "the mesh has no interior vertex to displace");

  std::vector<char> is_interior(points.size(), 0);
  for (std::size_t v : interior)
    is_interior[v] = 1;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& hexahedron : hexahedra)
    for (const auto& edge : internal::hexahedron_edges) {
      const std::size_t a = hexahedron[edge[0]], b = hexahedron[edge[1]];
      if (is_interior[a] || is_interior[b])
        edges.emplace_back((std::min)(a, b), (std::max)(a, b));
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  double sum = 0;
  for (const auto& edge : edges)
    sum += std::sqrt(CGAL::to_double((points[edge.second] - points[edge.first]).squared_length()));

  internal::Corruption_random random(seed);
  const std::size_t v = interior[random.index(interior.size())];
  points[v] = internal::displaced(points[v], random.on_sphere(), factor * sum / static_cast<double>(edges.size()));
  return v;
}

} } // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_CORRUPTION_H
