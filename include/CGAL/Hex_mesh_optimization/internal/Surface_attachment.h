// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H

// What holds the boundary on the reference while the quality is maximized:
// samples on boundary vertices, faces and edges, and samples of the reference and
// its feature curves, which pull from the other side.

#include <CGAL/Hex_mesh_optimization/internal/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_pull.h>
#include <CGAL/Hex_mesh_optimization/internal/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/deviation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
  int count; // of the vertices
  double weight;
  Vertex_kind kind;
  int curve;
  double scale = 0;  // of the distance: the local edge length
  std::size_t hint = Reference_surface::no_hint; // for the next search of the target
  double strain = 1; // grows while the sample is farther than the bound of the deviation allows
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
  // lengths: the target lengths of the edges. trusted: the reference is not the boundary of the mesh itself.
  Surface_attachment(const Hexahedral_complex& complex, const Reference_surface& surface, const Boundary_attachment& attachment,
                     const std::vector<double>& lengths, bool trusted, const Maximization_parameters& parameters)
    : parameters_(parameters)
    , surface_(surface)
    , attachment_(attachment)
    , pull_(complex, surface, parameters.reference_spacing)
    , scale_(mean_boundary_lengths(complex, lengths))
    , curve_edges_(surface.curves.size())
    , curve_samples_(surface.curves.size())
  {
    const double typical = parameters.typical_edge * bounding_box_diagonal(surface); // in mean boundary edges, which are 1
    energy_ = {parameters.attachment_weight / std::pow(typical, parameters.size_exponent) * (trusted ? parameters.trust : 1), parameters.linear_distance,
               parameters.steep_weight, parameters.steep_distance * std::sqrt(typical)};
    add_samples(complex);
    own_count_ = samples_.size();
    queried_at_.assign(own_count_, Vector_3::Constant(std::numeric_limits<double>::infinity()));
    spread_over_curves(complex);
  }

  double tightness = 1; // factor of all weights

  // Finds the targets of all samples from the present positions. What has hardly moved keeps its own.
  void update(const Positions& points)
  {
    for (std::size_t i = 0; i < own_count_; ++i) {
      const Vector_3 p = samples_[i].place(points);
      const double still = parameters_.still_distance * samples_[i].scale;
      if ((p - queried_at_[i]).squaredNorm() < still * still)
        continue;
      queried_at_[i] = p;
      aim(samples_[i], p);
    }
    std::vector<double> strains; // those of pulling samples outlive their links, whose order does not change
    for (std::size_t i = own_count_; i < samples_.size(); ++i)
      strains.push_back(samples_[i].strain);
    samples_.resize(own_count_);
    for (const Reference_pull::Link& link : pull_.update(points, parameters_.still_distance)) {
      Attachment_sample& s = add({{link.vertices[0], link.vertices[1], link.vertices[2]},
                                  {link.weights[0], link.weights[1], link.weights[2]},
                                  3, parameters_.pull_weight, Vertex_kind::SURFACE, -1});
      s.weight *= link.area / (s.scale * s.scale);
      s.target = link.sample;
      s.projector = link.direction * link.direction.transpose();
    }
    for (std::size_t c = 0; c < curve_samples_.size(); ++c)
      if (!curve_edges_[c].empty())
        for (const Vector_3& sample : curve_samples_[c]) {
          Attachment_sample& s = add(nearest_point(points, curve_edges_[c], sample));
          s.target = sample;
          s.projector = direction_projector(s.place(points) - sample, Vector_3::UnitX());
        }
    if (strains.size() == samples_.size() - own_count_)
      for (std::size_t i = 0; i < strains.size(); ++i)
        samples_[own_count_ + i].strain = strains[i];
    if (std::isfinite(parameters_.maximum_deviation))
      strain(points);
  }

  double energy(const Positions& points) const
  {
    double sum = 0;
    for (const Attachment_sample& s : samples_)
      sum += s.weight * s.strain * energy_.value(s.offset(points).norm() / s.scale);
    return tightness * sum;
  }

  // Adds gradient and a positive semi-definite model of the Hessian.
  void add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    for (const Attachment_sample& s : samples_) {
      const Vector_3 offset = s.offset(points);
      const double square = s.scale * s.scale, weight = tightness * s.weight * s.strain / square;
      const Distance_energy::Derivatives e = energy_.derivatives(offset.norm() / s.scale);
      const Matrix_3 hessian = weight * (e.slope * s.projector + e.growth / square * offset * offset.transpose());
      for (int i = 0; i < s.count; ++i) {
        gradient[s.vertices[i]] += weight * e.slope * s.shares[i] * offset;
        for (int j = 0; j <= i; ++j)
          matrix.add(s.vertices[i], s.vertices[j], s.shares[i] * s.shares[j] * hessian);
      }
    }
  }

  // The farthest that a sample is from its target.
  double largest_distance(const Positions& points) const
  {
    double largest = 0;
    for (const Attachment_sample& s : samples_)
      largest = (std::max)(largest, s.offset(points).squaredNorm());
    return std::sqrt(largest);
  }

private:
  // Of the boundary edges around each boundary vertex.
  static std::vector<double> mean_boundary_lengths(const Hexahedral_complex& complex, const std::vector<double>& lengths)
  {
    std::vector<double> sum(complex.number_of_vertices(), 0.0), count(complex.number_of_vertices(), 0.0);
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
      for (int v : complex.edges[e.edge]) {
        sum[v] += lengths[e.edge];
        ++count[v];
      }
    for (std::size_t v = 0; v < sum.size(); ++v)
      sum[v] /= (std::max)(count[v], 1.0);
    return sum;
  }

  Attachment_sample& add(const Attachment_sample& sample)
  {
    samples_.push_back(sample);
    Attachment_sample& s = samples_.back();
    for (int k = 0; k < s.count; ++k)
      s.scale += scale_[s.vertices[k]] / s.count;
    s.weight *= s.scale * s.scale * s.scale;
    if (s.kind != Vertex_kind::SURFACE)
      s.weight *= parameters_.feature_weight;
    return s;
  }

  void add_samples(const Hexahedral_complex& complex)
  {
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      if (complex.is_on_boundary[v] && attachment_.kind[v] != Vertex_kind::FIXED)
        add({{static_cast<int>(v)}, {1.0}, 1, 1.0, attachment_.kind[v], attachment_.curve[v]});
    for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces)
      add({f.vertices, {.25, .25, .25, .25}, 4, 1.0, Vertex_kind::SURFACE, -1});
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      const std::array<int, 2>& ends = complex.edges[e.edge];
      const int curve = attachment_.curve_of_edge[e.edge];
      add({{ends[0], ends[1]}, {.5, .5}, 2, parameters_.edge_sample_weight,
           curve >= 0 ? Vertex_kind::FEATURE : Vertex_kind::SURFACE, curve});
    }
  }

  void spread_over_curves(const Hexahedral_complex& complex)
  {
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
      if (attachment_.curve_of_edge[e.edge] >= 0)
        curve_edges_[attachment_.curve_of_edge[e.edge]].push_back(complex.edges[e.edge]);
    const double spacing =
      parameters_.reference_spacing * std::sqrt(oversize(surface_.points, surface_.triangles, complex.boundary_faces.size()));
    const double most = 16. * double(complex.boundary_edges.size()); // far more than a curve of the size of the mesh takes
    for (std::size_t c = 0; c < curve_samples_.size(); ++c) {
      const std::vector<int>& v = surface_.curves[c]->vertices;
      for (std::size_t i = 0; i + 1 < v.size(); ++i) {
        const Vector_3 &a = surface_.points[v[i]], &b = surface_.points[v[i + 1]];
        const int n = static_cast<int>((std::max)(0.0, (std::min)(std::ceil((b - a).norm() / spacing), most)));
        for (int k = 0; k < n; ++k)
          curve_samples_[c].push_back(a + (double(k) / n) * (b - a));
      }
    }
  }

  void aim(Attachment_sample& s, const Vector_3& p) const
  {
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
      const Surface_point q = surface_.closest_point(p, s.hint);
      s.hint = q.hint;
      s.target = q.point;
      s.projector = direction_projector(p - q.point, q.normal);
    }
  }

  // The point of some edges nearest to a sample of the curve that they represent.
  Attachment_sample nearest_point(const Positions& points, const std::vector<std::array<int, 2>>& edges, const Vector_3& sample) const
  {
    Attachment_sample best{{edges[0][0], edges[0][1]}, {1, 0}, 2, parameters_.curve_pull_weight, Vertex_kind::FEATURE, -1};
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::array<int, 2>& e : edges) {
      const Vector_3 &a = points[e[0]], along = points[e[1]] - a;
      const double t = (std::max)(0.0, (std::min)(1.0, along.dot(sample - a) / along.squaredNorm()));
      const double d = (a + t * along - sample).squaredNorm();
      if (d < nearest) {
        nearest = d;
        best.vertices = {e[0], e[1]};
        best.shares = {1 - t, t};
      }
    }
    return best;
  }

  void strain(const Positions& points)
  {
    for (Attachment_sample& s : samples_)
      if (s.offset(points).norm() > parameters_.strained_part * parameters_.maximum_deviation)
        s.strain = (std::min)(s.strain * parameters_.straining, parameters_.largest_strain);
  }

  static Matrix_3 direction_projector(const Vector_3& offset, const Vector_3& otherwise)
  {
    const double distance = offset.norm();
    const Vector_3 n = distance > Reference_pull::coincidence ? Vector_3(offset / distance) : otherwise;
    return n * n.transpose();
  }

  const Maximization_parameters parameters_;
  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  Distance_energy energy_;
  Reference_pull pull_;
  std::vector<double> scale_;                                // of each boundary vertex
  std::vector<Attachment_sample> samples_;                   // own ones first, then those of the reference
  std::size_t own_count_ = 0;
  Positions queried_at_;                                     // where each own sample was when its target was found
  std::vector<std::vector<std::array<int, 2>>> curve_edges_; // of the mesh, that represent each curve
  std::vector<Positions> curve_samples_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_SURFACE_ATTACHMENT_H
