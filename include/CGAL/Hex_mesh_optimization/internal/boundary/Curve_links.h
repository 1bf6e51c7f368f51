// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CURVE_LINKS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CURVE_LINKS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// For samples of the feature curves the nearest points of the mesh edges that
// represent the curve.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Curve_links
{
public:
  // A sample of a curve with the point of the edges nearest to it, Σ share_k · vertex_k of one edge.
  struct Link
  {
    std::array<int, 2> vertices;
    std::array<double, 2> shares;
    int face; // beside the edge
    Vector_3 sample;
  };

  // Curves that no edge represents have no samples.
  Curve_links(const Hexahedral_complex& complex, const Surface_faces& faces, const Reference_surface& surface,
              const Boundary_attachment& attachment, double spacing)
    : edges_(surface.curves.size())
  {
    int last = -1;
    for (const Surface_faces::Edge& e : faces.edges)
      if (attachment.curve_of_edge[e.edge] >= 0 && e.edge != std::exchange(last, e.edge))
        edges_[attachment.curve_of_edge[e.edge]].push_back({complex.edges[e.edge], e.face});
    spacing *= std::sqrt(oversize(surface.points, surface.triangles, faces.quads.size()));
    const double most = most_samples_of_edge * double(faces.edges.size());
    for (std::size_t c = 0; c < surface.curves.size(); ++c) {
      const std::vector<int>& v = surface.curves[c]->vertices;
      for (std::size_t i = 0; i + 1 < v.size() && !edges_[c].empty(); ++i) {
        const Vector_3 &a = surface.points[v[i]], &b = surface.points[v[i + 1]];
        const int n = static_cast<int>((std::max)(0.0, (std::min)(std::ceil((b - a).norm() / spacing), most)));
        for (int k = 0; k < n; ++k)
          samples_.push_back({a + (double(k) / n) * (b - a), c});
      }
    }
  }

  std::size_t size() const { return samples_.size(); }

  Link link(std::size_t i, const Positions& points) const
  {
    const Vector_3& sample = samples_[i].point;
    Link best{{}, {}, -1, sample};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge& e : edges_[samples_[i].curve]) {
      const Vector_3 &a = points[e.vertices[0]], along = points[e.vertices[1]] - a;
      const double t = (std::max)(0.0, (std::min)(1.0, along.dot(sample - a) / along.squaredNorm()));
      const double d = (a + t * along - sample).squaredNorm();
      if (d < nearest || best.face < 0) {
        nearest = d;
        best.vertices = e.vertices;
        best.shares = {1 - t, t};
        best.face = e.face;
      }
    }
    return best;
  }

private:
  struct Edge
  {
    std::array<int, 2> vertices;
    int face;
  };

  struct Sample
  {
    Vector_3 point;
    std::size_t curve;
  };

  // Far more than a curve of the size of the mesh takes: a bound for one that is much larger.
  static constexpr double most_samples_of_edge = 16;

  std::vector<std::vector<Edge>> edges_; // that represent each curve
  std::vector<Sample> samples_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CURVE_LINKS_H
