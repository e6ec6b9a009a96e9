#!/usr/bin/env python3
"""Tests that the tool extract_wireframe gives the same for a cloud that stays in its file as for one in memory.

usage: test_wireframe_streaming.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import os
import pathlib
import resource
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

TOOL = MAKE_CLOUD = None
TIME_LIMIT = 280
BAD_INPUT = 3
STREAMED = ("--points-in-memory", "2000")


def header_and_points(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    return data[:end], list(struct.iter_unpack("<4f", data[end:]))


class Streaming_test(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="wireframe_streaming_"))
        cls.make("box_with_hole", "--points", 20000, "-o", "poisson.ply")
        cls.make("box_with_hole", "--points", 20000, "--sampling", "uniform", "--field", "def", "-o", "random.ply")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def make(cls, *arguments):
        subprocess.run([MAKE_CLOUD, *map(str, arguments)], cwd=cls.folder, check=True, stdout=subprocess.DEVNULL,
                       timeout=TIME_LIMIT)

    def run_tool(self, *arguments, code=0, **options):
        done = subprocess.run([TOOL, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", timeout=TIME_LIMIT,
                              **options)
        self.assertEqual(done.returncode, code, (done.args, done.stdout, done.stderr))
        return done.stdout if code == 0 else done.stderr

    def wireframe(self, *arguments):
        self.run_tool(*arguments, "-o", "out.json")
        return (self.folder / "out.json").read_text()

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
        self.make("cylinder", "--points", 3000000, "--sampling", "uniform", "-o", "large.ply")

        def limit():
            resource.setrlimit(resource.RLIMIT_DATA, (200 << 20, 200 << 20))

        arguments = ("large.ply", "--threads", 1, "-o", "out.json")
        said = self.run_tool(*arguments, "--points-in-memory", 100000, preexec_fn=limit)
        self.assertIn("2 circles", said)
        (self.folder / "large.ply").unlink()


if __name__ == "__main__":
    TOOL, MAKE_CLOUD = (pathlib.Path(sys.argv[i]).resolve() for i in (1, 2))
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
