"""What the tests of make_abc_case and make_step_case share."""

import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

SUCCESS, INTERNAL_ERROR, USAGE_ERROR, BAD_INPUT, NO_SHARP_CURVE = range(5)


def read_cloud(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    return list(struct.iter_unpack("<4f", data[end:]))


class Case_test(unittest.TestCase):
    """Every test has a folder of its own. The module of a derived class sets `tool`."""
    tool = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_tool(self, *arguments, code=SUCCESS):
        result = subprocess.run([self.tool, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                universal_newlines=True, timeout=120)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout if code == SUCCESS else result.stderr
