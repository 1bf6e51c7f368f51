#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solvers and other programs with the files that optimize_hex_mesh and make_hex_mesh write.

test_with_solvers.py <folder of the programs>; what is not installed is skipped.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else "."


def run(*command, expected=0, **options):
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", **options)
    if expected is not None and done.returncode != expected:
        raise AssertionError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done


def read(name):
    with open(name) as file:
        return file.read()


def optimize(before, after, *options, expected=0):
    return run(os.path.join(PROGRAMS, "optimize_hex_mesh"), before, after, "--quiet", *options, expected=expected)


def needs(*programs):
    missing = [p for p in programs if shutil.which(p) is None]
    return unittest.skipIf(missing, f"not installed: {', '.join(missing)}")


def has_module(name):
    try:
        __import__(name)
        return True
    except ImportError:
        return False


class Beam:
    """A bar of 12 x 3 x 3 hexahedra of length 8, clamped at one end, loaded at the other."""

    N = (12, 3, 3)
    SIZE = (8.0, 1.0, 1.0)

    def __init__(self, tangled):
        nx, ny, nz = self.N
        self.points = [[self.SIZE[0] * i / nx, self.SIZE[1] * j / ny, self.SIZE[2] * k / nz]
                       for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)]
        self.hexahedra = []
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    v = self.number(i, j, k)
                    up, back = (nx + 1) * (ny + 1), nx + 1
                    self.hexahedra.append([v, v + 1, v + 1 + back, v + back, v + up, v + up + 1, v + up + 1 + back, v + up + back])
        if tangled:
            for i in (3, 6, 9):
                self.points[self.number(i, 1, 1)][0] += 2 * self.SIZE[0] / nx

    def number(self, i, j, k):
        return i + (self.N[0] + 1) * (j + (self.N[1] + 1) * k)

    def end(self, i):
        return [self.number(i, j, k) for k in range(self.N[2] + 1) for j in range(self.N[1] + 1)]

    def abaqus(self):
        text = "*HEADING\nA beam\n*NODE, NSET=NALL\n"
        text += "".join(f"{v + 1}, {p[0]:.9f}, {p[1]:.9f}, {p[2]:.9f}\n" for v, p in enumerate(self.points))
        text += "*ELEMENT, TYPE=C3D8, ELSET=EALL\n"
        text += "".join(f"{h + 1}, " + ", ".join(str(v + 1) for v in c) + "\n" for h, c in enumerate(self.hexahedra))
        text += "*NSET, NSET=FIX\n" + "".join(f"{v + 1},\n" for v in self.end(0))
        text += "*NSET, NSET=TIP\n" + "".join(f"{v + 1},\n" for v in self.end(self.N[0]))
        text += "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., .3\n*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL\n"
        text += "*BOUNDARY\nFIX, 1, 3\n*STEP\n*STATIC\n*CLOAD\nTIP, 3, -1.\n*NODE PRINT, NSET=TIP\nU\n*END STEP\n"
        return text


class In_a_folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def surface(self):
        faces = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
                 (3, 0, 4), (3, 4, 7)]
        points = [(0, 0, 0), (3, 0, 0), (3, 1, 0), (0, 1, 0), (0, 0, 1), (3, 0, 1), (3, 1, 1), (0, 1, 1)]
        text = f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%g %g %g\n" % p for p in points)
        return self.write("surface.off", text + "".join("3 %d %d %d\n" % f for f in faces))

    def make(self, name):
        run(os.path.join(PROGRAMS, "make_hex_mesh"), self.surface(), self.path(name), "--cells", "300", "--quiet")
        return self.path(name)


class CalculiX(In_a_folder):
    def deflection(self, name):
        """of the tip; None if CalculiX rejects the file"""
        stem = self.path(name[:-4])
        done = run("ccx", stem, expected=None, cwd=self.folder.name)
        if done.returncode != 0 or "ERROR" in done.stdout or not os.path.getsize(stem + ".dat"):
            return None
        rows = [line.split() for line in read(stem + ".dat").split("\n") if re.match(r"\s*\d+(\s+\S+){3}\s*$", line)]
        return sum(float(row[3]) for row in rows) / len(rows)

    @needs("ccx")
    def test_a_tangled_beam_is_rejected_before_and_solved_after(self):
        self.write("sound.inp", Beam(False).abaqus())
        before = self.write("tangled.inp", Beam(True).abaqus())
        self.assertIsNone(self.deflection("tangled.inp"))
        optimize(before, self.path("better.inp"))
        expected, found = self.deflection("sound.inp"), self.deflection("better.inp")
        self.assertIsNotNone(expected)
        self.assertIsNotNone(found)
        self.assertAlmostEqual(found / expected, 1, delta=.02)
        old, new = read(before).split("\n"), read(self.path("better.inp")).split("\n")
        self.assertEqual(len(old), len(new))
        nodes = range(old.index("*NODE, NSET=NALL") + 1, old.index("*ELEMENT, TYPE=C3D8, ELSET=EALL"))
        for i, (a, b) in enumerate(zip(old, new)):
            if a != b:
                self.assertIn(i, nodes)
                self.assertEqual(a.split(",")[0], b.split(",")[0])

    @needs("ccx")
    def test_what_is_made_is_solved(self):
        self.make("mesh.inp")
        text = read(self.path("mesh.inp"))
        text += ("*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SOLID SECTION, ELSET=BLOCK_0, MATERIAL=M\n*BOUNDARY\n1, 1, 3\n2, 1, 3\n"
                 "30, 1, 3\n60, 1, 3\n*STEP\n*STATIC\n*DLOAD\nBLOCK_0, P1, 0.\n*NODE PRINT, NSET=NALL\nU\n*END STEP\n")
        self.write("mesh.inp", text)
        self.assertIsNotNone(self.deflection("mesh.inp"))


class Gmsh(In_a_folder):
    def groups(self, name):
        """what Gmsh has read: names, and the number of elements of each group"""
        again = self.path("again.msh")
        run("gmsh", name, "-save", "-format", "msh22", "-o", again, "-v", "2")
        text = read(again)
        names = re.search(r"\$PhysicalNames\n(.*?)\$EndPhysicalNames", text, re.S).group(1).split("\n")
        counts = {}
        for line in re.search(r"\$Elements\n\d+\n(.*?)\$EndElements", text, re.S).group(1).strip().split("\n"):
            key = tuple(line.split()[1:4:2])
            counts[key] = counts.get(key, 0) + 1
        return names, counts

    @needs("gmsh")
    def test_physical_groups_stay(self):
        before = self.make("mesh.msh")
        names, counts = self.groups(before)
        self.assertEqual(len(names), 9)  # six sides, one block, their number and an end
        optimize(before, self.path("better.msh"), "--free-boundary")
        self.assertEqual(self.groups(self.path("better.msh")), (names, counts))


class OpenFOAM(In_a_folder):
    # the folder with the settings that every program reads; Debian sets no variable for it
    ENVIRONMENT = dict(os.environ, **({} if "WM_PROJECT_DIR" in os.environ else {"WM_PROJECT_DIR": "/usr/share/openfoam"}))
    HEADER = "FoamFile\n{{ version 2.0; format ascii; class dictionary; object {0}; }}\n"

    @needs("blockMesh", "checkMesh")
    def test_a_case_fails_before_and_passes_after(self):
        case = self.path("case")
        self.write("case/system/controlDict", self.HEADER.format("controlDict") +
                   "application x; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl timeStep;"
                   " writeInterval 1; writePrecision 12; writeFormat ascii;\n")
        for name in ("fvSchemes", "fvSolution"):
            self.write("case/system/" + name, self.HEADER.format(name) +
                       "gradSchemes {} divSchemes {} laplacianSchemes {} ddtSchemes {} interpolationSchemes {} snGradSchemes {}\n")
        self.write("case/system/blockMeshDict", self.HEADER.format("blockMeshDict") +
                   "scale 1; vertices ((0 0 0) (4 0 0) (4 2 0) (0 2 0) (0 0 2) (4 0 2) (4 2 2) (0 2 2));\n"
                   "blocks (hex (0 1 2 3 4 5 6 7) (8 4 4) simpleGrading (1 1 1)); edges ();\n"
                   "boundary (walls { type wall; faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); });\n")
        run("blockMesh", "-case", case, env=self.ENVIRONMENT)
        points = os.path.join(case, "constant/polyMesh/points")
        text = read(points)
        self.assertIn("(2 1 1)", text)
        with open(points, "w") as file:
            file.write(text.replace("(2 1 1)", "(3.4 1 1)").replace("(1 1 1)", "(1 1.9 1.2)"))
        check = lambda folder: run("checkMesh", "-case", folder, expected=None, env=self.ENVIRONMENT).stdout
        self.assertIn("Failed", check(case))
        better = self.path("better")
        optimize(case, better)
        self.assertIn("Mesh OK", check(better))
        for name in ("faces", "owner", "neighbour", "boundary"):
            self.assertEqual(read(os.path.join(case, "constant/polyMesh", name)),
                             read(os.path.join(better, "constant/polyMesh", name)))


class Exodus(In_a_folder):
    @needs("ncdump")
    def test_only_coordinates_differ(self):
        before = self.make("mesh.exo")
        optimize(before, self.path("better.exo"), "--free-boundary")
        dumps = [run("ncdump", "-n", "x", "-p", "9,17", name).stdout for name in (before, self.path("better.exo"))]
        kept = [re.sub(r"\n coord[xyz] = [^;]*;", "", dump) for dump in dumps]
        self.assertNotEqual(kept[0], dumps[0])
        self.assertEqual(kept[0], kept[1])


@unittest.skipUnless(has_module("meshio"), "meshio is not installed")
class Meshio(In_a_folder):
    def test_cells_are_the_same(self):
        import meshio
        cells = []
        for name in ("mesh.inp", "mesh.msh", "mesh.exo"):
            self.make(name)
            optimize(self.path(name), self.path("better" + name[4:]), "--free-boundary")
            for of in (name, "better" + name[4:]):
                mesh = meshio.read(self.path(of))
                cells.append(sorted(map(tuple, mesh.get_cells_type("hexahedron").tolist())))
        self.assertGreater(len(cells[0]), 100)
        for other in cells[1:]:
            self.assertEqual(cells[0], other)


if __name__ == "__main__":
    unittest.main()
