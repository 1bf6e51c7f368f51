// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: reads a hexahedral mesh, optimizes it, writes it,
// and tells what became of it.

#include "parts.h"
#include "program.h"

#include <CGAL/Hex_mesh_optimization/IO/unsupported_data.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/Hex_mesh_optimization/quality.h>
#include <CGAL/Hex_mesh_optimization/validity.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/property_map.h>
#include <boost/property_map/function_property_map.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

const char* const exit_codes =
  "The format of a mesh (.mesh, .vtk, .vtu) and of a surface (also .off, .obj, .stl, .ply) is told by the extension.\n"
  "Files of solvers are copied, with nothing but numbers of coordinates replaced: .inp (Abaqus, CalculiX, AVS UCD),\n"
  ".msh (Gmsh), .bdf, .nas, .dat (Nastran), .e, .exo, .g, .ex2 (Exodus II), .med (MED), and folders (cases of\n"
  "OpenFOAM). Their boundary is fixed where that suffices for a valid mesh, unless --free-boundary is given.\n"
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
  std::string input, reference, fixed_vertices, label_array, compared;
  std::vector<std::string> fixed_sets, internal_faces; // names of sets of the file
  bool info = false;
  std::vector<std::tuple<std::int64_t, std::int64_t, std::string>> interfaces; // labels, the file of a surface
  bool merge = false;
  bool fixed_boundary = false;
  bool free_boundary = false;
  std::string method = "full";
  std::string edge_lengths = "estimated";
  std::size_t iterations = 20;
  std::size_t restarts = 2;
  Options_of_parts parts;
};

void add_options_of_solver_files(CLI::App& app, Options& o)
{
  app
    .add_flag("--free-boundary", o.free_boundary,
              "move vertices of the boundary at once, also in a file of a solver, where it is fixed if that suffices")
    ->excludes(app.get_option("--fixed-boundary"));
  app
    .add_option("--fixed-set", o.fixed_sets,
                "do not move the vertices of this set of the file (node set, side set, group, patch); once for each")
    ->type_name("NAME");
  app
    .add_option("--internal-faces", o.internal_faces,
                "keep the faces of this set within the mesh as an interface; once for each")
    ->type_name("NAME");
}

void add_options(CLI::App& app, Options& o)
{
  const CLI::Validator count = CLI::Range(std::size_t(0), std::size_t(1000000)).description("");
  app.footer(exit_codes);
  app.get_formatter()->column_width(34);
  app.add_option("INPUT", o.input, "the mesh to optimize")->required();
  app.add_option("OUTPUT", o.output, "the file to write; may be INPUT");
  app.add_flag("--info", o.info, "list what INPUT has: labels, sets, cells of other kinds; OUTPUT is not needed");
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
  add_options_of_solver_files(app, o);
  app
    .add_option("--fixed-vertices", o.fixed_vertices,
                "a text file with the numbers of vertices not to move, one a line")
    ->type_name("FILE");
  app
    .add_option(
      "--method", o.method,
      "rectification alone, untangling and the maximization of quality alone, or what the mesh needs of them (full)")
    ->type_name("METHOD")
    ->check(CLI::IsMember({"full", "rectification", "maximization"}))
    ->capture_default_str();
  add_edge_lengths(app, o.edge_lengths);
  app.add_option("--iterations", o.iterations, "the most local-global iterations before target lengths are updated")
    ->type_name("N")
    ->check(count)
    ->capture_default_str();
  app.add_option("--restarts", o.restarts, "how often rectification starts again with updated target lengths")
    ->type_name("N")
    ->check(count)
    ->capture_default_str();
  add_options_of_parts(app, o.parts);
  for (const char* other :
       {"--info", "--reference", "--merge", "--interface", "--fixed-set", "--internal-faces", "--fixed-vertices"})
    for (const char* division : {"--parts", "--memory"})
      app.get_option(division)->excludes(app.get_option(other));
  add_common_options(app, o);
  app
    .add_option("--compare", o.compared,
                "what another program made of INPUT, to be shown on the page of --report as well")
    ->type_name("MESH")
    ->needs(app.get_option("--report"));
}

// What becomes of the file beside points and hexahedra: one line for each thing that is lost.
std::vector<std::string> losses(const Mesh& mesh, const std::string& output)
{
  std::vector<std::string> result = mesh.mesh_data.skipped;
  for (const std::string& lost : CGAL::IO::unsupported_data(output, mesh.mesh_data))
    result.push_back(lost);
  return result;
}

Mesh read_input(const Options& options)
{
  Mesh mesh;
  mesh.file = read_solver_file(options.input);
  if (mesh.file) {
    for (const auto& p : mesh.file->points)
      mesh.points.emplace_back(p[0], p[1], p[2]);
    mesh.hexahedra = mesh.file->hexahedra;
    mesh.mesh_data = mesh_data_of(*mesh.file);
    mesh.is_copied = is_copy(options.input, options.output);
    if (mesh.hexahedra.empty() && !options.info)
      throw CGAL::IO::Hex_mesh_file_error(options.input, 0, "there are no hexahedra in the file");
  }
  else
    read(options.input, mesh.points, mesh.hexahedra, mesh.mesh_data);
  if (!options.label_array.empty() && !mesh.mesh_data.use_label_array(options.label_array))
    throw CGAL::IO::Hex_mesh_file_error(options.input, 0,
                                        "there is no array \"" + options.label_array +
                                          "\" with one integral number for each cell");
  return mesh;
}

// Of the file of a solver; throws if there is none with that name.
const CGAL::IO::Hex_mesh_set& named_set(const Mesh& mesh, const Options& o, const std::string& name)
{
  const CGAL::IO::Hex_mesh_set* set = mesh.file ? mesh.file->find_set(name) : nullptr;
  if (set == nullptr)
    throw CGAL::IO::Hex_mesh_file_error(o.input, 0, "there is no set \"" + name + "\" (--info lists them)");
  return *set;
}

// The mesh with one vertex in the place of those that coincide.
Mesh merged(const Mesh& mesh)
{
  Mesh result = mesh;
  result.merged_into = HMO::coincident_vertices(mesh.points, mesh.hexahedra, 1e-4); // files round
  for (auto& h : result.hexahedra)
    for (std::size_t& v : h)
      v = result.merged_into[v];
  for (auto& cell : result.mesh_data.other_cells)
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
std::vector<std::array<std::size_t, 4>> labelled_faces(const CGAL::IO::Hex_mesh_data& mesh_data)
{
  std::vector<std::array<std::size_t, 4>> result;
  for (const auto& quadrilateral : mesh_data.labelled_quadrilaterals())
    if (quadrilateral.label != 0)
      result.push_back(quadrilateral.vertices);
  return result;
}

// Those that are to be kept. In the file of a solver a face has a label for many reasons: there they are named.
std::vector<std::array<std::size_t, 4>> kept_faces(const Mesh& mesh, const Options& o)
{
  if (!mesh.file)
    return labelled_faces(mesh.mesh_data);
  std::vector<std::array<std::size_t, 4>> result;
  for (const std::string& name : o.internal_faces) {
    const CGAL::IO::Hex_mesh_set& set = named_set(mesh, o, name);
    if (set.faces.empty())
      throw CGAL::IO::Hex_mesh_file_error(o.input, 0, "the set \"" + name + "\" has no quadrilaterals");
    for (std::array<std::size_t, 4> face : set.faces) {
      if (!mesh.merged_into.empty())
        for (std::size_t& v : face)
          v = mesh.merged_into[v];
      result.push_back(face);
    }
  }
  return result;
}

using Interfaces = std::vector<std::pair<std::array<int, 2>, Surface>>; // between the numbers of labels

// What comes in.
struct Input
{
  Mesh mesh, compared;
  Surface reference;
  Labels labels;
  Interfaces interfaces;
};

// How the vertices of a mesh may move.
struct Freedom
{
  bool fixed_boundary;
  bool keeps_interfaces = true;
  bool holds_periodic = false; // those that would move together otherwise
};

std::set<std::size_t> fixed_vertices(const Mesh& mesh, const Options& o, const Freedom& freedom)
{
  std::set<std::size_t> fixed;
  if (!o.fixed_vertices.empty())
    fixed = read_vertices(o.fixed_vertices, mesh.points.size());
  for (const std::string& name : o.fixed_sets) {
    const CGAL::IO::Hex_mesh_set& set = named_set(mesh, o, name);
    fixed.insert(set.vertices.begin(), set.vertices.end());
  }
  if (mesh.file)
    fixed.insert(mesh.file->held_points.begin(), mesh.file->held_points.end());
  if (mesh.file && freedom.holds_periodic)
    for (const auto& pair : mesh.file->periodic_pairs)
      fixed.insert({pair.first, pair.second});
  if (mesh.merged_into.empty())
    return fixed;
  std::set<std::size_t> merged;
  for (std::size_t v : fixed)
    merged.insert(mesh.merged_into[v]);
  return merged;
}

using Periodic_vertices = std::vector<std::tuple<std::size_t, std::size_t, Kernel::Vector_3>>;

Periodic_vertices periodic_vertices(const Mesh& mesh, const Freedom& freedom)
{
  Periodic_vertices result;
  if (mesh.file && !freedom.holds_periodic && mesh.merged_into.empty())
    for (const auto& [first, second, t] : mesh.file->periodic_pairs)
      result.emplace_back(first, second, Kernel::Vector_3(t[0], t[1], t[2]));
  return result;
}

HMO::Method method(const Options& o)
{
  return o.method == "full"            ? HMO::Method::FULL
         : o.method == "rectification" ? HMO::Method::RECTIFICATION
                                       : HMO::Method::MAXIMIZATION;
}

HMO::Status optimize(Mesh& mesh, const Input& input, const Options& o, const Freedom& freedom, double time_limit,
                     Watcher& watcher)
{
  const std::set<std::size_t> fixed = fixed_vertices(mesh, o, freedom);
  const auto faces = freedom.keeps_interfaces ? kept_faces(mesh, o) : std::vector<std::array<std::size_t, 4>>();
  const bool is_exact = o.on_surface || (mesh.file && mesh.file->has_exact_surfaces && !freedom.fixed_boundary);
  const auto np = common_parameters(o, watcher)
                    .hexahedron_label_map(boost::make_function_property_map<std::size_t>(
                      [&](std::size_t h) { return freedom.keeps_interfaces ? input.labels.number(h) : 0; }))
                    .internal_faces(faces)
                    .interface_references(input.interfaces)
                    .periodic_vertices(periodic_vertices(mesh, freedom))
                    .fixed_boundary(freedom.fixed_boundary)
                    .boundary_placement(is_exact ? HMO::Boundary_placement::ON_SURFACE
                                                 : HMO::Boundary_placement::WITHIN_TOLERANCE)
                    .maximum_running_time(time_limit)
                    .vertex_is_constrained_map(CGAL::make_boolean_property_map(fixed))
                    .optimization_method(method(o))
                    .target_edge_lengths(target_edge_lengths(o.edge_lengths))
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

// What is tried in turn until the mesh is valid. In the file of a solver the boundary carries loads and contacts: it moves
// only where it has to. What interfaces are where vertices have left them, nobody knows: at last they are not kept.
std::vector<Freedom> freedoms(const Mesh& mesh, const Options& o)
{
  if (!mesh.file)
    return {{o.fixed_boundary}};
  std::vector<Freedom> result;
  const bool is_fixed_at_first = o.fixed_boundary || (!o.free_boundary && o.reference.empty());
  for (bool keeps_interfaces : {true, false}) {
    if (!keeps_interfaces && (!o.interfaces.empty() || !o.internal_faces.empty()))
      break;
    if (is_fixed_at_first)
      result.push_back({true, keeps_interfaces});
    if (!o.fixed_boundary)
      result.push_back({false, keeps_interfaces});
  }
  return result;
}

// Of those that are tried, the one that is done last is the first that is valid, or the best.
HMO::Status optimize(Mesh& mesh, const Input& input, const Options& o, Watcher& watcher,
                     std::vector<std::string>& notes)
{
  const auto start = std::chrono::steady_clock::now();
  const Points given = mesh.points;
  HMO::Status best;
  Points best_points;
  const std::vector<Freedom> all = freedoms(mesh, o);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && !all[i].keeps_interfaces && input.labels.values.size() < 2)
      break; // nothing would be different
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (i > 0 && (spent >= o.time_limit || is_interrupted))
      break;
    const double left = i == 0 ? o.time_limit : o.time_limit - spent;
    mesh.points = given;
    HMO::Status status;
    Freedom freedom = all[i];
    try {
      status = optimize(mesh, input, o, freedom, left, watcher);
    }
    catch (const HMO::Input_error& error) {
      if (!mesh.file || mesh.file->periodic_pairs.empty() || error.element() != HMO::Input_error::Element::PARAMETER)
        throw;
      freedom.holds_periodic = true;
      status = optimize(mesh, input, o, freedom, left, watcher);
    }
    if (i > 0 && status.invalid_hexahedra.size() >= best.invalid_hexahedra.size())
      continue;
    best = std::move(status);
    best_points = mesh.points;
    notes.clear();
    if (!freedom.fixed_boundary && all[0].fixed_boundary)
      notes.push_back("vertices of the boundary were moved: with a fixed boundary, hexahedra stayed invalid");
    if (!freedom.keeps_interfaces)
      notes.push_back("interfaces between labels were not kept: with them, hexahedra stayed invalid");
    if (best.valid_mesh())
      break;
  }
  mesh.points = std::move(best_points);
  return best;
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
                              {"free_boundary", o.free_boundary},
                              {"fixed_sets", o.fixed_sets},
                              {"internal_faces", o.internal_faces},
                              {"fixed_vertices", o.fixed_vertices.empty() ? Json() : Json(o.fixed_vertices)},
                              {"method", o.method},
                              {"edge_lengths", o.edge_lengths},
                              {"iterations", o.iterations},
                              {"restarts", o.restarts},
                              {"parts", o.parts.division.number_of_parts},
                              {"memory", o.parts.division.maximum_memory},
                              {"layers", o.parts.division.layers}},
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
  if (!o.compared.empty())
    read(o.compared, input.compared.points, input.compared.hexahedra);
  if (!o.reference.empty())
    read(o.reference, input.reference);
  input.labels = Labels(input.mesh.mesh_data.hexahedron_labels);
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
  page.add_mesh("after", o.compared.empty() ? "After" : name_of(o.output), result.points, hexahedra);
  page.add_reference(o.reference.empty() ? "Boundary before" : "Reference");
  if (labels.values.size() > 1)
    page.add_labels(labels.numbers);
  if (!o.compared.empty())
    page.add_mesh("compared", name_of(o.compared), input.compared.points, input.compared.hexahedra);
  return page;
}

// What the report says of the mesh of another program, the last one of the page. Of interfaces nothing is measured.
Json json_of_comparison(const Options& o, const Mesh& compared, const Report_page& page, bool has_interfaces)
{
  return {{"file", o.compared},
          {"after", json(HMO::quality_statistics(compared.points, compared.hexahedra))},
          {"deviation", has_interfaces ? Json() : json(page.deviation())}};
}

// What the file of a solver has that is not optimized, for the user.
void print_file(const Mesh& mesh, std::ostream& out)
{
  if (!mesh.file)
    return;
  const CGAL::IO::Hex_mesh_file& file = *mesh.file;
  if (file.number_of_other_solids > 0)
    out << file.number_of_other_solids << " cells of the volume are no hexahedra that can be optimized; "
        << file.held_points.size() << " vertices of hexahedra are held, most of them shared with those.\n";
  else if (!file.held_points.empty())
    out << file.held_points.size() << " vertices of hexahedra are held.\n";
  if (file.number_of_high_order_hexahedra > 0)
    out << file.number_of_high_order_hexahedra << " hexahedra have nodes that are no corners: " << file.followers.size()
        << " such nodes go along with the corners; validity and quality are those of the corners.\n";
  for (const std::string& note : file.notes)
    out << note << ".\n";
}

// --info
void print_info(const Mesh& mesh, const Options& o)
{
  std::cout << o.input << ": " << (mesh.file ? mesh.file->format : "mesh") << ", " << mesh.points.size() << " points, "
            << mesh.hexahedra.size() << " hexahedra, " << mesh.mesh_data.other_cells.size() << " other cells\n";
  print_file(mesh, std::cout);
  const Labels labels(mesh.file ? mesh.file->labels : mesh.mesh_data.hexahedron_labels);
  for (std::size_t i = 0; i < labels.values.size(); ++i) {
    std::cout << "label " << labels.values[i] << ": "
              << std::count(labels.numbers.begin(), labels.numbers.end(), static_cast<int>(i)) << " hexahedra";
    if (mesh.file && mesh.file->label_names.count(labels.values[i]) > 0)
      std::cout << "  \"" << mesh.file->label_names.at(labels.values[i]) << '"';
    std::cout << '\n';
  }
  if (!mesh.file)
    return;
  for (const CGAL::IO::Hex_mesh_set& set : mesh.file->sets) {
    using Kind = CGAL::IO::Hex_mesh_set::Kind;
    std::cout << "set of "
              << (set.kind == Kind::VERTICES ? "vertices"
                  : set.kind == Kind::FACES  ? "faces"
                                             : "cells")
              << " \"" << set.name << "\": " << set.size << '\n';
  }
}

Json json_of_file(const Mesh& mesh, const std::vector<std::string>& notes)
{
  if (!mesh.file)
    return Json();
  const CGAL::IO::Hex_mesh_file& file = *mesh.file;
  Json names = Json::object();
  for (const auto& [label, name] : file.label_names)
    names[std::to_string(label)] = name;
  std::vector<std::string> all = file.notes;
  all.insert(all.end(), notes.begin(), notes.end());
  return {{"format", file.format},
          {"is_copied", mesh.is_copied},
          {"number_of_other_solids", file.number_of_other_solids},
          {"number_of_held_vertices", file.held_points.size()},
          {"number_of_high_order_hexahedra", file.number_of_high_order_hexahedra},
          {"label_names", names},
          {"notes", all}};
}

// Throws now what would be thrown after all the work.
void check_output_of_copy(const Mesh& mesh, const Options& o)
{
  check_copy(*mesh.file, o.output);
  std::error_code ignored;
  if (std::filesystem::is_directory(o.input, ignored)) {
    if (std::filesystem::exists(o.output, ignored) && !std::filesystem::is_directory(o.output, ignored))
      throw CGAL::IO::Hex_mesh_file_error(o.output, 0, "it is no folder, and the input is one");
  }
  else
    check_writable(o.output);
}

// The vertices are where the copy has them; so is what the status says of them.
void write_copy(Mesh& mesh, const Options& o, HMO::Status& status)
{
  const Points wanted = mesh.points;
  mesh.points = copy(*mesh.file, o.output, mesh.points);
  bool is_rounded = false;
  for (const auto& h : mesh.hexahedra)
    for (std::size_t v : h)
      is_rounded = is_rounded || wanted[v] != mesh.points[v];
  if (!is_rounded)
    return;
  const std::size_t before = status.invalid_hexahedra.size();
  status.after = HMO::quality_statistics(mesh.points, mesh.hexahedra);
  status.invalid_hexahedra.clear();
  HMO::invalid_hexahedra(mesh.points, mesh.hexahedra, std::back_inserter(status.invalid_hexahedra));
  if (status.invalid_hexahedra.size() > before)
    std::cerr << "warning: " << status.invalid_hexahedra.size() - before
              << " hexahedra are invalid because the fields of the file have no room for more digits\n";
}

// Returns false, and writes nothing, where the file has to be written anew.
bool write_as_copy(Mesh& mesh, const Input& input, const Places& places, const Options& o, HMO::Status& status)
{
  if (mesh.is_copied)
    write_copy(mesh, o, status);
  else if (places && status.reoriented_hexahedra.empty())
    copy(places, o.output, input.mesh.points, mesh.points);
  else
    return false;
  return true;
}

struct Outcome
{
  HMO::Status status;
  std::vector<HMO::Iteration> iterations;
  std::vector<std::string> notes; // for the user
};

// Merges before, where that is asked for; hexahedra that are inside out are turned.
Outcome optimized(Mesh& mesh, const Input& input, const Options& o)
{
  Outcome result;
  {
    Watcher watcher(o.quiet);
    if (o.merge) {
      Mesh one = merged(mesh);
      result.status = optimize(one, input, o, watcher, result.notes);
      mesh.merged_into = std::move(one.merged_into);
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        mesh.points[v] = one.points[mesh.merged_into[v]];
    }
    else
      result.status = optimize(mesh, input, o, watcher, result.notes);
    result.iterations = watcher.iterations();
  }
  for (std::size_t h : result.status.reoriented_hexahedra)
    std::swap_ranges(mesh.hexahedra[h].begin(), mesh.hexahedra[h].begin() + 4, mesh.hexahedra[h].begin() + 4);
  return result;
}

// Tells the user at once.
std::vector<std::string> announced_losses(const Mesh& mesh, const Options& o)
{
  const std::vector<std::string> lost = losses(mesh, o.output);
  if (!o.quiet)
    for (const std::string& line : lost)
      std::cerr << "warning: not in the output: " << line << '\n';
  return lost;
}

// --parts, --memory
Exit_code run_in_parts(const Options& o)
{
  if (!o.report.empty())
    throw HMO::Input_error(HMO::Input_error::Element::PARAMETER, 0, "there is no page of a mesh in parts");
  check_reports(o);
  check_writable(o.output);
  HMO::Mesh_division division = o.parts.division;
  division.label_array = o.label_array;
  HMO::Status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(o.quiet);
    const auto np = common_parameters(o, watcher)
                      .fixed_boundary(o.fixed_boundary)
                      .optimization_method(method(o))
                      .target_edge_lengths(target_edge_lengths(o.edge_lengths))
                      .number_of_iterations(o.iterations)
                      .number_of_restarts(o.restarts);
    status = in_threads(o.threads, [&] {
      return CGAL::optimize_hex_mesh_file<CGAL::Parallel_if_available_tag>(o.input, o.output, division, np);
    });
    iterations = watcher.iterations();
  }
  const Json options = json(o);
  return report_parts(o, status, o.output, with_iterations({{"options", options}}, iterations));
}

Exit_code run(const Options& options)
{
  if (options.parts.is_divided())
    return run_in_parts(options);
  if (!options.info) {
    check_reports(options);
    if (!is_copy(options.input, options.output))
      check_output(options.output);
  }
  const Input input = read_all(options);
  Mesh mesh = input.mesh;
  if (options.info) {
    print_info(mesh, options);
    return SUCCESS;
  }
  if (mesh.is_copied)
    check_output_of_copy(mesh, options);
  const Places places = mesh.file ? Places() : places_in(options.input, options.output, mesh.points);
  std::vector<std::string> lost;
  if (!mesh.is_copied && !places)
    lost = announced_losses(mesh, options);

  const Labels& labels = input.labels;
  Outcome outcome = optimized(mesh, input, options);
  HMO::Status& status = outcome.status;
  if (!write_as_copy(mesh, input, places, options, status)) {
    if (places)
      lost = announced_losses(mesh, options);
    write(options.output, mesh.points, mesh.hexahedra, mesh.mesh_data);
  }
  if (!options.quiet) {
    print_file(mesh, std::cout);
    for (const std::string& note : outcome.notes)
      std::cout << note << ".\n";
    print_report(status, mesh, labels);
  }
  Json report =
    with_iterations({{"options", json(options)},
                     {"status", json(status, mesh, labels)},
                     {"number_of_merged_vertices", mesh.number_of_merged()},
                     {"labels",
                      {{"array", mesh.mesh_data.label_array.empty() ? Json() : Json(mesh.mesh_data.label_array)},
                       {"number_of_labeled_hexahedra", mesh.mesh_data.hexahedron_labels.size()}}},
                     {"lost", lost},
                     {"file", json_of_file(mesh, outcome.notes)}},
                    outcome.iterations);
  std::optional<Report_page> page;
  if (!options.report.empty())
    page = page_of(options, input, mesh, labels);
  if (!options.compared.empty())
    report["comparison"] = json_of_comparison(options, input.compared, *page,
                                              labels.values.size() > 1 || !kept_faces(mesh, options).empty());
  if (!options.json.empty())
    write_json(options.json, report);
  if (page)
    write_page(*page, options, status, report);
  return status.valid_mesh() && status.is_within_deviation_bound() ? SUCCESS : REQUIREMENT_NOT_MET;
}

int main(int argc, char** argv)
{
  CLI::App app("Moves the vertices of a hexahedral mesh until no hexahedron is inverted and all are as good as the "
               "connectivity allows.");
  Options options;
  add_options(app, options);
  options.command = command_line(argc, argv);
  app.parse_complete_callback([&] {
    if (options.output.empty() && !options.info)
      throw CLI::RequiredError("OUTPUT");
  });
  return run_program(app, argc, argv, [&] { return run(options); });
}
