// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACED_POINTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACED_POINTS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The points of a file after corners of hexahedra have moved: as the numbers in the file can have them, and with the nodes
// that are no corners brought along.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/Coordinate_places.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal::IO {

class Placed_points
{
public:
  using Triple = std::array<double, 3>;

  // `moved`: all points, of which only those of corners of hexahedra matter.
  Placed_points(const CGAL::IO::Hex_mesh_file& file, const std::vector<Triple>& moved)
    : file_(file)
    , wanted_(moved)
    , points_(moved)
  {
    bool is_exact = true;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      points_[v] = file.places->rounded(v, file.points[v], moved[v]);
      is_exact = is_exact && points_[v] == moved[v];
    }
    if (!is_exact)
      mend();
    bring_followers();
  }

  const std::vector<Triple>& points() const { return points_; }

  // That are valid where they were to be, and are not where they can be.
  const std::vector<std::size_t>& hexahedra_lost() const { return lost_; }

private:
  bool is_valid(std::size_t h, const std::vector<Triple>& points) const
  {
    using Point = CGAL::Simple_cartesian<double>::Point_3;
    std::array<Point, 8> p;
    for (int turn : {0, 4}) { // it may be numbered inside out
      for (std::size_t i = 0; i < 8; ++i) {
        const Triple& at = points[file_.hexahedra[h][(i + static_cast<std::size_t>(turn)) % 8]];
        p[i] = Point(at[0], at[1], at[2]);
      }
      if (is_valid_hexahedron(p))
        return true;
    }
    return false;
  }

  void find_lost()
  {
    lost_.clear();
    for (std::size_t h = 0; h < file_.hexahedra.size(); ++h)
      if (!is_valid(h, points_) && is_valid(h, wanted_))
        lost_.push_back(h);
  }

  std::size_t number_of_invalid(const std::vector<std::size_t>& hexahedra) const
  {
    return static_cast<std::size_t>(
      std::count_if(hexahedra.begin(), hexahedra.end(), [this](std::size_t h) { return !is_valid(h, points_); }));
  }

  // Other numbers that the fields can hold, near by.
  void mend()
  {
    constexpr int most_rounds = 10;
    find_lost();
    for (int round = 0; round < most_rounds && !lost_.empty(); ++round) {
      std::map<std::size_t, std::vector<std::size_t>> around;
      for (std::size_t h : lost_)
        for (std::size_t v : file_.hexahedra[h])
          if (wanted_[v] != file_.points[v])
            around[v];
      for (std::size_t h = 0; h < file_.hexahedra.size(); ++h)
        for (std::size_t v : file_.hexahedra[h]) {
          const auto found = around.find(v);
          if (found != around.end())
            found->second.push_back(h);
        }
      bool has_improved = false;
      for (const auto& [v, hexahedra] : around)
        has_improved = improve(v, hexahedra, round + 1) || has_improved;
      find_lost();
      if (!has_improved)
        return;
    }
  }

  bool improve(std::size_t v, const std::vector<std::size_t>& hexahedra, int reach)
  {
    std::size_t least = number_of_invalid(hexahedra);
    if (least == 0)
      return false;
    const Triple start = points_[v];
    Triple best = start;
    const double step = reach * file_.places->resolution(v, start);
    for (int c = 0; c < 28; ++c) {
      Triple trial = start;
      for (int i = 0, code = c; i < 3; ++i, code /= 3)
        trial[i] += (code % 3 - 1) * step;
      if (c == 27)
        trial = file_.points[v];
      points_[v] = file_.places->rounded(v, file_.points[v], trial);
      const std::size_t number = number_of_invalid(hexahedra);
      if (number < least) {
        least = number;
        best = points_[v];
      }
    }
    points_[v] = best;
    return best != start;
  }

  void bring_followers()
  {
    for (const CGAL::IO::Hex_mesh_file::Follower& f : file_.followers) {
      Triple at = file_.points[f.point];
      bool has_moved = false;
      for (std::size_t c = 0; c < 8; ++c)
        for (int i = 0; i < 3; ++i) {
          const double d = f.weights[c] * (points_[f.corners[c]][i] - file_.points[f.corners[c]][i]);
          has_moved = has_moved || d != 0;
          at[i] += d;
        }
      points_[f.point] = has_moved ? file_.places->rounded(f.point, file_.points[f.point], at) : file_.points[f.point];
    }
  }

  const CGAL::IO::Hex_mesh_file& file_;
  const std::vector<Triple>& wanted_;
  std::vector<Triple> points_;
  std::vector<std::size_t> lost_;
};

} // namespace CGAL::Hex_mesh_optimization::internal::IO

#endif // CGAL_HEX_MESH_OPTIMIZATION_IO_INTERNAL_PLACED_POINTS_H
