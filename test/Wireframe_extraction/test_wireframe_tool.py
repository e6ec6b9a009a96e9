#!/usr/bin/env python3
"""Tests the command line tool extract_wireframe from the outside.

usage: test_wireframe_tool.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import csv
import json
import math
import os
import pathlib
import random
import re
import shutil
import stat
import struct
import subprocess
import sys
import time
import unittest
import unittest.mock

from program_test import (BAD_INPUT, INTERNAL_ERROR, NO_FEATURE, SUCCESS, TIME_LIMIT, USAGE_ERROR, Program_test, main,
                          read_cloud, without_provenance)

HERE = pathlib.Path(__file__).resolve().parent
WITH_CAD = os.environ.get("EXTRACT_WIREFRAME_WITH_CAD") == "1"   # whether the tool is built with OpenCASCADE
STAGES = ["1_skeleton.ply", "2_feet.ply", "3_corners.ply", "4_clusters.ply", "5_graph.ply", "6_curves.ply"]
# options that are refused without another one, and with what they are not
HELPERS = {"--view": ["--png", "x.png"], "--fuse": ["--patches"], "--use-indices": ["--patches"],
           "--indices-dataset": ["--patches"], "--unit": ["-o", "x.svg"], "--step-schema": ["-o", "x.step"],
           "--obj-splines": ["-o", "x.obj"], "--dxf-splines": ["-o", "x.dxf"], "--dimensions": ["-o", "x.svg"],
           "--sampling-step": ["-o", "x.ply"], "--chord-tolerance": ["-o", "x.ply"], "--corner-variance": ["--corner-measure", "variance"],
           "--corner-radius": ["--paper"], "--corner-sampling-ratio": ["--corner-measure=variance"],
           "--end-detection": ["--paper"], "--split-threshold": ["--graph-method", "subdivided"],
           "--keep-failed": ["--batch", "list.txt"]}


def read_ply(path):
    """The elements of a binary PLY file without lists: name -> list of dictionaries."""
    letters = {"double": "d", "float": "f", "uchar": "B", "int": "i"}
    data = pathlib.Path(path).read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    elements = []
    for line in data[:end].decode().split("\n"):
        words = line.split()
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[2], letters[words[1]]))
    result = {}
    for name, count, properties in elements:
        layout = struct.Struct("<" + "".join(letter for _, letter in properties))
        names = [name_of_property for name_of_property, _ in properties]
        rows = layout.iter_unpack(data[end:end + count * layout.size])
        result[name] = [dict(zip(names, row)) for row in rows]
        end += count * layout.size
    assert end == len(data), f"{path}: the header promises {end} bytes, there are {len(data)}"
    return result


def write_cloud(path, cloud):
    pathlib.Path(path).write_text("".join(" ".join(repr(x) for x in row) + "\n" for row in cloud))


def sampled(path):
    """The points of a file of CGAL's polyline text, line by line."""
    result = []
    for line in pathlib.Path(path).read_text().splitlines():
        numbers = [float(word) for word in line.split()[1:]]
        assert len(numbers) == 3 * int(line.split()[0])
        result.append([tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)])
    return result


def farthest(points, others):
    """The largest distance of one of the points to the nearest one of the others."""
    return max(min(math.dist(p, q) for q in others) for p in points)


class Tool_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_cloud("box.ply", "box", "--points", 5000)
        cls.make_cloud("cylinder.ply", "cylinder", "--points", 5000)
        cls.make_cloud("noisy.ply", "box_with_hole", "--points", 8000, "--field", "def")
        cls.box = read_cloud(cls.shared / "box.ply")

    def extract(self, *arguments):
        """Runs the tool, which has to succeed; returns what it said."""
        done = self.execute(self.folder, *arguments)
        self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""), done.args)
        return done.stdout

    def files(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def refuse(self, exit_code, words, *arguments):
        """Runs the tool, which has to fail in one line with these words, and to leave every file as it is."""
        names = self.files()
        before = {name: (self.folder / name).read_bytes() for name in names if (self.folder / name).is_file()}
        done = self.execute(self.folder, *arguments)
        self.assertEqual(done.returncode, exit_code, (done.args, done.stderr))
        self.assertRegex(done.stderr, r"\Aextract_wireframe: error: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word.lower(), done.stderr.lower())
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.files(), names)
        for name, content in before.items():
            self.assertEqual((self.folder / name).read_bytes(), content)
        return done.stderr

    def refuse_text(self, exit_code, words, text, name="cloud.xyz", *arguments):
        """The same for a cloud of this text."""
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return self.refuse(exit_code, [name] + words, name, "-o", "out.json", *arguments)

    def read_text(self, name):
        text = (self.folder / name).read_text()
        return without_provenance(text) if name.endswith(".json") else text

    def read_json(self, name):
        def refuse_constant(text):
            raise AssertionError(f"{text} in {name}")
        return json.loads(self.read_text(name), parse_constant=refuse_constant)

    def check_wireframe(self, wireframe):
        self.assertEqual((wireframe["format"], wireframe["version"]), ("wireframe", 2))
        self.assertGreater(len(wireframe["curves"]), 0)
        for curve in wireframe["curves"]:
            self.assertEqual(len(curve["knots"]), len(curve["control_points"]) + curve["degree"] + 1)
            for end, index in (("source", 0), ("target", -1)):
                if curve[end] is not None:
                    self.assertEqual(wireframe["vertices"][curve[end]], curve["control_points"][index])

    # ---- what works ----

    def test_box(self):
        said = self.extract(self.shared / "box.ply", "-o", "out.json")
        wireframe = self.read_json("out.json")
        self.check_wireframe(wireframe)
        self.assertEqual(len(wireframe["curves"]), 12)
        self.assertEqual(len(wireframe["vertices"]), 8)
        self.assertAlmostEqual(wireframe["sampling_distance"] / 0.03116, 1, delta=0.1)
        for row in (r"Points +5000\n", r"r +0\.0\d+ \(estimated\)\n", r"Noise +\S+ = \S+ r\n",
                    r"Skeleton +\d+ points\n", r"Corners +8\n", r"Curves +12 lines\n", r"Doubtful +0 of 12 curves\n\Z",
                    r"Residuals +rms \S+ = \S+ r, largest \S+ = \S+ r\n", r"Seconds +\d.*reading.*writing",
                    r"Written +out\.json\n"):
            self.assertRegex(said, row)
        self.assertNotIn("Warning", said)
        self.assertEqual(self.files(), ["out.json"])

    def test_cylinder(self):
        said = self.extract(self.shared / "cylinder.ply", "-o", "out.json")
        self.assertRegex(said, r"Curves +2 circles\n")
        wireframe = self.read_json("out.json")
        self.check_wireframe(wireframe)
        self.assertEqual([curve["closed"] for curve in wireframe["curves"]], [True, True])

    def test_formats(self):
        names = ["a.json", "a.obj", "a.ply", "a.polylines.txt", "b.txt", "a.cgal", "A.OBJ"]
        said = self.extract(self.shared / "box.ply", *sum((["-o", name] for name in names), []))
        self.assertEqual(self.files(), sorted(names))
        for name in names:
            self.assertIn(name, said)
        self.check_wireframe(self.read_json("a.json"))
        obj = (self.folder / "a.obj").read_text()
        self.assertRegex(obj, r"(?m)^v ")
        self.assertRegex(obj, r"(?m)^l ")
        self.assertEqual((self.folder / "A.OBJ").read_text(), obj)
        ply = read_ply(self.folder / "a.ply")
        self.assertGreater(len(ply["vertex"]), 8)
        self.assertEqual(len({edge["curve"] for edge in ply["edge"]}), 12)
        self.assertEqual(len(sampled(self.folder / "a.polylines.txt")), 12)
        for name in ("b.txt", "a.cgal"):
            self.assertEqual(sampled(self.folder / name), sampled(self.folder / "a.polylines.txt"))

    @staticmethod
    def quiet_about_leaks():
        """What OpenCASCADE never frees is not ours."""
        return unittest.mock.patch.dict(os.environ, ASAN_OPTIONS="detect_leaks=0")

    @unittest.skipUnless(WITH_CAD, "built without OpenCASCADE")
    def test_cad_formats(self):
        names = ["a.step", "a.stp", "a.iges", "a.igs", "a.brep", "A.STEP"]
        outputs = sum((["-o", name] for name in names), [])
        with self.quiet_about_leaks():
            self.assertEqual(self.extract(self.shared / "box.ply", *outputs, "--quiet"), "")
        self.assertEqual(self.files(), sorted(names))
        step, iges, brep = (self.read_text(name) for name in ("a.step", "a.iges", "a.brep"))
        self.assertIn("AUTOMOTIVE_DESIGN", step)
        self.assertIn("LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.)", step)
        self.assertEqual((step.count("= LINE("), step.count("B_SPLINE_CURVE")), (12, 0))
        self.assertIn("2HMM", iges)
        self.assertEqual(len(re.findall(r"(?m)^     110 .*D *\d*[13579]$", iges)), 12)
        self.assertRegex(brep, r"(?m)^Curves 12$")
        self.assertEqual((self.read_text("a.stp"), self.read_text("A.STEP")), (step, step))
        self.assertEqual(self.read_text("a.igs"), iges)
        with self.quiet_about_leaks():
            said = self.extract(self.shared / "box.ply", "-o", "b.stp", "-o", "b.igs", "-o", "b.json", "--unit", "in",
                                "--step-schema", "ap242")
        self.assertIn("b.stp", said)
        inches = self.read_text("b.stp")
        self.assertIn("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING", inches)
        self.assertIn("CONVERSION_BASED_UNIT('INCH'", inches)
        self.assertIn("4HINCH", self.read_text("b.igs"))
        for text in (step, inches):   # nothing is converted
            points = re.findall(r"CARTESIAN_POINT\([^,()]*,\(([^,()]+),([^,()]+),([^,()]+)\)\)",
                                re.sub(r"\s+", "", text))
            found = {tuple(map(float, point)) for point in points}
            for vertex in self.read_json("b.json")["vertices"]:
                self.assertLess(min(math.dist(vertex, point) for point in found), 1e-12)

    @unittest.skipUnless(WITH_CAD, "built without OpenCASCADE")
    def test_curve_types_in_step(self):
        expected = {"slotted_plate": {"LINE": 16, "CIRCLE": 4}, "flange": {"CIRCLE": 16},
                    "elliptic_cut": {"CIRCLE": 1, "ELLIPSE": 1}}
        for shape, counts in expected.items():
            with self.subTest(shape), self.quiet_about_leaks():
                cloud = self.folder / (shape + ".ply")
                self.make_cloud(cloud, shape, "--points", 20000)
                self.extract(cloud, "-o", "typed.step", "-o", "typed.json")
                step = self.read_text("typed.step")
                for kind in ("LINE", "CIRCLE", "ELLIPSE", "B_SPLINE_CURVE_WITH_KNOTS"):
                    self.assertEqual(step.count(f"= {kind}("), counts.get(kind, 0), kind)
                self.extract(cloud, "-o", "splines.json", "--splines-only")
                curves = self.read_json("splines.json")["curves"]
                self.assertEqual({curve["type"] for curve in curves}, {"bspline"})

    def test_shared_features(self):
        """The flange has six holes of one diameter on a circle, rims on one axis, and each hole has two rims."""
        self.make_cloud(self.folder / "flange.ply", "flange", "--points", 20000)
        self.extract("flange.ply", "--regularize", "--shared-features", "shared.csv", "--quiet")
        with open(self.folder / "shared.csv", newline="") as file:
            rows = list(csv.DictReader(file))

        def numbers(row, *names):
            return [float(row[name]) for name in names]
        equal = [row for row in rows if row["kind"] == "equal_diameter"]
        self.assertEqual(sorted(int(row["count"]) for row in equal), [2, 2, 12])
        holes = max(equal, key=lambda row: int(row["count"]))
        self.assertAlmostEqual(float(holes["diameter"]), 0.24, delta=2e-3)
        coaxial = [row for row in rows if row["kind"] == "coaxial"]
        self.assertEqual(sorted(int(row["count"]) for row in coaxial), [2] * 6 + [4])
        bolts = [row for row in rows if row["kind"] == "bolt_circle"]
        self.assertEqual([int(row["count"]) for row in bolts], [6, 6])
        for row in bolts:
            self.assertAlmostEqual(float(row["diameter"]), 1.36, delta=5e-3)
            self.assertLess(max(map(abs, numbers(row, "center_x", "center_y"))), 3e-3)
            self.assertAlmostEqual(abs(float(row["axis_z"])), 1, delta=1e-4)
            self.assertLess(float(row["deviation"]), 3e-3)
            self.assertLessEqual(set(row["curves"].split()), set(holes["curves"].split()))
        self.extract(self.shared / "box.ply", "--shared-features", "none.csv", "--quiet")   # which has no circle
        self.assertEqual((self.folder / "none.csv").read_bytes().count(b"\n"), 1)
        self.refuse(USAGE_ERROR, ["--shared-features OUT.csv"], self.shared / "box.ply", "--shared-features", "a.json")

    def test_regularize(self):
        cloud = self.folder / "flange.ply"
        self.make_cloud(cloud, "flange", "--points", 20000)
        said = {}
        for name, more in (("plain.json", []), ("regular.json", ["--regularize"])):
            said[name] = self.extract(cloud, "-o", name, *more)
            radii = sorted(curve["radii"][0] for curve in self.read_json(name)["curves"])
            self.assertEqual(len(radii), 16)
            holes = radii[:12]
            self.assertLess(abs(holes[0] - 0.12), 1e-3)
            self.assertEqual(holes[-1] - holes[0] < 1e-9, bool(more))
        self.assertNotIn("Regular ", said["plain.json"])
        for kind in ("equal radii", "coaxial", "parallel"):
            self.assertRegex(said["regular.json"], rf"(?m)^Regular +{kind}: curves \d+, \d+")

    @unittest.skipUnless(WITH_CAD and os.path.exists("/dev/full"), "built without OpenCASCADE")
    def test_cad_formats_on_a_full_disk(self):
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        (self.folder / "old.obj").write_text("old")
        os.symlink("/dev/full", self.folder / "full.json")
        os.symlink("/dev/full", self.folder / "full.step")
        with self.quiet_about_leaks():
            self.assert_full(["old.obj", "new.step", "new.igs", "new.brep", "full.json"])
            self.assert_full(["new.brep", "full.step", "old.obj"], "full.step")

    @unittest.skipIf(WITH_CAD, "built with OpenCASCADE")
    def test_without_cad_formats(self):
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        for name in ("part.step", "part.stp", "part.iges", "part.igs", "part.brep", "PART.STEP"):
            self.refuse(USAGE_ERROR, [name, "without OpenCASCADE", "libocct-data-exchange-dev"],
                        "box.ply", "-o", "out.json", "-o", name)

    def test_formats_of_other_programs(self):
        names = ["a.dxf", "a.vtp", "a.gltf", "a.glb", "a.svg", "a.csv", "a.obj"]
        self.extract(self.shared / "box.ply", *sum((["-o", name] for name in names), []), "--unit", "in",
                     "--obj-splines")
        self.assertEqual(self.files(), sorted(names))
        content = {name: (self.folder / name).read_bytes() for name in names}
        dxf = content["a.dxf"].decode().split("\n")
        self.assertEqual((dxf.count("LINE"), dxf.count("SPLINE")), (12, 0))
        self.assertEqual(dxf[dxf.index("$INSUNITS") + 2], "1")
        self.assertIn(b'NumberOfLines="12"', content["a.vtp"])
        gltf = json.loads(content["a.gltf"])
        self.assertEqual((gltf["nodes"][0]["scale"], len(gltf["nodes"])), ([0.0254] * 3, 14))
        self.assertEqual(content["a.glb"][:4], b"glTF")
        self.assertEqual(content["a.svg"].count(b"<line "), 48)
        self.assertRegex(content["a.svg"], rb"Size .* in, third-angle projection, scale ")
        self.assertEqual(content["a.csv"].count(b"\r\n"), 13)
        self.assertEqual(content["a.obj"].count(b"\nl "), 12)   # a line needs no spline

    def test_sampling(self):
        for arguments, least, most in (([], 20, 200), (["--sampling-step", "0.5"], 3, 5), (["--chord-tolerance", "1e-4"], 2, 2),
                                       (["--chord-tolerance", "1e-4", "--sampling-step", "0.5"], 3, 5)):
            self.extract(self.shared / "box.ply", "-o", "a.txt", *arguments)
            for line in sampled(self.folder / "a.txt"):
                self.assertTrue(least <= len(line) <= most, (arguments, len(line)))
        self.refuse(USAGE_ERROR, ["--chord-tolerance", "sampled curves"], self.shared / "box.ply", "-o", "x.json",
                    "--chord-tolerance", "1")

    def test_outputs_are_replaced(self):
        (self.folder / "out.json").write_text("old")
        self.extract(self.shared / "box.ply", "--output", "out.json")
        self.check_wireframe(self.read_json("out.json"))

    def test_quiet(self):
        self.assertEqual(self.extract(self.shared / "box.ply", "-o", "out.json", "--quiet"), "")
        self.assertEqual(self.files(), ["out.json"])

    def test_log_of_ceres(self):
        """Equations that cannot be solved, of which these random points have seven, are no message to the user."""
        numbers = random.Random(5)
        write_cloud(self.folder / "c.xyz", [[numbers.random() for _ in range(3)] + [0.05 * numbers.random()]
                                            for _ in range(3000)])
        self.extract("c.xyz", "-o", "out.json", "--quiet")   # which says nothing

    def test_paper(self):
        self.extract(self.shared / "box.ply", "-o", "default.json")
        self.extract(self.shared / "box.ply", "-o", "paper.json", "--paper")
        self.check_wireframe(self.read_json("paper.json"))
        self.assertNotEqual(self.read_json("paper.json"), self.read_json("default.json"))
        # what is given counts on top of it, in any order
        self.extract(self.shared / "box.ply", "-o", "a.json", "--paper", "--corner-radius", "3")
        self.extract("--corner-radius=3", self.shared / "box.ply", "-o", "b.json", "--paper")
        self.assertEqual(self.read_json("a.json"), self.read_json("b.json"))
        self.assertNotEqual(self.read_json("a.json"), self.read_json("paper.json"))

    def test_defaults_given_explicitly(self):
        """What the help calls the default is the default."""
        given = []
        for entry in re.split(r"(?m)^  (?=-)", self.extract("--help")):
            match = re.match(r"(?s)(--[a-z-]+) .*\[(\S+)\]$", entry.strip().split("\n\n")[0])
            if match and match[1] not in HELPERS:
                given += match.groups()
        self.assertGreater(len(given), 30)
        self.extract(self.shared / "box.ply", "-o", "a.json", *given)
        self.extract(self.shared / "box.ply", "-o", "b.json")
        self.assertEqual(self.read_json("a.json"), self.read_json("b.json"))

    def test_sampling_distance(self):
        said = self.extract(self.shared / "box.ply", "-o", "out.json", "--sampling-distance", "0.035")
        self.assertIn("0.035 (given)", said)
        self.assertEqual(self.read_json("out.json")["sampling_distance"], 0.035)

    def test_stages(self):
        stages = self.folder / "made" / "stages"
        said = self.extract(self.shared / "box.ply", "-o", "out.json", "--stages", "made/stages")
        self.assertEqual(sorted(path.name for path in stages.iterdir()), STAGES)
        bounds = [(min(values), max(values)) for values in zip(*self.box)][:3]
        for name in STAGES:
            self.assertIn(name, said)
            ply = read_ply(stages / name)
            self.assertGreater(len(ply["vertex"]), 0)
            self.assertTrue({"red", "green", "blue"} <= set(ply["vertex"][0]))
            for vertex in ply["vertex"]:
                for axis, (least, most) in enumerate(bounds):
                    self.assertTrue(least - 0.2 < vertex["xyz"[axis]] < most + 0.2, (name, vertex))
            for edge in ply.get("edge", []):
                self.assertLess(max(edge["vertex1"], edge["vertex2"]), len(ply["vertex"]))
        skeleton = read_ply(stages / "1_skeleton.ply")["vertex"]
        self.assertTrue(all(0 <= v["scalar_distance"] < 1.6 * 0.032 for v in skeleton))
        points = [(v["x"], v["y"], v["z"]) for v in skeleton[:20]]
        self.assertLess(farthest(points, [row[:3] for row in self.box]), 1e-9)
        self.assertEqual(len(read_ply(stages / "4_clusters.ply")["vertex"]), len(skeleton))
        curves = {v["scalar_curve"] for v in read_ply(stages / "6_curves.ply")["vertex"]}
        self.assertEqual(curves, set(range(12)))
        self.assertEqual(sum(v["scalar_corner"] for v in read_ply(stages / "5_graph.ply")["vertex"]), 8)

    def test_stages_of_paper(self):
        (self.folder / "stages").mkdir()
        for name in STAGES:
            (self.folder / "stages" / name).write_text("of an earlier run")
        (self.folder / "stages" / "other.ply").write_text("not of the tool")
        self.extract(self.shared / "box.ply", "-o", "out.json", "--stages", "stages", "--paper", "--quiet")
        for name in STAGES:
            if (self.folder / "stages" / name).exists():
                read_ply(self.folder / "stages" / name)
        self.assertTrue((self.folder / "stages" / "6_curves.ply").exists())
        self.assertEqual((self.folder / "stages" / "other.ply").read_text(), "not of the tool")

    def test_separate_distances(self):
        write_cloud(self.folder / "points.xyz", [row[:3] for row in self.box])
        write_cloud(self.folder / "d.txt", [row[3:] for row in self.box])
        write_cloud(self.folder / "whole.xyz", self.box)
        self.extract("points.xyz", "--distances", "d.txt", "-o", "a.json")
        self.extract("whole.xyz", "-o", "b.json")
        self.assertEqual(self.read_json("a.json"), self.read_json("b.json"))

    def test_distance_property(self):
        rows = "".join(",".join(repr(x) for x in row) + ",7\n" for row in self.box)
        (self.folder / "cloud.csv").write_text("x,y,z,how_far,quality\n" + rows)
        self.extract("cloud.csv", "-o", "a.json", "--distance-property", "how_far")
        self.assertEqual(len(self.read_json("a.json")["curves"]), 12)

    def test_same_result_twice_and_with_threads(self):
        cloud = self.shared / "noisy.ply"
        self.extract(cloud, "-o", "a.json")
        self.extract(cloud, "-o", "b.json")
        self.extract(cloud, "-o", "one.json", "--threads", "1")
        self.extract(cloud, "-o", "two.json", "--threads", "2")
        content = (self.folder / "a.json").read_bytes()
        for name in ("b.json", "one.json", "two.json"):
            self.assertEqual((self.folder / name).read_bytes(), content, name)

    def test_permutation(self):
        permuted = self.box[:]
        random.Random(7).shuffle(permuted)
        self.assert_same_curves(permuted, 1e-3)

    def test_duplicates(self):
        said = self.assert_same_curves(self.box + self.box[:2500], 0.5)
        self.assertRegex(said.lower(), "twice|duplicate|repeat")

    def test_many_points_at_one_place(self):
        """Scanners put what they did not see into the origin."""
        write_cloud(self.folder / "c.xyz", self.box + [(0., 0., 0., 1.)] * 50000)
        self.extract("c.xyz", "-o", "out.json")
        self.assertEqual(len(self.read_json("out.json")["curves"]), 12)

    def assert_same_curves(self, cloud, tolerance):
        """The cloud gives the same curves as the box, up to a tolerance in sampling distances."""
        write_cloud(self.folder / "first.xyz", self.box)
        write_cloud(self.folder / "second.xyz", cloud)
        self.extract("first.xyz", "-o", "first.json", "-o", "first.txt")
        said = self.extract("second.xyz", "-o", "second.json", "-o", "second.txt")
        r, other_r = (self.read_json(name)["sampling_distance"] for name in ("first.json", "second.json"))
        self.assertAlmostEqual(other_r / r, 1, delta=tolerance)
        first, second = (sampled(self.folder / name) for name in ("first.txt", "second.txt"))
        self.assertEqual(len(first), len(second))
        for line in first:
            # samples of two runs may be shifted against each other along the curve by half a step
            best = min(max(farthest(line[::8], other), farthest(other[::8], line)) for other in second)
            self.assertLess(best, (tolerance + 0.13) * r)
        first, second = (self.read_json(name)["vertices"] for name in ("first.json", "second.json"))
        self.assertEqual(len(first), len(second))
        self.assertLess(max(farthest(first, second), farthest(second, first)), tolerance * r)
        return said

    # ---- help ----

    def test_help_and_version(self):
        self.assertEqual(self.extract("-V"), self.extract("--version"))
        for name in ("-h", "--help"):
            text = self.extract(name)
            self.assertTrue(all(len(line) <= 100 for line in text.splitlines()))
        for word in ("CLOUD", "--output", "--distances", "--distance-property", "--skip-invalid", "--paper",
                     "--stages", "--threads", "--quiet", "--version", "Exit codes"):
            self.assertIn(word, text)

    def test_version_tells_what_is_built_in(self):
        lines = self.extract("--version").splitlines()
        self.assertRegex(lines[0], r"\Aextract_wireframe \d+\.\d+\.\d+\Z")
        parts = dict(re.split(r"  +", line.strip(), maxsplit=1) for line in lines[1:])
        self.assertRegex(parts.pop("geometry and fits"), r"\ACGAL [\d.]+, Eigen [\d.]+, Ceres [\d.]+\Z")
        self.assertRegex(parts.pop("several threads"), r"\A(TBB \d|not built in: needs TBB \(Debian: libtbb-dev\))")
        help_text = re.sub(r"\s+", " ", self.extract("--help"))
        for part, (name, variable, marked) in {
                "STEP, IGES and BREP": ("OpenCASCADE", "CAD", ".step .stp .iges .igs .brep"),
                "HDF5": ("HDF5", "HDF5", ".h5 .hdf5"), "compressed .npz": ("zlib", "ZLIB", "compressed .npz"),
                "--png": ("libpng", "PNG", "--png"), "--html": ("three.js", "VIEWER", "--html")}.items():
            is_built_in = os.environ.get("EXTRACT_WIREFRAME_WITH_" + variable) == "1"
            with self.subTest(part=part, is_built_in=is_built_in):
                expected = rf"\A{name} r?\d+" if is_built_in else rf"\Anot built in: needs {name} \(Debian: .+\)\Z"
                self.assertRegex(parts.pop(part), expected)
                self.assertEqual("Not built in: " + marked in help_text, not is_built_in)
        self.assertEqual(parts, {})

    def test_every_parameter_is_an_option(self):
        library = HERE / "../../Wireframe_extraction/include/CGAL/Wireframe_extraction"
        source = library / "internal/options/parameters_interface.h"
        if not source.exists():
            self.skipTest("the sources of the library are elsewhere")
        names = re.findall(r"^CGAL_add_named_parameter\(\w+, (\w+),", source.read_text(), re.MULTILINE)
        self.assertGreater(len(names), 25)
        # what only a program can give
        for_programs = {"distance_map", "deviation_map", "error_message", "number_of_skipped", "sampling_step",
                        "extraction_report", "mesh_report", "provenance", "visitor"}
        renamed = {"patch_fusion": "fuse", "field_origin": "field", "coordinate_properties": "coordinates"}
        text = self.extract("--help")
        for name in names:
            if name not in for_programs:
                self.assertRegex(text, rf"(?m)^  --{renamed.get(name, name).replace('_', '-')}\b")

    def test_suggestions(self):
        for word, meant in (("--reglarize", "--regularize"), ("--outpt=a.json", "--output"), ("--smooth_angle", "--smooth-angle"),
                            ("-regularize", "--regularize"), ("--recognize", "--recognize-types")):
            self.refuse(USAGE_ERROR, [word, f"did you mean {meant}?"], self.shared / "box.ply", "-o", "a.json", word)
        done = self.execute(self.folder, self.shared / "box.ply", "-o", "a.json", "--nonsense")
        self.assertNotIn("did you mean", done.stderr)

    def test_configuration(self):
        self.assertEqual(self.extract("--regularize", "--smooth-angle", "15", "--unit", "in", "--coordinates", "x,y,z",
                                      "--write-config", "c.toml"), "")
        text = self.read_text("c.toml")
        given = dict(re.findall(r'(?m)^([a-z-]+) = "(.*)"$', text))
        self.assertEqual(given, {"regularize": "true", "smooth-angle": "15", "unit": "in", "coordinates": "x,y,z"})
        for line in ('# field = "auto"', '# threads', '# corner-reach = "8"'):
            self.assertIn(line.split(" = ")[0], text + "# threads")
        said = self.extract(self.shared / "box.ply", "--config", "c.toml", "-o", "a.json", "--write-config", "again.toml")
        self.assertRegex(said, r"(?m)^r +0\.0\d+ in ")
        self.assertEqual(self.read_text("again.toml"), text)
        self.extract(self.shared / "box.ply", "--regularize", "--smooth-angle", "15", "-o", "b.json")
        self.assertEqual(self.read_text("a.json"), self.read_text("b.json"))
        (self.folder / "own.toml").write_text("quiet = true\nsplines-only = true\n# a comment\n")
        self.assertEqual(self.extract(self.shared / "box.ply", "--config", "own.toml", "-o", "c.json"), "")
        self.assertEqual({curve["type"] for curve in self.read_json("c.json")["curves"]}, {"bspline"})
        self.extract(self.shared / "box.ply", "--config", "own.toml", "--splines-only", "false", "-o", "d.json")
        self.assertEqual({curve["type"] for curve in self.read_json("d.json")["curves"]}, {"line"})
        (self.folder / "bad.toml").write_text("reglarize = true\n")
        self.refuse(USAGE_ERROR, ["--config", "reglarize", "did you mean --regularize?"], self.shared / "box.ply",
                    "--config", "bad.toml", "-o", "x.json")
        (self.folder / "bad.toml").write_text("smooth-angle = many\n")
        self.refuse(USAGE_ERROR, ["--smooth-angle", "many"], self.shared / "box.ply", "--config", "bad.toml", "-o", "x.json")
        self.refuse(USAGE_ERROR, ["none.toml"], self.shared / "box.ply", "--config", "none.toml", "-o", "x.json")
        self.refuse(USAGE_ERROR, ["missing/c.toml"], "--write-config", "missing/c.toml")

    @unittest.skipUnless(shutil.which("bash"), "there is no bash")
    def test_completion(self):
        (self.folder / "c.bash").write_text(self.extract("--completion", "bash"))
        (self.folder / "folder").mkdir()
        (self.folder / "file.ply").write_text("")

        def completed(*words):
            script = "source c.bash; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _extract_wireframe; echo \"${COMPREPLY[@]}\""
            return sorted(subprocess.run(["bash", "-c", script, "bash", "extract_wireframe", *words], cwd=self.folder,
                                         stdout=subprocess.PIPE, encoding="utf-8", check=True).stdout.split())

        self.assertEqual(completed("--reg"), ["--regularize"])
        self.assertEqual(completed("--unit", ""), ["cm", "ft", "in", "m", "mm", "um"])
        self.assertEqual(completed("--regularize", "f"), ["false"])
        self.assertEqual(completed("--stages", "f"), ["folder"])
        self.assertEqual(completed("-o", "f"), ["file.ply", "folder"])
        self.assertEqual(completed("f"), ["file.ply", "folder"])
        options = set(re.findall(r"--[a-z][a-z-]+", "\n".join(re.findall(r"(?m)^  (-.*?)(?:  |$)", self.extract("--help")))))
        self.assertEqual(options - set(completed("-")), set())
        zsh = self.extract("--completion", "zsh")
        for option in options:
            self.assertIn(f"'*{option}[", zsh)
        if shutil.which("zsh"):
            subprocess.run(["zsh", "-n", "-c", zsh], check=True)

    def test_provenance(self):
        """The wireframe tells what it comes from, the same wherever the cloud is and however many threads are at work."""
        os.mkdir(self.folder / "a")
        shutil.copy(self.shared / "box.ply", self.folder / "a/box.ply")
        self.extract("a/box.ply", "--regularize", "--threads", "1", "--unit", "in", "-o", "a.json")
        self.extract(self.shared / "box.ply", "--regularize", "--unit", "in", "-o", "b.json")
        self.assertEqual((self.folder / "a.json").read_bytes(), (self.folder / "b.json").read_bytes())
        provenance = json.loads((self.folder / "a.json").read_text())["provenance"]
        self.assertRegex(provenance["program"], r"^extract_wireframe \d")
        self.assertEqual((provenance["inputs"], provenance["unit"]), (["box.ply"], "in"))
        self.assertEqual(provenance["options"], {"--regularize": "true"})
        self.assertGreater(provenance["noise_level"], 0)
        self.assertIn("parallel", " ".join(provenance["regularities"]))

    def test_place_of_distances(self):
        """The summary names the column that was taken for the distance, and a note that which cannot be one."""
        self.assertRegex(self.extract(self.shared / "box.ply", "-o", "a.json"), r'(?m)^Distances +the property "\w+"$')
        rows = "".join(" ".join(map(repr, row)) + "\n" for row in self.box)
        (self.folder / "four.xyz").write_text(rows)
        self.assertRegex(self.extract("four.xyz", "-o", "a.json"), r"(?m)^Distances +column 4$")
        (self.folder / "named.csv").write_text("x,y,z,scalar_distance\n" + rows.replace(" ", ","))
        self.assertRegex(self.extract("named.csv", "-o", "a.json"), r'(?m)^Distances +column 4, "scalar_distance"$')
        (self.folder / "other.csv").write_text("x,y,z,intensity\n" + rows.replace(" ", ","))
        said = self.extract("other.csv", "-o", "a.json")
        self.assertIn('"intensity" is no distance', said)
        self.assertNotRegex(said, "(?m)^Distances")

    @unittest.skipUnless(os.path.exists("/dev/stdin"), "there is no /dev/stdin")
    def test_standard_streams(self):
        self.extract(self.shared / "box.ply", "-o", "expected.json")
        cloud = (self.shared / "box.ply").read_bytes()
        text = "".join(" ".join(map(repr, row)) + "\n" for row in self.box).encode()
        for content, name in ((cloud, "ply"), (text, "xyz"), (cloud, ".PLY")):
            done = subprocess.run([self.tool, "-", "--input-format", name, "-o", "-", "--output-format", ".json"],
                                  input=content, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
            self.assertEqual(done.returncode, SUCCESS, done.stderr)
            self.assertEqual(without_provenance(done.stdout.decode()), self.read_text("expected.json"))
            self.assertIn(b"Curves      12 lines", done.stderr)
        with open(self.shared / "box.ply", "rb") as stream:
            done = subprocess.run([self.tool, "-", "--input-format", "ply", "-o", "-", "--output-format", "csv", "-o", "a.json",
                                   "--quiet"], stdin=stream, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr, done.stdout.count(b"\n")), (SUCCESS, b"", 13))
        self.assertEqual(self.read_text("a.json"), self.read_text("expected.json"))
        shutil.copy(self.shared / "box.ply", self.folder / "cloud.dat")
        self.extract("cloud.dat", "--input-format", "ply", "-o", "b.json")
        self.assertEqual(self.read_text("b.json"), self.read_text("expected.json"))
        self.write_meshes()
        os.rename(self.folder / "box.stl", self.folder / "mesh.dat")
        self.assertIn("12 lines", self.extract("mesh.dat", "--input-format", "stl", "-o", "c.json"))
        done = subprocess.run([self.tool, "-", "--input-format", "stl", "-o", "d.json"], cwd=self.folder,
                              input=(self.folder / "mesh.dat").read_bytes(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual((done.returncode, done.stderr), (SUCCESS, b""))
        self.assertEqual(self.read_text("d.json"), self.read_text("c.json"))
        for words, arguments in ((["--input-format"], ["-", "-o", "x.json"]),
                                 (["--output-format"], [self.shared / "box.ply", "-o", "-"]),
                                 (["--output-format", "-o -"], [self.shared / "box.ply", "-o", "x.json", "--output-format", "json"]),
                                 (["unknown extension"], [self.shared / "box.ply", "-o", "-", "--output-format", "jpg"])):
            self.refuse(USAGE_ERROR, words, *arguments)
        self.refuse(BAD_INPUT, ["unknown format", "\".jpg\""], "cloud.dat", "--input-format", "jpg", "-o", "x.json")

    def test_doubts_in_summary(self):
        said = self.extract(self.shared / "noisy.ply", "-o", "a.json", "--minimum-evidence", "0", "--splines-only")
        wireframe = self.read_json("a.json")
        doubtful = [i for i, curve in enumerate(wireframe["curves"]) if curve["doubts"]]
        count = rf"{len(doubtful)} of {len(wireframe['curves'])} curves?"
        if doubtful:
            self.assertRegex(said, rf"\nDoubtful +{count}: {', '.join(map(str, doubtful[:15]))}.*\nWhy +[a-z_]+ \d.*\nWhat to do  .*\n\Z")
        else:
            self.assertRegex(said, rf"\nDoubtful +{count}\n\Z")

    @unittest.skipIf(sys.platform == "win32", "there is no pseudo terminal")
    def test_progress(self):
        import pty
        for more, is_loud in (([], True), (["--quiet"], False)):
            leader, follower = pty.openpty()
            process = subprocess.Popen([self.tool, str(self.shared / "box.ply"), "-o", "out.json", *more],
                                       cwd=self.folder, stdout=subprocess.PIPE, stderr=follower)
            os.close(follower)
            shown = b""
            try:
                while True:
                    piece = os.read(leader, 4096)
                    if not piece:
                        break
                    shown += piece
            except OSError:  # how a pseudo terminal ends
                pass
            os.close(leader)
            process.communicate(timeout=TIME_LIMIT)
            self.assertEqual(process.returncode, SUCCESS)
            if is_loud:
                self.assertIn(b"%", shown)
                self.assertIn(b"fitting curves", shown)
                self.assertTrue(shown.endswith(b"\r\x1b[K"), shown[-80:])  # the line is wiped
            else:
                self.assertEqual(shown, b"")

    # ---- wrong usage ----

    def test_usage(self):
        (self.folder / "c.xyz").write_text("1 2 3 4\n")
        self.refuse(USAGE_ERROR, ["CLOUD", "--help"])
        self.refuse(USAGE_ERROR, ["--output"], "c.xyz")
        self.refuse(USAGE_ERROR, ["--output"], "c.xyz", "-o")
        self.refuse(USAGE_ERROR, ["--nonsense"], "c.xyz", "-o", "out.json", "--nonsense")
        self.refuse(USAGE_ERROR, ["b.xyz"], "c.xyz", "b.xyz", "-o", "out.json")
        self.refuse(USAGE_ERROR, ["b.obj"], "c.xyz", "-o", "out.json", "b.obj")
        self.refuse(USAGE_ERROR, ["--distances", "--distance-property"], "c.xyz", "-o", "out.json",
                    "--distances", "d.txt", "--distance-property", "d")

    def test_booleans(self):
        """All of them stand alone or with a value, which is true or false, whatever stands behind them."""
        (self.folder / "c.xyz").write_text("1 2 3 4\n")
        booleans = re.findall(r"(?m)^  (--[a-z-]+) \[true\|false\]", self.extract("--help"))
        self.assertEqual(set(booleans), {"--obj-splines", "--dxf-splines", "--dimensions", "--patches", "--use-indices", "--skip-invalid",
                                         "--keep-failed", "--paper", "--quiet", "--use-creases", "--use-tangents",
                                         "--use-robust-loss", "--move-corners", "--adapt-knots", "--recognize-types",
                                         "--splines-only", "--regularize", "--use-boundaries", "--clamp-negative"})
        for name in booleans:
            if name in ("--keep-failed", "--use-boundaries"):
                continue   # of batches, and of meshes
            helpers = HELPERS.get(name, [])
            # the only thing that is wrong is the cloud
            self.refuse(BAD_INPUT, ["c.xyz", "coincide"], name, "c.xyz", "-o", "out.json", *helpers)
            self.refuse(BAD_INPUT, ["c.xyz", "coincide"], "c.xyz", "-o", "out.json", *helpers, name, "false")
            self.refuse(USAGE_ERROR, [name, "true|false"], "c.xyz", "-o", "out.json", f"{name}=maybe", *helpers)
        # what is read by the same code for all of them is looked at once
        for words in (["--paper"], ["--paper", "true"], ["--paper", "false"], ["--paper=true"], ["--paper=false"]):
            self.refuse(BAD_INPUT, ["c.xyz", "coincide"], *words, "c.xyz", "-o", "out.json")
            self.refuse(BAD_INPUT, ["c.xyz", "coincide"], "c.xyz", "-o", "out.json", *words)
        for value in ("maybe", "True", "1", ""):
            self.refuse(USAGE_ERROR, ["--paper", "true|false"] if value else ["--paper"], "c.xyz", "-o", "out.json",
                        f"--paper={value}")
        self.refuse(USAGE_ERROR, ["--quiet"], "c.xyz", "-o", "out.json", "--quiet", "--quiet")
        for words in (["true", "c.xyz"], ["c.xyz", "True"], ["--smooth-angle", "20", "false", "c.xyz"]):
            self.refuse(USAGE_ERROR, ["is no cloud", "--quiet true"], *words, "-o", "out.json")

    def test_values_of_booleans(self):
        self.extract("--quiet", "--splines-only", "false", self.shared / "box.ply", "-o", "lines.json")
        self.extract("--quiet=true", "--recognize-types=false", self.shared / "box.ply", "-o", "splines.json")
        self.extract("--splines-only", self.shared / "box.ply", "-o", "others.json")
        self.assertEqual({curve["type"] for curve in self.read_json("lines.json")["curves"]}, {"line"})
        self.assertEqual({curve["type"] for curve in self.read_json("splines.json")["curves"]}, {"bspline"})
        self.assertEqual(self.read_json("splines.json"), self.read_json("others.json"))
        self.assertIn("Points", self.extract("--quiet", "false", self.shared / "box.ply", "-o", "out.json"))

    def test_options_without_effect(self):
        (self.folder / "c.xyz").write_text("1 2 3 4\n")
        for option, others, what in (
                (["--view", "top"], [], "--png"), (["--fuse", "median"], [], "--patches"),
                (["--use-indices"], ["--patches", "false"], "--patches"), (["--indices-dataset", "i"], [], "--patches"),
                (["--step-schema", "ap242"], ["-o", "x.svg"], ".step"),
                (["--obj-splines"], ["-o", "x.svg"], ".obj"), (["--dimensions"], ["-o", "x.obj"], ".svg"),
                (["--sampling-step", "1"], ["-o", "x.svg"], ".vtp"), (["--corner-variance", "0.2"], [], "variance"),
                (["--corner-radius", "3"], [], "--corner-measure"),
                (["--corner-sampling-ratio", "0.2"], [], "variance"),
                (["--corner-residual", "1"], ["--paper"], "field-residual"),
                (["--end-detection", "main-axis"], [], "--graph-method subdivided"),
                (["--split-threshold", "3"], [], "--graph-method"), (["--maximum-gap", "3"], ["--paper"], "traced"),
                (["--minimum-evidence", "3"], ["--graph-method", "subdivided"], "traced"),
                (["--regularize"], ["--splines-only"], "--recognize-types"),
                (["--regularize"], ["--paper"], "--recognize-types"),
                (["--type-significance", "0.1"], ["--recognize-types", "false"], "--recognize-types"),
                (["--mesh", "cad"], [], "a mesh"), (["--use-boundaries"], [], ".stl"),
                (["--maximum-number-of-points", "1000"], [], "a mesh"),
                (["--jobs", "2"], [], "--batch"), (["--keep-failed"], [], "--batch"),
                (["--output-dir", "x"], [], "--batch")):
            self.refuse(USAGE_ERROR, [option[0], what, "requires"], "c.xyz", "-o", "out.json", *option, *others)
        # what has an effect, or could have none in any case, is taken; only the cloud is wrong
        for words in (["--regularize", "--paper", "--recognize-types"], ["--regularize", "false", "--splines-only"],
                      ["--corner-radius", "3", "--paper"], ["--unit", "in", "-o", "x.obj"],
                      ["--split-threshold", "3", "--graph-method", "subdivided"], ["--obj-splines", "-o", "x.obj"]):
            self.refuse(BAD_INPUT, ["c.xyz", "coincide"], "c.xyz", "-o", "out.json", *words)

    def test_values_of_options(self):
        (self.folder / "c.xyz").write_text("1 2 3 4\n")
        for option, values in (("--sampling-distance", ["0", "-1", "nan", "inf", "1e999", "much", "1 2", ""]),
                               ("--skeleton-distance", ["0", "-1.5"]), ("--corner-variance", ["-0.1", "1.1"]),
                               ("--corner-sampling-ratio", ["0", "1.5"]),
                               ("--connection-angle", ["-1", "91"]),
                               ("--smooth-angle", ["181"]), ("--use-tangents", ["maybe", "2"]),
                               ("--corner-measure", ["residual", "0", ""]), ("--graph-method", ["TRACED"]),
                               ("--end-detection", ["axis"]), ("--step-schema", ["ap203", "AP214", ""]),
                               ("--number-of-rounds", ["0", "2.5", "-1", "1e3"]),
                               ("--threads", ["0", "-1", "x", "1.5", "99999999999999999999", ""])):
            for value in values:
                self.refuse(USAGE_ERROR, [option], "c.xyz", "-o", "out.json", f"{option}={value}"
                            if value else option, *([] if value else [""]))
        self.refuse(USAGE_ERROR, ["--corner-radius"], "c.xyz", "-o", "out.json", "--corner-radius", "3",
                    "--corner-radius", "4")

    def test_same_file_twice(self):
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        write_cloud(self.folder / "d.txt", [row[3:] for row in self.box])
        words = ["same file"]
        self.refuse(USAGE_ERROR, words, "box.ply", "-o", "box.ply")
        self.refuse(USAGE_ERROR, words, "box.ply", "-o", "./box.ply")
        self.refuse(USAGE_ERROR, words, "box.ply", "-o", "out.json", "-o", f"../{self.folder.name}/out.json")
        self.refuse(USAGE_ERROR, words, "box.ply", "--distances", "d.txt", "-o", "d.txt")
        self.refuse(USAGE_ERROR, words, "box.ply", "--stages", ".", "-o", "5_graph.ply")
        if hasattr(os, "symlink"):
            os.symlink("box.ply", self.folder / "link.ply")
            self.refuse(USAGE_ERROR, words, "box.ply", "-o", "link.ply")

    # ---- outputs ----

    def test_bad_outputs(self):
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        (self.folder / "a_folder.json").mkdir()
        (self.folder / "a_file").write_text("old")
        for name in ("out", "out.xyz", "out.json.gz"):
            self.refuse(USAGE_ERROR, [name, "extension", ".json", ".dxf", ".obj", ".ply", ".vtp", ".gltf", ".glb",
                                      ".svg", ".csv", ".txt", ".cgal"],
                        "box.ply", "-o", name)
        self.refuse(USAGE_ERROR, ["empty"], "box.ply", "-o", "")
        self.refuse(USAGE_ERROR, ["missing/out.json", "no folder"], "box.ply", "-o", "missing/out.json")
        self.refuse(USAGE_ERROR, ["missing/out.json"], "box.ply", "-o", "fine.json", "-o", "missing/out.json")
        self.refuse(USAGE_ERROR, ["a_folder.json", "directory"], "box.ply", "-o", "a_folder.json")
        self.refuse(USAGE_ERROR, ["a_file/out.json"], "box.ply", "-o", "a_file/out.json")
        self.refuse(USAGE_ERROR, ["a_file"], "box.ply", "-o", "out.json", "--stages", "a_file")
        self.refuse(USAGE_ERROR, ["a_file/stages"], "box.ply", "-o", "out.json", "--stages", "a_file/stages")
        self.refuse(USAGE_ERROR, ["stages", "empty"], "box.ply", "-o", "out.json", "--stages", "")

    def test_protected_folder(self):
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        protected = self.folder / "protected"
        protected.mkdir()
        (protected / "old.json").write_text("old")
        (protected / "old.json").chmod(stat.S_IREAD)
        protected.chmod(stat.S_IREAD | stat.S_IEXEC)
        try:
            if os.access(protected, os.W_OK):
                self.skipTest("protection does not count for the superuser")
            self.refuse(USAGE_ERROR, ["protected/out.json"], "box.ply", "-o", "protected/out.json")
            self.refuse(USAGE_ERROR, ["protected/old.json"], "box.ply", "-o", "protected/old.json")
            self.refuse(USAGE_ERROR, ["protected"], "box.ply", "-o", "out.json", "--stages", "protected/new")
        finally:
            protected.chmod(stat.S_IRWXU)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no full device")
    def test_full_disk(self):
        """A file that cannot be written stops no other one, and leaves nothing behind."""
        shutil.copy(self.shared / "box.ply", self.folder / "box.ply")
        os.symlink("/dev/full", self.folder / "full.json")
        for names in (["new.json", "old.obj", "full.json"], ["full.json", "new.json", "old.obj"],
                      ["old.obj", "full.json", "new.json"]):
            (self.folder / "old.obj").write_text("old")
            (self.folder / "new.json").unlink(missing_ok=True)
            self.assert_full(names)

    def assert_full(self, names, full="full.json"):
        """All of these are written, but the one that the disk is full for."""
        done = self.execute(self.folder, "box.ply", *sum((["-o", name] for name in names), []))
        self.assertEqual(done.returncode, INTERNAL_ERROR, done.stderr)
        self.assertRegex(done.stderr, r"\Aextract_wireframe: error: " + re.escape(full) + r": [^\n]*full[^\n]*\n\Z")
        self.assertEqual(re.findall(r"(?m)^Written +(.+)$", done.stdout), [name for name in names if name != full])
        for name in names:
            if name != full:
                self.assertGreater((self.folder / name).stat().st_size, 100)
        self.assertEqual([name for name in self.files() if ".partial" in name], [])

    def test_old_output_stays(self):
        (self.folder / "out.json").write_text("old")
        self.refuse_text(BAD_INPUT, ["is empty"], "")
        self.refuse_text(NO_FEATURE, [], "".join(f"{x / 10} {y / 10} {(x * y) % 3} {100 + x / 10}\n"
                                                 for x in range(30) for y in range(30)))

    # ---- bad input ----

    def test_files(self):
        self.refuse(BAD_INPUT, ["none.ply", "No such file"], "none.ply", "-o", "out.json")
        self.refuse(BAD_INPUT, ["none.stl", "check its name"], "none.stl", "-o", "out.json")
        for name in ("scan.las", "scan.LAZ", "scan.e57"):
            self.refuse_text(BAD_INPUT, ["is not read", ".ply", "CloudCompare", "pdal"], "LASF", name)
        (self.folder / "folder.ply").mkdir()
        (self.folder / "folder").mkdir()
        for name in ("folder.ply", "folder"):
            self.refuse(BAD_INPUT, [name, "directory", "--batch"], name, "-o", "out.json")
        self.refuse(BAD_INPUT, ["größe.ply", "No such file"], "größe.ply", "-o", "out.json")
        self.refuse_text(BAD_INPUT, ["größe, y, z"], "größe y z\n1 2 3\n")
        self.refuse(BAD_INPUT, ["none.ply"], "none.ply", "-o", "out.json", "--stages", "a/b/c")
        self.refuse(BAD_INPUT, ["two lines.ply"], "two\nlines.ply", "-o", "out.json")
        for name in ("empty.ply", "empty.xyz", "empty.csv"):
            self.refuse_text(BAD_INPUT, ["is empty", "get a complete copy"], "", name)
        self.refuse_text(BAD_INPUT, ["no points"], "# nothing\n")

    # a box of 2 x 1 x 0.7
    VERTICES = [(x, y, z) for z in (0, 0.7) for x, y in ((0, 0), (2, 0), (2, 1), (0, 1))]
    FACES = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (3, 2, 1, 0), (4, 5, 6, 7)]

    def write_meshes(self):
        """The box in all formats for meshes; returns their names."""
        lines = [" ".join(map(str, vertex)) + "\n" for vertex in self.VERTICES]
        faces = ["4 " + " ".join(map(str, face)) + "\n" for face in self.FACES]
        (self.folder / "box.off").write_text("OFF\n8 6 0\n" + "".join(lines + faces))
        (self.folder / "box.ply").write_text(
            self.ply(8, ("x", "y", "z")).replace("end_header", "element face 6\nproperty list uchar int vertex_indices\n"
                                                 "end_header") + "".join(lines + faces))
        (self.folder / "box.obj").write_text(
            "".join("v " + line for line in lines)
            + "".join("f " + " ".join(str(v + 1) for v in face) + "\n" for face in self.FACES))
        triangles = [(a, b, c) for a, b, c, d in self.FACES] + [(a, c, d) for a, b, c, d in self.FACES]
        (self.folder / "box.stl").write_bytes(bytes(80) + struct.pack("<I", len(triangles)) + b"".join(
            struct.pack("<12f", 0, 0, 0, *(x for v in face for x in self.VERTICES[v])) + bytes(2) for face in triangles))
        return ["box.off", "box.ply", "box.obj", "box.stl"]

    def test_meshes(self):
        for name in self.write_meshes():
            with self.subTest(name=name):
                said = self.extract(name, "-o", "out.json", "-o", "out.obj")
                self.assertIn("taken for a shape (--mesh cad): 12 triangles, 12 sharp edges in 12 curves", said)
                wireframe = self.read_json("out.json")
                self.check_wireframe(wireframe)
                self.assertEqual([curve["type"] for curve in wireframe["curves"]], 12 * ["line"])
                self.assertLess(max(min(math.dist(p, q) for q in self.VERTICES) for p in wireframe["vertices"]), 1e-5)
                (self.folder / "out.json").unlink()
        said = self.extract("box.stl", "-o", "out.json", "--sampling-distance", "0.05")
        self.assertIn("r = 0.05", said)
        self.assertRegex(said, r"r +0\.05 \(given\)")
        few = int(re.search(r"Points +(\d+)", said)[1])
        many = int(re.search(r"Points +(\d+)", self.extract("box.stl", "-o", "out.json"))[1])
        self.assertLess(few, 5000)
        self.assertGreater(many, 15000)
        self.extract("box.stl", "-o", "a.json", "--threads", "1")
        self.extract("box.stl", "-o", "b.json", "--threads", "2")
        self.assertEqual(self.read_json("a.json"), self.read_json("b.json"))

    def test_choices_of_meshes(self):
        self.write_meshes()
        self.refuse(NO_FEATURE, ["no edge of the mesh is sharp", "120 degrees", "--minimum-fold"], "box.stl", "-o",
                    "out.json", "--minimum-fold", "120")
        for name in ("box.stl", "box.obj"):
            self.refuse(BAD_INPUT, [name, "the mesh is a scan: its vertices are a cloud without distances", "--mesh cad"],
                        name, "-o", "out.json", "--mesh", "scan", "--field", "given")
        self.refuse(BAD_INPUT, ["box.ply", "have no property for the distance"], "box.ply", "-o", "out.json", "--mesh",
                    "scan", "--field", "given")
        self.refuse(USAGE_ERROR, ["--use-boundaries", "scan"], "box.stl", "-o", "out.json", "--mesh", "scan",
                    "--use-boundaries")
        # distances that are there count
        (self.folder / "distances.txt").write_text("1\n" * 8)
        self.refuse(BAD_INPUT, ["box.off", "all distances are 1"], "box.off", "-o", "out.json", "--distances",
                    "distances.txt")
        self.refuse(USAGE_ERROR, ["--mesh"], "box.off", "-o", "out.json", "--distances", "distances.txt", "--mesh", "cad")
        # and those that are named have to be there
        for name in ("box.stl", "box.obj"):
            for option in ("--distance-property", "--distances-dataset", "--distances"):
                self.refuse(BAD_INPUT, [name, "has no distances", option, ".ply"], name, "-o", "out.json", option,
                            "distances.txt")
        for name in ("box.ply", "box.off"):
            self.refuse(BAD_INPUT, [name, "distances"], name, "-o", "out.json", "--distance-property", "d")
            self.refuse(USAGE_ERROR, ["--mesh cad", "--distance-property"], name, "-o", "out.json", "--distance-property",
                        "d", "--mesh", "cad")
        open_box = "".join(f"v {x} {y} {z}\n" for x, y, z in self.VERTICES)
        open_box += "".join("f " + " ".join(str(v + 1) for v in face) + "\n" for face in self.FACES[:5])
        (self.folder / "open.obj").write_text(open_box)
        self.assertIn("8 sharp edges", self.extract("open.obj", "-o", "out.json"))
        self.assertIn("12 sharp edges", self.extract("open.obj", "-o", "out.json", "--use-boundaries"))

    def test_bad_meshes(self):
        self.write_meshes()
        cut = (self.folder / "box.stl").read_bytes()[:-7]
        self.refuse_text(BAD_INPUT, ["12 facets", "truncated"], cut, "c.stl")
        self.refuse_text(BAD_INPUT, ["is empty", "get a complete copy"], "", "c.stl")
        self.refuse_text(BAD_INPUT, ["2 vertices and no faces", "cloud of points"], "v 0 0 0\nv 1 1 1\nl 1 2\n", "c.obj")
        self.refuse_text(BAD_INPUT, ["c.obj:2:", "1 vertex"], "v 0 0 0\nf 1\n", "c.obj")
        self.refuse_text(BAD_INPUT, ["no face has an area"], "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "c.obj")
        self.refuse_text(BAD_INPUT, ["c.ply", "vertex 9"], (self.folder / "box.ply").read_text().replace("4 4 5 6 7", "4 4 5 6 9"),
                         "c.ply")
        self.refuse_text(BAD_INPUT, ["50 million"],
                         (self.folder / "box.stl").read_bytes(), "c.stl", "--sampling-distance", "1e-6")

    def test_text(self):
        rows = "0 0 0 1\n"
        self.refuse_text(BAD_INPUT, ["word.xyz:2: column 4", "\"a\"", "write a number there", "leave the line out"],
                         rows + "1 0 0 a\n", "word.xyz")
        self.refuse_text(BAD_INPUT, ["comma.xyz:1:", "need a point"], "0,0 1,0 2,0 0,5\n", "comma.xyz")
        self.refuse_text(BAD_INPUT, ["one line", "check what holds x, y and z"],
                         "".join(f"{i} 0 0 {i}\n" for i in range(5)), "five.xyz")

    def test_columns_without_names(self):
        """Of normals before the distance, none must pass for one."""
        rows = ["%r %r %r 0.6 -0.58 0.55 %r" % row for row in self.box]
        text = "\n".join(rows)
        self.refuse_text(BAD_INPUT, ["normals.xyz:1:", "7 columns", "--distance-property", "line of names"], text,
                         "normals.xyz")
        for wrong in ("3", "8", "d"):
            self.refuse_text(BAD_INPUT, ["normals.xyz:1:", f'"{wrong}"', "4 to 7"], text, "normals.xyz",
                             "--distance-property", wrong)
        self.refuse_text(BAD_INPUT, ["distance in column 5 is -0.58", "--skip-invalid"], text, "normals.xyz",
                         "--distance-property", "5")
        self.extract("normals.xyz", "-o", "a.json", "--distance-property", "7")
        self.extract(self.shared / "box.ply", "-o", "b.json")
        self.assertEqual(len(self.read_json("a.json")["curves"]), len(self.read_json("b.json")["curves"]))

    @staticmethod
    def ply(count, names=("x", "y", "z", "distance"), body="", form="ascii"):
        properties = "".join(f"property float {name}\n" for name in names)
        return f"ply\nformat {form} 1.0\nelement vertex {count}\n{properties}end_header\n{body}"

    def test_ply(self):
        self.refuse_text(BAD_INPUT, ["no points"], self.ply(0), "c.ply")
        self.refuse_text(BAD_INPUT, ["distance", "x, y, z, confidence, nx", "--distance-property"],
                         self.ply(1, ("x", "y", "z", "confidence", "nx"), "1 2 3 4 5\n"), "c.ply", "--field", "given")
        self.refuse_text(BAD_INPUT, ["\"own\"", "x, y, z, distance"], self.ply(1, body="1 2 3 4\n"), "c.ply",
                         "--distance-property", "own")
        self.refuse_text(BAD_INPUT, ["truncated", "1 of 3"], self.ply(3, body="1 2 3 4\n"), "c.ply")
        self.refuse_text(BAD_INPUT, ["truncated", "0 of 3"],
                         self.ply(3, body="12345678", form="binary_little_endian"), "c.ply")
        self.refuse_text(BAD_INPUT, ["\"seven\"", ":9:"], self.ply(1, body="1 2 seven 4\n"), "c.ply")
        cut = (self.shared / "box.ply").read_bytes()[:-7]
        self.refuse_text(BAD_INPUT, ["truncated", "4999 of 5000"], cut, "c.ply")

    def test_lying_header(self):
        begin = time.monotonic()
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            self.refuse_text(BAD_INPUT, ["1000000000000", "truncated"],
                             self.ply(10**12, body="1 2 3 4\n", form=form), "c.ply")
        self.assertLess(time.monotonic() - begin, 30)

    def test_invalid_numbers(self):
        rows = ["%r %r %r %r\n" % row for row in self.box]
        bad = rows[:]
        bad[17] = "0 nan 0 1\n"
        bad[42] = "0 0 inf 1\n"
        bad[99] = "0 0 0 -0.5\n"
        bad[100] = "0 0 0 nan\n"
        words = ["4 of 5000", "2 with a coordinate", "1 with a distance", "1 with a negative", "point 17",
                 "line 18", "leave such points out by --skip-invalid"]
        self.refuse_text(BAD_INPUT, words, "".join(bad))
        self.refuse_text(BAD_INPUT, ["1 of 5000", "point 4999", "negative", "-2", "--skip-invalid"],
                         "".join(rows[:-1]) + "0 0 0 -2\n")
        (self.folder / "cloud.xyz").write_text("".join(bad))
        said = self.extract("cloud.xyz", "-o", "out.json", "--skip-invalid")
        self.assertRegex(said, r"Points +4996, 4 more skipped")
        self.assertEqual(len(self.read_json("out.json")["curves"]), 12)
        self.refuse_text(BAD_INPUT, ["no point is left"], "nan 0 0 1\n0 0 0 -1\n", "all.xyz",
                         "--skip-invalid")

    def test_counts_differ(self):
        (self.folder / "d.txt").write_text("1\n2\n")
        self.refuse_text(BAD_INPUT, ["3 points", "d.txt", "2 distances"], "1 2 3\n4 5 6\n7 8 9\n", "c.xyz",
                         "--distances", "d.txt")
        self.refuse(BAD_INPUT, ["none.txt", "No such file"], "c.xyz", "-o", "out.json",
                    "--distances", "none.txt")
        self.refuse(BAD_INPUT, ["empty"], "c.xyz", "-o", "out.json", "--distances", "")
        self.refuse_text(BAD_INPUT, [":2:", "3 columns"], "1 2 3 4\n1 2 3\n")

    def test_degenerate_clouds(self):
        count = 500
        self.refuse_text(BAD_INPUT, ["coincide"], "1 2 3 0\n")
        self.refuse_text(BAD_INPUT, ["coincide"], "1 2 3 0.1\n" * count)
        self.refuse_text(BAD_INPUT, ["line"], "".join(f"{i * 0.1} {i * 0.2} {i * 0.3} 0.1\n"
                                                      for i in range(count)))
        # without an edge in it, a plane has nothing to show
        self.refuse_text(NO_FEATURE, ["plane"], "".join(f"{x * 0.1} {y * 0.1} 0 {x * 0.1 + 1}\n"
                                                        for x in range(25) for y in range(25)))
        # with one it has
        (self.folder / "plane.xyz").write_text("".join(f"{x * 0.1} {y * 0.1} 1 {abs(x - 20) * 0.1}\n"
                                                       for x in range(41) for y in range(41)))
        self.extract("plane.xyz", "-o", "out.json")
        self.assertEqual(len(self.read_json("out.json")["curves"]), 1)

    def test_nothing_under_the_threshold(self):
        far = [row[:3] + (row[3] + 0.3,) for row in self.box]
        write_cloud(self.folder / "c.xyz", far)
        said = self.refuse(NO_FEATURE, ["c.xyz", "smallest", "--skeleton-distance"],
                           "c.xyz", "-o", "out.json")
        self.assertIn("0.3", said)   # the smallest distance
        self.assertIn("0.04", said)  # the threshold, 1.5 r

    def test_mix_up_of_units(self):
        for factor in (1000, 0.001):
            write_cloud(self.folder / "c.xyz", [row[:3] + (factor * row[3],) for row in self.box])
            self.refuse(BAD_INPUT, ["c.xyz", "unit"], "c.xyz", "-o", "out.json")
        write_cloud(self.folder / "c.xyz", [row[:3] + (row[3] + 5,) for row in self.box])
        self.refuse(NO_FEATURE, ["c.xyz", "smallest", "unit"], "c.xyz", "-o", "out.json")


if __name__ == "__main__":
    main("tool", "cloud_maker")
