#!/usr/bin/env python3
"""Draws each stage of an extraction as a PNG of its own: the whole shape, and beside it a part of it, enlarged.

Needs numpy, scipy and matplotlib (Debian: python3-scipy python3-matplotlib).
"""

import argparse
import pathlib
import sys

from plot_wireframe import PLY_TYPES, np, plt, read_cloud, read_wireframe, sample, view

from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle

GREY = "0.82"
TYPE_COLORS = {"line": "tab:blue", "circle": "tab:red", "arc": "tab:orange", "ellipse": "tab:purple",
               "elliptic_arc": "tab:pink", "bspline": "tab:green"}


def read_stage(name):
    """Returns the vertices and edges of a PLY file of a stage, as arrays with named columns. There may be no edges."""
    elements = []
    with open(name, "rb") as stream:
        for line in iter(stream.readline, b""):
            words = line.decode("ascii", "replace").split()
            if words[:1] == ["end_header"]:
                break
            if words[:1] == ["element"]:
                elements.append((words[1], int(words[2]), []))
            elif words[:1] == ["property"]:
                if not elements or words[1] not in PLY_TYPES:
                    raise ValueError(f"{name}: not a PLY file that extract_wireframe --stages writes")
                elements[-1][2].append((words[2], "<" + PLY_TYPES[words[1]]))
        found = {key: np.fromfile(stream, dtype=columns, count=count) for key, count, columns in elements}
    if "vertex" not in found or len(found["vertex"]) != elements[0][1]:
        raise ValueError(f"{name}: the file has no vertices, or ends too early")
    return found["vertex"], found.get("edge", np.zeros(0, dtype=[("vertex1", "i4"), ("vertex2", "i4")]))


def colors_of(rows):
    return np.column_stack([rows[key] for key in ("red", "green", "blue")]) / 255


class Stage_figure:
    """Two panels with the same view, the right one enlarged around the corner that is nearest to the viewer."""

    def __init__(self, rows, cloud, center, reach, r):
        self.rows, self.r = rows, r
        self.figure = plt.figure(figsize=(7.6, 3.1), dpi=80, facecolor="white")
        self.panels = [self.figure.add_axes([left, 0.02, 0.485, 0.96]) for left in (0.005, 0.505)]
        seen = cloud @ rows.T
        low, high = seen[:, :2].min(axis=0) - 3 * r, seen[:, :2].max(axis=0) + 3 * r
        middle, half = (low + high) / 2, (high - low) / 2
        half = max(half[0], half[1] / 0.8) * np.array([1, 0.8])
        place = (center @ rows.T)[:2]
        for axes, at, size in zip(self.panels, (middle, place), (half, reach * r * np.array([1, 0.8]))):
            axes.set_xlim(at[0] - size[0], at[0] + size[0])
            axes.set_ylim(at[1] - size[1], at[1] + size[1])
            axes.set_aspect("equal")
            axes.set_xticks([])
            axes.set_yticks([])
        self.panels[0].add_patch(Rectangle(place - reach * r * np.array([1, 0.8]), 2 * reach * r, 1.6 * reach * r,
                                           fill=False, linewidth=0.8))
        corner = place + reach * r * np.array([-0.93, -0.72])
        self.panels[1].plot([corner[0], corner[0] + 5 * r], [corner[1]] * 2, color="black", linewidth=1)
        self.panels[1].text(corner[0] + 2.5 * r, corner[1] + 0.25 * r, "5 r", ha="center", fontsize=8)

    def points(self, points, color, sizes=(1.2, 14), **options):
        seen = points @ self.rows.T
        order = np.argsort(seen[:, 2], kind="stable")
        color = color[order] if not isinstance(color, str) else color
        drawn = [axes.scatter(seen[order, 0], seen[order, 1], c=color, s=size, linewidths=0, **options)
                 for axes, size in zip(self.panels, sizes)]
        return drawn[0]

    def lines(self, polylines, colors, widths=(1.4, 2.2), **options):
        for axes, width in zip(self.panels, widths):
            axes.add_collection(LineCollection([(p @ self.rows.T)[:, :2] for p in polylines], colors=colors,
                                               linewidths=width, **options))

    def bar(self, drawn, label):
        axes = self.figure.add_axes([0.02, 0.11, 0.15, 0.03])
        self.figure.colorbar(drawn, cax=axes, orientation="horizontal", extend="max")
        axes.tick_params(labelsize=7, pad=1)
        axes.set_title(label, fontsize=7, pad=2)

    def legend(self, colors):
        self.panels[0].legend([Line2D([], [], color=color, linewidth=2) for color in colors.values()],
                              [name.replace("_", " ") for name in colors],
                              loc="lower left", fontsize=7, frameon=False)

    def save(self, name):
        self.figure.savefig(name, metadata={"Software": None})
        plt.close(self.figure)


def positions(rows):
    return np.column_stack([rows[key] for key in "xyz"])


def segments(vertices, edges):
    return positions(vertices)[np.column_stack([edges["vertex1"], edges["vertex2"]])]


class Stage_pictures:
    """Draws a picture per stage; `make_figure` gives an empty figure."""

    def __init__(self, stages, cloud, make_figure, output):
        self.stages, self.cloud, self.make_figure, self.output = stages, cloud, make_figure, output

    def figure_on_cloud(self):
        figure = self.make_figure()
        figure.points(self.cloud, GREY, (0.25, 1.5))
        return figure

    def draw_skeleton(self, distances, r):
        vertices, _ = read_stage(self.stages / "1_skeleton.ply")
        figure = self.make_figure()
        figure.points(self.cloud[distances >= 3 * r], GREY, (0.25, 3))
        drawn = figure.points(positions(vertices), vertices["scalar_distance"] / r, (2, 22),
                              cmap="viridis", vmin=0, vmax=1.5)
        figure.bar(drawn, "distance, in r")
        figure.save(self.output / "stage_skeleton.png")

    def draw_contraction(self, r):
        vertices, _ = read_stage(self.stages / "2_feet.ply")
        figure = self.figure_on_cloud()
        drawn = figure.points(positions(vertices), vertices["scalar_residual"] / r, (2, 14),
                              cmap="plasma", vmin=0, vmax=0.6)
        figure.bar(drawn, "residual, in r")
        figure.save(self.output / "stage_contraction.png")

    def draw_corners(self):
        vertices, edges = read_stage(self.stages / "3_corners.ply")
        figure = self.figure_on_cloud()
        is_ball = np.zeros(len(vertices), dtype=bool)
        is_ball[edges["vertex1"]] = is_ball[edges["vertex2"]] = True
        figure.points(positions(vertices[~is_ball]), colors_of(vertices[~is_ball]), (2, 14))
        figure.lines(segments(vertices, edges), "tab:red", (0.5, 0.9))
        figure.save(self.output / "stage_corners.png")

    def draw_clusters(self):
        vertices, _ = read_stage(self.stages / "4_clusters.ply")
        figure = self.figure_on_cloud()
        figure.points(positions(vertices), colors_of(vertices), (2, 14))
        figure.save(self.output / "stage_clusters.png")

    def draw_graph(self):
        vertices, edges = read_stage(self.stages / "5_graph.ply")
        figure = self.figure_on_cloud()
        figure.lines(segments(vertices, edges), colors_of(edges))
        is_corner = vertices["scalar_corner"] > 0
        figure.points(positions(vertices[~is_corner]), "0.3", (2, 10), zorder=3)
        figure.points(positions(vertices[is_corner]), "tab:red", (14, 60), zorder=4)
        figure.save(self.output / "stage_graph.png")

    def draw_curves(self, splines):
        palette = plt.get_cmap("tab10")
        figure = self.figure_on_cloud()
        for i, curve in enumerate(splines["curves"]):
            controls = np.array(curve["control_points"], dtype=float)
            figure.lines([controls], "0.5", (0, 0.7), linestyles="dotted")
            figure.points(controls, "0.5", (0, 16), marker="s", zorder=3)
            figure.lines([sample(curve)], [palette(i % 10)])
        figure.points(np.array(splines["vertices"]), "black", (8, 40), zorder=4)
        figure.save(self.output / "stage_curves.png")

    def draw_types(self, typed):
        figure = self.figure_on_cloud()
        present = {curve["type"] for curve in typed["curves"]}
        for curve in typed["curves"]:
            figure.lines([sample(curve)], TYPE_COLORS[curve["type"]], (1.6, 2.6))
        figure.points(np.array(typed["vertices"]), "black", (8, 40), zorder=4)
        figure.legend({name: color for name, color in TYPE_COLORS.items() if name in present})
        figure.save(self.output / "stage_types.png")


def draw_stages(pictures, distances, splines, typed):
    r = typed["sampling_distance"]
    pictures.draw_skeleton(distances, r)
    pictures.draw_contraction(r)
    pictures.draw_corners()
    pictures.draw_clusters()
    pictures.draw_graph()
    pictures.draw_curves(splines)
    pictures.draw_types(typed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stages", help="the folder that extract_wireframe --stages wrote", type=pathlib.Path)
    parser.add_argument("cloud", help="the cloud, a PLY file")
    parser.add_argument("splines", help="its wireframe of splines, made with --splines-only, a .json file")
    parser.add_argument("typed", help="its wireframe with curve types, a .json file")
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path,
                        help="the folder for the pictures, stage_skeleton.png and so on")
    parser.add_argument("--vertex", type=int,
                        help="the vertex of the typed wireframe to enlarge; default: the one nearest to the viewer")
    parser.add_argument("--reach", type=float, default=14, help="half the width of the enlarged part, in r; default 14")
    parser.add_argument("--azimuth", type=float, default=35, help="where to look from, in degrees; default 35")
    parser.add_argument("--elevation", type=float, default=30, help="how high, in degrees; default 30")
    arguments = parser.parse_args()
    try:
        cloud, distances = read_cloud(arguments.cloud)
        splines, typed = read_wireframe(arguments.splines), read_wireframe(arguments.typed)
        if not typed["vertices"] or not splines["vertices"]:
            raise ValueError(f"{arguments.typed}: there is no vertex to enlarge")
        rows = view(arguments.azimuth, arguments.elevation)
        vertices = np.array(typed["vertices"], dtype=float)
        index = int(np.argmax(vertices @ rows[2])) if arguments.vertex is None else arguments.vertex
        if not 0 <= index < len(vertices):
            raise ValueError(f"there is no vertex {index}; there are {len(vertices)}, counted from 0")
        pictures = Stage_pictures(
            arguments.stages, cloud,
            lambda: Stage_figure(rows, cloud, vertices[index], arguments.reach, typed["sampling_distance"]),
            arguments.output)
        draw_stages(pictures, distances, splines, typed)
    except (OSError, ValueError, KeyError) as error:
        print(f"plot_stages.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
