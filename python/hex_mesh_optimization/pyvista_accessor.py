# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The accessor of pyvista, from its version 0.48 on: import this module, and a grid has grid.hmo.optimize().

It is registered without that where pyvista has been imported before hex_mesh_optimization.
"""

from __future__ import annotations

import importlib
from typing import Any, Tuple

import numpy as np

from ._adapters import optimize_grid
from ._run import invalid, quality
from ._status import Status
from ._types import Array, Floats, Integers

__all__ = ["Accessor"]


class Accessor:
    """What a pyvista.UnstructuredGrid has as hmo."""

    def __init__(self, grid: Any) -> None:
        self._grid = grid

    def _hexahedra(self) -> Array:
        cells: Array = self._grid.cells_dict.get(12, np.empty((0, 8), np.int64))
        return cells

    def optimize(self, **parameters: Any) -> Tuple[Any, Status]:
        """See optimize_grid()."""
        return optimize_grid(self._grid, **parameters)

    def quality(self) -> Floats:
        """The scaled Jacobian of each hexahedron."""
        return quality(self._grid.points, self._hexahedra())

    def invalid(self) -> Integers:
        """The hexahedra that are not certified to be valid, counted among hexahedra."""
        return invalid(self._grid.points, self._hexahedra())


def _register() -> None:
    pyvista = importlib.import_module("pyvista")
    if hasattr(pyvista, "register_dataset_accessor"):
        pyvista.register_dataset_accessor("hmo", pyvista.UnstructuredGrid)(Accessor)


_register()
