// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_BOUNDED_MESH_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_BOUNDED_MESH_H

// A mesh whose boundary is bound to what it was.

#include <CGAL/Hex_mesh_optimization/internal/maximization/Places_within_bound.h>

#include "../Attached_mesh.h"
#include "../mesh_families.h"

#include <cstddef>

namespace test {

struct Bounded_mesh : Attached_mesh
{
  Boundary_samples its_samples;
  const Sliding its_sliding;
  const Places_within_bound places;

  Bounded_mesh(const Indexed_mesh& mesh, double bound)
    : Attached_mesh(mesh)
    , its_samples(complex, faces, *surface, attachment, lengths, false, bound, boundary.samples)
    , its_sliding(sliding())
    , places(*surface, attachment, its_sliding, its_samples, points.size())
  {
    its_samples.update(points, 1);
  }

  // Of a vertex that is attached to either.
  double distance(std::size_t v, const Vector_3& p) const
  {
    return attachment.kind[v] == Vertex_kind::FEATURE
             ? (surface->curves[attachment.curve[v]]->closest_point(p).point - p).norm()
             : (surface->closest_point(p, Surface_point::no_triangle, attachment.sheet[v]).point - p).norm();
  }
};

} // namespace test

using namespace test;

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_BOUNDED_MESH_H
