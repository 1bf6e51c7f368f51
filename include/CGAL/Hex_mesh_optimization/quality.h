// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H

// Quality measures of hexahedra, scaled Jacobian and edge ratio, and their
// statistics over a mesh.

#include <CGAL/assertions.h>

#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {

namespace internal {

// The vector scaled to length 1. Zero vectors, and those that are not finite,
// become NaN, which spreads to every determinant they enter.
inline Coordinates<double> normalized(Coordinates<double> a)
{
  double squared_length = scalar_product(a, a);
  if (!(squared_length > 1e-280 && squared_length < 1e280))
  {
    // the square may have over- or underflowed: bring the largest component to 1 first
    const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    for (double& x : a)
      x /= largest;
    squared_length = scalar_product(a, a);
  }
  const double length = std::sqrt(squared_length);
  return {{a[0] / length, a[1] / length, a[2] / length}};
}

// det(a, b, c) for unit vectors; -1 where one of them is undefined.
inline double scaled_determinant(const Coordinates<double>& a, const Coordinates<double>& b,
                                 const Coordinates<double>& c)
{
  const double d = scalar_product(cross_product(a, b), c);
  return d > -1 ? (std::min)(d, 1.) : -1.;
}

inline double scaled_jacobian(const Hexahedron_coordinates& x)
{
  Edge_vectors<double> edges(x);
  for (auto* direction : {&edges.u, &edges.v, &edges.w})
    for (Coordinates<double>& e : *direction)
      e = normalized(e);
  double result = 1;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        result = (std::min)(result, scaled_determinant(edges.u[j + 2 * k], edges.v[i + 2 * k],
                                                       edges.w[i + 2 * j]));
  return result;
}

// The scaled determinant of the principal axes: the Jacobian at the center.
inline double center_scaled_jacobian(const Hexahedron_coordinates& x)
{
  const Edge_vectors<double> edges(x);
  auto principal_axis = [](const std::array<Coordinates<double>, 4>& e)
  {
    Coordinates<double> axis;
    for (int i = 0; i < 3; ++i)
      axis[i] = .25 * e[0][i] + .25 * e[1][i] + .25 * e[2][i] + .25 * e[3][i];
    return normalized(axis);
  };
  return scaled_determinant(principal_axis(edges.u), principal_axis(edges.v),
                            principal_axis(edges.w));
}

inline double edge_ratio(const Hexahedron_coordinates& x)
{
  const Edge_vectors<double> edges(x);
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  for (const auto* direction : {&edges.u, &edges.v, &edges.w})
    for (const Coordinates<double>& e : *direction)
    {
      const double length = std::hypot(e[0], e[1], e[2]);
      if (!(length > 0) || std::isinf(length))
        return std::numeric_limits<double>::infinity();
      shortest = (std::min)(shortest, length);
      longest = (std::max)(longest, length);
    }
  return longest / shortest;
}

} // namespace internal

/// \ingroup PkgHexMeshOptimizationRef
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
 * \tparam Point a model of `Kernel::Point_3`, with coordinates that `CGAL::to_double()` converts
 *
 * \param p0,p1,p2,p3,p4,p5,p6,p7 the corners: `p0` to `p3` around the bottom, counter-clockwise when seen from inside
 *        the hexahedron, and `p4` to `p7` above them
 */
template <class Point>
double scaled_jacobian(const Point& p0, const Point& p1, const Point& p2, const Point& p3,
                       const Point& p4, const Point& p5, const Point& p6, const Point& p7)
{
  return internal::scaled_jacobian(internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7));
}

/*!
 * returns the scaled Jacobian of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` with value type a model of `Kernel::Point_3`
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
 * This nine-point value is what the Verdict library defines and what HexaLab displays. It is never greater than `scaled_jacobian()`.
 */
template <class Point>
double scaled_jacobian_with_center(const Point& p0, const Point& p1, const Point& p2, const Point& p3,
                                   const Point& p4, const Point& p5, const Point& p6, const Point& p7)
{
  const auto x = internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7);
  return (std::min)(internal::scaled_jacobian(x), internal::center_scaled_jacobian(x));
}

/*!
 * returns the nine-point scaled Jacobian of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` with value type a model of `Kernel::Point_3`
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
 * \tparam Point a model of `Kernel::Point_3`, with coordinates that `CGAL::to_double()` converts
 */
template <class Point>
double edge_ratio(const Point& p0, const Point& p1, const Point& p2, const Point& p3,
                  const Point& p4, const Point& p5, const Point& p6, const Point& p7)
{
  return internal::edge_ratio(internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7));
}

/*!
 * returns the edge ratio of the hexahedron with the eight corners `p[0]`, ..., `p[7]`.
 *
 * \tparam PointRange a model of `RandomAccessRange` with value type a model of `Kernel::Point_3`
 */
template <class PointRange>
double edge_ratio(const PointRange& p)
{
  return internal::edge_ratio(internal::hexahedron_coordinates(p));
}

/*!
 * The quality of a hexahedral mesh in a few numbers. All qualities are free of a unit. In a mesh without
 * hexahedra, every number is 0.
 */
struct Quality_statistics
{
  /// The number of hexahedra of the mesh.
  std::size_t number_of_hexahedra = 0;

  /// The number of hexahedra with a scaled Jacobian of 0 or less.
  std::size_t number_of_inverted = 0;

  /// The number of hexahedra not certified by `is_valid_hexahedron()`: but for rounding at a scaled
  /// Jacobian of 0, the inverted ones and those that are folded between their corners.
  std::size_t number_of_invalid = 0;

  /// The minimum over the hexahedra of `scaled_jacobian()`.
  double minimum = 0;

  /// The average over the hexahedra of `scaled_jacobian()`.
  double average = 0;

  /// The standard deviation over the hexahedra of `scaled_jacobian()`; the divisor is the number of hexahedra.
  double standard_deviation = 0;

  /// The minimum over the hexahedra of `scaled_jacobian_with_center()`.
  double minimum_with_center = 0;

  /// The average over the hexahedra of `scaled_jacobian_with_center()`.
  double average_with_center = 0;

  /// The maximum over the hexahedra of `edge_ratio()`.
  double maximum_edge_ratio = 0;

  /// The median of `edge_ratio()`: entry `n / 2` of the `n` sorted values.
  double median_edge_ratio = 0;

  /// The 99th percentile of `edge_ratio()`: entry `n * 99 / 100` of the `n` sorted values.
  double edge_ratio_99 = 0;
};

/*!
 * returns the scaled Jacobian of each hexahedron of a mesh, in the order of the hexahedra.
 *
 * \tparam PointRange a model of `RandomAccessContainer` with value type a model of `Kernel::Point_3`
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
 * \tparam PointRange a model of `RandomAccessContainer` with value type a model of `Kernel::Point_3`
 * \tparam HexahedronRange a range of ranges of eight indices into the points each
 */
template <class PointRange, class HexahedronRange>
Quality_statistics quality_statistics(const PointRange& points, const HexahedronRange& hexahedra)
{
  Quality_statistics result;
  const std::size_t n = result.number_of_hexahedra = hexahedra.size();
  if (n == 0)
    return result;

  std::vector<double> qualities, edge_ratios;
  qualities.reserve(n);
  edge_ratios.reserve(n);
  result.minimum = result.minimum_with_center = 1;
  for (const auto& hexahedron : hexahedra)
  {
    const auto x = internal::hexahedron_coordinates(points, hexahedron);
    const double quality = internal::scaled_jacobian(x);
    const double with_center = (std::min)(quality, internal::center_scaled_jacobian(x));
    qualities.push_back(quality);
    edge_ratios.push_back(internal::edge_ratio(x));
    if (quality <= 0)
      ++result.number_of_inverted;
    if (internal::hexahedron_validity(x) != Validity::VALID)
      ++result.number_of_invalid;
    result.minimum = (std::min)(result.minimum, quality);
    result.average += quality;
    result.minimum_with_center = (std::min)(result.minimum_with_center, with_center);
    result.average_with_center += with_center;
  }
  result.average /= double(n);
  result.average_with_center /= double(n);

  double variance = 0;
  for (double quality : qualities)
    variance += (quality - result.average) * (quality - result.average);
  result.standard_deviation = std::sqrt(variance / double(n));

  auto entry = [&edge_ratios](std::size_t rank)
  {
    std::nth_element(edge_ratios.begin(), edge_ratios.begin() + rank, edge_ratios.end());
    return edge_ratios[rank];
  };
  result.median_edge_ratio = entry(n / 2);
  result.edge_ratio_99 = entry(n * 99 / 100);
  result.maximum_edge_ratio = entry(n - 1);
  return result;
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
  for (double quality : scaled_jacobians(points, hexahedra))
  {
    const auto bin = static_cast<std::size_t>((quality + 1) / 2 * double(number_of_bins));
    ++result[(std::min)(bin, number_of_bins - 1)];
  }
  return result;
}

/// @}

} } // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_QUALITY_H
