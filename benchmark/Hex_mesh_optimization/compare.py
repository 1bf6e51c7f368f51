#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs another program and optimize_hex_mesh on the same files and prints, as CSV, quality and cost of both.

compare.py --other "PROGRAM {in} {out}" [--ours "build/bin/optimize_hex_mesh {in} {out}"] [--output-extension .mesh]
           [--pages FOLDER] FILE ...

Both outputs are measured by the statistics of optimize_hex_mesh, with its certificate of validity. With --pages, there
are a page for each file that shows both results side by side, NAME.html, and the results, NAME.ours.* and NAME.other.*."""

import argparse
import csv
import os
import subprocess
import sys
import tempfile

from measured_run import Cost, fill_in, statistics

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("files", nargs="+", metavar="FILE")
parser.add_argument("--other", required=True, help="command line with {in} and {out}")
parser.add_argument("--ours", default="build/bin/optimize_hex_mesh {in} {out}", help="command line with {in} and {out}")
parser.add_argument("--output-extension", default=".mesh", help="of the files written: .mesh, .vtk or .vtu")
parser.add_argument("--pages", metavar="FOLDER", help="keep the results and write a page for each file")
arguments = parser.parse_args()

optimizer = fill_in(arguments.ours, "", "")[0]
table = csv.writer(sys.stdout, lineterminator="\n")
table.writerow(["file", "program", "exit_code", "inverted", "invalid", "minimum", "average", "edge_ratio_99", "cpu_seconds", "wall_seconds", "MiB"])
failed = False


def remove(file):
    """Of an earlier run, that it is not taken for a result of this one."""
    if os.path.exists(file):
        os.remove(file)


def measure(file, name, template, output):
    """Runs a program and adds its row to the table; returns whether there is a result."""
    remove(output)
    cost = Cost(fill_in(template, file, output))
    s = statistics(optimizer, output) if os.path.exists(output) else None
    quality = [s["number_of_inverted"], s["number_of_invalid"], f"{s['minimum']:.4f}", f"{s['average']:.4f}",
               f"{s['edge_ratio_99']:.2f}"] if s else [""] * 5
    table.writerow([file, name, cost.exit_code, *quality, f"{cost.cpu:.2f}", f"{cost.wall:.2f}", f"{cost.memory:.0f}"])
    sys.stdout.flush()
    return s is not None


def write_page(file, ours, other, page):
    """Runs the optimizer once more: what the page costs is in no table."""
    remove(page)
    subprocess.run([*fill_in(arguments.ours, file, ours), "--report", page, "--compare", other], stdout=subprocess.DEVNULL)
    return os.path.exists(page)


with tempfile.TemporaryDirectory() as scratch:
    folder = arguments.pages or scratch
    os.makedirs(folder, exist_ok=True)
    for file in arguments.files:
        base = os.path.join(folder, os.path.splitext(os.path.basename(file))[0])
        ours, other = (f"{base}.{name}{arguments.output_extension}" for name in ("ours", "other"))
        has_ours = measure(file, "ours", arguments.ours, ours)
        has_other = measure(file, "other", arguments.other, other)
        failed = failed or not (has_ours and has_other)
        if arguments.pages and has_other:
            failed = not write_page(file, ours, other, base + ".html") or failed
sys.exit(1 if failed else 0)
