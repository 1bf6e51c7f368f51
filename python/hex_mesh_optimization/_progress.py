# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""How a run is watched: a bar, or a function of the caller's."""

from __future__ import annotations

import importlib
import sys
import warnings
from typing import Any, Callable, Protocol, TextIO, Union

import numpy as np

from ._status import Iteration

#: True for a bar; or what is called after each iteration, and stops the run by returning False
Progress = Union[bool, Callable[[Iteration], object]]


def is_notebook() -> bool:
    """Whether the cells of a notebook show what is written."""
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return shell is not None and hasattr(shell, "kernel")


class _Bar(Protocol):
    def __call__(self, iteration: Iteration) -> object: ...

    def close(self) -> None: ...


def _in_words(i: Iteration) -> str:
    quality = f"scaled Jacobian minimum {i.minimum:.3f}, mean {i.average:.3f}"
    return f"{i.stage.value} {i.iteration}: {i.number_of_inverted} inverted, {quality}"


class _Tqdm_bar:
    def __init__(self, tqdm: Any) -> None:
        self._bar = tqdm.tqdm(disable=False if is_notebook() else None, unit=" iterations")

    def __call__(self, iteration: Iteration) -> None:
        self._bar.set_description_str(_in_words(iteration), refresh=False)
        self._bar.update()

    def close(self) -> None:
        self._bar.close()


class _Plain_bar:
    """A line that is written again and again, on a terminal or in a notebook alone."""

    _width = 100

    def __init__(self, out: TextIO) -> None:
        self._out = out
        self._next: float = 0  # no terminal needs more than ten lines a second
        self._is_shown = out.isatty() or is_notebook()

    def __call__(self, iteration: Iteration) -> None:
        if self._is_shown and iteration.seconds >= self._next:
            self._next = iteration.seconds + 0.1
            self._out.write("\r" + f"{iteration.seconds:.1f} s  {_in_words(iteration)}".ljust(self._width))
            self._out.flush()

    def close(self) -> None:
        if self._next > 0:
            self._out.write("\r" + " " * self._width + "\r")
            self._out.flush()


def _bar() -> _Bar:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # in a notebook without widgets it is a line of text, and says so
            return _Tqdm_bar(importlib.import_module("tqdm.auto"))
    except ImportError:
        return _Plain_bar(sys.stderr)


class Watched:
    """What the compiled part calls, or None; to be closed at the end, which `with` does."""

    def __init__(self, progress: Progress) -> None:
        self._watch: Callable[[Iteration], object] | None = None
        self._bar: _Bar | None = None
        if isinstance(progress, (bool, np.bool_)):
            if progress:
                self._watch = self._bar = _bar()
        elif callable(progress):
            self._watch = progress
        else:
            raise TypeError(f"progress: True, False or a function expected, not {progress!r}")

    def __enter__(self) -> Callable[..., bool] | None:
        watch = self._watch
        if watch is None:
            return None

        def on_iteration(*members: Any) -> bool:
            assert watch is not None
            answer = watch(Iteration._of(members))
            return not (isinstance(answer, (bool, np.bool_)) and not answer)

        return on_iteration

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()
