# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Memory, threads and interruption: what users of Python expect of a long call."""

from __future__ import annotations

import signal
import sys
import threading
import time
import tracemalloc
from pathlib import Path
from typing import Any, Callable, Dict, List

import numpy as np
import pytest
from conftest import Mesh, block, in_a_process, interior, shaken_block

import hex_mesh_optimization as hmo


def with_unused_points(mesh: Mesh, number: int) -> Mesh:
    """Large arrays for which a run takes no time."""
    points, hexahedra = mesh
    return np.concatenate([points, np.zeros((number, 3))]), hexahedra


def test_contiguous_arrays_are_not_copied_by_python() -> None:
    points, hexahedra = with_unused_points(shaken_block(2), 60_000)
    cells = np.tile(block(2)[1], (1000, 1)).astype(np.int32)
    runs: List[Callable[[], object]] = [
        lambda: hmo.optimize(points, hexahedra),
        lambda: hmo.quality(points, cells),
        lambda: hmo.invalid(points, cells),
    ]
    for run in runs:
        run()
        tracemalloc.start()
        run()
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert peak < points.nbytes / 4


PEAK = """
from conftest import block
import hex_mesh_optimization as hmo
import numpy as np

def peak():
    return 1024 * int([l for l in open("/proc/self/status") if l.startswith("VmHWM")][0].split()[1])

points, hexahedra = block(70)
hmo.quality(points, hexahedra[:10])
open("/proc/self/clear_refs", "w").write("5")
before = peak()
result = hmo.quality(points, hexahedra)
print(peak() - before, points.nbytes, hexahedra.nbytes, result.nbytes)
"""


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="peak memory is asked of Linux")
def test_the_peak_of_memory_has_no_copy_of_the_mesh() -> None:
    grown, points, hexahedra, result = map(int, in_a_process(PEAK).communicate()[0].split())
    assert grown < 2 * result + points / 4  # what is made, and no mesh


def resident() -> int:
    pages = int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[1])
    return 4096 * pages


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is asked of Linux")
def test_calls_leak_nothing() -> None:
    points, hexahedra = with_unused_points(shaken_block(2), 20_000)  # half a megabyte
    seen: List[int] = []

    def watch(iteration: hmo.Iteration) -> None:
        seen[:] = [iteration.iteration]

    def fail(_: hmo.Iteration) -> None:
        raise RuntimeError

    def call(k: int) -> None:
        hmo.optimize(points, hexahedra, maximum_running_time=0, progress=watch)
        hmo.quality(points, hexahedra)
        with pytest.raises(RuntimeError):
            hmo.optimize(points, hexahedra, progress=fail)
        with pytest.raises(hmo.Input_error):
            hmo.optimize(points, hexahedra + len(points))

    for k in range(20):
        call(k)
    before, references = resident(), sys.getrefcount(watch)
    for k in range(200):
        call(k)
    assert resident() - before < 20 * points.nbytes
    assert sys.getrefcount(watch) == references


def test_another_thread_goes_on() -> None:
    points, hexahedra = shaken_block(8)
    count, is_done = 0, False

    def work() -> None:
        nonlocal count
        while not is_done:
            count += 1
            time.sleep(1e-4)

    thread = threading.Thread(target=work)
    thread.start()
    before = count
    hmo.optimize(points, hexahedra)
    after = count
    is_done = True
    thread.join()
    assert after - before > 20


def test_runs_in_two_threads_are_two_runs() -> None:
    meshes = [shaken_block(5, seed=seed) for seed in (1, 2)]
    expected = [hmo.optimize(*mesh)[0] for mesh in meshes]
    results: Dict[int, Any] = {}

    def run(k: int) -> None:
        seen: List[hmo.Iteration] = []
        points, status = hmo.optimize(*meshes[k], threads=k + 1, progress=seen.append)
        results[k] = points, seen == status.history

    threads = [threading.Thread(target=run, args=(k,)) for k in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k in (0, 1):
        assert np.array_equal(results[k][0], expected[k]) and results[k][1]


INTERRUPTED = """
from conftest import shaken_block
import hex_mesh_optimization as hmo

points, hexahedra = shaken_block(6)

def watch(iteration):
    if iteration.number_of_inverted == 0:
        print("valid", flush=True)
        while True:  # until the signal comes
            pass

try:
    hmo.optimize(points, hexahedra, progress=watch)
except hmo.Interrupted as stopped:
    print(len(hmo.invalid(stopped.points, hexahedra)), stopped.status.valid_mesh, stopped.status.return_code.name)
"""


def test_ctrl_c_ends_with_the_best_mesh() -> None:
    process = in_a_process(INTERRUPTED)
    assert process.stdout is not None and process.stdout.readline() == "valid\n"
    process.send_signal(signal.SIGINT)
    assert process.communicate()[0] == "0 True STOPPED_BY_VISITOR\n"
    assert process.returncode == 0


RUNNING = """
from conftest import shaken_block, cube_surface
import hex_mesh_optimization as hmo
import os, signal, sys, threading

points, hexahedra = shaken_block(3)
seen = []

def watch(iteration):  # the signal is for this thread, but comes while no Python runs
    seen.append(iteration)
    if len(seen) == 2:
        thread = threading.Thread(target=os.kill, args=(os.getpid(), signal.SIGINT))
        thread.start()
        thread.join()

try:
    if sys.argv[1:] == ["make"]:
        hmo.make(*cube_surface(1), cells=60, progress=watch)
    else:
        hmo.optimize(points, hexahedra, progress=watch)
except KeyboardInterrupt as stopped:
    print(type(stopped).__name__, len(seen), stopped.status.iterations, stopped.hexahedra is None)
    print(len(hmo.invalid(stopped.points, hexahedra if stopped.hexahedra is None else stopped.hexahedra)) >= 0)
"""


def test_ctrl_c_ends_within_an_iteration() -> None:
    assert in_a_process(RUNNING).communicate()[0] == "Interrupted 2 2 True\nTrue\n"
    made = in_a_process("import sys; sys.argv = ['', 'make']\n" + RUNNING).communicate()[0]
    assert made == "Interrupted 2 2 False\nTrue\n"


def test_another_signal_handler_is_heard() -> None:
    class Alarm(Exception):
        pass

    def ring(*_: Any) -> None:
        raise Alarm

    previous = signal.signal(signal.SIGUSR1, ring)
    try:
        with pytest.raises(Alarm):
            hmo.optimize(*shaken_block(3), progress=lambda i: signal.raise_signal(signal.SIGUSR1))
    finally:
        signal.signal(signal.SIGUSR1, previous)


def test_a_valid_mesh_stays_valid_when_it_is_stopped_at_once() -> None:
    points, hexahedra = shaken_block(4, 0.1)
    result, status = hmo.optimize(points, hexahedra, progress=lambda i: False)
    assert status.valid_mesh and status.iterations == 1
    assert status.after.minimum >= status.before.minimum
