// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H

// The whole optimization on flat arrays: from positions, hexahedra and a
// reference, all checked, to better positions and a status.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/Edge_cone_rectification.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Memory_order.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/quality_statistics.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/maximization/Quality_maximization.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Run_control.h>
#include <CGAL/Hex_mesh_optimization/internal/energy/Boundary_energy.h>
#include <CGAL/Hex_mesh_optimization/internal/untangling/Untangling.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/connectivity_limits.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/rectification/harmonic_start.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

class Hex_mesh_optimizer
{
public:
  // Everything that can be wrong with the input is refused here, by Input_error.
  // reference: null when the boundary of the mesh is its own reference.
  Hex_mesh_optimizer(const Positions& points, const std::vector<Hexahedron>& hexahedra, const Reference_input* reference,
                     const std::vector<char>& is_frozen, const Optimization_parameters& parameters)
    : parameters_(parameters)
    , control_(parameters.maximum_running_time, parameters.on_iteration)
    , numbering_(checked(points, hexahedra))
    , order_(numbering_.order)
    , given_(order_.ordered(points))
    , complex_(points.size(), order_.ordered(numbering_.hexahedra))
    , is_frozen_(order_.ordered(is_frozen))
  {
    if (reference)
      check(*reference);
    normalize();
    build_reference(reference);
  }

  // Optimizes. positions() are then the best found, in the coordinates of the input.
  Status run()
  {
    Status status;
    status.orientation_reversed = numbering_.is_reversed;
    status.before = statistics(given_);
    Positions best = points_;
    const Edge_relations relations(complex_);
    const std::vector<double> lengths = target_lengths(relations);
    const double start = control_.seconds();
    if (parameters_.method != Method::MAXIMIZATION && !control_.check_time())
      rectify(best, relations, lengths, 2 * status.before.number_of_inverted > complex_.hexahedra.size());
    const double middle = control_.seconds();
    status.rectification_seconds = middle - start;
    if (parameters_.method != Method::RECTIFICATION && !control_.check_time()) {
      maximize_quality(best, lengths, relations);
      status.maximization_seconds = control_.seconds() - middle;
    }
    write_back(best);
    finish(status);
    return status;
  }

  Positions positions() const { return order_.as_given(result_); }

private:
  void rectify(Positions& points, const Edge_relations& relations, const std::vector<double>& lengths, bool starts_harmonic)
  {
    const std::size_t tolerated = parameters_.method == Method::FULL ? left_to_untangling() : 0;
    if (starts_harmonic)
      harmonic_start(complex_, *attachment_, points);
    rectify_from(points, relations, lengths, tolerated);
    if (starts_harmonic || control_.is_stopped())
      return;
    const Mesh_quality quality(complex_, points);
    if (tolerated > 0 ? quality.inverted > tolerated : quality.invalid > 0) {
      // what the given interior locks, another start may not
      Positions other = points_;
      harmonic_start(complex_, *attachment_, other);
      rectify_from(other, relations, lengths, tolerated);
      if (Mesh_quality(complex_, other).inverted < quality.inverted)
        points = std::move(other);
    }
  }

  void rectify_from(Positions& points, const Edge_relations& relations, const std::vector<double>& lengths, std::size_t tolerated)
  {
    // quality maximization takes over from any valid state
    const double target = parameters_.method == Method::FULL ? (std::min)(0.0, parameters_.target_quality) : parameters_.target_quality;
    Edge_cone_rectification(complex_, relations, *surface_, *attachment_, lengths, parameters_.rectification)
      .run(points, control_, target, tolerated);
  }

  std::size_t left_to_untangling() const
  {
    return static_cast<std::size_t>(parameters_.left_to_untangling * static_cast<double>(complex_.hexahedra.size()));
  }

  void maximize_quality(Positions& points, const std::vector<double>& lengths, const Edge_relations& relations)
  {
    Maximization_parameters maximization = parameters_.maximization;
    maximization.maximum_deviation = parameters_.maximum_deviation / unit_;
    Surface_attachment attachment(complex_, *surface_, *attachment_, lengths, reference_is_given_, maximization);
    std::vector<char> is_fixed(complex_.number_of_vertices());
    for (std::size_t v = 0; v < is_fixed.size(); ++v)
      is_fixed[v] = attachment_->kind[v] == Vertex_kind::FIXED;
    std::size_t inverted = Mesh_quality(complex_, points).inverted;
    if (inverted > 0) {
      const bool was_left = parameters_.method == Method::FULL && inverted <= left_to_untangling();
      Untangling untangling(complex_, attachment, lengths, is_fixed, maximization);
      untangling.run(points, control_);
      inverted = Mesh_quality(complex_, points).inverted;
      if (was_left && inverted > 0 && !control_.is_stopped()) {
        rectify_from(points, relations, lengths, 0);
        untangling.run(points, control_);
      }
    }
    const bool are_estimated = !parameters_.target_length && parameters_.target_edge_lengths == Target_edge_lengths::ESTIMATED;
    Quality_maximization(complex_, attachment, lengths, are_estimated ? &relations : nullptr, is_fixed, maximization)
      .run(points, control_, parameters_.target_quality);
  }

  static void check(const Positions& points, const std::vector<Hexahedron>& hexahedra)
  {
    using Element = Input_error::Element;
    if (hexahedra.empty())
      throw Input_error(Element::MESH, 0, "the mesh has no hexahedra");
    if (points.size() > std::size_t((std::numeric_limits<int>::max)()) / 8 ||
        hexahedra.size() > std::size_t((std::numeric_limits<int>::max)()) / 24)
      throw Input_error(Element::MESH, 0, "the mesh is larger than its indices can count");
    for (std::size_t v = 0; v < points.size(); ++v)
      if (!points[v].allFinite())
        throw Input_error(Element::VERTEX, v, "vertex " + std::to_string(v) + " has a coordinate that is not finite");
    for (std::size_t h = 0; h < hexahedra.size(); ++h)
      for (int i = 0; i < 8; ++i) {
        if (hexahedra[h][i] < 0 || std::size_t(hexahedra[h][i]) >= points.size())
          throw Input_error(Element::HEXAHEDRON, h, "hexahedron " + std::to_string(h) + " refers to a vertex that does not exist");
        for (int j = 0; j < i; ++j)
          if (hexahedra[h][i] == hexahedra[h][j])
            throw Input_error(Element::HEXAHEDRON, h, "hexahedron " + std::to_string(h) + " has vertex " +
                                                        std::to_string(hexahedra[h][i]) + " at two corners");
      }
  }

  // The hexahedra as given, but for their orientation, and their order in memory.
  struct Numbering
  {
    bool is_reversed;
    std::vector<Hexahedron> hexahedra;
    Memory_order order;
  };

  // Bottom and top are exchanged if the hexahedra are numbered inside out. All errors in the mesh are found here, while its
  // elements have the numbers that the caller knows.
  static Numbering checked(const Positions& points, const std::vector<Hexahedron>& hexahedra)
  {
    check(points, hexahedra);
    Hexahedral_complex complex(points.size(), hexahedra);
    if (complex.boundary_faces.empty())
      throw Input_error(Input_error::Element::MESH, 0, "the mesh has no boundary: every face belongs to two hexahedra");
    const bool is_reversed = enclosed_volume(points, complex) < 0;
    if (is_reversed)
      for (Hexahedron& h : complex.hexahedra)
        for (int i = 0; i < 4; ++i)
          std::swap(h[i], h[i + 4]);
    Memory_order order(complex); // which hexahedra a vertex has does not depend on their orientation
    return {is_reversed, std::move(complex.hexahedra), std::move(order)};
  }

  // As the caller finds it, sums in the same order.
  Quality_statistics statistics(const Positions& points) const { return quality_statistics(order_.as_given(points), numbering_.hexahedra); }

  // Six times the volume within the boundary, up to scale: a tangled interior, however far out, does not matter.
  static double enclosed_volume(const Positions& points, const Hexahedral_complex& complex)
  {
    const Vector_3 origin = points[complex.boundary_faces[0].vertices[0]];
    double extent = 0;
    for (const auto& f : complex.boundary_faces)
      for (int v : f.vertices)
        extent = (std::max)(extent, (points[v] - origin).cwiseAbs().maxCoeff());
    double volume = 0;
    for (const auto& f : complex.boundary_faces) {
      Vector_3 p[4];
      for (int i = 0; i < 4; ++i)
        p[i] = (points[f.vertices[i]] - origin) / extent;
      volume += p[0].dot(p[1].cross(p[2])) + p[0].dot(p[2].cross(p[3])) + p[1].dot(p[2].cross(p[3])) + p[0].dot(p[1].cross(p[3]));
    }
    return volume;
  }

  static void check(const Reference_input& reference)
  {
    using Element = Input_error::Element;
    for (std::size_t v = 0; v < reference.points.size(); ++v)
      if (!reference.points[v].allFinite())
        throw Input_error(Element::REFERENCE_VERTEX, v,
                          "vertex " + std::to_string(v) + " of the reference surface has a coordinate that is not finite");
    if (reference.triangles.empty())
      throw Input_error(Element::MESH, 0, "the reference surface is empty");
  }

  // The boundary terms have units of length², so that all weights presuppose a unit: the mean boundary edge.
  void normalize()
  {
    unit_ = mean_boundary_edge_length(complex_, given_);
    if (!(unit_ > 0) || !std::isfinite(unit_))
      throw Input_error(Input_error::Element::MESH, 0, "all vertices of the boundary lie in one point, or too far apart for their coordinates");
    center_ = Vector_3::Zero();
    std::size_t count = 0;
    for (std::size_t v = 0; v < given_.size(); ++v)
      if (complex_.is_on_boundary[v]) {
        center_ += given_[v] / unit_;
        ++count;
      }
    center_ = center_ / double(count) * unit_;
    points_.reserve(given_.size());
    for (const Vector_3& p : given_)
      points_.push_back((p - center_) / unit_);
  }

  // The reference is the surface given, or the boundary of the mesh itself.
  void build_reference(const Reference_input* reference)
  {
    reference_is_given_ = reference != nullptr;
    const Feature_parameters& features = parameters_.features;
    Positions normalized;
    if (reference)
      for (const Vector_3& p : reference->points)
        normalized.push_back((p - center_) / unit_);
    require_area(reference ? normalized : points_, reference ? reference->triangles : boundary_triangles(complex_));
    if (reference) {
      Edge_list sharp = reference->sharp_is_given ? reference->sharp : sharp_edges(normalized, reference->triangles, features.angle_bound);
      surface_ = std::make_unique<Reference_surface>(std::move(normalized), reference->triangles, std::move(sharp),
                                                     reference->sharp_is_given, features);
      attachment_ = std::make_unique<Boundary_attachment>(Attachment_by_matching(complex_, points_, *surface_).attachment);
    }
    else {
      surface_ = boundary_as_reference(complex_, points_, features);
      attachment_ = std::make_unique<Boundary_attachment>(attach_to_own_boundary(complex_, *surface_));
    }
    for (std::size_t v = 0; v < is_frozen_.size(); ++v)
      if (is_frozen_[v] || (parameters_.fixed_boundary && complex_.is_on_boundary[v]))
        attachment_->kind[v] = Vertex_kind::FIXED;
  }

  void require_area(const Positions& points, const std::vector<Triangle_indices>& triangles) const
  {
    if (std::none_of(triangles.begin(), triangles.end(), [&](const Triangle_indices& t) { return Triangle_surface::has_area(points, t); }))
      throw Input_error(Input_error::Element::MESH, 0,
                        reference_is_given_ ? "the reference surface has no face with an area that is not lost against the mesh"
                                            : "the boundary of the mesh has no face with an area");
  }

  std::vector<double> target_lengths(const Edge_relations& relations) const
  {
    if (parameters_.target_length) {
      // asked for in the order that edges have with the caller's vertices
      std::vector<std::pair<std::array<int, 2>, std::size_t>> given_edges;
      for (std::size_t e = 0; e < complex_.edges.size(); ++e) {
        const auto [low, high] = std::minmax({order_.given_vertex(complex_.edges[e][0]), order_.given_vertex(complex_.edges[e][1])});
        given_edges.push_back({{low, high}, e});
      }
      std::sort(given_edges.begin(), given_edges.end());
      std::vector<double> lengths(complex_.edges.size());
      for (std::size_t i = 0; i < given_edges.size(); ++i) {
        const auto& [vertices, e] = given_edges[i];
        const double given = parameters_.target_length(vertices[0], vertices[1]);
        if (!(given > 0) || !std::isfinite(given))
          throw Input_error(Input_error::Element::PARAMETER, i,
                            "the target length of the edge from vertex " + std::to_string(vertices[0]) + " to vertex " +
                              std::to_string(vertices[1]) + " is not positive and finite");
        lengths[e] = given / unit_;
      }
      return lengths;
    }
    if (parameters_.target_edge_lengths == Target_edge_lengths::INPUT) {
      std::vector<double> lengths = edge_lengths(complex_, points_);
      for (double& l : lengths)
        l = (std::max)(l, parameters_.rectification.least_length);
      return lengths;
    }
    return estimate_edge_lengths(complex_, relations, points_);
  }

  // Rounding on the way back must not undo validity: the final statistics are those of the coordinates handed out.
  void write_back(const Positions& best)
  {
    result_ = given_;
    for (std::size_t v = 0; v < best.size(); ++v)
      if (attachment_->kind[v] != Vertex_kind::FIXED && best[v] != points_[v])
        result_[v] = best[v] * unit_ + center_;
  }

  void finish(Status& status)
  {
    status.after = statistics(result_);
    status.deviation = measured_deviation(result_);
    status.deviation_bound = parameters_.maximum_deviation;
    if (is_worse(status.after, status.before) || leaves_bound(status)) {
      result_ = given_;
      status.after = status.before;
      status.deviation = measured_deviation(result_);
    }
    for (std::size_t h = 0; h < complex_.hexahedra.size(); ++h)
      if (hexahedron_validity(hexahedron_coordinates(result_, complex_.hexahedra[h])) != Validity::VALID) {
        status.invalid_hexahedra.push_back(order_.given_hexahedron(h));
        if (is_locked(complex_.hexahedra[h]))
          status.locked_hexahedra.push_back(order_.given_hexahedron(h));
      }
    for (Connectivity_limit limit : connectivity_limits(complex_, *attachment_))
      if (scaled_jacobian(hexahedron_coordinates(result_, complex_.hexahedra[limit.hexahedron])) <= limit.largest_scaled_jacobian) {
        limit.hexahedron = order_.given_hexahedron(limit.hexahedron);
        status.connectivity_limits.push_back(limit);
      }
    std::sort(status.invalid_hexahedra.begin(), status.invalid_hexahedra.end());
    std::sort(status.locked_hexahedra.begin(), status.locked_hexahedra.end());
    std::sort(status.connectivity_limits.begin(), status.connectivity_limits.end(),
              [](const Connectivity_limit& a, const Connectivity_limit& b) { return a.hexahedron < b.hexahedron; });
    status.iterations = control_.iterations;
    if (control_.is_stopped())
      status.return_code = control_.return_code();
    else if (result_ == given_)
      status.return_code = Return_code::NO_IMPROVEMENT;
    else if (status.valid_mesh() && status.after.minimum >= parameters_.target_quality)
      status.return_code = Return_code::TARGET_QUALITY_REACHED;
    else
      status.return_code = Return_code::CONVERGED;
    status.total_seconds = control_.seconds();
  }

  Deviation measured_deviation(const Positions& points) const
  {
    Positions normalized;
    normalized.reserve(points.size());
    for (const Vector_3& p : points)
      normalized.push_back((p - center_) / unit_);
    Deviation result = deviation(complex_, normalized, *surface_, parameters_.measuring_spacing);
    result.average *= unit_;
    result.maximum *= unit_;
    return result;
  }

  // Whether a bound that the input obeyed is exceeded without the gain of validity.
  bool leaves_bound(const Status& status) const
  {
    return !status.is_within_deviation_bound() && status.before.number_of_invalid <= status.after.number_of_invalid &&
           measured_deviation(given_).maximum <= parameters_.maximum_deviation;
  }

  // Whether a corner is inverted whose vertices are all fixed.
  bool is_locked(const Hexahedron& h) const
  {
    const auto is_fixed = [&](int i) { return attachment_->kind[h[i]] == Vertex_kind::FIXED; };
    for (int c = 0; c < 8; ++c) {
      const int(&next)[3] = corner_neighbors[c];
      const auto edge = [&](int k) { return Vector_3(result_[h[next[k]]] - result_[h[c]]); };
      if (is_fixed(c) && is_fixed(next[0]) && is_fixed(next[1]) && is_fixed(next[2]) && edge(0).dot(edge(1).cross(edge(2))) <= 0)
        return true;
    }
    return false;
  }

  static bool is_worse(const Quality_statistics& now, const Quality_statistics& before)
  {
    if (now.number_of_inverted != before.number_of_inverted)
      return now.number_of_inverted > before.number_of_inverted;
    if (now.number_of_invalid != before.number_of_invalid)
      return now.number_of_invalid > before.number_of_invalid;
    return now.number_of_invalid == 0 && now.minimum < before.minimum;
  }

  const Optimization_parameters parameters_;
  Run_control control_;
  const Numbering numbering_;
  const Memory_order& order_; // in which all that follows is
  const Positions given_;
  const Hexahedral_complex complex_;
  const std::vector<char> is_frozen_;
  double unit_ = 1;
  bool reference_is_given_ = false; // not the boundary of the mesh itself
  Vector_3 center_ = Vector_3::Zero();
  Positions points_; // given_ in units of the mean boundary edge
  std::unique_ptr<Reference_surface> surface_;
  std::unique_ptr<Boundary_attachment> attachment_;
  Positions result_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_HEX_MESH_OPTIMIZER_H
