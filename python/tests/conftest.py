# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The meshes of the tests, and the programs beside which the module is held."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any, Callable, Tuple

import numpy as np
import pytest

import hex_mesh_optimization as hmo

Mesh = Tuple[Any, Any]


def block(n: int) -> Mesh:
    """A block of n x n x n unit cubes."""
    ticks = np.arange(n + 1.0)
    points = np.stack(np.meshgrid(ticks, ticks, ticks, indexing="ij"), axis=-1).reshape(-1, 3)
    number = np.arange((n + 1) ** 3).reshape(n + 1, n + 1, n + 1)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    hexahedra = np.stack([number[i : n + i, j : n + j, k : n + k].ravel() for i, j, k in corners], axis=-1)
    return points, hexahedra


def interior(points: Any) -> Any:
    """Which points of a block are within it."""
    return np.all((points > 0) & (points < points.max()), axis=1)


def shaken_block(n: int, amount: float = 0.8, seed: int = 1) -> Mesh:
    """A block whose inner points are somewhere else: tangled if the amount is large."""
    points, hexahedra = block(n)
    inside = interior(points)
    points[inside] += np.random.default_rng(seed).uniform(-amount, amount, (inside.sum(), 3))
    return points, hexahedra


def cube_surface(side: float) -> Mesh:
    vertices = side * np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float64)
    triangles = [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4]]
    triangles += [[2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]]
    return vertices, np.array(triangles)


def write_surface(file: Path, surface: Mesh) -> None:
    """A file in the format OFF."""
    vertices, triangles = surface
    rows = [f"{len(vertices)} {len(triangles)} 0", *(" ".join(map(str, v)) for v in vertices)]
    rows += ["3 " + " ".join(map(str, t)) for t in triangles]
    file.write_text("OFF\n" + "\n".join(rows) + "\n")


@pytest.fixture
def tangled() -> Mesh:
    points, hexahedra = shaken_block(3)
    assert len(hmo.invalid(points, hexahedra)) > 0
    return points, hexahedra


@pytest.fixture
def program(tmp_path: Path) -> Callable[..., None]:
    """Runs one of the command-line programs."""
    folder = os.environ.get("HEX_MESH_PROGRAMS", "")
    if not os.path.exists(os.path.join(folder, "optimize_hex_mesh")):
        pytest.skip("the command-line programs are not built")

    def run(name: str, *arguments: Any) -> None:
        subprocess.run([os.path.join(folder, name), *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    return run


def in_a_process(script: str) -> "subprocess.Popen[str]":
    """A Python of its own that can import what the tests have."""
    environment = dict(os.environ)
    environment["PYTHONPATH"] = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    return subprocess.Popen([sys.executable, "-c", script], env=environment, stdout=subprocess.PIPE, text=True)
