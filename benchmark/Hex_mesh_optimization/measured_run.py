# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of programs with their costs, and the quality of the meshes that they write."""

import json
import os
import shlex
import subprocess
import tempfile
import time


class Cost:
    """Of one process: seconds of the processor and of the clock, MiB of memory at its peak, and its exit code."""

    def __init__(self, command, output=subprocess.DEVNULL):
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=output, stderr=output)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = self.exit_code = os.waitstatus_to_exitcode(status)
        self.wall = time.monotonic() - start
        self.cpu = usage.ru_utime + usage.ru_stime
        self.memory = usage.ru_maxrss / 1024


def optimize(optimizer, source, target, options=()):
    """Runs optimize_hex_mesh; returns its cost and the status that it reports, None if there is no result."""
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        cost = Cost([optimizer, source, target, "--quiet", "--json", report, *options])
        if not os.path.exists(report):
            return cost, None
        with open(report) as stream:
            return cost, json.load(stream)["status"]


def statistics(optimizer, mesh):
    """The quality of a mesh, as optimize_hex_mesh finds it; None for a file that cannot be read."""
    with tempfile.TemporaryDirectory() as folder:
        # stopped before it begins, the program reports on the mesh as it is
        _, status = optimize(optimizer, mesh, os.path.join(folder, "same.vtk"), ["--time-limit", "0"])
        return status and status["before"]


def fill_in(template, source, target):
    """The words of a command line with the files in the places of {in} and {out}."""
    return [word.replace("{in}", source).replace("{out}", target) for word in shlex.split(template)]
