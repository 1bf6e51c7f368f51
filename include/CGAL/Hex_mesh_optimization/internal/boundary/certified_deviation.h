// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CERTIFIED_DEVIATION_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CERTIFIED_DEVIATION_H

#include <CGAL/license/Hex_mesh_optimization.h>

// How far two surfaces are apart at most: a bound that is shown, where deviation.h
// measures at samples.
//
// The distance to a convex set is convex. Over a convex polygon, the distance to a surface is therefore at most the
// largest distance of the corners of the polygon to any one triangle of the surface. Where that is too much, the
// polygon is cut along the sides of the triangle and each piece compared with the triangle close to it: so two surfaces
// that run along each other need about as many pieces as triangles of the one lie over those of the other, however
// small the bound is.

#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/base/parallel.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Hexahedral_complex.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Surface_point.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/closest_point_of_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

struct Certification_parameters
{
  // Where the surfaces turn out to be farther apart than asked for, the bound is within this part of the largest
  // distance found; infinite: it is whatever is known by then.
  double tolerance = .01;
  // That may be made of each triangle of both surfaces on average. Bunny with its boundary vertices slid along the
  // surface by 2% or 20% of an edge needs 2, and up to 6 of the triangles that are cut at all.
  std::size_t pieces = 32;
};

struct Certified_deviation
{
  double upper_bound = std::numeric_limits<double>::infinity(); // of the two-sided distance; always valid
  double largest_found = 0;                                     // the distance of a point of one surface to the other
  Vector_3 where = Vector_3::Zero();                            // that point
  bool is_shown = false;                                        // upper_bound is at most what was asked for
};

// Part of a triangle, with its corners in order.
class Convex_polygon
{
public:
  static constexpr int most_corners = 8; // of what is cut along three lines

  Convex_polygon() = default;
  Convex_polygon(const Vector_3& a, const Vector_3& b, const Vector_3& c) : corners_{a, b, c}, size_(3) {}

  int size() const { return size_; }
  const Vector_3* begin() const { return corners_.data(); }
  const Vector_3* end() const { return corners_.data() + size_; }

  Vector_3 center() const
  {
    Vector_3 sum = Vector_3::Zero();
    for (const Vector_3& c : *this)
      sum += c;
    return sum / double(size_);
  }

  // The parts behind and before a plane, which together are all of it; one is empty if the plane does not divide it.
  // What is within the tolerance of the plane counts for both.
  std::array<Convex_polygon, 2> cut(const Vector_3& point, const Vector_3& unit_normal, double tolerance) const
  {
    std::array<Convex_polygon, 2> parts;
    std::array<double, capacity> height;
    bool is_behind = false, is_before = false;
    for (int i = 0; i < size_; ++i) {
      height[i] = unit_normal.dot(corners_[i] - point);
      is_behind = is_behind || height[i] < -tolerance;
      is_before = is_before || height[i] > tolerance;
    }
    if (!is_behind || !is_before) {
      parts[is_before] = *this;
      return parts;
    }
    for (int i = 0; i < size_; ++i) {
      const int next = (i + 1) % size_;
      if (height[i] <= tolerance)
        parts[0].add(corners_[i]);
      if (height[i] >= -tolerance)
        parts[1].add(corners_[i]);
      if ((height[i] < -tolerance && height[next] > tolerance) ||
          (height[i] > tolerance && height[next] < -tolerance)) {
        const Vector_3 p = corners_[i] + height[i] / (height[i] - height[next]) * (corners_[next] - corners_[i]);
        parts[0].add(p);
        parts[1].add(p);
      }
    }
    return parts;
  }

  // Cut in two across the longest line between its corners, or, where it has many corners, along a diagonal.
  std::array<Convex_polygon, 2> halves() const
  {
    std::array<Convex_polygon, 2> parts;
    if (size_ > most_corners) {
      for (int i = 0; i <= size_ / 2; ++i)
        parts[0].add(corners_[i]);
      for (int i = size_ / 2; i <= size_; ++i)
        parts[1].add(corners_[i % size_]);
      return parts;
    }
    int from = 0, to = 0;
    double longest = 0;
    for (int i = 0; i < size_; ++i)
      for (int j = i + 1; j < size_; ++j)
        if ((corners_[j] - corners_[i]).squaredNorm() > longest) {
          longest = (corners_[j] - corners_[i]).squaredNorm();
          from = i;
          to = j;
        }
    const Vector_3 line = corners_[to] - corners_[from];
    return cut((corners_[from] + corners_[to]) / 2, line.normalized(), 0);
  }

private:
  static constexpr int capacity = 2 * most_corners; // a cut adds no more than two

  void add(const Vector_3& p)
  {
    if (size_ < capacity) // always so: what is cut is convex
      corners_[size_++] = p;
  }

  std::array<Vector_3, capacity> corners_;
  int size_ = 0;
};

struct Found_in_triangle
{
  std::size_t triangle;
  Vector_3 where;
};

// The largest distance of the points of one surface to another.
class One_sided_distance
{
public:
  struct Found
  {
    double distance = 0;
    Vector_3 where = Vector_3::Zero();

    void note(double d, const Vector_3& p)
    {
      if (d > distance) {
        distance = d;
        where = p;
      }
    }
  };

  // rounding: how far coordinates and distances may be off. The surfaces, neither of them empty, must outlive the
  // object.
  One_sided_distance(const Triangle_surface& from, const Triangle_surface& to, double rounding)
    : from_(from)
    , to_(to)
    , rounding_(rounding)
    , foot_(from.triangles.size())
  {}

  // The distances of the vertices and the centers of the triangles.
  void sample(Found& found)
  {
    const std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> triangle_of_vertex(from_.points.size(), none);
    for (std::size_t t = 0; t < from_.triangles.size(); ++t)
      for (int v : from_.triangles[t])
        triangle_of_vertex[v] = t;
    note_all(found, from_.triangles.size(), [&](std::size_t begin, std::size_t end, Found& part) {
      std::size_t near = Surface_point::no_triangle; // the next one is not far
      for (std::size_t t = begin; t < end; ++t) {
        foot_[t] = search(polygon(t).center(), near, from_.sheet(t), part);
        near = foot_[t].triangle;
      }
    });
    note_all(found, from_.points.size(), [&](std::size_t begin, std::size_t end, Found& part) {
      for (std::size_t v = begin; v < end; ++v)
        if (triangle_of_vertex[v] != none)
          search(from_.points[v], foot_[triangle_of_vertex[v]].triangle, from_.sheet(triangle_of_vertex[v]), part);
    });
  }

  // An upper bound: not above the target, if that can be shown. Notes what it finds on the way. After sample().
  double upper_bound(double target, const Certification_parameters& parameters, Found& found) const
  {
    std::vector<Bounded> bounds(from_.triangles.size());
    std::vector<std::size_t> open(from_.triangles.size());
    for (std::size_t t = 0; t < open.size(); ++t)
      open[t] = t;
    const std::size_t pieces = parameters.pieces * (from_.triangles.size() + to_.triangles.size());
    // most need few pieces, which leaves many for the others
    for (std::size_t most : {parameters.pieces, (std::numeric_limits<std::size_t>::max)()}) {
      if (open.empty())
        break;
      most = (std::min)(most, pieces / open.size());
      const Found before = found;
      note_all(found, open.size(), [&](std::size_t begin, std::size_t end, Found& part) {
        std::vector<Piece> heap;
        for (std::size_t i = begin; i < end; ++i) {
          Found here = before;
          bounds[open[i]] = bound(open[i], target, parameters.tolerance, most, heap, here);
          part.note(here.distance, here.where);
        }
      });
      open.erase(std::remove_if(open.begin(), open.end(), [&](std::size_t t) { return !bounds[t].is_open; }),
                 open.end());
    }
    double result = 0;
    for (const Bounded& b : bounds)
      result = (std::max)(result, b.bound);
    return result;
  }

  // About the farthest place of each triangle that is farther than its target somewhere, or of which many pieces do not
  // tell and which comes within the tolerance of it. target(triangle, near): of a triangle, near that one of the other
  // surface. After sample().
  template <class Target>
  std::vector<Found_in_triangle> farthest_places(const Target& target, const Certification_parameters& parameters) const
  {
    const auto of_ranges = results_of_ranges<std::vector<Found_in_triangle>>(
      from_.triangles.size(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Found_in_triangle> places;
        std::vector<Piece> heap;
        for (std::size_t t = begin; t < end; ++t) {
          const double most = target(t, foot_[t].triangle);
          Found here;
          const auto is_left_open = [&](std::size_t pieces) {
            return bound(t, most, parameters.tolerance, pieces, heap, here).is_open;
          };
          const bool is_open = is_left_open(parameters.pieces) && is_left_open(many * parameters.pieces);
          if (is_open) // a peak is where parts meet: their centers may not be beyond, however small they are
            for (const Vector_3& corner : heap.front().polygon)
              search(corner, heap.front().foot.triangle, from_.sheet(t), here);
          if (here.distance > (is_open ? 1 - parameters.tolerance : 1) * most)
            places.push_back({t, here.where});
        }
        return places;
      },
      grain);
    std::vector<Found_in_triangle> result;
    for (const std::vector<Found_in_triangle>& places : of_ranges)
      result.insert(result.end(), places.begin(), places.end());
    return result;
  }

private:
  struct Bounded
  {
    double bound = 0;
    bool is_open = false; // there were too many pieces
  };

  struct Piece
  {
    Convex_polygon polygon;
    double bound;       // of its distance
    Surface_point foot; // near it

    bool operator<(const Piece& other) const { return bound < other.bound; }
  };

  static constexpr std::size_t grain = 256; // triangles, each worth some microseconds
  // Times the pieces, for the few triangles of which those do not tell (measured on an organic model bound to .1 % of its
  // diagonal: without this a place .8 % beyond the bound is not found).
  static constexpr std::size_t many = 16;

  // Calls work(begin, end, found) for ranges of 0 … n-1.
  template <class Work>
  static void note_all(Found& found, std::size_t n, const Work& work)
  {
    for (const Found& part : results_of_ranges<Found>(
           n,
           [&](std::size_t begin, std::size_t end) {
             Found in_range;
             work(begin, end, in_range);
             return in_range;
           },
           grain))
      found.note(part.distance, part.where);
  }

  Convex_polygon polygon(std::size_t t) const
  {
    return Convex_polygon(from_.corner(t, 0), from_.corner(t, 1), from_.corner(t, 2));
  }

  Surface_point search(const Vector_3& p, std::size_t near, int sheet, Found& found) const
  {
    Surface_point foot = to_.closest_point(p, near, sheet);
    found.note(to_.way(p, foot).norm(), p);
    if (const int at_rim = to_.rims.triangle_at(foot); at_rim != Rims::none)
      foot.triangle = at_rim; // has the side that what is beyond is compared with
    return foot;
  }

  // What a distance may be without a need to look closer.
  double threshold(double target, double tolerance, const Found& found) const
  {
    // once by what is found is rounded, once by what the bound is
    return (std::max)(rounding_, found.distance > target ? (1 + tolerance) * found.distance : target - 2 * rounding_);
  }

  // Whatever rounding makes of the coordinates of the closest point, a point of the triangle is as close as that.
  double distance(const Vector_3& p, std::size_t triangle) const
  {
    const Vector_3 &a = to_.corner(triangle, 0), &b = to_.corner(triangle, 1), &c = to_.corner(triangle, 2);
    std::array<double, 3> w = closest_point_of_triangle(p, a, b, c);
    for (double& x : w)
      x = (std::max)(x, 0.0);
    return ((w[0] * a + w[1] * b + w[2] * c) / (w[0] + w[1] + w[2]) - p).norm();
  }

  double distance(const Convex_polygon& polygon, std::size_t triangle) const
  {
    double least = largest_over(polygon, [&](const Vector_3& p) { return distance(p, triangle); });
    for (int k = 0; k < 3; ++k)
      if (to_.rims.has(triangle, k)) {
        // what is beyond is convex too
        const Vector_3 &start = to_.corner(triangle, k), normal = to_.plane_normal(triangle);
        const Vector_3 outwards = (to_.corner(triangle, (k + 1) % 3) - start).cross(normal).normalized();
        least = (std::min)(least, largest_over(polygon, [&](const Vector_3& p) {
                             const double before = (std::max)(0.0, -outwards.dot(p - start));
                             return to_.rims.beyond == Beyond_rim::ANYTHING ? before
                                                                            : std::hypot(before, normal.dot(p - start));
                           }));
      }
    return least;
  }

  template <class Distance>
  static double largest_over(const Convex_polygon& polygon, const Distance& distance)
  {
    double largest = 0;
    for (const Vector_3& corner : polygon)
      largest = (std::max)(largest, distance(corner));
    return largest;
  }

  // heap: for repeated use
  Bounded bound(std::size_t triangle, double target, double tolerance, std::size_t most, std::vector<Piece>& heap,
                Found& found) const
  {
    const int sheet = from_.sheet(triangle);
    double shown = 0; // by the pieces that are done with
    heap.clear();
    // parent: of the piece, or near it
    const auto add = [&](const Convex_polygon& polygon, const Piece& parent) {
      Piece piece{polygon, (std::min)(parent.bound, distance(polygon, parent.foot.triangle)), parent.foot};
      if (piece.bound > threshold(target, tolerance, found)) {
        piece.foot = search(polygon.center(), parent.foot.triangle, sheet, found);
        if (piece.foot.triangle != parent.foot.triangle)
          piece.bound = (std::min)(piece.bound, distance(polygon, piece.foot.triangle));
      }
      if (piece.bound <= threshold(target, tolerance, found)) {
        shown = (std::max)(shown, piece.bound);
        return;
      }
      heap.push_back(piece);
      std::push_heap(heap.begin(), heap.end());
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const Convex_polygon whole = polygon(triangle);
    add(whole, Piece{whole, infinity, foot_[triangle]});
    for (std::size_t pieces = 1; !heap.empty() && heap.front().bound > threshold(target, tolerance, found);) {
      if (pieces >= most)
        return {(std::max)(shown, heap.front().bound), true};
      std::pop_heap(heap.begin(), heap.end());
      Piece piece = heap.back();
      heap.pop_back();
      if (const std::size_t parts = divide(piece, sheet, target, tolerance, found, add))
        pieces += parts;
      else
        shown = (std::max)(shown, piece.bound);
    }
    return {heap.empty() ? shown : (std::max)(shown, heap.front().bound), false};
  }

  // Calls add(polygon, piece) for the parts of a piece. How many there are; or none, and the bound of the piece is good
  // enough.
  template <class Add>
  std::size_t divide(Piece& piece, int sheet, double target, double tolerance, Found& found, const Add& add) const
  {
    std::size_t parts = 0;
    const auto add_part = [&](const Convex_polygon& part) {
      add(part, piece);
      ++parts;
    };
    if (piece.polygon.size() <= Convex_polygon::most_corners) {
      // what lies beyond the sides of the triangle nearby, one after the other, and what lies before all of them
      const std::size_t t = piece.foot.triangle;
      const Vector_3 normal = (to_.corner(t, 1) - to_.corner(t, 0)).cross(to_.corner(t, 2) - to_.corner(t, 0));
      std::array<Convex_polygon, 3> beyond;
      Convex_polygon rest = piece.polygon;
      bool is_cut = false;
      for (int k = 0; k < 3 && rest.size() > 0; ++k) {
        const Vector_3& start = to_.corner(t, k);
        const auto sides = rest.cut(start, (to_.corner(t, (k + 1) % 3) - start).cross(normal).normalized(), rounding_);
        is_cut = is_cut || (sides[0].size() > 0 && sides[1].size() > 0);
        rest = sides[0];
        beyond[k] = sides[1];
      }
      if (is_cut) {
        for (const Convex_polygon& polygon : {beyond[0], beyond[1], beyond[2], rest})
          if (polygon.size() > 0)
            add_part(polygon);
        return parts;
      }
    }
    // another triangle is closer to a part of it, or this is how far away it is
    const std::size_t before = piece.foot.triangle;
    for (const Vector_3& corner : piece.polygon)
      if (distance(corner, before) > threshold(target, tolerance, found)) {
        const Surface_point foot = search(corner, piece.foot.triangle, sheet, found);
        piece.bound = (std::min)(piece.bound, distance(piece.polygon, foot.triangle));
      }
    if (piece.bound <= threshold(target, tolerance, found))
      return 0;
    for (const Convex_polygon& half : piece.polygon.halves())
      if (half.size() > 0)
        add_part(half);
    return parts;
  }

  const Triangle_surface& from_;
  const Triangle_surface& to_;
  const double rounding_;
  std::vector<Surface_point> foot_; // of the center of each triangle
};

// How far distances between points of the two may be off: by some tens of operations, each by some 1e-16 of the
// coordinates.
inline double rounding_of_distances(const Triangle_surface& first, const Triangle_surface& second)
{
  double extent = 0;
  for (const Triangle_surface* surface : {&first, &second})
    for (const Triangle_indices& t : surface->triangles)
      for (int v : t)
        extent = (std::max)(extent, surface->points[v].lpNorm<Eigen::Infinity>());
  return 1e-12 * extent;
}

// Of two surfaces, sheet by sheet; target: the bound to show. O(n log n) for n triangles that lie over each other like those of two
// meshes of one shape. What is found does not depend on the number of threads. Nothing is shown if a surface is empty.
inline Certified_deviation certified_distance(const Triangle_surface& first, const Triangle_surface& second,
                                              double target,
                                              const Certification_parameters& parameters = Certification_parameters())
{
  Certified_deviation result;
  if (first.is_empty() || second.is_empty())
    return result;
  const double rounding = rounding_of_distances(first, second);
  One_sided_distance there(first, second, rounding), back(second, first, rounding);
  One_sided_distance::Found found;
  there.sample(found);
  back.sample(found);
  const double bound_there = there.upper_bound(target, parameters, found);
  result.upper_bound = (std::max)(bound_there, back.upper_bound(target, parameters, found)) + rounding;
  result.largest_found = found.distance;
  result.where = found.where;
  result.is_shown = result.upper_bound <= target;
  return result;
}

// About the farthest place of each triangle of one surface that is farther than its target from the other somewhere;
// target: as above. None if a surface is empty. O(n log n) as for the bound.
template <class Target>
std::vector<Found_in_triangle> farthest_places(const Triangle_surface& from, const Triangle_surface& to,
                                               const Target& target,
                                               const Certification_parameters& parameters = Certification_parameters())
{
  if (from.is_empty() || to.is_empty())
    return {};
  One_sided_distance distance(from, to, rounding_of_distances(from, to));
  One_sided_distance::Found found;
  distance.sample(found);
  return distance.farthest_places(target, parameters);
}

// Of faces of the mesh, each as two triangles, and the reference.
inline Certified_deviation certified_deviation(const Surface_faces& faces, const Positions& points,
                                               const Triangle_surface& reference, double target,
                                               const Certification_parameters& parameters = Certification_parameters())
{
  return certified_distance(as_triangle_surface(faces, points), reference, target, parameters);
}

// How far the bilinear faces of the boundary are from their two triangles at most, whichever diagonal those share: at
// the center of the face, where that is |a - b + c - d| / 4.
inline double bilinear_excess(const Hexahedral_complex& complex, const Positions& points)
{
  double largest = 0;
  for (const Hexahedral_complex::Boundary_face& f : complex.boundary_faces) {
    const std::array<int, 4>& q = f.vertices;
    largest = (std::max)(largest, (points[q[0]] - points[q[1]] + points[q[2]] - points[q[3]]).norm() / 4);
  }
  return largest;
}

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_BOUNDARY_CERTIFIED_DEVIATION_H
