# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Grids of VTK, meshes of meshio, and what pyvista is given: everything is kept but the places of the points."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from conftest import block, cube_surface, in_a_process, shaken_block

import hex_mesh_optimization as hmo


def test_nothing_is_imported_that_is_not_used() -> None:
    others = ("vtkmodules", "meshio", "pyvista", "tqdm", "IPython")
    script = f"import sys, hex_mesh_optimization; print([m for m in {others} if m in sys.modules])"
    assert in_a_process(script).communicate()[0] == "[]\n"


# --- VTK ----------------------------------------------------------------------------


def vtk_grid() -> Any:
    """A tangled block of two materials, a quadrilateral on it, and a tetrahedron beside it."""
    vtk = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")
    support = pytest.importorskip("vtkmodules.util.numpy_support")
    points, hexahedra = shaken_block(3)
    points = np.concatenate([points, [[-1, 0.5, 0.5]]]).astype(np.float32)
    grid = vtk.vtkUnstructuredGrid()
    of_grid = core.vtkPoints()
    of_grid.SetData(support.numpy_to_vtk(points, deep=True))
    grid.SetPoints(of_grid)
    grid.InsertNextCell(vtk.VTK_QUAD, 4, [0, 1, 5, 4])
    for h in hexahedra:
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, h.tolist())
    grid.InsertNextCell(vtk.VTK_TETRA, 4, [0, 1, 5, 64])

    def add(data: Any, name: str, values: Any) -> None:
        array = support.numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)

    add(grid.GetPointData(), "heat", np.linspace(0, 1, 65))
    add(grid.GetCellData(), "material", np.concatenate([[9], (block(3)[0][hexahedra].mean(axis=1)[:, 0] > 1) * 1, [9]]))
    add(grid.GetFieldData(), "time", np.array([1.5]))
    return grid


def as_arrays(grid: Any) -> Any:
    vtk_to_numpy = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
    data = [grid.GetPointData().GetArray("heat"), grid.GetCellData().GetArray("material"),
            grid.GetFieldData().GetArray("time"), grid.GetCells().GetConnectivityArray(),
            grid.GetCells().GetOffsetsArray(), grid.GetCellTypesArray()]
    return [vtk_to_numpy(array).tolist() for array in data], vtk_to_numpy(grid.GetPoints().GetData()).copy()


def test_a_grid_of_vtk_keeps_arrays_and_cells() -> None:
    grid = vtk_grid()
    before, old_points = as_arrays(grid)
    result, status = hmo.optimize_grid(grid, labels="material")
    after, points = as_arrays(result)
    assert type(result) is type(grid) and result is not grid
    assert after == before and as_arrays(grid)[0] == before
    assert np.array_equal(as_arrays(grid)[1], old_points)
    assert status.valid_mesh and status.before.number_of_invalid > 0
    assert [region.label for region in status.regions] == [0, 1]
    assert points.dtype == np.float64
    assert np.array_equal(points[[0, 1, 5, 64]], old_points[[0, 1, 5, 64]])  # of the tetrahedron
    hexahedra = shaken_block(3)[1]
    assert len(hmo.invalid(points, hexahedra)) == 0
    # the copy is deep
    result.GetPointData().GetArray("heat").SetValue(0, 77)
    assert as_arrays(grid)[0] == before


def test_the_parameters_of_a_grid_are_those_of_arrays() -> None:
    grid = vtk_grid()
    points = as_arrays(grid)[1]
    hexahedra = shaken_block(3)[1]
    result, _ = hmo.optimize_grid(grid, vertex_is_constrained_map=[21], threads=2)
    expected, _ = hmo.optimize(points, hexahedra, vertex_is_constrained_map=[0, 1, 5, 64, 21])
    assert np.array_equal(as_arrays(result)[1], expected)
    with pytest.raises(ValueError, match="^labels: the cells have no array 'none'"):
        hmo.optimize_grid(grid, labels="none")
    with pytest.raises(TypeError, match="^grid: a vtkUnstructuredGrid"):
        hmo.optimize_grid(points)
    with pytest.raises(hmo.Input_error, match="no hexahedra"):
        hmo.optimize_grid(type(grid)())


def test_a_surface_of_vtk_is_a_reference() -> None:
    model = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")
    vertices, triangles = cube_surface(3)
    surface, points, cells = model.vtkPolyData(), core.vtkPoints(), model.vtkCellArray()
    for v in vertices:
        points.InsertNextPoint(v)
    for t in triangles:
        cells.InsertNextCell(3, t.tolist())
    surface.SetPoints(points)
    surface.SetPolys(cells)
    result, _ = hmo.optimize_grid(vtk_grid(), reference=surface)
    expected, _ = hmo.optimize_grid(vtk_grid(), reference=(vertices.astype(np.float32), triangles))
    assert np.array_equal(as_arrays(result)[1], as_arrays(expected)[1])
    cells.InsertNextCell(4, [0, 1, 3, 2])
    with pytest.raises(ValueError, match="^reference: a surface of triangles"):
        hmo.optimize_grid(vtk_grid(), reference=surface)


# --- meshio -------------------------------------------------------------------------


def meshio_mesh() -> Any:
    meshio = pytest.importorskip("meshio")
    points, hexahedra = shaken_block(3)
    points = np.concatenate([points, [[-1, 0.5, 0.5]]])
    return meshio.Mesh(
        points,
        [("quad", np.array([[0, 1, 5, 4]])), ("hexahedron", hexahedra[:10]), ("tetra", np.array([[0, 1, 5, 64]])),
         ("hexahedron", hexahedra[10:])],
        point_data={"heat": np.linspace(0, 1, 65)},
        cell_data={"part": [np.array([5]), np.full(10, 3), np.array([4]), np.full(17, 3)]},
        field_data={"steel": np.array([3, 3])},
        cell_sets={"outside": [np.array([0]), np.array([], int), np.array([], int), np.array([], int)]},
        point_sets={"corner": np.array([0])},
    )


def test_a_mesh_of_meshio_keeps_data_and_blocks() -> None:
    mesh = meshio_mesh()
    result, status = hmo.optimize_meshio(mesh, labels="part")
    assert np.array_equal(mesh.points, meshio_mesh().points)
    assert status.valid_mesh and len(status.regions) == 1 and status.regions[0].label == 3
    assert [(b.type, b.data.tolist()) for b in result.cells] == [(b.type, b.data.tolist()) for b in mesh.cells]
    assert np.array_equal(result.point_data["heat"], mesh.point_data["heat"])
    assert [d.tolist() for d in result.cell_data["part"]] == [d.tolist() for d in mesh.cell_data["part"]]
    assert result.field_data["steel"].tolist() == [3, 3]
    assert result.point_sets["corner"].tolist() == [0] and result.cell_sets["outside"][0].tolist() == [0]
    assert np.array_equal(result.points[[0, 1, 5, 64]], mesh.points[[0, 1, 5, 64]])  # of the tetrahedron
    assert len(hmo.invalid(result.points, shaken_block(3)[1])) == 0
    expected = hmo.optimize(mesh.points, shaken_block(3)[1], vertex_is_constrained_map=[0, 1, 5, 64])[0]
    assert np.array_equal(result.points, expected)


def test_what_meshio_lacks_is_named() -> None:
    meshio = pytest.importorskip("meshio")
    with pytest.raises(ValueError, match="^labels: there is no 'none'"):
        hmo.optimize_meshio(meshio_mesh(), labels="none")
    with pytest.raises(hmo.Input_error, match="no hexahedra"):
        hmo.optimize_meshio(meshio.Mesh(np.zeros((3, 3)), [("triangle", [[0, 1, 2]])]))
    with pytest.raises(TypeError, match="^mesh: a meshio.Mesh"):
        hmo.optimize_meshio(shaken_block(2))


def test_a_surface_of_meshio_is_a_reference() -> None:
    meshio = pytest.importorskip("meshio")
    vertices, triangles = cube_surface(3)
    surface = meshio.Mesh(vertices, [("triangle", triangles)])
    result, _ = hmo.optimize_meshio(meshio_mesh(), reference=surface)
    expected, _ = hmo.optimize_meshio(meshio_mesh(), reference=(vertices, triangles))
    assert np.array_equal(result.points, expected.points)


# --- pyvista ------------------------------------------------------------------------


class Grid_of_pyvista:
    """What the accessor asks of a pyvista.UnstructuredGrid."""

    def __init__(self) -> None:
        self.points, hexahedra = shaken_block(2)
        self.cells_dict = {12: hexahedra}


def test_the_accessor_is_registered_with_pyvista(monkeypatch: pytest.MonkeyPatch) -> None:
    registered = {}

    def register(name: str, target: type) -> Any:
        def decorate(accessor: type) -> type:
            registered[name] = target, accessor
            return accessor

        return decorate

    pyvista = ModuleType("pyvista")
    monkeypatch.setattr(pyvista, "UnstructuredGrid", Grid_of_pyvista, raising=False)
    monkeypatch.setattr(pyvista, "register_dataset_accessor", register, raising=False)
    monkeypatch.setitem(sys.modules, "pyvista", pyvista)
    monkeypatch.delitem(sys.modules, "hex_mesh_optimization.pyvista_accessor", raising=False)
    import hex_mesh_optimization.pyvista_accessor  # noqa: F401

    target, accessor = registered["hmo"]
    assert target is Grid_of_pyvista
    of_grid = accessor(Grid_of_pyvista())
    assert np.array_equal(of_grid.quality(), hmo.quality(*shaken_block(2)))
    assert np.array_equal(of_grid.invalid(), hmo.invalid(*shaken_block(2)))
