// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H

// Which part of the reference each boundary vertex belongs to: a corner, a
// feature curve or the smooth surface (the sets C, F, S of eq. 21).

#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_curve.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Feature_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Hex_mesh_optimization {
namespace internal {

enum class Vertex_kind : char { INTERIOR, SURFACE, FEATURE, CORNER, FIXED };

struct Boundary_attachment
{
  std::vector<Vertex_kind> kind;
  std::vector<int> curve;  // of a FEATURE vertex
  Positions corner;        // the place of a CORNER vertex
  std::vector<int> curve_of_edge; // the curve that an edge of the boundary represents, or -1

  explicit Boundary_attachment(const Hexahedral_complex& complex)
    : kind(complex.number_of_vertices(), Vertex_kind::INTERIOR)
    , curve(complex.number_of_vertices(), -1)
    , corner(complex.number_of_vertices(), Vector_3::Zero())
    , curve_of_edge(complex.edges.size(), -1)
  {
    for (std::size_t v = 0; v < kind.size(); ++v)
      if (!complex.is_used[v])
        kind[v] = Vertex_kind::FIXED;
      else if (complex.is_on_boundary[v])
        kind[v] = Vertex_kind::SURFACE;
  }

  void to_corner(int v, const Vector_3& place)
  {
    kind[v] = Vertex_kind::CORNER;
    corner[v] = place;
  }

  // The vertices, one boundary edge apart, represent a curve; corners among them stay corners.
  void to_curve(const Hexahedral_complex& complex, const std::vector<int>& vertices, int c)
  {
    for (int v : vertices)
      if (kind[v] == Vertex_kind::SURFACE) {
        kind[v] = Vertex_kind::FEATURE;
        curve[v] = c;
      }
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      curve_of_edge[complex.find_edge(vertices[i], vertices[i + 1]) / 2] = c;
  }
};

inline Vector_3 face_area_vector(const Hexahedral_complex& complex, const Positions& points, int face)
{
  const std::array<int, 4>& q = complex.boundary_faces[face].vertices;
  return (points[q[2]] - points[q[0]]).cross(points[q[3]] - points[q[1]]);
}

// The edges of the boundary whose two faces deviate from flat by more than the bound.
inline Edge_list sharp_boundary_edges(const Hexahedral_complex& complex, const Positions& points, double angle_bound)
{
  const double bound = std::cos(angle_bound * CGAL_PI / 180);
  Edge_list sharp;
  for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
    const Vector_3 left = face_area_vector(complex, points, e.left), right = face_area_vector(complex, points, e.right);
    if (left.dot(right) < bound * left.norm() * right.norm())
      sharp.push_back(complex.edges[e.edge]);
  }
  return sharp;
}

// The boundary of the mesh in triangles: 2f and 2f + 1 for face f. Its vertices keep the
// indices of the mesh; a quad is split from its first corner in the order of
// hexahedron_faces, the split most readers of boundary quads apply.
inline std::vector<Triangle_indices> boundary_triangles(const Hexahedral_complex& complex)
{
  std::vector<Triangle_indices> triangles;
  triangles.reserve(2 * complex.boundary_faces.size());
  for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces) {
    triangles.push_back({f.vertices[0], f.vertices[1], f.vertices[2]});
    triangles.push_back({f.vertices[0], f.vertices[2], f.vertices[3]});
  }
  return triangles;
}

// The boundary of the mesh as a reference of its own.
inline std::unique_ptr<Reference_surface> boundary_as_reference(const Hexahedral_complex& complex, const Positions& points,
                                                                const Feature_parameters& features)
{
  return std::make_unique<Reference_surface>(points, boundary_triangles(complex),
                                             sharp_boundary_edges(complex, points, features.angle_bound), false, features);
}

// Attachment when the reference is the boundary itself: by identity.
inline Boundary_attachment attach_to_own_boundary(const Hexahedral_complex& complex, const Reference_surface& surface)
{
  Boundary_attachment attachment(complex);
  for (int v : surface.corners)
    attachment.to_corner(v, surface.points[v]);
  for (std::size_t c = 0; c < surface.curves.size(); ++c)
    attachment.to_curve(complex, surface.curves[c]->vertices, static_cast<int>(c));
  return attachment;
}

// Attachment to a separate reference: every corner takes the nearest boundary
// vertex, every curve the shortest path of boundary edges that follows it.
class Attachment_by_matching
{
public:
  Attachment_by_matching(const Hexahedral_complex& complex, const Positions& points, const Reference_surface& surface)
    : attachment(complex)
    , complex_(complex)
    , points_(points)
    , surface_(surface)
  {
    std::vector<int> ends;
    for (const Hexahedral_complex::Boundary_edge& e : complex.boundary_edges) {
      ends.push_back(complex.edges[e.edge][0]);
      ends.push_back(complex.edges[e.edge][1]);
    }
    neighbors_ = Grouped_array(complex.number_of_vertices(), ends.size(), [&](std::size_t k) { return ends[k]; },
                               [&](std::size_t k) { return ends[k ^ 1]; });
    std::vector<int> vertex_of(surface.points.size(), -1);
    for (int corner : surface.corners) {
      const int v = nearest_free_vertex(surface.points[corner]);
      if (v < 0)
        continue;
      vertex_of[corner] = v;
      attachment.to_corner(v, surface.points[corner]);
    }
    for (std::size_t c = 0; c < surface.curves.size(); ++c)
      match(static_cast<int>(c), vertex_of);
  }

  Boundary_attachment attachment;

private:
  double mean_edge_around(int v) const
  {
    double sum = 0;
    for (int u : neighbors_[v])
      sum += (points_[u] - points_[v]).norm();
    return neighbors_[v].size() ? sum / neighbors_[v].size() : 0;
  }

  // Farther than its own edges a vertex does not represent a corner.
  int nearest_free_vertex(const Vector_3& place) const
  {
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (attachment.kind[v] == Vertex_kind::SURFACE && (points_[v] - place).squaredNorm() < nearest) {
        nearest = (points_[v] - place).squaredNorm();
        best = static_cast<int>(v);
      }
    return best >= 0 && std::sqrt(nearest) <= mean_edge_around(best) ? best : -1;
  }

  void match(int c, const std::vector<int>& vertex_of)
  {
    const Feature_curve& curve = *surface_.curves[c];
    // A closed curve is followed from a third of its length to the next.
    std::vector<int> stations;
    if (curve.is_closed()) {
      const std::size_t n = curve.vertices.size() - 1;
      for (std::size_t k = 0; k < 3; ++k)
        stations.push_back(nearest_free_vertex(surface_.points[curve.vertices[k * n / 3]]));
      stations.push_back(stations.front());
    }
    else
      stations = {vertex_of[curve.vertices.front()], vertex_of[curve.vertices.back()]};
    std::vector<int> path;
    double length = 0;
    for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
      if (stations[k] < 0 || stations[k + 1] < 0 || stations[k] == stations[k + 1])
        return;
      const std::vector<int> part = follow(curve, stations[k], stations[k + 1]);
      if (part.empty())
        return;
      for (std::size_t i = 0; i + 1 < part.size(); ++i)
        length += (points_[part[i + 1]] - points_[part[i]]).norm();
      path.insert(path.end(), part.begin() + (path.empty() ? 0 : 1), part.end());
    }
    // a path that takes another way round is no match
    if (length > 2 * curve.length || 2 * length < curve.length)
      return;
    attachment.to_curve(complex_, path, c);
  }

  // Dijkstra over boundary edges; leaving the curve by one edge length costs ten edges.
  std::vector<int> follow(const Feature_curve& curve, int from, int to) const
  {
    using Entry = std::pair<double, int>;
    std::vector<double> cost(points_.size(), std::numeric_limits<double>::infinity());
    std::vector<int> previous(points_.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    cost[from] = 0;
    queue.emplace(0.0, from);
    while (!queue.empty() && queue.top().second != to) {
      const Entry top = queue.top();
      queue.pop();
      const int v = top.second;
      if (top.first > cost[v])
        continue;
      for (int u : neighbors_[v]) {
        if (attachment.kind[u] != Vertex_kind::SURFACE && u != to)
          continue;
        const double h = (points_[u] - points_[v]).norm();
        if (h == 0)
          continue;
        const double off = (curve.closest_point((points_[u] + points_[v]) / 2).point - (points_[u] + points_[v]) / 2).norm() / h;
        if (off > 2)
          continue;
        const double next = top.first + h * (1 + 10 * off * off);
        if (next < cost[u]) {
          cost[u] = next;
          previous[u] = v;
          queue.emplace(next, u);
        }
      }
    }
    std::vector<int> path;
    if (!std::isfinite(cost[to]))
      return path;
    for (int v = to; v != -1; v = previous[v])
      path.push_back(v);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const Hexahedral_complex& complex_;
  const Positions& points_;
  const Reference_surface& surface_;
  Grouped_array neighbors_;
};

} } } // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_BOUNDARY_ATTACHMENT_H
