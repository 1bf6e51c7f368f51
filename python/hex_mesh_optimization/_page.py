# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page of the programs' --report, for a browser or a notebook."""

from __future__ import annotations

import html
import json
import os
import tempfile
import webbrowser
from dataclasses import asdict
from pathlib import Path
from typing import Any, Dict, Tuple, Union

import numpy.typing as npt

from . import _arguments as arguments
from . import _engine
from ._errors import Input_error, naming_argument
from ._files import Mesh
from ._progress import is_notebook
from ._run import statistics
from ._status import Status
from ._types import Array, Surface

__all__ = ["Page", "show"]


class Page:
    """One file of HTML that needs no other one. In a notebook it shows itself."""

    def __init__(self, text: str) -> None:
        #: the HTML
        self.text = text

    def save(self, filename: Union[str, os.PathLike[str]]) -> None:
        """Writes the file."""
        Path(filename).write_text(self.text, encoding="utf-8")

    def open(self) -> Path:
        """Writes a temporary file, which stays, and opens it in a web browser."""
        with tempfile.NamedTemporaryFile("w", suffix=".html", delete=False, encoding="utf-8") as file:
            file.write(self.text)
        webbrowser.open(Path(file.name).as_uri())
        return Path(file.name)

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="800" style="border: 0"></iframe>'


def _pair(mesh: Any, name: str) -> Tuple[Array, Array]:
    if isinstance(mesh, Mesh):
        return mesh.points, mesh.hexahedra
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise TypeError(f"{name}: a Mesh or a pair (points, hexahedra) expected, not {type(mesh).__name__}")
    return arguments.points(mesh[0], f"{name}[0]"), arguments.hexahedra(mesh[1], f"{name}[1]")


# What the page needs of a status where there is none.
def _report_of_meshes(before: Tuple[Array, Array], after: Tuple[Array, Array]) -> Dict[str, Any]:
    numbers = asdict(statistics(*after))
    return {
        "before": asdict(statistics(*before)),
        "after": numbers,
        "regions": [],
        "interfaces": [],
        "deviation_bound": None,
        "iterations": 0,
        "attempts": [],
        "volume_changes": [],
        "number_of_reoriented_hexahedra": 0,
        "number_of_coincident_vertices": 0,
        "invalid_hexahedra": [
            {"id": h, "center": after[0][after[1][h]].mean(axis=0).tolist()}
            for h in _engine.invalid(*after).tolist()
        ],
        "locked_hexahedra": [],
        "vertices_off_reference": [],
        "connectivity_limits": [],
    }


def show(
    before: Mesh | Tuple[npt.ArrayLike, npt.ArrayLike],
    after: Mesh | Tuple[npt.ArrayLike, npt.ArrayLike],
    *,
    status: Status | None = None,
    reference: Surface | None = None,
    labels: npt.ArrayLike | None = None,
    title: str = "mesh",
    open_browser: bool | None = None,
) -> Page:
    """The page of the programs' --report: two meshes side by side, numbers, histograms, convergence, places.

    before, after: a Mesh, or points and hexahedra; of as many hexahedra.
    status: of the run between them, for its numbers, iterations and places.
    reference: the surface that distances are measured from; the boundary of the first mesh if not given.
    open_browser: whether to show the page in a web browser; if not given, unless this is a notebook, which shows the
        page that is returned, or there is no screen.
    """
    first, second = _pair(before, "before"), _pair(after, "after")
    if len(first[1]) != len(second[1]):
        raise ValueError(f"after: as many hexahedra as before, {len(first[1])}, expected, not {len(second[1])}")
    surface = None if reference is None else arguments.surface(reference)
    numbers = [] if labels is None else arguments.labels(labels, len(first[1])).tolist()
    try:
        report: Dict[str, Any] = {"status": _report_of_meshes(first, second), "iterations": []}
        if status is not None:
            report = json.loads(status._report)
            report["status"] = status.as_dict()
            report["status"].pop("thin_faces", None)  # their places are those of the surface, which is not at hand
        report["options"] = {"input": f"{title}, before", "output": "after"}
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "page.html"
            why = "" if status is None else status.why_it_stopped
            meshes = [("before", "Before", *first), ("after", "After", *second)]
            _engine.write_page(str(file), title, meshes, surface, numbers, json.dumps(report), why)
            page = Page(file.read_text(encoding="utf-8"))
    except Input_error as error:
        raise naming_argument(error, {"REFERENCE_VERTEX": "reference", "REFERENCE_FACE": "reference"}) from None
    if open_browser is None:
        open_browser = not is_notebook() and bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
    if open_browser:
        page.open()
    return page
