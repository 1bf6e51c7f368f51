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
    double area; // of the reference that the sample stands for
    double distance;
    Vector_3 direction; // unit vector between the two, or a normal where they coincide
    std::size_t hint; // for the next search
  };

  Reference_pull(const Hexahedral_complex& complex, const Reference_surface& surface, double spacing)
    : complex_(complex)
    , samples_(spread_samples(surface.points, surface.triangles, complex.boundary_faces.size(), spacing))
  {
    // vertices stand for a third of the triangles around them, in addition to the samples within: tips must not be missed
    std::vector<double> around(surface.points.size(), 0.0);
    for (const Triangle_indices& t : surface.triangles) {
      const Vector_3& a = surface.points[t[0]];
      const double area = (surface.points[t[1]] - a).cross(surface.points[t[2]] - a).norm() / 2;
      for (int v : t)
        around[v] += area / 3;
    }
    for (Surface_sample& sample : samples_)
      if (sample.vertex >= 0)
        sample.area = around[sample.vertex];
  }

  // One link for every sample, always in the same order. A link whose vertices have moved by less than `still` since it
  // was found stays as it is.
  const std::vector<Link>& update(const Positions& points, double still)
  {
    std::unique_ptr<Reference_surface> boundary;
    const bool is_first = links_.empty();
    links_.resize(samples_.size());
    found_at_.resize(samples_.size());
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      Link& link = links_[i];
      if (!is_first && !has_moved(link, found_at_[i], points, still))
        continue;
      if (!boundary) {
        boundary = boundary_as_reference(complex_, points, !is_first);
        if (boundary->is_empty()) {
          links_.clear();
          return links_;
        }
      }
      const Vector_3& sample = samples_[i].point;
      const Surface_point foot = boundary->closest_point(sample, is_first ? Reference_surface::no_hint : link.hint);
      const double distance = (foot.point - sample).norm();
      link = {boundary->triangles[foot.triangle], foot.coordinates, sample, samples_[i].area, distance,
              distance > coincidence ? Vector_3((foot.point - sample) / distance) : foot.normal, foot.hint};
      for (int k = 0; k < 3; ++k)
        found_at_[i][k] = points[link.vertices[k]];
    }
    return links_;
  }

  static constexpr double coincidence = 1e-7; // below this a distance has no direction

private:
  static bool has_moved(const Link& link, const std::array<Vector_3, 3>& before, const Positions& points, double still)
  {
    for (int k = 0; k < 3; ++k)
      if ((points[link.vertices[k]] - before[k]).squaredNorm() >= still * still)
        return true;
    return false;
  }

  const Hexahedral_complex& complex_;
  std::vector<Surface_sample> samples_;
  std::vector<Link> links_;
  std::vector<std::array<Vector_3, 3>> found_at_; // the vertices of each link
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_REFERENCE_PULL_H
