#!/usr/bin/env python3
"""Tests that the tool extract_wireframe gives the same for a cloud that stays in its file as for one in memory.

usage: test_wireframe_streaming_tool.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import os
import resource
import struct
import threading

from program_test import BAD_INPUT, Program_test, header_and_points, main, without_provenance

STREAMED = ("--points-in-memory", "2000")


class Streaming_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.make_cloud("poisson.ply", "box_with_hole", "--points", 20000)
        cls.make_cloud("random.ply", "box_with_hole", "--points", 20000, "--sampling", "uniform", "--field", "def")

    def setUp(self):
        self.folder = self.shared   # where these clouds are

    def wireframe(self, *arguments):
        self.run_tool(*arguments, "-o", "out.json")
        return without_provenance((self.folder / "out.json").read_text())

    def write_text(self, name, points):
        lines = (" ".join(map(repr, point)) + "\n" for point in points)
        (self.folder / name).write_text("".join(lines))

    def test_same_wireframe(self):
        for name in ("poisson", "random"):
            expected = self.wireframe(f"{name}.ply")
            self.assertEqual(self.wireframe(f"{name}.ply", *STREAMED), expected)
            header, points = header_and_points(self.folder / f"{name}.ply")
            self.write_text(f"{name}.xyz", points)
            self.assertEqual(self.wireframe(f"{name}.xyz", *STREAMED), expected)
            # as a scanner writes it; the origin differs in its last digit
            points.sort()
            (self.folder / "sorted.ply").write_bytes(header + b"".join(struct.pack("<4f", *p) for p in points))
            self.assertEqual(self.wireframe("sorted.ply", *STREAMED), self.wireframe("sorted.ply"))

    def test_separate_distances(self):
        _, points = header_and_points(self.folder / "poisson.ply")
        self.write_text("points.xyz", [p[:3] for p in points])
        self.write_text("distances.txt", [p[3:] for p in points])
        expected = self.wireframe("poisson.ply")
        self.assertEqual(self.wireframe("points.xyz", "--distances", "distances.txt", *STREAMED), expected)

    def test_pipe(self):
        """What can be read once only is held in memory."""
        expected = self.wireframe("poisson.ply")
        pipe = self.folder / "pipe.ply"
        os.mkfifo(pipe)
        writer = threading.Thread(target=lambda: pipe.write_bytes((self.folder / "poisson.ply").read_bytes()))
        writer.start()
        self.assertEqual(self.wireframe("pipe.ply", *STREAMED), expected)
        writer.join()

    def test_bad_files(self):
        """Messages do not depend on how a file is read, and nothing is written."""
        _, points = header_and_points(self.folder / "poisson.ply")
        self.write_text("negative.xyz", points[:7000] + [(0., 0., 0., -1.)] + points[7000:])
        text = (self.folder / "negative.xyz").read_text().replace(" -1.0\n", "\n")
        (self.folder / "short.xyz").write_text(text)
        data = (self.folder / "poisson.ply").read_bytes()
        (self.folder / "cut.ply").write_bytes(data[:len(data) // 2])
        for name, word in (("negative.xyz", "point 7000 (counted from 0, line 7001)"),
                           ("short.xyz", "short.xyz:7001: "), ("cut.ply", "truncated"), ("none.ply", "none.ply")):
            message = self.run_tool(name, "-o", "bad.json", code=BAD_INPUT)
            self.assertEqual(self.run_tool(name, *STREAMED, "-o", "bad.json", code=BAD_INPUT), message)
            self.assertIn(word, message)
        self.assertFalse((self.folder / "bad.json").exists())
        expected = self.wireframe("poisson.ply")
        for memory in ((), STREAMED):
            self.assertEqual(self.wireframe("negative.xyz", "--skip-invalid", *memory), expected)
        self.assertIn("1 more skipped", self.run_tool("negative.xyz", "--skip-invalid", *STREAMED, "-o", "out.json"))

    def test_memory(self):
        """Three million points, 48 MB, are read with hardly more memory than the tool itself takes."""
        self.make_cloud("large.ply", "cylinder", "--points", 3000000, "--sampling", "uniform")

        def limit():
            resource.setrlimit(resource.RLIMIT_DATA, (200 << 20, 200 << 20))

        arguments = ("large.ply", "--threads", 1, "-o", "out.json")
        said = self.run_tool(*arguments, "--points-in-memory", 100000, preexec_fn=limit)
        self.assertIn("2 circles", said)
        (self.folder / "large.ply").unlink()


if __name__ == "__main__":
    main("tool", "cloud_maker")
