// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PROGRAM_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PROGRAM_H

// The manners that the command-line programs share: exit codes, progress, interruption, the report in words, as JSON and as a
// page.

#include "files.h"
#include "Report_page.h"
#include "status_report.h"

#include <CGAL/Hex_mesh_optimization/IO/hex_mesh.h>
#include <CGAL/Hex_mesh_optimization/Input_error.h>
#include <CGAL/Hex_mesh_optimization/Status.h>
#include <CGAL/Hex_mesh_optimization/Visitor.h>
#include <CGAL/optimize_hex_mesh.h>

#include <CGAL/boost/graph/iterator.h>

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
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

enum Exit_code { SUCCESS = 0, REQUIREMENT_NOT_MET = 1, USAGE_ERROR = 2, FILE_ERROR = 3 };

// Of the optimization, which all programs have; with the default values of the named parameters.
struct Common_options
{
  std::string command; // all of the command line
  std::string output, json, report;
  double features_angle = 45;
  bool on_surface = false;
  double target_quality = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();
  double time_limit = std::numeric_limits<double>::infinity();
  int threads = 1;
  bool quiet = false;
};

inline void add_common_options(CLI::App& app, Common_options& o)
{
  app
    .add_option("--features-angle", o.features_angle,
                "an edge is sharp if the normals beside it differ by more than this")
    ->type_name("DEGREES")
    ->check(CLI::Range(0., 180.).description(""))
    ->capture_default_str();
  app.add_flag("--on-surface", o.on_surface, "keep every vertex of the boundary on the surface exactly");
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
  app.add_option("--report", o.report, "write a page to look at, in one .html file: meshes, numbers, places")
    ->type_name("FILE")
    ->check(CLI::Validator([](const std::string&) { return Report_page::reason_of_absence(); }, ""));
  app.add_flag("--quiet", o.quiet, "print nothing but errors");
  app.set_version_flag("--version", CGAL_HEX_MESH_OPTIMIZATION_VERSION, "print the version of the package and exit");
}

inline void add_edge_lengths(CLI::App& app, std::string& lengths)
{
  app
    .add_option(
      "--edge-lengths", lengths,
      "target lengths of edges: estimated from the boundary, or as in the input (for meshes graded on purpose)")
    ->type_name("LENGTHS")
    ->check(CLI::IsMember({"estimated", "input"}))
    ->capture_default_str();
}

inline HMO::Target_edge_lengths target_edge_lengths(const std::string& lengths)
{
  return lengths == "input" ? HMO::Target_edge_lengths::INPUT : HMO::Target_edge_lengths::ESTIMATED;
}

// Adds them to those of one program. Numbers that are not finite become null.
inline Json with_common_options(Json of_program, const Common_options& o)
{
  of_program.update(Json{{"output", o.output},
                         {"features_angle", o.features_angle},
                         {"on_surface", o.on_surface},
                         {"target_quality", o.target_quality},
                         {"maximum_deviation", o.maximum_deviation},
                         {"time_limit", o.time_limit},
                         {"threads", o.threads}});
  return of_program;
}

inline volatile std::sig_atomic_t is_interrupted = 0;

inline void interrupt(int signal)
{
  is_interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// Remembers every iteration, shows the latest on a terminal, and ends the
// optimization when the user interrupts the program.
class Watcher
{
public:
  explicit Watcher(bool quiet) : shows_progress_(!quiet && is_terminal())
  {
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
  }

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

// The named parameters of the optimization.
inline auto common_parameters(const Common_options& o, Watcher& watcher)
{
  return CGAL::parameters::features_angle_bound(o.features_angle)
    .boundary_placement(o.on_surface ? HMO::Boundary_placement::ON_SURFACE : HMO::Boundary_placement::WITHIN_TOLERANCE)
    .target_quality(o.target_quality)
    .maximum_deviation(o.maximum_deviation)
    .maximum_running_time(o.time_limit)
    .visitor(std::ref(watcher));
}

struct Mesh
{
  Points points;
  Hexahedra hexahedra;
  CGAL::IO::Hex_mesh_data mesh_data;
  Solver_file file;                     // of a solver, if it is one
  bool is_copied = false;               // to a file of the same format, with the numbering of its hexahedra
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

inline void check_reports(const Common_options& o)
{
  for (const std::string& report : {o.json, o.report})
    if (!report.empty())
      check_writable(report);
}

// What work() returns; its parallel algorithms have so many threads, or one where there is no TBB.
template <class Work>
auto in_threads(int number, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, number);
  return tbb::task_arena(number).execute(work);
#else
  (void)number;
  return work();
#endif
}

inline void print_connectivity_limits(const HMO::Status& status)
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

inline void print(const Report_row& row)
{
  std::cout << std::left << std::setw(32) << row.title << std::right << std::setw(12) << row.before << std::setw(12)
            << row.after << '\n';
}

// described: the mesh, or what else knows the centers of hexahedra
template <class Described>
void print_report(const HMO::Status& status, const Described& mesh, const Labels& labels = Labels())
{
  for (const Report_row& row : table(status, labels))
    print(row);
  std::cout << "Stopped after " << status.iterations << " iterations: " << in_words(status.return_code) << ".\n";
  if (status.number_of_reoriented_hexahedra() > 0)
    std::cout << status.number_of_reoriented_hexahedra() << " hexahedra were numbered inside out: they are written "
              << (mesh.is_copied ? "as they were numbered.\n" : "with bottom and top exchanged.\n");
  if (mesh.number_of_merged() > 0)
    std::cout << mesh.number_of_merged() << " vertices coincide with others and were merged with them.\n";
  if (status.number_of_coincident_vertices > 0)
    std::cout << status.number_of_coincident_vertices
              << " vertices coincide with others: faces are in the same place, but their hexahedra are no neighbors,"
              << " and may part (--merge makes them neighbors).\n";
  if (!status.is_within_deviation_bound())
    std::cout << "The deviation bound is not "
              << (status.deviation.maximum > status.deviation_bound ? "met" : "certified")
              << ": the maximum is between " << text(status.deviation.maximum) << " and "
              << text(status.deviation.certified) << ", the bound is " << text(status.deviation_bound) << ".\n";
  if (!status.vertices_off_reference.empty())
    std::cout << text(status.vertices_off_reference.size())
              << " vertices are not on the corner, curve or face of the reference that they belong to"
              << " (--json lists them).\n";
  for (const std::string& sentence : in_words(status.volume_changes, labels))
    std::cout << sentence << '\n';
  print_connectivity_limits(status);
  if (status.valid_mesh()) {
    std::cout << "The mesh is valid.\n";
    return;
  }
  const std::vector<std::size_t>& invalid = status.invalid_hexahedra;
  const std::size_t shown = (std::min)(invalid.size(), std::size_t(20));
  std::cout << "The mesh is not valid. Invalid hexahedra and their centers"
            << (shown < invalid.size() ? ", the first " + text(shown) + " of " + text(invalid.size()) : std::string())
            << ":\n";
  for (std::size_t i = 0; i < shown; ++i)
    std::cout << std::setw(10) << invalid[i] << "  (" << mesh.center(invalid[i]) << ")\n";
  if (!status.locked_hexahedra.empty())
    std::cout << text(status.locked_hexahedra.size())
              << " of them have an inverted corner whose vertices are all fixed.\n";
}

template <class Described>
Json json_of(const HMO::Status& status, const Described& mesh, const Labels& labels = Labels())
{
  return json(
    status, [&mesh](std::size_t h) { return mesh.center(h); }, labels);
}

inline Json json(const HMO::Status& status, const Mesh& mesh, const Labels& labels = Labels())
{
  return json_of(status, mesh, labels);
}

inline void write_json(const std::string& filename, const Json& report)
{
  write_text(filename, report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); // names in any encoding
}

// report: as for write_json()
inline void write_page(Report_page& page, const Common_options& o, const HMO::Status& status, const Json& report)
{
  page.add("command", o.command);
  page.add("why_it_stopped", in_words(status.return_code));
  page.write(o.report, std::filesystem::path(o.output).filename().string(), report);
}

// The surface from which the page measures deviations.
inline void set_reference(Report_page& page, const Surface& surface)
{
  Soup soup;
  std::vector<std::size_t> number(surface.num_vertices());
  for (const auto v : surface.vertices()) {
    number[v] = soup.points.size();
    const auto& p = surface.point(v);
    soup.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : surface.faces()) {
    soup.triangles.emplace_back();
    std::size_t corner = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      soup.triangles.back()[corner++] = number[v];
  }
  page.set_reference(soup.points, soup.triangles);
}

// What run() returns, or the exit code of what it throws or the command line deserves.
template <class Run>
int run_program(CLI::App& app, int argc, char** argv, const Run& run)
{
  try {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : USAGE_ERROR; // 0: --help, --version
  }

  try {
    return run();
  }
  catch (const HMO::Input_error& error) {
    std::cerr << "error: " << error.message() << '\n';
    return error.element() == HMO::Input_error::Element::PARAMETER ? USAGE_ERROR : FILE_ERROR;
  }
  catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return FILE_ERROR;
  }
}

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_PROGRAM_H
