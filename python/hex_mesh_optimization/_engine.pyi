# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

from typing import Any, Callable, Dict, List, Sequence, Tuple

from ._types import Array, Floats, Integers

version: str

class File_content: ...

_Surface = Tuple[Array, Array]

def optimize(
    points: Array,
    hexahedra: Array,
    reference: _Surface | None,
    options: Dict[str, Any],
    threads: int,
    progress: Callable[..., bool] | None,
) -> Tuple[Floats, Dict[str, Any], bool]: ...
def make(
    vertices: Array,
    triangles: Array,
    options: Dict[str, Any],
    threads: int,
    progress: Callable[..., bool] | None,
) -> Tuple[Floats, Integers, Dict[str, Any], bool]: ...
def quality(points: Array, hexahedra: Array) -> Floats: ...
def invalid(points: Array, hexahedra: Array) -> Integers: ...
def statistics(points: Array, hexahedra: Array) -> Dict[str, Any]: ...
def read(filename: str, label_array: str) -> Dict[str, Any]: ...
def read_surface(filename: str) -> Tuple[Floats, Integers]: ...
def write(
    filename: str, points: Array, hexahedra: Array, content: File_content | None, labels: List[int]
) -> List[str]: ...
def write_page(
    filename: str,
    title: str,
    meshes: Sequence[Tuple[str, str, Array, Array]],
    reference: _Surface | None,
    labels: List[int],
    report: str,
    why_it_stopped: str,
) -> None: ...
