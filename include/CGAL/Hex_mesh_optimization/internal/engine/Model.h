// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H
#define CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H

#include <CGAL/license/Hex_mesh_optimization.h>

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
#include <CGAL/Hex_mesh_optimization/internal/engine/Reference_parts.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Edge_relations.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Target_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/target_edge_lengths.h>
#include <CGAL/Hex_mesh_optimization/internal/quality/Mesh_quality.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Reference_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_adjacency.h>
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
  // Throws Input_error. reference: null when the outer boundary of the mesh is its own reference. is_frozen: of the vertices
  // in the order of the caller. The mesh must outlive the object.
  Model(const Checked_mesh& checked, const Reference_input* reference, const std::vector<char>& is_frozen,
        const Optimization_parameters& parameters)
    : mesh(checked)
    , reference_is_given(is_one_given(reference, parameters.interface_references))
    , unit(checked_unit(mesh))
    , center(boundary_center(mesh, unit))
    , points(in_units(mesh.points))
    , given_points(mesh.surroundings.has_any() ? in_units(mesh.surroundings.given) : points)
    , faces(boundary_surface_faces(mesh.complex,
                                   !is_labelled(reference) && (reference_is_given || has_collapsed_face_outside()),
                                   labels_of(parameters.interface_references)))
    , surface(reference_is_given ? given_reference(reference, parameters) : own_reference(parameters.features))
    , attachment(attached(reference, is_frozen, parameters.fixed_boundary))
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
    mesh.translations.restore(mesh.points, result);
    return result;
  }

  const Checked_mesh& mesh;
  const bool reference_is_given; // for something it is not the mesh itself
  const double
    unit; // the boundary terms have units of length², so that all weights presuppose one: the mean boundary edge
  const Vector_3 center;
  const Positions points;       // of the mesh, in this unit, as is all that follows
  const Positions given_points; // as they came in: what the boundary and target lengths are those of
  const Surface_faces faces;
  const std::unique_ptr<const Reference_surface> surface;
  const Boundary_attachment attachment;
  const std::vector<char> is_fixed; // of the vertices
  const Edge_relations relations;
  const Target_lengths targets; // of the edges

private:
  // Of an edge whose length is asked for: far thinner than boundary layers are, but not nothing.
  static constexpr double least_input_length = 1e-5;

  // Throws Input_error if one cannot be used.
  static bool is_one_given(const Reference_input* reference, const std::vector<Interface_reference>& interfaces)
  {
    if (reference)
      require_usable(*reference, of_outside);
    for (const Interface_reference& i : interfaces)
      require_usable(i.surface, name_of(i));
    return reference || !interfaces.empty();
  }

  // Whether there is a reference for each of the surfaces, between two labels or outside of one.
  static bool is_labelled(const Reference_input* reference) { return reference && !reference->labels.empty(); }

  static void require_usable(const Reference_input& reference, const std::string& name)
  {
    using Element = Input_error::Element;
    for (std::size_t v = 0; v < reference.points.size(); ++v)
      if (!reference.points[v].allFinite())
        throw Input_error(Element::REFERENCE_VERTEX, v,
                          "vertex " + std::to_string(v) + " of " + name + " has a coordinate that is not finite");
    if (reference.triangles.empty())
      throw Input_error(Element::MESH, 0, name + " is empty");
  }

  static constexpr const char* of_outside = "the reference surface";

  static std::string name_of(const Interface_reference& reference)
  {
    return std::string(of_outside) + " between labels " + std::to_string(reference.labels[0]) + " and " +
           std::to_string(reference.labels[1]);
  }

  static std::vector<std::array<int, 2>> labels_of(const std::vector<Interface_reference>& interfaces)
  {
    std::vector<std::array<int, 2>> result;
    for (const Interface_reference& i : interfaces)
      result.push_back(i.labels);
    return result;
  }

  // In which the translations of vertices are checked as well.
  static double checked_unit(const Checked_mesh& mesh)
  {
    const double unit = mean_boundary_edge(mesh);
    mesh.translations.check(mesh.points, unit, [&](int v) { return mesh.order.given_vertex(v); });
    return unit;
  }

  static double mean_boundary_edge(const Checked_mesh& mesh)
  {
    const double mean = mesh.surroundings.has_any() ? mesh.surroundings.unit
                                                    : mean_boundary_edge_length(mesh.complex, mesh.points);
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
    return count > 0 ? Vector_3(sum / double(count) * unit) : mesh.points.front();
  }

  // reference: null for the mesh as it is.
  std::unique_ptr<const Reference_surface> given_reference(const Reference_input* reference,
                                                           const Optimization_parameters& parameters) const
  {
    Reference_parts parts(mesh.complex, faces, points, parameters.features);
    if (!reference)
      require_area_of_boundary();
    else {
      const Positions normalized = usable_places(*reference, of_outside);
      require_same_place(*reference, of_outside, true);
      if (is_labelled(reference))
        return labelled_reference(*reference, normalized, std::move(parts), parameters.features.angle_bound);
      parts.add_given(Reference_parts::outside, normalized, reference->triangles,
                      reference->sharp_is_given
                        ? reference->sharp
                        : sharp_edges(normalized, reference->triangles, parameters.features.angle_bound));
    }
    for (std::size_t i = 0; i < parameters.interface_references.size(); ++i) {
      const Interface_reference& given = parameters.interface_references[i];
      const auto sheet = std::lower_bound(faces.labels.begin(), faces.labels.end(), given.labels);
      if (sheet == faces.labels.end() || *sheet != given.labels)
        throw Input_error(Input_error::Element::PARAMETER, i, "there is no interface for " + name_of(given));
      require_same_place(given.surface, name_of(given), false);
      parts.add_given(static_cast<int>(sheet - faces.labels.begin()), usable_places(given.surface, name_of(given)),
                      given.surface.triangles, given.surface.sharp);
    }
    if (faces.labels.size() > 1)
      parts.add_mesh();
    return parts.joined(reference && reference->sharp_is_given);
  }

  // places: of the vertices
  std::unique_ptr<const Reference_surface> labelled_reference(const Reference_input& reference, const Positions& places,
                                                              Reference_parts parts, double angle_bound) const
  {
    Edge_list sharp = sharp_edges(places, reference.triangles, reference.sharp_is_given ? 180 : angle_bound);
    for (const std::array<int, 2>& e : reference.sharp)
      sharp.push_back(Triangle_adjacency::ordered(e));
    std::sort(sharp.begin(), sharp.end());
    sharp.erase(std::unique(sharp.begin(), sharp.end()), sharp.end());
    parts.add_labelled(places, reference.triangles, reference.labels, sharp);
    return parts.joined(reference.sharp_is_given);
  }

  // Those of the vertices, of which some triangle has an area.
  Positions usable_places(const Reference_input& reference, const std::string& name) const
  {
    Positions normalized = in_units(reference.points);
    require_area(normalized, reference.triangles, name + " has no face with an area that is not lost against the mesh");
    return normalized;
  }

  // Where it has, the faces outside are attached to all that is outside, whatever the labels: what has no area is no place
  // to stand on, and another of the same label may be far away.
  bool has_collapsed_face_outside() const
  {
    return std::any_of(mesh.complex.boundary_faces.begin(), mesh.complex.boundary_faces.end(),
                       [this](const Hexahedral_complex::Boundary_face& f) {
                         const std::array<int, 4>& v = f.vertices;
                         return f.beyond < 0 && (!Triangle_surface::has_area(points, {v[0], v[1], v[2]}) ||
                                                 !Triangle_surface::has_area(points, {v[0], v[2], v[3]}));
                       });
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
    if (mesh.surroundings.has_any()) // a part may have nothing of the boundary
      return boundary_of_part_as_reference(mesh.complex, faces, given_points, mesh.surroundings.features, features);
    require_area_of_boundary();
    return boundary_as_reference(mesh.complex, faces, points, features);
  }

  // reference: null unless there is one for the outer boundary
  Boundary_attachment attached(const Reference_input* reference, const std::vector<char>& is_frozen,
                               bool fixed_boundary) const
  {
    Boundary_attachment result = is_labelled(reference)
                                   ? Attachment_by_matching(mesh.complex, points, *surface).attachment
                                 : reference_is_given ? attached_to_given(reference != nullptr)
                                                      : attach_to_own_boundary(mesh.complex, *surface);
    result.set_sheets(faces);
    std::vector<char> stays = mesh.order.ordered(is_frozen);
    const std::vector<char> outside = vertices_outside();
    for (std::size_t v = 0; v < stays.size(); ++v)
      stays[v] = stays[v] || (fixed_boundary && outside[v]);
    mesh.complex.ties.unite(stays);
    for (std::size_t v = 0; v < stays.size(); ++v)
      if (stays[v])
        result.kind[v] = Vertex_kind::FIXED;
    return result;
  }

  Boundary_attachment attached_to_given(bool outside_is_given) const
  {
    const Positions matched = outside_is_given ? in_box_of_reference() : points;
    if (faces.labels.size() < 2)
      return Attachment_by_matching(mesh.complex, matched, *surface).attachment;
    // only what has nothing beyond is matched
    const int first = static_cast<int>(surface->points.size() - points.size());
    if (!outside_is_given) {
      Boundary_attachment result(mesh.complex);
      attach_by_identity(mesh.complex, *surface, first, result);
      return result;
    }
    const Hexahedral_complex whole(points.size(), mesh.complex.hexahedra);
    Boundary_attachment result = Attachment_by_matching(whole, matched, *surface, first).attachment;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (mesh.complex.is_on_boundary[v] && !whole.is_on_boundary[v])
        result.kind[v] = Vertex_kind::SURFACE;
    attach_by_identity(mesh.complex, *surface, first, result);
    return result;
  }

  // Where the mesh is compared with the reference: as it is, or stretched into the box of that if it is nearly on it then.
  Positions in_box_of_reference() const
  {
    constexpr double nearly = .1; // of the distance without
    Eigen::AlignedBox3d of_mesh, of_reference;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (mesh.complex.is_on_boundary[v])
        of_mesh.extend(points[v]);
    for (const Triangle_indices& t : surface->triangles)
      for (int v : t)
        of_reference.extend(surface->points[v]);
    if (!(of_mesh.sizes().minCoeff() > 0))
      return points;
    Positions stretched;
    for (const Vector_3& p : points)
      stretched.push_back(of_reference.min() +
                          (p - of_mesh.min()).cwiseQuotient(of_mesh.sizes()).cwiseProduct(of_reference.sizes()));
    return distance_from_surface(stretched) < nearly * distance_from_surface(points) ? stretched : points;
  }

  // The sum over the vertices of the boundary.
  double distance_from_surface(const Positions& places) const
  {
    double sum = 0;
    for (std::size_t v = 0; v < places.size(); ++v)
      if (mesh.complex.is_on_boundary[v])
        sum += (surface->closest_point(places[v], Surface_point::no_triangle, 0).point - places[v]).norm();
    return sum;
  }

  bool is_on_reference(double tolerance) const
  {
    for (std::size_t v = 0; reference_is_given && v < points.size(); ++v)
      if (mesh.complex.is_on_boundary[v]) {
        const Surface_point foot = surface->closest_point(points[v], Surface_point::no_triangle, attachment.sheet[v]);
        if (surface->way(points[v], foot).norm() > tolerance)
          return false;
      }
    return true;
  }

  void require_area_of_boundary() const
  {
    require_area(points, boundary_triangles(mesh.complex), "the boundary of the mesh has no face with an area");
  }

  static void require_area(const Positions& points, const std::vector<Triangle_indices>& triangles,
                           const std::string& message)
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

  // Refuses a reference that cannot belong to the mesh: it would take long to find nothing. has_its_size: it is one for
  // all of the outer boundary.
  void require_same_place(const Reference_input& reference, const std::string& name, bool has_its_size) const
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
    const bool has_other_size = has_its_size && !(e <= largest_ratio * d && d <= largest_ratio * e);
    const bool is_elsewhere = ((of_mesh.min() - of_reference.max()).array() > 2 * margin.array()).any() ||
                              ((of_reference.min() - of_mesh.max()).array() > 2 * margin.array()).any();
    if (!has_other_size && !is_elsewhere)
      return;
    std::ostringstream message;
    message << name << " is ";
    if (has_other_size)
      message << std::setprecision(4) << e / d << " times as large as the mesh";
    else
      message << "far away from the mesh";
    message << ": it spans " << in_words(of_reference) << ", the mesh " << in_words(of_mesh)
            << ": are both in the same " << (has_other_size ? "unit of length?" : "place?");
    throw Input_error(Input_error::Element::MESH, 0, message.str());
  }

  // The mean boundary edge; that of a larger mesh is 1.
  double own_unit() const
  {
    return mesh.surroundings.has_any() ? 1 : mean_boundary_edge_length(mesh.complex, given_points);
  }

  Target_lengths target_lengths(const Optimization_parameters& parameters) const
  {
    if (parameters.target_length || parameters.target_edge_lengths == Target_edge_lengths::INPUT)
      return lengths_asked_for(wanted_lengths(parameters));
    // lengths between boundaries that have to go elsewhere say nothing
    if (!is_on_reference(parameters.boundary.samples.tolerance))
      return guessed_lengths(estimate_edge_lengths(mesh.complex, relations, given_points, own_unit()));
    const Mesh_quality quality(mesh.complex, given_points);
    if (quality.inverted == 0)
      return own_edge_lengths(mesh.complex, relations, given_points, own_unit());
    std::vector<char> is_sound(quality.scaled_jacobians.size());
    std::transform(quality.scaled_jacobians.begin(), quality.scaled_jacobians.end(), is_sound.begin(),
                   [](double s) { return s > 0; });
    return lengths_along_sound_sheets(mesh.complex, relations, given_points, is_sound, own_unit());
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
    std::vector<double> of_input = edge_lengths(mesh.complex, given_points);
    for (double& l : of_input)
      l = (std::max)(l, least_input_length);
    return of_input;
  }
};

} // namespace CGAL::Hex_mesh_optimization::internal

#endif // CGAL_HEX_MESH_OPTIMIZATION_INTERNAL_ENGINE_MODEL_H
