// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_MESH_FILES_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_MESH_FILES_H

// The files of the programs.

#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_data.h>
#include <CGAL/Hex_mesh_optimization/IO/Hex_mesh_file.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace py = pybind11;

// What a mesh keeps of its file beside points and hexahedra. Python carries it from the reader to the writer.
struct File_content
{
  std::string filename;
  CGAL::IO::Hex_mesh_data mesh_data;
  std::shared_ptr<const CGAL::IO::Hex_mesh_file> solver_file; // empty, if it is of another kind
};

// A dictionary of the members of Mesh, and of what was left out. label_array: of a file of VTK, or empty.
py::dict read_mesh(const std::string& filename, const std::string& label_array);

// Vertices and triangles.
py::tuple read_triangles(const std::string& filename);

// Returns what a user should know of the output, such as what the format cannot hold. The file of a solver is copied,
// with the numbering of its hexahedra, if the output is of the same format. content: null of a mesh that is of no file,
// which may have labels.
std::vector<std::string> write_mesh(const std::string& filename, const py::array& points, const py::array& hexahedra,
                                    const File_content* content, const std::vector<std::int64_t>& labels);

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_MESH_FILES_H
