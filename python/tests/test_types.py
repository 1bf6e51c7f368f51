# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The types: the package and its users are checked strictly."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import hex_mesh_optimization as hmo

USER = """
from typing import Any, Tuple, assert_type

import numpy as np
import numpy.typing as npt

import hex_mesh_optimization as hmo

Floats = npt.NDArray[np.float64]
points, status = hmo.optimize(np.zeros((8, 3)), [[0, 1]], threads=2, progress=lambda i: i.minimum < .5)
assert_type(points, Floats)
assert_type(status, hmo.Status)
assert_type(status.valid_mesh, bool)
assert_type(status.before.minimum, float)
assert_type(hmo.make([], [], cells=3), Tuple[Floats, npt.NDArray[np.int64], hmo.Meshing_status])
assert_type(hmo.quality(points, [[]]), Floats)
"""
WRONG = """
import hex_mesh_optimization as hmo

hmo.optimize([], [], threads="two")
hmo.optimize([], [], speed=3)
hmo.optimize([], [])[1].quality
hmo.make([], [], cells=None, progress=3)
"""


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> str:
    return str(tmp_path_factory.mktemp("mypy"))


def check(cache: str, *files: Path) -> "subprocess.CompletedProcess[str]":
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--strict", f"--cache-dir={cache}", *map(str, files)]
    environment = dict(os.environ, MYPYPATH=str(Path(hmo.__file__).parents[1]))
    return subprocess.run(command, capture_output=True, text=True, env=environment)


def test_package_tests_and_users_are_typed(cache: str, tmp_path: Path) -> None:
    package = Path(hmo.__file__).parent
    (tmp_path / "user.py").write_text(USER)
    result = check(cache, package, *Path(__file__).parent.glob("*.py"), tmp_path / "user.py")
    assert result.returncode == 0, result.stdout
    assert (package / "py.typed").exists()


def test_wrong_calls_are_found(cache: str, tmp_path: Path) -> None:
    (tmp_path / "wrong.py").write_text(WRONG)
    errors = check(cache, tmp_path / "wrong.py").stdout.splitlines()
    for line, word in [(4, "threads"), (5, "speed"), (6, "quality"), (7, "progress")]:
        assert any(f"wrong.py:{line}:" in row and word in row for row in errors), errors


def test_the_stub_names_what_the_compiled_part_has() -> None:
    import ast

    from hex_mesh_optimization import _engine

    stub = ast.parse((Path(hmo.__file__).parent / "_engine.pyi").read_text(encoding="utf-8"))
    named = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))} | {"version"}
    assert named == {name for name in dir(_engine) if not name.startswith("_")}


def test_every_named_parameter_of_cpp_is_there() -> None:
    import inspect
    import re

    header = Path(__file__).resolve().parents[2] / "include" / "CGAL" / "optimize_hex_mesh.h"
    named = set(re.findall(r"cgalParamNBegin\{(\w+)\}", header.read_text(encoding="utf-8")))
    own = set(inspect.signature(hmo.optimize).parameters)
    # of property maps of the caller's types, which arrays are not; progress is the visitor, internal_faces are facets
    assert named - own == {"vertex_point_map", "visitor", "facet_is_constrained_map"}
    making = header.with_name("make_hex_mesh.h")
    of_making = set(re.findall(r"cgalParamNBegin\{(\w+)\}", making.read_text(encoding="utf-8")))
    assert of_making <= set(inspect.signature(hmo.make).parameters)
