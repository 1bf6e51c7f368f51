// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_EDGE_LENGTHS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_EDGE_LENGTHS_H

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
#include <utility>
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
inline std::vector<double> smooth_edge_lengths(const Edge_relations& relations, const std::vector<double>& wanted,
                                               bool couples_sheets = true)
{
  const double tolerance = 1e-6;   // of the mean length
  const int most_iterations = 500; // some tens are needed
  const std::size_t n = wanted.size();
  const double mean = std::accumulate(wanted.begin(), wanted.end(), 0.0) / double(n);
  std::vector<double> lengths(n, mean);
  conjugate_gradients(Length_system(relations, couples_sheets), wanted,
                      {tolerance * tolerance * mean * mean * double(n), most_iterations, n}, lengths);
  return lengths;
}

// Boundary edges are drawn to their lengths, interior ones to the mean boundary length: it stands in for L_A because
// the interior of a tangled mesh says nothing about lengths.
inline std::vector<double> estimate_edge_lengths(const Hexahedral_complex& complex, const Edge_relations& relations,
                                                 const Positions& points)
{
  std::vector<double> wanted = edge_lengths(complex, points);
  const double mean = mean_boundary_edge_length(complex, points);
  for (std::size_t e = 0; e < wanted.size(); ++e)
    if (!complex.is_boundary_edge[e])
      wanted[e] = mean;
  return smooth_edge_lengths(relations, wanted);
}

struct Target_lengths
{
  enum class Origin {
    ESTIMATED,
    OWN, // those of the mesh
    ASKED_FOR
  };

  Target_lengths(Origin where_from, std::vector<double> values)
    : origin(where_from)
    , lengths(std::move(values))
    , certainty(lengths.size(), origin == Origin::ASKED_FOR ? 1. : 0.)
  {}

  Origin origin;
  std::vector<double> lengths;
  std::vector<double> certainty; // of each: 0 is a guess, 1 is not to be changed
};

// Values of edges, spread along the sheets of hexahedra from those that are known to the others, whose own ones count
// where a sheet has none that is known. O(edge pairs).
inline std::vector<double> spread_along_sheets(const Edge_relations& relations, const std::vector<char>& is_known,
                                               std::vector<double> values)
{
  const double least_weight = 1e-3; // of those that are not known
  const double tolerance = 1e-3;    // root mean square
  const int most_iterations = 500;
  const std::size_t n = values.size();
  std::vector<double> weights(n), wanted(n);
  for (std::size_t e = 0; e < n; ++e) {
    weights[e] = is_known[e] ? 1 : least_weight;
    wanted[e] = weights[e] * values[e];
  }
  conjugate_gradients(Length_system(relations, false, weights), wanted,
                      {tolerance * tolerance * double(n), most_iterations, n}, values);
  return values;
}

// What the lengths of a mesh say along the sheets of hexahedra.
class Lengths_along_sheets
{
public:
  // counts: of the edges, whether their lengths say something; the others have the estimated ones. Edges agree when
  // their lengths and those of all that are parallel to them in a hexahedron differ by no more than the factor.
  Lengths_along_sheets(const Edge_relations& relations, const std::vector<double>& lengths,
                       const std::vector<char>& counts, const std::vector<double>& estimated, double agreement)
    : estimated_(estimated)
  {
    const double tolerance = std::log(agreement);
    std::vector<double> logarithms(lengths.size()), agree(lengths.size());
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      logarithms[e] = std::log(counts[e] ? lengths[e] : estimated[e]);
      agree[e] = counts[e];
    }
    for (const Edge_pair& p : relations.parallel) {
      const std::size_t e = p.first / 2, f = p.second / 2;
      if (counts[e] && counts[f] && std::abs(logarithms[e] - logarithms[f]) > tolerance)
        agree[e] = agree[f] = 0;
    }
    logarithms_ = spread_along_sheets(relations, counts, std::move(logarithms));
    agree_ = spread_along_sheets(relations, counts, std::move(agree));
  }

  // The logarithm of the length over the estimated one.
  double factor(std::size_t e) const { return logarithms_[e] - std::log(estimated_[e]); }

  // Lengths are meant, not an accident, where the edges of a sheet agree and the estimate is clearly wrong. Nothing is
  // certain up to the first factor and part, all from the second on.
  double certainty(std::size_t e, double unclear, double clear, double few, double most) const
  {
    return part_between(std::abs(factor(e)), std::log(unclear), std::log(clear)) * part_between(agree_[e], few, most);
  }

private:
  // 0 up to low, 1 from high on
  static double part_between(double x, double low, double high)
  {
    return (std::max)(0.0, (std::min)(1.0, (x - low) / (high - low)));
  }

  const std::vector<double>& estimated_;
  std::vector<double> logarithms_, agree_; // agree_: the part of the edges
};

// Of a mesh whose interior can be trusted: its own lengths, smoothed along the sheets of hexahedra, and certain where
// they are meant, so that layers keep the heights that they have; where it is only poor it may be regraded.
// O(edge pairs).
inline Target_lengths own_edge_lengths(const Hexahedral_complex& complex, const Edge_relations& relations,
                                       const Positions& points)
{
  const std::vector<double> estimated = estimate_edge_lengths(complex, relations, points);
  const Lengths_along_sheets own(relations, edge_lengths(complex, points),
                                 std::vector<char>(complex.edges.size(), true), estimated, 1.25);
  Target_lengths result(Target_lengths::Origin::OWN, estimated);
  for (std::size_t e = 0; e < estimated.size(); ++e) {
    result.certainty[e] = own.certainty(e, 1.1, 1.5, .6, .8);
    result.lengths[e] *= std::exp(own.factor(e));
  }
  return result;
}

// Of a tangled mesh: the estimate where it says nothing, and its own lengths where it does: those of boundary edges with
// none but sound hexahedra around them are spread along the sheets, so that a fin or a layer that is thin stays so, also
// where it is tangled. Lengths that only interior edges have are no evidence (measured: an organic model whose layer
// under the surface is thin throughout is better regraded, its 99th percentile of the ratios of edges is 3.4 instead of
// 7). O(edge pairs).
inline Target_lengths lengths_along_sound_sheets(const Hexahedral_complex& complex, const Edge_relations& relations,
                                                 const Positions& points, const std::vector<char>& is_sound)
{
  const std::vector<double> present = edge_lengths(complex, points);
  std::vector<char> counts(complex.edges.size());
  for (std::size_t e = 0; e < counts.size(); ++e)
    counts[e] = present[e] > 0 && complex.is_boundary_edge[e];
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
    for (int directed : complex.hexahedron_edges[h])
      if (!is_sound[h])
        counts[directed / 2] = false;
  const std::vector<double> estimated = estimate_edge_lengths(complex, relations, points);
  const Lengths_along_sheets sound(relations, present, counts, estimated, 1.1);
  Target_lengths result(Target_lengths::Origin::ESTIMATED, estimated);
  for (std::size_t e = 0; e < estimated.size(); ++e) {
    result.certainty[e] = sound.certainty(e, 1.5, 2.5, .8, .9);
    result.lengths[e] *= std::exp(result.certainty[e] * sound.factor(e));
  }
  return result;
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
