#!/usr/bin/env python3
"""Tests what the tool extract_wireframe makes of clouds without distances.

usage: test_wireframe_raw_tool.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import csv
import json
import os
import struct
import threading

from program_test import BAD_INPUT, NO_FEATURE, USAGE_ERROR, Program_test, header_and_points, main, without_provenance

ESTIMATED = "estimated from the points"


class Raw_cloud_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_cloud("box.ply", "box", "--r", 0.09)
        cls.make_cloud("raw.ply", "box", "--r", 0.09, "--without-distances")
        data = (cls.shared / "raw.ply").read_bytes()
        end = data.index(b"end_header\n") + len(b"end_header\n")
        cls.points = list(struct.iter_unpack("<3f", data[end:]))
        cls.expected = None

    def setUp(self):
        super().setUp()
        for name in ("box.ply", "raw.ply"):
            os.link(self.shared / name, self.folder / name)

    def wireframe(self, *arguments):
        """What the tool says, and the wireframe it writes, as text."""
        said = self.run_tool(*arguments, "-o", "out.json")
        return said, without_provenance((self.folder / "out.json").read_text())

    def raw_wireframe(self):
        if Raw_cloud_test.expected is None:
            said, Raw_cloud_test.expected = self.wireframe("raw.ply")
            self.assertIn(ESTIMATED, said)
            self.assertIn("points near features", said)
            self.assertNotIn("Note", said)
            result = json.loads(self.expected)
            self.assertEqual((len(result["vertices"]), len(result["curves"])), (8, 12))
        return self.expected

    def write_text(self, name, rows, first=""):
        (self.folder / name).write_text(first + "".join(" ".join(map(repr, row)) + "\n" for row in rows))

    def check_raw(self, name, *notes, options=()):
        said, wireframe = self.wireframe(name, *options)
        self.assertIn(ESTIMATED, said)
        for note in notes:
            self.assertIn(note, said)
        if not notes:
            self.assertNotIn("Note", said)
        self.assertEqual(wireframe, self.raw_wireframe())

    def test_field(self):
        given = self.wireframe("box.ply")
        self.assertNotIn(ESTIMATED, given[0])
        self.assertEqual(self.wireframe("box.ply", "--field", "given")[1], given[1])
        self.check_raw("box.ply", options=("--field", "estimated"))
        self.check_raw("raw.ply", options=("--field", "auto"))
        error = self.run_tool("raw.ply", "--field", "given", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn("no property for the distance", error)
        self.assertIn("--field", error)
        # who names distances wants them
        error = self.run_tool("raw.ply", "--distance-property", "d", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn('no property "d"', error)
        self.assertFalse((self.folder / "bad.json").exists())

    def test_options(self):
        for arguments in (("--field", "estimated", "--distances", "d.txt"),
                          ("--field", "estimated", "--distance-property", "d"),
                          ("--field", "estimated", "--patches"), ("--field", "none"),
                          ("--field", "given", "--write-field", "f.ply"),
                          ("--minimum-fold", 0), ("--minimum-fold", 181), ("--write-field", "f.txt"),
                          ("--write-field", "none/f.ply"), ("--write-field", "raw.ply")):
            self.run_tool("raw.ply", *arguments, "-o", "bad.json", code=USAGE_ERROR)
        self.assertIn("--field", self.run_tool("--help"))

    def test_minimum_fold(self):
        error = self.run_tool("raw.ply", "--minimum-fold", 150, "-o", "bad.json", code=NO_FEATURE)
        self.assertIn("no fold of 150 degrees", error)
        self.assertIn("--minimum-fold", error)
        self.assertNotIn("--skeleton-distance", error)

    def test_text(self):
        points = self.points
        self.write_text("raw.xyz", points)
        self.check_raw("raw.xyz")
        self.write_text("count.pts", points, first=f"{len(points)}\n")
        self.check_raw("count.pts")
        self.write_text("named.txt", points, first="x y z\n")
        self.check_raw("named.txt")
        self.write_text("normals.xyz", [(*p, 0., 0.6, -0.8) for p in points])
        self.check_raw("normals.xyz", "columns 4 to 6 are taken for a normal", "--distance-property")
        self.write_text("named_normals.xyz", [(*p, 0., 0.6, -0.8) for p in points], first="x y z nx ny nz\n")
        self.check_raw("named_normals.xyz")
        self.write_text("commented.xyz", [(*p, 0., 0.6, -0.8) for p in points], first="# x y z nx ny nz\n")
        self.check_raw("commented.xyz")
        self.write_text("colours.txt", [(*p, 200, 31, 0) for p in points])
        self.check_raw("colours.txt", "columns 4 to 6 are taken for a colour")
        self.write_text("scan.pts", [(*p, -1200, 200, 31, 0) for p in points], first=f"{len(points)}\n")
        self.check_raw("scan.pts", "columns 5 to 7 are taken for a colour")
        self.write_text("intensity.txt", [(*p, 0.5) for p in points], first="x y z intensity\n")
        self.check_raw("intensity.txt", '"intensity" is no distance', "--distance-property")

    def test_text_of_other_programs(self):
        self.write_text("axes.xyz", [(*p, 0, 0, 1) if i % 2 else (*p, 0, 0, 0) for i, p in enumerate(self.points)])
        self.check_raw("axes.xyz", "columns 4 to 6 are taken for a normal")
        self.write_text("cloudcompare.txt", [(*p, 200, 31, 0, 0., 0.6, -0.8) for p in self.points])
        self.check_raw("cloudcompare.txt", "columns 4 to 6 are taken for a colour")
        self.write_text("header.txt", [(*p, 200, 31, 0, 0.25) for p in self.points], first="//X Y Z R G B far\n")
        self.check_raw("header.txt", "none of far is known to be a distance")
        body = "".join("%r %r %r 1 0.25\n" % p for p in self.points)
        (self.folder / "far.ply").write_text(
            f"ply\nformat ascii 1.0\nelement vertex {len(self.points)}\n" + "".join(
                f"property float {name}\n" for name in ("x", "y", "z", "confidence", "far")) + "end_header\n" + body)
        self.check_raw("far.ply", "none of far is known to be a distance")
        (self.folder / "far.pcd").write_text(
            "VERSION 0.7\nFIELDS x y z intensity far\nSIZE 4 4 4 4 4\nTYPE F F F F F\nCOUNT 1 1 1 1 1\n"
            f"WIDTH {len(self.points)}\nHEIGHT 1\nPOINTS {len(self.points)}\nDATA ascii\n" + body)
        self.check_raw("far.pcd", "none of far is known to be a distance")
        rows = "".join("%r,%r,%r\n" % p for p in self.points)
        (self.folder / "paraview.csv").write_text('"Points:0","Points:1","Points:2"\n' + rows)
        self.check_raw("paraview.csv")
        (self.folder / "other.csv").write_text("east,north,up\n" + rows)
        error = self.run_tool("other.csv", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn("the columns of x, y and z cannot all be found", error)
        self.assertIn("east, north, up", error)

    def test_text_with_distances(self):
        """What was read before is read as before, and what may be either is not guessed."""
        _, samples = header_and_points(self.folder / "box.ply")
        expected = self.wireframe("box.ply")[1]
        self.write_text("four.xyz", samples)
        said, wireframe = self.wireframe("four.xyz")
        self.assertEqual(wireframe, expected)
        self.assertNotIn("Note", said)
        self.write_text("five.xyz", [(*s, 7.) for s in samples])
        said, wireframe = self.wireframe("five.xyz")
        self.assertEqual(wireframe, expected)
        self.assertIn("column 4 of 5 is taken for the distance", said)
        self.write_text("named.xyz", samples, first="x y z d\n")
        said, wireframe = self.wireframe("named.xyz")
        self.assertEqual(wireframe, expected)
        self.assertIn('the column "d" is taken for the distance', said)
        self.write_text("seven.xyz", [(*s[:3], 0., 0.6, -0.8, s[3]) for s in samples])
        error = self.run_tool("seven.xyz", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn("--distance-property", error)
        self.assertEqual(self.wireframe("seven.xyz", "--distance-property", 7)[1], expected)
        self.check_raw("seven.xyz", options=("--field", "estimated"))
        self.write_text("other.xyz", [(*s, 1.) for s in samples], first="x y z d e\n")
        self.check_raw("other.xyz", "none of d, e is known to be a distance", "--distance-property")

    def test_formats(self):
        rows = "".join("%r %r %r\n" % p for p in self.points)
        n = len(self.points)
        (self.folder / "raw.off").write_text(f"OFF\n{n} 0 0\n{rows}")
        self.check_raw("raw.off")
        (self.folder / "raw.pcd").write_text("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                                             f"WIDTH {n}\nHEIGHT 1\nPOINTS {n}\nDATA ascii\n{rows}")
        self.check_raw("raw.pcd")
        (self.folder / "ascii.ply").write_text(f"ply\nformat ascii 1.0\nelement vertex {n}\nproperty double x\n"
                                               f"property double y\nproperty double z\nend_header\n{rows}")
        self.check_raw("ascii.ply")
        for columns, name in ((3, "raw.npy"), (6, "normals.npy")):
            header = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, %d), }" % (n, columns)
            header += " " * (63 - (10 + len(header)) % 64) + "\n"
            values = b"".join(struct.pack(f"<{columns}d", *p, *[0.6] * (columns - 3)) for p in self.points)
            (self.folder / name).write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
                                             + values)
        self.check_raw("raw.npy")
        self.check_raw("normals.npy", "the last three of its six columns are not looked at")
        for name, word in (("raw.off", "no distances"), ("raw.pcd", "no field for the distance"),
                           ("raw.npy", "no distances")):
            error = self.run_tool(name, "--field", "given", "-o", "bad.json", code=BAD_INPUT)
            self.assertIn(word, error)
            self.assertRegex(error, r"--field(?!-)")

    def test_scanned_mesh(self):
        """The vertices of a mesh that is a scan are a cloud without distances."""
        vertices = "".join("v %r %r %r\n" % p for p in self.points)
        (self.folder / "scan.obj").write_text(vertices + "f 1 2 3\nf 2 3 4\n")
        self.check_raw("scan.obj", "taken for a scan", options=("--mesh", "scan"))
        error = self.run_tool("scan.obj", "--mesh", "scan", "--field", "given", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn("--field", error)
        # in STL, every triangle has vertices of its own, which are points once only
        points = [tuple(struct.unpack("<3f", struct.pack("<3f", *p))) for p in self.points]
        corners = [points[i:i + 3] for i in range(len(points) - 2)]
        (self.folder / "scan.stl").write_bytes(bytes(80) + struct.pack("<I", len(corners)) + b"".join(
            struct.pack("<12f", 0, 0, 0, *(x for p in face for x in p)) + bytes(2) for face in corners))
        said, _ = self.wireframe("scan.stl", "--mesh", "scan")
        self.assertRegex(said, rf"Points +{len(points)}\n")
        self.assertIn("taken for a scan", said)

    def test_write_field(self):
        said = self.run_tool("raw.ply", "--write-field", "field.ply", "-o", "out.json")
        self.assertIn("field.ply", said)
        data = (self.folder / "field.ply").read_bytes()
        end = data.index(b"end_header\n") + len(b"end_header\n")
        header = data[:end].decode()
        rows = list(struct.iter_unpack("<5d", data[end:]))
        self.assertEqual([row[:3] for row in rows], self.points)
        self.assertTrue(all(row[3] >= 0 and row[4] > 0 for row in rows))
        values = dict(line.split()[1:] for line in header.splitlines() if line.startswith("comment"))
        _, wireframe = self.wireframe("field.ply", "--field", "given", "--sampling-distance",
                                      values["sampling_distance"], "--noise-level", values["noise_level"])
        self.assertEqual(wireframe, self.raw_wireframe())
        # the tool reads them back by itself, and says so, unless others are given
        said, wireframe = self.wireframe("field.ply")
        self.assertEqual(wireframe, self.raw_wireframe())
        self.assertRegex(said, r"(?m)^r +\S+ \(from the file\)$")
        self.assertRegex(said, r"(?m)^Noise .*\(from the file\)$")
        said, _ = self.wireframe("field.ply", "--sampling-distance", 0.06, "--noise-level", 0.1)
        self.assertRegex(said, r"(?m)^r +0.06 \(given\)$")
        self.assertNotIn("from the file", said)
        for options in (("--distance-property", "deviation"), ("--field", "estimated")):
            done = self.execute(self.folder, "field.ply", "-o", "other.json", *options)
            self.assertNotIn("from the file", done.stdout)
        if "needs libpng" not in self.run_tool("--version"):   # the same colours
            self.run_tool("raw.ply", "--png", "raw.png")
            self.run_tool("field.ply", "--png", "field.png")
            self.assertEqual((self.folder / "raw.png").read_bytes(), (self.folder / "field.png").read_bytes())
        self.run_tool("raw.ply", "--write-field", "alone.ply")   # is enough
        self.assertEqual((self.folder / "alone.ply").read_bytes(), data)
        error = self.run_tool("box.ply", "--write-field", "bad.ply", "-o", "bad.json", code=USAGE_ERROR)
        self.assertIn("--field estimated", error)
        self.assertFalse(list(self.folder.glob("bad.*")))
        self.run_tool("box.ply", "--field", "estimated", "--write-field", "box_field.ply")
        self.assertEqual((self.folder / "box_field.ply").read_bytes(), data)

    def test_skipped(self):
        self.write_text("bad.xyz", self.points[:5] + [(float("nan"), 0., 0.)] + self.points[5:])
        error = self.run_tool("bad.xyz", "-o", "bad.json", code=BAD_INPUT)
        self.assertIn("point 5 (counted from 0", error)
        said = self.run_tool("bad.xyz", "--skip-invalid", "-o", "out.json", "--write-field", "field.ply")
        self.assertIn("1 more skipped", said)
        self.assertEqual(without_provenance((self.folder / "out.json").read_text()), self.raw_wireframe())
        self.assertIn(f"element vertex {len(self.points)}\n".encode(), (self.folder / "field.ply").read_bytes())

    def test_stages(self):
        self.run_tool("raw.ply", "--stages", "stages", "-o", "out.json")
        names = sorted(path.name for path in (self.folder / "stages").iterdir())
        self.assertEqual(names[:2], ["0_field.ply", "1_skeleton.ply"])
        self.assertEqual(len(names), 7)
        self.assertIn(f"element vertex {len(self.points)}\n".encode(),
                      (self.folder / "stages" / "0_field.ply").read_bytes())
        # the next cloud has distances, and no file of the one before stays
        self.run_tool("box.ply", "--stages", "stages", "-o", "out.json")
        self.assertFalse((self.folder / "stages" / "0_field.ply").exists())

    def test_memory_and_pipe(self):
        self.check_raw("raw.ply", options=("--points-in-memory", 1000))
        os.mkfifo(self.folder / "pipe.ply")
        writer = threading.Thread(target=lambda: (self.folder / "pipe.ply").write_bytes(
            (self.folder / "raw.ply").read_bytes()))
        writer.start()
        self.check_raw("pipe.ply")
        writer.join()

    def test_batch(self):
        (self.folder / "list.txt").write_text("raw.ply\nbox.ply\n")
        batch = ("--batch", "list.txt", "--output-dir", "out", "--jobs", 1)
        self.run_tool(*batch)
        self.assertEqual(without_provenance((self.folder / "out/raw.json").read_text()), self.raw_wireframe())
        self.assertNotEqual(without_provenance((self.folder / "out/box.json").read_text()), self.raw_wireframe())
        self.run_tool(*batch, "--field", "estimated")   # other options: done again
        self.assertEqual(without_provenance((self.folder / "out/box.json").read_text()), self.raw_wireframe())
        with open(self.folder / "out/summary.csv", newline="") as file:
            self.assertEqual([row["status"] for row in csv.DictReader(file)], ["ok", "ok"])
        self.run_tool(*batch, "--write-field", "f.ply", code=USAGE_ERROR)


if __name__ == "__main__":
    main("tool", "cloud_maker")
