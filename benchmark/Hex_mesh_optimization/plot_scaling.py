#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots what scaling.py prints: wall time and memory over the number of hexahedra, both axes logarithmic, one line a
file, named after it, beside a line of proportional growth. Needs matplotlib (Debian: python3-matplotlib).

plot_scaling.py PLOT.svg CSV [CSV ...]"""

import argparse
import csv
import os

import matplotlib

matplotlib.use("Agg")  # no display
matplotlib.rcParams["svg.hashsalt"] = "scaling"  # the same file for the same figures
from matplotlib import pyplot

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("plot", help="the file to write; its extension tells the format")
parser.add_argument("tables", nargs="+", metavar="CSV")
arguments = parser.parse_args()

figure, (time_axes, memory_axes) = pyplot.subplots(1, 2, figsize=(9, 4), layout="constrained")
for table in arguments.tables:
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    hexahedra = [int(row["hexahedra"]) for row in rows]
    name = os.path.splitext(os.path.basename(table))[0].replace("_", " ")
    for axes, column in (time_axes, "wall_seconds"), (memory_axes, "MiB"):
        values = [float(row[column]) for row in rows]
        line, = axes.plot(hexahedra, values, marker="o", label=name)
        proportional = [values[-1] * n / hexahedra[-1] for n in hexahedra]
        axes.plot(hexahedra, proportional, color=line.get_color(), linestyle=":", linewidth=1)
for axes, label in (time_axes, "seconds"), (memory_axes, "MiB"):
    axes.set(xscale="log", yscale="log", xlabel="hexahedra", ylabel=label)
    axes.grid(True, which="major", alpha=.3)
    axes.legend()
figure.savefig(arguments.plot, metadata={"Date": None} if arguments.plot.endswith(".svg") else None)
