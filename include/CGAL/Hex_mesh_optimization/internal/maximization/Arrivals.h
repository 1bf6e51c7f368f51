// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How what is to stand exactly on corners, curves and faces comes to its place: as
// far as the hexahedra around it allow, which yield little by little. For what
// has not come then, places are searched for, with all around it; and what they
// cannot hold is let go, the features before the surface.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Pattern_search.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Arrival_parameters
{
  // The minimum that the hexahedra keep yields by the factor in each iteration in which the number of those that are away
  // does not fall to this part.
  double yielding = .97;
  double progress = .95;
  // When so much of the minimum at the first call is left, places are searched for by what has not come: so that no corner
  // around is below the level, or if that is more, below what is to be sought, or else a part of that, and of that, and
  // none below the least (measured on an organic model with all vertices on its surface, from one start that untangles with a
  // least regularization of 3e-5: 3 vertices are not at their places at the end; with .02 as the least, 7).
  double part_for_search = .5;
  double sought = .2;
  double part_of_sought = .4;
  double least_minimum = .002;
  // What was let go is called again after all others have settled, until none comes, or so many calls were made.
  std::size_t most_calls = 4;
  // What is left to a hexahedron of its own minimum in each iteration: the others have to follow.
  double least_part_of_hexahedron = .85;
  // Edges shorter than this part of their target lengths keep this part of their length in each iteration: scaled
  // Jacobians are blind to them, and the derivatives of the shape are not.
  double least_edge = .05;
  double least_part_of_edge = .97;
  // How often a way is halved.
  int halvings = 6;

  // A minimum that is not to be raised at the end.
  double raised = .6;

  Pattern_search_parameters search;
};

class Arrivals
{
public:
  // lengths: the targets of the edges. All but the numbers must outlive the object.
  Arrivals(const Hexahedral_complex& complex, const std::vector<double>& lengths, Sliding& sliding,
           const Arrival_parameters& parameters)
    : complex_(complex)
    , lengths_(lengths)
    , sliding_(sliding)
    , parameters_(parameters)
    , search_(complex, lengths, sliding, parameters.search)
  {}

  // Whether any were called with call().
  bool have_begun() const { return calls_ > 0; }
  // What the hexahedra keep while there are some on their way; else 0.
  double level() const { return level_; }

  // Calls all, or, once all were, again what was let go. Whether there is any: of the latter, any that has come. minimum: of
  // the mesh. is_over: tells when to stop, as searches take their time.
  bool call(Positions& points, double minimum, const std::function<bool()>& is_over)
  {
    if (calls_ == parameters_.most_calls)
      return false;
    level_ = minimum;
    least_away_ = std::numeric_limits<double>::infinity();
    if (calls_++ == 0) {
      first_level_ = minimum;
      sliding_.call_all();
      return true;
    }
    sliding_.recall_released(points);
    return sliding_.are_some_away() && find_places(points, is_over);
  }

  // Before each iteration after a call: whether some are still on their way, once the hexahedra have yielded.
  bool go_on(Positions& points, const std::function<bool()>& is_over)
  {
    const double away = static_cast<double>(sliding_.vertices_away().size());
    if (away > parameters_.progress * least_away_)
      level_ *= parameters_.yielding;
    least_away_ = (std::min)(least_away_, away);
    if (level_ < (std::max)(parameters_.least_minimum, parameters_.part_for_search * first_level_))
      find_places(points, is_over);
    if (sliding_.are_some_away())
      return true;
    level_ = 0;
    return false;
  }

  // Goes the ways of what is called, one vertex after the other, so that one that cannot come keeps no others. kept: what no
  // corner of each hexahedron may drop below; where a level is kept, hexahedra above it give more, but none much at once:
  // the others have to follow. O(vertices that are away).
  void approach(const std::vector<double>& scaled_jacobians, const Batched_values<1>& kept, double part_of_level,
                Positions& points)
  {
    const auto least = [&](int h) {
      const double own = scaled_jacobians[h];
      return level_ > 0
               ? (std::min)(own, (std::max)(part_of_level * level_, parameters_.least_part_of_hexahedron * own))
               : kept.get(h, 0);
    };
    sliding_.approach(points, [&](const std::vector<int>& vertices, const Vector_3& way) {
      std::vector<Before> around;
      for (int v : vertices)
        for (int h : complex_.vertex_hexahedra[v])
          around.push_back(before(points, h));
      const Vector_3 start = points[vertices.front()];
      double share = 1, gone = 0;
      for (int i = 0; i <= parameters_.halvings; ++i, share /= 2) {
        move(vertices, (share - gone) * way, points);
        gone = share;
        if (std::none_of(around.begin(), around.end(),
                         [&](const Before& b) { return is_ruined(points, b, least(b.hexahedron)); }))
          return i == 0;
      }
      move(vertices, start - points[vertices.front()], points);
      return false;
    });
  }

  // Raises the worst of what stands exactly: it climbs over the edges of faces, where Newton's method stops.
  void raise(Positions& points) { search_.raise(parameters_.raised, points); }

private:
  // Of a hexahedron, before it is moved.
  struct Before
  {
    int hexahedron;
    bool is_valid;
    std::array<double, 12> lengths;
  };

  static constexpr double rounding = 1e-6; // what is kept is in single precision

  // For all that have not come: on their features, or else on the surface; the others are let go. Whether any has come.
  bool find_places(Positions& points, const std::function<bool()>& is_over)
  {
    bool any = false;
    const auto search = [&] {
      sliding_.approach(points, [&](const std::vector<int>& vertices, const Vector_3& way) {
        bool has_come = false;
        for (double level = (std::max)(level_, parameters_.sought);
             !has_come && level > parameters_.least_minimum && !is_over(); level *= parameters_.part_of_sought)
          has_come = search_.bring(vertices, way, level, parameters_.least_minimum, points);
        any = any || has_come;
        return has_come;
      });
    };
    search();
    sliding_.release_from_features(points);
    search();
    sliding_.release_those_away();
    return any;
  }

  static void move(const std::vector<int>& vertices, const Vector_3& step, Positions& points)
  {
    for (int v : vertices)
      points[v] += step;
  }

  double length(const Positions& points, int edge) const
  {
    return (points[complex_.edges[edge][1]] - points[complex_.edges[edge][0]]).norm();
  }

  bool is_valid(const Positions& points, int h) const
  {
    return hexahedron_validity(hexahedron_coordinates(points, complex_.hexahedra[h])) == Validity::VALID;
  }

  Before before(const Positions& points, int h) const
  {
    Before result{h, level_ > 0 && is_valid(points, h), {}};
    for (int k = 0; k < 12; ++k)
      result.lengths[k] = length(points, complex_.hexahedron_edges[h][k] / 2);
    return result;
  }

  bool is_ruined(const Positions& points, const Before& b, double least) const
  {
    const int h = b.hexahedron;
    if (scaled_jacobian(hexahedron_coordinates(points, complex_.hexahedra[h])) < least - rounding)
      return true;
    if (!(level_ > 0))
      return false;
    if (b.is_valid && !is_valid(points, h)) // its corners may all be good
      return true;
    for (int k = 0; k < 12; ++k) {
      const int e = complex_.hexahedron_edges[h][k] / 2;
      if (length(points, e) <
          (std::min)(parameters_.least_edge * lengths_[e], parameters_.least_part_of_edge * b.lengths[k]))
        return true;
    }
    return false;
  }

  const Hexahedral_complex& complex_;
  const std::vector<double>& lengths_;
  Sliding& sliding_;
  const Arrival_parameters parameters_;
  Pattern_search<Sliding> search_;
  std::size_t calls_ = 0;
  double level_ = 0, first_level_ = 0, least_away_ = 0; // the last: a number of vertices
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H
