# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The types of arrays, for type checkers."""

from __future__ import annotations

from typing import Any, Tuple, Union

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]
Array = npt.NDArray[Any]
Surface = Tuple[npt.ArrayLike, npt.ArrayLike]  # vertices and triangles
Number = Union[float, "np.floating[Any]", "np.integer[Any]"]
