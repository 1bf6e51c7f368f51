// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H

// How what is to stand exactly on corners, curves and faces comes to its place: as
// far as the hexahedra around it allow, which yield little by little, and what
// they cannot hold is let go, the features before the surface.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_batches.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Arrival_parameters
{
  // The minimum that the hexahedra keep yields by the factor in each iteration in which the number of those that are away
  // does not fall to this part.
  double yielding = .97;
  double progress = .95;
  // When so much of the minimum at the first call is left, features are let go of by what has not come to them; then by
  // what stands in the way of others that are to come to the surface; and the surface by what has not come to it.
  double part_for_features = .2;
  double part_for_way = .1;
  double part_for_surface = .05;
  // In any case when no more than this is left: what is nearly inverted climbs slowly, if at all.
  double least_minimum = .02;
  // What was let go is called again after all others have settled, until all are there, or none could stand at its place,
  // or so many calls were made.
  std::size_t most_calls = 4;
  // What is left to a hexahedron of its own minimum in each iteration: the others have to follow.
  double least_part_of_hexahedron = .85;
  // Edges shorter than this part of their target lengths keep this part of their length in each iteration: scaled
  // Jacobians are blind to them, and the derivatives of the shape are not.
  double least_edge = .05;
  double least_part_of_edge = .97;
  // How often a way is halved.
  int halvings = 6;
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
  {}

  // Whether any were called with call().
  bool have_begun() const { return calls_ > 0; }
  // What the hexahedra keep while there are some on their way; else 0.
  double level() const { return level_; }

  // Calls all, or, once all were, again what was let go and could stand at its place. Whether there is any. minimum: of the
  // mesh.
  bool call(Positions& points, double minimum)
  {
    if (calls_ == parameters_.most_calls)
      return false;
    if (calls_ > 0 && !sliding_.recall_released(points, [&](int v, const Vector_3& place) {
          return hexahedra_below(points, v, place).empty();
        }))
      return false;
    sliding_.call_all();
    level_ = minimum;
    if (calls_++ == 0)
      first_level_ = minimum;
    least_away_ = std::numeric_limits<double>::infinity();
    return true;
  }

  // Before each iteration after a call: whether some are still on their way, once the hexahedra have yielded.
  bool go_on(Positions& points)
  {
    const double away = static_cast<double>(sliding_.vertices_away().size());
    if (away > parameters_.progress * least_away_)
      level_ *= parameters_.yielding;
    least_away_ = (std::min)(least_away_, away);
    if (is_left(parameters_.part_for_features))
      sliding_.release_from_features(points);
    if (is_left(parameters_.part_for_way))
      sliding_.make_way_to_surface(points, [&](int v, const Vector_3& place, const auto& release) {
        for (int h : hexahedra_below(points, v, place))
          for (int u : complex_.hexahedra[h])
            release(u);
      });
    if (is_left(parameters_.part_for_surface))
      sliding_.release_those_away();
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

private:
  // Of a hexahedron, before it is moved.
  struct Before
  {
    int hexahedron;
    bool is_valid;
    std::array<double, 12> lengths;
  };

  static constexpr double rounding = 1e-6; // what is kept is in single precision

  bool is_left(double part) const { return level_ < (std::max)(parameters_.least_minimum, part * first_level_); }

  // Those that would be nearly inverted with a vertex at a place.
  std::vector<int> hexahedra_below(const Positions& points, int v, const Vector_3& place) const
  {
    std::vector<int> result;
    for (int h : complex_.vertex_hexahedra[v]) {
      Hexahedron_coordinates x = hexahedron_coordinates(points, complex_.hexahedra[h]);
      for (int c = 0; c < 8; ++c)
        if (complex_.hexahedra[h][c] == v)
          x[c] = {{place.x(), place.y(), place.z()}};
      if (scaled_jacobian(x) < parameters_.least_minimum)
        result.push_back(h);
    }
    return result;
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
  std::size_t calls_ = 0;
  double level_ = 0, first_level_ = 0, least_away_ = 0; // the last: a number of vertices
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_ARRIVALS_H
