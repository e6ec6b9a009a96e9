#!/usr/bin/env python3
"""Tests make_step_case from the outside, on parts that write_step_parts makes: what is expected follows from them.

usage: test_wireframe_step_case.py MAKE_STEP_CASE WRITE_STEP_PARTS [options of unittest]
"""

import collections
import json
import math
import shutil
import subprocess

from program_test import BAD_INPUT, NO_FEATURE, USAGE_ERROR, Program_test, main, read_cloud

R = 0.02


class Step_case_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.parts = cls.shared / "parts"
        cls.parts.mkdir()
        subprocess.run([cls.part_writer, cls.parts], check=True, timeout=120, stdout=subprocess.DEVNULL)

    def make(self, name, *arguments):
        """The truth and the exact cloud; with the shortest curve 20 r long unless the arguments say else."""
        if "--quantile" not in arguments:
            arguments += ("--quantile", "0", "--quantile-length", "20")
        self.run_tool(self.parts / (name + ".stp"), "-o", self.folder, "--fields", "exact", "--force", *arguments)
        truth = json.loads((self.folder / name / "truth.json").read_text())
        self.assertEqual(truth["r"], R)
        cloud = read_cloud(self.folder / name / "exact.ply")
        self.assertEqual(truth["points"], len(cloud))
        return truth, cloud

    def assert_curves(self, truth, scale, segments, curves, corners):
        """`segments`: kind and length of each, in millimetres."""
        found = sorted((s["kind"], s["length"] / scale) for s in truth["segments"])
        self.assertEqual([kind for kind, _ in found], [kind for kind, _ in sorted(segments)])
        for (_, length), (kind, expected) in zip(found, sorted(segments)):
            self.assertAlmostEqual(length, expected, delta=1e-3 * expected, msg=kind)
        self.assertEqual((len(truth["curves"]), len(truth["corners"])), (curves, corners))

    def test_drilled_block(self):
        truth, cloud = self.make("drilled_block")
        scale = 20 * R / 10
        edges = [("line", length) for length in (10, 16, 20)] * 4
        self.assert_curves(truth, scale, edges + [("circle", 6 * math.pi)] * 2, 14, 8)   # no seam
        self.assertEqual(sum(c["closed"] for c in truth["curves"]), 2)
        counts = collections.Counter()
        for x, y, z, d in ([c / scale for c in p] for p in cloud):
            to_axis = math.hypot(x - 10, y - 8)
            if abs(z) < 1e-4 or abs(z - 10) < 1e-4:
                counts["plane"] += 1
                self.assertAlmostEqual(d, min(x, 20 - x, y, 16 - y, abs(to_axis - 3)), delta=0.02)
            elif to_axis < 3.5:
                counts["hole"] += 1
                self.assertAlmostEqual(to_axis, 3, delta=1e-4)   # on the cylinder, not on its triangles
                self.assertAlmostEqual(d, min(z, 10 - z), delta=0.02)
            elif abs(x) < 1e-4:
                counts["side"] += 1
                self.assertAlmostEqual(d, min(y, 16 - y, z, 10 - z), delta=1e-3)
        self.assertTrue(all(counts[k] > 300 for k in ("plane", "hole", "side")), counts)
        area = 2 * (320 + 200 + 160) - 18 * math.pi + 60 * math.pi
        self.assertAlmostEqual(len(cloud), 0.82 * area * scale ** 2 / R ** 2, delta=0.01 * len(cloud))

    def test_rounded_block(self):
        truth, _ = self.make("rounded_block")
        edges = [("line", 10)] * 3 + [("line", 16), ("line", 20), ("line", 13), ("line", 17)] * 2
        # the ends of the round pass smoothly into the straight edges; those along it are not sharp
        self.assert_curves(truth, 20 * R / (1.5 * math.pi), edges + [("arc", 1.5 * math.pi)] * 2, 9, 6)

    def test_slanted_cylinder(self):
        truth, cloud = self.make("slanted_cylinder")
        a, b = 5 * math.sqrt(2), 5
        h = ((a - b) / (a + b)) ** 2
        around = math.pi * (a + b) * (1 + 3 * h / (10 + math.sqrt(4 - 3 * h)))   # Ramanujan
        scale = 20 * R / (10 * math.pi)
        self.assert_curves(truth, scale, [("circle", 10 * math.pi), ("ellipse", around)], 2, 0)
        for x, y, z, d in ([c / scale for c in p] for p in cloud):
            if abs(z) < 1e-4:
                self.assertAlmostEqual(d, 5 - math.hypot(x, y), delta=0.02)

    def test_sharp_angle(self):
        truth, _ = self.make("creased_block")
        self.assertEqual((len(truth["segments"]), len(truth["curves"]), len(truth["corners"])), (14, 12, 8))
        truth, _ = self.make("creased_block", "--sharp-angle", "5")
        self.assertEqual((len(truth["segments"]), len(truth["curves"]), len(truth["corners"])), (15, 15, 10))

    def test_open_shells(self):
        truth, _ = self.make("two_squares")
        self.assert_curves(truth, 20 * R / 10, [("line", 10)] * 8, 8, 8)
        truth, _ = self.make("two_squares", "--sew", "0.01")
        self.assert_curves(truth, 20 * R / 10, [("line", 10)] * 7, 7, 6)

    def test_apex(self):
        truth, _ = self.make("cone")
        self.assert_curves(truth, 20 * R / (10 * math.pi), [("circle", 10 * math.pi)], 1, 0)

    def test_quantile(self):
        truth, cloud = self.make("drilled_block", "--quantile", "0.5", "--quantile-length", "25")
        median = sorted([10, 16, 20] * 4 + [6 * math.pi] * 2)[6:8]
        self.assertAlmostEqual(max(p[2] for p in cloud), 10 * 25 * R / (sum(median) / 2), delta=1e-3)
        _, cloud = self.make("drilled_block", "--max-points", "1000")
        self.assertLessEqual(len(cloud), 1000)
        self.assertGreater(len(cloud), 950)

    def test_same_seed_same_bytes(self):
        clouds = [self.make("drilled_block", "--seed", seed)[1] for seed in ("7", "7", "8")]
        self.assertEqual(clouds[0], clouds[1])
        self.assertNotEqual(clouds[0], clouds[2])

    def test_bad_parts(self):
        message = self.run_tool(self.parts / "sphere.stp", "-o", self.folder, code=NO_FEATURE)
        self.assertIn("no sharp curve", message)
        for name, content in (("empty", b""), ("text", b"hello\n"), ("binary", bytes(range(256)) * 10),
                              ("cut", (self.parts / "drilled_block.stp").read_bytes()[:3000])):
            path = self.folder / (name + ".stp")
            path.write_bytes(content)
            self.assertIn(str(path), self.run_tool(path, "-o", self.folder / "out", code=BAD_INPUT))
            self.assertFalse((self.folder / "out" / name).exists())
        self.run_tool(self.folder / "nowhere.stp", "-o", self.folder, code=BAD_INPUT)
        self.run_tool(self.folder, "-o", self.folder, code=BAD_INPUT)
        self.run_tool("-o", self.folder, code=USAGE_ERROR)
        self.run_tool(self.parts / "cone.stp", code=USAGE_ERROR)
        self.run_tool(self.parts / "cone.stp", "-o", self.folder, "--sharp-angle", "200", code=USAGE_ERROR)

    def test_batch(self):
        tree = self.folder / "tree"
        (tree / "below").mkdir(parents=True)
        shutil.copy(self.parts / "cone.stp", tree)
        shutil.copy(self.parts / "sphere.stp", tree / "below" / "ball.STEP")
        (tree / "bad.step").write_text("no part")
        result = self.execute(self.folder, "--batch", tree, "-o", "out", "--quantile-length", "20")
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        self.assertIn("1 cases made, 1 left out, 1 failed", result.stdout)
        self.assertIn("bad", result.stderr)
        self.assertEqual(sorted(p.name for p in (self.folder / "out" / "cone").iterdir()),
                         ["def.ply", "exact.ply", "noisy.ply", "truth.json"])


if __name__ == "__main__":
    main("tool", "part_writer")
