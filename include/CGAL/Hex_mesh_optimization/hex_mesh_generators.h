// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_GENERATORS_H
#define CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_GENERATORS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Hexahedral meshes of simple solids, at any refinement, for tests, examples
// and benchmarks.

#include <CGAL/number_type_config.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Hex_mesh_optimization {
namespace internal {

constexpr double pi = CGAL_PI;

// The name of a node of a block-structured mesh: a layer and three lattice
// coordinates. Blocks share a node by giving it the same name, so that no
// coordinates need to be compared.
using Lattice_node = std::array<int, 4>;

struct Lattice_node_hash
{
  std::size_t operator()(const Lattice_node& node) const
  {
    std::size_t hash = 0;
    for (int coordinate : node)
      hash = hash * 1000003u + static_cast<std::size_t>(coordinate);
    return hash;
  }
};

using Lattice_hexahedron = std::array<Lattice_node, 8>;
using Lattice_quad = std::array<Lattice_node, 4>;

// Numbers the nodes in order of first use and places each with
// `embedding(node)`, which returns three coordinates.
template <class PointRange, class Embedding>
void build_lattice_mesh(const std::vector<Lattice_hexahedron>& lattice_hexahedra, const Embedding& embedding,
                        PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra)
{
  using Point = typename PointRange::value_type;

  points.clear();
  hexahedra.clear();
  hexahedra.reserve(lattice_hexahedra.size());

  std::unordered_map<Lattice_node, std::size_t, Lattice_node_hash> numbers;
  numbers.reserve(2 * lattice_hexahedra.size());
  for (const Lattice_hexahedron& nodes : lattice_hexahedra) {
    std::array<std::size_t, 8> hexahedron;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const auto inserted = numbers.emplace(nodes[corner], points.size());
      if (inserted.second) {
        const std::array<double, 3> p = embedding(nodes[corner]);
        points.push_back(Point(p[0], p[1], p[2]));
      }
      hexahedron[corner] = inserted.first->second;
    }
    hexahedra.push_back(hexahedron);
  }
}

inline void check_generator_parameter(bool condition, const std::string& message)
{
  if (!condition)
    throw Input_error(Input_error::Element::PARAMETER, 0, message);
}

// A number of cells as the signed integer that lattice coordinates are made of.
inline int lattice_count(std::size_t count)
{
  check_generator_parameter(count >= 1 && count <= 1000000, "a number of cells must be between 1 and a million");
  return static_cast<int>(count);
}

// The hexahedra of the box of `ni` x `nj` x `nk` lattice cells whose first node
// is (0, i0, j0, k0).
inline void append_lattice_box(int i0, int j0, int k0, int ni, int nj, int nk,
                               std::vector<Lattice_hexahedron>& lattice_hexahedra)
{
  for (int k = k0; k < k0 + nk; ++k)
    for (int j = j0; j < j0 + nj; ++j)
      for (int i = i0; i < i0 + ni; ++i)
        lattice_hexahedra.push_back({{{0, i, j, k},
                                      {0, i + 1, j, k},
                                      {0, i + 1, j + 1, k},
                                      {0, i, j + 1, k},
                                      {0, i, j, k + 1},
                                      {0, i + 1, j, k + 1},
                                      {0, i + 1, j + 1, k + 1},
                                      {0, i, j + 1, k + 1}}});
}

// The edges around the lattice square [0,n]x[0,n], counter-clockwise, as pairs
// of lattice positions.
inline std::vector<std::array<std::array<int, 2>, 2>> lattice_square_boundary(int n)
{
  std::vector<std::array<std::array<int, 2>, 2>> edges;
  for (int t = 0; t < n; ++t) {
    edges.push_back({{{t, 0}, {t + 1, 0}}});
    edges.push_back({{{n, t}, {n, t + 1}}});
    edges.push_back({{{n - t, n}, {n - t - 1, n}}});
    edges.push_back({{{0, n - t}, {0, n - t - 1}}});
  }
  return edges;
}

// `layers` rings of hexahedra around the lattice square [0,n]x[0,n], each
// `nz` cells high. Layer 0 is the boundary of the square itself.
inline void append_lattice_rings(int n, int layers, int nz, std::vector<Lattice_hexahedron>& lattice_hexahedra)
{
  for (int k = 0; k < nz; ++k)
    for (int layer = 0; layer < layers; ++layer)
      for (const auto& edge : lattice_square_boundary(n)) {
        const auto node = [&](int l, int end, int height) {
          return Lattice_node{{l, edge[end][0], edge[end][1], height}};
        };
        lattice_hexahedra.push_back(
          {{node(layer, 0, k), node(layer + 1, 0, k), node(layer + 1, 1, k), node(layer, 1, k), node(layer, 0, k + 1),
            node(layer + 1, 0, k + 1), node(layer + 1, 1, k + 1), node(layer, 1, k + 1)}});
      }
}

// Maps the cube [-1,1]^3 to the unit ball, concentric cubes to concentric
// spheres and each face with equal angles; the square [-1,1]^2 (z = 0) goes to
// the unit disk.
inline std::array<double, 3> cube_to_ball(const std::array<double, 3>& p)
{
  const double radius = (std::max)(std::abs(p[0]), (std::max)(std::abs(p[1]), std::abs(p[2])));
  if (radius == 0)
    return p;
  std::array<double, 3> direction;
  double squared_length = 0;
  for (int d = 0; d < 3; ++d) {
    direction[d] = std::tan(pi / 4 * p[d] / radius);
    squared_length += direction[d] * direction[d];
  }
  for (double& coordinate : direction)
    coordinate *= radius / std::sqrt(squared_length);
  return direction;
}

// The core of an O-grid in the unit ball: half the size, and with its faces
// bulged toward the sphere to open the angles where three blocks meet.
inline std::array<double, 3> o_grid_core(const std::array<double, 3>& p)
{
  constexpr double size = .5, bulge = .4;
  const std::array<double, 3> ball = cube_to_ball(p);
  return {{size * ((1 - bulge) * p[0] + bulge * ball[0]), size * ((1 - bulge) * p[1] + bulge * ball[1]),
           size * ((1 - bulge) * p[2] + bulge * ball[2])}};
}

// The node of an O-grid in the unit ball at `p` on the cube [-1,1]^3 and a
// fraction `t` of the way from the core to the sphere.
inline std::array<double, 3> o_grid_node(const std::array<double, 3>& p, double t)
{
  const std::array<double, 3> core = o_grid_core(p), ball = cube_to_ball(p);
  return {{(1 - t) * core[0] + t * ball[0], (1 - t) * core[1] + t * ball[1], (1 - t) * core[2] + t * ball[2]}};
}

// The fraction of a segment before its node `i` if `n` cells grow geometrically
// and the last is `grading` times the first.
inline double graded_fraction(int i, int n, double grading)
{
  if (n == 1 || grading == 1)
    return static_cast<double>(i) / n;
  const double log_ratio = std::log(grading) / (n - 1);
  return std::expm1(i * log_ratio) / std::expm1(n * log_ratio);
}

} // namespace internal

/*!
 * \addtogroup PkgHexMeshOptimizationGenerators
 *
 * The generators fill `points` and `hexahedra` (their former contents are
 * lost). They are deterministic; every hexahedron is positively oriented and
 * convex enough that all corners are positive, and every vertex is used.
 * Angles are in radians, lengths in the caller's unit. All of them throw
 * `Input_error` if a number of cells is 0 or a length is not positive.
 *
 * `PointRange` is a model of `BackInsertionSequence` whose value type can be
 * constructed from three `double`s, such as `std::vector<Kernel::Point_3>`.
 */

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a box [0,sizes[0]] x [0,sizes[1]] x [0,sizes[2]] of
 * cells[0] x cells[1] x cells[2] hexahedra.
 *
 * \param points the vertices
 * \param hexahedra the indices of the 8 vertices of each hexahedron
 * \param cells the numbers of hexahedra along the three axes
 * \param sizes the lengths of the box along the three axes
 * \param gradings the length of the last cell over that of the first, for each
 *        axis: cells grow geometrically, as toward the wall of a boundary layer
 */
template <class PointRange>
void make_block(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra,
                const std::array<std::size_t, 3>& cells, const std::array<double, 3>& sizes = {{1, 1, 1}},
                const std::array<double, 3>& gradings = {{1, 1, 1}})
{
  std::array<int, 3> n;
  for (int d = 0; d < 3; ++d) {
    n[d] = internal::lattice_count(cells[d]);
    internal::check_generator_parameter(sizes[d] > 0, "the size of a block must be positive");
    internal::check_generator_parameter(gradings[d] > 0, "a grading must be positive");
  }

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, n[0], n[1], n[2], lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      std::array<double, 3> p;
      for (int d = 0; d < 3; ++d)
        p[d] = sizes[d] * internal::graded_fraction(node[d + 1], n[d], gradings[d]);
      return p;
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a bar of square section, swept along an arc of the given length that turns by
 * `bend`, its section turning by `twist` on the way: along x at first, bent
 * toward z. It has `n_along` x `n_across` x `n_across` hexahedra.
 *
 * The sweep keeps the volume length * width^2 of the straight bar.
 * `Input_error` is also thrown if the arc is too narrow for the section.
 */
template <class PointRange>
void make_bent_bar(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n_along,
                   std::size_t n_across, double length = 4, double width = 1, double bend = internal::pi / 2,
                   double twist = 0)
{
  const int ni = internal::lattice_count(n_along), nj = internal::lattice_count(n_across);
  internal::check_generator_parameter(length > 0 && width > 0, "the sizes of a bar must be positive");
  internal::check_generator_parameter(std::abs(bend) * width < std::sqrt(2.) * length,
                                      "the arc of a bar is too narrow for its section");

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, ni, nj, nj, lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      const double s = static_cast<double>(node[1]) / ni;
      const double u = width * (static_cast<double>(node[2]) / nj - .5);
      const double v = width * (static_cast<double>(node[3]) / nj - .5);
      const double y = std::cos(twist * s) * u - std::sin(twist * s) * v;
      const double h = std::sin(twist * s) * u + std::cos(twist * s) * v;
      const double angle = bend * s;
      // The limit of a straight bar is taken where the chord would lose its digits
      const double chord_x = std::abs(bend) < 1e-8 ? length * s : length / bend * std::sin(angle);
      const double chord_z = std::abs(bend) < 1e-8 ? 0 : length / bend * (1 - std::cos(angle));
      return std::array<double, 3>{{chord_x - std::sin(angle) * h, y, chord_z + std::cos(angle) * h}};
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a cylinder around the z axis as an O-grid: a core of n x n columns, and
 * `n` / 2 (at least one) rings around it; `n_along` cells high. It has
 * n_along * (n * n + 4 * n * rings) hexahedra.
 */
template <class PointRange>
void make_cylinder(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n,
                   std::size_t n_along, double radius = 1, double height = 2)
{
  const int ni = internal::lattice_count(n), nz = internal::lattice_count(n_along);
  const int rings = (std::max)(1, ni / 2);
  internal::check_generator_parameter(radius > 0 && height > 0, "the sizes of a cylinder must be positive");

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, ni, ni, nz, lattice);
  internal::append_lattice_rings(ni, rings, nz, lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      const std::array<double, 3> p = internal::o_grid_node({{2. * node[1] / ni - 1, 2. * node[2] / ni - 1, 0}},
                                                            static_cast<double>(node[0]) / rings);
      return std::array<double, 3>{{radius * p[0], radius * p[1], height * node[3] / nz}};
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a ball around the origin as an O-grid: a core of n x n x n hexahedra and
 * `n` / 2 (at least one) shells of 6 n x n around it.
 */
template <class PointRange>
void make_ball(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n, double radius = 1)
{
  const int ni = internal::lattice_count(n);
  const int shells = (std::max)(1, ni / 2);
  internal::check_generator_parameter(radius > 0, "the radius of a ball must be positive");

  // The quads on the faces of the core, counter-clockwise seen from outside
  std::vector<internal::Lattice_quad> quads;
  for (int axis = 0; axis < 3; ++axis)
    for (int a = 0; a < ni; ++a)
      for (int b = 0; b < ni; ++b) {
        const auto node = [&](int c, int u, int v) {
          internal::Lattice_node name = {{0, 0, 0, 0}};
          name[1 + axis] = c;
          name[1 + (axis + 1) % 3] = u;
          name[1 + (axis + 2) % 3] = v;
          return name;
        };
        quads.push_back({{node(ni, a, b), node(ni, a + 1, b), node(ni, a + 1, b + 1), node(ni, a, b + 1)}});
        quads.push_back({{node(0, a, b), node(0, a, b + 1), node(0, a + 1, b + 1), node(0, a + 1, b)}});
      }

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, ni, ni, ni, lattice);
  for (int shell = 0; shell < shells; ++shell)
    for (const internal::Lattice_quad& quad : quads) {
      internal::Lattice_hexahedron hexahedron;
      for (int corner = 0; corner < 4; ++corner) {
        hexahedron[corner] = hexahedron[corner + 4] = quad[corner];
        hexahedron[corner][0] = shell;
        hexahedron[corner + 4][0] = shell + 1;
      }
      lattice.push_back(hexahedron);
    }
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      std::array<double, 3> p = internal::o_grid_node({{2. * node[1] / ni - 1, 2. * node[2] / ni - 1,
                                                        2. * node[3] / ni - 1}},
                                                      static_cast<double>(node[0]) / shells);
      for (double& coordinate : p)
        coordinate *= radius;
      return p;
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a square plate [-size/2,size/2]^2 x [0,thickness] with a round hole through
 * its centre: n rings of 4 n cells around the hole, `n_through` cells thick.
 * `Input_error` is also thrown if the hole does not fit in the plate.
 */
template <class PointRange>
void make_plate_with_hole(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n,
                          std::size_t n_through, double size = 4, double hole_radius = 1, double thickness = 1)
{
  const int ni = internal::lattice_count(n), nz = internal::lattice_count(n_through);
  internal::check_generator_parameter(size > 0 && hole_radius > 0 && thickness > 0,
                                      "the sizes of a plate must be positive");
  internal::check_generator_parameter(2 * hole_radius < size, "the hole does not fit in the plate");

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_rings(ni, ni, nz, lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      const std::array<double, 3> square = {{2. * node[1] / ni - 1, 2. * node[2] / ni - 1, 0}};
      const std::array<double, 3> circle = internal::cube_to_ball(square);
      const double t = static_cast<double>(node[0]) / ni;
      return std::array<double, 3>{{(1 - t) * hole_radius * circle[0] + t * size / 2 * square[0],
                                    (1 - t) * hole_radius * circle[1] + t * size / 2 * square[1],
                                    thickness * node[3] / nz}};
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates an L of three cubes of edge length `size`, each of n x n x n hexahedra, with
 * a reentrant sharp edge.
 */
template <class PointRange>
void make_l_shape(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n,
                  double size = 1)
{
  const int ni = internal::lattice_count(n);
  internal::check_generator_parameter(size > 0, "the size of an L must be positive");

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, 2 * ni, ni, ni, lattice);
  internal::append_lattice_box(0, ni, 0, ni, ni, ni, lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      return std::array<double, 3>{{size * node[1] / ni, size * node[2] / ni, size * node[3] / ni}};
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a T of four cubes of edge length `size`, each of n x n x n hexahedra: a stem
 * under the middle of a bar of three, with two reentrant sharp edges.
 */
template <class PointRange>
void make_t_shape(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n,
                  double size = 1)
{
  const int ni = internal::lattice_count(n);
  internal::check_generator_parameter(size > 0, "the size of a T must be positive");

  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(ni, 0, 0, ni, ni, ni, lattice);
  internal::append_lattice_box(0, ni, 0, 3 * ni, ni, ni, lattice);
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      return std::array<double, 3>{{size * node[1] / ni, size * node[2] / ni, size * node[3] / ni}};
    },
    points, hexahedra);
}

/*!
 * \ingroup PkgHexMeshOptimizationGenerators
 *
 * generates a closed ring of rectangular section around the z axis, of genus 1, with
 * `n_around` (at least 3) x `n_across` x `n_across` hexahedra.
 */
template <class PointRange>
void make_ring(PointRange& points, std::vector<std::array<std::size_t, 8>>& hexahedra, std::size_t n_around,
               std::size_t n_across, double inner_radius = 1, double outer_radius = 2, double height = 1)
{
  const int na = internal::lattice_count(n_around), nj = internal::lattice_count(n_across);
  internal::check_generator_parameter(na >= 3, "a ring needs at least three cells around its axis");
  internal::check_generator_parameter(0 < inner_radius && inner_radius < outer_radius && height > 0,
                                      "a ring needs 0 < inner radius < outer radius and a positive height");

  // i across, j around, k up: a right-handed frame
  std::vector<internal::Lattice_hexahedron> lattice;
  internal::append_lattice_box(0, 0, 0, nj, na, nj, lattice);
  for (internal::Lattice_hexahedron& hexahedron : lattice)
    for (internal::Lattice_node& node : hexahedron)
      node[2] %= na;
  internal::build_lattice_mesh(
    lattice,
    [&](const internal::Lattice_node& node) {
      const double radius = inner_radius + (outer_radius - inner_radius) * node[1] / nj;
      const double angle = 2 * internal::pi * node[2] / na;
      return std::array<double, 3>{{radius * std::cos(angle), radius * std::sin(angle), height * node[3] / nj}};
    },
    points, hexahedra);
}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_HEX_MESH_GENERATORS_H
