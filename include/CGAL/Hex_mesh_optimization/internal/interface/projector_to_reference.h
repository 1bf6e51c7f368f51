// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PROJECTOR_TO_REFERENCE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PROJECTOR_TO_REFERENCE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// A reference that is known by its closest points and normals alone: samples of the boundary of the mesh, brought to it, are
// the vertices of a triangle surface, and where its normals turn sharply that has feature edges.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

template <class T, class Point, class = void>
struct Is_projector : std::false_type
{};
template <class T, class Point>
struct Is_projector<T, Point,
                    std::void_t<decltype(std::declval<const T&>().closest_point(std::declval<const Point&>()).x()),
                                decltype(std::declval<const T&>().normal(std::declval<const Point&>()).x())>>
  : std::true_type
{};

struct Projector_parameters
{
  // Into how many parts an edge of the boundary is divided: triangles deviate from a smooth surface by a sixteenth of what
  // faces do.
  int parts = 4;
  // A vertex on a feature comes to the planes of the triangles around it, one after the other, in so many sweeps, with
  // planes that are found so often again, that close to it on the way to the middle of a triangle.
  int sweeps = 60;
  int rounds = 3;
  double closeness = .1;
};

template <class Point, class Projector>
class Sampled_projector
{
public:
  Sampled_projector(const Projector& projector, const Projector_parameters& parameters)
    : projector_(projector)
    , parameters_(parameters)
  {}

  // angle_bound: in degrees.
  Reference_input run(const Positions& points, const std::vector<Hexahedron>& hexahedra, double angle_bound)
  {
    sample(points, hexahedra);
    const double least_cosine = std::cos(angle_bound * std::acos(-1.) / 180);
    std::map<std::array<int, 2>, int> triangle_at;
    std::vector<Vector_3> normals;
    for (const Triangle_indices& t : result_.triangles)
      normals.push_back(normal(closest_point(middle(t, result_.points))));
    std::set<int> on_features;
    for (std::size_t t = 0; t < result_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const int a = result_.triangles[t][k], b = result_.triangles[t][(k + 1) % 3];
        const auto [other, is_new] = triangle_at.try_emplace({(std::min)(a, b), (std::max)(a, b)}, static_cast<int>(t));
        if (!is_new && normals[t].dot(normals[other->second]) < least_cosine) {
          result_.sharp.push_back(other->first);
          on_features.insert({a, b});
        }
      }
    result_.sharp_is_given = true;
    snap(on_features);
    return std::move(result_);
  }

private:
  // The boundary, each face in parts², each sample where the projector brings it. What is no hexahedron is refused
  // elsewhere.
  void sample(const Positions& points, const std::vector<Hexahedron>& hexahedra)
  {
    std::vector<Hexahedron> sound;
    for (const Hexahedron& h : hexahedra)
      if (std::set<int>(h.begin(), h.end()).size() == 8 &&
          std::all_of(h.begin(), h.end(), [&](int v) { return v >= 0 && std::size_t(v) < points.size(); }))
        sound.push_back(h);
    const Face_neighbors neighbors(sound);
    const int n = parameters_.parts;
    for (int side = 0; side < neighbors.number_of_sides(); ++side) {
      if (neighbors.opposite(side) != Face_neighbors::ALONE)
        continue;
      const std::array<int, 4> face = neighbors.vertices(side);
      std::vector<int> samples((n + 1) * (n + 1));
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          samples[i * (n + 1) + j] = sample_of(points, face, i, j);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const int a = samples[i * (n + 1) + j], b = samples[(i + 1) * (n + 1) + j],
                    c = samples[(i + 1) * (n + 1) + j + 1], d = samples[i * (n + 1) + j + 1];
          result_.triangles.push_back({{a, b, c}});
          result_.triangles.push_back({{a, c, d}});
        }
    }
  }

  // i along the first edge of the face, j along the last. Faces share the samples on their edges.
  int sample_of(const Positions& points, const std::array<int, 4>& face, int i, int j)
  {
    const int n = parameters_.parts;
    std::array<std::pair<int, int>, 4> weights = {
      {{face[0], (n - i) * (n - j)}, {face[1], i * (n - j)}, {face[2], i * j}, {face[3], (n - i) * j}}};
    std::sort(weights.begin(), weights.end()); // the same for both faces of an edge
    std::vector<std::pair<int, int>> key;
    Vector_3 p = Vector_3::Zero();
    for (const auto& [v, weight] : weights)
      if (weight > 0) {
        key.push_back({v, weight});
        p += double(weight) / (n * n) * points[v];
      }
    const auto [at, is_new] = sample_at_.try_emplace(std::move(key), static_cast<int>(result_.points.size()));
    if (is_new)
      result_.points.push_back(closest_point(p));
    return at->second;
  }

  void snap(const std::set<int>& vertices)
  {
    std::map<int, std::vector<int>> triangles;
    for (std::size_t t = 0; t < result_.triangles.size(); ++t)
      for (int v : result_.triangles[t])
        if (vertices.count(v) > 0)
          triangles[v].push_back(static_cast<int>(t));
    const Positions before = result_.points;
    for (const auto& [v, around] : triangles) {
      std::vector<Vector_3> middles;
      for (int t : around)
        middles.push_back(middle(result_.triangles[t], before));
      snap(result_.points[v], middles);
    }
  }

  // The point to where the tangent planes beside it meet.
  void snap(Vector_3& p, const std::vector<Vector_3>& middles) const
  {
    for (int round = 0; round < parameters_.rounds; ++round) {
      std::vector<std::pair<Vector_3, Vector_3>> planes;
      const double part = round == 0 ? 1 : parameters_.closeness;
      for (const Vector_3& m : middles) {
        const Vector_3 q = closest_point(p + part * (m - p));
        planes.emplace_back(q, normal(q));
      }
      for (int sweep = 0; sweep < parameters_.sweeps; ++sweep)
        for (const auto& [q, n] : planes)
          p -= n.dot(p - q) * n;
    }
  }

  static Vector_3 middle(const Triangle_indices& t, const Positions& points)
  {
    return (points[t[0]] + points[t[1]] + points[t[2]]) / 3;
  }

  template <class Coordinates>
  static Vector_3 vector(const Coordinates& v)
  {
    return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
  }

  Vector_3 closest_point(const Vector_3& p) const { return vector(projector_.closest_point(Point(p[0], p[1], p[2]))); }
  Vector_3 normal(const Vector_3& p) const { return vector(projector_.normal(Point(p[0], p[1], p[2]))).normalized(); }

  const Projector& projector_;
  const Projector_parameters& parameters_;
  Reference_input result_;
  std::map<std::vector<std::pair<int, int>>, int> sample_at_;
};

// Point: what the projector takes.
template <class Point, class Projector>
Reference_input projector_to_reference(const Projector& projector, const Positions& points,
                                       const std::vector<Hexahedron>& hexahedra, double angle_bound)
{
  return Sampled_projector<Point, Projector>(projector, Projector_parameters()).run(points, hexahedra, angle_bound);
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_INTERFACE_PROJECTOR_TO_REFERENCE_H
