// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The cone of every directed edge and the local step: target directions that no
// base triangle of the cone sees from behind (Section 3.1.2 of the paper).

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/cone_direction.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <algorithm>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Edge_cones
{
public:
  // A base triangle lies at corner `corner` of a hexahedron, opposite the edge
  // to neighbor `axis`; item 24 h + 3 corner + axis.
  explicit Edge_cones(const Hexahedral_complex& complex)
    : complex_(complex)
    , triangles_(
        2 * complex.edges.size(), 24 * complex.hexahedra.size(), [this](std::size_t item) { return axis_of(item); },
        [](std::size_t item) { return static_cast<int>(item); })
    , normals_(24 * complex.hexahedra.size())
    , sums_(triangles_.size())
  {}

  std::size_t size() const { return triangles_.size(); }

  // The base triangles of the cone around a directed edge.
  Grouped_array::Group triangles(int directed) const { return triangles_[directed]; }

  // The unit normal of a base triangle; zero when the triangle is degenerate.
  const Vector_3& normal(int triangle) const { return normals_[triangle]; }

  // The sum of the unit base normals of a cone.
  const Vector_3& normal_sum(int directed) const { return sums_[directed]; }

  // cos of the largest angle between a direction and the base normals.
  double worst_cosine(int directed, const Vector_3& direction) const
  {
    double worst = 1;
    for (int t : triangles_[directed])
      worst = (std::min)(worst, direction.dot(normals_[t]));
    return worst;
  }

  void update_normals(const Positions& points)
  {
    for_each(complex_.hexahedra.size(), [&](std::size_t h) {
      const Hexahedron& hex = complex_.hexahedra[h];
      for (int c = 0; c < 8; ++c) {
        Vector_3 edge[3];
        for (int k = 0; k < 3; ++k)
          edge[k] = points[hex[corner_neighbors[c][k]]] - points[hex[c]];
        for (int k = 0; k < 3; ++k) {
          Vector_3& n = normals_[24 * h + 3 * c + k];
          n = edge[(k + 1) % 3].cross(edge[(k + 2) % 3]);
          const double length = n.norm();
          n = length > 0 ? Vector_3(n / length) : Vector_3(Vector_3::Zero());
        }
      }
    });
    for_each(sums_.size(), [&](std::size_t directed) {
      sums_[directed].setZero();
      for (int t : triangles_[directed])
        sums_[directed] += normals_[t];
    });
  }

private:
  int axis_of(std::size_t item) const
  {
    const int local = corner_edges[item % 24 / 3][item % 3];
    return complex_.hexahedron_edges[item / 24][local / 2] ^ (local & 1);
  }

  const Hexahedral_complex& complex_;
  Grouped_array triangles_;
  Positions normals_; // of the base triangles
  Positions sums_;    // of each cone
};

// What the local step decided for one directed edge.
struct Target_direction
{
  Vector_3 direction = Vector_3::Zero(); // unit length
  double worst_cosine = -1; // cos α of eq. 16: against the base normals; ≤ 0 when the cone has no valid axis now
  bool is_valid() const { return worst_cosine > 0; }
};

// The local step for one cone. threshold: the ε of eq. 10. For an edge of the
// surface, surface_normal is ň of eq. 20, which is read as (n̂·ň)²: the term as
// printed would push the edge inwards instead of laying it along the surface.
inline Target_direction target_direction(const Edge_cones& cones, int directed, const Vector_3& edge_vector,
                                         double threshold, double surface_weight, const Vector_3& surface_normal)
{
  Vector_3 sum = cones.normal_sum(directed);
  bool degenerate = false;
  for (int t : cones.triangles(directed))
    degenerate = degenerate || cones.normal(t).isZero(0);

  Vector_3 average = sum;
  if (surface_weight > 0) {
    // (k I + β ň ňᵀ) x = Σ n_k, by the Sherman-Morrison formula
    const double k = static_cast<double>(cones.triangles(directed).size());
    average -= surface_weight / (k + surface_weight) * surface_normal.dot(sum) * surface_normal;
  }
  if (average.norm() > 0)
    average.normalize();
  if (!degenerate) {
    const double worst = cones.worst_cosine(directed, average);
    if (worst > threshold)
      return {average, worst};
    std::vector<Vector_3> normals;
    for (int t : cones.triangles(directed))
      normals.push_back(cones.normal(t));
    const Cone_direction solved = cone_direction(normals, threshold, surface_weight, surface_normal);
    if (solved.feasible && solved.direction.norm() > 0) {
      const Vector_3 direction = solved.direction.normalized();
      return {direction, cones.worst_cosine(directed, direction)};
    }
  }
  const double length = edge_vector.norm();
  const Vector_3 current = length > 0 ? Vector_3(edge_vector / length) : average;
  const double worst_current = cones.worst_cosine(directed, current),
               worst_average = cones.worst_cosine(directed, average);
  return worst_current > worst_average ? Target_direction{current, worst_current}
                                       : Target_direction{average, worst_average};
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_RECTIFICATION_EDGE_CONES_H
