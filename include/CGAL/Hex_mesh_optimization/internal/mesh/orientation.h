// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_ORIENTATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_ORIENTATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Which hexahedra are numbered inside out.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// The same hexahedron the other way out: bottom and top are exchanged.
inline Hexahedron turned(Hexahedron h)
{
  std::swap_ranges(h.begin(), h.begin() + 4, h.begin() + 4);
  return h;
}

// The hexahedra of a component that is connected through faces agree with each other; then the volume that its
// boundary encloses is positive: a tangled interior, however far out, does not matter.
class Orientation
{
public:
  // Below this part of what its faces contribute, the sign of an enclosed volume is one of rounding.
  static constexpr double certain_volume = 1e-12;

  // Throws Input_error, naming two hexahedra, where going around through faces leads back inside out.
  Orientation(const Positions& points, const std::vector<Hexahedron>& hexahedra, const Face_neighbors& neighbors)
    : points_(points)
    , hexahedra_(hexahedra)
    , neighbors_(neighbors)
    , is_turned_(hexahedra.size(), false)
  {
    std::vector<char> is_seen(hexahedra.size(), false);
    for (std::size_t seed = 0; seed < hexahedra.size(); ++seed)
      if (!is_seen[seed])
        orient(component(static_cast<int>(seed), is_seen));
  }

  const std::vector<char>& is_turned() const { return is_turned_; }

private:
  // All that the seed reaches, each turned so that it agrees with the seed; in increasing order.
  std::vector<int> component(int seed, std::vector<char>& is_seen)
  {
    std::vector<int> reached(1, seed);
    is_seen[seed] = true;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (int f = 0; f < 6; ++f) {
        const int side = 6 * reached[i] + f, opposite = neighbors_.opposite(side);
        if (opposite < 0)
          continue;
        const int other = opposite / 6;
        const char must_turn = neighbors_.is_agreed(side) == (is_turned_[reached[i]] != 0);
        if (!is_seen[other]) {
          is_seen[other] = true;
          is_turned_[other] = must_turn;
          reached.push_back(other);
        }
        else if (is_turned_[other] != must_turn)
          refuse(reached[i], other);
      }
    std::sort(reached.begin(), reached.end());
    return reached;
  }

  [[noreturn]] static void refuse(int a, int b)
  {
    const int first = (std::min)(a, b), second = (std::max)(a, b);
    throw Input_error(Input_error::Element::HEXAHEDRON, second,
                      "the mesh has no orientation: hexahedra " + std::to_string(first) + " and " +
                        std::to_string(second) +
                        " share a face, but the way from one to the other through other faces turns inside out");
  }

  void orient(const std::vector<int>& component)
  {
    if (is_inside_out(component))
      for (int h : component)
        is_turned_[h] = !is_turned_[h];
  }

  bool is_inside_out(const std::vector<int>& component) const
  {
    std::vector<int> boundary; // its sides
    for (int h : component)
      for (int f = 0; f < 6; ++f)
        if (neighbors_.opposite(6 * h + f) == Face_neighbors::ALONE)
          boundary.push_back(6 * h + f);
    double volume = 0, of_all = 0; // up to the same factor
    if (!boundary.empty()) {
      const Vector_3 origin = points_[neighbors_.vertices(boundary[0])[0]];
      double extent = 0;
      for (int side : boundary)
        for (int v : neighbors_.vertices(side))
          extent = (std::max)(extent, (points_[v] - origin).cwiseAbs().maxCoeff());
      for (int side : boundary) {
        const std::array<int, 4> vertices = neighbors_.vertices(side);
        Vector_3 p[4];
        for (int i = 0; i < 4; ++i)
          p[i] = (points_[vertices[i]] - origin) / extent;
        const double part = p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3])) + p[1].dot(p[2].cross(p[3])) +
                            p[0].dot(p[1].cross(p[3]));
        volume += is_turned_[side / 6] ? -part : part;
        of_all += std::abs(part);
      }
    }
    return std::abs(volume) > certain_volume * of_all ? volume < 0 : number_of_upright_corners(component) < 0;
  }

  // Less those that are inside out.
  long long number_of_upright_corners(const std::vector<int>& component) const
  {
    long long sum = 0;
    for (int h : component)
      for (int c = 0; c < 8; ++c) {
        const Hexahedron& hexahedron = hexahedra_[h];
        const auto edge = [&](int k) -> Vector_3 {
          return points_[hexahedron[corner_neighbors[c][k]]] - points_[hexahedron[c]];
        };
        const double determinant = edge(0).dot(edge(1).cross(edge(2)));
        const int sign = (determinant > 0) - (determinant < 0);
        sum += is_turned_[h] ? -sign : sign;
      }
    return sum;
  }

  const Positions& points_;
  const std::vector<Hexahedron>& hexahedra_;
  const Face_neighbors& neighbors_;
  std::vector<char> is_turned_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESH_ORIENTATION_H
