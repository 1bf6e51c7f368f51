// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What holds surface faces on the reference: the energy of the distances of the
// samples from their targets, and its derivatives.

#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Distances are in units of the local edge length, or of the thickness of the solid where that is less.
// Numbers without another source were chosen together by a coordinate search on organic and CAD models of 2,500 to
// 38,000 hexahedra.
struct Boundary_parameters
{
  // Slope of the energy over the distance d, in a mesh whose mean boundary edge is one fiftieth of the diagonal of the
  // reference. In proportion to the edge: what counts is the deviation of the model, not that of one edge.
  double attachment_weight = 1.18;
  double typical_edge = .02;
  double size_exponent = 1.35;
  // Factor for a reference of its own. The boundary of a mesh, taken for its own reference, is as rough as the mesh.
  double trust = 5;
  // Below this the energy is quadratic, above linear: with the square of d the same average deviation buys less
  // quality.
  double linear_distance = .027;
  // From about this distance on an additional term grows with the sixth power, up to twice the distance; relative to
  // the geometric mean of the edge and its typical length, as the bound has to suit both the element and the model.
  double steep_weight = .25;
  double steep_distance = .175;
  // The same for a given reference, from which no place of the model may be far.
  double steep_weight_of_own = .8;
  double steep_distance_of_own = .146;

  Boundary_sample_parameters samples;
};

// The energy of each sample, for a reference in units of the mean boundary edge. trusted: it is not the boundary of the
// mesh itself.
inline Distance_energy boundary_distance_energy(const Reference_surface& surface, bool trusted,
                                                const Boundary_parameters& parameters)
{
  const double typical = parameters.typical_edge *
                         bounding_box_diagonal(surface); // over the mean boundary edge, which is 1
  const double weight = parameters.attachment_weight / std::pow(typical, parameters.size_exponent) *
                        (trusted ? parameters.trust : 1);
  return {weight, parameters.linear_distance, trusted ? parameters.steep_weight_of_own : parameters.steep_weight,
          (trusted ? parameters.steep_distance_of_own : parameters.steep_distance) * std::sqrt(typical)};
}

class Boundary_energy
{
public:
  // samples must outlive the energy, which is that for their present targets. points: how many the mesh has.
  Boundary_energy(const Boundary_samples& samples, const Distance_energy& distance, std::size_t points)
    : samples_(samples)
    , distance_(distance)
    , ranges_(samples.faces().size(), points, faces_of_range,
              [&](std::size_t f) -> const std::array<int, 4>& { return samples.faces()[f]; })
  {}

  double tightness = 1; // factor of all weights

  // Only the samples of these faces count; all do until that is called.
  void set_active(std::vector<char> faces) { is_active_ = std::move(faces); }

  double value(const Positions& points) const
  {
    return sum_of_ranges(samples_.samples().size(), [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Boundary_sample& s = samples_.samples()[i];
        if (is_active(s.face))
          sum += value_of_sample(s, s.offset(points).squaredNorm());
      }
      return sum;
    });
  }

  double add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    std::vector<double> values(samples_.faces().size(), 0.0); // of the faces
    ranges_.for_ranges([&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (is_active(f))
          values[f] = add_derivatives_of_face(f, points, gradient, matrix);
    });
    return std::accumulate(values.begin(), values.end(), 0.0);
  }

private:
  static constexpr std::size_t faces_of_range = 64;

  bool is_active(std::size_t face) const { return is_active_.empty() || is_active_[face]; }

  // The attachment, and h w (d/D)⁶ for a sample of weight w at the distance d, whose wall stands at D and acts with the
  // part h: whatever the tightness, the tube does not give.
  double value_of_sample(const Boundary_sample& s, double squared_distance) const
  {
    double value = tightness * s.weight * s.emphasis * distance_.value(std::sqrt(squared_distance) / s.scale);
    if (samples_.is_bounded()) {
      const double x = squared_distance / (s.wall * s.wall);
      value += samples_.wall_weight() * s.hold * s.weight * x * x * x;
    }
    return value;
  }

  // Samples share faces, so that the matrix is visited once for all of one face. Returns the value of its samples.
  double add_derivatives_of_face(std::size_t f, const Positions& points, Positions& gradient,
                                 Block_matrix& matrix) const
  {
    const std::array<int, 4>& corners = samples_.faces()[f];
    using Symmetric =
      Eigen::Matrix<double, 6, 1>; // xx, xy, xz, yy, yz, zz: as shares are numbers, all blocks are symmetric
    Symmetric blocks[4][4];
    Vector_3 gradients[4];
    double value = 0;
    for (int i = 0; i < 4; ++i) {
      gradients[i].setZero();
      for (int j = 0; j <= i; ++j)
        blocks[i][j].setZero();
    }
    for (int sample : samples_.of_face(f)) {
      const Boundary_sample& s = samples_.samples()[sample];
      const Vector_3 offset = s.offset(points);
      const double squared_distance = offset.squaredNorm();
      value += value_of_sample(s, squared_distance);
      const double square = s.scale * s.scale, weight = tightness * s.weight * s.emphasis / square;
      const Distance_energy::Derivatives e = distance_.derivatives(std::sqrt(squared_distance) / s.scale);
      double slope = weight * e.slope, growth = weight * e.growth / square;
      if (samples_.is_bounded()) {
        const double D2 = s.wall * s.wall, x = squared_distance / D2,
                     u = 6 * samples_.wall_weight() * s.hold * s.weight * x / D2;
        slope += u * x;
        growth += 4 * u / D2;
      }
      const Vector_3 force = slope * offset, o = growth * offset;
      const Matrix_3& P = s.target.projector;
      Symmetric hessian;
      hessian << slope * P(0, 0) + o[0] * offset[0], slope * P(0, 1) + o[0] * offset[1],
        slope * P(0, 2) + o[0] * offset[2], slope * P(1, 1) + o[1] * offset[1], slope * P(1, 2) + o[1] * offset[2],
        slope * P(2, 2) + o[2] * offset[2];
      double shares[4] = {0, 0, 0, 0};
      for (int k = 0; k < s.count; ++k)
        for (int i = 0; i < 4; ++i)
          shares[i] += corners[i] == s.vertices[k] ? s.shares[k] : 0;
      for (int i = 0; i < 4; ++i) {
        if (shares[i] == 0)
          continue;
        gradients[i] += shares[i] * force;
        for (int j = 0; j <= i; ++j)
          if (shares[j] != 0)
            blocks[i][j] += shares[i] * shares[j] * hessian;
      }
    }
    for (int i = 0; i < 4; ++i) {
      gradient[corners[i]] += gradients[i];
      for (int j = 0; j <= i; ++j) {
        const Symmetric& b = blocks[i][j];
        matrix.add(corners[i], corners[j],
                   (Matrix_3() << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5]).finished());
      }
    }
    return value;
  }

  const Boundary_samples& samples_;
  const Distance_energy distance_;
  const Conflict_free_ranges ranges_; // of the faces
  std::vector<char> is_active_;       // faces; empty: all are
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H
