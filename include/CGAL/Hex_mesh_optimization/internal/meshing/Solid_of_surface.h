// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_OF_SURFACE_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_OF_SURFACE_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What a surface bounds, as people have surfaces: its bodies, each with a closed boundary of its own, and what had to be
// understood to find them.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_boundary.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_stitching.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

inline double enclosed_volume(const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  double sum = 0;
  if (triangles.empty())
    return 0;
  const Vector_3 origin = points[triangles[0][0]];
  for (const Triangle_indices& t : triangles)
    sum += (points[t[0]] - origin).dot((points[t[1]] - origin).cross(points[t[2]] - origin)) / 6;
  return sum;
}

inline double surface_area(const Positions& points, const std::vector<Triangle_indices>& triangles)
{
  double sum = 0;
  for (const Triangle_indices& t : triangles)
    sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
  return sum;
}

// About how many hexahedra a solid of that volume and area has: its volume in cells, and a layer on a surface of steps, which
// is larger.
inline double number_for(double volume, double area, double spacing)
{
  constexpr double larger = 1.4;
  return volume / (spacing * spacing * spacing) + larger * area / (spacing * spacing);
}

// The spacing for that number.
inline double spacing_for(double volume, double area, double number)
{
  double low = 0, high = std::cbrt(volume) + 2 * std::sqrt(area);
  for (int i = 0; i < 60; ++i) {
    const double h = (low + high) / 2;
    (number_for(volume, area, h) > number ? low : high) = h;
  }
  return high;
}

class Solid_of_surface
{
public:
  struct Body
  {
    Reference_input surface;          // closed, oriented outwards
    std::vector<std::size_t> face_of; // of each of its triangles, a face of the surface as given
    double volume = 0;
  };

  // number, spacing: of the hexahedra to be made; spacing may be 0. Throws Input_error unless the surface bounds a volume, but
  // for holes that are small against the cells.
  Solid_of_surface(const Reference_input& given, double number, double spacing) : given_(given)
  {
    require_finite();
    const double cell = spacing > 0 ? spacing : estimated_spacing(number);
    Soup_stitching stitched = closed(given, cell);
    leave_out_walls(stitched);
    require_closed(stitched, cell);
    const double rounding = 3e-6 * bounding_diagonal(); // of parts that touch
    auto parts = std::make_unique<const Soup_parts>(stitched.points, stitched.triangles);
    auto of_parts = std::make_unique<const Solid_boundary>(stitched.points, *parts, rounding);
    if (of_parts->volume_inside_out > 0 && !parts->cavities.empty()) { // they are not within others, but cross them
      parts = std::make_unique<const Soup_parts>(stitched.points, stitched.triangles, false);
      of_parts = std::make_unique<const Solid_boundary>(stitched.points, *parts, rounding);
    }
    const Solid_boundary& boundary = *of_parts;
    require_outwards(boundary, cell);
    is_as_given_ = stitched.points == given.points && boundary.triangles == given.triangles &&
                   boundary.points == given.points;
    report_stitching(stitched);
    report.number_of_parts = parts->number_of_parts;
    report.number_of_reoriented_parts = parts->number_of_reoriented_parts;
    report.number_of_aligned_vertices = boundary.number_of_aligned;
    report.number_of_faces_within += boundary.number_within + uncounted(*parts);
    separate_bodies(boundary, stitched, cell);
    if (bodies.empty())
      throw Input_error(Input_error::Element::MESH, 0, "the surface bounds no volume");
  }

  std::vector<Body> bodies;
  Surface_report report;

private:
  using Element = Input_error::Element;

  void require_finite() const
  {
    if (given_.triangles.empty())
      throw Input_error(Element::MESH, 0, "the surface has no faces");
    for (std::size_t v = 0; v < given_.points.size(); ++v)
      if (!given_.points[v].allFinite())
        throw Input_error(Element::REFERENCE_VERTEX, v,
                          "vertex " + std::to_string(v) + " of the surface has a coordinate that is not finite");
  }

  double bounding_diagonal() const
  {
    Eigen::AlignedBox3d box;
    for (const Triangle_indices& t : given_.triangles)
      for (int v : t)
        box.extend(given_.points[v]);
    return box.diagonal().norm();
  }

  // Before it is known which triangles are turned.
  double estimated_spacing(double number) const
  {
    Eigen::AlignedBox3d box;
    for (const Triangle_indices& t : given_.triangles)
      for (int v : t)
        box.extend(given_.points[v]);
    const double least = .05; // part of the box
    const double volume = (std::max)(std::abs(enclosed_volume(given_.points, given_.triangles)), least * box.volume());
    return spacing_for(volume, surface_area(given_.points, given_.triangles), number);
  }

  // Borders that are farther apart belong together as well if the surface is open otherwise.
  static Soup_stitching closed(const Reference_input& given, double cell)
  {
    const double most = .05; // distance, in cells
    for (double tolerance : {1e-3, .01}) {
      Soup_stitching stitched(given.points, given.triangles, tolerance * cell, cell);
      if (std::all_of(stitched.holes.begin(), stitched.holes.end(), [](const auto& hole) { return hole.is_filled; }))
        return stitched;
    }
    return Soup_stitching(given.points, given.triangles, most * cell, cell);
  }

  // An open sheet within what the others bound divides it, and bounds nothing: it goes.
  void leave_out_walls(Soup_stitching& stitched)
  {
    std::set<int> open; // vertices of holes
    for (const Soup_stitching::Hole& hole : stitched.holes)
      if (!hole.is_filled)
        open.insert(hole.vertices.begin(), hole.vertices.end());
    if (open.empty())
      return;
    Disjoint_sets sheets(stitched.triangles.size());
    std::vector<int> borders; // a triangle at each
    for_soup_edges(stitched.triangles, [&](auto first, auto last) {
      if (last - first == 2)
        sheets.unite(first->triangle, (first + 1)->triangle);
      else if (last - first == 1)
        borders.push_back(first->triangle);
    });
    std::set<std::size_t> walls;
    for (int t : borders)
      walls.insert(sheets.find(t));
    std::vector<Triangle_indices> rest, within;
    std::vector<int> origin;
    for (std::size_t t = 0; t < stitched.triangles.size(); ++t)
      if (walls.count(sheets.find(t)))
        within.push_back(stitched.triangles[t]);
      else {
        rest.push_back(stitched.triangles[t]);
        origin.push_back(stitched.origin[t]);
      }
    bool is_closed = !rest.empty();
    for_soup_edges(rest, [&](auto first, auto last) { is_closed = is_closed && last - first > 1; });
    if (!is_closed || !are_within(stitched.points, within, rest))
      return;
    stitched.triangles = std::move(rest);
    stitched.origin = std::move(origin);
    stitched.holes.erase(std::remove_if(stitched.holes.begin(), stitched.holes.end(),
                                        [](const Soup_stitching::Hole& hole) { return !hole.is_filled; }),
                         stitched.holes.end());
    report.number_of_faces_within += within.size();
  }

  // As far as some of the triangles tell.
  static bool are_within(const Positions& points, const std::vector<Triangle_indices>& triangles,
                         const std::vector<Triangle_indices>& closed)
  {
    constexpr std::size_t most = 100;
    const std::size_t step = triangles.size() / most + 1;
    for (std::size_t t = 0; t < triangles.size(); t += step) {
      const Vector_3 middle = (points[triangles[t][0]] + points[triangles[t][1]] + points[triangles[t][2]]) / 3;
      double winding = 0;
      for (const Triangle_indices& v : closed)
        winding += solid_angle(middle, points[v[0]], points[v[1]], points[v[2]]);
      if (std::abs(winding) < .5) // whatever way they are oriented
        return false;
    }
    return true;
  }

  void require_closed(const Soup_stitching& stitched, double cell) const
  {
    const Soup_stitching::Hole* largest = nullptr;
    std::size_t number = 0, edges = 0;
    for (const Soup_stitching::Hole& hole : stitched.holes)
      if (!hole.is_filled) {
        ++number;
        edges += hole.vertices.size();
        if (!largest || hole.size > largest->size)
          largest = &hole;
      }
    if (!largest)
      return;
    const int v = largest->vertices[0];
    throw Input_error(Element::REFERENCE_VERTEX, v,
                      "the surface is open: " + std::to_string(edges) +
                        " of its edges have a face on one side only, in " + std::to_string(number) +
                        (number == 1 ? " hole" : " holes") + " larger than a cell, which is about " + in_digits(cell) +
                        " long. The largest measures " + in_digits(largest->size) + " across, at vertex " +
                        std::to_string(v) + ", " + in_words(stitched.points[v]));
  }

  void require_outwards(const Solid_boundary& boundary, double cell) const
  {
    if (boundary.volume_inside_out > cell * cell * cell)
      throw Input_error(
        Element::MESH, 0,
        "the surface passes through itself and is inside out beyond: there it would bound a volume of -" +
          in_digits(boundary.volume_inside_out) + ", near " + in_words(boundary.place_inside_out));
  }

  void report_stitching(const Soup_stitching& stitched)
  {
    report.number_of_copies = stitched.number_of_copies;
    report.number_without_area = stitched.number_without_area;
    report.number_of_stitched_vertices = stitched.number_of_stitched;
    report.farthest_moved = stitched.farthest;
    for (const Soup_stitching::Hole& hole : stitched.holes) {
      ++report.number_of_filled_holes;
      report.largest_filled_hole = (std::max)(report.largest_filled_hole, hole.size);
    }
  }

  static std::size_t uncounted(const Soup_parts& parts)
  {
    return std::count(parts.part.begin(), parts.part.end(), Soup_parts::none);
  }

  // A shell and the cavities in it.
  void separate_bodies(const Solid_boundary& boundary, const Soup_stitching& stitched, double cell)
  {
    std::vector<std::vector<int>> shells = components(boundary);
    // volume: less is left where faces cross by a little
    const double least = 1e-3 *
                         (std::min)(cell * cell * cell, std::abs(enclosed_volume(boundary.points, boundary.triangles)));
    std::vector<std::pair<double, std::vector<int>>> outer, cavities;
    for (std::vector<int>& shell : shells) {
      const double volume = enclosed_volume(boundary.points, triangles_of(boundary, shell));
      if (std::abs(volume) < least && shells.size() > 1) {
        ++report.number_of_small_components;
        report.volume_of_small_components += volume;
      }
      else
        (volume > 0 ? outer : cavities).emplace_back(std::abs(volume), std::move(shell));
    }
    std::sort(outer.begin(), outer.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::vector<int>> of_body;
    for (const auto& shell : outer)
      of_body.push_back(shell.second);
    for (const auto& cavity : cavities)
      for (std::size_t b = 0; b < outer.size(); ++b)
        if (outer[b].first > cavity.first && contains(boundary, outer[b].second, cavity.second)) {
          of_body[b].insert(of_body[b].end(), cavity.second.begin(), cavity.second.end());
          break;
        }
    std::sort(of_body.begin(), of_body.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
    for (std::vector<int>& triangles : of_body) {
      std::sort(triangles.begin(), triangles.end());
      add_body(boundary, stitched, triangles);
    }
    report.number_of_bodies = bodies.size();
  }

  static std::vector<std::vector<int>> components(const Solid_boundary& boundary)
  {
    Disjoint_sets sets(boundary.points.size());
    for (const Triangle_indices& t : boundary.triangles) {
      sets.unite(t[0], t[1]);
      sets.unite(t[0], t[2]);
    }
    std::map<std::size_t, std::vector<int>> of_root;
    for (std::size_t t = 0; t < boundary.triangles.size(); ++t)
      of_root[sets.find(boundary.triangles[t][0])].push_back(static_cast<int>(t));
    std::vector<std::vector<int>> result;
    for (auto& entry : of_root)
      result.push_back(std::move(entry.second));
    return result;
  }

  static std::vector<Triangle_indices> triangles_of(const Solid_boundary& boundary, const std::vector<int>& list)
  {
    std::vector<Triangle_indices> result;
    for (int t : list)
      result.push_back(boundary.triangles[t]);
    return result;
  }

  static bool contains(const Solid_boundary& boundary, const std::vector<int>& shell, const std::vector<int>& other)
  {
    const Triangle_indices& first = boundary.triangles[other[0]];
    const Vector_3 place = (boundary.points[first[0]] + boundary.points[first[1]] + boundary.points[first[2]]) / 3;
    double winding = 0;
    for (int t : shell) {
      const Triangle_indices& v = boundary.triangles[t];
      winding += solid_angle(place, boundary.points[v[0]], boundary.points[v[1]], boundary.points[v[2]]);
    }
    return winding > .5;
  }

  void add_body(const Solid_boundary& boundary, const Soup_stitching& stitched, const std::vector<int>& list)
  {
    Body body;
    if (is_as_given_ && list.size() == given_.triangles.size()) {
      body.surface = given_;
      for (int t : list)
        body.face_of.push_back(t);
    }
    else {
      std::map<int, int> number;
      body.surface.sharp_is_given = given_.sharp_is_given;
      const std::set<std::array<int, 2>> sharp = sorted_edges(given_.sharp);
      for (int t : list) {
        const int face = stitched.origin[boundary.origin[t]];
        Triangle_indices triangle;
        for (int k = 0; k < 3; ++k) {
          const int v = boundary.triangles[t][k];
          const auto inserted = number.emplace(v, static_cast<int>(body.surface.points.size()));
          if (inserted.second)
            body.surface.points.push_back(boundary.points[v]);
          triangle[k] = inserted.first->second;
        }
        body.surface.triangles.push_back(triangle);
        body.face_of.push_back(face == Soup_stitching::none ? std::size_t(0) : std::size_t(face));
        if (face != Soup_stitching::none)
          add_sharp(body.surface, triangle, given_.triangles[face], sharp);
      }
    }
    body.volume = enclosed_volume(body.surface.points, body.surface.triangles);
    report.volume += body.volume;
    report.area += surface_area(body.surface.points, body.surface.triangles);
    report.euler_characteristic += euler_characteristic_of(body.surface.triangles);
    bodies.push_back(std::move(body));
  }

  static std::set<std::array<int, 2>> sorted_edges(const Edge_list& edges)
  {
    std::set<std::array<int, 2>> result;
    for (const std::array<int, 2>& e : edges)
      result.insert({(std::min)(e[0], e[1]), (std::max)(e[0], e[1])});
    return result;
  }

  // Edges of a piece of a face that lie on edges of that which are given as sharp.
  void add_sharp(Reference_input& surface, const Triangle_indices& piece, const Triangle_indices& face,
                 const std::set<std::array<int, 2>>& sharp) const
  {
    for (int k = 0; k < 3 && !sharp.empty(); ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      if (!sharp.count({(std::min)(a, b), (std::max)(a, b)}))
        continue;
      const Vector_3 along = given_.points[b] - given_.points[a];
      const auto is_on_edge = [&](int v) {
        const Vector_3 d = surface.points[v] - given_.points[a];
        return (d - along.dot(d) / along.squaredNorm() * along).norm() < 1e-6 * along.norm();
      };
      for (int i = 0; i < 3; ++i)
        if (is_on_edge(piece[i]) && is_on_edge(piece[(i + 1) % 3]))
          surface.sharp.push_back({piece[i], piece[(i + 1) % 3]});
    }
  }

  static std::ptrdiff_t euler_characteristic_of(const std::vector<Triangle_indices>& triangles)
  {
    std::set<int> vertices;
    for (const Triangle_indices& t : triangles)
      vertices.insert(t.begin(), t.end());
    return static_cast<std::ptrdiff_t>(vertices.size()) - static_cast<std::ptrdiff_t>(triangles.size() / 2);
  }

  const Reference_input& given_;
  bool is_as_given_ = false;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_OF_SURFACE_H
