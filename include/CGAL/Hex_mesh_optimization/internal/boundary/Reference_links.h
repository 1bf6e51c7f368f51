// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_LINKS_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_LINKS_H

#include <CGAL/license/Hex_mesh_optimization.h>

// For samples of the reference the nearest points of surface faces of the mesh,
// asked for again and again. Points on the mesh cannot see that the tip of a
// protrusion was cut off; the tip can.

#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Nearby_triangles.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Smooth_normals.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Target.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/crest_samples.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/surface_samples.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Reference_links
{
public:
  // A sample of the reference with the point of the faces nearest to it:
  // Σ weight_k · vertex_k of one triangle.
  struct Link
  {
    Triangle_indices vertices;
    std::array<double, 3> weights;
    Vector_3 sample;
    double area; // of the reference that the sample stands for
    double distance;
    std::size_t triangle; // of the faces, two each
    bool is_new;          // by the last update
    Vector_3 direction;   // unit vector between the two, or a normal where they coincide; zero beyond a rim
  };

  // faces: with the same sheets as the surface. spacing: of the samples. crest_spacing, crest_width: of those on sharp
  // edges, of which there are none without a width.
  Reference_links(const Surface_faces& faces, const Triangle_surface& surface, double spacing, double crest_spacing = 1,
                  double crest_width = 0)
    : triangles_(split_quads(faces.quads))
    , sheets_(triangle_sheets(faces))
    , rims_(triangle_rims(faces))
    , samples_(spread_samples(surface, faces.quads.size(), spacing))
  {
    // vertices stand for a third of the triangles around them, in addition to the samples within: tips must not be
    // missed
    std::vector<double> around(surface.points.size(), 0.0);
    const std::vector<std::size_t> order = triangles_by_sheets(surface);
    for (std::size_t begin = 0, end, s = 0; begin < order.size(); begin = end) {
      const int sheet = surface.sheet(order[begin]);
      for (end = begin; end < order.size() && surface.sheet(order[end]) == sheet; ++end) {
        const Triangle_indices& t = surface.triangles[order[end]];
        const Vector_3& a = surface.points[t[0]];
        const double area = (surface.points[t[1]] - a).cross(surface.points[t[2]] - a).norm() / 2;
        for (int v : t)
          around[v] += area / 3;
      }
      for (; s < samples_.size() && samples_[s].sheet == sheet; ++s)
        if (samples_[s].vertex >= 0)
          samples_[s].area = around[samples_[s].vertex];
      for (std::size_t i = begin; i < end; ++i)
        for (int v : surface.triangles[order[i]])
          around[v] = 0;
    }
    if (crest_width > 0) {
      const std::vector<Surface_sample> crests = crest_samples(surface, faces.quads.size(), crest_spacing, crest_width);
      samples_.insert(samples_.end(), crests.begin(), crests.end());
    }
  }

  // One link for every sample, in the order in which they came. A link whose vertices have moved by less than `still` since it
  // was found stays as it is.
  const std::vector<Link>& update(const Positions& points, double still)
  {
    const bool is_first = links_.empty();
    const std::size_t linked = links_.size();
    links_.resize(samples_.size());
    found_at_.resize(samples_.size());
    if (is_first || !is_known(points)) {
      known_ = std::make_unique<Triangle_surface>(points, triangles_, sheets_, rims_);
      nearby_.reset(samples_.size());
      fast_ = nullptr;
      moved_ = 0;
      if (known_->is_empty()) {
        links_.clear();
        return links_;
      }
    }
    const std::unique_ptr<const Smooth_normals> normals = is_first ? std::make_unique<const Smooth_normals>(*known_)
                                                                   : nullptr;
    for_each(
      samples_.size(),
      [&](std::size_t i) {
        if (!is_first && i >= linked) // the search starts from a triangle
          links_[i].triangle =
            known_->closest_point(samples_[i].point, Surface_point::no_triangle, samples_[i].sheet).triangle;
        links_[i].is_new = i >= linked || has_moved(links_[i], found_at_[i], points, still);
        if (links_[i].is_new)
          find_link(i, points, normals.get());
      },
      searches_of_range);
    return links_;
  }

  // Further samples, whose links come after the others.
  void add(const std::vector<Surface_sample>& samples)
  {
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    if (known_)
      nearby_.add(samples.size());
  }

private:
  // To search fast triangles each time takes longer than new lists, where they are more than this part.
  static constexpr double most_fast_triangles = .25;
  // A search takes some microseconds.
  static constexpr std::size_t searches_of_range = 256;

  static bool has_moved(const Link& link, const std::array<Vector_3, 3>& before, const Positions& points, double still)
  {
    for (int k = 0; k < 3; ++k)
      if ((points[link.vertices[k]] - before[k]).squaredNorm() >= still * still)
        return true;
    return false;
  }

  // normals: of the faces at the first time, when many samples may lie on it; null later
  void find_link(std::size_t i, const Positions& points, const Smooth_normals* normals)
  {
    const Vector_3& sample = samples_[i].point;
    const Surface_point foot = normals ? known_->closest_point(sample, Surface_point::no_triangle, samples_[i].sheet)
                                       : closest(i, points);
    const Triangle_indices& t = known_->triangles[foot.triangle];
    const bool is_beyond = known_->rims.triangle_at(foot) != Rims::none;
    const double distance = is_beyond ? 0 : (foot.point - sample).norm();
    Link& link = links_[i];
    link = {t, foot.coordinates, sample, samples_[i].area, distance, foot.triangle, true, Vector_3::Zero()};
    if (is_beyond)
      link.direction = Vector_3::Zero();
    else if (distance > Target::coincidence)
      link.direction = (foot.point - sample) / distance;
    else if (normals)
      link.direction = normals->at(foot.triangle, foot.coordinates);
    else
      link.direction = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).normalized();
    for (int k = 0; k < 3; ++k)
      found_at_[i][k] = points[link.vertices[k]];
  }

  // Whether most triangles are where known_ has them. Those that are not become fast_.
  bool is_known(const Positions& points)
  {
    std::vector<char> is_fast(points.size());
    for_each(points.size(), [&](std::size_t v) {
      is_fast[v] = (points[v] - known_->points[v]).squaredNorm() > Nearby_triangles::margin * Nearby_triangles::margin;
    });
    fast_triangles_.clear();
    std::vector<Triangle_indices> triangles;
    std::vector<int> sheets;
    for (std::size_t t = 0; t < known_->triangles.size(); ++t) {
      const Triangle_indices& vertices = known_->triangles[t];
      if (is_fast[vertices[0]] || is_fast[vertices[1]] || is_fast[vertices[2]]) {
        fast_triangles_.push_back(t);
        triangles.push_back(vertices);
        sheets.push_back(known_->sheet(t));
      }
    }
    moved_ = Nearby_triangles::margin;
    if (double(triangles.size()) > most_fast_triangles * double(known_->triangles.size()))
      return false;
    fast_ = triangles.empty() ? nullptr
                              : std::make_unique<Triangle_surface>(points, std::move(triangles), std::move(sheets));
    return true;
  }

  // The point of the faces closest to sample i: one of the triangles near where it was, or a fast one.
  Surface_point closest(std::size_t i, const Positions& points)
  {
    const Vector_3& sample = samples_[i].point;
    std::optional<Surface_point> foot = nearby_.closest(i, sample, links_[i].triangle, points, *known_, moved_);
    if (!foot) {
      foot = closest_point_of_triangle(sample, links_[i].triangle, points, known_->triangles);
      const auto compare = [&](std::size_t triangle) {
        const Surface_point candidate = closest_point_of_triangle(sample, triangle, points, known_->triangles);
        if ((candidate.point - sample).squaredNorm() < (foot->point - sample).squaredNorm())
          foot = candidate;
      };
      known_->for_triangles_near(sample, (foot->point - sample).norm() + moved_, compare, samples_[i].sheet);
    }
    if (fast_)
      if (std::optional<Surface_point> closer = fast_->closer_point(sample, foot->point, samples_[i].sheet)) {
        closer->triangle = fast_triangles_[closer->triangle];
        return *closer;
      }
    return *foot;
  }

  const std::vector<Triangle_indices> triangles_; // of the faces
  const std::vector<int> sheets_;                 // of the triangles, or none
  const Rims rims_;                               // of the faces
  std::vector<Surface_sample> samples_;
  std::vector<Link> links_;
  std::vector<std::array<Vector_3, 3>> found_at_; // the vertices of each link
  std::unique_ptr<Triangle_surface> known_;       // the faces as they were when nearby_ was reset
  Nearby_triangles nearby_;                       // to each sample
  double moved_ = 0;                              // by how much the others may have since then
  std::vector<std::size_t> fast_triangles_;       // those that have moved too far since then
  std::unique_ptr<Triangle_surface> fast_;        // they, where they are now
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_REFERENCE_LINKS_H
