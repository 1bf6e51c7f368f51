// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_REPORT_PAGE_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_REPORT_PAGE_H

// The page that --report writes: what --json has, and the meshes, in one file of HTML that needs no other one.

#include "embedded_report_page.h"

#include <CGAL/Hex_mesh_optimization/Deviation.h>
#include <CGAL/Hex_mesh_optimization/internal/base/Vector_3.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/Face_neighbors.h>
#include <CGAL/Hex_mesh_optimization/internal/mesh/hexahedron.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_indices.h>
#include <CGAL/Hex_mesh_optimization/internal/surface/Triangle_surface.h>

#include <CGAL/Simple_cartesian.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class Report_page
{
public:
  using Json = nlohmann::ordered_json;
  using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
  using Hexahedra = std::vector<std::array<std::size_t, 8>>;

  // Why no page can be written; empty if one can.
  static std::string reason_of_absence(const std::string& page = embedded_report_page());

  explicit Report_page(std::string page = embedded_report_page()) : page_(std::move(page)) {}

  // The surface from which the deviations are measured. Without one, it is the outer boundary of the first mesh.
  void set_reference(const Points& points, const std::vector<std::array<std::size_t, 3>>& triangles);

  // role: "before", "after" or "compared", where the page finds the statistics. name: of the column, for people.
  void add_mesh(const std::string& role, const std::string& name, const Points& points, const Hexahedra& hexahedra);

  // The reference itself, with its distances from the outer boundary of the mesh that was added last.
  void add_reference(const std::string& name);

  // Of the outer boundary of the mesh that was added last, measured as the optimization does.
  CGAL::Hex_mesh_optimization::Deviation deviation() const;

  // More for the page, beside the report.
  void add(const std::string& key, Json value) { data_[key] = std::move(value); }
  void add_labels(const std::vector<int>& numbers);
  void add_places(const std::string& key, const Points& points);

  // title: of the window. report: what --json writes.
  void write(const std::string& filename, const std::string& title, Json report) const;

private:
  std::string in_base64(const Points& points) const;
  void add_deviations(Json& mesh, const CGAL::Hex_mesh_optimization::internal::Face_neighbors& neighbors);

  std::string page_;
  Json data_ = Json::object(), meshes_ = Json::array();
  std::unique_ptr<CGAL::Hex_mesh_optimization::internal::Triangle_surface> reference_;
  CGAL::Hex_mesh_optimization::internal::Vector_3 origin_; // the page has numbers of single precision
  Hexahedra first_hexahedra_;
  CGAL::Hex_mesh_optimization::internal::Positions points_; // of the mesh that was added last
  std::vector<CGAL::Hex_mesh_optimization::internal::Hexahedron> hexahedra_;
};

// As a shell reads it.
std::string command_line(int argc, const char* const* argv);

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_REPORT_PAGE_H
