# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files are those of the programs, and nothing of them is lost."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from conftest import Mesh, block

import hex_mesh_optimization as hmo

VTK = """# vtk DataFile Version 3.0
of the test
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 12 double
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0 0 2 1 0 2 1 1 2 0 1 2
CELLS 3 23
8 0 1 2 3 4 5 6 7
4 4 5 6 7
8 4 5 6 7 8 9 10 11
CELL_TYPES 3
12 9 12
CELL_DATA 3
SCALARS material int 1
LOOKUP_TABLE default
4
9
6
SCALARS other int 1
LOOKUP_TABLE default
1
2
3
POINT_DATA 12
SCALARS heat double 1
LOOKUP_TABLE default
0 1 2 3 4 5 6 7 8 9 10 11.5
"""


@pytest.fixture
def vtk_file(tmp_path: Path) -> Path:
    file = tmp_path / "in.vtk"
    file.write_text(VTK)
    return file


def test_a_file_is_read_and_written_as_a_whole(vtk_file: Path, tmp_path: Path) -> None:
    mesh = hmo.read(vtk_file)
    assert mesh.points.shape == (12, 3) and mesh.hexahedra.shape == (2, 8)
    assert mesh.labels is not None and mesh.labels.tolist() == [4, 6]
    assert mesh.internal_faces.tolist() == [[4, 5, 6, 7]]
    points = mesh.points + 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        hmo.write(tmp_path / "out.vtk", mesh, points)
    text = (tmp_path / "out.vtk").read_text(encoding="utf-8")
    assert "material" in text and "heat" in text and "11.5" in text
    again = hmo.read(tmp_path / "out.vtk")
    assert np.array_equal(again.points, points) and np.array_equal(again.hexahedra, mesh.hexahedra)
    assert again.labels is not None and again.labels.tolist() == [4, 6]


def test_the_array_of_labels_is_chosen(vtk_file: Path) -> None:
    labels = hmo.read(vtk_file, label_array="other").labels
    assert labels is not None and labels.tolist() == [1, 3]
    with pytest.raises(hmo.Hex_mesh_file_error, match='there is no array "none"'):
        hmo.read(vtk_file, label_array="none")


def test_what_a_format_cannot_hold_is_warned_of(vtk_file: Path, tmp_path: Path) -> None:
    with pytest.warns(hmo.Lost_data_warning, match="heat"):
        hmo.write(tmp_path / "out.mesh", hmo.read(vtk_file))


def test_a_mesh_of_arrays_is_written(tmp_path: Path) -> None:
    points, hexahedra = block(2)
    hmo.write(tmp_path / "plain.vtu", (points, hexahedra))
    plain = hmo.read(tmp_path / "plain.vtu")
    assert np.array_equal(plain.points, points) and np.array_equal(plain.hexahedra, hexahedra) and plain.labels is None
    hmo.write(str(tmp_path / "labels.mesh"), hmo.Mesh(points, hexahedra, np.arange(8)))
    labels = hmo.read(str(tmp_path / "labels.mesh")).labels
    assert labels is not None and labels.tolist() == list(range(8))


def test_the_output_is_that_of_the_program(program: Callable[..., None], tmp_path: Path, tangled: Mesh) -> None:
    points, hexahedra = tangled
    hexahedra[3] = hexahedra[3][[4, 5, 6, 7, 0, 1, 2, 3]]  # inside out
    for name in ("in.vtk", "in.vtu", "in.mesh"):
        hmo.write(tmp_path / name, hmo.Mesh(points, hexahedra, np.arange(len(hexahedra)) // 20))
        file, out, own = (tmp_path / f"{which}{name}" for which in ("", "program_", "own_"))
        program("optimize_hex_mesh", file, out)
        mesh = hmo.read(file)
        result, status = hmo.optimize(mesh.points, mesh.hexahedra, **mesh.parameters)
        hmo.write(own, mesh, result, status=status)
        assert own.read_bytes() == out.read_bytes()


def test_the_file_of_a_solver_is_copied(tmp_path: Path, tangled: Mesh) -> None:
    points, hexahedra = tangled
    lines = ["*HEADING", "a model", "*NODE, NSET=ALL"]
    lines += [f"{v + 1}, {x:.17g}, {y:.17g}, {z:.17g}" for v, (x, y, z) in enumerate(points)]
    lines += ["*ELEMENT, TYPE=C3D8, ELSET=PART"]
    lines += [", ".join(map(str, [h + 1, *(corners + 1)])) for h, corners in enumerate(hexahedra)]
    lines += ["*NSET, NSET=HELD", "22, 23", "*BOUNDARY", "HELD, 1, 3", ""]
    (tmp_path / "model.inp").write_text("\n".join(lines))
    mesh = hmo.read(tmp_path / "model.inp")
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.hexahedra, hexahedra)
    assert mesh.sets["HELD"].tolist() == [21, 22]
    result, status = hmo.optimize(mesh.points, mesh.hexahedra, **mesh.parameters)
    assert status.valid_mesh
    hmo.write(tmp_path / "better.inp", mesh, result)
    again = hmo.read(tmp_path / "better.inp")
    assert np.abs(again.points - result).max() < 1e-6 and len(hmo.invalid(again.points, hexahedra)) == 0
    others = [(tmp_path / name).read_text(encoding="utf-8").splitlines() for name in ("model.inp", "better.inp")]
    assert others[0][:3] == others[1][:3] and others[0][3 + len(points) :] == others[1][3 + len(points) :]
    with pytest.warns(hmo.Lost_data_warning, match="HELD"):
        hmo.write(tmp_path / "better.vtk", mesh, result)


def test_a_surface_is_read(tmp_path: Path) -> None:
    (tmp_path / "t.off").write_text("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
    vertices, triangles = hmo.read_surface(tmp_path / "t.off")
    assert vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert sorted(map(sorted, triangles.tolist())) == [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
