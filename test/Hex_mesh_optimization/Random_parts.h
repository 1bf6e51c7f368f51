// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_PARTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_PARTS_H

// Random closed parts that overlap, touch or coincide, as people write them, and what their union is, by corefinement.

#include "Generated_surface.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace test {

// The same with every standard library.
class Random_number
{
public:
  explicit Random_number(unsigned seed) : engine_(seed) {}

  int integer(int low, int high) // both included
  {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  double unit() { return double(engine_()) / double(std::mt19937::max()); }
  Vector_3 vector() { return {unit(), unit(), unit()}; }
  Matrix_3 rotation()
  {
    return Eigen::AngleAxisd(6 * unit(), (vector() - Vector_3::Constant(.5)).normalized()).toRotationMatrix();
  }

private:
  std::mt19937 engine_;
};

inline void append(Reference_input& soup, const Reference_input& part)
{
  const int n = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), part.points.begin(), part.points.end());
  for (const Triangle_indices& t : part.triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
}

inline Reference_input box_surface(const Vector_3& low, const Vector_3& high)
{
  Reference_input result = surface_of(block(1));
  for (Vector_3& p : result.points)
    p = p.cwiseProduct(high - low) + low;
  return result;
}

inline Reference_input cone_surface(int n)
{
  Reference_input result;
  for (int i = 0; i < n; ++i)
    result.points.emplace_back(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), 0);
  result.points.emplace_back(0, 0, 0);
  result.points.emplace_back(0, 0, 2);
  for (int i = 0; i < n; ++i) {
    result.triangles.push_back({i, (i + 1) % n, n + 1});
    result.triangles.push_back({(i + 1) % n, i, n});
  }
  return result;
}

inline Reference_input torus_surface(int n, int m, double thickness)
{
  Reference_input result;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * CGAL_PI * i / n, v = 2 * CGAL_PI * j / m, r = 1 + thickness * std::cos(v);
      result.points.emplace_back(r * std::cos(u), r * std::sin(u), thickness * std::sin(v));
      const int a = i * m + j, b = (i + 1) % n * m + j, c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
      result.triangles.push_back({a, b, c});
      result.triangles.push_back({a, c, d});
    }
  return result;
}

inline Reference_input random_part(Random_number& random)
{
  const int kind = random.integer(0, 3);
  Reference_input result = kind == 0   ? box_surface({-.7, -.7, -.7}, {.7, .7, .7})
                           : kind == 1 ? surface_of(Generated_mesh(
                                           [](auto& p, auto& h) { CGAL::Hex_mesh_optimization::make_ball(p, h, 4); }))
                           : kind == 2 ? torus_surface(24, 12, .4)
                                       : cone_surface(24);
  const Vector_3 size = Vector_3::Constant(.5) + .5 * random.vector();
  const Matrix_3 rotation = random.rotation();
  const Vector_3 by = 1.5 * random.vector();
  for (Vector_3& p : result.points)
    p = rotation * p.cwiseProduct(size) + by;
  return result;
}

// One to four: boxes that touch in pieces of faces, or any, or copies of one before.
inline std::vector<Reference_input> random_parts(Random_number& random)
{
  std::vector<Reference_input> result;
  const int number = random.integer(1, 4);
  if (random.integer(0, 2) == 0) { // a pile
    double level = 0;
    for (int i = 0; i < number; ++i) {
      const Vector_3 low(random.integer(0, 3) / 8., random.integer(0, 3) / 8., level),
        size(random.integer(3, 8) / 8., random.integer(3, 8) / 8., random.integer(2, 5) / 8.);
      result.push_back(box_surface(low, low + size));
      level += size[2];
    }
    return result;
  }
  for (int i = 0; i < number; ++i)
    result.push_back(i > 0 && random.integer(0, 4) == 0 ? result[random.integer(0, i - 1)] : random_part(random));
  return result;
}

struct Union_of_parts
{
  bool is_known = true; // else corefinement has no result, as where parts touch in an edge only
  double volume = 0;
  std::size_t number_of_bodies = 0;
  std::ptrdiff_t euler_characteristic = 0;
};

inline Union_of_parts union_of(const std::vector<Reference_input>& parts)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Union_of_parts result;
  Surface sum;
  for (const Reference_input& part : parts) {
    Surface mesh = surface_mesh(part), both;
    if (sum.is_empty())
      sum = mesh;
    else if (PMP::corefine_and_compute_union(sum, mesh, both))
      sum = both;
    else
      result.is_known = false;
  }
  sum.collect_garbage();
  std::vector<Surface> bodies;
  PMP::split_connected_components(sum, bodies);
  for (const Surface& body : bodies)
    result.number_of_bodies += CGAL::to_double(PMP::volume(body)) > 0; // others are cavities
  result.volume = CGAL::to_double(PMP::volume(sum));
  result.euler_characteristic = std::ptrdiff_t(sum.number_of_vertices()) - std::ptrdiff_t(sum.number_of_edges()) +
                                std::ptrdiff_t(sum.number_of_faces());
  return result;
}

// Turned as a whole, rounded to single precision, each triangle with vertices of its own: some are the other way
// round, some are there twice, some divided at the middle of an edge or within.
inline Reference_input written_badly(const Reference_input& surface, const Matrix_3& rotation, Random_number& random,
                                     bool rounds)
{
  Reference_input result;
  const auto add = [&](const Vector_3& a, const Vector_3& b, const Vector_3& c) {
    const int n = static_cast<int>(result.points.size());
    for (const Vector_3& p : {a, b, c}) {
      const Vector_3 place = rotation * p;
      result.points.push_back(rounds ? Vector_3(place.cast<float>().cast<double>()) : place);
    }
    if (random.integer(0, 2) == 0)
      result.triangles.push_back({n, n + 2, n + 1});
    else
      result.triangles.push_back({n, n + 1, n + 2});
  };
  for (const Triangle_indices& t : surface.triangles) {
    const Vector_3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const int way = random.integer(0, 9);
    const Vector_3 middle = way == 0 ? Vector_3((a + b) / 2) : Vector_3((a + b + c) / 3);
    if (way < 2) {
      add(a, middle, c);
      add(middle, b, c);
      if (way == 1)
        add(a, b, middle);
    }
    else
      for (int copy = 0; copy < (way == 2 ? 2 : 1); ++copy)
        add(a, b, c);
  }
  return result;
}

} // namespace test

#endif // CGAL_HEX_MESH_OPTIMIZATION_TEST_RANDOM_PARTS_H
