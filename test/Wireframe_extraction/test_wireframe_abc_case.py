#!/usr/bin/env python3
"""Tests make_abc_case from the outside, on a shape in the format of the ABC dataset that was made for this
(data/abc_style/make_channel.py says what it looks like): all that is expected here follows from its drawing.

usage: test_wireframe_abc_case.py MAKE_ABC_CASE [options of unittest]
"""

import collections
import json
import math
import pathlib
import shutil

from program_test import BAD_INPUT, NO_FEATURE, SUCCESS, USAGE_ERROR, Program_test, main, read_cloud

DATA = pathlib.Path(__file__).resolve().parent / "data" / "abc_style"
MESH, FEATURES = DATA / "channel.obj", DATA / "channel.yml"
R = 0.02
QUARTILE = 0.8                       # of the lengths of the 28 sharp curves
SMALL = ["--quantile-length", "20"]  # small clouds, for speed


def spacings(cloud, r):
    """The distance of every point to its nearest neighbour, as far as that is below 3 r."""
    cells = collections.defaultdict(list)
    for i, p in enumerate(cloud):
        cells[tuple(int(c // (3 * r)) for c in p[:3])].append(i)
    around = [(i, j, k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
    return [min(math.dist(p[:3], cloud[j][:3])
                for d in around for j in cells.get(tuple(int(c // (3 * r)) + s for c, s in zip(p[:3], d)), ())
                if i != j) for i, p in enumerate(cloud)]


class Abc_case_test(Program_test):
    def make(self, *arguments):
        self.run_tool(MESH, FEATURES, "-o", self.folder, *arguments)
        case = self.folder / "channel"
        return json.loads((case / "truth.json").read_text()), read_cloud(case / "exact.ply")

    def write_pair(self, mesh, features, name="bad"):
        (self.folder / (name + ".obj")).write_text(mesh)
        (self.folder / (name + ".yml")).write_text(features)
        return self.folder / (name + ".obj"), self.folder / (name + ".yml")

    def assert_bad(self, mesh, features, *words, code=BAD_INPUT):
        message = self.run_tool(*self.write_pair(mesh, features), "-o", self.folder / "out", code=code)
        for word in words:
            self.assertIn(word, message)
        self.assertFalse((self.folder / "out" / "bad").exists())

    # ---- a good shape

    def test_truth(self):
        truth, cloud = self.make(*SMALL, "--fields", "exact")
        scale = 20 * R / QUARTILE
        self.assertEqual(truth["r"], R)
        self.assertEqual(truth["points"], len(cloud))
        self.assertEqual((len(truth["segments"]), len(truth["curves"]), len(truth["corners"])), (28, 23, 14))
        kinds = collections.Counter(s["kind"] for s in truth["segments"])
        self.assertEqual(kinds, {"line": 23, "arc": 4, "circle": 1})
        # lines and the round of the profile are one curve, and the two arcs of the hole a closed one
        self.assertEqual(sorted((c["kind"], c["closed"]) for c in truth["curves"] if c["kind"] != "line"),
                         [("circle", True), ("composite", False), ("composite", False), ("composite", True)])
        total = sum(s["length"] for s in truth["segments"]) / scale
        expected = 2 * (1.7 + 0.15 * math.pi + 0.9 + 0.3 + 0.8 + 1.6 + 0.8 + 0.1 + 1.2) + 7 * 2 + 1.4 * math.pi
        self.assertAlmostEqual(total, expected, delta=0.005)
        corners = sorted(tuple(round(x / scale, 4) + 0. for x in c) for c in truth["corners"])
        profile = [(0, 0), (0, 1.2), (0.1, 0.4), (0.1, 1.2), (1.7, 0.4), (1.7, 1.2), (2, 1.2)]
        self.assertEqual(corners, sorted((x, y, z) for x, z in profile for y in (0, 2)))
        for curve in truth["curves"] + truth["segments"]:
            self.assertLess(max(map(math.dist, curve["points"], curve["points"][1:])), 0.2501 * R)
            self.assertEqual(curve["closed"], curve["points"][0] == curve["points"][-1])

    def test_scale_and_spacing(self):
        for r, quantile, length, shortest in ((0.02, 0.25, 20, QUARTILE), (0.5, 0, 4, 0.1), (0.02, 1, 30, 0.7 * math.pi)):
            truth, cloud = self.make("--r", r, "--quantile", quantile, "--quantile-length", length, "--fields",
                                     "exact", "--force")
            self.assertAlmostEqual(max(p[1] for p in cloud) / 2, length * r / shortest, delta=0.002 * length * r / shortest)
            found = spacings(cloud, r)
            self.assertGreater(min(found), 0.89 * r)
            self.assertLess(max(found), 2 * r)
            self.assertAlmostEqual(sum(found) / len(found), r, delta=0.04 * r)

    def test_distances(self):
        truth, cloud = self.make(*SMALL, "--fields", "exact")
        scale = 20 * R / QUARTILE
        counts = collections.Counter()
        for x, y, z, d in ([c / scale for c in p] for p in cloud):
            ends = min(y, 2 - y)
            from_hole = abs(math.hypot(x - 0.9, y - 1) - 0.35)
            if x < 1e-5:      # the thin wall from outside: the edge at (0.1, 0.4) and the hole belong to no neighbour
                counts["wall"] += 1
                self.assertAlmostEqual(d, min(ends, z, 1.2 - z), delta=1e-4)
                counts["behind the wall"] += math.hypot(0.1, z - 0.4) < d - 0.1
            elif abs(z - 0.4) < 1e-5 and 0.1 < x < 1.7 and 1e-5 < y < 2 - 1e-5 and from_hole > 0.01:
                counts["floor"] += 1
                self.assertAlmostEqual(d, min(ends, x - 0.1, 1.7 - x, from_hole), delta=0.002)
            elif x > 1.71 and z < 0.29 and ends < 0.5:    # the round: its smooth edges do not count
                counts["round"] += 1
                if 1e-5 < y < 2 - 1e-5:
                    self.assertAlmostEqual(d, ends, delta=0.002)
            elif x > 2 - 1e-5:
                counts["right"] += 1
                self.assertAlmostEqual(d, min(ends, math.hypot(1.2 - z, 0)), delta=1e-4)
        for face in ("wall", "behind the wall", "floor", "round", "right"):
            self.assertGreater(counts[face], 20, face)

    def test_scope_and_truncation(self):
        _, cloud = self.make(*SMALL, "--fields", "exact", "--field-scope", "all", "--truncate", "7")
        scale = 20 * R / QUARTILE
        self.assertAlmostEqual(max(p[3] for p in cloud), 7 * R, delta=1e-6)
        for x, y, z, d in ([c / scale for c in p] for p in cloud):
            if x < 1e-5:   # now the edge behind the wall is seen
                self.assertAlmostEqual(d, min(y, 2 - y, z, 1.2 - z, math.hypot(0.1, z - 0.4), 7 * R / scale), delta=1e-4)

    def test_fields(self):
        _, exact = self.make(*SMALL)
        for field, share, moved in (("def", 0.2, 0), ("noisy", 0.35, 0.25)):
            cloud = read_cloud(self.folder / "channel" / (field + ".ply"))
            self.assertEqual(len(cloud), len(exact))
            off = sum(abs(a[3] - b[3]) > R for a, b in zip(cloud, exact)) / len(exact)
            self.assertAlmostEqual(off, share, delta=0.05)
            step = math.sqrt(sum(math.dist(a[:3], b[:3]) ** 2 for a, b in zip(cloud, exact)) / len(exact) / 3)
            self.assertAlmostEqual(step, moved * R, delta=0.01 * R)

    def test_same_seed_same_bytes(self):
        clouds = []
        for seed in ("1", "1", "2"):
            self.make(*SMALL, "--seed", seed, "--force")
            clouds.append([(self.folder / "channel" / (f + ".ply")).read_bytes() for f in ("exact", "def", "noisy")])
        self.assertEqual(clouds[0], clouds[1])
        self.assertNotEqual(clouds[0], clouds[2])

    def test_too_many_points(self):
        truth, cloud = self.make("--max-points", "2000", "--fields", "exact")
        self.assertLessEqual(len(cloud), 2000)
        self.assertGreater(len(cloud), 1900)
        found = spacings(cloud, R)
        self.assertAlmostEqual(sum(found) / len(found), R, delta=0.05 * R)
        message = self.run_tool(MESH, FEATURES, "-o", self.folder, "--max-points", "2000", "--force")
        self.assertIn("coarser", message)
        result = self.execute(self.folder, MESH, FEATURES, "-o", "other", "--max-points", "2000", "--too-many", "skip")
        self.assertEqual(result.returncode, SUCCESS)
        self.assertIn("left out", result.stderr)
        self.assertFalse((self.folder / "other" / "channel").exists())

    def test_existing(self):
        self.make(*SMALL, "--fields", "exact")
        self.assertIn("--force", self.run_tool(MESH, FEATURES, "-o", self.folder, code=USAGE_ERROR))
        self.make(*SMALL, "--fields", "exact", "--force")
        self.run_tool(MESH, FEATURES, "-o", self.folder, "--name", "other", "--fields", "exact", *SMALL)
        self.assertTrue((self.folder / "other" / "truth.json").exists())

    # ---- a whole dataset

    def test_batch(self):
        tree, out = self.folder / "dataset", self.folder / "out"
        names = {"00000001": ("a", "b"), "00000002": ("a", "a"), "00000003": ("a", "b"), "00000004": ("a", None)}
        for number, (mesh_folder, feature_folder) in names.items():
            for folder, source, kind in ((mesh_folder, MESH, "trimesh"), (feature_folder, FEATURES, "features")):
                if folder:
                    place = tree / folder / number
                    place.mkdir(parents=True, exist_ok=True)
                    shutil.copy(source, place / ("%s_0a1b_%s_000%s" % (number, kind, source.suffix)))
        bad = tree / "b" / "00000003" / "00000003_0a1b_features_000.yml"
        bad.write_text(bad.read_text()[:3000])
        result = self.execute(self.folder, "--batch", tree, "-o", out, "--fields", "exact", *SMALL)
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        self.assertIn("2 cases made, 0 left out, 2 failed", result.stdout)
        self.assertIn("00000003_0a1b_000", result.stderr)
        self.assertIn("00000004_0a1b_000", result.stderr)
        self.assertEqual(sorted(p.name for p in out.iterdir()), ["00000001_0a1b_000", "00000002_0a1b_000"])
        bad.write_text(FEATURES.read_text())
        (tree / "a" / "00000004" / "00000004_0a1b_trimesh_000.obj").unlink()
        (out / "00000001_0a1b_000" / "truth.json").unlink()   # as if it had been interrupted
        message = self.run_tool("--batch", tree, "-o", out, "--fields", "exact", "--skip-existing", *SMALL)
        self.assertIn("2 cases made, 1 left out, 0 failed", message)

    def test_empty_batch(self):
        self.assertIn("no OBJ file", self.run_tool("--batch", self.folder, "-o", self.folder / "out", code=BAD_INPUT))
        self.run_tool("--batch", self.folder / "nowhere", "-o", self.folder / "out", code=USAGE_ERROR)

    # ---- bad shapes

    def test_usage(self):
        self.run_tool(code=USAGE_ERROR)
        self.run_tool(MESH, FEATURES, code=USAGE_ERROR)
        self.run_tool(MESH, "-o", self.folder, code=USAGE_ERROR)
        self.run_tool(MESH, FEATURES, "--batch", DATA, "-o", self.folder, code=USAGE_ERROR)
        for option in (("--quantile", "2"), ("--r", "0"), ("--r", "nan"), ("--max-points", "3"), ("--fields", "other"),
                       ("--too-many", "cry"), ("--seed", "x"), ("--truncate", "-1")):
            self.run_tool(MESH, FEATURES, "-o", self.folder, *option, code=USAGE_ERROR)
        (self.folder / "file").write_text("")
        self.run_tool(MESH, FEATURES, "-o", self.folder / "file", *SMALL, code=USAGE_ERROR)
        self.run_tool("--help")

    def test_bad_meshes(self):
        mesh, features = MESH.read_text(), FEATURES.read_text()
        lines = mesh.split("\n")
        first_face = next(i for i, line in enumerate(lines) if line.startswith("f"))

        def with_line(i, text):
            return "\n".join(lines[:i] + [text] + lines[i + 1:])
        self.assert_bad(with_line(3, "v 1 2"), features, "bad.obj:4:", "three finite numbers")
        self.assert_bad(with_line(3, "v 1 2 nan"), features, "bad.obj:4:", "three finite numbers")
        self.assert_bad(with_line(first_face, "f 1 2 3 4"), features, "bad.obj:%d:" % (first_face + 1), "triangulate")
        self.assert_bad(with_line(first_face, "f 1 2 999"), features, "bad.obj:%d:" % (first_face + 1), "999")
        self.assert_bad(with_line(first_face, "f 0 1 2"), features, "bad.obj:%d:" % (first_face + 1))
        self.assert_bad(with_line(first_face, "f a b c"), features, "bad.obj:%d:" % (first_face + 1))
        self.assert_bad("", features, "no faces")
        self.assert_bad("\n".join(lines[:-2]), features, "belong together")     # one face less
        self.assert_bad(mesh + "f 1 2 3\n", features, "belongs to no surface")   # one more
        self.run_tool(self.folder / "nowhere.obj", FEATURES, "-o", self.folder, code=BAD_INPUT)
        self.run_tool(MESH, self.folder / "nowhere.yml", "-o", self.folder, code=BAD_INPUT)
        self.run_tool(DATA, FEATURES, "-o", self.folder, code=BAD_INPUT)

    def test_bad_features(self):
        mesh, features = MESH.read_text(), FEATURES.read_text()
        line = features.split("\n").index("  vert_indices: [0, 1]") + 1
        self.assert_bad(mesh, features.replace("vert_indices: [0, 1]", "vert_indices: [0, x]", 1),
                        "bad.yml:%d:" % line, "'x'")
        self.assert_bad(mesh, features.replace("vert_indices: [0, 1]", "vert_indices: 0", 1), "bad.yml:%d:" % line)
        self.assert_bad(mesh, features.replace("vert_indices: [0, 1]", "vert_indices: [0, 1000]", 1), "curve 0", "1000")
        self.assert_bad(mesh, features.replace("vert_indices: [0, 1]", "vert_indices: [0, 40]", 1), "curve 0",
                        "no edge of")
        self.assert_bad(mesh, features.replace("- sharp: true", "- dull: true", 1), "bad.yml:3:", "sharp")
        self.assert_bad(mesh, features.replace("sharp: true", "sharp: perhaps", 1), "bad.yml:3:", "perhaps")
        self.assert_bad(mesh, features.replace("surfaces:", "patches:"), "surfaces")
        self.assert_bad(mesh, features.replace("face_indices: [0,", "face_indices: [271, 0,", 1), "face 271")
        self.assert_bad(mesh, features[:3000], "bad.yml:", "complete")
        self.assert_bad(mesh, "", "surfaces")
        self.assert_bad(mesh, "\0\1\2[[[{", "bad.yml")
        self.assert_bad(mesh, "[1, 2]", "surfaces")
        self.assert_bad(mesh, features.replace("sharp: true", "sharp: false"), "no sharp curve", code=NO_FEATURE)


if __name__ == "__main__":
    main("tool")
