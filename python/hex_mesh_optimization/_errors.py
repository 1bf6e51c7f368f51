# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The errors of the module."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Dict, Sequence, Tuple

if TYPE_CHECKING:
    from ._status import Element, Status
    from ._types import Floats, Integers

__all__ = ["Hex_mesh_file_error", "Input_error", "Interrupted"]


class Input_error(ValueError):
    """A mesh, a surface or a parameter cannot be used. The message names the argument and the element at fault."""

    def __init__(self, message: str, element: str = "MESH", element_index: int = 0) -> None:
        super().__init__(message)
        self._element = element
        #: which one of its kind, counted from 0 in the order of the argument
        self.element_index = element_index

    @property
    def element(self) -> Element:
        """What is at fault."""
        from ._status import Element

        return Element[self._element]

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (str(self), self._element, self.element_index)


class Hex_mesh_file_error(OSError, ValueError):
    """A file cannot be read or written. The message names the file and, where there is one, the line."""

    def __init__(self, message: str, filename: str = "", line: int = 0) -> None:
        super().__init__(message)
        self.filename = filename
        #: the line at fault, counted from 1; 0 if none can be named
        self.line = line

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (str(self), self.filename, self.line)


class Interrupted(KeyboardInterrupt):
    """The user has pressed Ctrl-C. Nothing is lost: here is the best mesh so far."""

    def __init__(self, points: Floats, status: Status, hexahedra: Integers | None = None) -> None:
        super().__init__("interrupted; the best mesh so far is kept in the attributes points and status")
        #: the best positions so far
        self.points = points
        #: what was reached
        self.status = status
        #: of a mesh that was made, else None
        self.hexahedra = hexahedra


# The arguments that messages of the engine are about, by what they say.
_ARGUMENTS = (
    (r"labels \d+ and \d+", "interface_references"),
    (r"^internal face ", "internal_faces"),
    (r"^periodic pair |^the translation of periodic pair |where the translation takes", "periodic_vertices"),
    (r"^the target length ", "target_edge_length_map"),
)


def naming_argument(error: Input_error, arguments: Dict[str, str], labels: Sequence[int] = ()) -> Input_error:
    """The error with the argument before the message.

    arguments: their names by the kinds of elements.
    labels: those that occur, in increasing order; the engine knows their numbers.
    """

    def in_labels(match: re.Match[str]) -> str:
        return f"labels {labels[int(match[1])]} and {labels[int(match[2])]}"

    message, name = str(error), arguments.get(error.element.name)
    for words, argument in _ARGUMENTS:
        if re.search(words, message):
            name = argument
    if name is None or message.startswith(name):
        return error
    if len(labels) > 0:
        message = re.sub(r"labels (\d+) and (\d+)", in_labels, message)
    return Input_error(f"{name}: {message}", error.element.name, error.element_index)
