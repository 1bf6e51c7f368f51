// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_SAMPLES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_SAMPLES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// Samples of what holds surface faces on the reference, with their targets: on
// vertices, faces and edges of the mesh, and from the other side of the reference
// and its feature curves.

#include <CGAL/Hex_mesh_optimization/internal/base/Grouped_array.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Curve_links.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Reference_links.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Reference_targets.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Solid_thickness.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Surface_faces.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Target.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/certified_deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// Lengths are in mean boundary edges unless something else is said.
// Numbers without another source were chosen together by a coordinate search on organic and CAD models of 2,500 to
// 38,000 hexahedra.
struct Boundary_sample_parameters
{
  // Weights of the samples, times the scale of the distance, which is relative to that, and the area of a local edge
  // squared, so that all is summed as the average deviation is. 1 at vertices and centers of faces.
  double edge_weight = .5;
  // Of samples of the reference, per area of one squared edge, and per edge length of a feature curve.
  double pull_weight = 10.2;
  double curve_pull_weight = .5;
  double reference_spacing = .8;
  // Of samples on sharp edges of a reference that the mesh has to be brought to, or that it is bound to: edges that are no
  // features, or that no edge of the mesh follows, are cut off where no sample is on them. Each stands for an area of its
  // length times the width. A boundary that is its own reference is too rough for that.
  double crest_spacing = .3;
  double crest_width = .25;
  // Factor for features.
  double feature_weight = 4.6;
  // Bound of the distances of interfaces, in units of the scale: between the samples it may be somewhat more, and a tenth
  // of an edge is what an interface may be off.
  double interface_deviation = .085;
  // Samples keep their targets until they have moved this far, in units of the scale.
  double still_distance = .02;

  // What is tolerated where no bound is given, in units of the scale: a mesh farther than that from a reference of its own
  // has not been brought to it. What comes from the reference itself is tolerated wherever the quality takes it.
  double tolerance = .3;

  // Factor of the weights on faces of which a fixed vertex is farther off than that, as at a wavy interface within a
  // fixed boundary, which the border of the interface cannot follow.
  double emphasis_of_held_away = .3;

  // --- Where distances are bounded ---
  // Samples keep to this part of the bound: what is between them may be farther off.
  double kept_part = .98;
  // While the boundary is attached with a tightness t < 1, the bound is larger by t to the power of minus this.
  double loosening = .25;
  // The tighter the bound is over this part of the scale, the more the average distance counts too, with a root of
  // that: walls alone hold the largest. Less for a given reference, by the square of the factor that its weights have as
  // it is.
  double close_distance = .8;
  double close_distance_of_own = .032;
  // The same factor for interfaces, whose bound is always the same part of the scale.
  double emphasis_of_interfaces = 1.5;
  // Weight of the wall of the tube, and where it stands: at this part of the bound, or of the distance if that is
  // larger: what is outside is drawn in step by step.
  double wall_weight = 11;
  double wall = 1.05;
  // Once the boundary is fully tight, the part of that weight which acts on a sample is multiplied, in each iteration, by
  // the square of its distance over the aimed part of the bound, within the two factors, from the least part up to 1:
  // only what would leave the bound is held by its wall. They are the multipliers of a method of nonlinear rescaling for
  // inequality constraints.
  double aimed_part = .97;
  double least_wall = .1;
  double wall_fading = .5, wall_return = 2;
  // A step may not take a sample farther than this part of the bound, or so much farther than it is.
  double most_of_bound = 1;
  double most_growth = 1.2;
  // Further samples of interfaces, on a lattice of so many parts along an edge, weigh so much: two materials share what there
  // is between them, and an interface would be off between the other samples.
  int parts = 4;
  double further_weight = .1;
  // What a sample at a place that was found beyond the bound weighs, and the area that it stands for on the reference.
  double weight_beyond = .1;
  double area_beyond = .05;
};

// A point Σ share_k · vertex_k of a face and where it should be.
struct Boundary_sample
{
  std::array<int, 4> vertices;
  std::array<double, 4> shares;
  int count; // of the vertices
  int face;  // that has them all
  double weight;
  Vertex_kind kind;
  int curve;
  double scale = 0;                                       // of the distance: the local edge, or thickness if it is less
  double bound = std::numeric_limits<double>::infinity(); // of the distance
  double wall = std::numeric_limits<double>::infinity();  // of the distance, for now
  double hold = 1;                                        // part of the weight of the wall, for now
  double emphasis = 1;                                    // factor of the weight, but at the wall
  Target target = {};

  Vector_3 place(const Positions& points) const
  {
    Vector_3 p = Vector_3::Zero();
    for (int k = 0; k < count; ++k)
      p += shares[k] * points[vertices[k]];
    return p;
  }

  // The part of the way to the target that counts.
  Vector_3 offset(const Positions& points) const { return target.offset(place(points)); }
};

class Boundary_samples
{
public:
  // faces: of the complex, with the sheets of the surface. lengths: the target lengths of the edges. has_tolerance: a
  // mesh has to be brought to the reference, which is not its own boundary. maximum_deviation: the bound of all
  // distances. The complex, the faces, the surface and the attachment must outlive the object.
  Boundary_samples(const Hexahedral_complex& complex, const Surface_faces& faces, const Reference_surface& surface,
                   const Boundary_attachment& attachment, const std::vector<double>& lengths, bool has_tolerance,
                   double maximum_deviation, const Boundary_sample_parameters& parameters)
    : parameters_(parameters)
    , maximum_deviation_(maximum_deviation)
    , tolerance_(has_tolerance ? parameters.tolerance : std::numeric_limits<double>::infinity())
    , faces_(faces)
    , surface_(surface)
    , has_interface_(std::any_of(faces.labels.begin(), faces.labels.end(),
                                 [](const std::array<int, 2>& labels) { return labels[1] != Surface_faces::no_label; }))
    , attachment_(attachment)
    , is_held_(!has_tolerance && !is_bounded() && !may_move(faces, attachment))
    , edge_(mean_lengths(complex, faces_, lengths))
    , thickness_(thicknesses(complex, lengths))
    , own_count_(is_held_ ? 0 : add_samples(complex))
    , targets_(surface, own_count_)
    , reference_links_(faces_, surface, parameters.reference_spacing, parameters.crest_spacing,
                       this->has_tolerance() ? parameters.crest_width : 0)
    , curve_links_(complex, faces_, surface, attachment, parameters.reference_spacing)
  {}

  // Whether no vertex of the faces can move, and nothing asks how far off they are: then there are no samples.
  bool is_held() const { return is_held_; }

  // Finds the targets of all samples from the present positions. What has hardly moved keeps its own. tightness: with
  // which the boundary is attached.
  void update(const Positions& points, double tightness)
  {
    if (!is_held_)
      find_targets(points, tightness);
    of_face_ = Grouped_array(
      faces_.quads.size(), samples_.size(), [this](std::size_t i) { return samples_[i].face; },
      [](std::size_t i) { return static_cast<int>(i); });
  }

  // Adds a sample at the farthest place of each triangle of the mesh and of the reference that is beyond its bound
  // somewhere, which the other samples do not see; whether there are such places. An exchange method for infinitely many
  // constraints. O(n log n); after an update(), and if there are any, before another.
  bool add_where_beyond(const Positions& points)
  {
    if (!is_bounded())
      return false;
    std::vector<double> bounds;
    for (std::size_t f = 0; f < faces_.quads.size(); ++f) {
      const Boundary_sample center = on_face(f, .5, .5, 1);
      bounds.push_back(!is_bounded(center.face) || is_held_away_[f]
                         ? std::numeric_limits<double>::infinity()
                         : bound_of(center.face, scale_on_surface(center.face, local_edge(center))) /
                             parameters_.kept_part);
    }
    const Triangle_surface faces = as_triangle_surface(faces_, points);
    std::vector<Boundary_sample> own;
    for (const Found_in_triangle& place :
         farthest_places(faces, surface_, [&](std::size_t triangle, std::size_t) { return bounds[triangle / 2]; })) {
      const Surface_point p = closest_point_of_triangle(place.where, place.triangle, points, faces.triangles);
      own.push_back(in_triangle(place.triangle, p.coordinates, parameters_.weight_beyond));
      weigh(own.back(), square_of_edge(own.back()));
    }
    std::vector<Surface_sample> of_reference;
    for (const Found_in_triangle& place :
         farthest_places(surface_, faces, [&](std::size_t, std::size_t near) { return bounds[near / 2]; }))
      of_reference.push_back({place.where, parameters_.area_beyond, -1, surface_.sheet(place.triangle)});
    if (own.empty() && of_reference.empty())
      return false;
    samples_.resize(own_count_);
    samples_.insert(samples_.end(), own.begin(), own.end());
    // those of the mesh come first, then those of the reference
    holds_.insert(holds_.begin() + own_count_ + link_count_, of_reference.size(), 1.0);
    holds_.insert(holds_.begin() + own_count_, own.size(), 1.0);
    own_count_ += own.size();
    targets_.add(own.size());
    reference_links_.add(of_reference);
    link_count_ = 0;
    return true;
  }

  // Lets walls fade where samples are well within their bounds, and return where they are not. After an update(). Those
  // of interfaces stay: between few samples on coarse faces they would be left by a third of their bound.
  void adapt_walls(const Positions& points)
  {
    if (!is_bounded_everywhere())
      return;
    for_each(samples_.size(), [&](std::size_t i) {
      Boundary_sample& s = samples_[i];
      const double part = s.offset(points).norm() / (parameters_.aimed_part * s.bound);
      s.hold *= std::clamp(part * part, parameters_.wall_fading, parameters_.wall_return);
      holds_[i] = s.hold = std::clamp(s.hold, parameters_.least_wall, 1.0);
    });
  }

  // All walls act in full again.
  void restore_walls() { std::fill(holds_.begin(), holds_.end(), 1.0); }

  // Those of the mesh first, then those of the reference.
  const std::vector<Boundary_sample>& samples() const { return samples_; }
  const std::vector<std::array<int, 4>>& faces() const { return faces_.quads; }
  // The samples on a face, each of which is on one face.
  Grouped_array::Group of_face(std::size_t f) const { return of_face_[f]; }

  double wall_weight() const { return parameters_.wall_weight; }
  double maximum_deviation() const { return maximum_deviation_; }
  // Whether a sample can be farther off than it may.
  bool has_tolerance() const { return is_bounded() || has_reference_of_its_own(); }
  // Whether the distances of all samples are bounded.
  bool is_bounded_everywhere() const { return std::isfinite(maximum_deviation_); }
  // Whether they are, to less than what is tolerated without a bound.
  bool is_closely_bounded() const { return maximum_deviation_ < parameters_.tolerance; }
  // Whether there is a reference that is not the mesh's own boundary, and not every vertex has to be on it.
  bool has_reference_of_its_own() const { return std::isfinite(tolerance_); }
  bool has_interface() const { return has_interface_; }
  // Whether the distances of some samples are bounded: those of interfaces are.
  bool is_bounded() const { return has_interface_ || std::isfinite(maximum_deviation_); }

  // By how much the samples exceed what is tolerated at the most, relative to it. Those of faces with a fixed vertex that
  // does so itself do not count: they would hide all others.
  double excess(const Positions& points) const
  {
    double largest = 0;
    if (!has_tolerance())
      return largest;
    for (double of_range : results_of_ranges<double>(samples_.size(), [&](std::size_t begin, std::size_t end) {
           double of_range = 0;
           for (std::size_t i = begin; i < end; ++i)
             if (!is_held_away_[samples_[i].face])
               of_range = (std::max)(of_range, samples_[i].offset(points).norm() / tolerated(samples_[i]) - 1);
           return of_range;
         }))
      largest = (std::max)(largest, of_range);
    return largest;
  }

  // Tells which hexahedra have a sample that gets too far when the points go to where they are reached.
  void find_leaving(const Positions& points, const Positions& reached, const Hexahedral_complex& complex,
                    std::vector<char>& is_leaving)
  {
    if (!is_bounded())
      return;
    std::vector<char> leaves(samples_.size(), false);
    for_each(samples_.size(), [&](std::size_t i) {
      const Boundary_sample& s = samples_[i];
      const double now = s.offset(points).norm(), then = s.offset(reached).norm(),
                   most = parameters_.most_of_bound * (std::max)(s.bound, parameters_.most_growth * now);
      // only the way of what moves so far has to be looked at more closely
      const bool may_turn = s.kind == Vertex_kind::SURFACE &&
                            now + (s.place(reached) - s.place(points)).norm() > most;
      leaves[i] = then > most || (may_turn && !is_within(i, reached, most));
    });
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (leaves[i])
        for (int h :
             {complex.boundary_faces[samples_[i].face].hexahedron, complex.boundary_faces[samples_[i].face].beyond})
          if (h >= 0)
            is_leaving[h] = true;
  }

  // Whether no sample on these faces is farther than tolerated, whatever is nearest to it by now. Those of the reference
  // look for it on these faces only. After an update(). What is between the samples it does not see.
  bool are_within(const std::vector<int>& faces, const Positions& points)
  {
    std::vector<std::array<int, 4>> quads;
    for (int f : faces)
      quads.push_back(faces_.quads[f]);
    const std::vector<Triangle_indices> triangles = split_quads(quads);
    return std::all_of(faces.begin(), faces.end(), [&](int f) {
      const Grouped_array::Group on_face = of_face_[f];
      return std::all_of(on_face.begin(), on_face.end(),
                         [&](int i) { return !(distance(i, triangles, points) > tolerated(samples_[i])); });
    });
  }

private:
  void find_targets(const Positions& points, double tightness)
  {
    if (is_held_away_.empty())
      find_held_away(points);
    for_each(
      own_count_,
      [&](std::size_t i) {
        const Vector_3 p = samples_[i].place(points);
        if (targets_.has_moved(i, p, parameters_.still_distance * samples_[i].scale))
          aim(i, p);
      },
      searches_of_range);
    const std::vector<Reference_links::Link>& links = reference_links_.update(points, parameters_.still_distance);
    const bool have_come = link_count_ != links.size();
    link_count_ = links.size();
    samples_.resize(own_count_ + link_count_ + curve_links_.size());
    for_each(links.size(), [&](std::size_t i) {
      if (links[i].is_new || have_come)
        follow(links[i], samples_[own_count_ + i]);
    });
    for_each(
      curve_links_.size(),
      [&](std::size_t i) { follow(curve_links_.link(i, points), points, samples_[own_count_ + links.size() + i]); },
      curve_searches_of_range);
    if (is_bounded())
      bound(points, tightness);
    ease_held_away();
  }

  // Whether the distance of sample i, which is on the surface, is no more than that.
  bool is_within(std::size_t i, const Positions& points, double most)
  {
    const Boundary_sample& s = samples_[i];
    if (i < own_count_)
      return targets_.is_within(i, s.place(points), faces_.sheet(s.face), most);
    return distance(i, std::array<Triangle_indices, 1>{{{s.vertices[0], s.vertices[1], s.vertices[2]}}}, points) <= most;
  }

  // How far sample i is from what it is attached to, where the target that it has tells less than that: the surface, or
  // the curve, may turn on the way. triangles: among which a sample of the reference looks for the nearest.
  template <class Triangles>
  double distance(std::size_t i, const Triangles& triangles, const Positions& points)
  {
    const Boundary_sample& s = samples_[i];
    const Vector_3 p = s.place(points);
    if (i < own_count_) {
      if (s.kind == Vertex_kind::SURFACE)
        return targets_.distance(i, p, faces_.sheet(s.face));
      return s.curve >= 0 ? (targets_.on_curve(s.curve, p).place - p).norm() : s.offset(points).norm();
    }
    const Vector_3& sample = s.target.place;
    if (s.kind != Vertex_kind::SURFACE) {
      const Vector_3 &a = points[s.vertices[0]], edge = points[s.vertices[1]] - a;
      const double t = edge.dot(sample - a) / (std::max)(edge.squaredNorm(), (std::numeric_limits<double>::min)());
      return (a + std::clamp(t, 0.0, 1.0) * edge - sample).norm();
    }
    if (s.target.projector.isZero()) // beyond a rim
      return 0;
    double nearest = std::numeric_limits<double>::infinity(); // its square
    for (const Triangle_indices& t : triangles) {
      const Vector_3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      const std::array<double, 3> w = closest_point_of_triangle(sample, a, b, c);
      nearest = (std::min)(nearest, (w[0] * a + w[1] * b + w[2] * c - sample).squaredNorm());
    }
    return std::sqrt(nearest);
  }

  // A search takes some microseconds, one along a curve more.
  static constexpr std::size_t searches_of_range = 256, curve_searches_of_range = 64;

  static bool may_move(const Surface_faces& faces, const Boundary_attachment& attachment)
  {
    return std::any_of(faces.vertices.begin(), faces.vertices.end(), [&](const Surface_faces::Vertex& v) {
      return attachment.kind[v.vertex] != Vertex_kind::FIXED;
    });
  }

  // Of the edges of the faces around each vertex.
  static std::vector<double> mean_lengths(const Hexahedral_complex& complex, const Surface_faces& faces,
                                          const std::vector<double>& lengths)
  {
    std::vector<double> sum(complex.number_of_vertices(), 0.0), count(complex.number_of_vertices(), 0.0);
    for (const Surface_faces::Edge& e : faces.edges)
      for (int v : complex.edges[e.edge]) {
        sum[v] += lengths[e.edge];
        ++count[v];
      }
    for (std::size_t v = 0; v < sum.size(); ++v)
      sum[v] /= (std::max)(count[v], 1.0);
    return sum;
  }

  // Of the solid behind each face, as far as it is less than the edges around.
  std::vector<double> thicknesses(const Hexahedral_complex& complex, const std::vector<double>& lengths) const
  {
    const Solid_thickness thickness(complex, lengths);
    std::vector<double> result;
    for (std::size_t f = 0; f < faces_.quads.size(); ++f) {
      double edge = 0;
      for (int v : faces_.quads[f])
        edge = (std::max)(edge, edge_[v]);
      result.push_back(thickness.at(complex.boundary_faces[f], edge));
    }
    return result;
  }

  double local_edge(const Boundary_sample& s) const
  {
    double edge = 0;
    for (int k = 0; k < s.count; ++k)
      edge += edge_[s.vertices[k]] / s.count;
    return edge;
  }

  double scale_on_surface(int face, double edge) const { return (std::min)(edge, thickness_[face]); }

  double square_of_edge(const Boundary_sample& s) const { return local_edge(s) * local_edge(s); }

  // Gives a sample its scale, and the weight that follows from that and from the area that it stands for.
  void weigh(Boundary_sample& s, double area) const
  {
    // along the surface, features may be farther off than the solid is thick
    s.scale = s.kind == Vertex_kind::SURFACE ? scale_on_surface(s.face, local_edge(s)) : local_edge(s);
    s.weight *= area * s.scale;
    if (s.kind != Vertex_kind::SURFACE)
      s.weight *= parameters_.feature_weight;
  }

  void add(const Boundary_sample& sample)
  {
    samples_.push_back(sample);
    weigh(samples_.back(), square_of_edge(sample));
  }

  // Those of the mesh. Returns how many.
  std::size_t add_samples(const Hexahedral_complex& complex)
  {
    int last = -1;
    for (const Surface_faces::Vertex& v : faces_.vertices) {
      const Vertex_kind kind = attachment_.kind[v.vertex];
      if (kind != Vertex_kind::FIXED && (kind == Vertex_kind::SURFACE || v.vertex != last)) // features: once
        add({{v.vertex}, {1.0}, 1, v.face, 1.0, kind, attachment_.curve[v.vertex]});
      last = v.vertex;
    }
    for (std::size_t f = 0; f < faces_.quads.size(); ++f)
      add(on_face(f, .5, .5, 1.0));
    add_further_samples();
    int last_edge = -1;
    for (const Surface_faces::Edge& e : faces_.edges) {
      const std::array<int, 2>& ends = complex.edges[e.edge];
      const int curve = attachment_.curve_of_edge[e.edge];
      if (curve >= 0 && e.edge == last_edge)
        continue;
      last_edge = e.edge;
      const Vertex_kind kind = curve >= 0 ? Vertex_kind::FEATURE : Vertex_kind::SURFACE;
      add({{ends[0], ends[1]}, {.5, .5}, 2, e.face, parameters_.edge_weight, kind, curve});
      for (int k = 1; faces_.is_interface(e.face) && k < parameters_.parts; ++k)
        if (2 * k != parameters_.parts) {
          const double u = double(k) / parameters_.parts;
          add({{ends[0], ends[1]}, {1 - u, u}, 2, e.face, parameters_.further_weight, kind, curve});
        }
    }
    return samples_.size();
  }

  void add_further_samples()
  {
    const int n = parameters_.parts;
    for (std::size_t f = 0; f < faces_.quads.size(); ++f)
      for (int i = 1; i < n && faces_.is_interface(static_cast<int>(f)); ++i)
        for (int j = 1; j < n; ++j)
          if (2 * i != n || 2 * j != n)
            add(on_face(f, double(i) / n, double(j) / n, parameters_.further_weight));
  }

  // On the triangle of a face that it is in: the reference is split in the same way where it is the boundary that came
  // in, so that this lies on it, even where faces are warped.
  Boundary_sample on_face(std::size_t f, double u, double v, double weight) const
  {
    const std::array<double, 4> shares = u > v ? std::array<double, 4>{1 - u, u - v, v, 0}
                                               : std::array<double, 4>{1 - v, 0, u, v - u};
    return {faces_.quads[f], shares, 4, static_cast<int>(f), weight, Vertex_kind::SURFACE, -1};
  }

  // Of the two that each face is split into.
  Boundary_sample in_triangle(std::size_t triangle, const std::array<double, 3>& coordinates, double weight) const
  {
    const std::array<double, 4> shares = triangle % 2 == 0
                                           ? std::array<double, 4>{coordinates[0], coordinates[1], coordinates[2], 0}
                                           : std::array<double, 4>{coordinates[0], 0, coordinates[1], coordinates[2]};
    const std::size_t f = triangle / 2;
    return {faces_.quads[f], shares, 4, static_cast<int>(f), weight, Vertex_kind::SURFACE, -1};
  }

  void aim(std::size_t i, const Vector_3& p)
  {
    Boundary_sample& s = samples_[i];
    if (s.kind == Vertex_kind::CORNER)
      s.target = Target::at(attachment_.corner[s.vertices[0]]);
    else if (s.kind == Vertex_kind::FEATURE)
      s.target = targets_.on_curve(s.curve, p);
    else
      s.target = targets_.on_surface(i, p, faces_.sheet(s.face));
  }

  // A sample of the reference pulls the point of the faces that it is linked to.
  void follow(const Reference_links::Link& link, Boundary_sample& s) const
  {
    s = {{link.vertices[0], link.vertices[1], link.vertices[2], -1},
         {link.weights[0], link.weights[1], link.weights[2], 0},
         3,
         static_cast<int>(link.triangle / 2),
         parameters_.pull_weight,
         Vertex_kind::SURFACE,
         -1};
    weigh(s, link.area);
    s.target = Target::in_direction(link.sample, link.direction);
  }

  // A sample of a feature curve pulls the point of an edge that it is linked to.
  void follow(const Curve_links::Link& link, const Positions& points, Boundary_sample& s) const
  {
    s = {{link.vertices[0], link.vertices[1]},
         {link.shares[0], link.shares[1]},
         2,
         link.face,
         parameters_.curve_pull_weight,
         Vertex_kind::FEATURE,
         -1};
    weigh(s, square_of_edge(s));
    s.target = Target::on_plane(link.sample, s.place(points), Vector_3::UnitX());
  }

  // The faces with a fixed vertex that is farther from their sheet than tolerated.
  void find_held_away(const Positions& points)
  {
    is_held_away_.assign(faces_.quads.size(), false);
    std::vector<std::array<int, 2>> away; // vertices, sheets
    for (const Surface_faces::Vertex& v : faces_.vertices)
      if (attachment_.kind[v.vertex] == Vertex_kind::FIXED) {
        const Vector_3& p = points[v.vertex];
        const int sheet = faces_.sheet(v.face);
        const Surface_point foot = surface_.closest_point(p, Surface_point::no_triangle, sheet);
        if (surface_.way(p, foot).norm() > tolerated(v.face, scale_on_surface(v.face, edge_[v.vertex])))
          away.push_back({v.vertex, sheet});
      }
    std::sort(away.begin(), away.end());
    for (std::size_t f = 0; f < faces_.quads.size() && !away.empty(); ++f)
      for (int v : faces_.quads[f])
        if (std::binary_search(away.begin(), away.end(), std::array<int, 2>{v, faces_.sheet(static_cast<int>(f))}))
          is_held_away_[f] = true;
  }

  // What cannot come near does not ruin hexahedra on the way.
  void ease_held_away()
  {
    if (std::find(is_held_away_.begin(), is_held_away_.end(), true) == is_held_away_.end())
      return;
    for (Boundary_sample& s : samples_)
      if (is_held_away_[s.face])
        s.emphasis = parameters_.emphasis_of_held_away * (is_bounded() ? s.emphasis : 1);
  }

  bool is_bounded(int face) const { return std::isfinite(maximum_deviation_) || faces_.is_interface(face); }

  // What the distance of a sample on a face is to keep to, with the scale; infinite where it is not bounded.
  double bound_of(int face, double scale) const
  {
    return parameters_.kept_part * (faces_.is_interface(face)
                                      ? (std::min)(maximum_deviation_, parameters_.interface_deviation * scale)
                                      : maximum_deviation_);
  }

  double tolerated(int face, double scale) const
  {
    return is_bounded(face) ? bound_of(face, scale) : tolerance_ * scale;
  }
  double tolerated(const Boundary_sample& s) const { return tolerated(s.face, s.scale); }

  void bound(const Positions& points, double tightness)
  {
    const double loosening = std::pow(tightness, -parameters_.loosening);
    const double close = has_reference_of_its_own() ? parameters_.close_distance_of_own : parameters_.close_distance;
    holds_.resize(samples_.size(), 1.0);
    for_each(samples_.size(), [&](std::size_t i) {
      Boundary_sample& s = samples_[i];
      const double bound = bound_of(s.face, s.scale);
      s.bound = bound * loosening;
      s.wall = parameters_.wall * (std::max)(s.bound, s.offset(points).norm());
      s.hold = holds_[i];
      s.emphasis = is_bounded_everywhere() ? std::sqrt((std::max)(1.0, close * s.scale / bound))
                                           : parameters_.emphasis_of_interfaces;
    });
  }

  const Boundary_sample_parameters parameters_;
  const double maximum_deviation_;
  const double tolerance_; // without a bound, in units of the scale
  const Surface_faces& faces_;
  const Reference_surface& surface_;
  const bool has_interface_;
  const Boundary_attachment& attachment_;
  const bool is_held_;
  const std::vector<double> edge_;      // local length, of each vertex of the faces
  const std::vector<double> thickness_; // of each face
  std::vector<Boundary_sample> samples_;
  std::vector<double> holds_;  // of the samples: parts of the weights of their walls
  std::size_t own_count_;      // of those of the mesh
  std::size_t link_count_ = 0; // of those of the reference
  Reference_targets targets_;  // of those of the mesh
  Reference_links reference_links_;
  const Curve_links curve_links_;
  Grouped_array of_face_;
  std::vector<char> is_held_away_; // of the faces
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENERGY_BOUNDARY_SAMPLES_H
