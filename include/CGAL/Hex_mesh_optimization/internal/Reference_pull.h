// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_PULL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_PULL_H

// The other side of the deviation: samples of the reference that the boundary of
// the mesh has left behind. Points on the mesh cannot see that the tip of a
// protrusion was cut off; the tip can.

#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/surface_samples.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

class Reference_pull
{
public:
  // A sample of the reference with the point of the mesh boundary nearest to it:
  // Σ weight_k · vertex_k of one triangle.
  struct Link
  {
    Triangle_indices vertices;
    std::array<double, 3> weights;
    Vector_3 sample;
    double distance;
  };

  Reference_pull(const Hexahedral_complex& complex, const Reference_surface& surface, double spacing)
    : complex_(complex)
    , samples_(spread_samples(surface.points, surface.triangles, spacing))
  {}

  // Links for all samples farther than `tolerance` from the boundary of the mesh.
  const std::vector<Link>& update(const Positions& points, double tolerance)
  {
    links_.clear();
    const std::unique_ptr<Reference_surface> boundary = boundary_as_reference(complex_, points);
    if (boundary->is_empty())
      return links_;
    for (const Surface_sample& surface_sample : samples_) {
      const Vector_3& sample = surface_sample.point;
      const Surface_point foot = boundary->closest_point(sample);
      const double distance = (sample - foot.point).norm();
      if (distance <= tolerance)
        continue;
      const Triangle_indices& t = boundary->triangles[foot.triangle];
      links_.push_back({t, foot.coordinates, sample, distance});
    }
    return links_;
  }

private:
  const Hexahedral_complex& complex_;
  std::vector<Surface_sample> samples_;
  std::vector<Link> links_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_PULL_H
