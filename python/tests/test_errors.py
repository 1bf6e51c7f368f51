# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Every argument wrongly given: the error names it, and nothing is written."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any, Dict, List, Tuple, Type

import numpy as np
import pytest
from conftest import block, cube_surface

import hex_mesh_optimization as hmo

POINTS, HEXAHEDRA = block(2)
VERTICES, TRIANGLES = cube_surface(2)
WITH_NAN = POINTS.copy()
WITH_NAN[5, 1] = np.nan
NEGATIVE = HEXAHEDRA.copy()
NEGATIVE[3, 2] = -1
BEYOND = HEXAHEDRA.copy()
BEYOND[3, 2] = 27
TWICE = HEXAHEDRA.copy()
TWICE[4, 1] = TWICE[4, 0]
CELLS = np.insert(HEXAHEDRA, 0, 8, axis=1)
TETRAHEDRON = CELLS.copy()
TETRAHEDRON[2, 0] = 4
RAGGED: Any = [[0, 0, 0], [1, 1]]

MASKED: Any = getattr(np, "ma").masked_less(POINTS, 1)  # numpy has no types for it

Case = Tuple[Any, Any, Type[Exception], str]

MESHES: List[Case] = [
    (POINTS[:, :2], HEXAHEDRA, ValueError, r"^points: .*\(n, 3\).*\(27, 2\)"),
    (POINTS.ravel(), HEXAHEDRA, ValueError, "^points: "),
    (RAGGED, HEXAHEDRA, ValueError, "^points: rows"),
    (POINTS.astype(str), HEXAHEDRA, TypeError, "^points: numbers expected"),
    (POINTS.astype(complex), HEXAHEDRA, TypeError, "^points: numbers expected, not complex128"),
    (POINTS.astype(bool), HEXAHEDRA, TypeError, "^points: numbers expected, not bool"),
    (None, HEXAHEDRA, TypeError, "^points: "),
    (MASKED, HEXAHEDRA, TypeError, "^points: an array without a mask"),
    (POINTS, HEXAHEDRA[:, :7], ValueError, r"^hexahedra: .*\(n, 8\).*\(8, 7\)"),
    (POINTS, HEXAHEDRA.astype(float), TypeError, "^hexahedra: integers expected, not float64"),
    (POINTS, HEXAHEDRA[np.newaxis], ValueError, "^hexahedra: "),
    (POINTS, None, TypeError, "^hexahedra: "),
    (POINTS, NEGATIVE, hmo.Input_error, "^hexahedra: hexahedron 3 "),
    (POINTS, BEYOND, hmo.Input_error, "^hexahedra: hexahedron 3 "),
    (POINTS, BEYOND.astype(np.uint64) + (BEYOND == 27) * np.uint64(2**63), hmo.Input_error, "hexahedron 3"),
    (POINTS, TETRAHEDRON, ValueError, "^hexahedra: cell 2 is no hexahedron: it has 4 vertices"),
    (POINTS, TETRAHEDRON.ravel(), ValueError, "^hexahedra: cell 2 is no hexahedron"),
    (POINTS, CELLS.ravel()[:-1], ValueError, "^hexahedra: cell 7 is no hexahedron"),
]


@pytest.mark.parametrize("points, hexahedra, kind, message", MESHES)
def test_a_wrong_mesh_is_refused_by_all(points: Any, hexahedra: Any, kind: Type[Exception], message: str) -> None:
    for function in (hmo.optimize, hmo.quality, hmo.invalid, hmo.statistics):
        with pytest.raises(kind, match=message):
            function(points, hexahedra)  # type: ignore[operator]


def test_what_an_optimization_alone_refuses() -> None:
    for points, hexahedra, element, index, message in [
        (WITH_NAN, HEXAHEDRA, hmo.Element.VERTEX, 5, "^points: vertex 5 .*not finite"),
        (POINTS, TWICE, hmo.Element.HEXAHEDRON, 4, "^hexahedra: hexahedron 4 "),
        (POINTS, [], hmo.Element.MESH, 0, "no hexahedra"),
        ([], [], hmo.Element.MESH, 0, "no hexahedra"),
    ]:
        with pytest.raises(hmo.Input_error, match=message) as caught:
            hmo.optimize(points, hexahedra)
        assert caught.value.element == element and caught.value.element_index == index
        assert isinstance(caught.value, ValueError)
        for other in (copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))):
            assert str(other) == str(caught.value) and other.element == element and other.element_index == index


WRONG_NUMBERS: List[Any] = ["1", None.__class__, [1], True]
NUMBERS = ["features_angle_bound", "target_quality", "maximum_deviation", "max_deviation", "maximum_running_time",
           "surface_weight", "feature_weight", "regularization_weight", "cone_angle_bound"]
COUNTS = ["number_of_iterations", "number_of_restarts", "threads"]
FLAGS = ["fixed_boundary", "maximize_minimum_quality", "verbose"]
CHOICES = ["boundary_placement", "optimization_method", "target_edge_lengths", "edge_length_update"]


def options() -> List[Tuple[Dict[str, Any], Type[Exception], str]]:
    result: List[Tuple[Dict[str, Any], Type[Exception], str]] = []
    for name in NUMBERS:
        real_name = "maximum_deviation" if name == "max_deviation" else name
        result += [({name: wrong}, TypeError, f"{real_name}: a number expected") for wrong in WRONG_NUMBERS]
        result.append(({name: float("nan")}, ValueError, f"{real_name}: nan"))
        if name != "target_quality":
            result.append(({name: -1.0}, hmo.Input_error, real_name))
    for name in COUNTS:
        result += [({name: wrong}, TypeError, f"{name}: an integer expected") for wrong in ("1", 1.5, [1], True)]
        result += [({name: wrong}, ValueError, f"{name}: an integer from") for wrong in (-1, 2**40)]
    for name in FLAGS:
        result += [({name: wrong}, TypeError, f"{name}: True or False expected") for wrong in (1, "yes", [])]
    for name in CHOICES:
        result += [({name: wrong}, ValueError, f"{name}: one of ") for wrong in (1, "fastest", hmo.Stage.UNTANGLING)]
    result += [
        ({"max_deviation": 1.0, "maximum_deviation": 1.0}, TypeError, "max_deviation"),
        ({"labels": np.zeros(8, int), "hexahedron_label_map": np.zeros(8, int)}, TypeError, "labels"),
        ({"labels": [1, 2]}, ValueError, "labels: one integer for each of the 8 hexahedra"),
        ({"labels": np.zeros(8)}, TypeError, "labels: integers"),
        ({"reference": VERTICES}, TypeError, r"reference: a pair \(vertices, triangles\)"),
        ({"reference": "surface.off"}, TypeError, "reference: a pair"),
        ({"reference": (VERTICES[:, :2], TRIANGLES)}, ValueError, r"reference\[0\]: "),
        ({"reference": (VERTICES, TRIANGLES.astype(float))}, TypeError, r"reference\[1\]: integers"),
        ({"reference": (VERTICES, TRIANGLES - 1)}, hmo.Input_error, "reference: triangle 0 "),
        ({"reference": (VERTICES, TRIANGLES + 1)}, hmo.Input_error, "reference: triangle"),
        ({"reference": (VERTICES * [1, 1, np.nan], TRIANGLES)}, hmo.Input_error, "reference: vertex 0 .*not finite"),
        ({"reference": (VERTICES + 100, TRIANGLES)}, hmo.Input_error, "reference"),
        ({"reference": (VERTICES, np.concatenate([TRIANGLES, TRIANGLES[:1]]))}, hmo.Input_error,
         "reference: triangle 12"),
        ({"edge_is_constrained_map": [[0, 1]]}, TypeError, "edge_is_constrained_map: given without a reference"),
        ({"edge_is_constrained_map": [[0, 7]], "reference": (VERTICES, TRIANGLES)}, ValueError,
         "edge_is_constrained_map: no triangle has the edge"),
        ({"edge_is_constrained_map": [0, 1], "reference": (VERTICES, TRIANGLES)}, ValueError,
         "edge_is_constrained_map: "),
        ({"vertex_is_constrained_map": np.zeros(5, bool)}, ValueError, "vertex_is_constrained_map: one truth value"),
        ({"vertex_is_constrained_map": [3, 27]}, ValueError, "vertex_is_constrained_map: there is no vertex 27"),
        ({"vertex_is_constrained_map": [-1]}, ValueError, "vertex_is_constrained_map: there is no vertex -1"),
        ({"vertex_is_constrained_map": [0.5]}, TypeError, "vertex_is_constrained_map: "),
        ({"vertex_is_constrained_map": [[1]]}, ValueError, "vertex_is_constrained_map: "),
        ({"internal_faces": [[0, 1, 2]]}, ValueError, "internal_faces: "),
        ({"internal_faces": [[0, 1, 2, 99]]}, hmo.Input_error, "internal_faces: internal face 0 "),
        ({"interface_references": [1]}, TypeError, "interface_references: a dictionary"),
        ({"interface_references": {1: 2}}, TypeError, "interface_references: a pair of labels"),
        ({"interface_references": {(0, 1): VERTICES}}, TypeError, r"interface_references\[0, 1\]: a pair"),
        ({"interface_references": {(0, 1): (VERTICES, TRIANGLES)}}, hmo.Input_error,
         "interface_references: no hexahedron"),
        ({"labels": [5, 5, 5, 5, 9, 9, 9, 7], "interface_references": {(5, 7): (VERTICES, TRIANGLES - 1)}},
         hmo.Input_error, "interface_references: .*labels 5 and 7"),
        ({"labels": [5, 7, 9, 9, 5, 7, 9, 9], "interface_references": {(7, 7): (VERTICES, TRIANGLES)}},
         hmo.Input_error, "interface_references: .*labels 7 and 7"),
        ({"periodic_vertices": [1]}, TypeError, "periodic_vertices: a pair"),
        ({"periodic_vertices": ([[0, 1]], [1, 0])}, ValueError, r"periodic_vertices\[1\]: "),
        ({"periodic_vertices": ([0, 1], [1, 0, 0])}, ValueError, r"periodic_vertices\[0\]: "),
        ({"periodic_vertices": ([[0, 99]], [1, 0, 0])}, hmo.Input_error, "periodic_vertices: periodic pair 0 "),
        ({"periodic_vertices": ([[0, -1]], [1, 0, 0])}, hmo.Input_error, "periodic_vertices: periodic pair 0 "),
        ({"periodic_vertices": ([[0, 1]], [5, 0, 0])}, hmo.Input_error, "periodic"),
        ({"periodic_vertices": ([[0, 1]], [np.nan, 0, 0])}, hmo.Input_error, "periodic_vertices: .*not finite"),
        ({"target_edge_length_map": ([[0, 1]], [1, 2])}, ValueError, r"target_edge_length_map\[1\]: one length"),
        ({"target_edge_length_map": {}}, TypeError, "target_edge_length_map: a pair"),
        ({"progress": 3}, TypeError, "progress: "),
        ({"speed": 3}, TypeError, "speed"),
    ]
    return result


@pytest.mark.parametrize("option, kind, message", options())
def test_a_wrong_option_is_named(option: Dict[str, Any], kind: Type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        hmo.optimize(POINTS, HEXAHEDRA, **option)


def test_options_are_given_by_name_alone() -> None:
    with pytest.raises(TypeError):
        hmo.optimize(POINTS, HEXAHEDRA, (VERTICES, TRIANGLES))  # type: ignore[misc]


@pytest.mark.parametrize(
    "vertices, triangles, option, kind, message",
    [
        (VERTICES[:, :2], TRIANGLES, {}, ValueError, "^vertices: "),
        (VERTICES.astype(str), TRIANGLES, {}, TypeError, "^vertices: "),
        (VERTICES * [1, 1, np.nan], TRIANGLES, {}, hmo.Input_error, "^vertices: vertex 0"),
        (VERTICES, TRIANGLES.astype(float), {}, TypeError, "^triangles: "),
        (VERTICES, HEXAHEDRA, {}, ValueError, "^triangles: "),
        (VERTICES, TRIANGLES - 1, {}, hmo.Input_error, "^triangles: triangle 0"),
        (VERTICES, TRIANGLES[:-1], {}, hmo.Input_error, ""),  # open
        (VERTICES, TRIANGLES, {"cells": 0}, ValueError, "number_of_hexahedra: "),
        (VERTICES, TRIANGLES, {"cells": 8, "number_of_hexahedra": 8}, TypeError, "cells"),
        (VERTICES, TRIANGLES, {"cells": 8, "grid_spacing": 0.5}, TypeError, "grid_spacing"),
        (VERTICES, TRIANGLES, {"grid_spacing": -1.0}, hmo.Input_error, "grid_spacing"),
        (VERTICES, TRIANGLES, {"minimum_cells_across": 0}, ValueError, "minimum_cells_across"),
        (VERTICES, TRIANGLES, {"cells": 8.5}, TypeError, "number_of_hexahedra"),
        (VERTICES, TRIANGLES, {"edge_is_constrained_map": [[0, 7]]}, ValueError, "edge_is_constrained_map"),
        (VERTICES, TRIANGLES, {"labels": [0]}, TypeError, "labels"),
    ],
)
def test_what_making_refuses_is_named(
    vertices: Any, triangles: Any, option: Dict[str, Any], kind: Type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        hmo.make(vertices, triangles, **option)


def test_files_are_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        hmo.read(tmp_path / "none.vtk")
    with pytest.raises(FileNotFoundError):
        hmo.read_surface(tmp_path / "none.off")
    with pytest.raises(hmo.Hex_mesh_file_error):
        hmo.read(tmp_path)
    damaged = tmp_path / "damaged.mesh"
    damaged.write_text("MeshVersionFormatted 2\nDimension 3\nVertices\nmany\n")
    with pytest.raises(hmo.Hex_mesh_file_error, match="damaged.mesh:4: ") as caught:
        hmo.read(damaged)
    assert caught.value.filename == str(damaged) and caught.value.line == 4
    assert isinstance(caught.value, OSError) and isinstance(caught.value, ValueError)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    for name in ("out.xyz", "no_folder/out.vtk"):
        with pytest.raises(hmo.Hex_mesh_file_error, match=name):
            hmo.write(tmp_path / name, (POINTS, HEXAHEDRA))
    with pytest.raises(hmo.Input_error, match="^mesh: hexahedron 3 "):
        hmo.write(tmp_path / "out.vtk", (POINTS, NEGATIVE))
    mesh: Any
    for mesh, message in [(POINTS, "^mesh: a Mesh"), ((POINTS.astype(str), HEXAHEDRA), r"^mesh\[0\]")]:
        with pytest.raises(TypeError, match=message):
            hmo.write(tmp_path / "out.vtk", mesh)
    with pytest.raises(ValueError, match="^points: 27 expected"):
        hmo.write(tmp_path / "out.vtk", (POINTS, HEXAHEDRA), POINTS[:-1])
    with pytest.raises(ValueError, match="^mesh.labels: "):
        hmo.write(tmp_path / "out.vtk", hmo.Mesh(POINTS, HEXAHEDRA, np.zeros(3, int)))
    assert not (tmp_path / "out.vtk").exists()
