// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_QUALITY_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_QUALITY_H

// Measures of meshes that are arrays: scaled Jacobians, invalid hexahedra, and the members of Quality_statistics.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace py = pybind11;

py::array quality(const py::array& points, const py::array& hexahedra);
py::array invalid(const py::array& points, const py::array& hexahedra);
py::dict statistics(const py::array& points, const py::array& hexahedra);

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_QUALITY_H
