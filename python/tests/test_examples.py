# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the manual and the README show does run."""

from __future__ import annotations

import importlib.util
import json
import re
import runpy
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict

import numpy as np
import pytest
from conftest import cube_surface, shaken_block, write_surface

import hex_mesh_optimization as hmo

TOP = Path(__file__).resolve().parents[2]
EXAMPLES = TOP / "examples" / "Hex_mesh_optimization" / "python"
NEEDED = {"vtk_grid": "vtkmodules", "meshio_mesh": "meshio"}


@pytest.fixture(autouse=True)
def folder_of_meshes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    hmo.write("tangled.vtk", shaken_block(3))
    write_surface(Path("surface.off"), cube_surface(3))


@pytest.mark.parametrize("example", sorted(file.stem for file in EXAMPLES.glob("*.py")))
def test_an_example_runs(example: str, capsys: pytest.CaptureFixture[str]) -> None:
    if example in NEEDED:
        pytest.importorskip(NEEDED[example])
    names = runpy.run_path(str(EXAMPLES / f"{example}.py"))
    assert names["status"].valid_mesh
    for file in ("repaired.vtk", "tetrahedron.vtk"):
        if Path(file).exists():
            mesh = hmo.read(file)
            assert len(hmo.invalid(mesh.points, mesh.hexahedra)) == 0


def test_the_manual_shows_every_example() -> None:
    text = (TOP / "doc" / "Hex_mesh_optimization" / "Python.txt").read_text(encoding="utf-8")
    shown = re.findall(r"^\\include Hex_mesh_optimization/python/(\w+)\.py", text, re.MULTILINE)
    assert sorted(shown) == sorted(file.stem for file in EXAMPLES.glob("*.py"))


def test_the_notebook_runs() -> None:
    cells = json.loads((EXAMPLES / "notebook.ipynb").read_text(encoding="utf-8"))["cells"]
    names: Dict[str, Any] = {}
    try:
        for cell in cells:
            if cell["cell_type"] == "code":
                exec("".join(cell["source"]), names)
    except RuntimeError as error:
        if "three.js" not in str(error):
            raise
        pytest.skip(str(error))
    assert names["status"]._repr_html_() and names["page"]._repr_html_()


def test_the_notebook_runs_in_jupyter(tmp_path: Path) -> None:
    for module in ("nbconvert", "ipykernel"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")
    shutil.copy(EXAMPLES / "notebook.ipynb", tmp_path)  # it runs where it is
    command = [sys.executable, "-m", "nbconvert", "--to", "html", "--execute", "notebook.ipynb"]
    subprocess.run(command, check=True, cwd=tmp_path)
    assert "minimum scaled Jacobian" in (tmp_path / "notebook.html").read_text(encoding="utf-8")


def test_the_lines_of_the_readme_run() -> None:
    blocks = re.findall(r"```python\n(.*?)```", (TOP / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) == 1
    points, hexahedra = shaken_block(3)
    vertices, triangles = cube_surface(3)
    names: Dict[str, Any] = dict(points=points, hexahedra=hexahedra, vertices=vertices, triangles=triangles)
    exec(blocks[0], names)
    assert names["status"].valid_mesh and np.all(np.isfinite(names["points"]))
