# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Hexahedral meshes: moves the vertices until no hexahedron is inverted and all are as good as the connectivity allows.

    points, status = hmo.optimize(points, hexahedra)
    points, hexahedra, status = hmo.make(vertices, triangles, cells=8000)

The package CGAL Hexahedral Mesh Optimization, from Python.
"""

import sys as _sys

from ._adapters import optimize_grid, optimize_meshio
from ._engine import version as __version__
from ._errors import Hex_mesh_file_error, Input_error, Interrupted
from ._files import Lost_data_warning, Mesh, read, read_surface, write
from ._page import Page, show
from ._run import invalid, make, optimize, quality, reoriented, statistics
from ._status import (
    Attempt,
    Boundary_placement,
    Connectivity_limit,
    Connectivity_limit_reason,
    Deviation,
    Edge_length_update,
    Element,
    Interface_statistics,
    Iteration,
    Meshing_status,
    Method,
    Quality_statistics,
    Part_volume,
    Region_volume,
    Return_code,
    Stage,
    Status,
    Target_edge_lengths,
    Volume_change,
)

__all__ = [
    "Attempt",
    "Boundary_placement",
    "Connectivity_limit",
    "Connectivity_limit_reason",
    "Deviation",
    "Edge_length_update",
    "Element",
    "Hex_mesh_file_error",
    "Input_error",
    "Interface_statistics",
    "Interrupted",
    "Iteration",
    "Lost_data_warning",
    "Mesh",
    "Meshing_status",
    "Method",
    "Page",
    "Quality_statistics",
    "Part_volume",
    "Region_volume",
    "Return_code",
    "Stage",
    "Status",
    "Target_edge_lengths",
    "Volume_change",
    "__version__",
    "invalid",
    "make",
    "optimize",
    "optimize_grid",
    "optimize_meshio",
    "quality",
    "read",
    "read_surface",
    "show",
    "reoriented",
    "statistics",
    "write",
]

if hasattr(_sys.modules.get("pyvista"), "register_dataset_accessor"):
    from . import pyvista_accessor as _pyvista_accessor
