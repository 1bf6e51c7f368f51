// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Quality measures of hexahedra, scaled Jacobian and edge ratio, and their
// statistics over a mesh.

#include <CGAL/Hex_mesh_optimization/Quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/// \ingroup PkgHexMeshOptimizationQuality
/// @{

/*!
 * returns the *scaled Jacobian* of a hexahedron: the minimum over its eight corners of the determinant of
 * the three edge vectors that leave the corner, each scaled to length 1. This is the value that the
 * literature on hexahedral meshing reports.
 *
 * The value lies in [-1, 1], has no unit, and does not change under translation, rotation and uniform
 * scaling. It is 1 exactly for right-angled boxes, of any edge lengths. A hexahedron with a value of 0 or less
 * is *inverted*; one with a positive value may still be folded between its corners, see `is_valid_hexahedron()`.
 * A hexahedron with an edge of length zero, or with a coordinate that is not finite, has the value -1.
 *
 * Lengths neither over- nor underflow: only the differences of the coordinates must be finite. The value is
 * exact up to a few units in the last place of 1.
 *
 * \tparam Point a model of `HexMeshOptimizationPoint_3`
 *
 * \param p0,p1,p2,p3,p4,p5,p6,p7 the corners: `p0` to `p3` around the bottom, counter-clockwise when seen from inside
 *        the hexahedron, and `p4` to `p7` above them
 */
template <class Point>
double scaled_jacobian(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4,
                       const Point& p5, const Point& p6, const Point& p7)
{
  return internal::scaled_jacobian(internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7));
}

/*!
 * returns the scaled Jacobian of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` whose value type is a model of `HexMeshOptimizationPoint_3`
 */
template <class PointRange>
double scaled_jacobian(const PointRange& p)
{
  return internal::scaled_jacobian(internal::hexahedron_coordinates(p));
}

/*!
 * returns the minimum of `scaled_jacobian()` and of the same determinant for the three principal axes, the
 * sums of the four edge vectors in each direction, which span the Jacobian at the center.
 *
 * This nine-point value is what the Verdict library defines and what HexaLab displays. It is never greater than
 * `scaled_jacobian()`.
 */
template <class Point>
double scaled_jacobian_with_center(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4,
                                   const Point& p5, const Point& p6, const Point& p7)
{
  const auto x = internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7);
  return (std::min)(internal::scaled_jacobian(x), internal::center_scaled_jacobian(x));
}

/*!
 * returns the nine-point scaled Jacobian of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` whose value type is a model of `HexMeshOptimizationPoint_3`
 */
template <class PointRange>
double scaled_jacobian_with_center(const PointRange& p)
{
  const auto x = internal::hexahedron_coordinates(p);
  return (std::min)(internal::scaled_jacobian(x), internal::center_scaled_jacobian(x));
}

/*!
 * returns the length of the longest edge of a hexahedron divided by the length of its shortest edge.
 *
 * The value is 1 for a cube and greater for a slab or a needle, which the scaled Jacobian does not see. It is infinite
 * for a hexahedron with an edge of length zero, or with a coordinate that is not finite.
 *
 * \tparam Point a model of `HexMeshOptimizationPoint_3`
 */
template <class Point>
double edge_ratio(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4, const Point& p5,
                  const Point& p6, const Point& p7)
{
  return internal::edge_ratio(internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7));
}

/*!
 * returns the edge ratio of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` whose value type is a model of `HexMeshOptimizationPoint_3`
 */
template <class PointRange>
double edge_ratio(const PointRange& p)
{
  return internal::edge_ratio(internal::hexahedron_coordinates(p));
}

/*!
 * returns the scaled Jacobian of each hexahedron of a mesh, in the order of the hexahedra.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type is a model of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a range of ranges of eight indices into the points each
 */
template <class PointRange, class HexahedronRange>
std::vector<double> scaled_jacobians(const PointRange& points, const HexahedronRange& hexahedra)
{
  std::vector<double> result;
  result.reserve(hexahedra.size());
  for (const auto& hexahedron : hexahedra)
    result.push_back(internal::scaled_jacobian(internal::hexahedron_coordinates(points, hexahedron)));
  return result;
}

/*!
 * computes the statistics of the qualities of a mesh, in one pass that takes time linear in the number of hexahedra.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type is a model of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a range of ranges of eight indices into the points each
 */
template <class PointRange, class HexahedronRange>
Quality_statistics quality_statistics(const PointRange& points, const HexahedronRange& hexahedra)
{
  return internal::quality_statistics(points, hexahedra);
}

/*!
 * computes the statistics of the qualities of a linear cell complex.
 *
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 *
 * \throws Input_error as `linear_cell_complex_to_hexahedra()` does
 */
template <class LCC>
Quality_statistics quality_statistics(const LCC& lcc)
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  return quality_statistics(points, hexahedra);
}

/*!
 * counts the hexahedra of a mesh by their scaled Jacobian.
 *
 * The interval [-1, 1] is divided into `number_of_bins` bins of equal width. Entry `i` of the result counts the
 * hexahedra with a scaled Jacobian of at least `-1 + 2. * i / number_of_bins` and less than
 * `-1 + 2. * (i + 1) / number_of_bins`; the last bin includes 1. So with an even number of bins, a scaled Jacobian
 * of 0 is counted in the upper half. The counts sum up to the number of hexahedra.
 *
 * \pre `number_of_bins > 0`
 */
template <class PointRange, class HexahedronRange>
std::vector<std::size_t> quality_histogram(const PointRange& points, const HexahedronRange& hexahedra,
                                           std::size_t number_of_bins)
{
  CGAL_precondition(number_of_bins > 0);
  std::vector<std::size_t> result(number_of_bins, 0);
  for (double quality : scaled_jacobians(points, hexahedra)) {
    const auto bin = static_cast<std::size_t>((quality + 1) / 2 * double(number_of_bins));
    ++result[(std::min)(bin, number_of_bins - 1)];
  }
  return result;
}

/// @}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H
