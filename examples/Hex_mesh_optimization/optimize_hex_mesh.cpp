// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: reads a hexahedral mesh, optimizes it, writes it,
// and tells what became of it.

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/IO/surface.h>
#include <CGAL/Hex_mesh_optimization/coincident_vertices.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <boost/property_map/function_property_map.hpp>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace HMO = CGAL::Hex_mesh_optimization;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Json = nlohmann::ordered_json;

enum Exit_code { ALL_IS_MET = 0, SOMETHING_IS_NOT_MET = 1, USAGE_ERROR = 2, UNUSABLE_FILE = 3 };

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

struct Options
{
  const HMO::internal::Optimization_parameters defaults;

  std::string input, output, reference, frozen, label_array, json;
  double features_angle = defaults.features.angle_bound;
  bool merge = false;
  bool fixed_boundary = defaults.fixed_boundary;
  bool on_surface = defaults.boundary_placement == HMO::Boundary_placement::ON_SURFACE;
  std::string method = "full";
  std::string edge_lengths = "estimated";
  std::size_t iterations = defaults.rectification.iterations;
  std::size_t restarts = defaults.rectification.restarts;
  double maximum_deviation = defaults.maximum_deviation;
  double time_limit = defaults.maximum_running_time;
  double target_quality = defaults.target_quality;
  int threads = 1;
  bool quiet = false;
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
  app
    .add_option("--features-angle", o.features_angle,
                "an edge is sharp if the normals beside it differ by more than this")
    ->type_name("DEGREES")
    ->check(CLI::Range(0., 180.).description(""))
    ->capture_default_str();
  app.add_flag("--merge", o.merge,
               "hexahedra whose faces coincide are neighbors, though their vertices are not the same");
  app
    .add_option("--label-array", o.label_array,
                "the cell array of a .vtk or .vtu file with the labels of the hexahedra (default: by its name)")
    ->type_name("NAME");
  app.add_flag("--fixed-boundary", o.fixed_boundary, "move no vertex of the boundary");
  app.add_flag("--on-surface", o.on_surface, "keep every vertex of the boundary on the reference exactly");
  app.add_option("--frozen", o.frozen, "a text file with the numbers of vertices not to move, one a line")
    ->type_name("FILE");
  app
    .add_option("--method", o.method,
                "rectification or the maximization of quality alone, or one after the other (full)")
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
  app
    .add_option("--target-quality", o.target_quality,
                "stop once the mesh is valid and its minimum scaled Jacobian this good")
    ->type_name("QUALITY");
  app
    .add_option("--max-deviation", o.maximum_deviation,
                "how far the boundary and the reference may be apart, in both directions")
    ->type_name("LENGTH")
    ->check(CLI::PositiveNumber.description(""));
  app.add_option("--time-limit", o.time_limit, "stop after that time and write the best mesh so far")
    ->type_name("SECONDS")
    ->check(CLI::Range(0., 1e9).description(""));
  app.add_option("--threads", o.threads, "number of threads (one, if this program was built without TBB)")
    ->type_name("N")
    ->check(CLI::Range(1, 1024).description(""))
    ->capture_default_str();
  app.add_option("--json", o.json, "write the report, with every iteration, to this file")->type_name("FILE");
  app.add_flag("--quiet", o.quiet, "print nothing but errors");
}

volatile std::sig_atomic_t is_interrupted = 0;

void interrupt(int signal)
{
  is_interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// Remembers every iteration, shows the latest on a terminal, and ends the
// optimization when the user interrupts the program.
class Watcher
{
public:
  explicit Watcher(bool quiet) : shows_progress_(!quiet && is_terminal()) {}

  bool on_iteration(const HMO::Iteration& i)
  {
    iterations_.push_back(i);
    if (shows_progress_ && i.seconds >= next_) {
      next_ = i.seconds + .1; // no terminal needs more
      std::fprintf(stderr, "\r%.1f s  %s %zu: %zu inverted, scaled Jacobian minimum %.3f, mean %.3f\033[K", i.seconds,
                   HMO::name(i.stage), i.iteration, i.number_of_inverted, i.minimum, i.average);
      std::fflush(stderr);
    }
    return !is_interrupted;
  }

  ~Watcher()
  {
    if (next_ > 0)
      std::fprintf(stderr, "\r\033[K");
  }

  const std::vector<HMO::Iteration>& iterations() const { return iterations_; }

private:
  static bool is_terminal()
  {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
  }

  const bool shows_progress_;
  double next_ = 0; // seconds
  std::vector<HMO::Iteration> iterations_;
};

struct Mesh
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  CGAL::IO::Hex_mesh_attachments attachments;
  std::vector<std::size_t> merged_into; // another vertex, for each; empty: none is merged

  std::size_t number_of_merged() const
  {
    std::size_t sum = 0;
    for (std::size_t v = 0; v < merged_into.size(); ++v)
      sum += merged_into[v] != v;
    return sum;
  }

  Kernel::Point_3 center(std::size_t h) const
  {
    Kernel::Vector_3 sum(0, 0, 0);
    for (std::size_t v : hexahedra[h])
      sum = sum + (points[v] - CGAL::ORIGIN) / 8;
    return CGAL::ORIGIN + sum;
  }
};

// Throws now what would be thrown after all the work.
void check_writable(const std::string& filename)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(filename, ignored);
  if (std::filesystem::is_other(status)) // to open a pipe is to use it
    return;
  CGAL::Hex_mesh_optimization::internal::IO::Atomic_file unused(filename);
}

void check_output(const std::string& filename)
{
  const std::string extension = CGAL::Hex_mesh_optimization::internal::IO::extension_of(filename);
  if (extension != "mesh" && extension != "vtk" && extension != "vtu")
    CGAL::Hex_mesh_optimization::internal::IO::refuse_extension(filename);
  check_writable(filename);
}

// What becomes of the file beside points and hexahedra: one line for each thing that is lost.
std::vector<std::string> losses(const Mesh& mesh, const std::string& output)
{
  std::vector<std::string> result = mesh.attachments.left_out;
  for (const std::string& lost : CGAL::IO::lost_attachments(output, mesh.attachments))
    result.push_back(lost);
  return result;
}

Mesh read(const Options& options)
{
  Mesh mesh;
  CGAL::IO::read_hex_mesh(options.input, mesh.points, mesh.hexahedra, mesh.attachments);
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
  result.merged_into = HMO::coincident_vertices(mesh.points, mesh.hexahedra);
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

// What work() returns; its parallel algorithms have so many threads, or one where there is no TBB.
template <class Work>
HMO::Status in_threads(int number, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, number);
  return tbb::task_arena(number).execute(work);
#else
  (void)number;
  return work();
#endif
}

// The labels of the hexahedra of a file: those that occur, in increasing order, and the number of each hexahedron's own
// among them, which fits into any integer. With no labels, all hexahedra have the number 0.
struct Labels
{
  std::vector<std::int64_t> values;
  std::vector<int> numbers;

  explicit Labels(const std::vector<std::int64_t>& labels) : values(labels)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (std::int64_t l : labels)
      numbers.push_back(static_cast<int>(std::lower_bound(values.begin(), values.end(), l) - values.begin()));
  }

  int number(std::size_t hexahedron) const { return numbers.empty() ? 0 : numbers[hexahedron]; }
  std::int64_t value(int number) const { return values.empty() ? 0 : values[number]; }
};

// The quadrilaterals of a file that have a label: if hexahedra are on both sides, it is a face to be kept.
std::vector<std::array<std::size_t, 4>> labelled_faces(const CGAL::IO::Hex_mesh_attachments& attachments)
{
  std::vector<std::array<std::size_t, 4>> result;
  for (const auto& quadrilateral : attachments.labelled_quadrilaterals())
    if (quadrilateral.label != 0)
      result.push_back(quadrilateral.vertices);
  return result;
}

HMO::Status optimize(Mesh& mesh, const Labels& labels, const Options& o, Watcher& watcher)
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);

  std::set<std::size_t> frozen;
  if (!o.frozen.empty())
    for (std::size_t v : read_vertices(o.frozen, mesh.points.size()))
      frozen.insert(mesh.merged_into.empty() ? v : mesh.merged_into[v]);
  const auto np = CGAL::parameters::features_angle_bound(o.features_angle)
                    .hexahedron_label_map(boost::make_function_property_map<std::size_t>(
                      [&](std::size_t h) { return labels.number(h); }))
                    .internal_faces(labelled_faces(mesh.attachments))
                    .fixed_boundary(o.fixed_boundary)
                    .boundary_placement(o.on_surface ? HMO::Boundary_placement::ON_SURFACE
                                                     : HMO::Boundary_placement::WITHIN_TOLERANCE)
                    .vertex_is_constrained_map(CGAL::make_boolean_property_map(frozen))
                    .optimization_method(o.method == "full"            ? HMO::Method::FULL
                                         : o.method == "rectification" ? HMO::Method::RECTIFICATION
                                                                       : HMO::Method::MAXIMIZATION)
                    .target_edge_lengths(o.edge_lengths == "input" ? HMO::Target_edge_lengths::INPUT
                                                                   : HMO::Target_edge_lengths::ESTIMATED)
                    .number_of_iterations(o.iterations)
                    .number_of_restarts(o.restarts)
                    .target_quality(o.target_quality)
                    .maximum_deviation(o.maximum_deviation)
                    .maximum_running_time(o.time_limit)
                    .visitor(std::ref(watcher));
  Surface_mesh reference;
  if (!o.reference.empty())
    CGAL::IO::read_surface(o.reference, reference);
  return in_threads(o.threads, [&] {
    using Tag = CGAL::Parallel_if_available_tag;
    return o.reference.empty() ? CGAL::optimize_hex_mesh<Tag>(mesh.points, mesh.hexahedra, np)
                               : CGAL::optimize_hex_mesh<Tag>(mesh.points, mesh.hexahedra, reference, np);
  });
}

const char* in_words(HMO::Return_code code)
{
  switch (code) {
  case HMO::Return_code::CONVERGED:
    return "further iterations would not improve the mesh";
  case HMO::Return_code::TARGET_QUALITY_REACHED:
    return "the target quality is reached";
  case HMO::Return_code::ITERATION_LIMIT:
    return "the iterations of the last stage were used up while the mesh still changed";
  case HMO::Return_code::TIME_LIMIT:
    return "the time limit was reached";
  case HMO::Return_code::STOPPED_BY_VISITOR:
    return "interrupted";
  case HMO::Return_code::DEVIATION_BOUND_NOT_MET:
    return "the boundary is not shown to be as close to the reference as asked for";
  case HMO::Return_code::NO_IMPROVEMENT:
    return "nothing better than the input was found, which is unchanged";
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

void print_row(const std::string& title, const std::string& before, const std::string& after)
{
  std::cout << std::left << std::setw(32) << title << std::right << std::setw(12) << before << std::setw(12) << after
            << '\n';
}

void print_connectivity_limits(const HMO::Status& status)
{
  const std::vector<HMO::Connectivity_limit>& limits = status.connectivity_limits;
  const std::size_t reached = std::count_if(limits.begin(), limits.end(), [](const auto& l) { return l.is_reached(); });
  if (reached > 0)
    std::cout << reached
              << " hexahedra are at the limit that the connectivity sets (--json lists them with reasons).\n";
  if (limits.size() > reached)
    std::cout << limits.size() - reached << (reached > 0 ? " more" : " hexahedra")
              << " have a limit below 1 from the connectivity and are below it.\n";
}

void print_report(const HMO::Status& status, const Mesh& mesh, const Labels& labels)
{
  const auto row = [&status](const char* title, auto HMO::Quality_statistics::*number) {
    print_row(title, text(status.before.*number), text(status.after.*number));
  };
  print_row("", "before", "after");
  row("hexahedra", &HMO::Quality_statistics::number_of_hexahedra);
  row("inverted", &HMO::Quality_statistics::number_of_inverted);
  row("invalid", &HMO::Quality_statistics::number_of_invalid);
  row("minimum scaled Jacobian", &HMO::Quality_statistics::minimum);
  row("mean scaled Jacobian", &HMO::Quality_statistics::average);
  row("standard deviation", &HMO::Quality_statistics::standard_deviation);
  row("99th percentile of edge ratio", &HMO::Quality_statistics::edge_ratio_99);
  print_row("volume", text(status.volume_before), text(status.volume_after));
  if (status.regions.size() > 1)
    for (const HMO::Region_volume& region : status.regions)
      print_row("  of label " + std::to_string(labels.value(region.label)), text(region.before), text(region.after));
  print_row("average deviation / diagonal", "", text(status.deviation.average_relative));
  print_row("maximum deviation / diagonal", "", text(status.deviation.maximum_relative));
  for (const HMO::Interface_statistics& i : status.interfaces)
    print_row("  between labels " + std::to_string(labels.value(i.labels[0])) + " and " +
                std::to_string(labels.value(i.labels[1])),
              "", text(i.deviation.maximum_relative));
  if (std::isfinite(status.deviation_bound))
    print_row("certified maximum, as a length", "", text(status.deviation.certified));
  print_row("seconds", "", text(status.total_seconds));
  print_row("  of rectification", "", text(status.rectification_seconds));
  print_row("  of untangling", "", text(status.untangling_seconds));
  print_row("  of maximization", "", text(status.maximization_seconds));

  std::cout << "Stopped after " << status.iterations << " iterations: " << in_words(status.return_code) << ".\n";
  if (status.number_of_turned_hexahedra() > 0)
    std::cout << status.number_of_turned_hexahedra()
              << " hexahedra were numbered inside out: they are written with bottom and top exchanged.\n";
  if (mesh.number_of_merged() > 0)
    std::cout << mesh.number_of_merged() << " vertices coincide with others and were merged with them.\n";
  if (status.number_of_coincident_vertices > 0)
    std::cout << status.number_of_coincident_vertices
              << " vertices coincide with others: faces are in the same place, but their hexahedra are no neighbors,"
              << " and may part (--merge makes them neighbors).\n";
  if (!status.is_within_deviation_bound())
    std::cout << "THE BOUND OF THE DEVIATION IS NOT "
              << (status.deviation.maximum > status.deviation_bound ? "MET" : "SHOWN TO BE MET")
              << ": the maximum is between " << text(status.deviation.maximum) << " and "
              << text(status.deviation.certified) << ", the bound " << text(status.deviation_bound) << ".\n";
  if (!status.released_vertices.empty())
    std::cout << text(status.released_vertices.size())
              << " vertices could not be brought to the corners, curves or faces of the reference"
              << " that they belong to (--json lists them).\n";
  print_connectivity_limits(status);
  if (status.valid_mesh()) {
    std::cout << "The mesh is valid.\n";
    return;
  }
  const std::vector<std::size_t>& invalid = status.invalid_hexahedra;
  const std::size_t shown = (std::min)(invalid.size(), std::size_t(20));
  std::cout << "THE MESH IS NOT VALID. Invalid hexahedra and their centers"
            << (shown < invalid.size() ? ", the first " + text(shown) + " of " + text(invalid.size()) : std::string())
            << ":\n";
  for (std::size_t i = 0; i < shown; ++i)
    std::cout << std::setw(10) << invalid[i] << "  (" << mesh.center(invalid[i]) << ")\n";
  if (!status.locked_hexahedra.empty())
    std::cout << text(status.locked_hexahedra.size())
              << " of them have an inverted corner whose vertices are all fixed.\n";
}

// The report has the members of the structs, and the enumerators, under their own names.
Json json(HMO::Return_code code)
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

Json json(const HMO::Quality_statistics& s)
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

Json json(HMO::Stage stage)
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

Json json(const HMO::Iteration& i)
{
  return {{"stage", json(i.stage)}, {"iteration", i.iteration},
          {"energy", i.energy},     {"number_of_inverted", i.number_of_inverted},
          {"minimum", i.minimum},   {"average", i.average},
          {"seconds", i.seconds}};
}

// Numbers that are not finite become null.
Json json(const Options& o)
{
  return {{"input", o.input},
          {"output", o.output},
          {"reference", o.reference.empty() ? Json() : Json(o.reference)},
          {"features_angle", o.features_angle},
          {"merge", o.merge},
          {"label_array", o.label_array.empty() ? Json() : Json(o.label_array)},
          {"fixed_boundary", o.fixed_boundary},
          {"on_surface", o.on_surface},
          {"frozen", o.frozen.empty() ? Json() : Json(o.frozen)},
          {"method", o.method},
          {"edge_lengths", o.edge_lengths},
          {"iterations", o.iterations},
          {"restarts", o.restarts},
          {"target_quality", o.target_quality},
          {"maximum_deviation", o.maximum_deviation},
          {"time_limit", o.time_limit},
          {"threads", o.threads}};
}

Json json(const HMO::Status& status, const Mesh& mesh, const Labels& labels)
{
  Json invalid = Json::array();
  for (std::size_t h : status.invalid_hexahedra) {
    const Kernel::Point_3 c = mesh.center(h);
    invalid.push_back({{"id", h}, {"center", {c.x(), c.y(), c.z()}}});
  }
  Json limits = Json::array();
  for (const HMO::Connectivity_limit& l : status.connectivity_limits)
    limits.push_back({{"hexahedron", l.hexahedron},
                      {"reason", HMO::description(l.reason)},
                      {"largest_scaled_jacobian", l.largest_scaled_jacobian},
                      {"scaled_jacobian", l.scaled_jacobian},
                      {"is_reached", l.is_reached()}});
  Json regions = Json::array(), interfaces = Json::array();
  for (const HMO::Region_volume& r : status.regions)
    regions.push_back({{"label", labels.value(r.label)}, {"volume_before", r.before}, {"volume_after", r.after}});
  for (const HMO::Interface_statistics& i : status.interfaces)
    interfaces.push_back({{"labels", {labels.value(i.labels[0]), labels.value(i.labels[1])}},
                          {"number_of_faces", i.number_of_faces},
                          {"average_deviation", i.deviation.average},
                          {"maximum_deviation", i.deviation.maximum}});
  return {{"return_code", json(status.return_code)},
          {"valid_mesh", status.valid_mesh()},
          {"number_of_turned_hexahedra", status.number_of_turned_hexahedra()},
          {"turned_hexahedra", status.turned_hexahedra},
          {"number_of_coincident_vertices", status.number_of_coincident_vertices},
          {"before", json(status.before)},
          {"after", json(status.after)},
          {"volume_before", status.volume_before},
          {"volume_after", status.volume_after},
          {"regions", regions},
          {"interfaces", interfaces},
          {"deviation",
           {{"average", status.deviation.average},
            {"maximum", status.deviation.maximum},
            {"average_relative", status.deviation.average_relative},
            {"maximum_relative", status.deviation.maximum_relative},
            {"certified", status.deviation.certified},
            {"bilinear", status.deviation.bilinear}}},
          {"is_within_deviation_bound", status.is_within_deviation_bound()},
          {"iterations", status.iterations},
          {"rectification_seconds", status.rectification_seconds},
          {"untangling_seconds", status.untangling_seconds},
          {"maximization_seconds", status.maximization_seconds},
          {"total_seconds", status.total_seconds},
          {"deviation_bound", status.deviation_bound},
          {"invalid_hexahedra", invalid},
          {"locked_hexahedra", status.locked_hexahedra},
          {"released_vertices", status.released_vertices},
          {"connectivity_limits", limits}};
}

void write_json(const Options& options, const HMO::Status& status, const Mesh& mesh, const Labels& labels,
                const std::vector<std::string>& lost, const std::vector<HMO::Iteration>& iterations)
{
  Json report = {{"options", json(options)},
                 {"status", json(status, mesh, labels)},
                 {"number_of_merged_vertices", mesh.number_of_merged()},
                 {"labels",
                  {{"array", mesh.attachments.label_array.empty() ? Json() : Json(mesh.attachments.label_array)},
                   {"number_of_labeled_hexahedra", mesh.attachments.hexahedron_labels.size()}}},
                 {"lost", lost},
                 {"iterations", Json::array()}};
  for (const HMO::Iteration& i : iterations)
    report["iterations"].push_back(json(i));
  CGAL::Hex_mesh_optimization::internal::IO::Atomic_file file(options.json);
  file.text() = report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; // file names may be in any encoding
  file.commit();
}

Exit_code run(const Options& options)
{
  check_output(options.output);
  if (!options.json.empty())
    check_writable(options.json);

  Mesh mesh = read(options);
  const std::vector<std::string> lost = losses(mesh, options.output);
  if (!options.quiet)
    for (const std::string& line : lost)
      std::cerr << "warning: not in the output: " << line << '\n';

  const Labels labels(mesh.attachments.hexahedron_labels);
  HMO::Status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(options.quiet);
    if (options.merge) {
      Mesh one = merged(mesh);
      status = optimize(one, labels, options, watcher);
      mesh.merged_into = std::move(one.merged_into);
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
        mesh.points[v] = one.points[mesh.merged_into[v]];
    }
    else
      status = optimize(mesh, labels, options, watcher);
    iterations = watcher.iterations();
  }
  for (std::size_t h : status.turned_hexahedra)
    std::swap_ranges(mesh.hexahedra[h].begin(), mesh.hexahedra[h].begin() + 4, mesh.hexahedra[h].begin() + 4);

  CGAL::IO::write_hex_mesh(options.output, mesh.points, mesh.hexahedra, mesh.attachments);
  if (!options.quiet)
    print_report(status, mesh, labels);
  if (!options.json.empty())
    write_json(options, status, mesh, labels, lost, iterations);
  return status.valid_mesh() && status.is_within_deviation_bound() ? ALL_IS_MET : SOMETHING_IS_NOT_MET;
}

int main(int argc, char** argv)
{
  CLI::App app("Moves the vertices of a hexahedral mesh until no hexahedron is inverted and all are as good as the "
               "connectivity allows.");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : USAGE_ERROR; // 0: --help
  }

  try {
    return run(options);
  }
  catch (const HMO::Input_error& error) {
    std::cerr << "error: " << error.message() << '\n';
    return error.element() == HMO::Input_error::Element::PARAMETER ? USAGE_ERROR : UNUSABLE_FILE;
  }
  catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return UNUSABLE_FILE;
  }
}
