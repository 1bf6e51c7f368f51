// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_BATCHES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_BATCHES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The hexahedra of a mesh, a lane each: what formulas over Lanes take.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_assembly.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Hexahedron_derivatives.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Lanes.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// A number of values for each hexahedron.
template <int number_of_values>
class Batched_values
{
public:
  explicit Batched_values(std::size_t number_of_hexahedra)
    : values_((number_of_hexahedra + number_of_lanes - 1) / number_of_lanes)
  {}

  void set(std::size_t hexahedron, int k, double value)
  {
    set_lane(values_[hexahedron / number_of_lanes].value[k], static_cast<int>(hexahedron % number_of_lanes),
             static_cast<float>(value));
  }

  double get(std::size_t hexahedron, int k) const
  {
    return lane(values_[hexahedron / number_of_lanes].value[k], static_cast<int>(hexahedron % number_of_lanes));
  }

  const Lanes* batch(std::size_t i) const { return values_[i].value; }
  Lanes* batch(std::size_t i) { return values_[i].value; }

private:
  struct Values
  {
    Lanes value[number_of_values] = {};
  };

  std::vector<Values> values_;
};

// The edge vectors of one hexahedron. Differences are taken in double: what is lost to single precision is relative to
// the edge, not to the mesh.
template <class Number>
void edge_vectors(const Positions& points, const Hexahedron& h, Number (&vectors)[12][3])
{
  for (int k = 0; k < 12; ++k) {
    const Vector_3 e = points[h[hexahedron_edges[k][1]]] - points[h[hexahedron_edges[k][0]]];
    for (int a = 0; a < 3; ++a)
      vectors[k][a] = static_cast<Number>(e[a]);
  }
}

class Hexahedron_batches
{
public:
  explicit Hexahedron_batches(const Hexahedral_complex& complex)
    : hexahedra_(complex.hexahedra)
    , ranges_(size(), complex.number_of_vertices(), batches_of_range, [this](std::size_t i) { return vertices(i); })
  {}

  std::size_t number_of_hexahedra() const { return hexahedra_.size(); }

  // The number of batches.
  std::size_t size() const { return (hexahedra_.size() + number_of_lanes - 1) / number_of_lanes; }

  std::size_t first_hexahedron(std::size_t batch) const { return batch * number_of_lanes; }
  int number_of_hexahedra(std::size_t batch) const
  {
    return static_cast<int>((std::min)(hexahedra_.size() - first_hexahedron(batch), std::size_t(number_of_lanes)));
  }

  // Lanes beyond the last hexahedron repeat it.
  Hexahedron_frame<Lanes> frame(std::size_t batch, const Positions& points) const
  {
    Lanes vectors[12][3];
    for (int l = 0; l < number_of_lanes; ++l) {
      float one[12][3];
      edge_vectors(points, hexahedra_[(std::min)(first_hexahedron(batch) + l, hexahedra_.size() - 1)], one);
      for (int k = 0; k < 12; ++k)
        for (int a = 0; a < 3; ++a)
          set_lane(vectors[k][a], l, one[k][a]);
    }
    return Hexahedron_frame<Lanes>(vectors);
  }

  // Calls work(batch) for all.
  template <class Work>
  void for_each(const Work& work) const
  {
    internal::for_each(size(), work, batches_of_range);
  }

  // Calls work(batch) for all, never at once for two with a common vertex.
  template <class Work>
  void for_each_without_conflict(const Work& work) const
  {
    ranges_.for_ranges([&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        work(i);
    });
  }

  // The sum of work(batch) over all.
  template <class Work>
  double sum(const Work& work) const
  {
    return sum_of_ranges(
      size(),
      [&](std::size_t begin, std::size_t end) {
        double result = 0;
        for (std::size_t i = begin; i < end; ++i)
          result += work(i);
        return result;
      },
      batches_of_range);
  }

  // Adds the derivatives of a batch.
  void add(std::size_t batch, const Hexahedron_derivatives<Lanes>& derivatives, const Hexahedron_assembly& assembly,
           Positions& gradient, Block_matrix& matrix) const
  {
    for (int l = 0; l < number_of_hexahedra(batch); ++l)
      assembly.add(first_hexahedron(batch) + l, derivatives, l, gradient, matrix);
  }

private:
  static constexpr std::size_t batches_of_range = 256 / number_of_lanes;

  std::vector<int> vertices(std::size_t batch) const
  {
    std::vector<int> result;
    for (int l = 0; l < number_of_hexahedra(batch); ++l)
      result.insert(result.end(), hexahedra_[first_hexahedron(batch) + l].begin(),
                    hexahedra_[first_hexahedron(batch) + l].end());
    return result;
  }

  const std::vector<Hexahedron>& hexahedra_;
  const Conflict_free_ranges ranges_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_HEXAHEDRON_BATCHES_H
