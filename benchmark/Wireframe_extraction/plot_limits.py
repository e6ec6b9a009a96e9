#!/usr/bin/env python3
"""Draws where wireframes differ most from the truth, as a PNG with one panel per wireframe.

Needs numpy, scipy and matplotlib (Debian: python3-scipy python3-matplotlib).
"""

import argparse
import json
import pathlib
import sys

from plot_wireframe import np, plt, read_wireframe, sample, view

from scipy.spatial import cKDTree


def dense(polyline, step):
    """Returns points on a polyline that are no farther from each other than `step`."""
    pieces = [polyline[:1]]
    for a, b in zip(polyline[:-1], polyline[1:]):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        pieces.append(a + (b - a) * np.linspace(0, 1, count + 1)[1:, None])
    return np.concatenate(pieces)


def worst_place(truth, prediction):
    """Returns the place where one is farthest from the other, and how far."""
    found = []
    for one, other in ((truth, prediction), (prediction, truth)):
        distances = cKDTree(np.concatenate(other)).query(np.concatenate(one))[0]
        found.append((distances.max(), np.concatenate(one)[distances.argmax()]))
    return max(found, key=lambda pair: pair[0])


def draw_panel(axes, truth_name, wireframe_name, rows, reach):
    with open(truth_name, encoding="utf-8") as stream:
        truth = json.load(stream)
    r = truth["r"]
    wireframe = read_wireframe(wireframe_name)
    true_curves = [dense(np.array(curve["points"], dtype=float), 0.1 * r) for curve in truth["segments"]]
    curves = [dense(sample(curve, 400), 0.1 * r) for curve in wireframe["curves"]]
    deviation, place = worst_place(true_curves, curves)
    if reach > 0:
        center = place
    else:
        center = 0.5 * (np.concatenate(true_curves).min(axis=0) + np.concatenate(true_curves).max(axis=0))
        reach = 0.6 * np.ptp(np.concatenate(true_curves) @ rows.T, axis=0)[:2].max() / r
    for curve in true_curves:
        seen = (curve - center) @ rows.T / r
        axes.plot(seen[:, 0], seen[:, 1], color="0.75", linewidth=5, solid_capstyle="round")
    colors = plt.get_cmap("tab10")
    for i, curve in enumerate(curves):
        seen = (curve - center) @ rows.T / r
        axes.plot(seen[:, 0], seen[:, 1], color=colors(i % 10), linewidth=1.6)
    for vertices, style in ((truth["corners"], dict(color="0.55", markersize=9)),
                            (wireframe["vertices"], dict(color="black", markersize=4))):
        if vertices:
            seen = (np.array(vertices, dtype=float) - center) @ rows.T / r
            axes.plot(seen[:, 0], seen[:, 1], "o", **style)
    name = pathlib.Path(truth_name).parent.name
    axes.set_title(f"{name}, {pathlib.Path(wireframe_name).stem}: HD {deviation / r:.1f} r", fontsize=9)
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-0.7 * reach, 0.7 * reach)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.plot([-0.95 * reach, -0.95 * reach + 5], [-0.64 * reach] * 2, color="black", linewidth=1)
    axes.text(-0.95 * reach + 2.5, -0.62 * reach, "5 r", ha="center", fontsize=7)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", metavar="TRUTH WIREFRAME", help="pairs of truth.json and wireframe JSON")
    parser.add_argument("-o", "--output", required=True, help="the picture, a .png file")
    parser.add_argument("--reach", type=float, default=15,
                        help="half the width of a panel, in r; 0 shows all; default 15")
    parser.add_argument("--azimuth", type=float, default=35, help="where to look from, in degrees; default 35")
    parser.add_argument("--elevation", type=float, default=30, help="how high, in degrees; default 30")
    arguments = parser.parse_args()
    if len(arguments.files) % 2:
        parser.error("every truth needs a wireframe")
    pairs = list(zip(arguments.files[::2], arguments.files[1::2]))
    columns = min(2, len(pairs))
    lines = (len(pairs) + columns - 1) // columns
    figure, panels = plt.subplots(lines, columns, figsize=(4.5 * columns, 3.3 * lines), dpi=90, squeeze=False)
    try:
        for axes, (truth, wireframe) in zip(panels.flat, pairs):
            draw_panel(axes, truth, wireframe, view(arguments.azimuth, arguments.elevation), arguments.reach)
        for axes in panels.flat[len(pairs):]:
            axes.axis("off")
        figure.tight_layout()
        figure.savefig(arguments.output, metadata={"Software": None})
    except (OSError, ValueError, KeyError) as error:
        print(f"plot_limits.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
