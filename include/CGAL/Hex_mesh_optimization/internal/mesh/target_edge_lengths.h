// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_EDGE_LENGTHS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_EDGE_LENGTHS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Target edge lengths: their estimation from the boundary (eq. 22) and their
// update where the quality is low (eq. 23, 24).

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/conjugate_gradients.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

inline std::vector<double> edge_lengths(const Hexahedral_complex& complex, const Positions& points)
{
  std::vector<double> lengths(complex.edges.size());
  for (std::size_t e = 0; e < lengths.size(); ++e)
    lengths[e] = (points[complex.edges[e][1]] - points[complex.edges[e][0]]).norm();
  return lengths;
}

inline double mean_boundary_edge_length(const Hexahedral_complex& complex, const Positions& points)
{
  double sum = 0;
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
    sum += (points[complex.edges[e.edge][1]] - points[complex.edges[e.edge][0]]).norm();
  return sum / double(complex.boundary_edges.size());
}

// The system of eq. 22: lengths near the wanted ones, L_A, and similar between topologically parallel edges, those that
// a sheet of hexahedra crosses, and between consecutive ones, which go on from sheet to sheet, or else not.
class Length_system
{
public:
  // weights: of the wanted lengths, 1 if there are none.
  Length_system(const Edge_relations& relations, bool couples_sheets, const std::vector<double>& weights = {})
    : relations_(relations)
    , couples_sheets_(couples_sheets)
    , diagonal_(relations.parallel_degree.size())
  {
    for (std::size_t e = 0; e < diagonal_.size(); ++e)
      diagonal_[e] = (weights.empty() ? 1 : weights[e]) +
                     2 * (relations.parallel_degree[e] + (couples_sheets ? relations.consecutive_degree[e] : 0));
  }

  void multiply(const std::vector<double>& x, std::vector<double>& y) const
  {
    for (std::size_t e = 0; e < diagonal_.size(); ++e)
      y[e] = diagonal_[e] * x[e];
    // each pair stands twice in the sums of eq. 22, once for either edge
    subtract(relations_.parallel, x, y);
    if (couples_sheets_)
      subtract(relations_.consecutive, x, y);
  }

  double precondition(std::size_t e, double r) const { return r / diagonal_[e]; }
  static bool is_fixed(std::size_t) { return false; }

private:
  static void subtract(const std::vector<Edge_pair>& pairs, const std::vector<double>& x, std::vector<double>& y)
  {
    for (const Edge_pair& p : pairs) {
      y[p.first / 2] -= 2 * x[p.second / 2];
      y[p.second / 2] -= 2 * x[p.first / 2];
    }
  }

  const Edge_relations& relations_;
  const bool couples_sheets_;
  std::vector<double> diagonal_;
};

// Minimizes eq. 22. The system is diagonally dominant, so conjugate gradients need a number of steps that does not
// depend on the mesh; each is linear in the number of edge pairs.
inline std::vector<double> smooth_edge_lengths(const Edge_relations& relations, const std::vector<double>& wanted)
{
  const double tolerance = 1e-6;   // of the mean length
  const int most_iterations = 500; // some tens are needed
  const std::size_t n = wanted.size();
  const double mean = std::accumulate(wanted.begin(), wanted.end(), 0.0) / double(n);
  std::vector<double> lengths(n, mean);
  conjugate_gradients(Length_system(relations, true), wanted,
                      {tolerance * tolerance * mean * mean * double(n), most_iterations, n}, lengths);
  return lengths;
}

// Boundary edges are drawn to their lengths, interior ones to the mean boundary length: it stands in for L_A because
// the interior of a tangled mesh says nothing about lengths.
inline std::vector<double> estimate_edge_lengths(const Hexahedral_complex& complex, const Edge_relations& relations,
                                                 const Positions& points, double mean)
{
  std::vector<double> wanted = edge_lengths(complex, points);
  for (std::size_t e = 0; e < wanted.size(); ++e)
    if (!complex.is_boundary_edge[e])
      wanted[e] = mean;
  return smooth_edge_lengths(relations, wanted);
}

inline std::vector<double> estimate_edge_lengths(const Hexahedral_complex& complex, const Edge_relations& relations,
                                                 const Positions& points)
{
  return estimate_edge_lengths(complex, relations, points, mean_boundary_edge_length(complex, points));
}

// eq. 23, 24: lengths move to the reached ones where the worst hexahedron around
// the edge is poor.
inline void update_edge_lengths(const Hexahedral_complex& complex, const Positions& points,
                                const std::vector<double>& hexahedron_quality, double sigma,
                                std::vector<double>& lengths)
{
  std::vector<double> worst(lengths.size(), 1.0);
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
    for (int directed : complex.hexahedron_edges[h])
      worst[directed / 2] = (std::min)(worst[directed / 2], hexahedron_quality[h]);
  const std::vector<double> reached = edge_lengths(complex, points);
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const double q = (std::max)(worst[e], 0.0); // an inverted element is as poor as can be
    const double w = std::exp(-0.5 * (q / sigma) * (q / sigma));
    lengths[e] = (1 - w) * lengths[e] + w * reached[e];
  }
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_EDGE_LENGTHS_H
