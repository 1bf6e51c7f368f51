// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H

// What a run works with: positions in a unit of length of the mesh, the reference, what
// each vertex is attached to, and target lengths.

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/enum.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Attachment_by_matching.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/Boundary_attachment.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Checked_mesh.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_input.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Target_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Rims.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/sharp_edges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Hex_mesh_optimization::internal {

class Model
{
public:
  // Throws Input_error. reference: null when the boundary of the mesh is its own reference. is_frozen: of the vertices
  // in the order of the caller. The mesh must outlive the object.
  Model(const Checked_mesh& checked, const Reference_input* reference, const std::vector<char>& is_frozen,
        const Optimization_parameters& parameters)
    : mesh(checked)
    , reference_is_given(is_given(reference))
    , unit(mean_boundary_edge(mesh))
    , center(boundary_center(mesh, unit))
    , points(in_units(mesh.points))
    , faces(boundary_surface_faces(mesh.complex, reference_is_given))
    , surface(reference ? given_reference(*reference, parameters.features) : own_reference(parameters.features))
    , attachment(attached(is_frozen, parameters.fixed_boundary))
    , is_fixed(attachment.fixed_vertices())
    , relations(mesh.complex)
    , targets(target_lengths(parameters))
  {}

  Positions in_units(const Positions& positions) const
  {
    Positions result;
    result.reserve(positions.size());
    for (const Vector_3& p : positions)
      result.push_back((p - center) / unit);
    return result;
  }

  // In the coordinates of the input. What has not moved is not rounded.
  Positions in_coordinates(const Positions& positions) const
  {
    Positions result = mesh.points;
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (!is_fixed[v] && positions[v] != points[v])
        result[v] = positions[v] * unit + center;
    return result;
  }

  const Checked_mesh& mesh;
  const bool reference_is_given; // it is not the boundary of the mesh itself
  const double
    unit; // the boundary terms have units of length², so that all weights presuppose one: the mean boundary edge
  const Vector_3 center;
  const Positions points; // of the mesh, in this unit, as is all that follows
  const Surface_faces faces;
  const std::unique_ptr<const Reference_surface> surface;
  const Boundary_attachment attachment;
  const std::vector<char> is_fixed; // of the vertices
  const Edge_relations relations;
  const Target_lengths targets; // of the edges

private:
  // Of an edge whose length is asked for: far thinner than boundary layers are, but not nothing.
  static constexpr double least_input_length = 1e-5;

  // Throws Input_error if it cannot be used.
  static bool is_given(const Reference_input* reference)
  {
    using Element = Input_error::Element;
    if (!reference)
      return false;
    for (std::size_t v = 0; v < reference->points.size(); ++v)
      if (!reference->points[v].allFinite())
        throw Input_error(Element::REFERENCE_VERTEX, v,
                          "vertex " + std::to_string(v) +
                            " of the reference surface has a coordinate that is not finite");
    if (reference->triangles.empty())
      throw Input_error(Element::MESH, 0, "the reference surface is empty");
    return true;
  }

  static double mean_boundary_edge(const Checked_mesh& mesh)
  {
    const double mean = mean_boundary_edge_length(mesh.complex, mesh.points);
    if (!(mean > 0) || !std::isfinite(mean))
      throw Input_error(Input_error::Element::MESH, 0,
                        "all vertices of the boundary lie in one point, or too far apart for their coordinates");
    return mean;
  }

  static Vector_3 boundary_center(const Checked_mesh& mesh, double unit)
  {
    Vector_3 sum = Vector_3::Zero();
    std::size_t count = 0;
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.complex.is_on_boundary[v]) {
        sum += mesh.points[v] / unit;
        ++count;
      }
    return sum / double(count) * unit;
  }

  std::unique_ptr<const Reference_surface> given_reference(const Reference_input& reference,
                                                           const Feature_parameters& features) const
  {
    Positions normalized = in_units(reference.points);
    require_area(normalized, reference.triangles,
                 "the reference surface has no face with an area that is not lost against the mesh");
    require_same_place(reference);
    Edge_list sharp = reference.sharp_is_given ? reference.sharp
                                               : sharp_edges(normalized, reference.triangles, features.angle_bound);
    std::vector<Triangle_indices> triangles = reference.triangles;
    std::vector<int> sheets;
    std::vector<std::size_t> rims;
    if (faces.labels.size() > 1)
      append_interfaces(features.angle_bound, normalized, triangles, sheets, rims, sharp);
    Rims its_rims(triangles, sheets, rims, Beyond_rim::PLANE);
    return std::make_unique<const Reference_surface>(std::move(normalized), std::move(triangles), std::move(sharp),
                                                     reference.sharp_is_given, features, std::move(sheets),
                                                     std::vector<int>(), std::move(its_rims));
  }

  // To a reference for what has nothing beyond, what is between regions, as it is. Where an interface ends at the outer
  // boundary it goes along with that; no curve holds it where it was. rims: as Rims takes them
  void append_interfaces(double angle_bound, Positions& reference_points, std::vector<Triangle_indices>& triangles,
                         std::vector<int>& sheets, std::vector<std::size_t>& rims, Edge_list& sharp) const
  {
    const int first = static_cast<int>(reference_points.size());
    reference_points.insert(reference_points.end(), points.begin(), points.end());
    sheets.assign(triangles.size(), 0);
    const std::vector<Triangle_indices> of_faces = split_quads(faces.quads);
    const Rims of_mesh = triangle_rims(faces);
    std::vector<char> is_outside(points.size(), false);
    for (std::size_t f = 0; f < faces.quads.size(); ++f)
      if (mesh.complex.boundary_faces[f].beyond < 0)
        for (int v : faces.quads[f])
          is_outside[v] = true;
      else
        for (std::size_t t : {2 * f, 2 * f + 1}) {
          const Triangle_indices& vertices = of_faces[t];
          for (int k = 0; k < 3; ++k)
            if (of_mesh.has(t, k))
              rims.push_back(3 * triangles.size() + k);
          triangles.push_back({vertices[0] + first, vertices[1] + first, vertices[2] + first});
          sheets.push_back(faces.sheet(static_cast<int>(f)));
        }
    for (const std::array<int, 2>& e : sharp_boundary_edges(mesh.complex, points, angle_bound))
      if (!is_outside[e[0]] && !is_outside[e[1]])
        sharp.push_back({e[0] + first, e[1] + first});
  }

  // Whether a vertex has a face with nothing beyond.
  std::vector<char> vertices_outside() const
  {
    std::vector<char> result(points.size(), false);
    for (const Hexahedral_complex::Boundary_face& f : mesh.complex.boundary_faces)
      for (int k = 0; k < 4 && f.beyond < 0; ++k)
        result[f.vertices[k]] = true;
    return result;
  }

  std::unique_ptr<const Reference_surface> own_reference(const Feature_parameters& features) const
  {
    require_area(points, boundary_triangles(mesh.complex), "the boundary of the mesh has no face with an area");
    return boundary_as_reference(mesh.complex, faces, points, features);
  }

  Boundary_attachment attached(const std::vector<char>& is_frozen, bool fixed_boundary) const
  {
    Boundary_attachment result = reference_is_given ? attached_to_given()
                                                    : attach_to_own_boundary(mesh.complex, *surface);
    result.set_sheets(faces);
    const std::vector<char> frozen = mesh.order.ordered(is_frozen), outside = vertices_outside();
    for (std::size_t v = 0; v < frozen.size(); ++v)
      if (frozen[v] || (fixed_boundary && outside[v]))
        result.kind[v] = Vertex_kind::FIXED;
    return result;
  }

  Boundary_attachment attached_to_given() const
  {
    if (faces.labels.size() < 2)
      return Attachment_by_matching(mesh.complex, points, *surface).attachment;
    // only what has nothing beyond is matched
    const int first = static_cast<int>(surface->points.size() - points.size());
    const Hexahedral_complex whole(points.size(), mesh.complex.hexahedra);
    Boundary_attachment result = Attachment_by_matching(whole, points, *surface, first).attachment;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (mesh.complex.is_on_boundary[v] && !whole.is_on_boundary[v])
        result.kind[v] = Vertex_kind::SURFACE;
    attach_by_identity(mesh.complex, *surface, first, result);
    return result;
  }

  bool is_on_reference(double tolerance) const
  {
    for (std::size_t v = 0; reference_is_given && v < points.size(); ++v)
      if (mesh.complex.is_on_boundary[v] &&
          (surface->closest_point(points[v], Surface_point::no_hint, attachment.sheet[v]).point - points[v]).norm() >
            tolerance)
        return false;
    return true;
  }

  static void require_area(const Positions& points, const std::vector<Triangle_indices>& triangles, const char* message)
  {
    if (std::none_of(triangles.begin(), triangles.end(),
                     [&](const Triangle_indices& t) { return Triangle_surface::has_area(points, t); }))
      throw Input_error(Input_error::Element::MESH, 0, message);
  }

  // What a box spans, as words.
  static std::string in_words(const Eigen::AlignedBox3d& box)
  {
    std::ostringstream out;
    const auto corner = [&](const Vector_3& p) { out << '(' << p[0] << ' ' << p[1] << ' ' << p[2] << ')'; };
    corner(box.min());
    out << " to ";
    corner(box.max());
    return out.str();
  }

  // Refuses a reference that cannot belong to the mesh: it would take long to find nothing.
  void require_same_place(const Reference_input& reference) const
  {
    constexpr double largest_ratio = 3;    // of the diagonals
    constexpr double largest_offset = .25; // by which both boxes are enlarged, in larger diagonals
    Eigen::AlignedBox3d of_mesh, of_reference;
    const std::vector<char> outside = vertices_outside();
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (outside[v])
        of_mesh.extend(mesh.points[v]);
    for (const Triangle_indices& t : reference.triangles)
      for (int v : t)
        of_reference.extend(reference.points[v]);
    const double d = of_mesh.diagonal().stableNorm(), e = of_reference.diagonal().stableNorm();
    const Vector_3 margin = Vector_3::Constant(largest_offset * (std::max)(d, e));
    const bool has_other_size = !(e <= largest_ratio * d && d <= largest_ratio * e);
    const bool is_elsewhere = ((of_mesh.min() - of_reference.max()).array() > 2 * margin.array()).any() ||
                              ((of_reference.min() - of_mesh.max()).array() > 2 * margin.array()).any();
    if (!has_other_size && !is_elsewhere)
      return;
    std::ostringstream message;
    message << "the reference surface is ";
    if (has_other_size)
      message << std::setprecision(4) << e / d << " times as large as the mesh";
    else
      message << "far away from the mesh";
    message << ": it spans " << in_words(of_reference) << ", the mesh " << in_words(of_mesh)
            << ": are both in the same " << (has_other_size ? "unit of length?" : "place?");
    throw Input_error(Input_error::Element::MESH, 0, message.str());
  }

  Target_lengths target_lengths(const Optimization_parameters& parameters) const
  {
    if (parameters.target_length || parameters.target_edge_lengths == Target_edge_lengths::INPUT)
      return lengths_asked_for(wanted_lengths(parameters));
    // lengths between boundaries that have to go elsewhere say nothing
    if (!is_on_reference(parameters.boundary.samples.tolerance))
      return guessed_lengths(estimate_edge_lengths(mesh.complex, relations, points));
    const Mesh_quality quality(mesh.complex, points);
    if (quality.inverted == 0)
      return own_edge_lengths(mesh.complex, relations, points);
    std::vector<char> is_sound(quality.scaled_jacobians.size());
    std::transform(quality.scaled_jacobians.begin(), quality.scaled_jacobians.end(), is_sound.begin(),
                   [](double s) { return s > 0; });
    return lengths_along_sound_sheets(mesh.complex, relations, points, is_sound);
  }

  std::vector<double> wanted_lengths(const Optimization_parameters& parameters) const
  {
    if (parameters.target_length) {
      // asked for in the order that edges have with the caller's vertices
      std::vector<std::pair<std::array<int, 2>, std::size_t>> given_edges;
      for (std::size_t e = 0; e < mesh.complex.edges.size(); ++e) {
        const auto [low, high] = std::minmax(
          {mesh.order.given_vertex(mesh.complex.edges[e][0]), mesh.order.given_vertex(mesh.complex.edges[e][1])});
        given_edges.push_back({{low, high}, e});
      }
      std::sort(given_edges.begin(), given_edges.end());
      std::vector<double> of_caller(mesh.complex.edges.size());
      for (std::size_t i = 0; i < given_edges.size(); ++i) {
        const auto& [vertices, e] = given_edges[i];
        const double given = parameters.target_length(vertices[0], vertices[1]);
        if (!(given > 0) || !std::isfinite(given))
          throw Input_error(Input_error::Element::PARAMETER, i,
                            "the target length of the edge from vertex " + std::to_string(vertices[0]) + " to vertex " +
                              std::to_string(vertices[1]) + " is not positive and finite");
        of_caller[e] = given / unit;
      }
      return of_caller;
    }
    std::vector<double> of_input = edge_lengths(mesh.complex, points);
    for (double& l : of_input)
      l = (std::max)(l, least_input_length);
    return of_input;
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H
