# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The calls: an optimization, a mesh of a surface, and measures of quality."""

from __future__ import annotations

from typing import Any, Dict, Mapping, Tuple

import numpy as np
import numpy.typing as npt

from . import _arguments as arguments
from . import _engine
from ._errors import Input_error, Interrupted, naming_argument
from ._progress import Progress, Watched
from ._status import (
    Boundary_placement,
    Edge_length_update,
    Meshing_status,
    Method,
    Quality_statistics,
    Status,
    Target_edge_lengths,
)
from ._types import Array, Floats, Integers, Surface

__all__ = ["invalid", "make", "optimize", "quality", "reoriented", "statistics"]

_OF_MESH = {
    "VERTEX": "points",
    "HEXAHEDRON": "hexahedra",
    "REFERENCE_VERTEX": "reference",
    "REFERENCE_FACE": "reference",
}
_OF_SURFACE = {"REFERENCE_VERTEX": "vertices", "REFERENCE_FACE": "triangles"}

_SHORT_NAMES = {"max_deviation": "maximum_deviation", "cells": "number_of_hexahedra"}


def _options(given: Dict[str, Any]) -> Dict[str, Any]:
    """Of the arguments of a call, the named parameters that need not know the mesh, checked."""
    long = {name: value for name, value in given.items() if name in arguments.OPTIONS}
    for short_name, name in _SHORT_NAMES.items():
        if short_name in given:
            long[name] = arguments.one_of(name, long[name], short_name, given[short_name])
    return {name: arguments.OPTIONS[name](value, name) for name, value in long.items() if value is not None}


def optimize(
    points: npt.ArrayLike,
    hexahedra: npt.ArrayLike,
    *,
    reference: Surface | None = None,
    labels: npt.ArrayLike | None = None,
    max_deviation: float | None = None,
    features_angle_bound: float | None = None,
    edge_is_constrained_map: npt.ArrayLike | None = None,
    vertex_is_constrained_map: npt.ArrayLike | None = None,
    hexahedron_label_map: npt.ArrayLike | None = None,
    internal_faces: npt.ArrayLike | None = None,
    interface_references: Mapping[Tuple[int, int], Surface] | None = None,
    periodic_vertices: Tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
    fixed_boundary: bool | None = None,
    boundary_placement: Boundary_placement | str | None = None,
    optimization_method: Method | str | None = None,
    target_quality: float | None = None,
    maximum_deviation: float | None = None,
    target_edge_lengths: Target_edge_lengths | str | None = None,
    target_edge_length_map: Tuple[npt.ArrayLike, npt.ArrayLike] | None = None,
    edge_length_update: Edge_length_update | str | None = None,
    number_of_iterations: int | None = None,
    number_of_restarts: int | None = None,
    surface_weight: float | None = None,
    feature_weight: float | None = None,
    regularization_weight: float | None = None,
    cone_angle_bound: float | None = None,
    maximize_minimum_quality: bool | None = None,
    maximum_running_time: float | None = None,
    verbose: bool | None = None,
    threads: int = 1,
    progress: Progress = False,
) -> Tuple[Floats, Status]:
    """Moves the vertices of a hexahedral mesh until no hexahedron is inverted and all are as good as possible.

    This is CGAL::optimize_hex_mesh(), and the parameters are its named parameters: what they mean and what they are
    if they are not given stands there. Those that are property maps in C++ are arrays here.

    points: three coordinates each. The array is not changed.
    hexahedra: the eight vertices of each, in the order of VTK; or a `cells` array of VTK (8, a, b, ..., 8, ...).
    reference: the surface that the boundary represents, vertices and triangles; the boundary as it is if not given.
    labels, or hexahedron_label_map: an integer for each hexahedron, such as its material.
    max_deviation: short for maximum_deviation.
    edge_is_constrained_map: the feature edges of the reference, pairs of its vertices.
    vertex_is_constrained_map: a truth value for each vertex, or the indices of those that must not move.
    internal_faces: four vertices each.
    interface_references: a dictionary from pairs of labels to surfaces, (vertices, triangles).
    periodic_vertices: an array of pairs of vertices, and an array with the translation of each, or one for all.
    target_edge_length_map: an array of edges, pairs of vertices, and an array with the length of each.
    threads: the result is the same, bit for bit, whatever their number.
    progress: True for a bar; or a function that is called with each Iteration, and stops the run by returning False.

    Returns the new points, and what the run reports. Raises Input_error, a ValueError, for what cannot be used, and
    Interrupted, with the best points so far, on Ctrl-C.
    """
    options = _options(locals())
    all_points = arguments.points(points, "points")
    all_hexahedra = arguments.hexahedra(hexahedra)
    if vertex_is_constrained_map is not None:
        options["vertex_is_constrained_map"] = arguments.constrained_vertices(
            vertex_is_constrained_map, len(all_points), "vertex_is_constrained_map"
        )
    all_labels = arguments.one_of("hexahedron_label_map", hexahedron_label_map, "labels", labels)
    if all_labels is not None:
        options["labels"] = arguments.labels(all_labels, len(all_hexahedra))
    surface = None if reference is None else arguments.surface(reference)
    if surface is None and edge_is_constrained_map is not None:
        raise TypeError("edge_is_constrained_map: given without a reference, whose edges it is about")
    number_of_threads = arguments.count(threads, "threads", 1, 1024)

    try:
        with Watched(progress) as watch:
            result, members, is_interrupted = _engine.optimize(
                all_points, all_hexahedra, surface, options, number_of_threads, watch
            )
    except Input_error as error:
        occurring = np.unique(options["labels"]).tolist() if "labels" in options else [0]
        raise naming_argument(error, _OF_MESH, occurring) from None
    status = Status._of(members)
    if is_interrupted:
        raise Interrupted(result, status)
    return result, status


def make(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    *,
    cells: int | None = None,
    max_deviation: float | None = None,
    number_of_hexahedra: int | None = None,
    grid_spacing: float | None = None,
    minimum_cells_across: int | None = None,
    features_angle_bound: float | None = None,
    edge_is_constrained_map: npt.ArrayLike | None = None,
    face_label_map: npt.ArrayLike | None = None,
    fixed_boundary: bool | None = None,
    boundary_placement: Boundary_placement | str | None = None,
    optimization_method: Method | str | None = None,
    target_quality: float | None = None,
    maximum_deviation: float | None = None,
    target_edge_lengths: Target_edge_lengths | str | None = None,
    edge_length_update: Edge_length_update | str | None = None,
    number_of_iterations: int | None = None,
    number_of_restarts: int | None = None,
    surface_weight: float | None = None,
    feature_weight: float | None = None,
    regularization_weight: float | None = None,
    cone_angle_bound: float | None = None,
    maximize_minimum_quality: bool | None = None,
    maximum_running_time: float | None = None,
    verbose: bool | None = None,
    threads: int = 1,
    progress: Progress = False,
) -> Tuple[Floats, Integers, Meshing_status]:
    """Makes a hexahedral mesh of the volume that a closed surface bounds.

    This is CGAL::make_hex_mesh(), and the parameters are its named parameters, as for optimize().

    vertices, triangles: the surface; neighbors have indices in common and are oriented alike, outwards.
    cells: short for number_of_hexahedra, about how many to make.
    face_label_map: an integer for each triangle. Parts with different ones stay apart, with interfaces between them, and
        status.labels has an integer for each hexahedron; where parts overlap, the highest one counts.

    Returns points, hexahedra, and what the run reports. Raises Input_error, a ValueError, for a surface that bounds no
    volume, and Interrupted, with the best mesh so far, on Ctrl-C.
    """
    options = _options(locals())
    if "number_of_hexahedra" in options and grid_spacing is not None:
        raise TypeError("grid_spacing: given beside the number of hexahedra, which it determines")
    surface_points = arguments.points(vertices, "vertices")
    surface_triangles = arguments.indices(triangles, 3, "triangles")
    if face_label_map is not None:
        options["face_labels"] = arguments.labels(face_label_map, len(surface_triangles), "face_label_map", "triangles")
    number_of_threads = arguments.count(threads, "threads", 1, 1024)

    try:
        with Watched(progress) as watch:
            points, hexahedra, members, is_interrupted = _engine.make(
                surface_points, surface_triangles, options, number_of_threads, watch
            )
    except Input_error as error:
        raise naming_argument(error, _OF_SURFACE) from None
    status = Meshing_status._of(members)
    if is_interrupted:
        raise Interrupted(points, status, hexahedra)
    return points, hexahedra, status


def _mesh(points: npt.ArrayLike, hexahedra: npt.ArrayLike) -> Tuple[Array, Array]:
    return arguments.points(points, "points"), arguments.hexahedra(hexahedra)


def quality(points: npt.ArrayLike, hexahedra: npt.ArrayLike) -> Floats:
    """The scaled Jacobian of each hexahedron: 1 for a box, 0 or less if it is inverted."""
    try:
        return _engine.quality(*_mesh(points, hexahedra))
    except Input_error as error:
        raise naming_argument(error, _OF_MESH) from None


def invalid(points: npt.ArrayLike, hexahedra: npt.ArrayLike) -> Integers:
    """The hexahedra that are not certified to be valid everywhere, by their indices in increasing order."""
    try:
        return _engine.invalid(*_mesh(points, hexahedra))
    except Input_error as error:
        raise naming_argument(error, _OF_MESH) from None


def statistics(points: npt.ArrayLike, hexahedra: npt.ArrayLike) -> Quality_statistics:
    """The quality of a mesh in a few numbers."""
    try:
        return Quality_statistics(**_engine.statistics(*_mesh(points, hexahedra)))
    except Input_error as error:
        raise naming_argument(error, _OF_MESH) from None


def reoriented(hexahedra: npt.ArrayLike, status: Status) -> Array:
    """A copy of the hexahedra in which those that were numbered inside out are not any more."""
    result = np.array(arguments.hexahedra(hexahedra))
    inside_out = status.reoriented_hexahedra
    result[inside_out] = result[inside_out][:, [4, 5, 6, 7, 0, 1, 2, 3]]
    return result
