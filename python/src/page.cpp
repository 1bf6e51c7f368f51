// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page.h"

#include "Report_page.h"
#include "arrays.h"
#include "status_report.h"

#include <CGAL/Hex_mesh_optimization/internal/interface/triangle_soup_to_reference.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace {

struct Shown_mesh
{
  std::string role, name;
  Points points;
  Report_page::Hexahedra hexahedra;
};

HMO::internal::Reference_input reference_of(const py::object& reference)
{
  const auto [vertices, triangles] = reference.cast<std::pair<py::array, py::array>>();
  return HMO::internal::triangle_soup_to_reference(point_range(Table(vertices)), cell_range<3>(Table(triangles)),
                                                   CGAL::parameters::default_values());
}

} // namespace

void write_page(const std::string& filename, const std::string& title, const std::vector<Named_mesh>& named_meshes,
                const py::object& reference, const std::vector<std::int64_t>& labels, const std::string& report,
                const std::string& why_it_stopped)
{
  const std::string reason = Report_page::reason_of_absence();
  if (!reason.empty())
    throw std::runtime_error(reason);
  const bool has_reference = !reference.is_none();
  HMO::internal::Reference_input surface;
  if (has_reference)
    surface = reference_of(reference);
  std::vector<Shown_mesh> meshes;
  for (const auto& [role, name, points, hexahedra] : named_meshes) {
    require_vertices(Table(hexahedra), Table(points).rows());
    meshes.push_back({role, name, points_of(points), hexahedra_of(hexahedra)});
  }

  const py::gil_scoped_release unlocked;
  Report_page page;
  if (has_reference) {
    Report_page::Points points;
    for (const HMO::internal::Vector_3& p : surface.points)
      points.emplace_back(p[0], p[1], p[2]);
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const auto& t : surface.triangles)
      triangles.push_back({{std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])}});
    page.set_reference(points, triangles);
  }
  for (const Shown_mesh& mesh : meshes)
    page.add_mesh(mesh.role, mesh.name, mesh.points, mesh.hexahedra);
  page.add_reference(has_reference ? "Reference" : "Boundary before");
  const Labels numbered(labels);
  if (numbered.values.size() > 1)
    page.add_labels(numbered.numbers);
  page.add("command", "Python, hex_mesh_optimization " CGAL_HEX_MESH_OPTIMIZATION_VERSION);
  if (!why_it_stopped.empty())
    page.add("why_it_stopped", why_it_stopped);
  Json all = Json::parse(report);
  if (!all["status"].contains("deviation"))
    all["status"]["deviation"] = json(page.deviation());
  page.write(filename, title, std::move(all));
}
