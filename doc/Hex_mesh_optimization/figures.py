#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the figures of the manual and the tables in its text with the programs of this package, in the folder fig.

figures.py [--programs build/bin] [--check] [FIGURE ...]

All meshes come from generate_hex_mesh and make_hex_mesh, or from the few lines on surfaces below; nothing is random but for
fixed seeds. --check runs the programs and compares their numbers with those in fig/numbers.json, without drawing
(a number that is shown rounded may differ by what is hardly seen, as compilers differ in the last bits). Drawing needs
VTK, matplotlib and a display: scripts/figures provides them."""

import argparse
import collections
import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "fig")


# --- Surfaces: points and polygons ----------------------------------------------------------------------------------


def grid(n, m, point):
    """Of a torus: n by m quadrangles, closed in both directions, as triangles."""
    index = lambda i, j: (i % n) * m + j % m
    faces = []
    for i in range(n):
        for j in range(m):
            faces.append((index(i, j), index(i + 1, j), index(i + 1, j + 1)))
            faces.append((index(i, j), index(i + 1, j + 1), index(i, j + 1)))
    return [point(i, j) for i in range(n) for j in range(m)], faces


def knot(n=160, m=16, radius=0.42):
    """A tube around a trefoil."""
    curve = lambda t: (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -1.3 * math.sin(3 * t))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        length = math.sqrt(sum(x * x for x in a))
        return tuple(x / length for x in a)

    def point(i, j):
        t, s = 2 * math.pi * i / n, 2 * math.pi * j / m
        place, ahead, behind = curve(t), curve(t + 1e-3), curve(t - 1e-3)
        tangent = unit([a - b for a, b in zip(ahead, behind)])
        bend = unit([a + b - 2 * p for a, b, p in zip(ahead, behind, place)])
        across = unit(cross(tangent, bend))
        bend = cross(across, tangent)
        return tuple(p + radius * (math.cos(s) * a - math.sin(s) * b) for p, a, b in zip(place, bend, across))

    return grid(n, m, point)


def torus(n=60, m=30):
    """Of radii 1 and .4."""
    def point(i, j):
        t, s = 2 * math.pi * i / n, 2 * math.pi * j / m
        return ((1 + 0.4 * math.cos(s)) * math.cos(t), (1 + 0.4 * math.cos(s)) * math.sin(t), 0.4 * math.sin(s))

    return grid(n, m, point)


def bumps(n=44, m=28):
    """A sphere with bumps."""
    points, faces = [(0, 0, -1)], []
    for j in range(1, m):
        for i in range(n):
            t, s = 2 * math.pi * i / n, math.pi * j / m
            r = 1 + 0.3 * math.sin(s) ** 2 * math.cos(3 * t) * math.sin(2.5 * s)
            points.append((r * math.sin(s) * math.cos(t), r * math.sin(s) * math.sin(t), -r * math.cos(s)))
    points.append((0, 0, 1))
    index = lambda i, j: 1 + (j - 1) * n + i % n
    for i in range(n):
        faces.append((0, index(i + 1, 1), index(i, 1)))
        faces.append((len(points) - 1, index(i, m - 1), index(i + 1, m - 1)))
        for j in range(1, m - 1):
            faces.append((index(i, j), index(i + 1, j), index(i + 1, j + 1)))
            faces.append((index(i, j), index(i + 1, j + 1), index(i, j + 1)))
    return points, faces


def gear(teeth=9, hole=0.45, thickness=0.6):
    """A gear with a round hole."""
    ring = [(0.95 if step < 3 else 1.3, 2 * math.pi * (k + step / 6) / teeth) for k in range(teeth) for step in range(6)]
    n = len(ring)
    points = []
    for z in (0, thickness):
        points += [(r * math.cos(a), r * math.sin(a), z) for r, a in ring]
        points += [(hole * math.cos(a), hole * math.sin(a), z) for _, a in ring]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, n + j, j), (i, n + i, n + j)]  # bottom
        faces += [(2 * n + i, 2 * n + j, 3 * n + j), (2 * n + i, 3 * n + j, 3 * n + i)]  # top
        faces += [(i, j, 2 * n + j), (i, 2 * n + j, 2 * n + i)]  # outside
        faces += [(n + i, 3 * n + j, n + j), (n + i, 3 * n + i, 3 * n + j)]  # hole
    return points, faces


def prism(n, height, radius=1):
    """Regular, of n sides."""
    points = [(radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n), z) for z in (0, height)
              for i in range(n)]
    faces = [(0, i + 1, i) for i in range(1, n - 1)] + [(n, n + i, n + i + 1) for i in range(1, n - 1)]
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, n + j), (i, n + j, n + i)]
    return points, faces


RIDGE = ((0.6, 0, 1.1), (1.4, 1.5, 1.1))


def roof():
    """A house with a flat roof whose ridge is askew."""
    points = [(x, y, z) for z in (0, 0.8) for x, y in ((0, 0), (2, 0), (2, 1.5), (0, 1.5))] + list(RIDGE)
    faces = [(0, 3, 2), (0, 2, 1), (0, 1, 5), (0, 5, 4), (2, 3, 7), (2, 7, 6), (1, 2, 6), (1, 6, 5), (3, 0, 4), (3, 4, 7),
             (4, 5, 8), (6, 7, 9), (5, 6, 9), (5, 9, 8), (7, 4, 8), (7, 8, 9)]
    return points, faces


def write_off(file, surface):
    points, faces = surface
    with open(file, "w") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines("%.17g %.17g %.17g\n" % p for p in points)
        out.writelines(" ".join(map(str, (len(f), *f))) + "\n" for f in faces)


# --- Meshes ---------------------------------------------------------------------------------------------------------


class Mesh:
    """Points, hexahedra, and the label of each hexahedron; of a legacy VTK file in text, as this package writes it."""

    @classmethod
    def of(cls, points, hexahedra):
        mesh = cls.__new__(cls)
        mesh.points, mesh.hexahedra, mesh.labels = points, hexahedra, [0] * len(hexahedra)
        return mesh

    def __init__(self, file):
        words = open(file).read().split()
        at = words.index("POINTS")
        n = int(words[at + 1])
        values = list(map(float, words[at + 3:at + 3 + 3 * n]))
        self.points = [tuple(values[3 * i:3 * i + 3]) for i in range(n)]
        at = words.index("CELLS")
        values = list(map(int, words[at + 3:at + 3 + int(words[at + 2])]))
        self.hexahedra = [values[i + 1:i + 9] for i in range(0, len(values), 9)]
        self.labels = [0] * len(self.hexahedra)

    def write(self, file):
        with open(file, "w") as out:
            out.write(f"# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {len(self.points)} double\n")
            out.writelines("%.17g %.17g %.17g\n" % p for p in self.points)
            out.write(f"CELLS {len(self.hexahedra)} {9 * len(self.hexahedra)}\n")
            out.writelines("8 " + " ".join(map(str, h)) + "\n" for h in self.hexahedra)
            out.write(f"CELL_TYPES {len(self.hexahedra)}\n" + "12\n" * len(self.hexahedra))
            out.write(f"CELL_DATA {len(self.hexahedra)}\nSCALARS material int\nLOOKUP_TABLE default\n")
            out.writelines(f"{label}\n" for label in self.labels)

    def qualities(self):
        """The scaled Jacobian of each hexahedron."""
        corners = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))
        result = []
        for h in self.hexahedra:
            x = [self.points[v] for v in h]
            least = 1.0
            for c, (i, j, k) in enumerate(corners):
                a, b, d = ([p - q for p, q in zip(x[n], x[c])] for n in (i, j, k))
                length = math.sqrt(sum(t * t for t in a) * sum(t * t for t in b) * sum(t * t for t in d))
                volume = (a[0] * (b[1] * d[2] - b[2] * d[1]) - a[1] * (b[0] * d[2] - b[2] * d[0]) +
                          a[2] * (b[0] * d[1] - b[1] * d[0]))
                least = min(least, volume / length if length > 0 else -1.0)
            result.append(least)
        return result


class Workshop:
    """The programs, and the folder of their files."""

    def __init__(self, programs, folder):
        self.programs, self.folder = os.path.abspath(programs), folder

    def file(self, name):
        return os.path.join(self.folder, name)

    def run(self, program, *arguments):
        process = subprocess.run([os.path.join(self.programs, program), *map(str, arguments)], cwd=self.folder, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if process.returncode not in (0, 1):  # 1: not everything is met, as the report says
            sys.exit(f"figures.py: {program} {' '.join(map(str, arguments))}\n{process.stderr}")
        return process.stdout

    def generate(self, family, target, *options):
        self.run("generate_hex_mesh", family, target, *options)

    def scramble(self, source, target):
        """The mesh with all vertices of its interior at random places of its bounding box."""
        self.generate("of_file", target, "--input", source, "--refine", 1, "--corrupt", "scramble")

    def optimize(self, source, target, *options):
        """The report of optimize_hex_mesh."""
        self.run("optimize_hex_mesh", source, target, "--quiet", "--json", "report.json", *options)
        return self.report()

    def make(self, surface, target, *options):
        """The report of make_hex_mesh."""
        self.run("make_hex_mesh", surface, target, "--quiet", "--json", "report.json", *options)
        return self.report()

    def start(self, surface, target, *options):
        """What make_hex_mesh hands to the optimization."""
        self.make(surface, target, "--time-limit", 0, *options)

    def report(self):
        with open(self.file("report.json")) as stream:
            return json.load(stream)


# --- Drawing: VTK for the meshes, matplotlib for what is around them --------------------------------------------------


def libraries():
    """Needed for drawing alone."""
    global matplotlib, numpy, vtk, numpy_support, pyplot, Image
    import matplotlib
    import numpy
    import vtk
    from PIL import Image
    from vtk.util import numpy_support
    matplotlib.use("Agg")
    from matplotlib import pyplot
    matplotlib.rcParams.update({"font.size": 9, "axes.titlesize": 9, "figure.facecolor": "white"})


def quality_colors():
    """From 0 to 1, and a color of its own for inverted hexahedra."""
    bright = pyplot.get_cmap("RdYlBu")
    colors = matplotlib.colors.ListedColormap([bright(0.72 * i / 255) for i in range(256)])
    colors.set_under("#b000b0")
    return colors


def actor_of(mesh, indices, values, colors, interval, opacity, has_edges):
    """The boundary of some of the hexahedra of a mesh, each in the color of its value."""
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(numpy.array(mesh.points, dtype=float), deep=True))
    grid.SetPoints(points)
    for h in indices:
        grid.InsertNextCell(vtk.VTK_HEXAHEDRON, 8, mesh.hexahedra[h])
    array = numpy_support.numpy_to_vtk(numpy.array([float(values[h]) for h in indices]), deep=True)
    grid.GetCellData().SetScalars(array)
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *colors(i / 255))
    table.SetTableRange(*interval)
    table.SetUseBelowRangeColor(True)
    table.SetBelowRangeColor(*colors(-1.0))
    mapper = vtk.vtkDataSetMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(*interval)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetOpacity(opacity)
    look.SetEdgeVisibility(has_edges)
    look.SetEdgeColor(0.15, 0.15, 0.15)
    look.SetLineWidth(2)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)
    return actor


def surface_actor(surface):
    points, faces = surface
    data, cells, places = vtk.vtkPolyData(), vtk.vtkCellArray(), vtk.vtkPoints()
    for p in points:
        places.InsertNextPoint(p)
    for f in faces:
        cells.InsertNextCell(len(f), f)
    data.SetPoints(places)
    data.SetPolys(cells)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(0.82, 0.86, 0.9)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.3, 0.3, 0.3)
    look.SetLineWidth(1)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)
    return actor


def ridge_actor():
    line = vtk.vtkLineSource()
    line.SetPoint1(*RIDGE[0])
    line.SetPoint2(*RIDGE[1])
    tube = vtk.vtkTubeFilter()
    tube.SetInputConnection(line.GetOutputPort())
    tube.SetRadius(0.008)
    tube.SetNumberOfSides(12)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(tube.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.8, 0.1, 0.1)
    return actor


def image_of(actors, direction, up=(0, 0, 1), size=(900, 700), zoom=1.0):
    """Seen from a direction, as an array of pixels, without the margins."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(60)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*direction)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(*up)
    camera.ParallelProjectionOn()
    renderer.ResetCamera()
    camera.Zoom(zoom)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(2 * size[0], 2 * size[1])
    window.AddRenderer(renderer)
    window.Render()
    source = vtk.vtkWindowToImageFilter()
    source.SetInput(window)
    source.ReadFrontBufferOff()
    source.Update()
    image = source.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
    pixels = numpy.asarray(Image.fromarray(pixels).resize(size, Image.LANCZOS))
    rows, columns = (numpy.flatnonzero((pixels < 250).any(axis=(2, 1 - axis))) for axis in (0, 1))
    return pixels[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1]


def where(mesh, is_kept):
    """The hexahedra with centers where is_kept(x, y, z)."""
    return [h for h, corners in enumerate(mesh.hexahedra)
            if is_kept(*(sum(mesh.points[v][d] for v in corners) / 8 for d in range(3)))]


def cut(mesh, indices=None):
    """Some of the hexahedra, or all of them, in the color of their quality."""
    return [actor_of(mesh, indices or range(len(mesh.hexahedra)), mesh.qualities(), quality_colors(), (0, 1), 1, True)]


def worst(mesh, bound):
    """The hexahedra of no better quality than the bound, and a shadow of the others."""
    values = mesh.qualities()
    poor = [h for h, q in enumerate(values) if q <= bound]
    shadow = actor_of(mesh, range(len(values)), [1] * len(values), lambda _: (0.45, 0.6, 0.75, 1), (0, 1), 0.2, False)
    return [shadow] + ([actor_of(mesh, poor, values, quality_colors(), (0, 1), 1, True)] if poor else [])


def show(axes, image, title):
    axes.imshow(image)
    axes.set_title(title)
    axes.axis("off")


def histogram(axes, *of):
    """Of scaled Jacobians, on a log scale: pairs of a name and values."""
    bins = [i / 20 for i in range(-20, 21)]
    for (name, values), color in zip(of, ("#c8553d", "#2f6690")):
        axes.hist(values, bins=bins, label=name, color=color, alpha=0.75)
    axes.set(yscale="log", xlabel="scaled Jacobian", ylabel="hexahedra", xlim=(-1, 1), ylim=(0.7, None))
    axes.legend(loc="upper left", frameon=False)
    axes.spines[["top", "right"]].set_visible(False)


def color_bar(figure, axes):
    scale = pyplot.cm.ScalarMappable(pyplot.Normalize(0, 1), quality_colors())
    figure.colorbar(scale, ax=axes, label="scaled Jacobian", shrink=0.7, extend="min", aspect=30)


def save(figure, name):
    """As a PNG with few colors, the same for the same numbers."""
    file = os.path.join(FOLDER, name + ".png")
    figure.savefig(file, dpi=100, bbox_inches="tight", pad_inches=0.05, metadata={"Software": None})
    pyplot.close(figure)
    Image.open(file).convert("RGB").quantize(200, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(file, optimize=True)
    print(f"{file}: {os.path.getsize(file) // 1000} KB")


def words(report, when="after"):
    """The quality in a report, for a title."""
    q = report[when]
    return f"{q['number_of_inverted']} of {q['number_of_hexahedra']} inverted, minimum {q['minimum']:.2f}, average {q['average']:.2f}"


# --- The figures: what is run, which returns the numbers that are shown, and how they are drawn -------------------------


def summary(report):
    """Of a report, what the figures show."""
    status = report["status"]
    shown = ("number_of_hexahedra", "number_of_inverted", "minimum", "average")
    return {**{when: {name: status[when][name] for name in shown} for when in ("before", "after")},
            "valid": status["valid_mesh"], "deviation": status["deviation"]["maximum_relative"]}


def shapes():
    """Of one hexahedron: a cube, a box, one that is sheared, and two with a vertex moved along the diagonal."""
    cube = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    maps = (lambda x, y, z: (x, y, z), lambda x, y, z: (x, y, 0.25 * z), lambda x, y, z: (x - z, y, z),
            *((lambda x, y, z, t=t: tuple(c - t * x * y * z for c in (x, y, z))) for t in (0.2, 0.4)))
    return [Mesh.of([f(*p) for p in cube], [list(range(8))]) for f in maps]


def run_shapes(w):
    result = []
    for mesh in shapes():
        mesh.write(w.file("shape.vtk"))
        result.append(w.optimize("shape.vtk", "same.vtk", "--time-limit", 0)["status"]["before"]["minimum"])
    return {"scaled Jacobians": result}


def draw_shapes(w, numbers):
    figure, axes = pyplot.subplots(1, 5, figsize=(8, 1.9), layout="constrained")
    for a, mesh, quality in zip(axes, shapes(), numbers["scaled Jacobians"]):
        show(a, image_of(cut(mesh), (1.2, 1.9, 1.3)), f"{quality:.2f}")
    save(figure, "shapes")


def run_before_after(w):
    write_off(w.file("gear.off"), gear())
    w.make("gear.off", "gear.vtk", "--cells", 2000)
    w.scramble("gear.vtk", "before.vtk")
    return summary(w.optimize("before.vtk", "after.vtk", "--reference", "gear.off"))


def draw_before_after(w, numbers):
    before, after = Mesh(w.file("before.vtk")), Mesh(w.file("after.vtk"))
    kept = where(after, lambda x, y, z: z < 0.3)
    images = [image_of(cut(mesh, kept), (1.2, -2, 3.2)) for mesh in (before, after)]
    figure, axes = pyplot.subplots(1, 3, figsize=(11, 3.6), layout="constrained", width_ratios=(1, 1, 0.8))
    show(axes[0], images[0], words(numbers, "before").replace("inverted, ", "inverted,\n"))
    show(axes[1], images[1], words(numbers).replace("inverted, ", "inverted,\n"))
    color_bar(figure, axes[1])
    histogram(axes[2], ("before", before.qualities()), ("after", after.qualities()))
    save(figure, "before_after")
    small = pyplot.figure(figsize=(1.9, 1.6))
    show(small.add_axes((0, 0, 1, 1)), images[1], "")
    save(small, "before_after_small")


def run_worst(w):
    write_off(w.file("knot.off"), knot())
    w.start("knot.off", "start.vtk", "--cells", 2000)
    w.generate("of_file", "before.vtk", "--input", "start.vtk", "--refine", 1, "--corrupt", "scramble", "--amount", 0.4)
    return summary(w.optimize("before.vtk", "after.vtk", "--reference", "knot.off"))


def draw_worst(w, numbers):
    before, after = Mesh(w.file("before.vtk")), Mesh(w.file("after.vtk"))
    bound = sorted(after.qualities())[len(after.hexahedra) // 200]
    figure, axes = pyplot.subplots(1, 3, figsize=(11, 3.4), layout="constrained", width_ratios=(1, 1, 0.8))
    for a, mesh, when in ((axes[0], before, "before"), (axes[1], after, "after")):
        show(a, image_of(worst(mesh, bound), (0.3, -1, 3)), words(numbers, when).replace("inverted, ", "inverted,\n"))
    color_bar(figure, axes[1])
    histogram(axes[2], ("before", before.qualities()), ("after", after.qualities()))
    save(figure, "worst")


def run_convergence(w):
    write_off(w.file("knot.off"), knot())
    w.start("knot.off", "start.vtk", "--cells", 1500)
    w.generate("of_file", "plain.vtk", "--input", "start.vtk", "--refine", 1, "--corrupt", "scramble", "--amount", 0.4)
    w.scramble("start.vtk", "scrambled.vtk")
    result = {}
    for name in ("plain", "scrambled"):
        for method in ("rectification", "full"):
            report = w.optimize(name + ".vtk", "after.vtk", "--reference", "knot.off", "--method", method)
            result[f"{name}, {method}"] = {
                "before": report["status"]["before"]["number_of_inverted"],
                "after": report["status"]["after"]["number_of_inverted"], "minimum": report["status"]["after"]["minimum"],
                "iterations": [[i["stage"], i["number_of_inverted"], i["energy"], i["minimum"], i["average"]]
                               for i in report["iterations"]]}
    return result


def draw_convergence(w, numbers):
    figure, axes = pyplot.subplots(2, 3, figsize=(11, 5), layout="constrained")
    for row, name in zip(axes, ("plain", "scrambled")):
        run = numbers[f"{name}, rectification"]
        row[0].plot([run["before"]] + [i[1] for i in run["iterations"]], marker=".", color="#c8553d")
        row[0].set(yscale="symlog", ylim=(-0.3, 3 * run["before"]), ylabel=name + " input\ninverted hexahedra")
        row[1].plot(range(1, len(run["iterations"]) + 1), [i[2] for i in run["iterations"]], marker=".", color="#2f6690")
        row[1].set(ylabel="energy (eq. 25)")
        run = numbers[f"{name}, full"]
        row[2].plot(range(1, len(run["iterations"]) + 1), [i[3] for i in run["iterations"]], marker=".", label="minimum")
        row[2].plot(range(1, len(run["iterations"]) + 1), [i[4] for i in run["iterations"]], marker=".", label="average")
        for i, (a, b) in enumerate(zip(run["iterations"], run["iterations"][1:])):
            if a[0] != b[0]:
                row[2].axvline(i + 1.5, color="gray", linestyle=":")
        row[2].set(ylim=(-1, 1), ylabel="scaled Jacobian")
        row[2].legend(loc="lower right", frameon=False)
        for a in row:
            a.set_xlabel("iteration")
            a.grid(alpha=0.3)
    axes[0][0].set_title("rectification alone: inverted hexahedra")
    axes[0][1].set_title("rectification alone: energy")
    axes[0][2].set_title("all stages (dotted: where one ends)")
    save(figure, "convergence")


ALTERNATIVES = ("as it is", "without regularization", "regularization alone")


def run_alternatives(w):
    """Of five surfaces, what make_hex_mesh hands to the optimization; and four generated solids. Their interior is left as it is,
    displaced by up to half an edge and by up to a whole one, and scrambled."""
    given = []
    for name, surface in (("knot", knot()), ("gear", gear()), ("roof", roof()), ("torus", torus()), ("bumps", bumps())):
        write_off(w.file(name + ".off"), surface)
        given.append(name + ".vtk")
        w.start(name + ".off", given[-1], "--cells", 400)
    for family in ("ball", "cylinder", "plate_with_hole", "twisted_bar"):
        given.append(family + ".vtk")
        w.generate(family, given[-1], "--refine", 3)
    result = {}
    for name, options in (("as given", None), ("half an edge", ["--amount", 0.5]), ("one edge", ["--amount", 1]), ("scrambled", [])):
        files = given
        if options is not None:
            files = [f"changed_{file}" for file in given]
            for source, target in zip(given, files):
                w.generate("of_file", target, "--input", source, "--refine", 1, "--corrupt", "scramble", *options)
        rows = list(csv.DictReader(w.run("design_alternatives", *files).splitlines()))
        result[name] = {}
        for alternative in ALTERNATIVES:
            of = [row for row in rows if row["alternative"] == alternative]
            result[name][alternative] = {
                "meshes": len(of), "invalid after one start": sum(int(row["inverted_after_first_start"]) > 0 for row in of),
                "invalid": sum(int(row["inverted_after"]) > 0 for row in of),
                "minimum": sum(float(row["minimum"]) for row in of) / len(of),
                "average": sum(float(row["average"]) for row in of) / len(of),
                "inverted before": sum(int(row["inverted_before"]) for row in of) /
                                   sum(int(row["hexahedra"]) for row in of)}
    return result


def draw_alternatives(w, numbers):
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 2.8), layout="constrained")
    for k, (alternative, color) in enumerate(zip(ALTERNATIVES, ("#2f6690", "#d9a441", "#c8553d"))):
        places = [i + 0.27 * (k - 1) for i in range(len(numbers))]
        for a, what in ((axes[0], "minimum"), (axes[1], "average")):
            a.bar(places, [counts[alternative][what] for counts in numbers.values()], 0.25, color=color, label=alternative)
    for a, what in ((axes[0], "minimum"), (axes[1], "average")):
        a.set(ylabel=what + " scaled Jacobian,\nmean over the meshes", ylim=(0, 1))
        a.set_xticks(range(len(numbers)), numbers)
        a.spines[["top", "right"]].set_visible(False)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 1.12), ncol=3, frameon=False)
    save(figure, "alternatives")
    with open(os.path.join(FOLDER, "alternatives.table"), "w") as table:
        table.write("| Interior | Inverted before | " + " | ".join(ALTERNATIVES) + " |\n")
        table.write("| :------- | ---: |" + " ---: |" * len(ALTERNATIVES) + "\n")
        for name, counts in numbers.items():
            cells = [f"{c['invalid']} of {c['meshes']}, {c['minimum']:.2f}" for c in map(counts.get, ALTERNATIVES)]
            table.write(f"| {name} | {100 * counts[ALTERNATIVES[0]]['inverted before']:.0f} % | " + " | ".join(cells) + " |\n")


BOUNDS = (0.05, 0.1, 0.15, 0.2, 0.3)  # of the mean edge


def run_tolerance(w):
    write_off(w.file("bumps.off"), bumps())
    w.start("bumps.off", "start.vtk", "--cells", 1000)
    mesh = Mesh(w.file("start.vtk"))
    along = [math.dist(mesh.points[h[c]], mesh.points[h[c + 1]]) for h in mesh.hexahedra for c in (0, 1, 2)]
    edge = sum(along) / len(along)
    runs = {str(bound): ["--max-deviation", bound * edge] for bound in BOUNDS}
    runs.update({"no bound": [], "ON_SURFACE": ["--on-surface"], "fixed_boundary()": ["--fixed-boundary"]})
    result = {}
    for name, options in runs.items():
        status = w.optimize("start.vtk", "after.vtk", "--reference", "bumps.off", *options)["status"]
        result[name] = {"minimum": status["after"]["minimum"], "average": status["after"]["average"],
                        "inverted": status["after"]["number_of_inverted"], "deviation": status["deviation"]["maximum"] / edge,
                        "within": status["is_within_deviation_bound"]}
    return result


def draw_tolerance(w, numbers):
    figure, axes = pyplot.subplots(1, 3, figsize=(10.5, 3), layout="constrained")
    for a, what in zip(axes, ("deviation", "minimum", "average")):
        for within, face in ((True, "#2f6690"), (False, "white")):
            shown = [b for b in BOUNDS if numbers[str(b)]["within"] == within]
            if shown:
                a.plot(shown, [numbers[str(b)][what] for b in shown], "o", color="#2f6690", markerfacecolor=face,
                       label="maximum_deviation()" + ("" if within else ", not met"))
        for name, line in (("no bound", "-"), ("ON_SURFACE", "--"), ("fixed_boundary()", ":")):
            a.axhline(numbers[name][what], color="#c8553d", linestyle=line, label=name)
        a.set(xlabel="bound, in edges", ylabel=what + ("" if what == "deviation" else " scaled Jacobian"))
        a.grid(alpha=0.3)
    axes[0].set(ylabel="maximum deviation, in edges")
    axes[0].plot(BOUNDS, BOUNDS, color="gray", linewidth=0.8)
    axes[2].legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, "tolerance")


def of_materials(mesh):
    """Of the bar that generate_hex_mesh makes, in three layers."""
    n = len(mesh.hexahedra)
    return [1 if h < 0.4 * n else 2 if h < 0.8 * n else 3 for h in range(n)]


def run_materials(w):
    """A bar of three materials, its interior tangled but for the vertices between them."""
    w.generate("bent_bar", "bar.vtk", "--refine", 5)
    mesh = Mesh(w.file("bar.vtk"))
    mesh.labels = of_materials(mesh)
    of_vertex = [set() for _ in mesh.points]
    for h, corners in enumerate(mesh.hexahedra):
        for v in corners:
            of_vertex[v].add(mesh.labels[h])
    w.generate("of_file", "scrambled.vtk", "--input", "bar.vtk", "--refine", 1, "--corrupt", "scramble", "--amount", 1.5)
    scrambled = Mesh(w.file("scrambled.vtk"))
    mesh.points = [p if len(labels) > 1 else q for p, q, labels in zip(mesh.points, scrambled.points, of_vertex)]
    mesh.write(w.file("before.vtk"))
    report = w.optimize("before.vtk", "after.vtk")
    return {**summary(report), "interfaces": [i["maximum_deviation"] for i in report["status"]["interfaces"]],
            "volumes": [[r["volume_before"], r["volume_after"]] for r in report["status"]["regions"]]}


def draw_materials(w, numbers):
    before, after = Mesh(w.file("before.vtk")), Mesh(w.file("after.vtk"))
    labels = of_materials(after)
    colors = lambda x: ((0.9, 0.68, 0.5, 1), (0.65, 0.82, 0.65, 1), (0.62, 0.73, 0.9, 1))[min(2, max(0, int(3 * x)))]
    kept = where(after, lambda x, y, z: y > -0.1)
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    for a, mesh, when in zip(axes, (before, after), ("before", "after")):
        show(a, image_of([actor_of(mesh, kept, labels, colors, (1, 3), 1, True)], (-0.5, -2, 0.9)), words(numbers, when))
    save(figure, "materials")


def run_features(w):
    write_off(w.file("roof.off"), roof())
    return {str(angle): summary(w.make("roof.off", f"angle{angle}.vtk", "--cells", 1200, "--features-angle", angle))
            for angle in (20, 45)}


def draw_features(w, numbers):
    view = (-0.1, -0.7, 2)
    figure, axes = pyplot.subplots(1, 3, figsize=(10, 3.1), layout="constrained")
    show(axes[0], image_of([surface_actor(roof()), ridge_actor()], view), "the surface:\na ridge of 32\N{DEGREE SIGN}")
    for a, angle in zip(axes[1:], (20, 45)):
        q = numbers[str(angle)]
        show(a, image_of([*cut(Mesh(w.file(f"angle{angle}.vtk"))), ridge_actor()], view),
             f"features_angle_bound({angle}):\nminimum {q['after']['minimum']:.2f}, average {q['after']['average']:.2f}")
    color_bar(figure, axes[2])
    save(figure, "features")


def run_edge_lengths(w):
    w.generate("boundary_layer", "before.vtk", "--refine", 10, "--corrupt", "scramble", "--amount", 0.4)
    return {lengths: summary(w.optimize("before.vtk", lengths + ".vtk", "--edge-lengths", lengths))
            for lengths in ("estimated", "input")}


def draw_edge_lengths(w, numbers):
    figure, axes = pyplot.subplots(1, 3, figsize=(10, 3.1), layout="constrained")
    kept = where(Mesh(w.file("estimated.vtk")), lambda x, y, z: y > 0.5)
    for a, name, title in zip(axes, ("before", "estimated", "input"), ("before", "ESTIMATED", "INPUT")):
        q = numbers["input"]["before"] if name == "before" else numbers[name]["after"]
        show(a, image_of(cut(Mesh(w.file(name + ".vtk")), kept), (0.6, -2, 0.7)),
             f"{title}: {q['number_of_inverted']} inverted,\nminimum {q['minimum']:.2f}, average {q['average']:.2f}")
    color_bar(figure, axes[2])
    save(figure, "edge_lengths")


def run_from_surface(w):
    write_off(w.file("bumps.off"), bumps())
    w.start("bumps.off", "start.vtk", "--cells", 2000)
    return summary(w.make("bumps.off", "mesh.vtk", "--cells", 2000))


def draw_from_surface(w, numbers):
    figure, axes = pyplot.subplots(1, 3, figsize=(10.5, 3.5), layout="constrained")
    view = (0.4, -2, 0.9)
    show(axes[0], image_of([surface_actor(bumps())], view), "the surface")
    kept = where(Mesh(w.file("mesh.vtk")), lambda x, y, z: y > 0.07)
    for a, name, when in ((axes[1], "start", "before"), (axes[2], "mesh", "after")):
        show(a, image_of(cut(Mesh(w.file(name + ".vtk")), kept), view),
             words(numbers, when).replace("inverted, ", "inverted,\n"))
    color_bar(figure, axes[2])
    save(figure, "from_surface")


FIGURES = {"shapes": (run_shapes, draw_shapes), "before_after": (run_before_after, draw_before_after), "worst": (run_worst, draw_worst),
           "convergence": (run_convergence, draw_convergence), "alternatives": (run_alternatives, draw_alternatives),
           "tolerance": (run_tolerance, draw_tolerance), "materials": (run_materials, draw_materials),
           "features": (run_features, draw_features), "edge_lengths": (run_edge_lengths, draw_edge_lengths),
           "from_surface": (run_from_surface, draw_from_surface)}


def differences(path, committed, measured):
    """What differs by more than is hardly seen."""
    if isinstance(committed, dict) and isinstance(measured, dict):
        # how many iterations there are hangs on the last bits
        return [d for key in sorted({*committed, *measured} - {"iterations"})
                for d in differences(f"{path}.{key}", committed.get(key), measured.get(key))]
    if isinstance(committed, list) and isinstance(measured, list):
        return [d for i in range(max(len(committed), len(measured)))
                for d in differences(f"{path}[{i}]", *(x[i] if i < len(x) else None for x in (committed, measured)))]
    if isinstance(committed, float) or isinstance(measured, float):
        close = None not in (committed, measured) and math.isclose(committed, measured, rel_tol=0.05, abs_tol=0.01)
    else:
        close = committed == measured
    return [] if close else [f"{path}: {committed} is committed, {measured} measured"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figures", nargs="*", metavar="FIGURE", help=", ".join(FIGURES) + "; all if none is named")
    parser.add_argument("--programs", default="build/bin", help="folder of the programs")
    parser.add_argument("--check", action="store_true", help="compare with the numbers that are committed, and draw nothing")
    arguments = parser.parse_args()
    if not arguments.check:
        libraries()

    file = os.path.join(FOLDER, "numbers.json")
    known = {}
    if os.path.exists(file):
        with open(file) as stream:
            known = json.load(stream)
    wrong = []
    for name in arguments.figures or FIGURES:
        run, draw = FIGURES[name]
        with tempfile.TemporaryDirectory() as folder:
            w = Workshop(arguments.programs, folder)
            numbers = json.loads(json.dumps(run(w)))
            if arguments.check:
                wrong += differences(name, known.get(name), numbers)
                continue
            known[name] = numbers
            with open(file, "w") as stream:
                json.dump(known, stream, indent=1, sort_keys=True)
                stream.write("\n")
            draw(w, numbers)
    for line in wrong:
        print(line)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
