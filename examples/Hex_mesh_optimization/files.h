// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H

// What the command-line programs read, write and repair. The readers, the writers and the repair take the most of the time of
// compilation: they are compiled once for all programs.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_attachments.h>
#include <CGAL/Hex_mesh_optimization/Surface_repair.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Hexahedra = std::vector<std::array<std::size_t, 8>>;
using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>; // for the repair

// Triangles as a file has them, whatever they are together.
struct Soup
{
  Points points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

void read(const std::string& filename, Points& points, Hexahedra& hexahedra);
void read(const std::string& filename, Points& points, Hexahedra& hexahedra,
          CGAL::IO::Hex_mesh_attachments& attachments);
void read(const std::string& filename, Surface& surface);
void read(const std::string& filename, Soup& soup);

void write(const std::string& filename, const Points& points, const Hexahedra& hexahedra,
           const CGAL::IO::Hex_mesh_attachments& attachments = {});

void repair(Surface& surface);
CGAL::Hex_mesh_optimization::Surface_repair repair(Soup& soup);

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H
