// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_SURFACES_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_SURFACES_H

#include <CGAL/license/Hex_mesh_optimization.h>

// What parts of a surface bound that stay apart: a region for each, and the surfaces between them and around them.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Meshing_status.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Disjoint_sets.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Contact_planes.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Solid_of_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_arrangement.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_edges.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/Soup_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/meshing/close_gaps.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

// What one part bounds alone: closed, oriented outwards.
struct Part_solid
{
  int label;
  std::vector<Triangle_indices> triangles;
  Eigen::AlignedBox3d box;
};

class Region_surfaces
{
public:
  // part: of each triangle, a label. Where several parts are, that of the highest label is. number, spacing: of the
  // hexahedra to be made; spacing may be 0. Throws Input_error unless each part bounds a volume.
  Region_surfaces(const Reference_input& given, const std::vector<int>& part, double number, double spacing)
  {
    surface.sharp_is_given = given.sharp_is_given;
    take_parts(given, part, number, spacing);
    close_gaps(number, spacing);
    for (const Part_solid& solid : solids)
      all_.insert(all_.end(), solid.triangles.begin(), solid.triangles.end());
    report_union(number, spacing);
    arrange();
    for (const Part_solid& solid : solids)
      describe(solid.label, number, spacing);
  }

  Positions points;                       // of the solids
  std::vector<Part_solid> solids;         // in increasing order of labels
  Reference_input surface;                // of all regions, each triangle once, with labels
  std::vector<std::size_t> face_of;       // of each of its triangles, a face of the surface as given
  std::vector<Material_report> materials; // what is left of each part
  Surface_report report;                  // of the union

private:
  using Source = Soup_arrangement::Source;

  void take_parts(const Reference_input& given, const std::vector<int>& part, double number, double spacing)
  {
    std::map<std::array<double, 3>, int> vertex_at;
    const std::set<int> labels(part.begin(), part.end());
    for (int label : labels) {
      if (label == Reference_input::no_label)
        throw Input_error(Input_error::Element::PARAMETER, 0,
                          "the label " + std::to_string(label) + " of faces stands for what is outside");
      Part_solid solid{label, {}, {}};
      std::vector<std::size_t> face; // of the surface as given, of each triangle
      const Reference_input alone = only(given, part, label, face);
      try {
        const Solid_of_surface of_part(alone, number, spacing);
        add_repairs(of_part.report);
        for (const Solid_of_surface::Body& body : of_part.bodies)
          add_body(body, face, solid, vertex_at);
      }
      catch (const Input_error& error) {
        throw Input_error(error.element(), error.element_index(),
                          "part " + std::to_string(label) + ": " + error.what());
      }
      solids.push_back(std::move(solid));
    }
  }

  // The triangles with a label.
  static Reference_input only(const Reference_input& given, const std::vector<int>& part, int label,
                              std::vector<std::size_t>& face)
  {
    Reference_input result = given;
    result.triangles.clear();
    for (std::size_t t = 0; t < given.triangles.size(); ++t)
      if (part[t] == label) {
        result.triangles.push_back(given.triangles[t]);
        face.push_back(t);
      }
    return result;
  }

  void add_body(const Solid_of_surface::Body& body, const std::vector<std::size_t>& face, Part_solid& solid,
                std::map<std::array<double, 3>, int>& vertex_at)
  {
    const auto vertex = [&](int v) {
      const Vector_3& p = body.surface.points[v];
      const auto inserted = vertex_at.emplace(std::array<double, 3>{p[0], p[1], p[2]}, static_cast<int>(points.size()));
      if (inserted.second)
        points.push_back(p);
      return inserted.first->second;
    };
    for (std::size_t t = 0; t < body.surface.triangles.size(); ++t) {
      const Triangle_indices& given = body.surface.triangles[t];
      const Triangle_indices triangle = {vertex(given[0]), vertex(given[1]), vertex(given[2])};
      for (int v : triangle)
        solid.box.extend(points[v]);
      solid.triangles.push_back(triangle);
      label_.push_back(solid.label);
      given_face_.push_back(face[body.face_of[t]]);
    }
    for (const std::array<int, 2>& e : body.surface.sharp)
      sharp_.insert(Triangle_adjacency::ordered({vertex(e[0]), vertex(e[1])}));
  }

  void add_repairs(const Surface_report& of_part)
  {
    report.number_of_reoriented_parts += of_part.number_of_reoriented_parts;
    report.number_of_copies += of_part.number_of_copies;
    report.number_without_area += of_part.number_without_area;
    report.number_of_stitched_vertices += of_part.number_of_stitched_vertices;
    report.number_of_faces_within += of_part.number_of_faces_within;
    report.farthest_moved = (std::max)(report.farthest_moved, of_part.farthest_moved);
    report.number_of_filled_holes += of_part.number_of_filled_holes;
    report.largest_filled_hole = (std::max)(report.largest_filled_hole, of_part.largest_filled_hole);
    report.number_of_small_components += of_part.number_of_small_components;
    report.volume_of_small_components += of_part.volume_of_small_components;
    report.number_of_parts += of_part.number_of_parts;
  }

  // Between parts with a curved surface in common.
  void close_gaps(double number, double spacing)
  {
    double volume = 0, area = 0;
    Eigen::AlignedBox3d box;
    for (const Part_solid& solid : solids) {
      volume += enclosed_volume(points, solid.triangles);
      area += surface_area(points, solid.triangles);
      box.extend(solid.box);
    }
    cell_ = spacing > 0 ? spacing : spacing_for(volume, area, number);
    constexpr double nearly = .1; // of a cell
    rounding_ = 3e-6 * box.diagonal().norm();
    // the later part's surface is that of both; where the earlier one has too large triangles, that of the earlier
    // one is
    const auto close = [&](Part_solid& part, const Part_solid& other, bool wins) {
      const Triangle_surface of_other(points, other.triangles);
      return internal::close_gaps(points, part.triangles, of_other, wins, nearly * cell_, rounding_);
    };
    for (std::size_t j = 1; j < solids.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (solids[i].box.intersects(solids[j].box)) {
          std::size_t moved = close(solids[i], solids[j], false);
          if (moved == 0)
            moved = close(solids[j], solids[i], true);
          report.number_of_aligned_vertices += moved;
        }
    for (Part_solid& solid : solids)
      for (const Triangle_indices& t : solid.triangles)
        for (int v : t)
          solid.box.extend(points[v]);
  }

  void report_union(double number, double spacing)
  {
    Reference_input all;
    all.points = points;
    all.triangles = all_;
    const Solid_of_surface whole(all, number, spacing);
    report.volume = whole.report.volume;
    report.area = whole.report.area;
    report.number_of_bodies = whole.report.number_of_bodies;
    report.euler_characteristic = whole.report.euler_characteristic;
  }

  void arrange()
  {
    const Contact_planes contacts(points, all_, label_, rounding_);
    report.number_of_aligned_vertices += contacts.places.size();
    const Soup_arrangement arrangement(points, all_, contacts.places);
    surface.points = arrangement.points;
    Disjoint_sets patches(arrangement.faces.size());
    for_soup_edges(arrangement.faces, [&](auto first, auto last) {
      if (last - first == 2 &&
          are_alike(arrangement.sources[first->triangle], arrangement.sources[(first + 1)->triangle]))
        patches.unite(first->triangle, (first + 1)->triangle);
    });
    std::map<std::size_t, std::vector<int>> of_patch;
    for (std::size_t f = 0; f < arrangement.faces.size(); ++f)
      of_patch[patches.find(f)].push_back(static_cast<int>(f));
    for (const auto& [root, members] : of_patch) {
      const int largest = *std::max_element(members.begin(), members.end(), [&](int a, int b) {
        return area_of(arrangement.faces[a]) < area_of(arrangement.faces[b]);
      });
      const std::array<int, 2> sides = regions_beside(arrangement.faces[largest], arrangement.sources[largest]);
      for (int f : members)
        take(arrangement.faces[f], arrangement.sources[f][0], sides);
    }
  }

  bool are_alike(const std::vector<Source>& a, const std::vector<Source>& b) const
  {
    return a.size() == 1 && b.size() == 1 && label_[a[0].triangle] == label_[b[0].triangle];
  }

  double area_of(const Triangle_indices& t) const
  {
    return (surface.points[t[1]] - surface.points[t[0]]).cross(surface.points[t[2]] - surface.points[t[0]]).norm();
  }

  // In front of the first source of a face, and behind it.
  std::array<int, 2> regions_beside(const Triangle_indices& face, const std::vector<Source>& sources) const
  {
    const Vector_3 middle = (surface.points[face[0]] + surface.points[face[1]] + surface.points[face[2]]) / 3;
    std::array<int, 2> result = {Reference_input::no_label, Reference_input::no_label};
    for (const Part_solid& solid : solids) {
      double jump = 0;
      std::set<Triangle_indices> left_out;
      for (const Source& s : sources)
        if (label_[s.triangle] == solid.label) {
          left_out.insert(all_[s.triangle]);
          jump += s.is_turned == sources[0].is_turned ? 1 : -1;
        }
      if (left_out.empty() && !solid.box.contains(middle))
        continue;
      double winding = 0;
      for (const Triangle_indices& t : solid.triangles)
        if (left_out.empty() || !left_out.count(t))
          winding += solid_angle(middle, points[t[0]], points[t[1]], points[t[2]]);
      for (int side : {0, 1})
        if (std::round(winding + (side == 0 ? -jump : jump) / 2) > 0)
          result[side] = solid.label; // the later ones win
    }
    return result;
  }

  // Seen from the region of the lower label, outwards.
  void take(Triangle_indices face, const Source& first, const std::array<int, 2>& sides)
  {
    if (sides[0] == sides[1])
      return;
    if (first.is_turned != (sides[0] < sides[1]))
      std::swap(face[1], face[2]);
    surface.triangles.push_back(face);
    surface.labels.push_back({(std::min)(sides[0], sides[1]), (std::max)(sides[0], sides[1])});
    face_of.push_back(given_face_[first.triangle]);
    const Triangle_indices& source = all_[first.triangle];
    for (int k = 0; k < 3 && !sharp_.empty(); ++k)
      if (sharp_.count(Triangle_adjacency::ordered({source[k], source[(k + 1) % 3]})))
        add_sharp(face, source[k], source[(k + 1) % 3]);
  }

  // Edges of a piece of a face that lie on an edge of that.
  void add_sharp(const Triangle_indices& face, int a, int b)
  {
    const Vector_3 along = points[b] - points[a];
    const auto is_on_edge = [&](int v) {
      const Vector_3 d = surface.points[v] - points[a];
      return (d - along.dot(d) / along.squaredNorm() * along).norm() < 1e-6 * along.norm();
    };
    for (int i = 0; i < 3; ++i)
      if (is_on_edge(face[i]) && is_on_edge(face[(i + 1) % 3]))
        surface.sharp.push_back({face[i], face[(i + 1) % 3]});
  }

  void describe(int label, double number, double spacing)
  {
    Material_report material;
    material.label = label;
    std::vector<Triangle_indices> around;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      Triangle_indices triangle = surface.triangles[t];
      if (surface.labels[t][1] == label)
        std::swap(triangle[1], triangle[2]);
      if (surface.labels[t][0] == label || surface.labels[t][1] == label)
        around.push_back(triangle);
    }
    material.volume = enclosed_volume(surface.points, around);
    material.area = surface_area(surface.points, around);
    if (!around.empty())
      set_topology(around, spacing > 0 ? spacing : cell_, number, material);
    materials.push_back(material);
  }

  // Where the region touches itself, each side keeps its own edges and vertices; what is less than a thousandth of a
  // cell does not count. Nothing is said of what cannot be told.
  void set_topology(const std::vector<Triangle_indices>& around, double cell, double number,
                    Material_report& material) const
  {
    Reference_input region;
    region.points = surface.points;
    region.triangles = around;
    try {
      const Solid_of_surface solid(region, number, cell);
      material.number_of_bodies = solid.report.number_of_bodies;
      material.euler_characteristic = solid.report.euler_characteristic;
    }
    catch (const Input_error&) { // then it has no bodies
    }
  }

  std::vector<Triangle_indices> all_; // triangles of the solids
  std::vector<int> label_;            // of each
  double rounding_ = 0;               // of parts that touch
  double cell_ = 0;                   // about as long as it will be
  std::vector<std::size_t> given_face_;
  std::set<std::array<int, 2>> sharp_; // edges
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_MESHING_REGION_SURFACES_H
