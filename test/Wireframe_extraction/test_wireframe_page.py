#!/usr/bin/env python3
"""Tests the page of extract_wireframe --html without a browser: what is in it, and what is said if there is none.

usage: test_wireframe_page.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import array
import base64
import json
import math
import os
import re
import sys
import unittest

from program_test import NO_FEATURE, USAGE_ERROR, Program_test, main

WITH_VIEWER = os.environ.get("EXTRACT_WIREFRAME_WITH_VIEWER") == "1"
NAME = "a <b>&amp; \"c\" <!-- <script>alert(1)<.ply"   # a slash is not possible in a name


def refuse_constant(name):
    raise ValueError(name + " in the page")


def data_of(page):
    """The data of a page, whose text must end where they end."""
    parts = re.findall(r'<script type="application/json" id="wireframe-data">(.*?)</script>', page, re.DOTALL)
    assert len(parts) == 1, "there must be one element with data"
    return json.loads(parts[0], parse_constant=refuse_constant)


def numbers(text, letter):
    values = array.array(letter, base64.b64decode(text, validate=True))
    if sys.byteorder == "big":
        values.byteswap()
    return values


def triples(values):
    return list(zip(values[0::3], values[1::3], values[2::3]))


class Page_test(Program_test):
    def make_cloud_of_test(self, name, *arguments):
        self.make_cloud(self.folder / "cloud.ply", *arguments)
        (self.folder / "cloud.ply").rename(self.folder / name)   # which need not end in .ply

    def page_of(self, *arguments):
        output = self.run_tool(*arguments, "--html", "page.html", "-o", "wireframe.json")
        self.assertIn("page.html", output)
        page = (self.folder / "page.html").read_text(encoding="utf-8")
        return page, data_of(page), json.loads((self.folder / "wireframe.json").read_text())


@unittest.skipUnless(WITH_VIEWER, "the tool was built without the viewer")
class Content_test(Page_test):
    def test_agrees_with_json(self):
        self.make_cloud_of_test(NAME, "slotted_plate", "--points", 8000, "--field", "exact", "--scale", 100)
        page, data, wireframe = self.page_of(NAME, "--unit", "cm", "--maximum-gap", 17)
        self.assertEqual((data["format"], data["version"]), ("wireframe page", 1))
        self.assertEqual((data["unit"], data["title"]), ("cm", NAME))
        self.assertEqual(data["number_of_points"], 8000)
        self.check_curves(data, wireframe)
        self.check_cloud(data, NAME)
        self.check_layers(data)
        self.check_run(data)
        self.check_self_contained(page)

    def place(self, data, point):
        return [c + data["size"] * x for c, x in zip(data["center"], point)]

    def check_curves(self, data, wireframe):
        self.assertEqual(data["sampling_distance"], wireframe["sampling_distance"])
        tolerance = 1e-6 * data["size"]   # of single precision
        vertices = [self.place(data, p) for p in triples(numbers(data["vertices"], "f"))]
        self.assertEqual(len(vertices), len(wireframe["vertices"]))
        for mine, other in zip(vertices, wireframe["vertices"]):
            self.assertLess(math.dist(mine, other), tolerance)
        points = [self.place(data, p) for p in triples(numbers(data["curve_points"], "f"))]
        self.assertEqual(len(data["curves"]), len(wireframe["curves"]))
        self.assertEqual(sum(curve["count"] for curve in data["curves"]), len(points))
        types = set()
        for index, (mine, other) in enumerate(zip(data["curves"], wireframe["curves"])):
            types.add(other["type"])
            self.assertEqual(mine["index"], index)
            for name in ("type", "closed", "source", "target", "rms", "max", "support", "doubts"):
                self.assertEqual(mine[name], other[name], name)
            self.assertEqual(mine.get("radii"), other.get("radii"))
            own = points[mine["first"]:mine["first"] + mine["count"]]
            self.assertLess(math.dist(own[0], other["control_points"][0]), tolerance)
            self.assertLess(math.dist(own[-1], other["control_points"][-1]), tolerance)
            length = sum(math.dist(a, b) for a, b in zip(own, own[1:]))
            self.assertLess(abs(length - mine["length"]), 0.01 * mine["length"])
            if other["type"] == "arc":
                for point in own:
                    self.assertLess(abs(math.dist(point, other["center"]) - other["radii"][0]), tolerance)
        self.assertEqual(types, {"line", "arc"})
        self.assertTrue(types <= set(data["type_colours"]))

    def check_cloud(self, data, name):
        content = (self.folder / name).read_bytes()
        begin = content.index(b"end_header\n") + len(b"end_header\n")
        values = array.array("f", content[begin:])
        if sys.byteorder == "big":
            values.byteswap()
        read = sorted(zip(values[0::4], values[1::4], values[2::4], values[3::4]))
        self.assertAlmostEqual(data["cloud"]["largest_value"], max(sample[3] for sample in read))
        samples = numbers(data["cloud"]["samples"], "H")
        self.assertEqual(len(samples), 4 * len(read))
        step, value_step = data["size"] / 65535, data["cloud"]["largest_value"] / 65535
        shown = [(*self.place(data, [samples[i + j] / 65535 - 0.5 for j in range(3)]), samples[i + 3] * value_step)
                 for i in range(0, len(samples), 4)]
        # the order is another one: each point of the page is looked for in a grid
        grid = {}
        cell = 10 * step
        for sample in read:
            grid.setdefault(tuple(int(x // cell) for x in sample[:3]), []).append(sample)
        for sample in shown[::10]:
            place = [int(x // cell) for x in sample[:3]]
            near = [other for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)
                    for other in grid.get((place[0] + i, place[1] + j, place[2] + k), [])]
            self.assertTrue(any(math.dist(sample[:3], other[:3]) < step and abs(sample[3] - other[3]) < value_step
                                for other in near), sample)

    def check_layers(self, data):
        layers = {layer["name"]: layer for layer in data["layers"]}
        self.assertEqual(list(layers), ["stage-" + name for name in
                                        ("skeleton", "feet", "corners", "clusters", "graph", "curves")])
        for layer in layers.values():
            positions = triples(numbers(layer["positions"], "f"))
            colours = base64.b64decode(layer["colours"])
            edges = numbers(layer["edges"], "I")
            self.assertGreater(len(positions), 0)
            self.assertEqual(len(colours), 3 * len(positions))
            self.assertEqual(2 * len(base64.b64decode(layer["edge_colours"])), 3 * len(edges))
            self.assertTrue(all(index < len(positions) for index in edges))
            # numbers that are not finite would fail here, too; single points may lie beside the cloud
            self.assertTrue(all(abs(x) < 0.7 for point in positions for x in point), layer["name"])
        skeleton = layers["stage-skeleton"]
        self.assertEqual(skeleton["count"], len(numbers(skeleton["positions"], "f")) // 3)
        self.assertGreater(len(numbers(layers["stage-graph"]["edges"], "I")), 0)

    def check_run(self, data):
        parameters = {parameter["name"]: parameter for parameter in data["parameters"]}
        for name, value, is_given in (("--maximum-gap", "17", True), ("--corner-reach", "5", False)):
            self.assertEqual((parameters[name]["value"], parameters[name]["is_given"]), (value, is_given))
        self.assertEqual(parameters["--noise-level"]["value"], "from the cloud")
        self.assertEqual(parameters["--corner-measure"]["value"], "field-residual")
        seconds = dict(data["seconds"])
        self.assertTrue({"reading", "skeleton", "graph"} <= set(seconds))
        self.assertTrue(all(value >= 0 for value in seconds.values()))
        self.assertEqual(dict(data["summary"])["Points"], "8000")

    def check_self_contained(self, page):
        self.assertNotIn("@WIREFRAME", page)
        self.assertIsNone(re.search(r"<(?:script|img|iframe)[^>]*\ssrc\s*=|<link\b|@import|\burl\(\s*['\"]?http", page))
        self.assertNotIn(NAME, page)   # it is only in the data, where it is escaped
        self.assertEqual(page.count("</script>"), 2)

    def test_parameters_of_paper(self):
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        _, data, _ = self.page_of("box.ply", "--paper")
        parameters = {parameter["name"]: parameter["value"] for parameter in data["parameters"]}
        self.assertEqual((parameters["--graph-method"], parameters["--recognize-types"]), ("subdivided", "false"))

    def test_far_and_large(self):
        """Far from the origin no digits are lost, and invalid points are left out."""
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        content = (self.folder / "box.ply").read_bytes()
        begin = content.index(b"end_header\n") + len(b"end_header\n")
        values = array.array("f", content[begin:])
        if sys.byteorder == "big":
            values.byteswap()
        with (self.folder / "far.xyz").open("w") as file:
            file.write("nan 0 0 0\n0 0 0 -1\n")
            for i in range(0, len(values), 4):
                file.write(" ".join(repr(x) for x in [*(1e6 + x for x in values[i:i + 3]), values[i + 3]]) + "\n")
        _, data, wireframe = self.page_of("far.xyz", "--skip-invalid")
        self.assertEqual(data["number_of_points"], 4000)
        self.check_curves_are_near(data, wireframe)

    def check_curves_are_near(self, data, wireframe):
        for mine, other in zip(triples(numbers(data["vertices"], "f")), wireframe["vertices"]):
            self.assertLess(math.dist(self.place(data, mine), other), 1e-6)

    def test_without_output(self):
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        self.run_tool("box.ply", "--html", "page.html", "--quiet")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["box.ply", "page.html"])

    def test_failures(self):
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        (self.folder / "folder.html").mkdir()
        for arguments, words in (
                (("--html", ""), "name of the page is empty"),
                (("--html", "page.txt"), "page.txt: a page is written into .html"),
                (("--html", "missing/page.html"), "make it first"),
                (("--html", "folder.html"), "is a directory"),
                (("--html", "box.ply"), "is the same file"),
                (("--html", "a.json", "-o", "a.json"), "is the same file")):
            error = self.run_tool("box.ply", *arguments, code=USAGE_ERROR)
            self.assertIn(words, error)
            self.assertEqual(error.count("\n"), 1, error)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["box.ply", "folder.html"])

    def test_nothing_is_written_on_failure(self):
        rows = [f"{x} {y} {x * y / 50} {9 + x}\n" for x in range(20) for y in range(20)]
        (self.folder / "smooth.xyz").write_text("".join(rows))
        (self.folder / "page.html").write_text("old")
        self.run_tool("smooth.xyz", "--html", "page.html", code=NO_FEATURE)
        self.assertEqual((self.folder / "page.html").read_text(), "old")


class Command_line_test(Page_test):
    def test_page_is_no_format(self):
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        self.assertIn("--html OUT.html", self.run_tool("box.ply", "-o", "page.html", code=USAGE_ERROR))
        self.assertIn("--output (or --html", self.run_tool("box.ply", code=USAGE_ERROR))

    @unittest.skipIf(WITH_VIEWER, "the tool was built with the viewer")
    def test_without_viewer(self):
        self.make_cloud_of_test("box.ply", "box", "--points", 4000, "--field", "exact")
        error = self.run_tool("box.ply", "--html", "page.html", code=USAGE_ERROR)
        self.assertIn("libjs-three esbuild", error)
        self.assertEqual(error.count("\n"), 1)
        self.assertFalse((self.folder / "page.html").exists())


if __name__ == "__main__":
    main("tool", "cloud_maker")
