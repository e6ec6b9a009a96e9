#!/usr/bin/env python3
"""Draws what plot() of the Python module draws of some clouds, side by side, as a PNG.

Needs the module (PYTHONPATH may name the folder in which it was built) and matplotlib (Debian: python3-matplotlib).
"""

import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import wireframe_extraction  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("clouds", nargs="+", help="clouds, with or without distances")
    parser.add_argument("-o", "--output", required=True, help="the picture")
    arguments = parser.parse_args()
    figure = plt.figure(figsize=(5 * len(arguments.clouds), 4.2))
    for number, path in enumerate(arguments.clouds, 1):
        axes = figure.add_subplot(1, len(arguments.clouds), number, projection="3d")
        points, distances = wireframe_extraction.read_cloud(path)
        wireframe_extraction.extract(points, distances).plot(axes, points=points)
        axes.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0)
    figure.savefig(arguments.output, dpi=90)


if __name__ == "__main__":
    main()
