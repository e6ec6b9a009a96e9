"""What the tests that run the programs of this project from the outside share."""

import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

TIME_LIMIT = 280
SUCCESS, INTERNAL_ERROR, USAGE_ERROR, BAD_INPUT, NO_FEATURE, SOME_FAILED, BUSY = range(7)   # exit codes


def header_and_points(path):
    """The header of a cloud of make_cloud, as bytes, and the list of its (x, y, z, distance)."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    return data[:end], list(struct.iter_unpack("<4f", data[end:]))


def without_provenance(text):
    """Wireframe JSON without the line that says where it comes from, which names the input and the options."""
    return re.sub(r'(?m)^ "provenance":.*\n', "", text)


def read_cloud(path):
    return header_and_points(path)[1]


class Program_test(unittest.TestCase):
    """Every class has a folder, `shared`, and every test one of its own in it, `folder`, where programs are run."""
    tool = cloud_maker = None   # set by main()

    @classmethod
    def setUpClass(cls):
        cls.shared = pathlib.Path(tempfile.mkdtemp(prefix="test_wireframe_"))
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.shared))

    @classmethod
    def make_cloud(cls, path, *arguments):
        """The path is one in the folder of the class, unless it is absolute."""
        subprocess.run([cls.cloud_maker, *map(str, arguments), "-o", str(cls.shared / path)], check=True,
                       stdout=subprocess.DEVNULL, timeout=TIME_LIMIT)

    @classmethod
    def execute(cls, folder, *arguments, **options):
        """Runs the tool in a folder; returns the finished process, however it ended."""
        if "input" not in options:
            options["stdin"] = subprocess.DEVNULL
        return subprocess.run([cls.tool, *map(str, arguments)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding="utf-8", timeout=TIME_LIMIT, **options)

    def run_tool(self, *arguments, code=SUCCESS, **options):
        """Runs the tool, which has to end with this code; returns what it said, or its errors if it had to fail."""
        done = self.execute(self.folder, *arguments, **options)
        self.assertEqual(done.returncode, code, (done.args, done.stdout, done.stderr))
        return done.stdout if code == SUCCESS else done.stderr


def main(*names):
    """Takes paths of programs from the command line as attributes of the tests, in this order, and runs the tests."""
    if len(sys.argv) <= len(names):
        sys.exit(sys.modules["__main__"].__doc__)
    for name, path in zip(names, sys.argv[1:]):
        setattr(Program_test, name, os.path.abspath(path))
    unittest.main(module="__main__", argv=sys.argv[:1] + sys.argv[1 + len(names):])
