#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs optimize_hex_mesh over the published meshes of Livesu, Sheffer, Vining and Tarini, "Practical Hex-Mesh Optimization
via Edge-Cone Rectification" (2015), and prints Tables 1 to 3 of the paper with what it reaches.

paper_tables.py [--programs build/bin] [--threads 1] FOLDER

FOLDER holds pairs NAME_in.mesh and NAME_out.mesh, as the collection of HexaLab (www.hexalab.net) names them, such as
bunny_in.mesh and bunny_stresstest_out.mesh; models that are not there are left out. Of each model there are these rows:
  paper      what the paper prints, of its own method and of those that it compares with
  published  the output that its authors have published, measured here
  ours       the output of optimize_hex_mesh with its default options, measured here
Inverted are hexahedra with a scaled Jacobian of 0 or less; the distance is the average one between the boundaries of input and output, over the
diagonal of the bounding box; seconds are of the processor, those of the paper of an Intel i7-4770K by the clock."""

import argparse
import os
import re
import sys
import tempfile

from measured_run import optimize

# Model, and rows of the paper: method, inverted, average, minimum, distance, seconds. None: not printed.
OWN = "edge-cone rectification"
RUIZ_A, RUIZ_B, BREWER, AIGERMAN = "Ruiz-Gironés 2014a", "Ruiz-Gironés 2014b", "Brewer 2003", "Aigerman 2013"
TABLES = {
    "Table 1: models": [
        ("asm001", (OWN, 0, .87, .17, 2.0e-4, 31)), ("asm106", (OWN, 0, .91, .25, 8.6e-5, 110)),
        ("clef2", (OWN, 0, .90, .34, 1.5e-4, 3)), ("bunny", (OWN, 0, .97, .61, 4.6e-4, 20)),
        ("dancing_children", (OWN, 0, .94, .35, 2.2e-4, 19)), ("kingkong", (OWN, 0, .97, .27, 4.1e-4, 119)),
        ("cap", (OWN, 0, .87, .11, 6.6e-4, 91)), ("bust", (OWN, 0, .92, .11, 9.0e-4, 4)),
        ("dragon", (OWN, 0, .90, .10, 5.9e-4, 250)), ("part29", (OWN, 0, .93, .35, 2.9e-4, 69)),
        ("it-vhs", (OWN, 0, .88, .35, 1.4e-4, 85)), ("cad6", (OWN, 0, .93, .29, 1.6e-4, 58))],
    "Table 2: corrupted models": [
        ("asm001_stresstest", (OWN, 0, .85, .12, 2.7e-4, 779)), ("clef2_stresstest", (OWN, 0, .90, .24, 1.4e-4, 109)),
        ("hanger_stresstest", (OWN, 0, .99, .72, 1.0e-4, 11)), ("impeller_stresstest", (OWN, 0, .94, .18, 5.5e-5, 37)),
        ("armadillo_stresstest", (OWN, 0, .94, .13, 2.5e-3, 102)), ("part29_stresstest", (OWN, 0, .93, .24, 3.4e-4, 180))],
    "Table 3: comparison with others": [
        ("ewc3", (RUIZ_A, None, .93, .45, 0, None), (BREWER, None, .94, -.03, .02, None), (OWN, 0, .96, .56, 1.3e-5, None)),
        ("gear", (RUIZ_A, None, .89, .46, 0, None), (BREWER, None, .88, .37, 0, None), (OWN, 0, .91, .59, 7.2e-6, None)),
        ("linking_rod", (RUIZ_A, None, .92, .41, 0, None), (BREWER, None, .92, .26, 0, None), (OWN, 0, .95, .55, 5.1e-6, None)),
        ("sphere_plane", (RUIZ_A, None, .90, .20, 0, None), (OWN, 0, .95, .37, 5.4e-6, None)),
        ("half_gear", (RUIZ_B, None, .98, .70, None, None), (OWN, 0, .99, .91, 5.3e-4, None)),
        ("block", (AIGERMAN, None, .79, -.98, 0, None), (OWN, 0, .87, .25, 6.5e-5, None)),
        ("block_stresstest", (AIGERMAN, None, .50, .07, .01, None), (OWN, 0, .83, .25, 7.8e-5, None)),
        ("armadillo", (RUIZ_A, None, .80, -.74, 0, None), (BREWER + ", fixed boundary", None, .91, -.99, 0, None),
         (BREWER + ", free boundary", None, .79, -.99, .02, None), (OWN, 0, .90, .14, 7.2e-4, None))]}


def key(name):
    """Without what spelling may differ in."""
    return re.sub("[^a-z0-9]", "", name.lower())


def boundary(mesh, surface):
    """Writes the faces of only one hexahedron of a Medit file as .off."""
    words = re.sub("#.*", "", open(mesh).read()).split()
    at = words.index("Vertices")
    n = int(words[at + 1])
    points = [words[at + 2 + 4 * i:at + 5 + 4 * i] for i in range(n)]
    at = words.index("Hexahedra")
    faces = {}
    for i in range(int(words[at + 1])):
        h = [int(v) - 1 for v in words[at + 2 + 9 * i:at + 10 + 9 * i]]
        for corners in (0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7):
            face = [h[c] for c in corners]
            faces.setdefault(tuple(sorted(face)), []).append(face)
    outer = [of_one[0] for of_one in faces.values() if len(of_one) == 1]
    with open(surface, "w") as out:
        out.write(f"OFF\n{n} {len(outer)} 0\n")
        out.writelines(" ".join(p) + "\n" for p in points)
        out.writelines("4 " + " ".join(map(str, f)) + "\n" for f in outer)


def row(method, inverted, average, minimum, distance, seconds):
    cells = ["" if value is None else form.format(value) for value, form in
             ((inverted, "{}"), (average, "{:.3f}"), (minimum, "{:.3f}"), (distance, "{:.1e}"), (seconds, "{:.0f}"))]
    print(f"  {method:36}" + "".join(f"{cell:>10}" for cell in cells))


def measured(method, status, when, seconds):
    q = status[when]
    row(method, q["number_of_inverted"], q["average"], q["minimum"], status["deviation"]["average_relative"], seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER")
    parser.add_argument("--programs", default="build/bin", help="folder of optimize_hex_mesh")
    parser.add_argument("--threads", default="1", help="of optimize_hex_mesh")
    arguments = parser.parse_args()
    optimizer = os.path.join(arguments.programs, "optimize_hex_mesh")
    files = {key(name[:-len(".mesh")]): os.path.join(arguments.folder, name)
             for name in sorted(os.listdir(arguments.folder)) if name.endswith(".mesh")}

    number_of_models, failed = 0, False
    for title, models in TABLES.items():
        print(f"{title}\n  {'':36}" + "".join(f"{name:>10}" for name in ("inverted", "average", "minimum", "distance", "seconds")))
        for model, *rows in models:
            source, published = (files.get(key(model + end)) for end in ("_in", "_out"))
            if source is None:
                continue
            number_of_models += 1
            with tempfile.TemporaryDirectory() as folder:
                target, surface = os.path.join(folder, "ours.mesh"), os.path.join(folder, "boundary.off")
                cost, status = optimize(optimizer, source, target, ["--threads", arguments.threads])
                if status is None:
                    failed = True
                    print(f"{model}: optimize_hex_mesh failed")
                    continue
                print(f"{model}, {status['before']['number_of_hexahedra']} hexahedra")
                q = status["before"]
                row("input", q["number_of_inverted"], q["average"], q["minimum"], None, None)
                for of_paper in rows:
                    row("paper: " + of_paper[0], *of_paper[1:])
                if published is not None:
                    boundary(source, surface)
                    # stopped before it begins, the program reports on the mesh as it is
                    _, of_published = optimize(optimizer, published, target, ["--reference", surface, "--time-limit", "0"])
                    if of_published is not None:
                        measured("published", of_published, "before", None)
                measured("ours", status, "after", cost.cpu)
                sys.stdout.flush()
    if number_of_models == 0:
        print(f"no model of the paper is in {arguments.folder}", file=sys.stderr)
    sys.exit(1 if failed or number_of_models == 0 else 0)


if __name__ == "__main__":
    main()
