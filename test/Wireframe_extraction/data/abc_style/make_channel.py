#!/usr/bin/env python3
"""Writes channel.obj and channel.yml, a shape in the format of the ABC dataset, made for the tests.

A U-shaped channel along y with a thin left wall, one outer edge rounded, and a hole in its floor:

    z = 1.2  P8-P7             P4----P3      x of P8 and P0: 0     P7, P6: 0.1   P5, P4: 1.7   P3, P2: 2
             |  |              |      |      The round from P1 to P2 has the radius 0.3.
    z = 0.4  |  P6-----------P5       |      The hole has the radius 0.35 about x = 0.9, y = 1.
             |      (hole)           P2
    z = 0    P0---------------P1 (round)     y from 0 (front) to 2 (back)

It has 12 surfaces and 33 curves. 28 curves are sharp: 9 of the profile at each end, 7 along y, the upper rim of
the hole, a closed circle, and the lower one in two arcs. Not sharp are the two along the round, the seam of the
hole, and two that only the format has: a point, and a copy of a sharp curve (to be taken once).
"""

import math
import pathlib

PROFILE = [(0, 0), (1.7, 0), (2, 0.3), (2, 1.2), (1.7, 1.2), (1.7, 0.4), (0.1, 0.4), (0.1, 1.2), (0, 1.2)]
ARC_PARTS, HOLE_PARTS = 12, 48
ROUND = [(1.7 + 0.3 * math.sin(math.pi / 2 * i / ARC_PARTS), 0.3 - 0.3 * math.cos(math.pi / 2 * i / ARC_PARTS))
         for i in range(ARC_PARTS + 1)]

vertices, index_of = [], {}


def vertex(x, y, z):
    key = tuple(round(c, 6) + 0.0 for c in (x, y, z))
    if key not in index_of:
        index_of[key] = len(vertices)
        vertices.append(key)
    return index_of[key]


def points_of_side(i):
    """Profile points from P_i to the next, with those of the round."""
    return ROUND if i == 1 else [PROFILE[i], PROFILE[(i + 1) % len(PROFILE)]]


def strip(a, b):
    """Triangles between two rows of as many vertices."""
    return [t for i in range(len(a) - 1) for t in ((a[i], b[i], b[i + 1]), (a[i], b[i + 1], a[i + 1]))]


def triangulated(polygon, at):
    """Ear clipping of a polygon in the plane; `at` gives the vertex of a point."""
    def area(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    rest, triangles = list(polygon), []
    while len(rest) > 2:
        best = None
        for i in range(len(rest)):
            a, b, c = rest[i - 1], rest[i], rest[(i + 1) % len(rest)]
            if area(a, b, c) <= 1e-9 or any(p not in (a, b, c) and area(a, b, p) >= -1e-12 and area(b, c, p) >= -1e-12
                                            and area(c, a, p) >= -1e-12 for p in rest):
                continue
            size = max(math.dist(a, b), math.dist(b, c), math.dist(c, a))
            if best is None or size < best[0]:
                best = (size, i, (at(*a), at(*b), at(*c)))
        triangles.append(best[2])
        del rest[best[1]]
    return triangles


def ring(circle, corners):
    """Triangles between a circle and the convex polygon around it: each point of the circle is joined to the
    corner that is nearest by its angle about the centre."""
    def angle(v):
        x, y, _ = vertices[v]
        return math.atan2(y - 1, x - 0.9) % (2 * math.pi)
    inner, outer = sorted(circle, key=angle), sorted(corners, key=angle)
    inner, outer = inner + inner[:1], outer + outer[:1]

    def turn(row, i):
        return angle(row[i]) + (2 * math.pi if i == len(row) - 1 else 0)

    triangles, i, j = [], 0, 0
    while i < len(inner) - 1 or j < len(outer) - 1:
        if j == len(outer) - 1 or (i < len(inner) - 1
                                   and 2 * turn(inner, i + 1) <= turn(outer, j) + turn(outer, j + 1)):
            triangles.append((inner[i], outer[j], inner[i + 1]))
            i += 1
        else:
            triangles.append((inner[i], outer[j], outer[j + 1]))
            j += 1
    return triangles


def main():
    n = len(PROFILE)
    row = {(i, y): [vertex(x, y, z) for x, z in points_of_side(i)] for y in (0, 2) for i in range(n)}
    circle = {z: [vertex(0.9 + 0.35 * math.cos(2 * math.pi * k / HOLE_PARTS),
                         1 + 0.35 * math.sin(2 * math.pi * k / HOLE_PARTS), z) for k in range(HOLE_PARTS)]
              for z in (0, 0.4)}
    surfaces = []
    for i in range(n):
        if i in (0, 5):
            surfaces.append(("Plane", ring(circle[0 if i == 0 else 0.4], row[i, 0] + row[i, 2])))
        else:
            surfaces.append(("Cylinder" if i == 1 else "Plane", strip(row[i, 0], row[i, 2])))
    outline = PROFILE[:1] + ROUND + PROFILE[3:]
    for y in (0, 2):
        surfaces.append(("Plane", triangulated(outline, lambda x, z: vertex(x, y, z))))
    loop = {z: circle[z] + circle[z][:1] for z in circle}
    surfaces.append(("Cylinder", strip(loop[0], loop[0.4])))

    curves = []
    for y in (0, 2):
        curves += [("Circle" if i == 1 else "Line", True, row[i, y]) for i in range(n)]
    curves += [("Line", i not in (1, 2), [vertex(x, 0, z), vertex(x, 2, z)]) for i, (x, z) in enumerate(PROFILE)]
    half = HOLE_PARTS // 2
    curves += [("Circle", True, loop[0.4]), ("Circle", True, loop[0][:half + 1]), ("Circle", True, loop[0][half:]),
               ("Line", False, [circle[0][0], circle[0.4][0]]), ("Other", True, [vertex(0, 0, 0)]),
               ("Line", True, row[0, 0][::-1])]

    here = pathlib.Path(__file__).resolve().parent
    with open(here / "channel.obj", "w") as out:
        out.write("# made by make_channel.py\n")
        out.writelines("v %.6f %.6f %.6f\n" % v for v in vertices)
        for _, triangles in surfaces:
            out.writelines("f %d//1 %d//1 %d//1\n" % tuple(v + 1 for v in t) for t in triangles)
    with open(here / "channel.yml", "w") as out:
        out.write("# made by make_channel.py\ncurves:\n")
        for kind, is_sharp, indices in curves:
            out.write("- sharp: %s\n  type: %s\n  vert_indices: %s\n  vert_parameters: [0.0, [1.0, 2.0]]\n"
                      % ("true" if is_sharp else "false", kind, indices))
        out.write("surfaces:\n")
        first = 0
        for kind, triangles in surfaces:
            out.write("- face_indices: %s\n  type: %s\n  vert_indices: %s\n"
                      % (list(range(first, first + len(triangles))), kind, sorted({v for t in triangles for v in t})))
            first += len(triangles)


if __name__ == "__main__":
    main()
