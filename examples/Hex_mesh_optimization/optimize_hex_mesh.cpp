// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: reads a hexahedral mesh, optimizes it, writes it,
// and tells what became of it.

#include "program.h"

#include <CGAL/Hex_mesh_optimization/IO/lost_attachments.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/property_map.h>
#include <boost/property_map/function_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

const char* const exit_codes =
  "The format of a mesh (.mesh, .vtk, .vtu) and of a surface (also .off, .obj, .stl, .ply) is told by the extension.\n"
  "Interrupted (Ctrl-C), the program writes the best mesh so far; interrupted twice, it ends without.\n"
  "Vertices and hexahedra are counted from 0, in the order of the file.\n"
  "\n"
  "Exit codes:\n"
  "  0  OUTPUT is written and valid\n"
  "  1  OUTPUT is written, but invalid hexahedra remain, or --max-deviation is not met\n"
  "  2  wrong usage; nothing is written\n"
  "  3  a file cannot be read, used or written, or memory is short; OUTPUT is not written";

struct Options : Common_options
{
  std::string input, reference, frozen, label_array, beside;
  std::vector<std::tuple<std::int64_t, std::int64_t, std::string>> interfaces; // labels, the file of a surface
  bool merge = false;
  bool fixed_boundary = defaults.fixed_boundary;
  std::string method = "full";
  std::string edge_lengths = "estimated";
  std::size_t iterations = defaults.rectification.iterations;
  std::size_t restarts = defaults.rectification.restarts;
};

void add_options(CLI::App& app, Options& o)
{
  const CLI::Validator count = CLI::Range(std::size_t(0), std::size_t(1000000)).description("");
  app.footer(exit_codes);
  app.get_formatter()->column_width(34);
  app.add_option("INPUT", o.input, "the mesh to optimize")->required();
  app.add_option("OUTPUT", o.output, "the file to write; may be INPUT")->required();
  app
    .add_option("--reference", o.reference, "the surface that the boundary represents (default: the boundary as it is)")
    ->type_name("SURFACE");
  app.add_flag("--merge", o.merge,
               "hexahedra whose faces coincide are neighbors, though their vertices are not the same");
  app
    .add_option("--label-array", o.label_array,
                "the cell array of a .vtk or .vtu file with the labels of the hexahedra (default: by its name)")
    ->type_name("NAME");
  app
    .add_option(
      "--interface", o.interfaces,
      "the surface that the interface between two labels is brought to (default: as it is); once for each pair")
    ->type_name("LABEL LABEL SURFACE");
  app.add_flag("--fixed-boundary", o.fixed_boundary, "move no vertex of the boundary");
  app.add_option("--frozen", o.frozen, "a text file with the numbers of vertices not to move, one a line")
    ->type_name("FILE");
  app
    .add_option(
      "--method", o.method,
      "rectification alone, untangling and the maximization of quality alone, or what the mesh needs of them (full)")
    ->type_name("METHOD")
    ->check(CLI::IsMember({"full", "rectification", "maximization"}))
    ->capture_default_str();
  app
    .add_option(
      "--edge-lengths", o.edge_lengths,
      "target lengths of edges: estimated from the boundary, or as in the input (for meshes graded on purpose)")
    ->type_name("LENGTHS")
    ->check(CLI::IsMember({"estimated", "input"}))
    ->capture_default_str();
  app.add_option("--iterations", o.iterations, "the most local-global iterations before target lengths are updated")
    ->type_name("N")
    ->check(count)
    ->capture_default_str();
  app.add_option("--restarts", o.restarts, "how often rectification starts again with updated target lengths")
    ->type_name("N")
    ->check(count)
    ->capture_default_str();
  add_common_options(app, o);
  app
    .add_option("--beside", o.beside, "what another program made of INPUT, to be shown on the page of --report as well")
    ->type_name("MESH")
    ->needs(app.get_option("--report"));
}

// What becomes of the file beside points and hexahedra: one line for each thing that is lost.
std::vector<std::string> losses(const Mesh& mesh, const std::string& output)
{
  std::vector<std::string> result = mesh.attachments.left_out;
  for (const std::string& lost : CGAL::IO::lost_attachments(output, mesh.attachments))
    result.push_back(lost);
  return result;
}

Mesh read_input(const Options& options)
{
  Mesh mesh;
  read(options.input, mesh.points, mesh.hexahedra, mesh.attachments);
  if (!options.label_array.empty() && !mesh.attachments.use_label_array(options.label_array))
    throw CGAL::IO::Hex_mesh_file_error(options.input, 0,
                                        "there is no array \"" + options.label_array +
                                          "\" with one integral number for each cell");
  return mesh;
}

// The mesh with one vertex in the place of those that coincide.
Mesh merged(const Mesh& mesh)
{
  Mesh result = mesh;
  result.merged_into = HMO::coincident_vertices(mesh.points, mesh.hexahedra, 1e-4); // files round
  for (auto& h : result.hexahedra)
    for (std::size_t& v : h)
      v = result.merged_into[v];
  for (auto& cell : result.attachments.other_cells)
    for (std::size_t& v : cell.vertices)
      v = result.merged_into[v];
  return result;
}

std::set<std::size_t> read_vertices(const std::string& filename, std::size_t number_of_vertices)
{
  std::ifstream in(filename);
  if (!in)
    throw CGAL::IO::Hex_mesh_file_error(filename, 0, "cannot open the file for reading");
  std::set<std::size_t> vertices;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    long long v = -1;
    if ((words >> std::ws).eof())
      continue;
    if (!(words >> v) || v < 0 || static_cast<unsigned long long>(v) >= number_of_vertices || !(words >> std::ws).eof())
      throw CGAL::IO::Hex_mesh_file_error(filename, number, "this is no number of a vertex: " + line);
    vertices.insert(static_cast<std::size_t>(v));
  }
  return vertices;
}

// The quadrilaterals of a file that have a label: if hexahedra are on both sides, it is a face to be kept.
std::vector<std::array<std::size_t, 4>> labelled_faces(const CGAL::IO::Hex_mesh_attachments& attachments)
{
  std::vector<std::array<std::size_t, 4>> result;
  for (const auto& quadrilateral : attachments.labelled_quadrilaterals())
    if (quadrilateral.label != 0)
      result.push_back(quadrilateral.vertices);
  return result;
}

using Interfaces = std::vector<std::pair<std::array<int, 2>, Surface>>; // between the numbers of labels

// What comes in.
struct Input
{
  Mesh mesh, beside;
  Surface reference;
  Labels labels;
  Interfaces interfaces;
};

HMO::Status optimize(Mesh& mesh, const Input& input, const Options& o, Watcher& watcher)
{
  std::set<std::size_t> frozen;
  if (!o.frozen.empty())
    for (std::size_t v : read_vertices(o.frozen, mesh.points.size()))
      frozen.insert(mesh.merged_into.empty() ? v : mesh.merged_into[v]);
  const auto np = common_parameters(o, watcher)
                    .hexahedron_label_map(boost::make_function_property_map<std::size_t>(
                      [&](std::size_t h) { return input.labels.number(h); }))
                    .internal_faces(labelled_faces(mesh.attachments))
                    .interface_references(input.interfaces)
                    .fixed_boundary(o.fixed_boundary)
                    .vertex_is_constrained_map(CGAL::make_boolean_property_map(frozen))
                    .optimization_method(o.method == "full"            ? HMO::Method::FULL
                                         : o.method == "rectification" ? HMO::Method::RECTIFICATION
                                                                       : HMO::Method::MAXIMIZATION)
                    .target_edge_lengths(o.edge_lengths == "input" ? HMO::Target_edge_lengths::INPUT
                                                                   : HMO::Target_edge_lengths::ESTIMATED)
                    .number_of_iterations(o.iterations)
                    .number_of_restarts(o.restarts);
  try {
    return in_threads(o.threads, [&] {
      using Tag = CGAL::Parallel_if_available_tag;
      return o.reference.empty() ? CGAL::optimize_hex_mesh<Tag>(mesh.points, mesh.hexahedra, np)
                                 : CGAL::optimize_hex_mesh<Tag>(mesh.points, mesh.hexahedra, input.reference, np);
    });
  }
  catch (const HMO::Input_error& error) {
    if (error.element() != HMO::Input_error::Element::PARAMETER || error.element_index() >= o.interfaces.size())
      throw;
    // the engine knows the numbers of the labels
    const auto& [a, b, file] = o.interfaces[error.element_index()];
    throw HMO::Input_error(error.element(), error.element_index(),
                           "--interface " + std::to_string(a) + ' ' + std::to_string(b) +
                             ": there are no faces between these labels, or another surface was given for them");
  }
}

Json json(const Options& o)
{
  Json interfaces = Json::array();
  for (const auto& [a, b, file] : o.interfaces)
    interfaces.push_back({{"labels", {a, b}}, {"surface", file}});
  return with_common_options({{"input", o.input},
                              {"reference", o.reference.empty() ? Json() : Json(o.reference)},
                              {"interfaces", interfaces},
                              {"merge", o.merge},
                              {"label_array", o.label_array.empty() ? Json() : Json(o.label_array)},
                              {"fixed_boundary", o.fixed_boundary},
                              {"frozen", o.frozen.empty() ? Json() : Json(o.frozen)},
                              {"method", o.method},
                              {"edge_lengths", o.edge_lengths},
                              {"iterations", o.iterations},
                              {"restarts", o.restarts}},
                             o);
}

Interfaces read_interfaces(const Options& o, const Labels& labels)
{
  Interfaces result;
  for (const auto& [a, b, file] : o.interfaces) {
    for (std::int64_t label : {a, b})
      if (!std::binary_search(labels.values.begin(), labels.values.end(), label))
        throw CGAL::IO::Hex_mesh_file_error(o.input, 0, "no hexahedron has the label " + std::to_string(label));
    result.push_back({{labels.number_of(a), labels.number_of(b)}, Surface()});
    read(file, result.back().second);
  }
  return result;
}

Input read_all(const Options& o)
{
  Input input;
  input.mesh = read_input(o);
  if (!o.beside.empty())
    read(o.beside, input.beside.points, input.beside.hexahedra);
  if (!o.reference.empty())
    read(o.reference, input.reference);
  input.labels = Labels(input.mesh.attachments.hexahedron_labels);
  input.interfaces = read_interfaces(o, input.labels);
  return input;
}

std::string name_of(const std::string& file) { return std::filesystem::path(file).filename().string(); }

// The page without the report.
Report_page page_of(const Options& o, const Input& input, const Mesh& result, const Labels& labels)
{
  Report_page::Hexahedra hexahedra = result.hexahedra;
  if (result.number_of_merged() > 0) // neighbors are to be seen as such
    for (auto& h : hexahedra)
      for (std::size_t& v : h)
        v = result.merged_into[v];
  Report_page page;
  if (!o.reference.empty())
    set_reference(page, input.reference);
  page.add_mesh("before", "Before", input.mesh.points, hexahedra);
  page.add_mesh("after", o.beside.empty() ? "After" : name_of(o.output), result.points, hexahedra);
  page.add_reference(o.reference.empty() ? "Boundary before" : "Reference");
  if (labels.values.size() > 1)
    page.add_labels(labels.numbers);
  if (!o.beside.empty())
    page.add_mesh("beside", name_of(o.beside), input.beside.points, input.beside.hexahedra);
  return page;
}

// What the report says of the mesh of another program, the last one of the page. Of interfaces nothing is measured.
Json json_of_beside(const Options& o, const Mesh& beside, const Report_page& page, bool has_interfaces)
{
  return {{"file", o.beside},
          {"after", json(HMO::quality_statistics(beside.points, beside.hexahedra))},
          {"deviation", has_interfaces ? Json() : json(page.deviation())}};
}

Exit_code run(const Options& options)
{
  check_outputs(options);
  const Input input = read_all(options);
  Mesh mesh = input.mesh;
  const std::vector<std::string> lost = losses(mesh, options.output);
  if (!options.quiet)
    for (const std::string& line : lost)
      std::cerr << "warning: not in the output: " << line << '\n';

  const Labels& labels = input.labels;
  HMO::Status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(options.quiet);
    if (options.merge) {
      Mesh one = merged(mesh);
      status = optimize(one, input, options, watcher);
      mesh.merged_into = std::move(one.merged_into);
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        mesh.points[v] = one.points[mesh.merged_into[v]];
    }
    else
      status = optimize(mesh, input, options, watcher);
    iterations = watcher.iterations();
  }
  for (std::size_t h : status.turned_hexahedra)
    std::swap_ranges(mesh.hexahedra[h].begin(), mesh.hexahedra[h].begin() + 4, mesh.hexahedra[h].begin() + 4);

  write(options.output, mesh.points, mesh.hexahedra, mesh.attachments);
  if (!options.quiet)
    print_report(status, mesh, labels);
  Json report =
    with_iterations({{"options", json(options)},
                     {"status", json(status, mesh, labels)},
                     {"number_of_merged_vertices", mesh.number_of_merged()},
                     {"labels",
                      {{"array", mesh.attachments.label_array.empty() ? Json() : Json(mesh.attachments.label_array)},
                       {"number_of_labeled_hexahedra", mesh.attachments.hexahedron_labels.size()}}},
                     {"lost", lost}},
                    iterations);
  std::optional<Report_page> page;
  if (!options.report.empty())
    page = page_of(options, input, mesh, labels);
  if (!options.beside.empty())
    report["beside"] = json_of_beside(options, input.beside, *page,
                                      labels.values.size() > 1 || !labelled_faces(mesh.attachments).empty());
  if (!options.json.empty())
    write_json(options.json, report);
  if (page)
    write_page(*page, options, status, report);
  return status.valid_mesh() && status.is_within_deviation_bound() ? ALL_IS_MET : SOMETHING_IS_NOT_MET;
}

int main(int argc, char** argv)
{
  CLI::App app("Moves the vertices of a hexahedral mesh until no hexahedron is inverted and all are as good as the "
               "connectivity allows.");
  Options options;
  add_options(app, options);
  options.command = command_line(argc, argv);
  return run_program(app, argc, argv, [&] { return run(options); });
}
