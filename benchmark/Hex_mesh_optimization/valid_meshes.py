#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What feasible steps gain on meshes that are valid already, as Markdown.

usage: valid_meshes.py PROGRAM MESH [MESH ...]

PROGRAM is optimize_hex_mesh; it runs on each mesh as it is, with --fixed-boundary and with --on-surface. The meshes that the
numbers of Interior_point_parameters were chosen with are those that the authors of HybridOctree_Hex publish as their results
(github.com/CMU-CBML/HybridOctree_Hex: bone, bunny, bottle, dtorus, kitten, venus, ...), which the reader fetches.
"""
import json
import os
import subprocess
import sys
import tempfile

RUNS = {"": [], "fixed boundary": ["--fixed-boundary"], "on the surface": ["--on-surface"]}


def run(program, mesh, options):
    with tempfile.TemporaryDirectory() as folder:
        record = os.path.join(folder, "record.json")
        output = os.path.join(folder, "output.vtk")
        subprocess.run([program, mesh, output, "--quiet", "--json", record, *options], check=False)
        if not os.path.exists(record):
            return None
        with open(record, encoding="utf-8") as stream:
            return json.load(stream)["status"]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    print("| mesh | run | hexahedra | minimum | | average | | deviation / diagonal | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    for mesh in sys.argv[2:]:
        for name, options in RUNS.items():
            status = run(sys.argv[1], mesh, options)
            title = f"| {os.path.splitext(os.path.basename(mesh))[0]} | {name} |"
            if status is None:
                print(title, "no result | | | | | | |")
                continue
            before, after = status["before"], status["after"]
            print(title, f"{after['number_of_hexahedra']} | {before['minimum']:.3f} | {after['minimum']:.3f} | "
                  f"{before['average']:.4f} | {after['average']:.4f} | "
                  f"{status['deviation']['maximum_relative']:.1e} | {status['total_seconds']:.1f} |", flush=True)


if __name__ == "__main__":
    main()
