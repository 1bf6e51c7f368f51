# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes of VTK, pyvista and meshio, whose packages are imported only when they are used."""

from __future__ import annotations

import copy
import importlib
from typing import Any, Dict, List, Tuple

import numpy as np

from . import _arguments as arguments
from ._errors import Input_error
from ._run import optimize
from ._status import Status
from ._types import Array

__all__ = ["optimize_grid", "optimize_meshio"]

_VTK_HEXAHEDRON = 12
# Cells with a volume, by their dimension in VTK, and in meshio by their names.
_MESHIO_SURFACES_AND_LINES = ("vertex", "line", "triangle", "quad", "polygon")


def _numpy_support() -> Any:
    return importlib.import_module("vtkmodules.util.numpy_support")


def _surface_of_vtk(surface: Any) -> Tuple[Array, Array]:
    """The vertices and triangles of a vtkPolyData."""
    support = _numpy_support()
    polygons = surface.GetPolys()
    offsets = support.vtk_to_numpy(polygons.GetOffsetsArray())
    if not np.all(np.diff(offsets) == 3):
        raise ValueError("reference: a surface of triangles expected, see vtkTriangleFilter")
    triangles = support.vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
    return support.vtk_to_numpy(surface.GetPoints().GetData()), triangles


def _reference(surface: Any) -> Any:
    return _surface_of_vtk(surface) if hasattr(surface, "GetPolys") else surface


def _constrained(parameters: Dict[str, Any], number_of_points: int, others: Array) -> Array:
    """Which vertices may not move: those of the caller's, and those of other cells with a volume, which might fold."""
    name = "vertex_is_constrained_map"
    given = parameters.pop(name, None)
    mask = np.zeros(number_of_points, np.bool_)
    if given is not None:
        mask |= arguments.constrained_vertices(given, number_of_points, name)
    mask[others] = True
    return mask


def optimize_grid(grid: Any, *, labels: Any = None, reference: Any = None, **parameters: Any) -> Tuple[Any, Status]:
    """Optimizes the hexahedra of a vtkUnstructuredGrid or a pyvista.UnstructuredGrid.

    labels: the name of an array of the cells, or an integer for each hexahedron.
    reference: a vtkPolyData or pyvista.PolyData of triangles, or vertices and triangles.
    The other parameters are those of optimize(). Vertices of tetrahedra and other cells with a volume do not move.

    Returns a deep copy, with all arrays and all cells of the grid, whose points have moved, and what the run reports.
    """
    if not hasattr(grid, "GetCellTypesArray"):
        raise TypeError(f"grid: a vtkUnstructuredGrid expected, not {type(grid).__name__}")
    support = _numpy_support()
    if grid.GetNumberOfCells() == 0:
        raise Input_error("grid: the mesh has no hexahedra")
    cells = grid.GetCells()
    types = support.vtk_to_numpy(grid.GetCellTypesArray())
    offsets = support.vtk_to_numpy(cells.GetOffsetsArray())
    connectivity = support.vtk_to_numpy(cells.GetConnectivityArray())
    is_hexahedron = types == _VTK_HEXAHEDRON
    hexahedra = connectivity[offsets[:-1][is_hexahedron][:, np.newaxis] + np.arange(8)]
    others = [
        connectivity[offsets[c] : offsets[c + 1]]
        for c in np.flatnonzero(~is_hexahedron)
        if grid.GetCell(int(c)).GetCellDimension() == 3
    ]
    if isinstance(labels, str):
        array = grid.GetCellData().GetArray(labels)
        if array is None:
            raise ValueError(f"labels: the cells have no array {labels!r}")
        labels = support.vtk_to_numpy(array)[is_hexahedron]
    points = support.vtk_to_numpy(grid.GetPoints().GetData())
    constrained = _constrained(parameters, len(points), np.concatenate(others) if others else np.empty(0, np.int64))
    moved, status = optimize(
        points,
        hexahedra,
        labels=labels,
        reference=_reference(reference),
        vertex_is_constrained_map=constrained,
        **parameters,
    )
    result = type(grid)()
    result.DeepCopy(grid)
    new_points = importlib.import_module("vtkmodules.vtkCommonCore").vtkPoints()
    data = support.numpy_to_vtk(moved, deep=True)
    data.SetName(grid.GetPoints().GetData().GetName())
    new_points.SetData(data)
    result.SetPoints(new_points)
    return result, status


def optimize_meshio(mesh: Any, *, labels: Any = None, reference: Any = None, **parameters: Any) -> Tuple[Any, Status]:
    """Optimizes the hexahedra of a meshio.Mesh.

    labels: the name of an entry of cell_data, or an integer for each hexahedron, block after block.
    reference: a meshio.Mesh with triangles, or vertices and triangles.
    The other parameters are those of optimize(). Vertices of tetrahedra and other cells with a volume do not move.

    Returns a deep copy, with all blocks, data and sets of the mesh, whose points have moved, and what the run reports.
    """
    if not hasattr(mesh, "cells") or not hasattr(mesh, "cell_data"):
        raise TypeError(f"mesh: a meshio.Mesh expected, not {type(mesh).__name__}")
    blocks = [b for b, block in enumerate(mesh.cells) if block.type == "hexahedron"]
    others: List[Array] = [
        np.ravel(block.data)
        for block in mesh.cells
        if block.type != "hexahedron" and not block.type.startswith(_MESHIO_SURFACES_AND_LINES)
    ]
    if not blocks:
        raise Input_error("mesh: the mesh has no hexahedra")
    if isinstance(labels, str):
        if labels not in mesh.cell_data:
            raise ValueError(f"labels: there is no {labels!r} in cell_data")
        labels = np.concatenate([np.asarray(mesh.cell_data[labels][b]) for b in blocks])
    if hasattr(reference, "get_cells_type"):
        reference = reference.points, reference.get_cells_type("triangle")
    constrained = _constrained(
        parameters, len(mesh.points), np.concatenate(others).astype(np.int64) if others else np.empty(0, np.int64)
    )
    # meshes of a single block need no copy
    hexahedra = mesh.cells[blocks[0]].data if len(blocks) == 1 else np.concatenate([mesh.cells[b].data for b in blocks])
    moved, status = optimize(
        mesh.points,
        hexahedra,
        labels=labels,
        reference=reference,
        vertex_is_constrained_map=constrained,
        **parameters,
    )
    result = copy.deepcopy(mesh)
    result.points = moved
    return result, status
