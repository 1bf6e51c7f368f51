#!/usr/bin/env python3
# Copyright (c) 2026 The Hex_mesh_optimization authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of --report in a browser: test_report.py FOLDER_OF_PROGRAMS"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By

from browser import opened, set_size

programs = pathlib.Path(sys.argv.pop()).resolve()
BOX = "OFF\n8 6 0\n" + "".join(f"{line}\n" for line in (
    "0 0 0", "1.1 0 0", "1.1 1 0", "0 1 0", "0 0 1", "1.1 0 1", "1.1 1 1", "0 1 1",
    "4 0 3 2 1", "4 4 5 6 7", "4 0 1 5 4", "4 1 2 6 5", "4 2 3 7 6", "4 3 0 4 7"))


def run(program, *arguments):
    return subprocess.run([programs / program, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode


def at(report, path):
    for key in path.split("."):
        report = report[int(key)] if isinstance(report, list) else report[key]
    return report


def shown_number(text, form):
    """The number that a text shows, and half a unit of its last digit."""
    word = text.replace("\u2212", "-").replace(",", "").split()[0]
    mantissa, _, exponent = word.partition("e")
    decimals = len(mantissa.partition(".")[2])
    scale = 10.0 ** int(exponent or 0) / (100 if form == "percent" else 1)
    return float(mantissa) * scale, .5000001 * 10.0 ** -decimals * scale


class Page:
    """What holds for each page; a test case makes one, and the JSON of the same run."""

    compares = False

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.page, cls.json = cls.folder / "page.html", cls.folder / "report.json"
        cls.make()
        cls.report = json.loads(cls.json.read_text())
        cls.browser = opened(cls.page, width=900, height=600)
        cls.driver = cls.browser.__enter__()
        cls.addClassCleanup(cls.browser.__exit__, None, None, None)
        cls.first_cut = cls.driver.execute_script("return [viewer.cut.axis, document.getElementById('cut-axis').value]")

    def setUp(self):
        for id, value in (("coloring", "quality"), ("cut-axis", "1"), ("cut-position", "0.5"), ("worst", False)):
            self.choose(id, value)
        self.driver.execute_script("document.getElementById('view').scrollIntoView()")

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def picture(self):
        # what has changed is drawn in the next frame
        self.driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
        return self.all("#canvas")[0].screenshot_as_png

    def choose(self, id, value):
        self.driver.execute_script(
            "const e = document.getElementById(arguments[0]);"
            "if (e.type === 'checkbox') e.checked = arguments[1]; else e.value = arguments[1];"
            "e.dispatchEvent(new Event('input', {bubbles: true}))", id, value)

    def colors(self):
        """How often each color is in the view."""
        self.picture()
        return self.driver.execute_script("""
            const canvas = document.getElementById("canvas"), copy = document.createElement("canvas");
            copy.width = canvas.width; copy.height = canvas.height;
            copy.getContext("2d").drawImage(canvas, 0, 0);
            const counts = {}, pixels = new Uint32Array(copy.getContext("2d").getImageData(0, 0, copy.width, copy.height).data.buffer);
            for (const p of pixels) counts[p] = (counts[p] || 0) + 1;
            return counts;""")

    def test_no_error_is_in_the_console_and_nothing_is_loaded(self):
        self.assertEqual([entry for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")], [])
        self.assertEqual(self.driver.execute_script("return performance.getEntriesByType('resource').map(r => r.name)"), [])

    def test_the_report_in_the_page_is_that_of_the_json(self):
        of_page = json.loads(self.driver.execute_script("return document.getElementById('data').textContent"))["report"]
        self.assertEqual(of_page, self.report)

    def test_the_numbers_are_those_of_the_json(self):
        wanted = {f"status.{side}.{member}" for side in ("before", "after")
                  for member in ("number_of_hexahedra", "number_of_inverted", "number_of_invalid", "minimum", "average")}
        wanted |= {"status.deviation.maximum", "status.deviation.maximum_relative", "status.total_seconds"}
        if self.compares:
            wanted |= {"comparison.after.minimum", "comparison.after.number_of_invalid", "comparison.deviation.maximum"}
        for cell in self.all("[data-path]"):
            path, text = cell.get_attribute("data-path"), cell.text
            wanted.discard(path)
            value = at(self.report, path)
            if value is None:
                self.assertEqual(text, "–", path)
                continue
            number, tolerance = shown_number(text, cell.get_attribute("data-format"))
            self.assertAlmostEqual(number, value, delta=tolerance, msg=path)
        self.assertEqual(wanted, set())

    def test_the_histograms_count_every_hexahedron(self):
        paths = {path.get_attribute("data-role"): path for path in self.all("#histogram path")}
        members = {"before": "status.before", "after": "status.after", "compared": "comparison.after"}
        self.assertEqual(set(paths), {"before", "after"} | ({"compared"} if self.compares else set()))
        for role, path in paths.items():
            counts = [int(count) for count in path.get_attribute("data-counts").split()]
            self.assertEqual(sum(counts), at(self.report, members[role])["number_of_hexahedra"])

    def test_the_meshes_are_those_of_the_report(self):
        members = {"before": "status.before", "after": "status.after", "compared": "comparison.after"}
        meshes = self.driver.execute_script(
            "return meshes.map(m => [m.role, m.size, Math.min(...m.jacobians), m.isInvalid.reduce((a, b) => a + b, 0)])")
        self.assertEqual(len(meshes), 3 if self.compares else 2)
        for role, size, minimum, invalid in meshes:
            statistics = at(self.report, members[role])
            self.assertEqual(size, statistics["number_of_hexahedra"])
            self.assertEqual(invalid, statistics["number_of_invalid"])
            self.assertAlmostEqual(minimum, statistics["minimum"], delta=1e-6)

    def test_the_lists_are_complete(self):
        counts = {text.partition(":")[0]: int(count) for text, count in self.driver.execute_script(
            "return Array.from(document.querySelectorAll('#places details'), d => [d.textContent, d.dataset.count])")}
        status = self.report["status"]
        for title, member in (("Invalid hexahedra", "invalid_hexahedra"),
                              ("Vertices off the reference, not on the corner, curve or face that they belong to", "vertices_off_reference"),
                              ("Hexahedra that the connectivity limits", "connectivity_limits"),
                              ("Faces of the surface that are thin for the spacing", "thin_faces")):
            self.assertEqual(counts.get(title, 0), len(status.get(member, [])))

    def test_the_view_is_drawn_and_turns(self):
        self.assertGreater(len(self.colors()), 20)
        before = self.picture()
        self.assertEqual(before, self.picture())  # what differs is not by chance
        canvas = self.all("#canvas")[0]
        ActionChains(self.driver).move_to_element(canvas).click_and_hold().move_by_offset(120, 40).release().perform()
        turned = self.picture()
        self.assertNotEqual(before, turned)
        ActionChains(self.driver).send_keys_to_element(canvas, "\ue012").perform()  # the left arrow
        self.assertNotEqual(turned, self.picture())

    def test_the_page_opens_with_all_of_the_mesh(self):
        self.assertEqual(self.first_cut, [-1, "-1"])

    def test_the_cut_takes_hexahedra_away(self):
        background = lambda: max(self.colors().values())
        self.choose("cut-axis", "-1")
        whole = background()
        self.choose("cut-axis", "0")
        self.choose("cut-position", "0.9")
        self.assertGreater(background(), whole)

    def test_only_the_worst_are_shown(self):
        before = self.picture()
        self.choose("threshold", "0.5")
        text = self.all("#threshold-value")[0].text
        numbers = [int(number.replace(",", "")) for number in text.partition(":")[2].split(" / ")]
        wanted = self.driver.execute_script("""return meshes.map(m =>
            Array.from(m.centers.keys()).filter(i => i < m.size && m.centers[3 * i + 1] >= viewer.cutCoordinate() &&
              (m.isInvalid[i] || m.jacobians[i] <= .5)).length)""")
        self.assertEqual(numbers, wanted)
        self.assertNotEqual(before, self.picture())

    def test_every_coloring_is_another_picture(self):
        pictures = set()
        for option in self.all("#coloring option"):
            self.choose("coloring", option.get_attribute("value"))
            pictures.add(self.picture())
        self.assertEqual(len(pictures), len(self.all("#coloring option")))
        self.choose("coloring", "deviation")
        self.assertIn(self.all("#view-names span")[-1].text, ("Boundary before", "Reference", "Surface"))  # with its own distances

    def test_a_click_in_a_list_flies_there(self):
        before = self.picture()
        button = self.all("#places details[open] tbody button")[0]
        button.click()
        self.assertIn(f"hexahedron {button.text}:", self.all("#picked")[0].text)
        self.assertNotEqual(before, self.picture())
        self.all("#whole")[0].click()
        self.assertEqual(self.all("#picked")[0].text, "")

    def test_nothing_is_wider_than_the_window(self):
        for width in (390, 1200):
            set_size(self.driver, width, 900)
            self.picture()
            self.assertEqual(self.driver.execute_script("return [innerWidth, document.documentElement.scrollWidth]"), [width, width])


class Stopped(Page, unittest.TestCase):
    """A run that ended at once, before the boundary came to the reference: there are places of most kinds."""

    @classmethod
    def make(cls):
        # a name with what would keep the data from ending
        tangled, reference = cls.folder / "tangled <!--<script> & '.mesh", cls.folder / "reference.off"
        run("generate_hex_mesh", "block", tangled, "--refine", "3", "--corrupt", "scramble", "--seed", "1")
        reference.write_text(BOX)
        run("optimize_hex_mesh", tangled, cls.folder / "out.mesh", "--reference", reference, "--on-surface", "--time-limit", "0", "--quiet",
            "--json", cls.json, "--report", cls.page)

    def test_there_are_places(self):
        for member in ("invalid_hexahedra", "vertices_off_reference"):
            self.assertGreater(len(self.report["status"][member]), 0)

    def test_a_released_vertex_is_shown(self):
        vertex = self.report["status"]["vertices_off_reference"][0]
        before = self.picture()
        details = next(d for d in self.all("#places details") if d.text.startswith("Vertices off"))
        details.find_element(By.TAG_NAME, "summary").click()
        details.find_element(By.CSS_SELECTOR, "tbody button").click()
        self.assertTrue(self.all("#picked")[0].text.startswith(f"Vertex {vertex},"))
        self.assertNotEqual(before, self.picture())
        self.all("#whole")[0].click()

    def test_a_page_that_cannot_be_written_is_refused_before_all_work(self):
        mesh, output = next(self.folder.glob("tangled*")), self.folder / "refused.mesh"
        self.assertEqual(run("optimize_hex_mesh", mesh, output, "--report", self.folder / "missing" / "page.html"), 3)
        self.assertEqual(run("optimize_hex_mesh", mesh, output, "--compare", mesh), 2)  # on no page
        self.assertFalse(output.exists())

    def test_the_command_repeats_the_run(self):
        self.json.unlink()
        subprocess.run([f"{programs}/{self.all('#command')[0].text}"], shell=True)
        self.assertEqual(json.loads(self.json.read_text())["status"]["after"], self.report["status"]["after"])


class Made(Page, unittest.TestCase):
    @classmethod
    def make(cls):
        (cls.folder / "box.off").write_text(BOX)
        run("make_hex_mesh", cls.folder / "box.off", cls.folder / "out.mesh", "--spacing", ".25", "--min-cells-across", "9", "--quiet",
            "--json", cls.json, "--report", cls.page)

    def test_some_faces_are_thin(self):
        self.assertGreater(len(self.report["status"]["thin_faces"]), 0)


class Compared(Page, unittest.TestCase):
    compares = True

    @classmethod
    def make(cls):
        tangled, pages = cls.folder / "in.vtk", cls.folder / "pages"
        run("generate_hex_mesh", "ball", tangled, "--refine", "1", "--corrupt", "scramble", "--seed", "2")
        ours = f"{programs / 'optimize_hex_mesh'} {{in}} {{out}} --quiet"
        compare = pathlib.Path(__file__).parents[3] / "benchmark" / "Hex_mesh_optimization" / "compare.py"
        subprocess.run([sys.executable, "-B", compare, "--ours", f"{ours} --json {cls.json}", "--other", f"{ours} --method rectification",
                        "--output-extension", ".vtk", "--pages", pages, tangled], stdout=subprocess.DEVNULL, check=True)
        (pages / "in.html").rename(cls.page)

    def test_the_other_result_is_measured_as_ours_is(self):
        ours, again = self.folder / "pages" / "in.ours.vtk", self.folder / "again.json"
        run("optimize_hex_mesh", self.folder / "in.vtk", self.folder / "again.vtk", "--quiet", "--json", again, "--report", self.folder / "again.html",
            "--compare", ours)
        report = json.loads(again.read_text())
        self.assertGreater(report["status"]["deviation"]["maximum"], 0)
        for member in ("average", "maximum", "average_relative", "maximum_relative"):
            # a boundary that stays where it is differs by rounding only, which files have their own of
            self.assertAlmostEqual(report["comparison"]["deviation"][member], report["status"]["deviation"][member],
                                   delta=1e-3 * report["status"]["deviation"][member] + 1e-12, msg=member)
        self.assertEqual(report["comparison"]["after"]["number_of_invalid"], report["status"]["after"]["number_of_invalid"])


if __name__ == "__main__":
    unittest.main()
