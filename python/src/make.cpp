// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "optimize.h"
#include "options.h"
#include "status.h"

#include <CGAL/make_hex_mesh.h>

#include <optional>

namespace {

using Cells = std::vector<std::array<std::int64_t, 8>>;

template <class NamedParameters>
HMO::Meshing_status make_with(const Table& vertices, const Table& triangles, Points& points, Cells& hexahedra,
                              const NamedParameters& np)
{
  return CGAL::make_hex_mesh<CGAL::Parallel_if_available_tag>(point_range(vertices), cell_range<3>(triangles), points,
                                                              hexahedra, np);
}

// The engine knows their numbers.
Labels labels_of_faces(const py::dict& options)
{
  std::vector<std::int64_t> labels;
  if (options.contains("face_labels")) {
    const Table table(options["face_labels"].cast<py::array>());
    for (std::size_t t = 0; t < table.rows(); ++t)
      labels.push_back(table.index(t, 0));
  }
  return Labels(labels);
}

} // namespace

py::tuple make(const py::array& vertices, const py::array& triangles, const py::dict& options, int threads,
               const py::object& progress)
{
  const HMO::internal::Meshing_parameters defaults;
  const Table surface_points(vertices), surface_triangles(triangles);
  std::optional<std::set<Edge>> features;
  if (options.contains("edge_is_constrained_map"))
    features = feature_edges(Table(options["edge_is_constrained_map"].cast<py::array>()), surface_triangles);
  const Labels parts = labels_of_faces(options);
  Points points;
  Cells hexahedra;
  HMO::Meshing_status status;
  Watcher watcher(progress);
  const auto np = common_parameters(options, watcher)
                    .number_of_hexahedra(option(options, "number_of_hexahedra", defaults.number_of_hexahedra))
                    .grid_spacing(option(options, "grid_spacing", defaults.spacing))
                    .minimum_cells_across(option(options, "minimum_cells_across", defaults.minimum_cells_across));
  const auto make = [&](const auto& of_mesh) {
    status = parts.numbers.empty() ? make_with(surface_points, surface_triangles, points, hexahedra, of_mesh)
                                   : make_with(surface_points, surface_triangles, points, hexahedra,
                                               of_mesh.face_label_map(boost::make_function_property_map<std::size_t>(
                                                 [&](std::size_t t) { return parts.number(t); })));
  };
  run(watcher, threads, [&] {
    if (features)
      make(np.edge_is_constrained_map(
        boost::make_function_property_map<Edge>([&](const Edge& e) { return features->count(e) > 0; })));
    else
      make(np);
  });
  py::array cells = as_array(std::move(hexahedra));
  py::dict report = as_dict(status, points, Table(cells), parts, watcher);
  add_to(report, status, parts);
  watcher.finish(); // an interruption must not come between the result and its caller
  return py::make_tuple(as_array(std::move(points)), cells, report, watcher.is_interrupted());
}
