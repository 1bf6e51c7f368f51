# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Arguments as the compiled part takes them. Everything that is refused is named."""

from __future__ import annotations

import enum
import numbers
import operator
from typing import Any, Callable, Dict, Mapping, Tuple, Type

import numpy as np
import numpy.typing as npt

from ._status import Boundary_placement, Edge_length_update, Method, Target_edge_lengths
from ._types import Array


def _array(value: npt.ArrayLike, name: str, kinds: str, expected: str) -> Array:
    try:
        array = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: rows of the same length expected") from None
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name}: an array without a mask expected")
    if array.dtype.kind not in kinds and not (array.size == 0 and array.dtype.kind == "f"):
        raise TypeError(f"{name}: {expected} expected, not {array.dtype}")
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def _require_columns(array: Array, columns: int, name: str) -> Array:
    if array.size == 0 and array.ndim <= 2:
        return array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name}: an array of shape (n, {columns}) expected, not {array.shape}")
    return array


def points(value: npt.ArrayLike, name: str) -> Array:
    """Three coordinates each, as float64."""
    array = _require_columns(_array(value, name, "fiu", "numbers"), 3, name)
    return array if array.dtype == np.float64 else array.astype(np.float64)


def indices(value: npt.ArrayLike, columns: int, name: str) -> Array:
    """Rows of integers, of the type that they have."""
    array = _require_columns(_array(value, name, "iu", "integers"), columns, name)
    return array if array.size > 0 else array.astype(np.int64)


def hexahedra(value: npt.ArrayLike, name: str = "hexahedra") -> Array:
    """Eight vertices each; also in the form that VTK has, with the number of vertices before those of each cell."""
    array = _array(value, name, "iu", "integers")
    if array.size == 0:
        return np.empty((0, 8), np.int64)
    if array.ndim == 1 or (array.ndim == 2 and array.shape[1] == 9):
        cells = array
        if array.ndim == 1:
            end = 9 * (array.size // 9)
            counts = array[:end:9]
            if end != array.size or not np.all(counts == 8):
                first = int(np.argmax(counts != 8)) if not np.all(counts == 8) else len(counts)
                raise ValueError(f"{name}: cell {first} is no hexahedron: 8 and then its eight vertices expected")
            cells = array.reshape(-1, 9)
        elif not np.all(array[:, 0] == 8):
            first = int(np.argmax(array[:, 0] != 8))
            raise ValueError(f"{name}: cell {first} is no hexahedron: it has {array[first, 0]} vertices")
        return cells[:, 1:]
    return _require_columns(array, 8, name)


def surface(value: Any, name: str = "reference") -> Tuple[Array, Array]:
    """Vertices and triangles."""
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise TypeError(f"{name}: a pair (vertices, triangles) expected, not {type(value).__name__}")
    return points(value[0], f"{name}[0]"), indices(value[1], 3, f"{name}[1]")


def number(value: Any, name: str) -> float:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: a number expected, not {value!r}")
    if value != value:
        raise ValueError(f"{name}: nan is no usable value")
    return float(value)


def count(value: Any, name: str, least: int = 0, most: int = 2**31 - 1) -> int:
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        result = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: an integer expected, not {value!r}") from None
    if not least <= result <= most:
        raise ValueError(f"{name}: an integer from {least} to {most} expected, not {result}")
    return result


def flag(value: Any, name: str) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name}: True or False expected, not {value!r}")
    return bool(value)


def choice(value: Any, name: str, enumeration: Type[enum.Enum]) -> str:
    """The name of the enumerator, which may be given by its value."""
    try:
        return enumeration(value).name
    except ValueError:
        names = ", ".join(repr(e.value) for e in enumeration)
        raise ValueError(f"{name}: one of {enumeration.__name__} expected ({names}), not {value!r}") from None


def labels(value: npt.ArrayLike, number: int, name: str = "labels", of: str = "hexahedra") -> Array:
    array = _array(value, name, "iu", "integers")
    if array.shape != (number,):
        expected = f"one integer for each of the {number} {of}"
        raise ValueError(f"{name}: {expected} expected, not {array.shape}")
    return array


def constrained_vertices(value: npt.ArrayLike, number_of_points: int, name: str) -> Array:
    """A truth value for each vertex; given as that, or as the indices of vertices."""
    array = _array(value, name, "biu", "truth values, or integers,")
    if array.dtype.kind == "b":
        if array.shape != (number_of_points,):
            expected = f"one truth value for each of the {number_of_points} points"
            raise ValueError(f"{name}: {expected} expected, not {array.shape}")
        return array
    if array.ndim != 1:
        raise ValueError(f"{name}: an array of indices expected, not of shape {array.shape}")
    mask = np.zeros(number_of_points, np.bool_)
    if array.size > 0:
        outside = (array < 0) | (array >= number_of_points)
        if np.any(outside):
            raise ValueError(f"{name}: there is no vertex {array[np.argmax(outside)]}")
        mask[array] = True
    return mask


def interface_references(value: Any, name: str) -> Any:
    """Of a dictionary from two labels to a surface."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{name}: a dictionary from pairs of labels to surfaces expected, not {type(value).__name__}")
    result = []
    for pair, of_pair in value.items():
        if not isinstance(pair, tuple) or len(pair) != 2:
            raise TypeError(f"{name}: a pair of labels expected, not {pair!r}")
        a, b = (operator.index(label) for label in pair)
        result.append((a, b, *surface(of_pair, f"{name}[{a}, {b}]")))
    return result


def _pair(value: Any, name: str, expected: str) -> Tuple[Any, Any]:
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        raise TypeError(f"{name}: a pair ({expected}) expected")
    return value[0], value[1]


def periodic_vertices(value: Any, name: str) -> Tuple[Array, Array]:
    """Pairs of vertices, and the translation of each, or one for all."""
    pairs, translations = _pair(value, name, "pairs, translations")
    pairs = indices(pairs, 2, f"{name}[0]")
    translations = _array(translations, f"{name}[1]", "fiu", "numbers").astype(np.float64)
    if translations.shape not in ((3,), (len(pairs), 3)):
        raise ValueError(f"{name}[1]: an array of shape (3,) or ({len(pairs)}, 3) expected, not {translations.shape}")
    return pairs, np.broadcast_to(translations, (len(pairs), 3))


def target_edge_length_map(value: Any, name: str) -> Tuple[Array, Array]:
    """Edges, and the length of each."""
    edges, lengths = _pair(value, name, "edges, lengths")
    edges = indices(edges, 2, f"{name}[0]")
    lengths = _array(lengths, f"{name}[1]", "fiu", "numbers").astype(np.float64)
    if lengths.shape != (len(edges),):
        raise ValueError(f"{name}[1]: one length for each of the {len(edges)} edges expected, not {lengths.shape}")
    return edges, lengths


#: the named parameters that need not know the mesh, with what checks them
OPTIONS: Dict[str, Callable[[Any, str], Any]] = {
    "features_angle_bound": number,
    "boundary_placement": lambda v, n: choice(v, n, Boundary_placement),
    "fixed_boundary": flag,
    "optimization_method": lambda v, n: choice(v, n, Method),
    "target_quality": number,
    "maximum_deviation": number,
    "maximum_running_time": number,
    "target_edge_lengths": lambda v, n: choice(v, n, Target_edge_lengths),
    "edge_length_update": lambda v, n: choice(v, n, Edge_length_update),
    "number_of_iterations": count,
    "number_of_restarts": count,
    "surface_weight": number,
    "feature_weight": number,
    "regularization_weight": number,
    "cone_angle_bound": number,
    "maximize_minimum_quality": flag,
    "verbose": flag,
    "edge_is_constrained_map": lambda v, n: indices(v, 2, n),
    "internal_faces": lambda v, n: indices(v, 4, n),
    "interface_references": interface_references,
    "periodic_vertices": periodic_vertices,
    "target_edge_length_map": target_edge_length_map,
    "number_of_hexahedra": lambda v, n: count(v, n, 1),
    "grid_spacing": number,
    "minimum_cells_across": lambda v, n: count(v, n, 1),
}


def one_of(name: str, value: Any, short_name: str, short_value: Any) -> Any:
    """A parameter that has a short name as well."""
    if value is not None and short_value is not None:
        raise TypeError(f"{short_name} and {name} are the same parameter: give one of them")
    return value if short_value is None else short_value
