// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H

// What holds the boundary on the reference while the quality is maximized:
// samples on boundary vertices, faces and edges, and samples of the reference and
// its feature curves, which pull from the other side.

#include <CGAL/Hex_mesh_optimization/internal/solver/Block_matrix.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Conflict_free_ranges.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Distance_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Maximization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Reference_links.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

// A point Σ share_k · vertex_k of the boundary and where it should be: target, or
// anywhere in the directions that the projector removes.
struct Attachment_sample
{
  static constexpr std::size_t no_triangle = static_cast<std::size_t>(-1);

  std::array<int, 4> vertices;
  std::array<double, 4> shares;
  int count; // of the vertices
  int face;  // of the boundary, that has them all
  double weight;
  Vertex_kind kind;
  int curve;
  double scale = 0;  // of the distance: the local edge length
  std::size_t triangle = no_triangle; // of the target
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
    , complex_(complex)
    , surface_(surface)
    , attachment_(attachment)
    , pull_(complex, surface, parameters.reference_spacing)
    , scale_(mean_boundary_lengths(complex, lengths))
    , curve_edges_(surface.curves.size())
    , face_ranges_(complex.boundary_faces.size(), complex.number_of_vertices(), faces_of_range,
                   [&](std::size_t f) -> const std::array<int, 4>& { return complex.boundary_faces[f].vertices; })
  {
    const double typical = parameters.typical_edge * bounding_box_diagonal(surface); // in mean boundary edges, which are 1
    energy_ = {parameters.attachment_weight / std::pow(typical, parameters.size_exponent) * (trusted ? parameters.trust : 1), parameters.linear_distance,
               parameters.steep_weight, parameters.steep_distance * std::sqrt(typical)};
    add_samples(complex);
    own_count_ = samples_.size();
    nearby_.reset(own_count_);
    queried_at_.assign(own_count_, Vector_3::Constant(std::numeric_limits<double>::infinity()));
    spread_over_curves(complex);
  }

  double tightness = 1; // factor of all weights

  // Finds the targets of all samples from the present positions. What has hardly moved keeps its own.
  void update(const Positions& points)
  {
    for_each(own_count_, [&](std::size_t i) {
      const Vector_3 p = samples_[i].place(points);
      const double still = parameters_.still_distance * samples_[i].scale;
      if ((p - queried_at_[i]).squaredNorm() < still * still)
        return;
      queried_at_[i] = p;
      aim(i, p);
    }, 256);
    const std::vector<Reference_pull::Link>& links = pull_.update(points, parameters_.still_distance);
    samples_.resize(own_count_ + links.size() + curve_samples_.size()); // the same number each time, so that strains are kept
    for_each(links.size(), [&](std::size_t i) {
      if (links[i].is_new)
        follow(links[i], samples_[own_count_ + i]);
    });
    for_each(curve_samples_.size(), [&](std::size_t i) { follow(points, curve_samples_[i], samples_[own_count_ + links.size() + i]); }, 64);
    if (std::isfinite(parameters_.maximum_deviation))
      strain(points);
    of_face_ = Grouped_array(complex_.boundary_faces.size(), samples_.size(), [this](std::size_t i) { return samples_[i].face; },
                             [](std::size_t i) { return static_cast<int>(i); });
  }

  double energy(const Positions& points) const
  {
    return tightness * sum_of_ranges(samples_.size(), [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Attachment_sample& s = samples_[i];
        sum += s.weight * s.strain * energy_.value(s.offset(points).norm() / s.scale);
      }
      return sum;
    });
  }

  // Adds gradient and a positive semi-definite model of the Hessian.
  void add_derivatives(const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    face_ranges_.for_ranges([&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        add_derivatives(f, points, gradient, matrix);
    });
  }

  // The farthest that a sample is from its target.
  double largest_distance(const Positions& points) const
  {
    double largest = 0;
    for (double of_range : results_of_ranges<double>(samples_.size(), [&](std::size_t begin, std::size_t end) {
           double square = 0;
           for (std::size_t i = begin; i < end; ++i)
             square = (std::max)(square, samples_[i].offset(points).squaredNorm());
           return square;
         }))
      largest = (std::max)(largest, of_range);
    return std::sqrt(largest);
  }

private:
  // Of the mesh, with one of the faces beside it.
  struct Curve_edge
  {
    std::array<int, 2> vertices;
    int face;
  };

  struct Curve_sample
  {
    Vector_3 point;
    std::size_t curve;
  };

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

  static constexpr std::size_t faces_of_range = 64;

  // Samples share faces, so that the matrix is visited once for all of one face.
  void add_derivatives(std::size_t f, const Positions& points, Positions& gradient, Block_matrix& matrix) const
  {
    const std::array<int, 4>& corners = complex_.boundary_faces[f].vertices;
    using Symmetric = Eigen::Matrix<double, 6, 1>; // xx, xy, xz, yy, yz, zz: as shares are numbers, all blocks are symmetric
    Symmetric blocks[4][4];
    Vector_3 gradients[4];
    for (int i = 0; i < 4; ++i) {
      gradients[i].setZero();
      for (int j = 0; j <= i; ++j)
        blocks[i][j].setZero();
    }
    for (int sample : of_face_[f]) {
      const Attachment_sample& s = samples_[sample];
      const Vector_3 offset = s.offset(points);
      const double square = s.scale * s.scale, weight = tightness * s.weight * s.strain / square;
      const Distance_energy::Derivatives e = energy_.derivatives(offset.norm() / s.scale);
      const Vector_3 force = weight * e.slope * offset, o = weight * e.growth / square * offset;
      const Matrix_3& P = s.projector;
      const double slope = weight * e.slope;
      Symmetric hessian;
      hessian << slope * P(0, 0) + o[0] * offset[0], slope * P(0, 1) + o[0] * offset[1], slope * P(0, 2) + o[0] * offset[2],
        slope * P(1, 1) + o[1] * offset[1], slope * P(1, 2) + o[1] * offset[2], slope * P(2, 2) + o[2] * offset[2];
      double shares[4] = {0, 0, 0, 0};
      for (int k = 0; k < s.count; ++k)
        shares[std::find(corners.begin(), corners.end(), s.vertices[k]) - corners.begin()] = s.shares[k];
      for (int i = 0; i < 4; ++i) {
        if (shares[i] == 0)
          continue;
        gradients[i] += shares[i] * force;
        for (int j = 0; j <= i; ++j)
          blocks[i][j] += shares[i] * shares[j] * hessian;
      }
    }
    for (int i = 0; i < 4; ++i) {
      gradient[corners[i]] += gradients[i];
      for (int j = 0; j <= i; ++j) {
        const Symmetric& b = blocks[i][j];
        matrix.add(corners[i], corners[j], (Matrix_3() << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5]).finished());
      }
    }
  }

  // Gives a sample the weight that follows from what it is on.
  void weigh(Attachment_sample& s) const
  {
    s.scale = 0;
    for (int k = 0; k < s.count; ++k)
      s.scale += scale_[s.vertices[k]] / s.count;
    s.weight *= s.scale * s.scale * s.scale;
    if (s.kind != Vertex_kind::SURFACE)
      s.weight *= parameters_.feature_weight;
  }

  void add(const Attachment_sample& sample)
  {
    samples_.push_back(sample);
    weigh(samples_.back());
  }

  // A sample of the reference pulls the point of the boundary that it is linked to.
  void follow(const Reference_pull::Link& link, Attachment_sample& s) const
  {
    const double strain = s.strain; // outlives the link
    s = {{link.vertices[0], link.vertices[1], link.vertices[2], -1}, {link.weights[0], link.weights[1], link.weights[2], 0}, 3,
         static_cast<int>(link.triangle / 2), parameters_.pull_weight, Vertex_kind::SURFACE, -1};
    weigh(s);
    s.weight *= link.area / (s.scale * s.scale);
    s.target = link.sample;
    s.projector = link.direction * link.direction.transpose();
    s.strain = strain;
  }

  // A sample of a feature curve pulls the nearest point of the edges that represent the curve.
  void follow(const Positions& points, const Curve_sample& sample, Attachment_sample& s) const
  {
    const double strain = s.strain;
    s = nearest_point(points, curve_edges_[sample.curve], sample.point);
    weigh(s);
    s.target = sample.point;
    s.projector = direction_projector(s.place(points) - sample.point, Vector_3::UnitX());
    s.strain = strain;
  }

  void add_samples(const Hexahedral_complex& complex)
  {
    for (std::size_t v = 0; v < complex.number_of_vertices(); ++v)
      if (complex.is_on_boundary[v] && attachment_.kind[v] != Vertex_kind::FIXED)
        add({{static_cast<int>(v)}, {1.0}, 1, complex.vertex_boundary_faces[v][0], 1.0, attachment_.kind[v], attachment_.curve[v]});
    for (std::size_t f = 0; f < complex.boundary_faces.size(); ++f)
      add({complex.boundary_faces[f].vertices, {.25, .25, .25, .25}, 4, static_cast<int>(f), 1.0, Vertex_kind::SURFACE, -1});
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      const std::array<int, 2>& ends = complex.edges[e.edge];
      const int curve = attachment_.curve_of_edge[e.edge];
      add({{ends[0], ends[1]}, {.5, .5}, 2, e.left, parameters_.edge_sample_weight,
           curve >= 0 ? Vertex_kind::FEATURE : Vertex_kind::SURFACE, curve});
    }
  }

  void spread_over_curves(const Hexahedral_complex& complex)
  {
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges)
      if (attachment_.curve_of_edge[e.edge] >= 0)
        curve_edges_[attachment_.curve_of_edge[e.edge]].push_back({complex.edges[e.edge], e.left});
    const double spacing =
      parameters_.reference_spacing * std::sqrt(oversize(surface_.points, surface_.triangles, complex.boundary_faces.size()));
    const double most = 16. * double(complex.boundary_edges.size()); // far more than a curve of the size of the mesh takes
    for (std::size_t c = 0; c < surface_.curves.size(); ++c) {
      const std::vector<int>& v = surface_.curves[c]->vertices;
      for (std::size_t i = 0; i + 1 < v.size() && !curve_edges_[c].empty(); ++i) {
        const Vector_3 &a = surface_.points[v[i]], &b = surface_.points[v[i + 1]];
        const int n = static_cast<int>((std::max)(0.0, (std::min)(std::ceil((b - a).norm() / spacing), most)));
        for (int k = 0; k < n; ++k)
          curve_samples_.push_back({a + (double(k) / n) * (b - a), c});
      }
    }
  }

  void aim(std::size_t i, const Vector_3& p)
  {
    Attachment_sample& s = samples_[i];
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
      const Surface_point q = closest_point(i, p, s.triangle);
      s.triangle = q.triangle;
      s.target = q.point;
      s.projector = direction_projector(p - q.point, surface_.normal(q.triangle, q.coordinates));
    }
  }

  // Of the reference to sample i, which was closest to triangle `before`, if there was one.
  Surface_point closest_point(std::size_t i, const Vector_3& p, std::size_t before)
  {
    if (before == Attachment_sample::no_triangle)
      return surface_.closest_point(p);
    if (const std::optional<Surface_point> q = nearby_.closest(i, p, before, surface_.points, surface_, 0))
      return *q;
    const Surface_point bound = closest_point_of_triangle(p, before, surface_.points, surface_.triangles);
    return surface_.closer_point(p, bound.point).value_or(bound);
  }

  // The point of some edges nearest to a sample of the curve that they represent.
  Attachment_sample nearest_point(const Positions& points, const std::vector<Curve_edge>& edges, const Vector_3& sample) const
  {
    Attachment_sample best{{}, {}, 2, -1, parameters_.curve_pull_weight, Vertex_kind::FEATURE, -1};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Curve_edge& e : edges) {
      const Vector_3 &a = points[e.vertices[0]], along = points[e.vertices[1]] - a;
      const double t = (std::max)(0.0, (std::min)(1.0, along.dot(sample - a) / along.squaredNorm()));
      const double d = (a + t * along - sample).squaredNorm();
      if (d < nearest || best.face < 0) {
        nearest = d;
        best.vertices = {e.vertices[0], e.vertices[1]};
        best.shares = {1 - t, t};
        best.face = e.face;
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
  const Hexahedral_complex& complex_;
  const Reference_surface& surface_;
  const Boundary_attachment& attachment_;
  Distance_energy energy_;
  Reference_pull pull_;
  std::vector<double> scale_;                                // of each boundary vertex
  std::vector<Attachment_sample> samples_;                   // own ones first, then those of the reference
  std::size_t own_count_ = 0;
  Positions queried_at_;                                     // where each own sample was when its target was found
  Nearby_triangles nearby_;                                  // of the reference, to each own sample
  std::vector<std::vector<Curve_edge>> curve_edges_;         // that represent each curve
  std::vector<Curve_sample> curve_samples_;                  // of the curves that are represented
  Grouped_array of_face_;                                    // the samples of each boundary face
  const Conflict_free_ranges face_ranges_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_ENERGY_H
