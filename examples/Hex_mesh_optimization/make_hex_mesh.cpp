// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: reads a surface, makes a hexahedral mesh of what it bounds, writes it, and tells how good it is.

#include "boundary_patches.h"
#include "program.h"

#include <CGAL/make_hex_mesh.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

const char* const exit_codes =
  "The format of a surface (.off, .obj, .stl, .ply, .mesh, .vtk, .vtu) and of a mesh (.mesh, .vtk, .vtu, .inp for\n"
  "Abaqus and CalculiX, .msh for Gmsh, .e or .exo for Exodus II) is told by the extension. In files of solvers, each\n"
  "smooth patch of the boundary is a named set of faces.\n"
  "Interrupted (Ctrl-C), the program writes the best mesh so far; interrupted twice, it ends without.\n"
  "Vertices, faces and hexahedra are counted from 0.\n"
  "\n"
  "Exit codes:\n"
  "  0  OUTPUT is written and valid\n"
  "  1  OUTPUT is written, but invalid hexahedra remain, or --max-deviation is not met\n"
  "  2  wrong usage; nothing is written\n"
  "  3  a file cannot be read, used or written, SURFACE bounds no volume, or memory is short; OUTPUT is not written";

struct Options : Common_options
{
  const HMO::internal::Meshing_parameters of_meshing;

  std::string surface;
  std::size_t cells = of_meshing.number_of_hexahedra;
  double spacing = of_meshing.spacing;
  std::size_t across = of_meshing.cells_across;
  bool repair = false;
};

void add_options(CLI::App& app, Options& o)
{
  app.footer(exit_codes);
  app.get_formatter()->column_width(34);
  app.add_option("SURFACE", o.surface, "the closed surface of the volume to mesh")->required();
  app.add_option("OUTPUT", o.output, "the file to write")->required();
  CLI::Option* const cells = app
                               .add_option("--cells", o.cells,
                                           "about how many hexahedra to make; more where thin parts need them")
                               ->type_name("N")
                               ->check(CLI::Range(std::size_t(1), std::size_t(100000000)).description(""))
                               ->capture_default_str();
  app.add_option("--spacing", o.spacing, "the length of the cells instead")
    ->type_name("LENGTH")
    ->check(CLI::PositiveNumber.description(""))
    ->excludes(cells);
  app.add_option("--across", o.across, "how many cells to have between opposite walls")
    ->type_name("N")
    ->check(CLI::Range(std::size_t(1), std::size_t(1000)).description(""))
    ->capture_default_str();
  app.add_flag("--repair", o.repair,
               "mend a surface that is open, intersects itself or is not oriented, where that is possible");
  add_common_options(app, o);
}

Json json(const Options& o)
{
  return with_common_options({{"surface", o.surface},
                              {"cells", o.spacing > 0 ? Json() : Json(o.cells)},
                              {"spacing", o.spacing > 0 ? Json(o.spacing) : Json()},
                              {"across", o.across},
                              {"repair", o.repair}},
                             o);
}

HMO::Meshing_status make(const Surface& surface, const Options& o, Mesh& mesh, Watcher& watcher)
{
  const auto np =
    common_parameters(o, watcher).number_of_hexahedra(o.cells).grid_spacing(o.spacing).cells_across(o.across);
  return in_threads(o.threads, [&] {
    return CGAL::make_hex_mesh<CGAL::Parallel_if_available_tag>(surface, mesh.points, mesh.hexahedra, np);
  });
}

// The mesh that the optimization starts from.
Mesh start(const Surface& surface, Options o)
{
  Mesh mesh;
  o.time_limit = 0;
  Watcher nobody(true);
  make(surface, o, mesh, nobody);
  return mesh;
}

// Where the thin faces of the surface are.
Report_page::Points thin_places(const Surface& surface, const HMO::Meshing_status& status)
{
  const std::vector<Surface::Face_index> faces(surface.faces_begin(), surface.faces_end());
  Report_page::Points places;
  for (std::size_t f : status.thin_faces) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (const auto v : surface.vertices_around_face(surface.halfedge(faces[f]))) {
      const auto& p = surface.point(v);
      sum = sum + Kernel::Vector_3(p.x(), p.y(), p.z()) / 3;
    }
    places.push_back(CGAL::ORIGIN + sum);
  }
  return places;
}

void write_page(const Options& o, const Surface& surface, const Mesh& mesh, const HMO::Meshing_status& status,
                const Json& report)
{
  const Mesh before = start(surface, o);
  Report_page page;
  set_reference(page, surface);
  page.add_mesh("before", "Start: voxels and layers", before.points, before.hexahedra);
  page.add_mesh("after", "Result", mesh.points, mesh.hexahedra);
  page.add_reference("Surface");
  page.add_places("thin_places", thin_places(surface, status));
  write_page(page, o, status, report);
}

Exit_code run(const Options& options)
{
  check_output(options.output);
  check_reports(options);
  Surface surface;
  read(options.surface, surface);
  if (options.repair)
    repair(surface);

  Mesh mesh;
  HMO::Meshing_status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(options.quiet);
    status = make(surface, options, mesh, watcher);
    iterations = watcher.iterations();
  }

  if (CGAL::IO::is_hex_mesh_file(options.output)) // a solver applies loads to sets of faces
    add_patches(mesh, options.features_angle);
  write(options.output, mesh.points, mesh.hexahedra, mesh.attachments);
  if (!options.quiet) {
    print_report(status, mesh);
    if (!status.has_topology_of_surface)
      std::cout
        << "THE MESH HAS NOT THE TOPOLOGY OF THE SURFACE: holes are closed, walls have holes, or parts are lost;"
        << " the spacing, " << text(status.spacing) << ", is too large for them.\n";
    if (!status.thin_faces.empty())
      std::cout << status.thin_faces.size() << " of " << surface.number_of_faces()
                << " faces of the surface have less than " << options.across
                << (options.across == 1 ? " cell" : " cells") << " behind them: parts there are thin for the spacing, "
                << text(status.spacing) << (options.json.empty() ? " (--json lists them)" : "") << ".\n";
  }
  Json of_status = json(status, mesh);
  of_status["spacing"] = status.spacing;
  of_status["has_topology_of_surface"] = status.has_topology_of_surface;
  of_status["thin_faces"] = status.thin_faces;
  const Json report = with_iterations({{"options", json(options)}, {"status", of_status}}, iterations);
  if (!options.json.empty())
    write_json(options.json, report);
  if (!options.report.empty())
    write_page(options, surface, mesh, status, report);
  return status.valid_mesh() && status.is_within_deviation_bound() ? ALL_IS_MET : SOMETHING_IS_NOT_MET;
}

int main(int argc, char** argv)
{
  CLI::App app("Makes a hexahedral mesh of the volume that a triangle surface bounds.");
  Options options;
  add_options(app, options);
  options.command = command_line(argc, argv);
  return run_program(app, argc, argv, [&] { return run(options); });
}
