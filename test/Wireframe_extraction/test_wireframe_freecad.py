#!/usr/bin/env python3
"""Tests with FreeCAD that a CAD program finds the curves in what write_wireframe() writes.

usage: test_wireframe_freecad.py FREECADCMD TEST_WIREFRAME_CAD [options of unittest]
"""

import collections
import json
import os
import subprocess

from program_test import Program_test, main

# of the sample that test_wireframe_cad writes
EXPECTED = {"Part::GeomLine": 4, "Part::GeomCircle": 3, "Part::GeomEllipse": 2, "Part::GeomBSplineCurve": 4}

# What FreeCAD runs. In a script of its own, as its Python may be another one than ours.
SCRIPT = """
import json, os
import FreeCAD, Part, Import
folder = os.environ["WIREFRAME_FOLDER"]
result = {}
for name in ("sample.step", "sample.iges", "sample.brep"):
    path = os.path.join(folder, name)
    shape = Part.Shape()
    shape.read(path)
    result[name] = {"edges": [(edge.Curve.TypeId, edge.Length) for edge in shape.Edges],
                    "wires": [(len(wire.Edges), wire.isClosed()) for wire in shape.Wires]}
document = FreeCAD.newDocument("imported")
Import.insert(os.path.join(folder, "sample.step"), "imported")
result["imported"] = [edge.Curve.TypeId for thing in document.Objects
                      if thing.isDerivedFrom("Part::Feature") for edge in thing.Shape.Edges]
with open(os.path.join(folder, "result.json"), "w") as file:
    json.dump(result, file)
"""


class Freecad_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        names = [str(cls.shared / name) for name in ("sample.step", "sample.iges", "sample.brep")]
        subprocess.run([cls.sample_writer, *names], check=True, timeout=120)
        (cls.shared / "script.py").write_text(SCRIPT)
        environment = dict(os.environ, WIREFRAME_FOLDER=str(cls.shared), HOME=str(cls.shared),
                           QT_QPA_PLATFORM="offscreen")
        done = subprocess.run([cls.freecad, str(cls.shared / "script.py")], env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=240)
        result = cls.shared / "result.json"
        if not result.exists():
            raise AssertionError(f"FreeCAD wrote no result, but said:\n{done.stdout}")
        cls.result = json.loads(result.read_text())

    def test_kinds(self):
        for name in ("sample.step", "sample.iges", "sample.brep"):
            with self.subTest(name):
                kinds = collections.Counter(kind for kind, _ in self.result[name]["edges"])
                self.assertEqual(dict(kinds), EXPECTED)

    def test_lengths(self):
        """The formats agree, and the arc has the length that it should have."""
        step, iges, brep = (sorted(length for _, length in self.result[name]["edges"])
                            for name in ("sample.step", "sample.iges", "sample.brep"))
        for a, b, c in zip(step, iges, brep):
            self.assertAlmostEqual(a, b, delta=1e-6)
            self.assertAlmostEqual(a, c, delta=1e-6)
        arcs = [length for kind, length in self.result["sample.step"]["edges"] if kind == "Part::GeomCircle"]
        self.assertAlmostEqual(min(arcs), 3.141592653589793, delta=1e-6)   # a quarter, of radius 2

    def test_loop(self):
        for name in ("sample.step", "sample.iges", "sample.brep"):
            with self.subTest(name):
                self.assertIn([4, True], self.result[name]["wires"])

    def test_import(self):
        """The way a user opens it."""
        self.assertEqual(dict(collections.Counter(self.result["imported"])), EXPECTED)


if __name__ == "__main__":
    main("freecad", "sample_writer")
