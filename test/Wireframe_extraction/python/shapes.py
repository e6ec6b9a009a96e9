"""Wireframes with known shapes, as wireframe JSON."""

import json

import numpy as np


def closed_curve(curve_type, degree, knots, control_points, weights=None, **parameters):
    """Return a curve without vertices."""
    curve = {"type": curve_type, "closed": True, "source": None, "target": None, "degree": degree, "knots": list(knots),
             "control_points": np.asarray(control_points).tolist(), **parameters}
    return curve if weights is None else {**curve, "weights": list(weights)}


def circle(center, radius):
    """Return a circle in the plane of x and y, as four rational pieces."""
    corners = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)])
    points = np.column_stack([radius * corners, np.zeros(9)]) + center
    angles = np.arange(5) * np.pi / 2
    knots = radius * np.concatenate([[0], np.repeat(angles, 2), [2 * np.pi]])
    return closed_curve("circle", 2, knots, points, [1, np.sqrt(0.5)] * 4 + [1], center=list(center), axis=[0, 0, 1],
                        major_direction=[1, 0, 0], radii=[radius, radius], angles=[0, 2 * np.pi], rms=0.5,
                        max=0.75, support=7, doubts=["misfit", "short"],
                        uncertainty={"position": 0.1, "direction": 0.2, "radii": [0.3, 0.4]})


def write(path, vertices, curves, sampling_distance=0.1):
    """Write wireframe JSON, and return its path."""
    positions = np.asarray(vertices, dtype=float).reshape(-1, 3).tolist()
    path.write_text(json.dumps({"format": "wireframe", "version": 1, "sampling_distance": sampling_distance,
                                "vertices": positions, "curves": curves}))
    return path


def line(start, end, source=0, target=1):
    """Return a line between two vertices."""
    return {"type": "line", "closed": False, "source": source, "target": target, "degree": 1,
            "knots": [0, 0, 1, 1], "control_points": [list(map(float, start)), list(map(float, end))]}


def spline(knots, control_points, weights=None, degree=3):
    """Return a spline between the vertices 0 and 1."""
    curve = {"type": "bspline", "closed": False, "source": 0, "target": 1, "degree": degree, "knots": list(knots),
             "control_points": np.asarray(control_points).tolist()}
    return curve if weights is None else {**curve, "weights": list(weights)}
