// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "optimize.h"

#include "options.h"
#include "status.h"

#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/optimize_hex_mesh.h>

#include <map>
#include <optional>
#include <tuple>

namespace {

using Tag = CGAL::Parallel_if_available_tag;
using Soup = std::pair<Points, std::vector<std::array<std::int64_t, 3>>>;
using Interfaces = std::vector<std::pair<std::array<int, 2>, Soup>>;
using Periodic_pairs = std::vector<std::tuple<std::size_t, std::size_t, Kernel::Vector_3>>;

template <std::size_t n>
std::vector<std::array<std::int64_t, n>> cells(const Table& table)
{
  const auto range = cell_range<n>(table);
  return {range.begin(), range.end()};
}

std::optional<Table> table_of(const py::dict& options, const char* name)
{
  if (!options.contains(name))
    return std::nullopt;
  return Table(options[name].cast<py::array>());
}

Labels labels_of(const py::dict& options)
{
  std::vector<std::int64_t> labels;
  if (const auto table = table_of(options, "labels"))
    for (std::size_t h = 0; h < table->rows(); ++h)
      labels.push_back(table->index(h, 0));
  return Labels(labels);
}

// Between the numbers of labels.
Interfaces interfaces_of(const py::dict& options, const Labels& labels)
{
  Interfaces result;
  if (!options.contains("interface_references"))
    return result;
  for (const py::handle& entry : options["interface_references"]) {
    const auto [a, b, points, triangles] = entry.cast<std::tuple<std::int64_t, std::int64_t, py::array, py::array>>();
    for (std::int64_t label : {a, b})
      if (!std::binary_search(labels.values.begin(), labels.values.end(), label))
        throw HMO::Input_error(HMO::Input_error::Element::PARAMETER, result.size(),
                               "interface_references: no hexahedron has the label " + std::to_string(label));
    const auto range = point_range(Table(points));
    result.push_back({{labels.number_of(a), labels.number_of(b)},
                      Soup(Points(range.begin(), range.end()), cells<3>(Table(triangles)))});
  }
  return result;
}

Periodic_pairs periodic_pairs_of(const py::dict& options)
{
  Periodic_pairs result;
  if (!options.contains("periodic_vertices"))
    return result;
  const auto [pairs, translations] = options["periodic_vertices"].cast<std::pair<py::array, py::array>>();
  const Table vertices(pairs), vectors(translations);
  for (std::size_t i = 0; i < vertices.rows(); ++i)
    result.emplace_back(static_cast<std::size_t>(vertices.index(i, 0)), static_cast<std::size_t>(vertices.index(i, 1)),
                        Kernel::Vector_3(vectors.number(i, 0), vectors.number(i, 1), vectors.number(i, 2)));
  return result;
}

// Of each edge that is given, or nothing if none is.
std::optional<std::map<Edge, double>> lengths_of(const py::dict& options)
{
  if (!options.contains("target_edge_length_map"))
    return std::nullopt;
  const auto [edges, lengths] = options["target_edge_length_map"].cast<std::pair<py::array, py::array>>();
  const Table vertices(edges), numbers(lengths);
  std::map<Edge, double> result;
  for (std::size_t i = 0; i < vertices.rows(); ++i)
    result[edge_of(vertices.index(i, 0), vertices.index(i, 1))] = numbers.number(i, 0);
  return result;
}

// Throws what Python gets as a ValueError unless each edge of a hexahedron has a length.
void require_lengths(const std::map<Edge, double>& lengths, const Table& hexahedra)
{
  static const int edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                   {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  for (const auto& h : cell_range<8>(hexahedra))
    for (const auto& [a, b] : edges) {
      const Edge edge = edge_of(h[static_cast<std::size_t>(a)], h[static_cast<std::size_t>(b)]);
      if (lengths.count(edge) == 0)
        throw py::value_error("target_edge_length_map: there is no length for the edge between the vertices " +
                              std::to_string(edge.first) + " and " + std::to_string(edge.second));
    }
}

// Everything that is read of Python's objects before the run.
struct Input
{
  Table hexahedra;
  Labels labels;
  Interfaces interfaces;
  Periodic_pairs periodic_pairs;
  std::optional<std::map<Edge, double>> lengths;
  std::optional<Table> is_constrained, internal_faces, reference_points, reference_triangles;
  std::optional<std::set<Edge>> features;

  Input(const py::array& hexes, const py::object& reference, const py::dict& options)
    : hexahedra(hexes)
    , labels(labels_of(options))
    , interfaces(interfaces_of(options, labels))
    , periodic_pairs(periodic_pairs_of(options))
    , lengths(lengths_of(options))
    , is_constrained(table_of(options, "vertex_is_constrained_map"))
    , internal_faces(table_of(options, "internal_faces"))
  {
    if (lengths)
      require_lengths(*lengths, hexahedra);
    if (reference.is_none())
      return;
    const auto [points, triangles] = reference.cast<std::pair<py::array, py::array>>();
    reference_points.emplace(points);
    reference_triangles.emplace(triangles);
    if (const auto edges = table_of(options, "edge_is_constrained_map"))
      features = feature_edges(*edges, *reference_triangles);
  }
};

template <class NamedParameters>
HMO::Status optimize_with(const Input& in, Points& points, const NamedParameters& np)
{
  const auto hexahedra = cell_range<8>(in.hexahedra);
  if (!in.reference_points)
    return CGAL::optimize_hex_mesh<Tag>(points, hexahedra, np);
  const auto reference_points = point_range(*in.reference_points);
  const auto triangles = cell_range<3>(*in.reference_triangles);
  if (!in.features)
    return CGAL::optimize_hex_mesh<Tag>(points, hexahedra, reference_points, triangles, np);
  return CGAL::optimize_hex_mesh<Tag>(
    points, hexahedra, reference_points, triangles, np,
    CGAL::parameters::edge_is_constrained_map(boost::make_function_property_map<Edge>(
      [&](const Edge& e) { return in.features->count(edge_of(std::int64_t(e.first), std::int64_t(e.second))) > 0; })));
}

HMO::Status optimize_all(const Input& in, const py::dict& options, Points& points, Watcher& watcher, int threads)
{
  const auto np = common_parameters(options, watcher)
                    .hexahedron_label_map(boost::make_function_property_map<std::size_t>(
                      [&](std::size_t h) { return in.labels.number(h); }))
                    .vertex_is_constrained_map(boost::make_function_property_map<std::size_t>(
                      [&](std::size_t v) { return in.is_constrained && in.is_constrained->index(v, 0) != 0; }))
                    .internal_faces(in.internal_faces ? cells<4>(*in.internal_faces)
                                                      : std::vector<std::array<std::int64_t, 4>>())
                    .interface_references(in.interfaces)
                    .periodic_vertices(in.periodic_pairs);
  HMO::Status status;
  run(watcher, threads, [&] {
    status = in.lengths
               ? optimize_with(in, points,
                               np.target_edge_length_map(boost::make_function_property_map<Edge>([&](const Edge& e) {
                                 return in.lengths->at(edge_of(std::int64_t(e.first), std::int64_t(e.second)));
                               })))
               : optimize_with(in, points, np);
  });
  return status;
}

} // namespace

py::tuple optimize(const py::array& points, const py::array& hexahedra, const py::object& reference,
                   const py::dict& options, int threads, const py::object& progress)
{
  const auto given = point_range(Table(points));
  Points result(given.begin(), given.end());
  const Input input(hexahedra, reference, options);
  Watcher watcher(progress);
  const HMO::Status status = optimize_all(input, options, result, watcher, threads);
  const py::dict report = as_dict(status, result, input.hexahedra, input.labels, watcher);
  watcher.finish(); // an interruption must not come between the result and its caller
  return py::make_tuple(as_array(std::move(result)), report, watcher.is_interrupted());
}
