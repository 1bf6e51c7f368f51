// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H

// The vertices of poor hexahedra try places around them, one vertex after the
// other (a pattern search: R. Hooke, T. A. Jeeves, "Direct search" solution of
// numerical and statistical problems, 1961). It takes longer than Newton's method
// and finds what no derivative leads to: on a surface of triangles, a hexahedron
// with two faces in one flat part of it is inverted or flat wherever its vertices
// go in this part, and sound where they stand on edges of the reference.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Sliding.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Jacobian_certificate.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/hexahedron_coordinates.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/scaled_jacobian.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
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
  // What a hexahedron with good corners lacks that is not valid.
  double lack_of_invalid = .01;
  // The worst are raised step by step, and no more when less than this part of a step is gained.
  double step_of_level = .05;
  double part_of_level = .2;
};

class Pattern_search
{
public:
  // lengths: the targets of the edges. All but the numbers must outlive the object.
  Pattern_search(const Hexahedral_complex& complex, const std::vector<double>& lengths, const Sliding& sliding,
                 const Pattern_search_parameters& parameters = Pattern_search_parameters())
    : complex_(complex)
    , lengths_(lengths)
    , sliding_(sliding)
    , parameters_(parameters)
  {
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          if (i != 0 || j != 0 || k != 0)
            directions_.push_back(Vector_3(i, j, k).normalized());
  }

  // Moves the vertices along the way, and then them and those around for what corners lack of the level. If a hexahedron
  // is then worse than it was and worse than `least`, or no longer valid, all of it is undone. Whether it is not.
  bool bring(const std::vector<int>& vertices, const Vector_3& way, double level, double least, Positions& points)
  {
    begin(Order::LARGE_STEPS_FIRST);
    move(vertices, way, points);
    search(level, points);
    return keep(least, points);
  }

  // Moves the vertices of the worst hexahedra until their minimum reaches the limit or does not rise any more. None gets
  // worse than the worst was, and none gets invalid.
  void raise(double limit, Positions& points)
  {
    for (;;) {
      const std::vector<double> scaled_jacobians = scaled_jacobians_at(points);
      const double minimum = *std::min_element(scaled_jacobians.begin(), scaled_jacobians.end());
      const double level = (std::min)(limit, minimum + parameters_.step_of_level);
      if (!(level > minimum))
        return;
      begin(Order::SMALL_STEPS_FIRST);
      for (std::size_t h = 0; h < scaled_jacobians.size(); ++h)
        if (scaled_jacobians[h] < level)
          touch(static_cast<int>(h), points);
      search(level, points);
      if (!keep(minimum, points))
        return;
      const std::vector<double> raised = scaled_jacobians_at(points);
      if (*std::min_element(raised.begin(), raised.end()) < minimum + parameters_.part_of_level * (level - minimum))
        return;
    }
  }

private:
  enum class Order {
    LARGE_STEPS_FIRST, // to get away from where it stands: with small ones first, more are not brought to their places
    SMALL_STEPS_FIRST  // to stay where all else is good: with large ones first, averages fall three times as far
  };

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

  void move(const std::vector<int>& vertices, const Vector_3& step, Positions& points)
  {
    for (int v : vertices)
      for (int h : complex_.vertex_hexahedra[v])
        touch(h, points);
    for (int v : vertices) {
      moved_.emplace(v, points[v]);
      points[v] += step;
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

  // One round after the other, of all vertices of hexahedra that were touched and lack something.
  void search(double level, Positions& points)
  {
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < parameters_.most_rounds; ++round) {
      std::vector<int> vertices;
      double sum = 0;
      for (const auto& [h, before] : before_) {
        const double lacking = lack(h, level, points);
        sum += lacking;
        if (lacking > 0)
          vertices.insert(vertices.end(), complex_.hexahedra[h].begin(), complex_.hexahedra[h].end());
      }
      if (vertices.empty() || sum > (1 - parameters_.gain_of_round) * last)
        return;
      last = sum;
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (int v : vertices)
        place(v, level, points);
    }
  }

  void place(int v, double level, Positions& points)
  {
    const std::vector<int> group = sliding_.movable_with(v);
    if (group.empty())
      return;
    double least = lack_around(group, level, points, std::numeric_limits<double>::infinity());
    if (!(least > 0))
      return;
    const double length = mean_edge_around(v, points);
    const bool is_careful = order_ == Order::SMALL_STEPS_FIRST;
    for (int i = 0; i <= parameters_.halvings; ++i) {
      const double distance = parameters_.largest_step * length /
                              double(1 << (is_careful ? parameters_.halvings - i : i));
      const Vector_3 step = best_step(group, distance, level, points, least);
      if (step == Vector_3::Zero())
        continue;
      move(group, step, points);
      points[v] = sliding_.place_near(v, points[v]);
      if (is_careful)
        return;
    }
  }

  // Of about the distance; zero if none is better. least: of what is lacking, up to now.
  Vector_3 best_step(const std::vector<int>& group, double distance, double level, Positions& points,
                     double& least) const
  {
    const int v = group.front();
    Positions starts;
    for (int u : group)
      starts.push_back(points[u]);
    Vector_3 result = Vector_3::Zero();
    for (const Vector_3& direction : directions_) {
      const Vector_3 step = sliding_.place_near(v, starts.front() + distance * direction) - starts.front();
      for (std::size_t i = 0; i < group.size(); ++i)
        points[group[i]] = starts[i] + step;
      const double most = (1 - parameters_.gain) * least, lacking = lack_around(group, level, points, most);
      if (lacking < most) {
        least = lacking;
        result = step;
      }
    }
    for (std::size_t i = 0; i < group.size(); ++i)
      points[group[i]] = starts[i];
    return result;
  }

  // More than most need not be told apart.
  double lack_around(const std::vector<int>& vertices, double level, const Positions& points, double most) const
  {
    double sum = 0;
    for (int v : vertices)
      for (int h : complex_.vertex_hexahedra[v]) {
        if (!(sum < most))
          return sum;
        sum += lack(h, level, points);
      }
    return sum;
  }

  // The sum of the squares of what corners lack of the level, and edges of their length.
  double lack(int h, double level, const Positions& points) const
  {
    const auto squared = [](double x) { return x * x; };
    const Hexahedron_coordinates x = hexahedron_coordinates(points, complex_.hexahedra[h]);
    double sum = 0;
    bool is_inverted = false;
    for (double s : scaled_jacobians_of_corners(x)) {
      sum += squared((std::max)(0.0, level - s));
      is_inverted = is_inverted || !(s > 0);
    }
    const double least = order_ == Order::SMALL_STEPS_FIRST ? parameters_.least_edge_of_raised : parameters_.least_edge;
    for (int directed : complex_.hexahedron_edges[h])
      sum += squared((std::max)(0.0, 1 - length(directed / 2, points) / (least * lengths_[directed / 2])));
    if (is_inverted || hexahedron_validity(x) != Validity::VALID)
      sum += parameters_.lack_of_invalid * (1 + part_below_zero(x));
    return sum;
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
  const Sliding& sliding_;
  const Pattern_search_parameters parameters_;
  std::vector<Vector_3> directions_;
  Order order_ = Order::LARGE_STEPS_FIRST;
  std::map<int, Before> before_;  // of the hexahedra around what has moved
  std::map<int, Vector_3> moved_; // where those vertices were
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MAXIMIZATION_PATTERN_SEARCH_H
