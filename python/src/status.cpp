// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "status.h"

#include <string>

namespace {

py::dict as_dict(const HMO::Deviation& d)
{
  py::dict result;
  result["average"] = d.average;
  result["maximum"] = d.maximum;
  result["average_relative"] = d.average_relative;
  result["maximum_relative"] = d.maximum_relative;
  result["certified"] = d.certified;
  result["bilinear"] = d.bilinear;
  return result;
}

const char* name(HMO::Connectivity_limit_reason reason)
{
  using Reason = HMO::Connectivity_limit_reason;
  switch (reason) {
  case Reason::FLAT_EDGE:
    return "FLAT_EDGE";
  case Reason::FLAT_CURVE:
    return "FLAT_CURVE";
  case Reason::INTERIOR_EDGE:
    return "INTERIOR_EDGE";
  case Reason::INTERIOR_VERTEX:
    return "INTERIOR_VERTEX";
  case Reason::CURVE_VERTEX:
    return "CURVE_VERTEX";
  case Reason::SMOOTH_EDGE:
    return "SMOOTH_EDGE";
  case Reason::SMOOTH_VERTEX:
    return "SMOOTH_VERTEX";
  }
  return "";
}

py::list attempts(const HMO::Status& status)
{
  py::list result;
  for (const HMO::Attempt& a : status.attempts)
    result.append(
      py::make_tuple(a.name, a.is_taken, a.iterations, a.seconds, a.number_of_inverted, a.minimum, a.average));
  return result;
}

py::list volume_changes(const HMO::Status& status, const Labels& labels)
{
  py::list result;
  for (const HMO::Volume_change& c : status.volume_changes)
    result.append(py::make_tuple(labels.value(c.label), c.hexahedron, c.number_of_hexahedra, c.before, c.after));
  return result;
}

py::list limits(const HMO::Status& status)
{
  py::list result;
  for (const HMO::Connectivity_limit& l : status.connectivity_limits)
    result.append(py::make_tuple(l.hexahedron, name(l.reason), l.largest_scaled_jacobian, l.scaled_jacobian));
  return result;
}

py::list regions(const HMO::Status& status, const Labels& labels)
{
  py::list result;
  for (const HMO::Region_volume& r : status.regions)
    result.append(py::make_tuple(labels.value(r.label), r.before, r.after));
  return result;
}

py::list interfaces(const HMO::Status& status, const Labels& labels)
{
  py::list result;
  for (const HMO::Interface_statistics& i : status.interfaces)
    result.append(py::make_tuple(py::make_tuple(labels.value(i.labels[0]), labels.value(i.labels[1])),
                                 i.number_of_faces, as_dict(i.deviation)));
  return result;
}

py::list history(const Watcher& watcher)
{
  py::list result;
  for (const HMO::Iteration& i : watcher.iterations())
    result.append(py::make_tuple(json(i.stage).get<std::string>(), i.iteration, i.energy, i.number_of_inverted,
                                 i.minimum, i.average, i.seconds));
  return result;
}

} // namespace

py::dict as_dict(const HMO::Quality_statistics& s)
{
  py::dict result;
  result["number_of_hexahedra"] = s.number_of_hexahedra;
  result["number_of_inverted"] = s.number_of_inverted;
  result["number_of_invalid"] = s.number_of_invalid;
  result["minimum"] = s.minimum;
  result["average"] = s.average;
  result["standard_deviation"] = s.standard_deviation;
  result["minimum_with_center"] = s.minimum_with_center;
  result["average_with_center"] = s.average_with_center;
  result["maximum_edge_ratio"] = s.maximum_edge_ratio;
  result["median_edge_ratio"] = s.median_edge_ratio;
  result["edge_ratio_99"] = s.edge_ratio_99;
  return result;
}

py::dict as_dict(const HMO::Status& s, const Points& points, const Table& hexahedra, const Labels& labels,
                 const Watcher& watcher)
{
  const auto center = [&](std::size_t h) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (std::int64_t v : Cell_of_row<8>{hexahedra}(h))
      sum = sum + (points[static_cast<std::size_t>(v)] - CGAL::ORIGIN) / 8;
    return CGAL::ORIGIN + sum;
  };
  py::dict result;
  result["return_code"] = json(s.return_code).get<std::string>();
  result["before"] = as_dict(s.before);
  result["after"] = as_dict(s.after);
  result["deviation"] = as_dict(s.deviation);
  result["regions"] = regions(s, labels);
  result["interfaces"] = interfaces(s, labels);
  result["volume_before"] = s.volume_before;
  result["volume_after"] = s.volume_after;
  result["volume_changes"] = volume_changes(s, labels);
  result["volume_changes_in_words"] = in_words(s.volume_changes, labels);
  result["deviation_bound"] = s.deviation_bound;
  result["iterations"] = s.iterations;
  result["attempts"] = attempts(s);
  result["rectification_seconds"] = s.rectification_seconds;
  result["untangling_seconds"] = s.untangling_seconds;
  result["maximization_seconds"] = s.maximization_seconds;
  result["total_seconds"] = s.total_seconds;
  result["invalid_hexahedra"] = as_array(s.invalid_hexahedra);
  result["locked_hexahedra"] = as_array(s.locked_hexahedra);
  result["vertices_off_reference"] = as_array(s.vertices_off_reference);
  result["connectivity_limits"] = limits(s);
  result["reoriented_hexahedra"] = as_array(s.reoriented_hexahedra);
  result["number_of_coincident_vertices"] = s.number_of_coincident_vertices;
  result["history"] = history(watcher);
  result["why_it_stopped"] = in_words(s.return_code);
  py::list rows;
  for (const Report_row& row : table(s, labels))
    rows.append(py::make_tuple(row.title, row.before, row.after));
  result["table"] = rows;
  result["report"] = with_iterations({{"status", json(s, center, labels)}}, watcher.iterations()).dump();
  return result;
}

void add_to(py::dict& dict, const HMO::Meshing_status& status, const Labels& labels)
{
  dict["spacing"] = status.spacing;
  dict["has_topology_of_surface"] = status.has_topology_of_surface;
  dict["matches_surface"] = status.matches_surface();
  dict["number_of_bodies"] = status.number_of_bodies;
  dict["euler_characteristic"] = status.euler_characteristic;
  dict["volume_of_surface"] = status.surface.volume;
  dict["thin_faces"] = as_array(status.thin_faces);
  std::vector<std::int64_t> of_hexahedra;
  for (int number : status.labels)
    of_hexahedra.push_back(labels.value(number));
  dict["labels"] = as_array(std::move(of_hexahedra));
  py::list parts;
  for (const HMO::Material_report& part : status.materials)
    parts.append(py::make_tuple(labels.value(part.label), part.volume, part.volume_after, part.number_of_hexahedra));
  dict["parts"] = parts;
}
