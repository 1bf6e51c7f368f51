// Copyright (c) 2026 The Hex_mesh_optimization authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_HEX_MESH_OPTIMIZATION_PYTHON_STATUS_H
#define CGAL_HEX_MESH_OPTIMIZATION_PYTHON_STATUS_H

// What a run reports, as dictionaries with the members under their own names.

#include "Watcher.h"
#include "arrays.h"
#include "status_report.h"

#include <CGAL/Hex_mesh_optimization/Meshing_status.h>

#include <pybind11/pybind11.h>

py::dict as_dict(const HMO::Quality_statistics& statistics);
py::dict as_dict(const HMO::Status& status, const Points& points, const Table& hexahedra, const Labels& labels,
                 const Watcher& watcher);
// labels: of the parts that stay apart, if any
void add_to(py::dict& dict, const HMO::Meshing_status& status, const Labels& labels);

#endif // CGAL_HEX_MESH_OPTIMIZATION_PYTHON_STATUS_H
