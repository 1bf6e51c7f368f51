#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs make_hex_mesh over the surfaces that the authors of HybridOctree_Hex publish (Tong, Halilaj and Zhang, "HybridOctree_Hex:
Hybrid octree-based adaptive all-hexahedral mesh generation with Jacobian control", 2024), and prints a table of both.

octree_table.py [--programs build/bin] [--cells 8000] [--only NAME,...] [--csv FILE] [--table FILE] [--published] FOLDER

FOLDER is a clone of github.com/CMU-CBML/HybridOctree_Hex, which has the surfaces in "input boundaries", the results in "our
results" and a table of these in README.md. With --published, the averages and deviations of its results are measured as well, those
that are there: they are no part of that table. Deviations are over the diagonal of the surface's bounding box; seconds are
of the processor. --table writes the table of the manual. A row has "!" and the reasons where a goal is missed: a mesh for every surface, certified valid, with the right
Euler characteristic, a minimum of .5, an average of .85 and a maximum deviation of .006."""

import argparse
import csv
import json
import os
import re
import statistics as numbers
import sys
import tempfile

from measured_run import Cost

GOALS = (("minimum", lambda s: s["after"]["minimum"] >= .5), ("average", lambda s: s["after"]["average"] >= .85),
         ("deviation", lambda s: s["deviation"]["maximum_relative"] <= .006),
         ("topology", lambda s: s["has_topology_of_surface"]), ("validity", lambda s: s["valid_mesh"]))


def convert(raw, surface):
    """Writes a .raw file, numbers of vertices and triangles and then both, as .off."""
    words = open(raw).read().split()
    points, triangles = int(words[0]), int(words[1])
    with open(surface, "w") as out:
        out.write(f"OFF\n{points} {triangles} 0\n")
        for i in range(points):
            out.write(" ".join(words[2 + 3 * i:5 + 3 * i]) + "\n")
        at = 2 + 3 * points
        for i in range(triangles):
            out.write("3 " + " ".join(words[at + 3 * i:at + 3 * i + 3]) + "\n")


def published_table(readme):
    """Of each model: hexahedra and minimum, as the authors print them."""
    rows = re.findall(r"^\|\s*([^|]+?)\s*\|\s*\d+\s*\|\s*(\d+)\s*\|\s*([0-9.]+)\s*\|", open(readme).read(), re.M)
    return {name: (int(hexahedra), float(minimum)) for name, hexahedra, minimum in rows}


def status_of(command):
    with tempfile.TemporaryDirectory() as folder:
        report, log = os.path.join(folder, "report.json"), os.path.join(folder, "log")
        with open(log, "w") as output:
            cost = Cost([*command, "--json", report], output)
        said = open(log, errors="replace").read()
        if not os.path.exists(report):
            return cost, None, said
        with open(report) as stream:
            return cost, json.load(stream)["status"], said


def write_table(path, rows):
    """As the manual includes it."""
    with open(path, "w") as out:
        out.write("| Surface | Theirs: hexahedra | minimum | Here: hexahedra | minimum | average | maximum deviation | seconds |\n"
                  "| :------ | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n")
        for row in rows:
            out.write("| " + " | ".join(map(str, [*row[:3], *row[5:8], row[9], row[10]])) + " |\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", default="build/bin")
    parser.add_argument("--cells", default="8000")
    parser.add_argument("--only", default="")
    parser.add_argument("--csv")
    parser.add_argument("--table")
    parser.add_argument("--published", action="store_true")
    parser.add_argument("folder")
    options = parser.parse_args()
    inputs, results = (os.path.join(options.folder, f) for f in ("input boundaries", "our results"))
    published = published_table(os.path.join(options.folder, "README.md"))
    only = set(filter(None, options.only.split(",")))
    header = ("model", "theirs: hexes", "min", "avg", "maxdev", "ours: hexes", "min", "avg", "avgdev", "maxdev", "s", "")
    line = "{:24}{:>14}{:>7}{:>7}{:>9}  {:>12}{:>7}{:>7}{:>9}{:>9}{:>7} {}"
    print(line.format(*header))
    rows, made = [], []
    for name in sorted(f[:-len("_tri.raw")] for f in os.listdir(inputs) if f.endswith("_tri.raw")):
        if only and name not in only:
            continue
        with tempfile.TemporaryDirectory() as folder:
            surface, mesh = os.path.join(folder, "surface.off"), os.path.join(folder, "mesh.vtk")
            convert(os.path.join(inputs, name + "_tri.raw"), surface)
            theirs = list(published.get(name, ("", ""))) + ["", ""]
            result = os.path.join(results, name + ".vtk")
            if options.published and os.path.exists(result):
                _, status, _ = status_of([os.path.join(options.programs, "optimize_hex_mesh"), result, mesh, "--reference",
                                          surface, "--time-limit", "0", "--quiet"])
                if status:
                    theirs = [status["before"]["number_of_hexahedra"], f"{status['before']['minimum']:.3f}",
                              f"{status['before']['average']:.3f}", f"{status['deviation']['maximum_relative']:.1e}"]
            cost, status, said = status_of([os.path.join(options.programs, "make_hex_mesh"), surface, mesh, "--cells",
                                            options.cells])
        if not status:
            reason = said.strip().split("\n")[-1]
            ours, note = [""] * 5 + [f"{cost.cpu:.1f}"], "! " + reason
        else:
            made.append((status, cost.cpu))
            missed = [goal for goal, holds in GOALS if not holds(status)]
            said = [word for word in said.split("\n") if word.startswith("THE ") or "thin" in word]
            ours = [status["after"]["number_of_hexahedra"], f"{status['after']['minimum']:.3f}",
                    f"{status['after']['average']:.3f}", f"{status['deviation']['average_relative']:.1e}",
                    f"{status['deviation']['maximum_relative']:.1e}", f"{cost.cpu:.1f}"]
            note = ("! " + ", ".join(missed) if missed else "") + (" | " + " ".join(said) if said and missed else "")
        rows.append([name, *theirs, *ours, note])
        print(line.format(*map(str, rows[-1])), flush=True)
    if made:
        def median(of):
            return numbers.median(of(status) for status, _ in made)
        print(f"{len(made)} of {len(rows)} made; medians: {median(lambda s: s['after']['number_of_hexahedra']):.0f} hexahedra, "
              f"minimum {median(lambda s: s['after']['minimum']):.3f}, average {median(lambda s: s['after']['average']):.3f}, "
              f"maximum deviation {median(lambda s: s['deviation']['maximum_relative']):.1e}, "
              f"{numbers.median(cpu for _, cpu in made):.1f} s; {sum(1 for row in rows if row[-1].startswith('!'))} miss a goal")
    if options.csv:
        with open(options.csv, "w", newline="") as stream:
            csv.writer(stream).writerows([header, *rows])
    if options.table:
        write_table(options.table, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
