#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs another program beside optimize_hex_mesh on the same files and prints, as CSV, quality and cost of both.

compare.py --other "PROGRAM {in} {out}" [--ours "build/bin/optimize_hex_mesh {in} {out}"] [--output-extension .mesh] FILE ...

Both outputs are measured by the statistics of optimize_hex_mesh, with its certificate of validity."""

import argparse
import csv
import os
import sys
import tempfile

from measured_run import Cost, fill_in, statistics

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("files", nargs="+", metavar="FILE")
parser.add_argument("--other", required=True, help="command line with {in} and {out}")
parser.add_argument("--ours", default="build/bin/optimize_hex_mesh {in} {out}", help="command line with {in} and {out}")
parser.add_argument("--output-extension", default=".mesh", help="of the files written: .mesh, .vtk or .vtu")
arguments = parser.parse_args()

optimizer = fill_in(arguments.ours, "", "")[0]
table = csv.writer(sys.stdout, lineterminator="\n")
table.writerow(["file", "program", "exit_code", "inverted", "invalid", "minimum", "average", "edge_ratio_99", "cpu_seconds", "wall_seconds", "MiB"])
failed = False
for file in arguments.files:
    for name, template in (("ours", arguments.ours), ("other", arguments.other)):
        with tempfile.TemporaryDirectory() as folder:
            output = os.path.join(folder, "out" + arguments.output_extension)
            cost = Cost(fill_in(template, file, output))
            s = statistics(optimizer, output) if os.path.exists(output) else None
        failed = failed or s is None
        quality = [s["number_of_inverted"], s["number_of_invalid"], f"{s['minimum']:.4f}", f"{s['average']:.4f}",
                   f"{s['edge_ratio_99']:.2f}"] if s else [""] * 5
        table.writerow([file, name, cost.exit_code, *quality, f"{cost.cpu:.2f}", f"{cost.wall:.2f}", f"{cost.memory:.0f}"])
        sys.stdout.flush()
sys.exit(1 if failed else 0)
