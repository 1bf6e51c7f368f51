# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the functions report, and the enumerations, under the names that they have in C++."""

from __future__ import annotations

import enum
import html
import json
from dataclasses import asdict, dataclass, field, fields
from typing import Any, Dict, List, Mapping, Tuple, Type, TypeVar

from ._types import Integers

__all__ = [
    "Attempt",
    "Boundary_placement",
    "Connectivity_limit",
    "Connectivity_limit_reason",
    "Deviation",
    "Edge_length_update",
    "Element",
    "Interface_statistics",
    "Iteration",
    "Meshing_status",
    "Method",
    "Quality_statistics",
    "Region_volume",
    "Return_code",
    "Stage",
    "Status",
    "Target_edge_lengths",
    "Volume_change",
]


class Method(enum.Enum):
    """How to optimize."""

    FULL = "full"  #: what the mesh needs of the other two
    RECTIFICATION = "rectification"  #: edge-cone rectification alone
    MAXIMIZATION = "maximization"  #: untangling and quality maximization alone


class Target_edge_lengths(enum.Enum):
    """Where target edge lengths come from when no map gives them."""

    ESTIMATED = "estimated"  #: from the boundary
    INPUT = "input"  #: for meshes that are graded on purpose and not tangled


class Boundary_placement(enum.Enum):
    """Where the vertices of the boundary have to be."""

    WITHIN_TOLERANCE = "within_tolerance"  #: off the reference where that buys quality
    ON_SURFACE = "on_surface"  #: on the reference exactly


class Edge_length_update(enum.Enum):
    """What becomes of the target edge lengths once the iterations have settled."""

    NONE = "none"
    SELECTIVE = "selective"
    FULL = "full"


class Stage(enum.Enum):
    """The parts an optimization consists of."""

    RECTIFICATION = "rectification"
    UNTANGLING = "untangling"
    MAXIMIZATION = "maximization"


class Return_code(enum.Enum):
    """Why an optimization stopped. None of these says that the mesh is valid: ask Status.valid_mesh."""

    CONVERGED = "converged"
    TARGET_QUALITY_REACHED = "target_quality_reached"
    ITERATION_LIMIT = "iteration_limit"
    TIME_LIMIT = "time_limit"
    STOPPED_BY_VISITOR = "stopped_by_visitor"  #: by progress or Ctrl-C
    DEVIATION_BOUND_NOT_MET = "deviation_bound_not_met"
    NO_IMPROVEMENT = "no_improvement"  #: all positions are as they were


class Connectivity_limit_reason(enum.Enum):
    """Why the connectivity limits the quality of a hexahedron."""

    FLAT_EDGE = "flat_edge"
    FLAT_CURVE = "flat_curve"
    INTERIOR_EDGE = "interior_edge"
    INTERIOR_VERTEX = "interior_vertex"
    CURVE_VERTEX = "curve_vertex"
    SMOOTH_EDGE = "smooth_edge"
    SMOOTH_VERTEX = "smooth_vertex"


class Element(enum.Enum):
    """The kind of what an Input_error is about."""

    MESH = "mesh"
    VERTEX = "vertex"
    HEXAHEDRON = "hexahedron"
    REFERENCE_VERTEX = "reference_vertex"
    REFERENCE_FACE = "reference_face"
    PARAMETER = "parameter"


@dataclass(frozen=True)
class Iteration:
    """The state after one iteration."""

    stage: Stage
    iteration: int  #: counted from 0 within the stage
    energy: float
    number_of_inverted: int
    minimum: float  #: scaled Jacobian
    average: float  #: scaled Jacobian
    seconds: float  #: since the call

    @classmethod
    def _of(cls, members: Tuple[Any, ...]) -> Iteration:
        return cls(Stage[members[0]], *members[1:])


@dataclass(frozen=True)
class Quality_statistics:
    """The quality of a mesh in a few numbers."""

    number_of_hexahedra: int
    number_of_inverted: int
    number_of_invalid: int
    minimum: float  #: of the scaled Jacobians
    average: float
    standard_deviation: float
    minimum_with_center: float
    average_with_center: float
    maximum_edge_ratio: float
    median_edge_ratio: float
    edge_ratio_99: float


@dataclass(frozen=True)
class Deviation:
    """How far the boundary of the mesh and the reference are apart, in both directions."""

    average: float
    maximum: float
    average_relative: float  #: over the diagonal of the bounding box of the reference
    maximum_relative: float
    certified: float  #: an upper bound of the maximum; infinite where none was asked for
    bilinear: float


@dataclass(frozen=True)
class Region_volume:
    """The volume of all hexahedra with one label."""

    label: int
    before: float
    after: float


@dataclass(frozen=True)
class Interface_statistics:
    """What became of the faces between the hexahedra of two labels."""

    labels: Tuple[int, int]
    number_of_faces: int
    deviation: Deviation


@dataclass(frozen=True)
class Connectivity_limit:
    """A hexahedron whose scaled Jacobian the connectivity bounds, wherever its vertices are."""

    hexahedron: int
    reason: Connectivity_limit_reason
    largest_scaled_jacobian: float
    scaled_jacobian: float

    @property
    def is_reached(self) -> bool:
        """Whether no position can raise it by more than .01."""
        return self.scaled_jacobian >= self.largest_scaled_jacobian - 0.01


@dataclass(frozen=True)
class Volume_change:
    """Connected hexahedra with one label whose volume has changed by more than one percent."""

    label: int
    hexahedron: int  #: the first of them
    number_of_hexahedra: int
    before: float
    after: float


@dataclass(frozen=True)
class Attempt:
    """One way that was taken from the best mesh so far to a better one."""

    name: str
    is_taken: bool  #: whether what it has led to is the best mesh since then
    iterations: int
    seconds: float
    number_of_inverted: int
    minimum: float
    average: float


_S = TypeVar("_S", bound="Status")
_M = TypeVar("_M", bound="Meshing_status")


@dataclass(frozen=True, eq=False, repr=False)
class Status:
    """The result of optimize(). Hexahedra and vertices are listed by their indices, in increasing order."""

    return_code: Return_code
    before: Quality_statistics
    after: Quality_statistics
    deviation: Deviation
    regions: List[Region_volume]
    interfaces: List[Interface_statistics]
    volume_before: float
    volume_after: float
    volume_changes: List[Volume_change]
    volume_changes_in_words: List[str]
    deviation_bound: float
    iterations: int
    attempts: List[Attempt]
    rectification_seconds: float
    untangling_seconds: float
    maximization_seconds: float
    total_seconds: float
    invalid_hexahedra: Integers
    locked_hexahedra: Integers
    vertices_off_reference: Integers
    connectivity_limits: List[Connectivity_limit]
    reoriented_hexahedra: Integers  #: whose first four vertices are to be exchanged with the last four, see reoriented()
    number_of_coincident_vertices: int
    history: List[Iteration]  #: every iteration, for plots of the convergence
    why_it_stopped: str  #: in words
    _table: List[Tuple[str, str, str]] = field()
    _report: str = field()  # the JSON of the programs

    @property
    def valid_mesh(self) -> bool:
        """Whether every hexahedron is certified to be valid."""
        return len(self.invalid_hexahedra) == 0

    @property
    def is_within_deviation_bound(self) -> bool:
        """Whether the deviation is certified to be at most maximum_deviation; true if none was given."""
        return self.deviation.certified <= self.deviation_bound

    @property
    def number_of_reoriented_hexahedra(self) -> int:
        """The number of reoriented_hexahedra."""
        return len(self.reoriented_hexahedra)

    def as_dict(self) -> Dict[str, Any]:
        """What the programs write with --json as the status, of plain numbers, strings, lists and dictionaries."""
        result: Dict[str, Any] = json.loads(self._report)["status"]
        return result

    @classmethod
    def _of(cls: Type[_S], members: Mapping[str, Any]) -> _S:
        m = dict(members)
        m["return_code"] = Return_code[m["return_code"]]
        m["before"] = Quality_statistics(**m["before"])
        m["after"] = Quality_statistics(**m["after"])
        m["deviation"] = Deviation(**m["deviation"])
        m["regions"] = [Region_volume(*r) for r in m["regions"]]
        m["interfaces"] = [Interface_statistics(i[0], i[1], Deviation(**i[2])) for i in m["interfaces"]]
        m["volume_changes"] = [Volume_change(*c) for c in m["volume_changes"]]
        m["attempts"] = [Attempt(*a) for a in m["attempts"]]
        m["connectivity_limits"] = [
            Connectivity_limit(h, Connectivity_limit_reason[reason], limit, reached)
            for h, reason, limit, reached in m["connectivity_limits"]
        ]
        m["history"] = [Iteration._of(i) for i in m["history"]]
        m["_table"] = m.pop("table")
        m["_report"] = m.pop("report")
        return cls(**{f.name: m[f.name] for f in fields(cls)})

    def _sentences(self) -> List[str]:
        result = [f"Stopped after {self.iterations} iterations: {self.why_it_stopped}."]
        if self.number_of_reoriented_hexahedra > 0:
            result.append(f"{self.number_of_reoriented_hexahedra} hexahedra are numbered inside out (reoriented_hexahedra).")
        if self.number_of_coincident_vertices > 0:
            result.append(
                f"{self.number_of_coincident_vertices} vertices coincide with others: faces are in the same place, "
                "but their hexahedra are no neighbors, and may part."
            )
        if not self.is_within_deviation_bound:
            result.append(
                f"The deviation bound is not certified: the maximum is between "
                f"{self.deviation.maximum:.4g} and {self.deviation.certified:.4g}."
            )
        if len(self.vertices_off_reference) > 0:
            result.append(
                f"{len(self.vertices_off_reference)} vertices are not where they belong on the reference (vertices_off_reference)."
            )
        result += self.volume_changes_in_words
        reached = sum(limit.is_reached for limit in self.connectivity_limits)
        if reached > 0:
            result.append(f"{reached} hexahedra are at the limit that the connectivity sets (connectivity_limits).")
        if self.valid_mesh:
            result.append("The mesh is valid.")
        else:
            n = len(self.invalid_hexahedra)
            result.append(f"The mesh is not valid: {n} hexahedra are invalid (invalid_hexahedra).")
        return result

    def __str__(self) -> str:
        rows = [f"{title:<32}{before:>12}{after:>12}" for title, before, after in self._table]
        return "\n".join(rows + self._sentences())

    __repr__ = __str__

    def _repr_html_(self) -> str:
        def row(cells: Tuple[str, str, str], tag: str) -> str:
            title, before, after = (html.escape(cell) for cell in cells)
            indent = ' style="padding-left: 2em"' if title.startswith(" ") else ""
            return (
                f'<tr><th style="text-align: left"><span{indent}>{title.strip()}</span></th>'
                f"<{tag}>{before}</{tag}><{tag}>{after}</{tag}></tr>"
            )

        body = "".join(row(cells, "td") for cells in self._table[1:])
        notes = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in self._sentences())
        return f"<table><thead>{row(self._table[0], 'th')}</thead><tbody>{body}</tbody></table><ul>{notes}</ul>"


@dataclass(frozen=True)
class Part_volume:
    """A part of a surface that stays apart: what it bounds outside of those with higher labels, and what it has got."""

    label: int
    volume: float
    volume_after: float
    number_of_hexahedra: int


@dataclass(frozen=True, eq=False, repr=False)
class Meshing_status(Status):
    """The result of make(): that of the optimization, whose start is the mesh before, and that of the grid."""

    spacing: float  #: the length of the cells
    has_topology_of_surface: bool
    matches_surface: bool  #: volume, bodies, Euler characteristic and distance are what the cells explain
    number_of_bodies: int
    euler_characteristic: int
    volume_of_surface: float  #: what the surface as it was given bounds
    thin_faces: Integers  #: triangles with fewer cells behind them than minimum_cells_across asks for
    labels: Integers  #: of the hexahedra, if parts stay apart; else empty
    parts: List[Part_volume]  #: then, those

    @classmethod
    def _of(cls: Type[_M], members: Mapping[str, Any]) -> _M:
        return super()._of({**members, "parts": [Part_volume(*p) for p in members["parts"]]})

    def as_dict(self) -> Dict[str, Any]:
        result = super().as_dict()
        result["labels"] = self.labels.tolist()
        result["parts"] = [asdict(p) for p in self.parts]
        result["spacing"] = self.spacing
        result["has_topology_of_surface"] = self.has_topology_of_surface
        for name in ("matches_surface", "number_of_bodies", "euler_characteristic", "volume_of_surface"):
            result[name] = getattr(self, name)
        result["thin_faces"] = self.thin_faces.tolist()
        return result

    def _sentences(self) -> List[str]:
        result = super()._sentences()
        if not self.has_topology_of_surface:
            result.append(
                "The mesh does not have the topology of the surface: holes are closed, walls have holes, or parts are lost; "
                f"the spacing, {self.spacing:.4g}, is too large for them."
            )
        if not self.matches_surface:
            result.append(
                f"The mesh does not match the surface: its volume is {self.volume_after:.6g}, that of the surface "
                f"{self.volume_of_surface:.6g}; it has {self.number_of_bodies} bodies."
            )
        if len(self.thin_faces) > 0:
            result.append(
                f"{len(self.thin_faces)} faces of the surface have too few cells behind them (thin_faces): parts there "
                f"are thin for the spacing, {self.spacing:.4g}."
            )
        return result
