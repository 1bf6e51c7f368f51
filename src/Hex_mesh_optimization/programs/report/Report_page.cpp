// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#include "Report_page.h"

#include <CGAL/Hex_mesh_optimization/IO/internal/Atomic_file.h>
#include <CGAL/Hex_mesh_optimization/IO/internal/base64.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/boundary_surface.h>
#include <CGAL/Hex_mesh_optimization/internal/boundary/deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/engine/Optimization_parameters.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace HMO = CGAL::Hex_mesh_optimization;

namespace {

using HMO::internal::Vector_3;

const std::string_view place_of_title = "@title@", place_of_data = "@data@";

template <class Number>
std::string as_base64(const std::vector<Number>& numbers)
{
  std::string text;
  HMO::internal::IO::append_base64(text, std::string_view(reinterpret_cast<const char*>(numbers.data()),
                                                          numbers.size() * sizeof(Number)));
  return text;
}

std::vector<std::uint32_t> flat(const Report_page::Hexahedra& hexahedra)
{
  std::vector<std::uint32_t> result;
  result.reserve(8 * hexahedra.size());
  for (const auto& h : hexahedra)
    for (std::size_t v : h)
      result.push_back(static_cast<std::uint32_t>(v));
  return result;
}

std::string in_html(const std::string& text)
{
  std::string result;
  for (char c : text)
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else
      result += c;
  return result;
}

// No element of HTML begins or ends within it.
std::string in_script(const nlohmann::ordered_json& json)
{
  std::string result;
  // file names may be in any encoding
  for (char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

std::vector<std::array<int, 4>> outer_faces(const HMO::internal::Face_neighbors& neighbors)
{
  std::vector<std::array<int, 4>> quads;
  for (int side = 0; side < neighbors.number_of_sides(); ++side)
    if (neighbors.opposite(side) == HMO::internal::Face_neighbors::ALONE)
      quads.push_back(neighbors.vertices(side));
  return quads;
}

// From a surface, which must outlive the object.
class Distances
{
public:
  explicit Distances(const HMO::internal::Triangle_surface& surface) : surface_(surface) {}

  float operator()(const Vector_3& p)
  {
    const HMO::internal::Surface_point foot = surface_.closest_point(p, near_);
    near_ = foot.triangle; // the next point is not far
    return static_cast<float>((foot.point - p).norm());
  }

private:
  const HMO::internal::Triangle_surface& surface_;
  std::size_t near_ = HMO::internal::Surface_point::no_triangle;
};

} // namespace

std::string Report_page::reason_of_absence(const std::string& page)
{
  if (page.empty())
    return "this program was built without three.js (Debian: libjs-three), which the page of --report shows meshes "
           "with";
  return "";
}

void Report_page::set_reference(const Points& points, const std::vector<std::array<std::size_t, 3>>& triangles)
{
  HMO::internal::Positions positions;
  for (const auto& p : points)
    positions.emplace_back(p.x(), p.y(), p.z());
  std::vector<HMO::internal::Triangle_indices> indices;
  for (const auto& t : triangles)
    indices.push_back({{static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])}});
  reference_ = std::make_unique<HMO::internal::Triangle_surface>(std::move(positions), std::move(indices));
}

void Report_page::add_mesh(const std::string& role, const std::string& name, const Points& points,
                           const Hexahedra& hexahedra)
{
  points_.clear();
  for (const auto& p : points)
    points_.emplace_back(p.x(), p.y(), p.z());
  hexahedra_.clear();
  for (const auto& h : hexahedra) {
    hexahedra_.emplace_back();
    std::copy(h.begin(), h.end(), hexahedra_.back().begin());
  }
  Json mesh{{"role", role}, {"name", name}};
  if (meshes_.empty()) {
    Eigen::AlignedBox3d box;
    for (const Vector_3& p : points_)
      box.extend(p);
    origin_ = box.isEmpty() ? Vector_3(Vector_3::Zero()) : Vector_3(box.center());
    data_["origin"] = {origin_.x(), origin_.y(), origin_.z()};
  }
  mesh["points"] = in_base64(points);
  const HMO::internal::Face_neighbors neighbors(hexahedra_);
  if (meshes_.empty() || hexahedra != first_hexahedra_) {
    mesh["hexahedra"] = as_base64(flat(hexahedra));
    std::vector<std::int32_t> opposite;
    for (int side = 0; side < neighbors.number_of_sides(); ++side)
      opposite.push_back(neighbors.opposite(side));
    mesh["opposite_sides"] = as_base64(opposite);
  }
  if (meshes_.empty())
    first_hexahedra_ = hexahedra;
  const std::vector<double> jacobians = HMO::scaled_jacobians(points, hexahedra);
  mesh["scaled_jacobians"] = as_base64(std::vector<float>(jacobians.begin(), jacobians.end()));
  std::vector<std::size_t> invalid;
  HMO::invalid_hexahedra(points, hexahedra, std::back_inserter(invalid));
  mesh["invalid_hexahedra"] = as_base64(std::vector<std::uint32_t>(invalid.begin(), invalid.end()));
  add_deviations(mesh, neighbors);
  meshes_.push_back(std::move(mesh));
}

// At the vertices of the outer boundary, and at the centers of its faces, where both triangles of each meet.
void Report_page::add_deviations(Json& mesh, const HMO::internal::Face_neighbors& neighbors)
{
  if (!reference_)
    reference_ = std::make_unique<HMO::internal::Triangle_surface>(points_,
                                                                   HMO::internal::split_quads(outer_faces(neighbors)));
  if (reference_->is_empty())
    return;
  Distances distance(*reference_);
  const float none = -1;
  std::vector<float> of_vertices(points_.size(), none), of_sides;
  std::vector<std::uint32_t> sides;
  for (int side = 0; side < neighbors.number_of_sides(); ++side) {
    if (neighbors.opposite(side) != HMO::internal::Face_neighbors::ALONE)
      continue;
    for (int v : neighbors.vertices(side))
      if (of_vertices[v] == none)
        of_vertices[v] = distance(points_[v]);
    const std::array<int, 4> corners = neighbors.vertices(side);
    sides.push_back(static_cast<std::uint32_t>(side));
    of_sides.push_back(distance((points_[corners[0]] + points_[corners[2]]) / 2));
  }
  mesh["deviations"] = {{"of_vertices", as_base64(of_vertices)},
                        {"outer_sides", as_base64(sides)},
                        {"of_outer_sides", as_base64(of_sides)}};
}

void Report_page::add_reference(const std::string& name)
{
  const HMO::internal::Triangle_surface boundary(points_, HMO::internal::split_quads(
                                                            outer_faces(HMO::internal::Face_neighbors(hexahedra_))));
  if (boundary.is_empty())
    return;
  Distances distance(boundary);
  Points points; // those that triangles have
  std::vector<int> number(reference_->points.size(), -1);
  std::vector<std::uint32_t> triangles;
  std::vector<float> of_vertices, of_triangles;
  for (const HMO::internal::Triangle_indices& t : reference_->triangles) {
    Vector_3 center = Vector_3::Zero();
    for (int v : t) {
      const Vector_3& p = reference_->points[v];
      center += p / 3;
      if (number[v] < 0) {
        number[v] = static_cast<int>(points.size());
        points.emplace_back(p.x(), p.y(), p.z());
        of_vertices.push_back(distance(p));
      }
      triangles.push_back(static_cast<std::uint32_t>(number[v]));
    }
    of_triangles.push_back(distance(center));
  }
  data_["reference"] = {{"name", name},
                        {"points", in_base64(points)},
                        {"triangles", as_base64(triangles)},
                        {"deviations_of_vertices", as_base64(of_vertices)},
                        {"deviations_of_triangles", as_base64(of_triangles)}};
}

HMO::Deviation Report_page::deviation() const
{
  HMO::internal::Surface_faces faces;
  faces.quads = outer_faces(HMO::internal::Face_neighbors(hexahedra_));
  double sum = 0; // of the lengths of the edges, which have two faces each
  for (const std::array<int, 4>& q : faces.quads)
    for (int k = 0; k < 4; ++k)
      sum += (points_[q[(k + 1) % 4]] - points_[q[k]]).norm();
  const double mean = sum / (4 * double(faces.quads.size()));
  return HMO::internal::deviations(faces, points_, *reference_,
                                   HMO::internal::Optimization_parameters().measuring_spacing * mean)
    .all;
}

std::string Report_page::in_base64(const Points& points) const
{
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for (const auto& p : points)
    for (int c = 0; c < 3; ++c)
      numbers.push_back(static_cast<float>(p[c] - origin_[c]));
  return as_base64(numbers);
}

void Report_page::add_labels(const std::vector<int>& numbers)
{
  data_["labels"] = as_base64(std::vector<std::int32_t>(numbers.begin(), numbers.end()));
}

void Report_page::add_places(const std::string& key, const Points& points) { data_[key] = in_base64(points); }

void Report_page::write(const std::string& filename, const std::string& title, Json report) const
{
  Json data = data_;
  data["meshes"] = meshes_;
  data["report"] = std::move(report);
  const std::size_t title_at = page_.find(place_of_title), data_at = page_.find(place_of_data);
  HMO::internal::IO::Atomic_file file(filename);
  std::string& text = file.text();
  text = page_.substr(0, title_at) + in_html(title);
  text.append(page_, title_at + place_of_title.size(), data_at - title_at - place_of_title.size());
  text += in_script(data);
  text.append(page_, data_at + place_of_data.size(), std::string::npos);
  file.commit();
}

std::string command_line(int argc, const char* const* argv)
{
  const std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:%@";
  std::string result = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    result += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
      result += word;
      continue;
    }
    result += '\'';
    for (char c : word)
      if (c == '\'')
        result += "'\\''";
      else
        result += c;
    result += '\'';
  }
  return result;
}
