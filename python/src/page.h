// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_PAGE_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_PAGE_H

// The page of the programs' --report.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace py = pybind11;

using Named_mesh = std::tuple<std::string, std::string, py::array, py::array>; // role and name, see Report_page

// report: as the programs write it, but that the deviation may be missing. why_it_stopped: empty if there was no run.
void write_page(const std::string& filename, const std::string& title, const std::vector<Named_mesh>& named_meshes,
                const py::object& reference, const std::vector<std::int64_t>& labels, const std::string& report,
                const std::string& why_it_stopped);

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_PAGE_H
