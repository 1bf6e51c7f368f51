// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PARTS_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PARTS_H

// What the programs share that optimize a mesh part by part.

#include "Mesh_in_file.h"
#include "program.h"

#include <CGAL/optimize_hex_mesh_file.h>

#include <cstddef>
#include <iostream>
#include <string>

struct Options_of_parts
{
  HMO::Mesh_division division;

  bool is_divided() const { return division.number_of_parts > 0 || division.maximum_memory > 0; }
};

inline void add_layers(CLI::App& app, Options_of_parts& o)
{
  app
    .add_option("--layers", o.division.layers,
                "layers of hexahedra around what parts have held, which those of the next round have")
    ->type_name("N")
    ->check(CLI::Range(1, 1000).description(""))
    ->capture_default_str();
}

inline void add_options_of_parts(CLI::App& app, Options_of_parts& o)
{
  CLI::Option* parts =
    app
      .add_option("--parts", o.division.number_of_parts,
                  "optimize so many parts of a .vtu file one after the other, which need not all be in memory")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""));
  app
    .add_option("--memory", o.division.maximum_memory,
                "as --parts, with as many as it takes to get along with that memory, such as 4G")
    ->type_name("SIZE")
    ->transform(CLI::AsSizeValue(false).description(""))
    ->excludes(parts);
  add_layers(app, o);
}

// report: what else it has
inline Exit_code report_parts(const Common_options& o, HMO::Status& status, const std::string& file, Json report)
{
  const Mesh_in_file mesh(file);
  // the report knows labels by their places among them all
  Labels labels;
  for (HMO::Region_volume& r : status.regions)
    labels.values.push_back(r.label);
  for (HMO::Region_volume& r : status.regions)
    r.label = labels.number_of(r.label);
  for (HMO::Interface_statistics& i : status.interfaces)
    i.labels = {labels.number_of(i.labels[0]), labels.number_of(i.labels[1])};
  if (!o.quiet)
    print_report(status, mesh, labels);
  report["status"] = json_of(status, mesh, labels);
  if (!o.json.empty())
    write_json(o.json, report);
  return status.valid_mesh() && status.is_within_deviation_bound() ? SUCCESS : REQUIREMENT_NOT_MET;
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PARTS_H
