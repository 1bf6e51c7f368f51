# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The runs: the same as those of the programs, from arrays of every form, to arrays."""

from __future__ import annotations

import copy
import json
import pickle
from pathlib import Path
from typing import Any, Callable, List

import numpy as np
import pytest
from conftest import Mesh, block, cube_surface, interior, shaken_block, write_surface

import hex_mesh_optimization as hmo

Program = Callable[..., None]


def test_bits_are_those_of_the_program(program: Program, tmp_path: Path) -> None:
    program("generate_hex_mesh", "plate_with_hole", tmp_path / "in.vtk", "--refine", 3, "--corrupt", "scramble")
    program("optimize_hex_mesh", tmp_path / "in.vtk", tmp_path / "out.vtk", "--json", tmp_path / "out.json")
    mesh, expected = hmo.read(tmp_path / "in.vtk"), hmo.read(tmp_path / "out.vtk")
    points, status = hmo.optimize(mesh.points, mesh.hexahedra, labels=mesh.labels, threads=2)
    assert np.array_equal(points, expected.points)
    report = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    own, its = status.as_dict(), report["status"]
    times = [name for name in own if name.endswith("seconds")]
    for timed in [own, its]:
        for name in times:
            del timed[name]
        for attempt in timed["attempts"]:
            del attempt["seconds"]
    assert own == its
    assert [i.minimum for i in status.history] == [i["minimum"] for i in report["iterations"]]


def test_a_reference_and_labels_act_as_in_the_program(program: Program, tmp_path: Path) -> None:
    points, hexahedra = shaken_block(3)
    labels = np.where(block(3)[0][hexahedra].mean(axis=1)[:, 2] > 1, 7, -5)
    hmo.write(tmp_path / "in.mesh", hmo.Mesh(points, hexahedra, labels))
    write_surface(tmp_path / "cube.off", cube_surface(3))
    options = "--reference", tmp_path / "cube.off", "--max-deviation", 0.3
    program("optimize_hex_mesh", tmp_path / "in.mesh", tmp_path / "out.mesh", *options)
    mesh = hmo.read(tmp_path / "in.mesh")
    result, status = hmo.optimize(
        mesh.points,
        mesh.hexahedra,
        reference=hmo.read_surface(tmp_path / "cube.off"),
        labels=mesh.labels,
        max_deviation=0.3,
    )
    assert np.array_equal(result, hmo.read(tmp_path / "out.mesh").points)
    assert [region.label for region in status.regions] == [-5, 7]
    assert sum(region.after for region in status.regions) == pytest.approx(27, rel=0.01)
    assert [interface.labels for interface in status.interfaces] == [(-5, 7)]
    assert status.is_within_deviation_bound and status.deviation_bound == 0.3


def test_a_made_mesh_is_that_of_the_program(program: Program, tmp_path: Path) -> None:
    vertices, triangles = cube_surface(1)
    write_surface(tmp_path / "cube.off", (vertices, triangles))
    program("make_hex_mesh", tmp_path / "cube.off", tmp_path / "out.vtk", "--cells", 60)
    expected = hmo.read(tmp_path / "out.vtk")
    points, hexahedra, status = hmo.make(vertices, triangles, cells=60)
    assert np.array_equal(points, expected.points)
    assert np.array_equal(hexahedra, expected.hexahedra)
    assert status.valid_mesh and status.has_topology_of_surface and len(status.thin_faces) == 0
    assert status.spacing > 0


def test_the_input_is_not_changed_and_the_result_is_handed_over(tangled: Mesh) -> None:
    points, hexahedra = tangled
    before = points.copy(), hexahedra.copy()
    points.setflags(write=False)
    hexahedra.setflags(write=False)
    result, status = hmo.optimize(points, hexahedra)
    assert np.array_equal(points, before[0]) and np.array_equal(hexahedra, before[1])
    assert status.valid_mesh and status.before.number_of_invalid > 0
    assert result.dtype == np.float64 and result.flags.c_contiguous and result.flags.writeable
    assert not result.flags.owndata  # it is where the run has left it


INTEGERS = [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64]


def test_arrays_of_every_form_are_taken(tangled: Mesh) -> None:
    points, hexahedra = tangled
    expected = hmo.optimize(points, hexahedra)[0]
    cells = np.insert(hexahedra, 0, 8, axis=1)
    wide = np.zeros((2 * len(points), 6))
    wide[::2, ::2] = points
    forms: List[Any] = [hexahedra.astype(t) for t in INTEGERS]
    forms += [hexahedra.tolist(), np.asfortranarray(hexahedra), hexahedra.astype(">i4"), cells, cells.ravel()]
    for form in forms:
        assert np.array_equal(hmo.optimize(points, form)[0], expected)
        assert np.array_equal(hmo.quality(points, form), hmo.quality(points, hexahedra))
    for other in (points.tolist(), np.asfortranarray(points), points.astype(">f8"), wide[::2, ::2]):
        assert np.array_equal(hmo.optimize(other, hexahedra)[0], expected)


def test_the_number_of_threads_does_not_matter(tangled: Mesh) -> None:
    assert np.array_equal(hmo.optimize(*tangled)[0], hmo.optimize(*tangled, threads=3)[0])


def test_progress_sees_each_iteration_and_stops(tangled: Mesh) -> None:
    seen: List[hmo.Iteration] = []
    _, status = hmo.optimize(*tangled, progress=seen.append)
    assert seen == status.history and len(seen) == status.iterations > 0
    assert all(isinstance(i.stage, hmo.Stage) for i in seen)
    for no in (False, np.bool_(False)):
        _, status = hmo.optimize(*tangled, progress=lambda i: no)
        assert status.iterations == 1
        assert status.return_code == hmo.Return_code.STOPPED_BY_VISITOR


def test_an_error_of_progress_passes_through(tangled: Mesh) -> None:
    error = RuntimeError("mine")

    def fail(_: hmo.Iteration) -> None:
        raise error

    with pytest.raises(RuntimeError) as caught:
        hmo.optimize(*tangled, progress=fail)
    assert caught.value is error


def test_a_bar_leaves_no_trace(tangled: Mesh, capfd: pytest.CaptureFixture[str]) -> None:
    expected = hmo.optimize(*tangled)[0]
    assert np.array_equal(hmo.optimize(*tangled, progress=True)[0], expected)
    assert capfd.readouterr() == ("", "")  # no terminal


def test_a_plain_bar_is_written_on_a_terminal(tangled: Mesh, monkeypatch: pytest.MonkeyPatch) -> None:
    import io

    from hex_mesh_optimization import _progress

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    terminal = Terminal()
    monkeypatch.setattr(_progress, "_bar", lambda: _progress._Plain_bar(terminal))
    hmo.optimize(*tangled, progress=True)
    assert "inverted" in terminal.getvalue() and terminal.getvalue().endswith(" \r")


def test_verbose_writes_lines(tangled: Mesh, capfd: pytest.CaptureFixture[str]) -> None:
    status = hmo.optimize(*tangled, verbose=True)[1]
    assert len(capfd.readouterr().err.splitlines()) == status.iterations


# --- What the named parameters do -------------------------------------------------


def test_constrained_vertices_stay(tangled: Mesh) -> None:
    points, hexahedra = tangled
    chosen = np.flatnonzero(interior(block(3)[0]))[:2]
    mask = np.zeros(len(points), bool)
    mask[chosen] = True
    by_index = hmo.optimize(points, hexahedra, vertex_is_constrained_map=chosen)[0]
    by_mask = hmo.optimize(points, hexahedra, vertex_is_constrained_map=mask)[0]
    assert np.array_equal(by_index, by_mask)
    assert np.array_equal(by_index[chosen], points[chosen])


def test_a_fixed_boundary_stays(tangled: Mesh) -> None:
    points, hexahedra = tangled
    result, _ = hmo.optimize(points, hexahedra, fixed_boundary=True)
    outside = ~interior(block(3)[0])
    assert np.array_equal(result[outside], points[outside])


def test_methods_are_given_by_name_or_enumerator(tangled: Mesh) -> None:
    by_name = hmo.optimize(*tangled, optimization_method="rectification", edge_length_update="selective")[1]
    assert {i.stage for i in by_name.history} == {hmo.Stage.RECTIFICATION}
    by_enumerator = hmo.optimize(
        *tangled,
        optimization_method=hmo.Method.RECTIFICATION,
        edge_length_update=hmo.Edge_length_update.SELECTIVE,
    )[1]
    assert [i.energy for i in by_enumerator.history] == [i.energy for i in by_name.history]


def test_parameters_of_rectification_arrive(tangled: Mesh) -> None:
    def energies(**parameters: Any) -> List[float]:
        history = hmo.optimize(*tangled, optimization_method="rectification", **parameters)[1].history
        return [i.energy for i in history]

    usual = energies()
    given = dict(
        surface_weight=3.0, feature_weight=3.0, regularization_weight=0.1, cone_angle_bound=60, number_of_iterations=1
    )
    for name, value in given.items():
        assert energies(**{name: value}) != usual, name
    assert energies(number_of_restarts=0, edge_length_update="none", maximize_minimum_quality=False)


def test_limits_stop_the_run(tangled: Mesh) -> None:
    assert hmo.optimize(*tangled, maximum_running_time=0)[1].return_code == hmo.Return_code.TIME_LIMIT
    status = hmo.optimize(*tangled, target_quality=0.1)[1]
    assert status.return_code == hmo.Return_code.TARGET_QUALITY_REACHED and status.after.minimum >= 0.1


def test_vertices_stand_on_the_surface(tangled: Mesh) -> None:
    result, _ = hmo.optimize(*tangled, reference=cube_surface(3), boundary_placement="on_surface")
    outside = result[~interior(block(3)[0])]
    assert np.abs(np.minimum(np.abs(outside), np.abs(outside - 3)).min(axis=1)).max() < 1e-12


def test_internal_faces_stay_where_they_are() -> None:
    points, hexahedra = block(4)
    number = np.arange(125).reshape(5, 5, 5)
    middle = number[2]
    faces = [
        [middle[j, k], middle[j + 1, k], middle[j + 1, k + 1], middle[j, k + 1]] for j in range(4) for k in range(4)
    ]
    free = interior(points)
    points[free & (points[:, 0] != 2)] += np.random.default_rng(1).uniform(-0.7, 0.7, 3)
    result, status = hmo.optimize(points, hexahedra, internal_faces=faces)
    assert np.abs(result[middle.ravel(), 0] - 2).max() < 0.05
    assert [interface.number_of_faces for interface in status.interfaces] == [16]


def test_an_interface_is_brought_to_its_reference() -> None:
    points, hexahedra = block(4)
    labels = (points[hexahedra].mean(axis=1)[:, 0] > 2).astype(int)
    x = 2.3
    plane = np.array([[x, -1, -1], [x, 5, -1], [x, 5, 5], [x, -1, 5]]), [[0, 1, 2], [0, 2, 3]]
    result, _ = hmo.optimize(points, hexahedra, labels=labels, interface_references={(1, 0): plane},
                             reference=cube_surface(4))
    assert np.abs(result[points[:, 0] == 2, 0] - x).max() < 0.05


def test_periodic_vertices_move_together() -> None:
    points, hexahedra = shaken_block(3)
    low, high = (np.flatnonzero(points[:, 0] == x) for x in (0, 3))
    pairs = np.stack([low, high], axis=1)
    result, _ = hmo.optimize(points, hexahedra, periodic_vertices=(pairs, (3, 0, 0)))
    assert np.array_equal(result[low] + (3, 0, 0), result[high])
    each = hmo.optimize(points, hexahedra, periodic_vertices=(pairs, np.tile((3.0, 0, 0), (len(pairs), 1))))[0]
    assert np.array_equal(result, each)


def test_lengths_of_edges_are_asked_for() -> None:
    points, hexahedra = block(2)
    edges = {tuple(sorted((int(h[a]), int(h[b])))) for h in hexahedra for a in range(8) for b in range(a)
             if np.abs(points[h[a]] - points[h[b]]).sum() == 1}
    pairs = np.array(sorted(edges))
    lengths = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    assert hmo.optimize(points, hexahedra, target_edge_length_map=(pairs, lengths))[1].valid_mesh
    with pytest.raises(ValueError, match="target_edge_length_map: there is no length for the edge"):
        hmo.optimize(points, hexahedra, target_edge_length_map=(pairs[1:], lengths[1:]))
    with pytest.raises(hmo.Input_error, match="target_edge_length_map: .*not positive"):
        hmo.optimize(points, hexahedra, target_edge_length_map=(pairs, -lengths))


def test_feature_edges_are_given() -> None:
    points, hexahedra = shaken_block(2, 0.3)
    vertices, triangles = cube_surface(2)
    edges = np.array([[a, b] for a in range(8) for b in range(a) if np.abs(vertices[a] - vertices[b]).sum() == 2])
    given = hmo.optimize(points, hexahedra, reference=(vertices, triangles), edge_is_constrained_map=edges)
    assert given[1].valid_mesh
    corners = [v for v, p in enumerate(block(2)[0]) if set(p) <= {0.0, 2.0}]
    assert np.abs(given[0] - block(2)[0])[corners].max() < 1e-9  # where the edges that are given meet
    assert hmo.make(vertices, triangles, cells=30, edge_is_constrained_map=edges)[2].valid_mesh


def test_parts_of_a_surface_stay_apart_with_their_labels() -> None:
    vertices, triangles = cube_surface(2)
    both = np.vstack([vertices, vertices + [2, 0, 0]])
    triangles_of_both = np.vstack([triangles, triangles + len(vertices)])
    parts = np.repeat([-7, 3], len(triangles))
    points, hexahedra, status = hmo.make(both, triangles_of_both, grid_spacing=1.0, face_label_map=parts)
    assert status.valid_mesh and status.matches_surface
    assert sorted(status.labels.tolist()) == [-7] * 8 + [3] * 8
    assert [(p.label, p.number_of_hexahedra) for p in status.parts] == [(-7, 8), (3, 8)]
    assert [region.label for region in status.regions] == [-7, 3]
    centers = points[hexahedra].mean(axis=1)
    assert ((centers[:, 0] > 2) == (status.labels == 3)).all()
    with pytest.raises(ValueError, match="face_label_map: one integer for each"):
        hmo.make(vertices, triangles, face_label_map=[1, 2])


def test_making_obeys_its_parameters() -> None:
    surface = cube_surface(1)
    coarse = hmo.make(*surface, grid_spacing=0.5)[1]
    fine = hmo.make(*surface, number_of_hexahedra=200, minimum_cells_across=2, target_quality=0.2)[1]
    assert len(coarse) < len(fine)


# --- What is reported -------------------------------------------------------------


def test_a_status_is_shown_copied_and_pickled(tangled: Mesh) -> None:
    status = hmo.optimize(*tangled)[1]
    text = str(status)
    assert "minimum scaled Jacobian" in text and text.endswith("The mesh is valid.") and repr(status) == text
    assert "<table>" in status._repr_html_() and "minimum scaled Jacobian" in status._repr_html_()
    for other in (copy.deepcopy(status), pickle.loads(pickle.dumps(status))):
        assert other.as_dict() == status.as_dict() and other.history == status.history
        assert isinstance(other.return_code, hmo.Return_code)


def test_the_table_is_that_of_the_program(program: Program, tmp_path: Path, tangled: Mesh) -> None:
    import os
    import subprocess

    hmo.write(tmp_path / "in.vtk", tangled)
    command = os.path.join(os.environ["HEX_MESH_PROGRAMS"], "optimize_hex_mesh")
    files = [str(tmp_path / name) for name in ("in.vtk", "out.vtk")]
    words = subprocess.run([command, *files], check=True, capture_output=True, text=True).stdout.splitlines()
    own = str(hmo.optimize(*tangled)[1]).splitlines()
    untimed = [[line for line in lines if "seconds" not in line and " of " not in line[:5]] for lines in (words, own)]
    assert untimed[0][:10] == untimed[1][:10] and len(untimed[0]) > 10


def test_statistics_agree_with_the_status(tangled: Mesh) -> None:
    points, hexahedra = tangled
    result, status = hmo.optimize(points, hexahedra)
    assert hmo.statistics(points, hexahedra) == status.before
    assert hmo.statistics(result, hexahedra) == status.after
    assert hmo.quality(result, hexahedra).min() == status.after.minimum
    assert len(hmo.invalid(points, hexahedra)) == status.before.number_of_invalid
    assert len(status.invalid_hexahedra) == len(hmo.invalid(result, hexahedra)) == 0


def test_hexahedra_that_are_inside_out_are_told_of(tangled: Mesh) -> None:
    points, hexahedra = tangled
    expected = hmo.optimize(points, hexahedra)[0]
    mixed = hexahedra.copy()
    mixed[[3, 5]] = mixed[[3, 5]][:, [4, 5, 6, 7, 0, 1, 2, 3]]
    result, status = hmo.optimize(points, mixed)
    assert status.reoriented_hexahedra.tolist() == [3, 5] and status.number_of_reoriented_hexahedra == 2
    assert np.array_equal(hmo.reoriented(mixed, status), hexahedra)
    assert np.array_equal(result, expected)
