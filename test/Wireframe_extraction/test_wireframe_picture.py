#!/usr/bin/env python3
"""Tests the picture of extract_wireframe --png: that it shows the curves where they are.

usage: test_wireframe_picture.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import itertools
import json
import math
import os
import struct
import unittest
import zlib

from program_test import USAGE_ERROR, Program_test, main

WITH_PNG = os.environ.get("EXTRACT_WIREFRAME_WITH_PNG") == "1"
COLOURS = {"line": (64, 64, 64), "arc": (255, 127, 14), "circle": (214, 39, 40)}
VERTEX = (18, 20, 26)
MARGIN = 40

A, B = math.sqrt(1 / 2), math.sqrt(1 / 6)
VIEWS = {"isometric": ((A, A, 0), (-B, B, 2 * B)), "front": ((1, 0, 0), (0, 0, 1)), "right": ((0, 1, 0), (0, 0, 1)),
         "top": ((1, 0, 0), (0, 1, 0))}


def unfiltered(data, width, height, channels):
    """The rows of a PNG, by the five filters of its specification."""
    size = width * channels
    rows, above = [], bytearray(size)
    for y in range(height):
        kind = data[y * (size + 1)]
        row = bytearray(data[y * (size + 1) + 1:(y + 1) * (size + 1)])
        if kind == 1:
            for channel in range(channels):
                row[channel::channels] = bytes(total & 255 for total in itertools.accumulate(row[channel::channels]))
        elif kind == 2:
            row = bytearray((value + up) & 255 for value, up in zip(row, above))
        elif kind in (3, 4):
            for x in range(size):
                left, corner = (row[x - channels], above[x - channels]) if x >= channels else (0, 0)
                if kind == 3:
                    row[x] = (row[x] + (left + above[x]) // 2) & 255
                else:
                    up = above[x]
                    to_left, to_up, to_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
                    near = left if to_left <= to_up and to_left <= to_corner else up if to_up <= to_corner else corner
                    row[x] = (row[x] + near) & 255
        rows.append(row)
        above = row
    return rows


def read_png(path):
    """The pixels, as rows of triples."""
    content = path.read_bytes()
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    position, chunks = 8, []
    while position < len(content):
        size, = struct.unpack(">I", content[position:position + 4])
        kind, data = content[position + 4:position + 8], content[position + 8:position + 8 + size]
        check, = struct.unpack(">I", content[position + 8 + size:position + 12 + size])
        assert check == zlib.crc32(kind + data)
        chunks.append((kind, data))
        position += 12 + size
    assert chunks[0][0] == b"IHDR" and chunks[-1][0] == b"IEND"
    width, height, depth, colour, *_, interlace = struct.unpack(">IIBBBBB", chunks[0][1])
    assert (depth, colour, interlace) == (8, 2, 0), "eight bits of red, green and blue"
    data = zlib.decompress(b"".join(data for kind, data in chunks if kind == b"IDAT"))
    return [[tuple(row[3 * x:3 * x + 3]) for x in range(width)] for row in unfiltered(data, width, height, 3)]


def points_of(curve):
    """Points of a line or an arc, ends left out."""
    for i in range(1, 40):
        t = i / 40
        if curve["type"] == "line":
            begin, end = curve["control_points"]
            yield [(1 - t) * a + t * b for a, b in zip(begin, end)]
        else:
            start, stop = curve["angles"]
            angle = start + t * (stop - start)
            x, axis = curve["major_direction"], curve["axis"]
            y = [axis[1] * x[2] - axis[2] * x[1], axis[2] * x[0] - axis[0] * x[2], axis[0] * x[1] - axis[1] * x[0]]
            yield [c + r * math.cos(angle) * u + s * math.sin(angle) * v
                   for c, u, v, r, s in zip(curve["center"], x, y, 3 * [curve["radii"][0]], 3 * [curve["radii"][1]])]


class Picture_test(Program_test):
    def setUp(self):
        super().setUp()
        self.make_cloud(self.folder / "plate.ply", "slotted_plate", "--points", 8000, "--field", "exact")

    def run_tool(self, *arguments, **options):
        """The same without a display."""
        environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return super().run_tool(*arguments, env=environment, **options)

    def projection(self, view, width, height):
        """As the picture has it: by the corners of the plate, which the cloud does not pass."""
        right, up = VIEWS[view]
        def on_page(point):
            return [sum(a * b for a, b in zip(direction, point)) for direction in (right, up)]
        corners = [on_page(vertex) for vertex in self.wireframe["vertices"]]
        low = [min(corner[i] for corner in corners) for i in range(2)]
        high = [max(corner[i] for corner in corners) for i in range(2)]
        scale = min((width - 2 * MARGIN) / (high[0] - low[0]), (height - 2 * MARGIN) / (high[1] - low[1]))
        def to_pixel(point):
            x, y = on_page(point)
            return width / 2 + scale * (x - (low[0] + high[0]) / 2), height / 2 - scale * (y - (low[1] + high[1]) / 2)
        return to_pixel

    @unittest.skipUnless(WITH_PNG, "the tool was built without libpng")
    def test_curves_are_where_they_should_be(self):
        for view in VIEWS:
            arguments = [] if view == "isometric" else ["--view", view]
            self.run_tool("plate.ply", "--png", "plate.png", "-o", "plate.json", *arguments)
            self.wireframe = json.loads((self.folder / "plate.json").read_text())
            pixels = read_png(self.folder / "plate.png")
            height, width = len(pixels), len(pixels[0])
            to_pixel = self.projection(view, width, height)
            types = set()
            hits = count = 0
            for curve in self.wireframe["curves"]:
                types.add(curve["type"])
                for point in points_of(curve):
                    x, y = to_pixel(point)
                    x, y = int(x), int(y)
                    near = [pixels[j][i] for i in (x - 1, x, x + 1) for j in (y - 1, y, y + 1)]
                    # along an axis, arcs and lines are before each other, and lines are behind their vertices
                    colours = [COLOURS[curve["type"]]] if view == "isometric" else [*COLOURS.values(), VERTEX]
                    hits += any(self.is_like(pixel, colour) for pixel in near for colour in colours)
                    count += 1
            self.assertEqual(types, {"line", "arc"})
            # a vertex, or the border of a curve that is before it, may hide a point
            self.assertGreater(hits / count, 0.9, view)
            background = pixels[0][0]
            for row in pixels:
                self.assertTrue(all(self.is_like(row[x], background) for x in (0, 5, width - 6, width - 1)))
            some = [pixel for row in pixels[::7] for pixel in row[::7]]
            self.assertGreater(sum(not self.is_like(pixel, background) for pixel in some), 0.05 * len(some))

    @staticmethod
    def is_like(pixel, other):
        return max(abs(a - b) for a, b in zip(pixel, other)) < 24

    @unittest.skipUnless(WITH_PNG, "the tool was built without libpng")
    def test_failures(self):
        for arguments, words in ((("--png", ""), "name of the picture is empty"),
                                 (("--png", "plate.ply"), "is the same file"),
                                 (("--png", "plate.jpg"), "plate.jpg: a picture is written into .png"),
                                 (("--png", "missing/plate.png"), "make it first"),
                                 (("--png", "plate.png", "--view", "left"), "isometric|front|right|top")):
            error = self.run_tool("plate.ply", *arguments, code=USAGE_ERROR)
            self.assertIn(words, error)
            self.assertEqual(error.count("\n"), 1, error)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["plate.ply"])

    def test_is_no_format(self):
        self.assertIn("--png OUT.png", self.run_tool("plate.ply", "-o", "plate.png", code=USAGE_ERROR))

    @unittest.skipIf(WITH_PNG, "the tool was built with libpng")
    def test_without_libpng(self):
        error = self.run_tool("plate.ply", "--png", "plate.png", code=USAGE_ERROR)
        self.assertIn("libpng-dev", error)
        self.assertEqual(error.count("\n"), 1)


if __name__ == "__main__":
    main("tool", "cloud_maker")
