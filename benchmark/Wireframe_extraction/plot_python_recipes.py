#!/usr/bin/env python3
"""Draws what a few lines of Python make of a wireframe: the gallery of the manual's page on Python.

usage: plot_python_recipes.py HOLED CROSSING NOISY -o FOLDER
HOLED is a cloud with holes, CROSSING one with curved edges, and NOISY one with large errors.
"""

import argparse
import pathlib

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

import wireframe_extraction  # noqa: E402


def doubts(path):
    """Draw a wireframe of a bad cloud: what is doubtful is dotted."""
    cloud = wireframe_extraction.read_cloud(path)
    wireframe = wireframe_extraction.extract(*cloud)
    axes = wireframe.plot(points=cloud.points)
    axes.set_title(f"{int(wireframe.doubtful.sum())} of {len(wireframe.curves)} curves are doubtful")
    axes.set_axis_off()
    return axes.figure


def curvature(path):
    """Draw how the curvature changes along the curves."""
    wireframe = wireframe_extraction.extract(path)
    figure, axes = pyplot.subplots(figsize=(6, 3.5))
    for curve in wireframe.curves:
        if curve.type == "bspline":
            t = np.linspace(*curve.range, 400)
            lengths = np.linalg.norm(np.diff(curve(t), axis=0), axis=1).cumsum()
            axes.plot(np.insert(lengths, 0, 0), curve.curvature(t), label=f"curve {curve.index}")
    axes.set_xlabel("length along the curve")
    axes.set_ylabel("curvature")
    axes.legend(frameon=False)
    return figure


def residuals(path):
    """Compare the distances of a field with those to the wireframe."""
    points, distances = wireframe_extraction.read_cloud(path)
    wireframe = wireframe_extraction.extract(points, distances)
    r = wireframe.sampling_distance
    is_near = distances < 3 * r
    errors = (distances - wireframe.distance(points))[is_near] / r
    figure, axes = pyplot.subplots(figsize=(6, 3.5))
    axes.hist(errors, np.linspace(-2, 2, 81), color="#4c72b0")
    axes.set_xlabel("given distance less that to the wireframe, in r")
    axes.set_ylabel(f"of {int(is_near.sum())} points")
    return figure


def holes(path):
    """Draw the circles of a part from above, with their diameters and uncertainties."""
    wireframe = wireframe_extraction.extract(path)
    figure, axes = pyplot.subplots(figsize=(5, 4))
    for curve in wireframe.curves:
        samples = curve.sample(count=100)
        axes.plot(samples[:, 0], samples[:, 1], color="#999999" if curve.radius is None else "#c44e52")
        if curve.radius is not None and curve.index == max(c.index for c in wireframe.curves if c.radius is not None):
            text = f"⌀ {2 * curve.radius:.5f} ± {2 * curve.uncertainty['major_radius']:.0e}"
            axes.annotate(text, curve.center[:2], ha="center", va="center")
    axes.set_aspect("equal")
    axes.set_axis_off()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("holed", type=pathlib.Path)
    parser.add_argument("crossing", type=pathlib.Path)
    parser.add_argument("noisy", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="the folder for the pictures")
    arguments = parser.parse_args()
    pictures = {"python_doubts": (doubts, arguments.noisy), "python_curvature": (curvature, arguments.crossing),
                "python_residuals": (residuals, arguments.noisy), "python_holes": (holes, arguments.holed)}
    for name, (draw, path) in pictures.items():
        draw(path).savefig(arguments.output / f"{name}.png", dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    main()
