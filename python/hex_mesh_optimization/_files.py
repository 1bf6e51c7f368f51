# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files: the formats of the programs, with everything that they hold beside points and hexahedra."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from typing import Any, Dict, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from . import _engine
from ._errors import Input_error, naming_argument
from ._run import reoriented
from ._status import Status
from ._types import Array, Floats, Integers

__all__ = ["Lost_data_warning", "Mesh", "read", "read_surface", "write"]


class Lost_data_warning(UserWarning):
    """What a user should know of a file: something could not be read, or the format that is written cannot hold it."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Points and hexahedra; of a file, also everything else that is there, which write() keeps."""

    points: Array
    hexahedra: Array
    labels: Array | None = None  #: one integer for each hexahedron
    internal_faces: Array = field(default_factory=lambda: np.empty((0, 4), np.int64))  #: those of the file with a label
    sets: Dict[str, Array] = field(default_factory=dict)  #: of the file of a solver, the vertices of each by its name
    notes: Tuple[str, ...] = ()  #: what a user should know of the file
    _parameters: Dict[str, Any] = field(default_factory=dict, repr=False)
    _content: Any = field(default=None, repr=False)

    @property
    def parameters(self) -> Dict[str, Any]:
        """What the mesh says of named parameters: optimize(mesh.points, mesh.hexahedra, **mesh.parameters)."""
        return {"labels": self.labels, "internal_faces": self.internal_faces, **self._parameters}


def _readable(filename: Union[str, os.PathLike[str]]) -> str:
    path = os.fspath(filename)
    if not os.path.isdir(path):  # some meshes are folders
        open(path, "rb").close()  # the errors of Python are the ones that its users know
    return path


def read(filename: Union[str, os.PathLike[str]], *, label_array: str | None = None) -> Mesh:
    """Reads a mesh in the format that the extension tells.

    label_array: the cell array of a VTK file with the labels of the hexahedra; by its name if not given.
    """
    content = _engine.read(_readable(filename), label_array or "")
    for line in content["notes"]:
        warnings.warn(f"{os.fspath(filename)}: {line}", Lost_data_warning, stacklevel=2)
    return Mesh(
        content["points"],
        content["hexahedra"],
        content["labels"],
        content["internal_faces"],
        content["sets"],
        tuple(content["notes"]),
        content["parameters"],
        content["content"],
    )


def read_surface(filename: Union[str, os.PathLike[str]]) -> Tuple[Floats, Integers]:
    """Reads a triangle surface, vertices and triangles, in the format that the extension tells."""
    return _engine.read_surface(_readable(filename))


def write(
    filename: Union[str, os.PathLike[str]],
    mesh: Mesh | Tuple[npt.ArrayLike, npt.ArrayLike],
    points: npt.ArrayLike | None = None,
    *,
    status: Status | None = None,
) -> None:
    """Writes a mesh in the format that the extension tells; the file appears complete or not at all.

    mesh: of read(), whose labels, data, sets and other cells are written as well; or points and hexahedra.
    points: in the place of those of the mesh.
    status: of optimize(); hexahedra that were numbered inside out are written with bottom and top exchanged.

    The file of a solver is copied if it is written in its own format: nothing changes but the coordinates of points.
    Warns with Lost_data_warning of what another format cannot hold.
    """
    if isinstance(mesh, tuple):
        mesh = Mesh(arguments.points(mesh[0], "mesh[0]"), arguments.hexahedra(mesh[1], "mesh[1]"))
    elif not isinstance(mesh, Mesh):
        raise TypeError(f"mesh: a Mesh or a pair (points, hexahedra) expected, not {type(mesh).__name__}")
    old_points = arguments.points(mesh.points, "mesh.points")
    new_points = old_points if points is None else arguments.points(points, "points")
    if len(new_points) != len(old_points):
        raise ValueError(f"points: {len(old_points)} expected, as many as the mesh has, not {len(new_points)}")
    hexahedra = arguments.hexahedra(mesh.hexahedra, "mesh.hexahedra")
    if status is not None:
        hexahedra = reoriented(hexahedra, status)
    labels = [] if mesh.labels is None else arguments.labels(mesh.labels, len(hexahedra), "mesh.labels").tolist()
    try:
        lost = _engine.write(os.fspath(filename), new_points, hexahedra, mesh._content, labels)
    except Input_error as error:
        raise naming_argument(error, {"HEXAHEDRON": "mesh"}) from None
    for line in lost:
        warnings.warn(f"{os.fspath(filename)}: {line}", Lost_data_warning, stacklevel=2)
