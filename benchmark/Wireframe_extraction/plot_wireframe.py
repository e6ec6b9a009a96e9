#!/usr/bin/env python3
"""Draws a cloud with its distance field, and beside it the wireframe that was extracted from it, as a PNG.

Needs numpy, scipy and matplotlib (Debian: python3-scipy python3-matplotlib).
"""

import argparse
import json
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from scipy.interpolate import BSpline
except ImportError as error:
    sys.exit(f"plot_wireframe.py: {error}; it needs numpy, scipy and matplotlib "
             "(Debian: python3-scipy python3-matplotlib)")

PLY_TYPES = {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8", "int": "i4", "int32": "i4",
             "uint": "u4", "uint32": "u4", "short": "i2", "ushort": "u2", "char": "i1", "uchar": "u1",
             "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2"}
DISTANCE_NAMES = ("distance", "distances", "sharpness", "scalar_distance", "quality")


def read_header(stream, name):
    """Returns the format, the number of vertices, and their properties as (name, numpy type)."""
    if stream.readline().strip() != b"ply":
        raise ValueError(f"{name}: not a PLY file")
    kind, count, properties, element = None, None, [], None
    for line in iter(stream.readline, b""):
        words = line.decode("ascii", "replace").split()
        if words[:1] == ["end_header"]:
            break
        if words[:1] == ["format"]:
            kind = words[1]
        elif words[:1] == ["element"]:
            element = words[1]
            if element == "vertex":
                count = int(words[2])
            elif count is None:
                raise ValueError(f"{name}: the element vertex has to be the first one")
        elif words[:1] == ["property"] and element == "vertex":
            if words[1] not in PLY_TYPES:
                raise ValueError(f"{name}: a vertex has a property of the type {words[1]}, which is not supported")
            properties.append((words[2], PLY_TYPES[words[1]]))
    if count is None:
        raise ValueError(f"{name}: there is no element vertex")
    return kind, count, properties


def read_cloud(name):
    """Returns the points of a PLY file, one per row, and their distances."""
    with open(name, "rb") as stream:
        kind, count, properties = read_header(stream, name)
        if kind == "ascii":
            rows = [tuple(stream.readline().split()[:len(properties)]) for _ in range(count)]
            vertices = np.array(rows, dtype=[(n, "f8") for n, _ in properties])
        else:
            order = ">" if kind == "binary_big_endian" else "<"
            vertices = np.fromfile(stream, dtype=[(n, order + t) for n, t in properties], count=count)
    if len(vertices) != count:
        raise ValueError(f"{name}: the file ends after {len(vertices)} of {count} points")
    present = [n for n in DISTANCE_NAMES if n in vertices.dtype.names]
    if not present:
        raise ValueError(f"{name}: no distance among the properties {', '.join(vertices.dtype.names)}")
    points = np.column_stack([vertices[k] for k in "xyz"]).astype(float)
    return points, vertices[present[0]].astype(float)


def read_wireframe(name):
    with open(name, encoding="utf-8") as stream:
        wireframe = json.load(stream)
    if wireframe.get("format") != "wireframe" or wireframe.get("version") not in (1, 2):
        raise ValueError(f"{name}: not wireframe JSON, version 1")
    return wireframe


def sample(curve, count=200):
    """Returns points of a curve; every curve has a B-spline form, whatever its type."""
    points = np.array(curve["control_points"], dtype=float)
    weights = np.array(curve.get("weights") or np.ones(len(points)))
    degree, knots = curve["degree"], np.array(curve["knots"], dtype=float)
    spline = BSpline(knots, np.column_stack([points * weights[:, None], weights]), degree)
    values = spline(np.linspace(knots[degree], knots[len(points)], count))
    return values[:, :3] / values[:, 3:]


def view(azimuth, elevation):
    """Returns the rows right, up and towards the viewer of a parallel projection."""
    a, e = np.radians([azimuth, elevation])
    right = [-np.sin(a), np.cos(a), 0]
    towards = [np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)]
    return np.array([right, np.cross(towards, right), towards])


def draw(cloud, distances, wireframe, rows, output):
    r = wireframe["sampling_distance"]
    figure = plt.figure(figsize=(9, 4.4), dpi=90, facecolor="white")
    left, right = figure.add_axes([0.01, 0.13, 0.47, 0.8]), figure.add_axes([0.52, 0.13, 0.47, 0.8])
    seen = cloud @ rows.T
    order = np.argsort(seen[:, 2], kind="stable")  # from the back to the front, so that the front covers the back
    extent = np.ptp(seen[:, :2], axis=0).max()
    size = (1.9 * r / extent * 4.4 * 72) ** 2  # points reach their neighbours: the surface looks closed
    colored = left.scatter(seen[order, 0], seen[order, 1], c=np.minimum(distances[order] / r, 10), s=size,
                           cmap="viridis", vmin=0, vmax=10, linewidths=0)
    bar = figure.colorbar(colored, cax=figure.add_axes([0.13, 0.115, 0.24, 0.025]), orientation="horizontal",
                          extend="max")
    bar.set_label("distance to the nearest sharp curve, in r", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    left.set_title(f"{len(cloud)} points", fontsize=10)

    colors = plt.get_cmap("tab10")
    for i, curve in enumerate(wireframe["curves"]):
        polyline = sample(curve) @ rows.T
        right.plot(polyline[:, 0], polyline[:, 1], color=colors(i % 10), linewidth=1.8)
    if wireframe["vertices"]:
        vertices = np.array(wireframe["vertices"]) @ rows.T
        right.plot(vertices[:, 0], vertices[:, 1], "o", color="black", markersize=4)
    right.set_title(f"{len(wireframe['curves'])} curves, {len(wireframe['vertices'])} vertices", fontsize=10)

    low, high = seen[:, :2].min(axis=0) - 3 * r, seen[:, :2].max(axis=0) + 3 * r
    for axes in (left, right):
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect("equal")
        axes.axis("off")
    figure.savefig(output, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cloud", help="the cloud, a PLY file")
    parser.add_argument("wireframe", help="its wireframe, as extract_wireframe writes it to a .json file")
    parser.add_argument("-o", "--output", required=True, help="the picture, a .png file")
    parser.add_argument("--azimuth", type=float, default=35, help="where to look from, in degrees; default 35")
    parser.add_argument("--elevation", type=float, default=30, help="how high, in degrees; default 30")
    arguments = parser.parse_args()
    try:
        cloud, distances = read_cloud(arguments.cloud)
        wireframe = read_wireframe(arguments.wireframe)
        draw(cloud, distances, wireframe, view(arguments.azimuth, arguments.elevation), arguments.output)
    except (OSError, ValueError, KeyError) as error:
        print(f"plot_wireframe.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
