// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_BOUNDARY_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_BOUNDARY_H

#include <CGAL/license/Hex_mesh_optimization.h>

// The boundary of what a triangle soup bounds, as a closed surface for each body: the faces with inside on one side only.

#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Contact_planes.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_arrangement.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Solid_boundary
{
public:
  // Inside is where the parts wind around more than 0 times in all. tolerance: parts that are as near touch.
  Solid_boundary(const Positions& points_of_soup, const Soup_parts& parts, double tolerance) : parts_(parts)
  {
    std::vector<Triangle_indices> counted;
    for (std::size_t t = 0; t < parts.triangles.size(); ++t)
      if (parts.part[t] != Soup_parts::none) {
        counted.push_back(parts.triangles[t]);
        triangle_of_counted_.push_back(static_cast<int>(t));
      }
    std::vector<int> part;
    for (int t : triangle_of_counted_)
      part.push_back(parts.part[t]);
    const Contact_planes contacts(points_of_soup, counted, part, tolerance);
    number_of_aligned = contacts.places.size();
    const Soup_arrangement arrangement(points_of_soup, counted, contacts.places);
    points = arrangement.points;
    classify(arrangement);
    separate_contacts();
  }

  Positions points;                        // some stand for several vertices at the same place
  std::vector<Triangle_indices> triangles; // closed, oriented outwards, two at each edge
  std::vector<int> origin;                 // of each, a triangle of the parts
  std::size_t number_of_aligned = 0;       // vertices that were put into planes where parts touch
  std::size_t number_within = 0;           // faces that are inside, or bound nothing
  double volume_inside_out = 0;            // where the parts wind around less than 0 times
  Vector_3 place_inside_out = Vector_3::Zero();

private:
  using Sides = std::array<double, 2>; // in front, behind

  void classify(const Soup_arrangement& arrangement)
  {
    const std::vector<Triangle_indices>& faces = arrangement.faces;
    Disjoint_sets patches(faces.size());
    for_soup_edges(faces, [&](auto first, auto last) {
      if (last - first == 2 &&
          same_parts(arrangement.sources[first->triangle], arrangement.sources[(first + 1)->triangle]))
        patches.unite(first->triangle, (first + 1)->triangle);
    });
    std::map<std::size_t, std::vector<int>> of_patch;
    for (std::size_t f = 0; f < faces.size(); ++f)
      of_patch[patches.find(f)].push_back(static_cast<int>(f));
    for (auto& [root, members] : of_patch) {
      const int largest = *std::max_element(members.begin(), members.end(),
                                            [&](int a, int b) { return area(faces[a]) < area(faces[b]); });
      // in front and behind of the first source of each face, which all faces of a patch have from the same part
      const Sides sides = windings(faces[largest], arrangement.sources[largest]);
      for (int f : members)
        take(faces[f], arrangement.sources[f], sides);
    }
  }

  // Patches are pieces of the same parts, as often: so windings differ across their faces by as much.
  bool same_parts(const std::vector<Soup_arrangement::Source>& a, const std::vector<Soup_arrangement::Source>& b) const
  {
    if (a.size() != 1 || b.size() != 1)
      return false;
    return part_of(a[0]) == part_of(b[0]);
  }

  int part_of(const Soup_arrangement::Source& s) const { return parts_.part[triangle_of_counted_[s.triangle]]; }

  double area(const Triangle_indices& t) const
  {
    return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
  }

  // Around the middle of a face, in front and behind of its first source.
  Sides windings(const Triangle_indices& face, const std::vector<Soup_arrangement::Source>& sources) const
  {
    const Vector_3 middle = (points[face[0]] + points[face[1]] + points[face[2]]) / 3;
    std::map<int, std::vector<int>> left_out; // of each part
    std::map<int, double> jump;
    for (const Soup_arrangement::Source& s : sources) {
      left_out[part_of(s)].push_back(triangle_of_counted_[s.triangle]);
      jump[part_of(s)] += s.is_turned == sources[0].is_turned ? 1 : -1;
    }
    Sides sides = {0, 0};
    for (std::size_t p = 0; p < parts_.number_of_parts; ++p) {
      const auto found = left_out.find(static_cast<int>(p));
      const double winding = found == left_out.end() ? parts_.winding(static_cast<int>(p), middle)
                                                     : parts_.winding(static_cast<int>(p), middle, found->second);
      const double half = found == left_out.end() ? 0 : jump[static_cast<int>(p)] / 2;
      sides[0] += std::round(winding - half);
      sides[1] += std::round(winding + half);
    }
    return sides;
  }

  void take(Triangle_indices face, const std::vector<Soup_arrangement::Source>& sources, const Sides& sides)
  {
    if (sources[0].is_turned)
      std::swap(face[1], face[2]); // as the first source
    add_inside_out(face, sides);
    if ((sides[0] > 0) == (sides[1] > 0)) {
      ++number_within;
      return;
    }
    if (sides[0] > 0)
      std::swap(face[1], face[2]);
    triangles.push_back(face);
    origin.push_back(triangle_of_counted_[sources[0].triangle]);
  }

  void add_inside_out(const Triangle_indices& face, const Sides& sides)
  {
    if ((sides[0] < 0) == (sides[1] < 0))
      return;
    const double six = points[face[0]].dot(points[face[1]].cross(points[face[2]]));
    volume_inside_out += (sides[1] < 0 ? six : -six) / 6;
    place_inside_out = points[face[0]];
  }

  // Where more than two faces meet in an edge, those belong together that have inside between them; and a vertex gets a
  // copy for each fan of faces.
  void separate_contacts()
  {
    Disjoint_sets corners(3 * triangles.size());
    const auto corner = [&](int t, int v) {
      return std::size_t(3 * t) +
             std::size_t(std::find(triangles[t].begin(), triangles[t].end(), v) - triangles[t].begin());
    };
    for_soup_edges(triangles, [&](auto first, auto last) {
      std::vector<Soup_side> around(first, last);
      if (around.size() > 2)
        sort_around(around);
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Soup_side &a = around[i], &b = around[(i + 1) % around.size()];
        // sorted to turn left about the edge: inside is after a face that has the edge as it runs
        if (around.size() > 2 && !(has_inside_after(a) && !has_inside_after(b)))
          continue;
        for (int v : a.edge)
          corners.unite(corner(a.triangle, v), corner(b.triangle, v));
      }
    });
    std::map<std::size_t, int> copy;
    std::vector<char> is_used(points.size(), false);
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
      const std::size_t root = corners.find(i);
      int& v = triangles[i / 3][i % 3];
      const auto inserted = copy.emplace(root, v);
      if (inserted.second && is_used[v]) {
        inserted.first->second = static_cast<int>(points.size());
        points.push_back(Vector_3(points[v]));
        is_used.push_back(true);
      }
      else if (inserted.second)
        is_used[v] = true;
      v = inserted.first->second;
    }
  }

  // Turning left about the edge, what comes after the face is behind it: its normal looks back.
  static bool has_inside_after(const Soup_side& s) { return s.is_reversed; }

  void sort_around(std::vector<Soup_side>& around) const
  {
    const Vector_3 axis = (points[around[0].edge[1]] - points[around[0].edge[0]]).normalized();
    const Vector_3 u = axis.unitOrthogonal(), v = axis.cross(u);
    const auto angle = [&](const Soup_side& s) {
      int third = triangles[s.triangle][0];
      for (int w : triangles[s.triangle])
        if (w != s.edge[0] && w != s.edge[1])
          third = w;
      const Vector_3 d = points[third] - points[s.edge[0]];
      return std::atan2(d.dot(v), d.dot(u));
    };
    std::sort(around.begin(), around.end(),
              [&](const Soup_side& a, const Soup_side& b) { return angle(a) < angle(b); });
  }

  const Soup_parts& parts_;
  std::vector<int> triangle_of_counted_;
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_SOLID_BOUNDARY_H
