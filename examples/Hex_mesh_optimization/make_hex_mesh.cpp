// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: reads a surface, makes a hexahedral mesh of what it bounds, writes it, and tells how good it is.

#include "boundary_patches.h"
#include "program.h"

#include <CGAL/make_hex_mesh.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

const char* const exit_codes =
  "The format of a surface (.off, .obj, .stl, .ply, .mesh, .vtk, .vtu) and of a mesh (.mesh, .vtk, .vtu, .inp for\n"
  "Abaqus and CalculiX, .msh for Gmsh, .e or .exo for Exodus II) is told by the extension. In files of solvers, each\n"
  "smooth patch of the boundary is a named set of faces.\n"
  "Interrupted (Ctrl-C), the program writes the best mesh so far; interrupted twice, it ends without.\n"
  "Vertices, faces and hexahedra are counted from 0.\n"
  "\n"
  "Exit codes:\n"
  "  0  OUTPUT is written and valid, and has the volume, the bodies and the topology that SURFACE bounds\n"
  "  1  OUTPUT is written, but invalid hexahedra remain, it differs from SURFACE by more than its cells explain, or\n"
  "     --max-deviation is not met\n"
  "  2  wrong usage; nothing is written\n"
  "  3  a file cannot be read, used or written, SURFACE bounds no volume or is too fine for the cells, or memory is\n"
  "     short; OUTPUT is not written";

struct Options : Common_options
{
  std::vector<std::string> surfaces;
  std::size_t cells = 8000;
  double spacing = 0; // that of so many cells
  std::size_t minimum_cells_across = 1;
  bool repair = false, materials = false;
};

void add_options(CLI::App& app, Options& o)
{
  app.footer(exit_codes);
  app.get_formatter()->column_width(34);
  app
    .add_option(
      "SURFACE", o.surfaces,
      "the surface of the volume to mesh: closed parts, which may overlap or touch; one file, or several. The\n"
      "last of the files is OUTPUT, the one to write")
    ->required()
    ->type_name("FILE")
    ->expected(2, 1000000);
  app.parse_complete_callback([&o] {
    o.output = o.surfaces.back();
    o.surfaces.pop_back();
  });
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
  app.add_option("--min-cells-across", o.minimum_cells_across, "how many cells to have between opposite walls")
    ->type_name("N")
    ->check(CLI::Range(std::size_t(1), std::size_t(1000)).description(""))
    ->capture_default_str();
  CLI::Option* const repair = app.add_flag(
    "--repair", o.repair, "close holes of any size, and leave out vertices that were pulled through the opposite side");
  app
    .add_flag(
      "--materials", o.materials,
      "parts stay apart: each file, each solid of one .stl file, or else each closed part, gets a label, counted\n"
      "from 1, with interfaces between them; where parts overlap, the later one is")
    ->excludes(repair);
  add_common_options(app, o);
}

Json json(const Options& o)
{
  return with_common_options({{"surface", o.surfaces.size() == 1 ? Json(o.surfaces[0]) : Json(o.surfaces)},
                              {"cells", o.spacing > 0 ? Json() : Json(o.cells)},
                              {"spacing", o.spacing > 0 ? Json(o.spacing) : Json()},
                              {"minimum_cells_across", o.minimum_cells_across},
                              {"repair", o.repair},
                              {"materials", o.materials}},
                             o);
}

// What the files have together.
struct Input
{
  Soup surface;
  std::vector<int> labels; // of its triangles, if parts stay apart
};

HMO::Meshing_status make(const Input& input, const Options& o, Mesh& mesh, Watcher& watcher)
{
  const Soup& surface = input.surface;
  const auto np = common_parameters(o, watcher)
                    .number_of_hexahedra(o.cells)
                    .grid_spacing(o.spacing)
                    .minimum_cells_across(o.minimum_cells_across);
  return in_threads(o.threads, [&] {
    using Tag = CGAL::Parallel_if_available_tag;
    if (!o.materials)
      return CGAL::make_hex_mesh<Tag>(surface.points, surface.triangles, mesh.points, mesh.hexahedra, np);
    return CGAL::make_hex_mesh<Tag>(surface.points, surface.triangles, mesh.points, mesh.hexahedra,
                                    np.face_label_map(CGAL::make_property_map(input.labels)));
  });
}

// The mesh that the optimization starts from.
Mesh start(const Input& input, Options o)
{
  Mesh mesh;
  o.time_limit = 0;
  Watcher nobody(true);
  make(input, o, mesh, nobody);
  return mesh;
}

// Where the thin faces of the surface are.
Report_page::Points thin_places(const Soup& surface, const HMO::Meshing_status& status)
{
  Report_page::Points places;
  for (std::size_t f : status.thin_faces) {
    const std::array<std::size_t, 3>& t = surface.triangles[f];
    places.push_back(CGAL::centroid(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
  }
  return places;
}

void write_page(const Options& o, const Input& input, const Mesh& mesh, const HMO::Meshing_status& status,
                const Json& report)
{
  const Soup& surface = input.surface;
  const Mesh before = start(input, o);
  Report_page page;
  page.set_reference(surface.points, surface.triangles);
  page.add_mesh("before", "Start: voxels and layers", before.points, before.hexahedra);
  page.add_mesh("after", "Result", mesh.points, mesh.hexahedra);
  page.add_reference("Surface");
  if (!status.labels.empty() && status.labels.size() == before.hexahedra.size())
    page.add_labels(status.labels);
  page.add_places("thin_places", thin_places(surface, status));
  write_page(page, o, status, report);
}

void print(const HMO::Surface_repair& repair)
{
  if (repair.number_of_filled_holes > 0)
    std::cout << "Repaired: " << repair.number_of_filled_holes << " holes of the surface were closed, the largest "
              << text(repair.largest_filled_hole) << " across.\n";
  if (repair.number_of_skipped_vertices > 0) {
    std::cout << "Repaired: " << repair.number_of_skipped_vertices
              << " vertices that were pulled through the opposite side were skipped, the farthest "
              << text(repair.farthest) << " away from the surface as it is now; the volume was "
              << text(repair.volume_before) << " before and is " << text(repair.volume_after) << " now:\n";
    for (const auto& p : repair.skipped_vertices)
      std::cout << "          (" << p[0] << ' ' << p[1] << ' ' << p[2] << ")\n";
  }
}

// One line for each thing that was not taken as it was given.
void print(const HMO::Surface_report& surface)
{
  const auto say = [](std::size_t number, const std::string& what) {
    if (number > 0)
      std::cout << "Surface: " << number << ' ' << what << ".\n";
  };
  say(surface.number_of_copies, "faces are copies of others, and were used once");
  say(surface.number_without_area, "faces have no area, and were skipped");
  say(surface.number_of_stitched_vertices,
      "vertices of borders were stitched to other borders, the farthest moved by " + text(surface.farthest_moved));
  say(surface.number_of_aligned_vertices, "vertices where parts touch but for rounding were moved into common planes");
  say(surface.number_of_filled_holes,
      "holes smaller than a cell were closed, the largest " + text(surface.largest_filled_hole) + " across");
  say(surface.number_of_reoriented_parts, "closed parts were inside out, and were reoriented");
  say(surface.number_of_faces_within, "pieces of faces are inside the volume, or bound none, and were skipped");
  say(surface.number_of_small_components,
      "bodies or cavities of less than a thousandth of a cell were skipped, their volume is " +
        text(surface.volume_of_small_components));
  if (surface.number_of_parts > 1)
    std::cout << "Surface: its " << surface.number_of_parts << " closed parts bound " << surface.number_of_bodies
              << (surface.number_of_bodies == 1 ? " body.\n" : " bodies.\n");
}

void print_differences(const HMO::Meshing_status& status)
{
  const HMO::Surface_report& surface = status.surface;
  print(Report_row{"volume of the surface", "", text(surface.volume)});
  print(Report_row{"bodies", text(surface.number_of_bodies), text(status.number_of_bodies)});
  print(Report_row{"Euler characteristic", text(surface.euler_characteristic), text(status.euler_characteristic)});
  if (status.number_of_bodies != surface.number_of_bodies)
    std::cout << "The mesh has " << status.number_of_bodies << " bodies; the surface bounds "
              << surface.number_of_bodies << ".\n";
  if (!status.has_topology_of_surface || status.euler_characteristic != surface.euler_characteristic)
    std::cout
      << "The mesh does not have the topology of the surface: holes are closed, walls have holes, or parts are lost;"
      << " the spacing, " << text(status.spacing) << ", is too large for them.\n";
  if (!(std::abs(status.volume_after - surface.volume) <= status.volume_tolerance()))
    std::cout << "The mesh does not have the volume of the surface: " << text(status.volume_after) << " instead of "
              << text(surface.volume) << ", which is more than cells of " << text(status.spacing) << " explain.\n";
  if (!(status.deviation.maximum <= status.spacing))
    std::cout << "The mesh is farther from the surface than a cell is long: " << text(status.deviation.maximum)
              << "; cells are " << text(status.spacing) << " long.\n";
}

// Each stands for itself.
Labels labels_of_parts(const HMO::Meshing_status& status)
{
  std::vector<std::int64_t> all;
  for (int l = 0; !status.materials.empty() && l <= status.materials.back().label; ++l)
    all.push_back(l);
  return Labels(all);
}

// What parts that stay apart have got.
void print_parts(const HMO::Meshing_status& status)
{
  for (const HMO::Material_report& part : status.materials) {
    std::cout << "Part " << part.label << ": " << part.number_of_hexahedra << " hexahedra, volume "
              << text(part.volume_after) << " of " << text(part.volume) << ".\n";
    const bool is_lost = part.number_of_hexahedra == 0 && part.number_of_bodies > 0;
    if (is_lost || !(std::abs(part.volume_after - part.volume) <= status.volume_tolerance(part)))
      std::cout << "Part " << part.label << (is_lost ? " is lost" : " does not have its volume") << ": cells of "
                << text(status.spacing) << " are too large for it.\n";
    else if (!part.has_topology)
      std::cout << "Part " << part.label << " does not have its topology: cells of " << text(status.spacing)
                << " close its holes, or lose pieces of it.\n";
  }
}

void print_number(const Options& o, const HMO::Meshing_status& status, std::size_t faces)
{
  const double wanted = double(status.number_of_hexahedra_wanted), made = double(status.after.number_of_hexahedra);
  if (wanted > 0 && made > 1.3 * wanted)
    std::cout << "There are " << text(made / wanted) << " times as many hexahedra as asked for: "
              << "parts or gaps are thin,"
              << " and cells of " << text(status.spacing)
              << " are what their topology needs (--spacing sets another).\n";
  if (wanted > 0 && made < wanted / 1.3)
    std::cout << "There are fewer hexahedra than asked for: the cells along flat sides come in whole numbers.\n";
  if (!status.thin_faces.empty())
    std::cout << status.thin_faces.size() << " of " << faces << " faces of the surface have less than "
              << o.minimum_cells_across << (o.minimum_cells_across == 1 ? " cell" : " cells")
              << " behind them: parts there are thin for the spacing, " << text(status.spacing)
              << (o.json.empty() ? " (--json lists them)" : "") << ".\n";
}

Json json(const HMO::Surface_report& s)
{
  return {{"volume", s.volume},
          {"area", s.area},
          {"number_of_bodies", s.number_of_bodies},
          {"euler_characteristic", s.euler_characteristic},
          {"number_of_parts", s.number_of_parts},
          {"number_of_reoriented_parts", s.number_of_reoriented_parts},
          {"number_of_copies", s.number_of_copies},
          {"number_without_area", s.number_without_area},
          {"number_of_faces_within", s.number_of_faces_within},
          {"number_of_stitched_vertices", s.number_of_stitched_vertices},
          {"number_of_aligned_vertices", s.number_of_aligned_vertices},
          {"farthest_moved", s.farthest_moved},
          {"number_of_filled_holes", s.number_of_filled_holes},
          {"largest_filled_hole", s.largest_filled_hole},
          {"number_of_small_components", s.number_of_small_components},
          {"volume_of_small_components", s.volume_of_small_components}};
}

Json json(const HMO::Surface_repair& r)
{
  return {{"number_of_filled_holes", r.number_of_filled_holes},
          {"largest_filled_hole", r.largest_filled_hole},
          {"skipped_vertices", r.skipped_vertices},
          {"farthest", r.farthest},
          {"volume_before", r.volume_before},
          {"volume_after", r.volume_after}};
}

Json json(const HMO::Meshing_status& status, const Mesh& mesh, const HMO::Surface_repair& repaired)
{
  Json result = json(static_cast<const HMO::Status&>(status), mesh, labels_of_parts(status));
  result["spacing"] = status.spacing;
  result["has_topology_of_surface"] = status.has_topology_of_surface;
  result["matches_surface"] = status.matches_surface();
  result["number_of_bodies"] = status.number_of_bodies;
  result["euler_characteristic"] = status.euler_characteristic;
  result["thin_faces"] = status.thin_faces;
  result["surface"] = json(status.surface);
  result["repair"] = json(repaired);
  result["parts"] = Json::array();
  for (const HMO::Material_report& part : status.materials)
    result["parts"].push_back({{"label", part.label},
                               {"number_of_hexahedra", part.number_of_hexahedra},
                               {"volume", part.volume},
                               {"area", part.area},
                               {"number_of_bodies", part.number_of_bodies},
                               {"euler_characteristic", part.euler_characteristic},
                               {"has_topology", part.has_topology},
                               {"volume_after", part.volume_after}});
  return result;
}

// Appends, and tells of each triangle of which part it is.
void read(const std::string& filename, Input& input, bool is_alone)
{
  Soup soup;
  read(filename, soup);
  const std::size_t first = input.surface.points.size();
  const int last = input.labels.empty() ? 0 : input.labels.back();
  std::vector<int> parts(soup.triangles.size(), 1);
  if (is_alone) {
    parts = solids_of_stl(filename);
    if (parts.size() != soup.triangles.size() || parts.back() == 1)
      parts = closed_parts(soup);
  }
  input.surface.points.insert(input.surface.points.end(), soup.points.begin(), soup.points.end());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    input.surface.triangles.push_back(soup.triangles[t]);
    for (std::size_t& v : input.surface.triangles.back())
      v += first;
    input.labels.push_back(last + parts[t]);
  }
}

Input read(const Options& options, HMO::Surface_repair& repaired)
{
  Input input;
  for (const std::string& filename : options.surfaces)
    read(filename, input, options.surfaces.size() == 1);
  if (options.repair)
    repaired = repair(input.surface);
  return input;
}

Exit_code run(const Options& options)
{
  check_output(options.output);
  check_reports(options);
  HMO::Surface_repair repaired;
  const Input input = read(options, repaired);

  Mesh mesh;
  HMO::Meshing_status status;
  std::vector<HMO::Iteration> iterations;
  {
    Watcher watcher(options.quiet);
    status = make(input, options, mesh, watcher);
    iterations = watcher.iterations();
  }

  if (CGAL::IO::is_hex_mesh_file(options.output)) // a solver applies loads to sets of faces
    add_patches(mesh, options.features_angle);
  mesh.mesh_data.hexahedron_labels.assign(status.labels.begin(), status.labels.end());
  write(options.output, mesh.points, mesh.hexahedra, mesh.mesh_data);
  if (!options.quiet) {
    print(repaired);
    print(status.surface);
    print_report(status, mesh, labels_of_parts(status));
    print_parts(status);
    print_differences(status);
    print_number(options, status, input.surface.triangles.size());
  }
  const Json report = with_iterations({{"options", json(options)}, {"status", json(status, mesh, repaired)}},
                                      iterations);
  if (!options.json.empty())
    write_json(options.json, report);
  if (!options.report.empty())
    write_page(options, input, mesh, status, report);
  return status.valid_mesh() && status.is_within_deviation_bound() && status.matches_surface() ? SUCCESS
                                                                                               : REQUIREMENT_NOT_MET;
}

int main(int argc, char** argv)
{
  CLI::App app("Makes a hexahedral mesh of the volume that a triangle surface bounds.");
  Options options;
  add_options(app, options);
  options.command = command_line(argc, argv);
  return run_program(app, argc, argv, [&] { return run(options); });
}
