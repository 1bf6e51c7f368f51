// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H

// What holds the boundary on the reference while the quality is maximized:
// samples on boundary vertices, faces and edges, and samples of the reference
// that the boundary has left behind.

#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_pull.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary_attachment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// A point Σ share_k · vertex_k of the boundary and where it should be: target, or
// anywhere in the directions that the projector removes.
struct Attachment_sample
{
  std::array<int, 4> vertices;
  std::array<double, 4> shares;
  int count;           // of the vertices
  double weight;
  Vertex_kind kind;
  int curve;
  Vector_3 target = Vector_3::Zero();
  Matrix_3 projector = Matrix_3::Zero();

  Vector_3 place(const Positions& points) const
  {
    Vector_3 p = Vector_3::Zero();
    for (int k = 0; k < count; ++k)
      p += shares[k] * points[vertices[k]];
    return p;
  }

  // The part of the way to the target that counts.
  Vector_3 offset(const Positions& points) const { return projector * (place(points) - target); }
};

class Surface_attachment
{
public:
  Surface_attachment(const Hexahedral_complex& complex, const Reference_surface& surface, const Boundary_attachment& attachment,
                     double edge_weight, double reference_spacing)
    : surface_(surface)
    , attachment_(attachment)
    , pull_(complex, surface, reference_spacing)
  {
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      if (complex.is_on_boundary[v] && attachment.kind[v] != Vertex_kind::FIXED)
        samples.push_back({{static_cast<int>(v)}, {1.0}, 1, 1.0, attachment.kind[v], attachment.curve[v]});
    for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
      samples.push_back({f.vertices, {.25, .25, .25, .25}, 4, 1.0, Vertex_kind::SURFACE, -1});
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      const int curve = attachment.curve_of_edge[e.edge];
      samples.push_back({{complex.edges[e.edge][0], complex.edges[e.edge][1]}, {.5, .5}, 2, edge_weight,
                         curve >= 0 ? Vertex_kind::FEATURE : Vertex_kind::SURFACE, curve});
    }
    own_count_ = samples.size();
    samples_of_ = Grouped_array(complex.number_of_vertices(), 4 * own_count_,
                                [this](std::size_t k) { return samples[k / 4].vertices[k % 4 < std::size_t(samples[k / 4].count) ? k % 4 : 0]; },
                                [](std::size_t k) { return static_cast<int>(k / 4); });
  }

  // Targets and projectors at the present positions; pulls by reference samples farther than the tolerance, if asked for.
  void update(const Positions& points, bool pull, double pull_tolerance, double pull_weight)
  {
    samples.resize(own_count_);
    for (Attachment_sample& s : samples) {
      const Vector_3 p = s.place(points);
      if (s.kind == Vertex_kind::CORNER) {
        s.target = attachment_.corner[s.vertices[0]];
        s.projector = Matrix_3::Identity();
      }
      else if (s.kind == Vertex_kind::FEATURE) {
        const Curve_point c = surface_.curves[s.curve]->closest_point(p);
        s.target = c.point;
        s.projector = Matrix_3::Identity() - c.tangent * c.tangent.transpose();
      }
      else {
        const Surface_point q = surface_.closest_point(p);
        s.target = q.point;
        s.projector = direction_projector(p - q.point, q.normal);
      }
    }
    if (!pull)
      return;
    for (const Reference_pull::Link& link : pull_.update(points, pull_tolerance)) {
      Attachment_sample s{{link.vertices[0], link.vertices[1], link.vertices[2]}, {link.weights[0], link.weights[1], link.weights[2]}, 3,
                          pull_weight, Vertex_kind::SURFACE, -1};
      s.target = link.sample;
      s.projector = direction_projector(s.place(points) - link.sample, Vector_3::UnitX());
      samples.push_back(s);
    }
  }

  // Lets a vertex leave its feature for the smooth surface. False if it is on none.
  bool demote(int v)
  {
    bool any = false;
    for (int s : samples_of_[v])
      if (samples[s].kind == Vertex_kind::FEATURE || samples[s].kind == Vertex_kind::CORNER) {
        samples[s].kind = Vertex_kind::SURFACE;
        any = true;
      }
    return any;
  }

  std::vector<Attachment_sample> samples;

private:
  static Matrix_3 direction_projector(const Vector_3& offset, const Vector_3& otherwise)
  {
    const double distance = offset.norm();
    const Vector_3 n = distance > 1e-7 ? Vector_3(offset / distance) : otherwise;
    return n * n.transpose();
  }

  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  Reference_pull pull_;
  std::size_t own_count_;
  Grouped_array samples_of_; // the own samples that a vertex has a share in
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H
