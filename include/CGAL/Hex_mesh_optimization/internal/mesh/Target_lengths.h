// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_LENGTHS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_LENGTHS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Target lengths, and how certain it is that they are wanted: what the lengths of a mesh itself say. The edges that a
// sheet of hexahedra crosses belong together.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/conjugate_gradients.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Target_lengths
{
  std::vector<double> lengths;
  std::vector<double> certainty; // of each: 0 is a guess, 1 is not to be changed
  bool are_asked_for = false;    // by the caller
};

inline Target_lengths guessed_lengths(std::vector<double> lengths)
{
  std::vector<double> certainty(lengths.size(), 0.0);
  return {std::move(lengths), std::move(certainty)};
}

inline Target_lengths lengths_asked_for(std::vector<double> lengths)
{
  std::vector<double> certainty(lengths.size(), 1.0);
  return {std::move(lengths), std::move(certainty), true};
}

// When lengths are meant, and not an accident: the edges of a sheet agree, and what would be estimated is clearly
// another length.
struct Meant_lengths
{
  // Edges agree when their lengths and those of all that are parallel to them in a hexahedron differ by no more than
  // this factor. Nothing is certain where fewer than the first part of the edges of a sheet do, all from the second on.
  double agreement, few, most;
  // Of the factor between the length and the estimate: nothing is certain up to the first, all from the second on.
  double unclear, clear;
};

// Of a mesh whose interior can be trusted, chosen with a graded layer and with poor outputs of other methods.
inline constexpr Meant_lengths meant_in_valid_mesh{1.25, .6, .8, 1.1, 1.5};
// Of a tangled mesh there must be no doubt.
inline constexpr Meant_lengths meant_in_tangled_mesh{1.1, .8, .9, 1.5, 2.5};

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
  // counts: of the edges, whether their lengths say something; the others have the estimated ones.
  Lengths_along_sheets(const Edge_relations& relations, const std::vector<double>& lengths,
                       const std::vector<char>& counts, const std::vector<double>& estimated,
                       const Meant_lengths& meant)
    : estimated_(estimated)
    , meant_(meant)
  {
    const double tolerance = std::log(meant.agreement);
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

  double certainty(std::size_t e) const
  {
    return part_between(std::abs(factor(e)), std::log(meant_.unclear), std::log(meant_.clear)) *
           part_between(agree_[e], meant_.few, meant_.most);
  }

private:
  // 0 up to low, 1 from high on
  static double part_between(double x, double low, double high)
  {
    return (std::max)(0.0, (std::min)(1.0, (x - low) / (high - low)));
  }

  const std::vector<double>& estimated_;
  const Meant_lengths meant_;
  std::vector<double> logarithms_, agree_; // agree_: the part of the edges
};

// Of a mesh whose interior can be trusted: its own lengths, smoothed along the sheets of hexahedra, and certain where
// they are meant, so that layers keep the heights that they have; where it is only poor it may be regraded. mean:
// length of the boundary edges. O(edge pairs).
inline Target_lengths own_edge_lengths(const Hexahedral_complex& complex, const Edge_relations& relations,
                                       const Positions& points, double mean)
{
  const std::vector<double> estimated = estimate_edge_lengths(complex, relations, points, mean);
  const Lengths_along_sheets own(relations, edge_lengths(complex, points),
                                 std::vector<char>(complex.edges.size(), true), estimated, meant_in_valid_mesh);
  Target_lengths result = guessed_lengths(estimated);
  for (std::size_t e = 0; e < estimated.size(); ++e) {
    result.certainty[e] = own.certainty(e);
    result.lengths[e] *= std::exp(own.factor(e));
  }
  return result;
}

// Of a tangled mesh: the estimate where it says nothing, and its own lengths where it does: those of boundary edges with
// none but sound hexahedra around them are spread along the sheets, so that a fin or a layer that is thin stays so, also
// where it is tangled. Lengths that only interior edges have are no evidence: a layer under the surface that is thin
// throughout is better regraded. O(edge pairs).
inline Target_lengths lengths_along_sound_sheets(const Hexahedral_complex& complex, const Edge_relations& relations,
                                                 const Positions& points, const std::vector<char>& is_sound,
                                                 double mean)
{
  const std::vector<double> present = edge_lengths(complex, points);
  std::vector<char> counts(complex.edges.size());
  for (std::size_t e = 0; e < counts.size(); ++e)
    counts[e] = present[e] > 0 && complex.is_boundary_edge[e];
  for (std::size_t h = 0; h < complex.hexahedra.size(); ++h)
    for (int directed : complex.hexahedron_edges[h])
      if (!is_sound[h])
        counts[directed / 2] = false;
  const std::vector<double> estimated = estimate_edge_lengths(complex, relations, points, mean);
  const Lengths_along_sheets sound(relations, present, counts, estimated, meant_in_tangled_mesh);
  Target_lengths result = guessed_lengths(estimated);
  for (std::size_t e = 0; e < estimated.size(); ++e) {
    result.certainty[e] = sound.certainty(e);
    result.lengths[e] *= std::exp(result.certainty[e] * sound.factor(e));
  }
  return result;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_TARGET_LENGTHS_H
