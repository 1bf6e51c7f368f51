#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Optimizes one solid at growing resolution and prints, as CSV, the time of each stage, memory, and growth: the
exponent k of "time grows as n^k" between a mesh of n hexahedra and the one before it.

scaling.py [--programs build/bin] [--family ball] [--corrupt scramble] [--amount .3] [--threads 1] [SIZE ...]
scaling.py [--programs build/bin] --mesh FILE [--threads 1] [PARTS ...]   each hexahedron of a mesh in PARTS³"""

import argparse
import csv
import math
import os
import sys
import tempfile

from measured_run import Cost, optimize

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("sizes", nargs="*", type=int, default=[4, 8, 16], help="cells along the shortest side")
parser.add_argument("--programs", default="build/bin", help="folder of generate_hex_mesh and optimize_hex_mesh")
parser.add_argument("--family", default="ball", help="of generate_hex_mesh")
parser.add_argument("--mesh", help="subdivide this mesh, in the place of a family")
parser.add_argument("--threads", default="1", help="of optimize_hex_mesh")
parser.add_argument("--corrupt", help="of generate_hex_mesh: scramble, rotate or displace")
parser.add_argument("--amount", help="of generate_hex_mesh")
arguments = parser.parse_args()

table = csv.writer(sys.stdout, lineterminator="\n")
table.writerow(["hexahedra", "cpu_seconds", "growth", "wall_seconds", "set_up_and_measure_seconds", "rectification_seconds",
                "untangling_seconds", "maximization_seconds", "microseconds_per_hexahedron", "MiB", "minimum", "average", "invalid"])
before = None
for size in arguments.sizes:
    with tempfile.TemporaryDirectory() as folder:
        mesh = os.path.join(folder, "mesh.vtk")
        generate = [os.path.join(arguments.programs, "generate_hex_mesh"), "of_file" if arguments.mesh else arguments.family, mesh,
                    "--refine", str(size)]
        if arguments.mesh:
            generate += ["--input", arguments.mesh]
        if arguments.corrupt:
            generate += ["--corrupt", arguments.corrupt]
        if arguments.amount:
            generate += ["--amount", arguments.amount]
        if Cost(generate, sys.stderr).exit_code != 0:
            sys.exit("scaling.py: generate_hex_mesh failed")
        cost, status = optimize(os.path.join(arguments.programs, "optimize_hex_mesh"), mesh, os.path.join(folder, "out.vtk"),
                                ["--threads", arguments.threads])
    if status is None:
        sys.exit(f"scaling.py: optimize_hex_mesh failed on size {size}")
    after = status["after"]
    n = after["number_of_hexahedra"]
    growth = "" if before is None else f"{math.log(cost.cpu / before[1]) / math.log(n / before[0]):.2f}"
    stages = [status[stage + "_seconds"] for stage in ("rectification", "untangling", "maximization")]
    table.writerow([n, f"{cost.cpu:.2f}", growth, f"{cost.wall:.2f}", f"{status['total_seconds'] - sum(stages):.2f}", *(f"{s:.2f}" for s in stages),
                    f"{1e6 * cost.cpu / n:.0f}", f"{cost.memory:.0f}", f"{after['minimum']:.4f}", f"{after['average']:.4f}",
                    after["number_of_invalid"]])
    sys.stdout.flush()
    before = n, cost.cpu
