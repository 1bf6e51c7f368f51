// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIMIZE_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIMIZE_H

// The two runs, with arguments that the Python part of the module has checked. Both tell as the last of their results
// whether the user has interrupted them.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace py = pybind11;

// The points, a dictionary of the members of Status, and the interruption.
py::tuple optimize(const py::array& points, const py::array& hexahedra, const py::object& reference,
                   const py::dict& options, int threads, const py::object& progress);

// The points, the hexahedra, a dictionary of the members of Meshing_status, and the interruption.
py::tuple make(const py::array& vertices, const py::array& triangles, const py::dict& options, int threads,
               const py::object& progress);

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_OPTIMIZE_H
