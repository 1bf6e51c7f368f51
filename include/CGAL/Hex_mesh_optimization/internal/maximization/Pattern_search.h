// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The vertices of poor hexahedra try places around them, one vertex after the
// other, or where that helps no more, the two ends of an edge together (a pattern
// search: R. Hooke, T. A. Jeeves, "Direct search" solution of numerical and
// statistical problems, 1961, along directions that are others in each round, as
// in C. Audet, J. E. Dennis Jr., Mesh adaptive direct search algorithms for
// constrained optimization, 2006). It takes longer than Newton's method and finds
// what no derivative leads to: on a surface of triangles, a hexahedron with two
// faces in one flat part of it is inverted or flat wherever its vertices go in
// this part, and sound where they stand on edges of the reference.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Pattern_search_parameters
{
  // The distances tried are halved from the largest one so often, in mean lengths of the edges around a vertex.
  double largest_step = .5;
  int halvings = 5;
  // Less than this part of what is lacking is no gain, for a vertex, and for a round of all vertices.
  double gain = .001;
  double gain_of_round = .01;
  int most_rounds = 40;
  // Edges lack what they are shorter than these parts of their target lengths, while vertices are brought to a place,
  // and while the worst are raised: scaled Jacobians are blind to them (measured on a CAD part: .1 in the latter raises
  // the 99th percentile of edge ratios from 14 to 32).
  double least_edge = .1;
  double least_edge_of_raised = .3;
  // What a hexahedron lacks that is not valid, whatever its corners, and what more if all coefficients of its Jacobian
  // determinant are negative. Searches on a coarse model ended with good corners and nothing to lead back to validity
  // where the latter was .01; with 1 they are no better.
  double lack_of_invalid = .01;
  double lack_of_negative = .1;
  // What corners lack of 1 counts so much besides, where a vertex moves: those above the level are not spent for nothing
  // (measured on a CAD part: bound to .02 % of its diagonal, the average is .8856 with .001 instead of .8853, at minima of
  // .214 and .215; bound to .1 %, nothing is raised with .01).
  double weight_of_average = 0;
  // The worst are raised step by step, and no more when less than this part of a step is gained.
  double step_of_level = .05;
  double part_of_level = .2;
  // While they are below this minimum, with large steps too where small ones do not help. What is better would pay for it
  // with all around (measured on a block: a minimum of .50 instead of .46, edge ratios of 19 instead of 6).
  double raised_by_large_steps = .2;
  // Where more than this part and this number of hexahedra are below a level, they are left in peace: to raise all of those
  // costs the average and takes as long as all before (measured on voxels of a ball, all of them on it, a fifth of them
  // poor: .042 and .60 instead of .010 and .62, in 275 s instead of 149 s).
  double most_raised_part = .04;
  std::size_t most_raised = 100;
};

// Places is a class with
//   std::vector<int> movable_with(int v) const,
//     the vertices that move where v goes, v the first of them; none if it stays, or goes with another,
//   Departure departure(int v, const Vector_3& from) const,
//     what is to be known of the place that v goes from,
//   Vector_3 reached(int v, const Departure& departure, const Vector_3& to) const,
//     where v comes to if it is to go from there to another place, and
//   bool allows(const std::vector<int>& vertices, const Positions& points) const,
//     whether these vertices, of all points, may stand where they are.
template <class Places>
class Pattern_search
{
public:
  // lengths: the targets of the edges. All but the numbers must outlive the object.
  Pattern_search(const Hexahedral_complex& complex, const std::vector<double>& lengths, const Places& places,
                 const Pattern_search_parameters& parameters = Pattern_search_parameters())
    : complex_(complex)
    , lengths_(lengths)
    , places_(places)
    , parameters_(parameters)
  {}

  // Moves the vertices along the way, and then them and those around for what corners lack of the level. If a hexahedron
  // is then worse than it was and worse than `least`, or no longer valid, all of it is undone. Whether it is not.
  bool bring(const std::vector<int>& vertices, const Vector_3& way, double level, double least, Positions& points)
  {
    begin(Order::LARGE_STEPS_FIRST);
    remember(vertices, points);
    for (int v : vertices)
      points[v] += way;
    search(level, points);
    return keep(least, points);
  }

  // Moves the vertices of the worst hexahedra until their minimum reaches the limit or does not rise any more. None gets
  // worse than the worst was, and none gets invalid.
  void raise(double limit, Positions& points)
  {
    Order order = Order::SMALL_STEPS_FIRST;
    std::vector<double> scaled_jacobians = scaled_jacobians_at(points);
    for (;;) {
      const double minimum = *std::min_element(scaled_jacobians.begin(), scaled_jacobians.end());
      const double level = (std::min)(limit, minimum + parameters_.step_of_level);
      if (!(level > minimum))
        return;
      begin(order);
      for (std::size_t h = 0; h < scaled_jacobians.size(); ++h)
        if (scaled_jacobians[h] < level)
          touch(static_cast<int>(h), points);
      if (before_.size() > parameters_.most_raised &&
          double(before_.size()) > parameters_.most_raised_part * double(scaled_jacobians.size()))
        return;
      search(level, points);
      if (keep(minimum, points))
        scaled_jacobians = scaled_jacobians_at(points);
      const bool has_risen = *std::min_element(scaled_jacobians.begin(), scaled_jacobians.end()) >=
                             minimum + parameters_.part_of_level * (level - minimum);
      if (!has_risen && (order == Order::LARGE_STEPS_FIRST || minimum > parameters_.raised_by_large_steps))
        return;
      order = has_risen ? Order::SMALL_STEPS_FIRST : Order::LARGE_STEPS_FIRST;
    }
  }

private:
  enum class Order {
    LARGE_STEPS_FIRST, // to get away from where it stands: with small ones first, more are not brought to their places
    SMALL_STEPS_FIRST  // to stay where all else is good: with large ones first, averages fall three times as far
  };

  // Those that are tied go together.
  using Groups = std::vector<std::vector<int>>;
  using Departures = std::vector<typename Places::Departure>; // of the first vertices of groups

  struct Before
  {
    double minimum;
    bool is_valid;
  };

  static constexpr double rounding = 1e-6;

  void begin(Order order)
  {
    order_ = order;
    before_.clear();
    moved_.clear();
  }

  std::vector<double> scaled_jacobians_at(const Positions& points) const
  {
    std::vector<double> result;
    for (const Hexahedron& h : complex_.hexahedra)
      result.push_back(scaled_jacobian(hexahedron_coordinates(points, h)));
    return result;
  }

  void touch(int h, const Positions& points)
  {
    if (before_.count(h) > 0)
      return;
    const Hexahedron_coordinates x = hexahedron_coordinates(points, complex_.hexahedra[h]);
    before_[h] = {scaled_jacobian(x), hexahedron_validity(x) == Validity::VALID};
  }

  // Of what is going to move.
  void remember(const std::vector<int>& vertices, const Positions& points)
  {
    for (int v : vertices) {
      for (int h : complex_.vertex_hexahedra[v])
        touch(h, points);
      moved_.emplace(v, points[v]);
    }
  }

  bool keep(double least, Positions& points) const
  {
    const bool is_good = std::all_of(before_.begin(), before_.end(), [&](const auto& b) {
      const Hexahedron_coordinates x = hexahedron_coordinates(points, complex_.hexahedra[b.first]);
      return scaled_jacobian(x) >= (std::min)(least, b.second.minimum) - rounding &&
             (!b.second.is_valid || hexahedron_validity(x) == Validity::VALID);
    });
    for (auto m = moved_.begin(); !is_good && m != moved_.end(); ++m)
      points[m->first] = m->second;
    return is_good;
  }

  // One round after the other, of all vertices of hexahedra that were touched and lack something, or where that has helped no
  // more, of the ends of their edges.
  void search(double level, Positions& points)
  {
    double last = std::numeric_limits<double>::infinity();
    bool by_edges = false;
    for (int round = 0; round < parameters_.most_rounds; ++round) {
      std::vector<int> vertices, edges;
      double sum = 0;
      for (const auto& [h, before] : before_) {
        const double lacking = lack_of_shape(h, level, 0, points) + lack_of_validity(h, points);
        sum += lacking;
        if (lacking > 0) {
          vertices.insert(vertices.end(), complex_.hexahedra[h].begin(), complex_.hexahedra[h].end());
          for (int directed : complex_.hexahedron_edges[h])
            edges.push_back(directed / 2);
        }
      }
      const bool has_gained = sum <= (1 - parameters_.gain_of_round) * last;
      if (vertices.empty() || (by_edges && !has_gained))
        return;
      by_edges = !has_gained;
      last = sum;
      const std::vector<Vector_3> directions = directions_of_round(round);
      if (by_edges)
        for (int e : sorted_once(std::move(edges)))
          place({places_.movable_with(complex_.edges[e][0]), places_.movable_with(complex_.edges[e][1])}, directions,
                level, points);
      else
        for (int v : sorted_once(std::move(vertices)))
          place({places_.movable_with(v)}, directions, level, points);
    }
  }

  static std::vector<int> sorted_once(std::vector<int>&& indices)
  {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return std::move(indices);
  }

  // To the neighbors of a cell in a grid that is turned in each round. The angles are arbitrary: any that do not come back
  // within the rounds would do.
  static std::vector<Vector_3> directions_of_round(int round)
  {
    const double about_z = 2.4 * round, about_x = 1.1 * round;
    const Matrix_3 turn = (Eigen::AngleAxisd(about_x, Vector_3::UnitX()) *
                           Eigen::AngleAxisd(about_z, Vector_3::UnitZ()))
                            .toRotationMatrix();
    std::vector<Vector_3> result;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          if (i != 0 || j != 0 || k != 0)
            result.push_back(turn * Vector_3(i, j, k).normalized());
    return result;
  }

  // All groups by the same way, if each of them can move.
  void place(const Groups& groups, const std::vector<Vector_3>& directions, double level, Positions& points)
  {
    if (std::any_of(groups.begin(), groups.end(), [](const std::vector<int>& group) { return group.empty(); }))
      return;
    using Limits = std::numeric_limits<double>;
    if (!(lack_around(groups, level, 0, points, (Limits::min)()) > 0))
      return;
    double least = lack_around(groups, level, parameters_.weight_of_average, points, Limits::infinity());
    const double length = mean_edge_around(groups.front().front(), points);
    const bool is_careful = order_ == Order::SMALL_STEPS_FIRST;
    Departures departures = departures_of(groups, points);
    for (int i = 0; i <= parameters_.halvings; ++i) {
      const double distance = parameters_.largest_step * length /
                              double(1 << (is_careful ? parameters_.halvings - i : i));
      const Vector_3 way = best_way(groups, departures, directions, distance, level, points, least);
      if (way == Vector_3::Zero())
        continue;
      for (const std::vector<int>& group : groups)
        remember(group, points);
      go(groups, departures, way, points);
      if (is_careful)
        return;
      departures = departures_of(groups, points);
    }
  }

  Departures departures_of(const Groups& groups, const Positions& points) const
  {
    Departures result;
    for (const std::vector<int>& group : groups)
      result.push_back(places_.departure(group.front(), points[group.front()]));
    return result;
  }

  // Of the distance; zero if none is better. least: of what is lacking, up to now.
  Vector_3 best_way(const Groups& groups, const Departures& departures, const std::vector<Vector_3>& directions,
                    double distance, double level, Positions& points, double& least) const
  {
    std::vector<std::pair<int, Vector_3>> starts;
    std::vector<int> vertices;
    for (const std::vector<int>& group : groups)
      for (int v : group) {
        starts.emplace_back(v, points[v]);
        vertices.push_back(v);
      }
    Vector_3 result = Vector_3::Zero();
    for (const Vector_3& direction : directions) {
      const Vector_3 way = distance * direction;
      go(groups, departures, way, points);
      const double most = (1 - parameters_.gain) * least,
                   lacking = lack_around(groups, level, parameters_.weight_of_average, points, most);
      if (lacking < most && places_.allows(vertices, points)) {
        least = lacking;
        result = way;
      }
      for (const auto& [v, start] : starts)
        points[v] = start;
    }
    return result;
  }

  // Along the way, each group as its first vertex may.
  void go(const Groups& groups, const Departures& departures, const Vector_3& way, Positions& points) const
  {
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const int first = groups[g].front();
      const Vector_3 start = points[first], place = places_.reached(first, departures[g], start + way);
      for (int v : groups[g])
        points[v] += place - start;
      points[first] = place;
    }
  }

  // What more than most is, need not be told apart: whether hexahedra are valid takes the longest to tell.
  double lack_around(const Groups& groups, double level, double weight_of_average, const Positions& points,
                     double most) const
  {
    double sum = 0;
    const auto add_around = [&](const auto& lack) {
      for (const std::vector<int>& group : groups)
        for (int v : group)
          for (int h : complex_.vertex_hexahedra[v])
            if (sum < most)
              sum += lack(h);
    };
    add_around([&](int h) { return lack_of_shape(h, level, weight_of_average, points); });
    add_around([&](int h) { return lack_of_validity(h, points); });
    return sum;
  }

  // The sum of the squares of what corners lack of the level, and edges of their length, and what corners lack of 1, times
  // the weight.
  double lack_of_shape(int h, double level, double weight_of_average, const Positions& points) const
  {
    const auto squared = [](double x) { return x * x; };
    double sum = 0;
    for (double s : scaled_jacobians_of_corners(hexahedron_coordinates(points, complex_.hexahedra[h])))
      sum += squared((std::max)(0.0, level - s)) + weight_of_average * (1 - s);
    const double least = order_ == Order::SMALL_STEPS_FIRST ? parameters_.least_edge_of_raised : parameters_.least_edge;
    for (int directed : complex_.hexahedron_edges[h])
      sum += squared((std::max)(0.0, 1 - length(directed / 2, points) / (least * lengths_[directed / 2])));
    return sum;
  }

  double lack_of_validity(int h, const Positions& points) const
  {
    const Hexahedron_coordinates x = hexahedron_coordinates(points, complex_.hexahedra[h]);
    return hexahedron_validity(x) == Validity::VALID
             ? 0
             : parameters_.lack_of_invalid + parameters_.lack_of_negative * part_below_zero(x);
  }

  // Of the Jacobian determinant, as its coefficients have it, from 0 to 1: what leads back to where it is positive.
  static double part_below_zero(const Hexahedron_coordinates& x)
  {
    const auto coefficients = jacobian_coefficients(Edge_vectors<double>(x));
    const auto [least, largest] = std::minmax_element(coefficients.begin(), coefficients.end());
    const double below = (std::max)(0.0, -*least), above = (std::max)(0.0, *largest);
    return below > 0 ? below / (below + above) : 0;
  }

  double length(int edge, const Positions& points) const
  {
    return (points[complex_.edges[edge][1]] - points[complex_.edges[edge][0]]).norm();
  }

  // Of the edges in the hexahedra around; those in several count several times.
  double mean_edge_around(int v, const Positions& points) const
  {
    double sum = 0;
    std::size_t count = 0;
    for (int h : complex_.vertex_hexahedra[v])
      for (int directed : complex_.hexahedron_edges[h])
        if (complex_.edges[directed / 2][0] == v || complex_.edges[directed / 2][1] == v) {
          sum += length(directed / 2, points);
          ++count;
        }
    return count > 0 ? sum / double(count) : 0;
  }

  const Hexahedral_complex& complex_;
  const std::vector<double>& lengths_;
  const Places& places_;
  const Pattern_search_parameters parameters_;
  Order order_ = Order::LARGE_STEPS_FIRST;
  std::map<int, Before> before_;  // of the hexahedra around what has moved
  std::map<int, Vector_3> moved_; // where those vertices were
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H
