// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_STATUS_REPORT_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_STATUS_REPORT_H

// What an optimization reports, as the rows of a table and as JSON: for the programs and for the Python module.

#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/Visitor.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;
using Json = nlohmann::ordered_json;

// The labels of the hexahedra of a file: those that occur, in increasing order, and the number of each hexahedron's own
// among them, which fits into any integer. With no labels, all hexahedra have the number 0.
struct Labels
{
  std::vector<std::int64_t> values;
  std::vector<int> numbers;

  explicit Labels(const std::vector<std::int64_t>& labels = {}) : values(labels)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (std::int64_t l : labels)
      numbers.push_back(number_of(l));
  }

  // Of a label that occurs.
  int number_of(std::int64_t label) const
  {
    return static_cast<int>(std::lower_bound(values.begin(), values.end(), label) - values.begin());
  }
  int number(std::size_t hexahedron) const { return numbers.empty() ? 0 : numbers[hexahedron]; }
  std::int64_t value(int number) const { return values.empty() ? 0 : values[number]; }
};

inline const char* in_words(HMO::Return_code code)
{
  switch (code) {
  case HMO::Return_code::CONVERGED:
    return "converged: further iterations would not improve the mesh";
  case HMO::Return_code::TARGET_QUALITY_REACHED:
    return "target quality reached";
  case HMO::Return_code::ITERATION_LIMIT:
    return "iteration limit reached";
  case HMO::Return_code::TIME_LIMIT:
    return "time limit reached";
  case HMO::Return_code::STOPPED_BY_VISITOR:
    return "interrupted";
  case HMO::Return_code::DEVIATION_BOUND_NOT_MET:
    return "deviation bound not certified";
  case HMO::Return_code::NO_IMPROVEMENT:
    return "no improvement found: all positions are those of the input";
  }
  return "";
}

template <class Number>
std::string text(Number x)
{
  std::ostringstream out;
  out << std::setprecision(4) << x;
  return out.str();
}

struct Report_row
{
  std::string title, before, after;
};

inline std::vector<Report_row> table(const HMO::Status& status, const Labels& labels = Labels())
{
  std::vector<Report_row> rows{{"", "before", "after"}};
  const auto add = [&](const char* title, auto HMO::Quality_statistics::*number) {
    rows.push_back({title, text(status.before.*number), text(status.after.*number)});
  };
  const auto add_after = [&](const std::string& title, double number) { rows.push_back({title, "", text(number)}); };
  add("hexahedra", &HMO::Quality_statistics::number_of_hexahedra);
  add("inverted", &HMO::Quality_statistics::number_of_inverted);
  add("invalid", &HMO::Quality_statistics::number_of_invalid);
  add("minimum scaled Jacobian", &HMO::Quality_statistics::minimum);
  add("mean scaled Jacobian", &HMO::Quality_statistics::average);
  add("standard deviation", &HMO::Quality_statistics::standard_deviation);
  add("99th percentile of edge ratio", &HMO::Quality_statistics::edge_ratio_99);
  rows.push_back({"volume", text(status.volume_before), text(status.volume_after)});
  if (status.regions.size() > 1)
    for (const HMO::Region_volume& region : status.regions)
      rows.push_back(
        {"  of label " + std::to_string(labels.value(region.label)), text(region.before), text(region.after)});
  add_after("average deviation / diagonal", status.deviation.average_relative);
  add_after("maximum deviation / diagonal", status.deviation.maximum_relative);
  for (const HMO::Interface_statistics& i : status.interfaces)
    add_after("  between labels " + std::to_string(labels.value(i.labels[0])) + " and " +
                std::to_string(labels.value(i.labels[1])),
              i.deviation.maximum_relative);
  if (std::isfinite(status.deviation_bound))
    add_after("certified maximum, as a length", status.deviation.certified);
  add_after("seconds", status.total_seconds);
  add_after("  of rectification", status.rectification_seconds);
  add_after("  of untangling", status.untangling_seconds);
  add_after("  of maximization", status.maximization_seconds);
  return rows;
}

// The report has the members of the structs, and the enumerators, under their own names.
inline Json json(HMO::Return_code code)
{
  switch (code) {
  case HMO::Return_code::CONVERGED:
    return "CONVERGED";
  case HMO::Return_code::TARGET_QUALITY_REACHED:
    return "TARGET_QUALITY_REACHED";
  case HMO::Return_code::ITERATION_LIMIT:
    return "ITERATION_LIMIT";
  case HMO::Return_code::TIME_LIMIT:
    return "TIME_LIMIT";
  case HMO::Return_code::STOPPED_BY_VISITOR:
    return "STOPPED_BY_VISITOR";
  case HMO::Return_code::DEVIATION_BOUND_NOT_MET:
    return "DEVIATION_BOUND_NOT_MET";
  case HMO::Return_code::NO_IMPROVEMENT:
    return "NO_IMPROVEMENT";
  }
  return Json();
}

inline Json json(const HMO::Quality_statistics& s)
{
  return {{"number_of_hexahedra", s.number_of_hexahedra},
          {"number_of_inverted", s.number_of_inverted},
          {"number_of_invalid", s.number_of_invalid},
          {"minimum", s.minimum},
          {"average", s.average},
          {"standard_deviation", s.standard_deviation},
          {"minimum_with_center", s.minimum_with_center},
          {"average_with_center", s.average_with_center},
          {"maximum_edge_ratio", s.maximum_edge_ratio},
          {"median_edge_ratio", s.median_edge_ratio},
          {"edge_ratio_99", s.edge_ratio_99}};
}

inline Json json(const HMO::Deviation& d)
{
  return {{"average", d.average},
          {"maximum", d.maximum},
          {"average_relative", d.average_relative},
          {"maximum_relative", d.maximum_relative},
          {"certified", d.certified},
          {"bilinear", d.bilinear}};
}

inline Json json(HMO::Stage stage)
{
  switch (stage) {
  case HMO::Stage::RECTIFICATION:
    return "RECTIFICATION";
  case HMO::Stage::UNTANGLING:
    return "UNTANGLING";
  case HMO::Stage::MAXIMIZATION:
    return "MAXIMIZATION";
  }
  return Json();
}

inline Json json(const HMO::Iteration& i)
{
  return {{"stage", json(i.stage)}, {"iteration", i.iteration},
          {"energy", i.energy},     {"number_of_inverted", i.number_of_inverted},
          {"minimum", i.minimum},   {"average", i.average},
          {"seconds", i.seconds}};
}

inline Json json(const HMO::Attempt& a)
{
  return {{"name", a.name},
          {"is_taken", a.is_taken},
          {"iterations", a.iterations},
          {"seconds", a.seconds},
          {"number_of_inverted", a.number_of_inverted},
          {"minimum", a.minimum},
          {"average", a.average}};
}

// In one sentence for each piece.
inline std::vector<std::string> in_words(const std::vector<HMO::Volume_change>& changes, const Labels& labels)
{
  std::vector<std::string> result;
  for (const HMO::Volume_change& c : changes) {
    std::ostringstream out;
    out << "The volume of " << c.number_of_hexahedra << " connected hexahedra";
    if (labels.values.size() > 1)
      out << " with label " << labels.value(c.label);
    out << " (the first is " << c.hexahedron << ") changed from " << text(c.before) << " to " << text(c.after);
    if (c.before > 0)
      out << ", by " << std::showpos << std::setprecision(2) << 100 * (c.after / c.before - 1) << " %";
    result.push_back(out.str() + ".");
  }
  return result;
}

// center: of a hexahedron, by its number.
template <class Center>
Json json(const HMO::Status& status, const Center& center, const Labels& labels)
{
  Json invalid = Json::array();
  for (std::size_t h : status.invalid_hexahedra) {
    const auto c = center(h);
    invalid.push_back({{"id", h}, {"center", {c.x(), c.y(), c.z()}}});
  }
  Json limits = Json::array();
  for (const HMO::Connectivity_limit& l : status.connectivity_limits)
    limits.push_back({{"hexahedron", l.hexahedron},
                      {"reason", HMO::description(l.reason)},
                      {"largest_scaled_jacobian", l.largest_scaled_jacobian},
                      {"scaled_jacobian", l.scaled_jacobian},
                      {"is_reached", l.is_reached()}});
  Json regions = Json::array(), interfaces = Json::array(), attempts = Json::array(), changes = Json::array();
  for (const HMO::Volume_change& c : status.volume_changes)
    changes.push_back({{"label", labels.value(c.label)},
                       {"hexahedron", c.hexahedron},
                       {"number_of_hexahedra", c.number_of_hexahedra},
                       {"volume_before", c.before},
                       {"volume_after", c.after}});
  for (const HMO::Attempt& a : status.attempts)
    attempts.push_back(json(a));
  for (const HMO::Region_volume& r : status.regions)
    regions.push_back({{"label", labels.value(r.label)}, {"volume_before", r.before}, {"volume_after", r.after}});
  for (const HMO::Interface_statistics& i : status.interfaces)
    interfaces.push_back({{"labels", {labels.value(i.labels[0]), labels.value(i.labels[1])}},
                          {"number_of_faces", i.number_of_faces},
                          {"average_deviation", i.deviation.average},
                          {"maximum_deviation", i.deviation.maximum}});
  return {{"return_code", json(status.return_code)},
          {"valid_mesh", status.valid_mesh()},
          {"number_of_reoriented_hexahedra", status.number_of_reoriented_hexahedra()},
          {"reoriented_hexahedra", status.reoriented_hexahedra},
          {"number_of_coincident_vertices", status.number_of_coincident_vertices},
          {"before", json(status.before)},
          {"after", json(status.after)},
          {"volume_before", status.volume_before},
          {"volume_after", status.volume_after},
          {"volume_changes", changes},
          {"volume_changes_in_words", in_words(status.volume_changes, labels)},
          {"regions", regions},
          {"interfaces", interfaces},
          {"deviation", json(status.deviation)},
          {"is_within_deviation_bound", status.is_within_deviation_bound()},
          {"iterations", status.iterations},
          {"attempts", attempts},
          {"rectification_seconds", status.rectification_seconds},
          {"untangling_seconds", status.untangling_seconds},
          {"maximization_seconds", status.maximization_seconds},
          {"total_seconds", status.total_seconds},
          {"deviation_bound", status.deviation_bound},
          {"invalid_hexahedra", invalid},
          {"locked_hexahedra", status.locked_hexahedra},
          {"vertices_off_reference", status.vertices_off_reference},
          {"connectivity_limits", limits}};
}

// report: what stands before the iterations.
inline Json with_iterations(Json report, const std::vector<HMO::Iteration>& iterations)
{
  report["iterations"] = Json::array();
  for (const HMO::Iteration& i : iterations)
    report["iterations"].push_back(json(i));
  return report;
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_STATUS_REPORT_H
