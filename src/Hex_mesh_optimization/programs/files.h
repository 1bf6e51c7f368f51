// Copyright (c) 2026 The Hex_mesh_optimization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Hex_mesh_optimization authors

#ifndef CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H
#define CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H

// What the command-line programs read, write and repair. The readers, the writers and the repair take the most of the time of
// compilation: they are compiled once for all programs.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file.h>
#include <CGAL/Hex_mesh_optimization/Surface_repair.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <memory>
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
void read(const std::string& filename, Points& points, Hexahedra& hexahedra, CGAL::IO::Hex_mesh_data& mesh_data);
void read(const std::string& filename, Surface& surface);
void read(const std::string& filename, Soup& soup);

// Of each facet of an .stl file in text, the number of its solid, from 1; none of files of other kinds.
std::vector<int> solids_of_stl(const std::string& filename);

// Of each triangle, which closed part of the surface it belongs to.
std::vector<int> closed_parts(const Soup& soup);

// The file of a solver, which can be copied with other points.
using Solver_file = std::shared_ptr<const CGAL::IO::Hex_mesh_file>;

// Empty, if the file is of another kind.
Solver_file read_solver_file(const std::string& filename);

// Whether the output is a copy of the input with other points, and not of another format.
bool is_copy(const std::string& input, const std::string& output);

// Throws now what copy() would throw.
void check_copy(const CGAL::IO::Hex_mesh_file& file, const std::string& output);

// Returns the points as they are in the copy.
Points copy(const CGAL::IO::Hex_mesh_file& file, const std::string& output, const Points& points);

// The places of the coordinates in a file of Medit or VTK; empty where such a file is written anew, as its points are
// compressed, or the output is of another format.
struct File_places;
using Places = std::shared_ptr<const File_places>;
Places places_in(const std::string& input, const std::string& output, const Points& points);
void copy(const Places& places, const std::string& output, const Points& before, const Points& after);

// Throw now what would be thrown after all the work.
void check_writable(const std::string& filename);
void check_output(const std::string& filename);

// The whole file, or nothing of it.
void write_text(const std::string& filename, const std::string& text);

CGAL::IO::Hex_mesh_data mesh_data_of(const CGAL::IO::Hex_mesh_file& file);

void write(const std::string& filename, const Points& points, const Hexahedra& hexahedra,
           const CGAL::IO::Hex_mesh_data& mesh_data = {});

void repair(Surface& surface);
CGAL::Hex_mesh_optimization::Surface_repair repair(Soup& soup);

#endif // CGAL_HEX_MESH_OPTIMIZATION_EXAMPLES_FILES_H
