#!/usr/bin/env python3
"""Reads what the writers of wireframes wrote with readers of others, and compares it with the true curves.

usage: test_wireframe_formats_read.py TEST_WIREFRAME_FORMATS [options of unittest]

TEST_WIREFRAME_FORMATS is the test program of that name, which writes the files. ezdxf (Debian: python3-ezdxf) reads
DXF; VTK (Debian: python3-vtk9) reads its own format and glTF, and these tests are skipped where it is missing.
"""

import base64
import bisect
import csv
import heapq
import itertools
import json
import math
import struct
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

import ezdxf
from ezdxf.math import BSpline

try:
    import vtk
except ImportError:
    vtk = None

from program_test import Program_test, main

SVG = "{http://www.w3.org/2000/svg}"
TYPES = ["bspline", "line", "circle", "arc", "ellipse", "elliptic_arc"]
METERS = {"um": 1e-6, "mm": 1e-3, "cm": 1e-2, "m": 1., "in": 0.0254, "ft": 0.3048}
DXF_UNITS = {"um": 13, "mm": 4, "cm": 5, "m": 6, "in": 1, "ft": 2}


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def conic_point(curve, angle):
    x, y = curve["major_direction"], cross(curve["axis"], curve["major_direction"])
    a, b = curve["radii"][0] * math.cos(angle), curve["radii"][1] * math.sin(angle)
    return [c + a * u + b * v for c, u, v in zip(curve["center"], x, y)]


def spline_point(curve, u):
    """De Boor's algorithm, on control points in homogeneous coordinates."""
    degree, knots, points = curve["degree"], curve["knots"], curve["control_points"]
    weights = curve.get("weights", [1.] * len(points))
    span = min(max(bisect.bisect_right(knots, u) - 1, degree), len(points) - 1)
    d = [[w * c for c in p] + [w] for p, w in zip(points[span - degree:span + 1], weights[span - degree:span + 1])]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knots[j + span - degree], knots[j + 1 + span - r]
            t = (u - low) / (high - low)
            d[j] = [(1 - t) * a + t * b for a, b in zip(d[j - 1], d[j])]
    return [c / d[degree][3] for c in d[degree][:3]]


def true_points(curve, count=65):
    """Points at even steps of the angle, or of the parameter, from start to end."""
    if "angles" in curve:
        begin, end = curve["angles"]
        return [conic_point(curve, begin + (end - begin) * i / (count - 1)) for i in range(count)]
    begin, end = curve["knots"][0], curve["knots"][-1]
    return [spline_point(curve, begin + (end - begin) * i / (count - 1)) for i in range(count)]


class Arc_length:
    """The length of a curve, and where a share of it ends, by chords that are short against the curve."""

    def __init__(self, curve):
        if "angles" in curve:
            self.points = true_points(curve, 4001)
        else:  # a chord must not cut a corner, which may be at a knot
            spans = [(a, b) for a, b in zip(curve["knots"], curve["knots"][1:]) if a < b]
            self.points = [spline_point(curve, a + (b - a) * i / 500) for a, b in spans for i in range(500)]
            self.points.append(spline_point(curve, curve["knots"][-1]))
        self.lengths = [0., *itertools.accumulate(map(math.dist, self.points, self.points[1:]))]
        self.total = self.lengths[-1]

    def point(self, share):
        i = min(max(bisect.bisect_right(self.lengths, share * self.total) - 1, 0), len(self.points) - 2)
        t = (share * self.total - self.lengths[i]) / (self.lengths[i + 1] - self.lengths[i])
        return [a + t * (b - a) for a, b in zip(self.points[i], self.points[i + 1])]


def seen_from_above(curve):
    """The points of a conic as DXF has it: counterclockwise from above, if it is level."""
    points = true_points(curve)
    is_from_below = math.hypot(*curve["axis"][:2]) < 1e-9 and curve["axis"][2] < 0
    return points[::-1] if is_from_below else points


class Svg_shape:
    """An element of a drawing as pieces, each a function of a parameter from 0 to 1."""

    def __init__(self, element):
        self.kind = element.tag[len(SVG):]
        texts = ("class", "d", "stroke", "transform")
        number = {key: float(value) for key, value in element.items() if key not in texts}
        if self.kind == "line":
            self.pieces = [self.segment([number["x1"], number["y1"]], [number["x2"], number["y2"]])]
        elif self.kind == "path":
            self.pieces = list(self.path(element.get("d").split()))
        else:
            center = [number["cx"], number["cy"]]
            radii = [number["r"]] * 2 if self.kind == "circle" else [number["rx"], number["ry"]]
            degrees = 0.
            if element.get("transform"):   # about its own center
                degrees, *about = map(float, element.get("transform")[len("rotate("):-1].split())
                assert about == center
            self.pieces = [self.arc(center, radii, math.radians(degrees), 0., 2 * math.pi)]
        self.samples = [(i, k / 32, piece(k / 32)) for i, piece in enumerate(self.pieces) for k in range(33)]

    @staticmethod
    def segment(p, q):
        return lambda t: [a + t * (b - a) for a, b in zip(p, q)]

    @staticmethod
    def arc(center, radii, turn, begin, sweep):
        def point(t):
            x, y = radii[0] * math.cos(begin + t * sweep), radii[1] * math.sin(begin + t * sweep)
            return [center[0] + x * math.cos(turn) - y * math.sin(turn),
                    center[1] + x * math.sin(turn) + y * math.cos(turn)]
        return point

    def path(self, words):
        assert words[0] == "M"
        p, words = [float(word) for word in words[1:3]], words[3:]
        while words:
            count = {"A": 7, "C": 6}[words[0]]
            numbers = [float(word) for word in words[1:count + 1]]
            if words[0] == "A":
                yield self.arc_between(p, numbers)
            else:
                yield self.cubic(p, numbers[:2], numbers[2:4], numbers[4:])
            p, words = numbers[-2:], words[count + 1:]

    @staticmethod
    def cubic(a, b, c, d):
        return lambda t: [(1 - t) ** 3 * i + 3 * (1 - t) ** 2 * t * j + 3 * (1 - t) * t * t * k + t ** 3 * m
                          for i, j, k, m in zip(a, b, c, d)]

    def arc_between(self, p, numbers):
        """The arc from p to q, as appendix B.2.4 of SVG 2 has it."""
        rx, ry, degrees, is_large, is_clockwise, *q = numbers
        turn = math.radians(degrees)
        co, si = math.cos(turn), math.sin(turn)
        half = [(a - b) / 2 for a, b in zip(p, q)]
        x, y = (co * half[0] + si * half[1]) / rx, (co * half[1] - si * half[0]) / ry
        length = math.hypot(x, y)
        assert length <= 1 + 1e-6   # else the radii would have to grow
        height = math.sqrt(max(1 - length * length, 0.)) / length * (-1 if is_large == is_clockwise else 1)
        u, v = height * y, -height * x   # the center, where the ellipse is a unit circle
        begin, end = math.atan2(y - v, x - u), math.atan2(-y - v, -x - u)
        sweep = (end - begin) % (2 * math.pi) - (0 if is_clockwise else 2 * math.pi)
        center = [(a + b) / 2 + c for a, b, c in
                  zip(p, q, (co * rx * u - si * ry * v, si * rx * u + co * ry * v))]
        return self.arc(center, (rx, ry), turn, begin, sweep)

    def length(self):
        return sum(math.dist(p[2], q[2]) for p, q in zip(self.samples, self.samples[1:]) if p[0] == q[0])

    def distance(self, p):
        """Of a point from the nearest piece."""
        # where the projection crosses itself, another branch may be nearer than its samples tell
        far = [math.inf, *(math.dist(q, p) for _, _, q in self.samples), math.inf]
        minima = [(b, *self.samples[i][:2])
                  for i, (a, b, c) in enumerate(zip(far, far[1:], far[2:])) if b <= a and b <= c]
        return min(self.refined(piece, t, p) for _, piece, t in heapq.nsmallest(4, minima))

    def refined(self, piece, t, p):
        point, low, high = self.pieces[piece], max(t - 1 / 32, 0), min(t + 1 / 32, 1)
        for _ in range(40):
            a, b = low + 0.382 * (high - low), high - 0.382 * (high - low)
            low, high = (low, b) if math.dist(point(a), p) < math.dist(point(b), p) else (a, high)
        return math.dist(point(low), p)


class Formats_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        subprocess.run([cls.format_writer, cls.shared], check=True, timeout=200)
        cls.truths = {name: json.loads((cls.shared / (name + ".json")).read_text()) for name in ("near", "far")}
        cls.tilted = json.loads((cls.shared / "tilted.json").read_text())
        cls.arc_lengths = {name: [Arc_length(curve) for curve in truth["curves"]] for name, truth in cls.truths.items()}

    def wireframes(self):
        for name, truth in self.truths.items():
            yield name, truth, 1e-9 * max(abs(c) for vertex in truth["vertices"] for c in vertex)

    def assert_near(self, p, q, tolerance, message=None):
        self.assertLessEqual(math.dist(p, q), tolerance, message)

    def assert_polyline(self, polyline, curve, arc_length, tolerance):
        """The polyline runs from the start of the curve to its end, with even steps of at most 0.1."""
        count = len(polyline) - 1
        self.assertEqual(count, max(math.ceil(arc_length.total / 0.1 - 1e-3), 3 if curve["closed"] else 1))
        self.assert_near(polyline[0], true_points(curve)[0], tolerance)
        self.assert_near(polyline[-1], true_points(curve)[-1], tolerance)
        for i, p in enumerate(polyline):
            self.assert_near(p, arc_length.point(i / count), 1e-4 + tolerance)

    @staticmethod
    def distance_to_conic(p, curve):
        """Of a point nearby, up to a factor: how far it is off the plane, and how far the equation is off."""
        x, y = curve["major_direction"], cross(curve["axis"], curve["major_direction"])
        d = [a - b for a, b in zip(p, curve["center"])]
        u, v, w = (sum(a * b for a, b in zip(d, e)) for e in (x, y, curve["axis"]))
        off = abs(math.hypot(u / curve["radii"][0], v / curve["radii"][1]) - 1) * curve["radii"][1]
        return max(abs(w), off)

    # ---- DXF ----

    def read_dxf(self, name):
        document = ezdxf.readfile(str(self.shared / name))
        auditor = document.audit()
        self.assertEqual([str(error.message) for error in auditor.errors], [])
        self.assertEqual([str(error.message) for error in auditor.fixes], [])
        self.assertEqual(document.dxfversion, "AC1015")
        return document

    def test_dxf(self):
        for name, truth, tolerance in self.wireframes():
            document = self.read_dxf(name + ".dxf")
            entities = list(document.modelspace())
            points, entities = entities[:len(truth["vertices"])], entities[len(truth["vertices"]):]
            for entity, vertex in zip(points, truth["vertices"]):
                self.assertEqual((entity.dxftype(), entity.dxf.layer, list(entity.dxf.location)),
                                 ("POINT", "VERTICES", vertex))
            self.assertEqual(len(entities), len(truth["curves"]))
            layers = {"bspline": "SPLINES", "line": "LINES", "circle": "CIRCLES", "arc": "ARCS", "ellipse": "ELLIPSES",
                      "elliptic_arc": "ELLIPTIC_ARCS"}
            for entity, curve in zip(entities, truth["curves"]):
                self.assertEqual(entity.dxf.layer, layers[curve["type"]])
                self.assertIn(entity.dxf.layer, document.layers)
                with self.subTest(name=name, curve=curve):
                    getattr(self, "check_" + entity.dxftype().lower())(entity, curve, tolerance)

    def check_line(self, entity, curve, _):
        self.assertEqual([list(entity.dxf.start), list(entity.dxf.end)],
                         [curve["control_points"][0], curve["control_points"][-1]])

    def check_circle(self, entity, curve, tolerance):
        self.assertEqual(curve["type"], "circle")
        self.assertAlmostEqual(entity.dxf.radius, curve["radii"][0], delta=1e-12)
        self.assert_near(entity.ocs().to_wcs(entity.dxf.center), curve["center"], tolerance)
        for vertex in entity.vertices(range(0, 360, 15)):
            self.assertLess(self.distance_to_conic(vertex, curve), tolerance)

    def check_arc(self, entity, curve, tolerance):
        self.assertEqual(curve["type"], "arc")
        self.assert_near(entity.start_point, seen_from_above(curve)[0], tolerance)
        self.assert_near(entity.end_point, seen_from_above(curve)[-1], tolerance)
        for vertex, p in zip(entity.vertices(entity.angles(65)), seen_from_above(curve)):
            self.assert_near(vertex, p, tolerance)

    def check_ellipse(self, entity, curve, tolerance):
        self.assertIn(curve["type"], ("ellipse", "elliptic_arc"))
        for vertex, p in zip(entity.vertices(entity.params(65)), seen_from_above(curve)):
            self.assert_near(vertex, p, tolerance)
        self.assert_near(entity.start_point, seen_from_above(curve)[0], tolerance)
        self.assert_near(entity.end_point, seen_from_above(curve)[-1], tolerance)

    def check_spline(self, entity, curve, tolerance):
        self.assertFalse(entity.closed)   # which would be periodic
        self.assertEqual(bool(entity.dxf.flags & 4), "weights" in curve)
        self.assertEqual(entity.dxf.degree, curve["degree"])
        self.assertEqual(list(entity.knots), curve["knots"])
        self.assertEqual(list(entity.weights), curve.get("weights", []))
        shift = curve["knots"][0]  # ezdxf evaluates from 0 on
        spline = BSpline(entity.control_points, order=curve["degree"] + 1, knots=[k - shift for k in entity.knots],
                         weights=list(entity.weights) or None)
        for i, p in enumerate(true_points(curve)):
            u = min((curve["knots"][-1] - shift) * i / 64, spline.max_t)
            self.assert_near(spline.point(u), p, tolerance)

    def test_dxf_extent_and_units(self):
        document = self.read_dxf("near.dxf")
        low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
        for curve in self.truths["near"]["curves"]:
            for p in true_points(curve):
                for a, b, c in zip(low, p, high):
                    self.assertTrue(a - 1e-9 <= b <= c + 1e-9)
        for name in ("flat", "empty"):
            self.read_dxf(name + ".dxf")
        self.assertEqual(document.header["$INSUNITS"], 4)
        for unit, code in DXF_UNITS.items():
            header = self.read_dxf(f"unit_{unit}.dxf").header
            self.assertEqual((header["$INSUNITS"], header["$MEASUREMENT"]), (code, 0 if unit in ("in", "ft") else 1))

    # ---- VTK ----

    def test_vtp(self):
        """The parts of the file fit each other, whoever reads them."""
        for name, truth, _ in self.wireframes():
            piece = ElementTree.parse(self.shared / (name + ".vtp")).find("PolyData/Piece")
            numbers = {key: int(value) for key, value in piece.attrib.items()}
            self.assertEqual((numbers["NumberOfVerts"], numbers["NumberOfLines"]),
                             (len(truth["vertices"]), len(truth["curves"])))
            self.assertEqual(len(piece.find("Points/DataArray").text.split()), 3 * numbers["NumberOfPoints"])
            cells = len(truth["vertices"]) + len(truth["curves"])
            for array in piece.find("CellData"):
                values = array.text.split()
                self.assertEqual(values.count("0") if array.tag == "Array" else len(values), cells, array.attrib)

    @unittest.skipIf(vtk is None, "there is no VTK (Debian: python3-vtk9)")
    def test_vtk_reads_vtp(self):
        for name, truth, tolerance in self.wireframes():
            data = self.read_vtp(name + ".vtp")
            count = len(truth["vertices"])
            self.assertEqual((data.GetNumberOfVerts(), data.GetNumberOfLines()), (count, len(truth["curves"])))
            arrays = [data.GetCellData().GetAbstractArray(i) for i in range(data.GetCellData().GetNumberOfArrays())]
            values = {array.GetName(): array for array in arrays}
            for i, vertex in enumerate(truth["vertices"]):
                self.assertEqual(list(data.GetCell(i).GetPoints().GetPoint(0)), vertex)
                self.assertEqual((values["type_name"].GetValue(i), values["index"].GetValue(i)), ("vertex", -1))
            for i, curve in enumerate(truth["curves"]):
                points = data.GetCell(count + i).GetPoints()
                arc_length = self.arc_lengths[name][i]
                self.assert_polyline([points.GetPoint(j) for j in range(points.GetNumberOfPoints())], curve, arc_length,
                                     tolerance)
                of = {key: array.GetValue(count + i) for key, array in values.items()}
                self.assertEqual((of["index"], of["type"], of["type_name"], of["closed"]),
                                 (i, TYPES.index(curve["type"]), curve["type"], int(curve["closed"])))
                self.assertEqual([of["source"], of["target"]],
                                 [-1 if curve[end] is None else curve[end] for end in ("source", "target")])
                self.assertEqual([of["rms"], of["max"], of["support"]], [curve["rms"], curve["max"], curve["support"]])
                self.assertEqual([of["radius"], of["minor_radius"]], curve.get("radii", [0, 0]))
                self.assertAlmostEqual(of["length"], arc_length.total, delta=1e-5 * of["length"])
            self.assertEqual(data.GetFieldData().GetArray("sampling_distance").GetValue(0), truth["sampling_distance"])
        for unit in METERS:
            field = self.read_vtp(f"unit_{unit}.vtp").GetFieldData()
            self.assertEqual(field.GetAbstractArray("unit").GetValue(0), unit)
        self.assertEqual(self.read_vtp("empty.vtp").GetNumberOfCells(), 0)

    def read_vtp(self, name):
        errors = []
        reader = vtk.vtkXMLPolyDataReader()
        reader.AddObserver("ErrorEvent", lambda *_: errors.append(name))
        reader.SetFileName(str(self.shared / name))
        reader.Update()
        self.assertEqual(errors, [])
        return reader.GetOutput()

    # ---- glTF ----

    def read_gltf(self, name):
        """The document and its bytes, from either form."""
        data = (self.shared / name).read_bytes()
        if name.endswith(".gltf"):
            document = json.loads(data)
            buffers = document.get("buffers", [])
            for buffer in buffers:
                start, code = buffer["uri"].split(",")
                self.assertEqual(start, "data:application/octet-stream;base64")
            return document, base64.b64decode(code, validate=True) if buffers else b""
        magic, version, length, json_length, kind = struct.unpack("<4sIII4s", data[:20])
        self.assertEqual((magic, version, length, kind), (b"glTF", 2, len(data), b"JSON"))
        self.assertEqual(json_length % 4, 0)
        document, rest = json.loads(data[20:20 + json_length]), data[20 + json_length:]
        if rest:
            size, kind = struct.unpack("<I4s", rest[:8])
            self.assertEqual((size, kind), (len(rest) - 8, b"BIN\0"))
            self.assertEqual(size % 4, 0)
        return document, rest[8:]

    def gltf_points(self, document, data, node):
        """In the unit of the wireframe; all that the format asks of an accessor is checked."""
        primitive, = document["meshes"][node["mesh"]]["primitives"]
        accessor = document["accessors"][primitive["attributes"]["POSITION"]]
        view = document["bufferViews"][accessor["bufferView"]]
        self.assertEqual((accessor["componentType"], accessor["type"], view["byteStride"], view["buffer"]),
                         (5126, "VEC3", 12, 0))
        self.assertEqual(view["byteLength"], document["buffers"][0]["byteLength"])
        self.assertEqual(view["byteLength"], len(data))
        self.assertEqual(accessor["byteOffset"] % 4, 0)
        points = [struct.unpack_from("<3f", data, accessor["byteOffset"] + 12 * i) for i in range(accessor["count"])]
        self.assertEqual(accessor["min"], [min(p[i] for p in points) for i in range(3)])
        self.assertEqual(accessor["max"], [max(p[i] for p in points) for i in range(3)])
        self.assertIn("baseColorFactor", document["materials"][primitive["material"]]["pbrMetallicRoughness"])
        root = document["nodes"][0]
        self.assertNotIn("rotation", root)
        return primitive, [[c + t / s for c, t, s in zip(p, root["translation"], root["scale"])] for p in points]

    def test_gltf(self):
        for name, truth, tolerance in self.wireframes():
            for extension in (".gltf", ".glb"):
                document, data = self.read_gltf(name + extension)
                self.assertEqual(document["asset"]["version"], "2.0")
                self.assertEqual(document["scenes"][document["scene"]]["nodes"], [0])
                nodes = [document["nodes"][i] for i in document["nodes"][0]["children"]]
                self.assertEqual(len(nodes), len(document["nodes"]) - 1)
                self.assertEqual([node["name"] for node in nodes], ["vertices"] + [
                    f"curve_{i}_{curve['type']}" for i, curve in enumerate(truth["curves"])])
                primitive, points = self.gltf_points(document, data, nodes[0])
                self.assertEqual(primitive["mode"], 0)
                # single precision, of coordinates that are at most about ten from the middle
                for p, vertex in zip(points, truth["vertices"]):
                    self.assert_near(p, vertex, 3e-6 + tolerance)
                self.assertEqual(len(points), len(truth["vertices"]))
                for node, curve, arc_length in zip(nodes[1:], truth["curves"], self.arc_lengths[name]):
                    primitive, points = self.gltf_points(document, data, node)
                    self.assertEqual(primitive["mode"], 3)
                    self.assertEqual(document["materials"][primitive["material"]]["name"], curve["type"])
                    self.assertEqual(node["extras"]["support"], curve["support"])
                    self.assert_polyline(points, curve, arc_length, 3e-6 + tolerance)
                    if curve["closed"]:
                        self.assertEqual(points[0], points[-1])

    @unittest.skipIf(vtk is None, "there is no VTK (Debian: python3-vtk9)")
    def test_vtk_reads_gltf(self):
        """VTK moves and scales as the nodes say: all is in meters, and where it should be."""
        truth = self.truths["near"]
        for name in ("near.gltf", "near.glb"):
            errors, parts = [], []
            reader = vtk.vtkGLTFReader()
            for event in ("ErrorEvent", "WarningEvent"):
                reader.AddObserver(event, lambda *_: errors.append(name))
            reader.SetFileName(str(self.shared / name))
            reader.Update()
            self.assertEqual(errors, [])
            iterator = reader.GetOutput().NewIterator()
            iterator.InitTraversal()
            while not iterator.IsDoneWithTraversal():
                data = iterator.GetCurrentDataObject()
                parts.append([[1000 * c for c in data.GetPoint(i)] for i in range(data.GetNumberOfPoints())])
                iterator.GoToNextItem()
            self.assertEqual(len(parts), 1 + len(truth["curves"]))
            for p, vertex in zip(parts[0], truth["vertices"]):
                self.assert_near(p, vertex, 1e-5)
            for points, curve, arc_length in zip(parts[1:], truth["curves"], self.arc_lengths["near"]):
                self.assert_polyline(points, curve, arc_length, 1e-5)

    def test_gltf_units(self):
        for unit, meters in METERS.items():
            document, data = self.read_gltf(f"unit_{unit}.glb")
            root, node = document["nodes"]
            self.assertEqual(root["scale"], [meters] * 3)
            for t, c in zip(root["translation"], (1.5, 2, 3)):
                self.assertAlmostEqual(t / meters, c)
            self.assertEqual(self.gltf_points(document, data, node)[0]["mode"], 0)
        for extension in (".gltf", ".glb"):
            document, data = self.read_gltf("empty" + extension)
            self.assertEqual((document["scenes"], data), ([{"name": "wireframe"}], b""))
            self.assertNotIn("nodes", document)

    # ---- SVG ----

    VIEWS = {"front": ((1, 0, 0), (0, 0, 1)), "top": ((1, 0, 0), (0, 1, 0)), "right": ((0, 1, 0), (0, 0, 1)),
             "isometric": ((math.sqrt(1 / 2), math.sqrt(1 / 2), 0),
                           (-math.sqrt(1 / 6), math.sqrt(1 / 6), 2 * math.sqrt(1 / 6)))}

    def read_svg(self, name):
        """The root, the views, and in each view what takes a point to its place on the page."""
        root = ElementTree.parse(self.shared / (name + ".svg")).getroot()
        views = {view.get("id"): view for view in root.findall(SVG + "g")}
        scale, places = float(root.get("data-scale")), {}
        first = (self.truths.get(name) or self.tilted)["vertices"][0]
        for key, (right, up) in self.VIEWS.items():
            circle = views[key].find(SVG + "circle[@class='vertex']")

            def place(p, circle=circle, right=right, up=up):
                d = [a - b for a, b in zip(p, first)]
                return [float(circle.get("cx")) + scale * sum(map(float.__mul__, d, map(float, right))),
                        float(circle.get("cy")) - scale * sum(map(float.__mul__, d, map(float, up)))]
            places[key] = place
        return root, views, places

    @staticmethod
    def curves_of(view):
        return [element for element in view if element.get("class") not in (None, "vertex", "dimension")]

    def test_svg(self):
        for name, truth, tolerance in self.wireframes():
            root, views, places = self.read_svg(name)
            size = [root.get("width"), root.get("height")]
            self.assertTrue(all(length.endswith("mm") for length in size))
            width, height = (float(length[:-2]) for length in size)
            self.assertEqual(root.get("viewBox"), f"0 0 {size[0][:-2]} {size[1][:-2]}")   # a unit is a millimeter
            boxes = {}
            for key, place in places.items():
                elements = self.curves_of(views[key])
                self.assertEqual([e.get("class").split()[0] for e in elements], [c["type"] for c in truth["curves"]])
                self.assertEqual(len(views[key].findall(SVG + "circle[@class='vertex']")), len(truth["vertices"]))
                box = [place(p) for curve in truth["curves"] for p in true_points(curve)]
                boxes[key] = [f(p[i] for p in box) for f in (min, max) for i in range(2)]
                for x, y in box:
                    self.assertTrue(0 < x < width and 0 < y < height)
            # aligned as in a drawing, and apart from each other
            if name == "near":
                origins = {key: place([0., 0., 0.]) for key, place in places.items()}
                self.assertAlmostEqual(origins["front"][0], origins["top"][0], delta=1e-5)
                self.assertAlmostEqual(origins["front"][1], origins["right"][1], delta=1e-5)
            self.assertLess(boxes["top"][3], boxes["front"][1])
            self.assertLess(boxes["front"][2], boxes["right"][0])
            self.assertLess(boxes["isometric"][3], boxes["right"][1])
            self.assertLess(boxes["top"][2], boxes["isometric"][0])
            self.assertEqual({text.text for text in views["legend"]}, set(TYPES))
        for name in ("flat", "empty"):
            self.assertEqual(len(ElementTree.parse(self.shared / (name + ".svg")).getroot().findall(SVG + "g")), 5)

    def test_svg_curves(self):
        """Each curve is its projection to a millionth of the size, as a primitive of its kind."""
        for name, truth, tolerance in [*self.wireframes(), ("tilted", self.tilted, 0.)]:
            root, views, places = self.read_svg(name)
            scale = float(root.get("data-scale"))
            size = scale * math.dist(*[[f(v[i] for v in truth["vertices"]) for i in range(3)] for f in (min, max)])
            for key, place in places.items() if name != "far" else [("isometric", places["isometric"])]:
                for element, curve in zip(self.curves_of(views[key]), truth["curves"]):
                    shape = Svg_shape(element)
                    with self.subTest(name, view=key, type=curve["type"]):
                        kinds = {"bspline": ["path"], "line": ["line"], "arc": ["path", "line"],
                                 "elliptic_arc": ["path", "line"], "circle": ["circle", "ellipse", "line"],
                                 "ellipse": ["circle", "ellipse", "line"]}
                        self.assertIn(shape.kind, kinds[curve["type"]])
                        points = [place(p) for p in true_points(curve)]
                        error = 1e-6 * size + 2 * scale * tolerance
                        for p in points[::8]:
                            self.assertLessEqual(shape.distance(p), error)
                        if shape.kind == "path":
                            self.assert_near(shape.pieces[0](0.), points[0], error)
                            self.assert_near(shape.pieces[-1](1.), points[-1], error)
                        if shape.kind != "line":   # nothing besides
                            fine = [place(p) for p in true_points(curve, 301)]
                            length = sum(map(math.dist, fine, fine[1:]))
                            self.assertAlmostEqual(shape.length(), length, delta=1e-2 * length)

    def test_svg_scale(self):
        """What fits a page is drawn in its size, all else at a usual scale, which is said."""
        for unit, meters in METERS.items():
            text = (self.shared / f"unit_{unit}.svg").read_text()
            self.assertRegex(text, rf"Size 1 x 0 x 0 {unit},.* scale \d+:\d+<")
            over, under = map(float, text[text.index("scale ", text.index("Size")) + 6:].split("<")[0].split(":"))
            scale = float(ElementTree.fromstring(text.encode()).get("data-scale"))
            self.assertAlmostEqual(scale, over / under * 1000 * meters, delta=1e-9 * scale)

    def test_svg_dimensions(self):
        """The radii of arcs and the diameters of circles, each once."""
        root = ElementTree.parse(self.shared / "dimensions.svg").getroot()
        texts = sorted(g.find(SVG + "text").text for g in root.iter(SVG + "g") if g.get("class") == "dimension")
        expected = sorted(f"R {c['radii'][0]:.4g}" if c["type"] == "arc" else f"\u2300 {2 * c['radii'][0]:.4g}"
                          for c in self.truths["near"]["curves"] if c["type"] in ("arc", "circle"))
        self.assertEqual(texts, expected)

    # ---- CSV ----

    def test_csv(self):
        for name, truth, _ in self.wireframes():
            with open(self.shared / (name + ".csv"), newline="", encoding="ascii") as file:
                rows = list(csv.DictReader(file, strict=True))
            self.assertEqual(len(rows), len(truth["curves"]))
            for i, (row, curve) in enumerate(zip(rows, truth["curves"])):
                self.assertNotIn(None, row)
                self.assertEqual((row["index"], row["type"], row["closed"]),
                                 (str(i), curve["type"], str(curve["closed"]).lower()))
                for key in ("source", "target"):
                    self.assertEqual(row[key], "" if curve[key] is None else str(curve[key]))
                for key in ("rms", "max", "support"):
                    self.assertEqual(float(row[key]), curve[key])
                self.assertEqual((row["doubts"].split(), row["doubtful"]),
                                 (curve["doubts"], "true" if curve["doubts"] else "false"))
                values = {"center": curve.get("center"), "axis": curve.get("axis"),
                          "major_direction": curve.get("major_direction")}
                if curve["type"] == "line":
                    p, q = curve["control_points"]
                    values["center"] = [(a + b) / 2 for a, b in zip(p, q)]
                    values["axis"] = [(b - a) / math.dist(p, q) for a, b in zip(p, q)]
                for key, value in values.items():
                    texts = [row[key + "_" + axis] for axis in "xyz"]
                    if value is None:
                        self.assertEqual(texts, ["", "", ""])
                    else:
                        self.assert_near(list(map(float, texts)), value, 1e-9)
                radii, angles = curve.get("radii", ["", ""]), curve.get("angles", ["", ""])
                found = [row[key] for key in ("major_radius", "minor_radius", "start_angle", "end_angle")]
                self.assertEqual([float(text) if text else "" for text in found], radii + angles)
                uncertainty = curve.get("uncertainty", {})
                expected = [uncertainty.get("position", ""), uncertainty.get("direction", ""),
                            *uncertainty.get("radii", ["", ""])]
                found = [row[key + "_uncertainty"] for key in ("position", "direction", "major_radius", "minor_radius")]
                self.assertEqual([float(text) if text else "" for text in found], expected)
                length = self.arc_lengths[name][i].total
                self.assertAlmostEqual(float(row["length"]), length, delta=1e-5 * length)
        self.assertEqual((self.shared / "empty.csv").read_bytes().count(b"\r\n"), 1)

    # ---- OBJ ----

    def test_obj_splines(self):
        for name, truth, tolerance in self.wireframes():
            points, curves = [], []
            for line in (self.shared / (name + "_splines.obj")).read_text().splitlines():
                kind, *words = line.split()
                if kind == "v":
                    points.append(list(map(float, words)))
                elif kind == "g":
                    curves.append({"name": words[0]})
                elif kind in ("curv", "l"):
                    indices = words[2:] if kind == "curv" else words
                    curves[-1]["found"] = [points[int(i) - 1] for i in indices]
                elif kind in ("cstype", "deg", "parm"):
                    curves[-1][kind] = words
                else:
                    self.assertRegex(line, "^(#|end$)")
            self.assertEqual(points[:len(truth["vertices"])], truth["vertices"])
            for i, (found, curve) in enumerate(zip(curves, truth["curves"])):
                self.assertEqual(found["name"], f"curve_{i}_{curve['type']}")
                if curve["type"] == "line":
                    self.assertEqual(found["found"], curve["control_points"])
                    continue
                self.assertEqual(found["cstype"], ["rat"] * ("weights" in curve) + ["bspline"])
                spline = {"degree": int(found["deg"][0]), "knots": list(map(float, found["parm"][1:])),
                          "control_points": [p[:3] for p in found["found"]],
                          "weights": [p[3] if len(p) > 3 else 1. for p in found["found"]]}
                self.assertEqual(len(spline["knots"]), len(found["found"]) + spline["degree"] + 1)
                for p, q in zip(true_points(spline), true_points(curve)):
                    if "angles" in curve:
                        self.assertLess(self.distance_to_conic(p, curve), tolerance)
                    else:
                        self.assert_near(p, q, tolerance)
            self.assertEqual(len(curves), len(truth["curves"]))


if __name__ == "__main__":
    main("format_writer")
