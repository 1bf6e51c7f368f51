// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a hexahedral mesh of a simple solid, or the subdivision of another mesh, tangled on request.

#include "files.h"

#include <CGAL/Hex_mesh_optimization/hex_mesh_corruption.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_generators.h>
#include <CGAL/Hex_mesh_optimization/hex_mesh_subdivision.h>

#include <CGAL/number_utils.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace HMO = CGAL::Hex_mesh_optimization;

int main(int argc, char** argv)
{
  std::string input;
  // At refinement n; the numbers of cells are chosen to keep them near cubes
  const std::map<std::string, std::function<void(Points&, Hexahedra&, std::size_t)>> families = {
    {"ball", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_ball(p, h, 2 * n); }},
    {"bent_bar", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_bent_bar(p, h, 4 * n, n); }},
    {"block",
     [](Points& p, Hexahedra& h, std::size_t n) {
       HMO::make_block(p, h, {{n, n, n}});
     }},
    {"boundary_layer",
     [](Points& p, Hexahedra& h, std::size_t n) {
       HMO::make_block(p, h, {{n, n, n}}, {{1, 1, 1}}, {{1, 1, 50}});
     }},
    {"cylinder", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_cylinder(p, h, 2 * n, 4 * n); }},
    {"l_shape", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_l_shape(p, h, n); }},
    {"plate_with_hole", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_plate_with_hole(p, h, 2 * n, n); }},
    {"of_file",
     [&input](Points& p, Hexahedra& h, std::size_t n) {
       read(input, p, h);
       HMO::subdivide_hex_mesh(p, h, n);
     }},
    {"ring", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_ring(p, h, 9 * n, n); }},
    {"t_shape", [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_t_shape(p, h, n); }},
    {"twisted_bar",
     [](Points& p, Hexahedra& h, std::size_t n) { HMO::make_bent_bar(p, h, 6 * n, n, 6, 1, CGAL_PI / 2, CGAL_PI); }}};
  std::vector<std::string> family_names;
  for (const auto& family : families)
    family_names.push_back(family.first);

  CLI::App app("Writes a hexahedral mesh of a simple solid, or the subdivision of another mesh, tangled on request.");
  std::string family, output, corruption;
  std::size_t refinement = 4;
  std::uint64_t seed = 1;
  double amount = 0;
  app.add_option("family", family, "the solid; of_file divides every hexahedron of the input")
    ->required()
    ->check(CLI::IsMember(family_names));
  app.add_option("output", output, "the file to write; its extension chooses the format")->required();
  app.add_option("-n,--refine", refinement, "cells along the shortest side")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  app.add_option("--input", input, "the mesh that of_file subdivides")->check(CLI::ExistingFile);
  app
    .add_option("--corrupt", corruption,
                "scramble: move all interior vertices; rotate: turn hexahedra about their centers; "
                "displace: move one interior vertex")
    ->check(CLI::IsMember({"scramble", "rotate", "displace"}));
  app.add_option("--seed", seed, "of the corruption")->capture_default_str();
  const CLI::Option* amount_option =
    app
      .add_option("--amount", amount,
                  "scramble: distance in local edge lengths (default: anywhere in the bounding box); "
                  "rotate: fraction of the hexahedra (default .5); "
                  "displace: distance in average interior edge lengths (default 4)")
      ->check(CLI::NonNegativeNumber);
  CLI11_PARSE(app, argc, argv);
  if (amount_option->count() != 0 && corruption.empty()) {
    std::cerr << "--amount needs --corrupt\n";
    return EXIT_FAILURE;
  }

  if ((family == "of_file") == input.empty()) {
    std::cerr << "of_file and --input need each other\n";
    return EXIT_FAILURE;
  }

  try {
    Points points;
    Hexahedra hexahedra;
    families.at(family)(points, hexahedra, refinement);
    std::cout << family << ": " << points.size() << " vertices, " << hexahedra.size() << " hexahedra\n";

    const bool is_amount_given = amount_option->count() != 0;
    if (corruption == "scramble") {
      if (is_amount_given)
        HMO::scramble_interior(points, hexahedra, seed, amount);
      else
        HMO::scramble_interior(points, hexahedra, seed);
    }
    else if (corruption == "rotate") {
      HMO::rotate_hexahedra(points, hexahedra, seed, is_amount_given ? amount : .5);
    }
    else if (corruption == "displace") {
      const std::size_t v = HMO::displace_vertex(points, hexahedra, seed, is_amount_given ? amount : 4);
      std::cout << "displaced vertex " << v << " (counting from 0)\n";
    }

    write(output, points, hexahedra);
  }
  catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
