// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program for clusters: optimizes a mesh in a file by all processes that MPI starts.

#include "parts.h"
#include "program.h"

#include <CGAL/optimize_hex_mesh_file_mpi.h>

#include <CLI/CLI.hpp>

#include <petscsys.h>

#include <iostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

const char* const about_files =
  "mpirun -n 64 optimize_hex_mesh_mpi in.vtu out.vtu\n"
  "Only .vtu files with one piece of hexahedra and raw appended data, with points of 64 bits, can be read. All "
  "processes\n"
  "must see the same files. OUTPUT depends on the number of parts, and not on that of processes.\n"
  "SIGTERM ends the run with the best mesh so far.\n"
  "\n"
  "Exit codes: those of optimize_hex_mesh";

struct Options : Common_options
{
  std::string input, label_array;
  bool fixed_boundary = false;
  std::string edge_lengths = "estimated";
  Options_of_parts parts;
};

void add_options(CLI::App& app, Options& o)
{
  app.footer(about_files);
  app.get_formatter()->column_width(34);
  app.add_option("INPUT", o.input, "the mesh to optimize")->required();
  app.add_option("OUTPUT", o.output, "the file to write; may be INPUT")->required();
  app.add_option("--parts", o.parts.division.number_of_parts, "number of parts (default: that of the processes)")
    ->type_name("N")
    ->check(CLI::Range(1, 1000000).description(""));
  add_layers(app, o.parts);
  app
    .add_option("--label-array", o.label_array,
                "the cell array with the labels of the hexahedra (default: by its name)")
    ->type_name("NAME");
  app.add_flag("--fixed-boundary", o.fixed_boundary, "move no vertex of the boundary");
  add_edge_lengths(app, o.edge_lengths);
  add_common_options(app, o);
}

Json json(const Options& o, int number_of_ranks)
{
  return with_common_options({{"input", o.input},
                              {"label_array", o.label_array.empty() ? Json() : Json(o.label_array)},
                              {"fixed_boundary", o.fixed_boundary},
                              {"edge_lengths", o.edge_lengths},
                              {"parts", o.parts.division.number_of_parts},
                              {"layers", o.parts.division.layers},
                              {"ranks", number_of_ranks}},
                             o);
}

int run(const Options& o, int rank, int number_of_ranks)
{
  if (!o.report.empty())
    throw HMO::Input_error(HMO::Input_error::Element::PARAMETER, 0, "there is no page of a mesh in parts");
  if (rank == 0) {
    check_reports(o);
    check_writable(o.output);
  }
  HMO::Mesh_division division = o.parts.division;
  division.label_array = o.label_array;
  HMO::Status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(o.quiet || rank > 0);
    const auto np = common_parameters(o, watcher)
                      .fixed_boundary(o.fixed_boundary)
                      .target_edge_lengths(target_edge_lengths(o.edge_lengths));
    status = in_threads(o.threads, [&] {
      return CGAL::optimize_hex_mesh_file_mpi<CGAL::Parallel_if_available_tag>(PETSC_COMM_WORLD, o.input, o.output,
                                                                               division, np);
    });
    iterations = watcher.iterations();
  }
  if (rank > 0)
    return status.valid_mesh() && status.is_within_deviation_bound() ? SUCCESS : REQUIREMENT_NOT_MET;
  const Json options = json(o, number_of_ranks);
  return report_parts(o, status, o.output, with_iterations({{"options", options}}, iterations));
}

int main(int argc, char** argv)
{
  // the options are those of this program, and not of PETSc, which would catch signals too
  if (PetscInitializeNoArguments() != 0)
    return FILE_ERROR;
  PetscPopSignalHandler();
  int rank = 0, size = 1;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  MPI_Comm_size(PETSC_COMM_WORLD, &size);
  CLI::App app(
    "Moves the vertices of a hexahedral mesh in a file until no hexahedron is inverted and all are as good as the "
    "connectivity allows: part by part, by all processes that MPI starts.");
  Options options;
  add_options(app, options);
  options.command = command_line(argc, argv);
  bool is_run = false;
  // all ranks understand the same of the command line, of which one speaks
  std::ostringstream unheard;
  std::streambuf* const heard[] = {std::cout.rdbuf(), std::cerr.rdbuf()};
  if (rank > 0) {
    std::cout.rdbuf(unheard.rdbuf());
    std::cerr.rdbuf(unheard.rdbuf());
  }
  const int code = run_program(app, argc, argv, [&] {
    std::cerr.rdbuf(heard[1]);
    is_run = true;
    const int result = run(options, rank, size);
    is_run = false;
    return result;
  });
  std::cout.rdbuf(heard[0]);
  std::cerr.rdbuf(heard[1]);
  if (is_run) // it has thrown: the other ranks would wait in vain
    MPI_Abort(PETSC_COMM_WORLD, code);
  PetscFinalize();
  return code;
}
