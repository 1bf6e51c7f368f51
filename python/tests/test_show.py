# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page of a report, and what a notebook shows."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Mesh, block, cube_surface

import hex_mesh_optimization as hmo


def data_of(page: hmo.Page) -> Any:
    found = re.search(r'<script[^>]*type="application/json"[^>]*>(.*?)</script>', page.text, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


def shown(*arguments: Any, **options: Any) -> hmo.Page:
    try:
        return hmo.show(*arguments, open_browser=False, **options)
    except RuntimeError as error:
        if "three.js" in str(error):
            pytest.skip(str(error))
        raise


def test_the_page_has_meshes_and_report(tangled: Mesh, tmp_path: Path) -> None:
    points, hexahedra = tangled
    labels = np.arange(len(hexahedra)) // 20
    result, status = hmo.optimize(points, hexahedra, labels=labels, reference=cube_surface(3))
    page = shown(
        tangled, (result, hexahedra), status=status, reference=cube_surface(3), labels=labels, title="block"
    )
    data = data_of(page)
    assert [mesh["role"] for mesh in data["meshes"]] == ["before", "after"]
    assert data["report"]["status"] == status.as_dict()
    assert len(data["report"]["iterations"]) == status.iterations
    assert "labels" in data and data["reference"]["name"] == "Reference"
    assert data["why_it_stopped"] == status.why_it_stopped
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page.text


def test_two_meshes_are_enough(tangled: Mesh) -> None:
    page = shown(tangled, hmo.Mesh(*block(3)))
    data = data_of(page)
    status = data["report"]["status"]
    assert status["before"]["number_of_invalid"] > 0 and status["after"]["minimum"] == 1
    assert status["deviation"]["maximum"] < 1e-12 and "why_it_stopped" not in data
    assert page._repr_html_().startswith("<iframe srcdoc=")


def test_what_cannot_be_shown_is_named(tangled: Mesh) -> None:
    with pytest.raises(ValueError, match="^after: as many hexahedra"):
        hmo.show(tangled, block(2))
    with pytest.raises(TypeError, match="^before: a Mesh"):
        hmo.show(3, tangled)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="^labels: "):
        hmo.show(tangled, tangled, labels=[1])
