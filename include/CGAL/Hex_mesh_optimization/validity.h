// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_VALIDITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_VALIDITY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Whether hexahedra are valid: proofs, for the coordinates as given, that their
// trilinear maps have positive Jacobian determinants everywhere.

#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/linear_cell_complex_to_hexahedra.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization {

/// \ingroup PkgHexMeshOptimizationQuality
/// @{

/*!
 * decides whether a hexahedron is valid: whether the Jacobian determinant of the trilinear map from the unit
 * cube that takes the corners to the given points is positive everywhere on the closed cube.
 *
 * The answers `Validity::VALID` and `Validity::INVALID` are proofs for the given coordinates, as `double`s: no rounding
 * error can falsify them. A hexahedron with a coordinate that is not finite is invalid, and so is one
 * with a determinant that reaches zero at a corner.
 *
 * The determinant is written in the Bernstein-B&eacute;zier basis, as proposed by Johnen, Weill and Remacle
 * (<em>Robust and efficient validation of the linear hexahedral element</em>, 2017). It has 27 coefficients, averages
 * of the determinants of three edge vectors. If they are all positive the hexahedron is valid; if one at a corner is
 * not, it is invalid; in between, the cube is subdivided. This is done with `double`s and a bound of their error,
 * then with intervals, and finally with exact numbers, each only where the one before could not decide.
 *
 * Almost every hexahedron of a mesh takes well below a microsecond. A determinant that
 * touches zero inside without becoming negative can only be decided where the zero is at a corner of a cell of the
 * subdivision; otherwise the answer is `Validity::UNDECIDED`.
 *
 * \tparam Point a model of `HexMeshOptimizationPoint_3`
 *
 * \param p0,p1,p2,p3,p4,p5,p6,p7 the corners: `p0` to `p3` around the bottom, counter-clockwise when seen from inside
 *        the hexahedron, and `p4` to `p7` above them
 * \param maximum_depth how often the cube is halved, in all directions, at the most, and not more than 100 times; the
 *        total number of cells is bounded as well
 *
 * The compiler must follow IEEE 754: no option `-ffast-math`.
 */
template <class Point>
Validity hexahedron_validity(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4,
                             const Point& p5, const Point& p6, const Point& p7,
                             int maximum_depth = internal::default_maximum_depth)
{
  return internal::hexahedron_validity(internal::hexahedron_coordinates(p0, p1, p2, p3, p4, p5, p6, p7), maximum_depth);
}

/*!
 * decides whether the hexahedron with the eight corners `p[0]`, ..., `p[7]` is valid.
 *
 * \tparam PointRange a model of `RandomAccessRange` whose value type is a model of `HexMeshOptimizationPoint_3`
 */
template <class PointRange>
Validity hexahedron_validity(const PointRange& p, int maximum_depth = internal::default_maximum_depth)
{
  return internal::hexahedron_validity(internal::hexahedron_coordinates(p), maximum_depth);
}

/*!
 * returns whether a hexahedron is proven valid, that is, whether `hexahedron_validity()` is `Validity::VALID`.
 *
 * \tparam Point a model of `HexMeshOptimizationPoint_3`
 */
template <class Point>
bool is_valid_hexahedron(const Point& p0, const Point& p1, const Point& p2, const Point& p3, const Point& p4,
                         const Point& p5, const Point& p6, const Point& p7)
{
  return hexahedron_validity(p0, p1, p2, p3, p4, p5, p6, p7) == Validity::VALID;
}

/*!
 * returns whether the hexahedron with the eight corners `p[0]`, ..., `p[7]` is proven valid.
 *
 * \tparam PointRange a model of `RandomAccessRange` whose value type is a model of `HexMeshOptimizationPoint_3`
 */
template <class PointRange>
bool is_valid_hexahedron(const PointRange& p)
{
  return hexahedron_validity(p) == Validity::VALID;
}

/*!
 * writes the indices of the hexahedra of a mesh that are not proven valid, in increasing order.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value type is a model of `HexMeshOptimizationPoint_3`
 * \tparam HexahedronRange a range of ranges of eight indices into the points each
 * \tparam OutputIterator a model of `OutputIterator` to which `std::size_t` can be assigned
 *
 * \returns the past-the-end iterator
 */
template <class PointRange, class HexahedronRange, class OutputIterator>
OutputIterator invalid_hexahedra(const PointRange& points, const HexahedronRange& hexahedra, OutputIterator out)
{
  std::size_t index = 0;
  for (const auto& hexahedron : hexahedra) {
    if (internal::hexahedron_validity(internal::hexahedron_coordinates(points, hexahedron)) != Validity::VALID)
      *out++ = index;
    ++index;
  }
  return out;
}

/*!
 * writes a dart of each hexahedron of a linear cell complex that is not proven valid: the one from corner 0 to corner
 * 4, in the order of `linear_cell_complex_to_hexahedra()`.
 *
 * \tparam LCC an instance of `Linear_cell_complex_for_combinatorial_map<3,3,...>` or
 *         `Linear_cell_complex_for_generalized_map<3,3,...>`
 * \tparam OutputIterator a model of `OutputIterator` to which `LCC::Dart_const_descriptor` (before \cgal 5.6,
 *         `LCC::Dart_const_handle`) can be assigned
 *
 * \throws Input_error as `linear_cell_complex_to_hexahedra()` does
 */
template <class LCC, class OutputIterator>
OutputIterator invalid_hexahedra(const LCC& lcc, OutputIterator out)
{
  std::vector<typename LCC::Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  linear_cell_complex_to_hexahedra(lcc, points, hexahedra);
  const internal::Hexahedra_of_linear_cell_complex<LCC> volumes(lcc);
  for (std::size_t h = 0; h < hexahedra.size(); ++h)
    if (internal::hexahedron_validity(internal::hexahedron_coordinates(points, hexahedra[h])) != Validity::VALID)
      *out++ = volumes.corners(h)[0];
  return out;
}

/// @}

} // namespace CGAL::Hex_mesh_optimization

#endif // CGAL_HEX_MESH_OPTIMIZATION_VALIDITY_H
