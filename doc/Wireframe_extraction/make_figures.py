#!/usr/bin/env python3
"""Makes the figures of the manual anew, with the programs and scripts of the project and nothing else.

The figure that FreeCAD draws is not among them; how it was made is said below it. The sweep takes about half an hour;
what it measured stays in the work folder, and is not measured again.
"""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "benchmark/Wireframe_extraction"
SWEEP_SOLIDS = ("crossing_cylinders", "flange", "inscribed_boss", "slotted_plate")
LIMITS = (("rounded_plate", "exact"), ("inscribed_boss", "def"), ("faceted_disc", "def"), ("thin_plate", "noisy"))


class Figures:
    """One function per figure, of its name."""

    def __init__(self, programs, work, output):
        self.programs, self.work, self.output = programs, work, output

    def run(self, program, *arguments):
        program = SCRIPTS / program if program.endswith(".py") else self.programs / program
        command = [sys.executable] if program.suffix == ".py" else []
        subprocess.run([*command, program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def case(self, solid, points, family):
        folder = self.work / family / solid
        if not (folder / "truth.json").exists():
            self.run("make_cloud", solid, "--points", points, "-o", folder)
        return folder

    def wireframe_extraction(self):
        cloud = ROOT / "examples/Wireframe_extraction/data/box_with_hole.ply"
        self.run("extract_wireframe", cloud, "-o", self.work / "title.json", "--quiet")
        self.run("plot_wireframe.py", cloud, self.work / "title.json", "-o", self.output / "wireframe_extraction.png")

    def python_plot(self):
        data = ROOT / "examples/Wireframe_extraction/data"
        self.run("plot_python.py", data / "slotted_plate.ply", data / "crossing_cylinders.ply",
                 "-o", self.output / "python_plot.png")

    def python_recipes(self):
        data = ROOT / "examples/Wireframe_extraction/data"
        noisy = self.case("inscribed_boss", 10000, "recipes") / "noisy.ply"
        self.run("plot_python_recipes.py", data / "box_with_hole.ply", data / "crossing_cylinders.ply", noisy,
                 "-o", self.output)

    def stages(self):
        cloud = self.case("slotted_plate", 20000, "stages") / "def.ply"
        splines, typed = self.work / "splines.json", self.work / "typed.json"
        stages = self.work / "stages_of_plate"
        self.run("extract_wireframe", cloud, "-o", splines, "--splines-only", "--quiet")
        self.run("extract_wireframe", cloud, "-o", typed, "--stages", stages, "--quiet")
        self.run("plot_stages.py", stages, cloud, splines, typed, "-o", self.output,
                 "--azimuth", 112, "--elevation", 44)

    def limits(self):
        pairs = []
        for solid, field in LIMITS:
            folder = self.case(solid, 20000, "limits")
            self.run("extract_wireframe", folder / f"{field}.ply", "-o", folder / f"{field}.json", "--quiet")
            pairs += [folder / "truth.json", folder / f"{field}.json"]
        self.run("plot_limits.py", *pairs, "-o", self.output / "limits.png")

    def sweep(self):
        for solid in SWEEP_SOLIDS:
            self.case(solid, 8000, "sweep")
        self.run("plot_sweep.py", self.work / "sweep", "--benchmark", self.programs / "run_benchmark",
                 "--tool", self.programs / "extract_wireframe", "--csv", self.work / "sweep.csv",
                 "-o", self.output / "sweep.png")


def main():
    names = ("wireframe_extraction", "python_plot", "python_recipes", "stages", "limits", "sweep")
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", required=True, type=pathlib.Path,
                        help="the folder with make_cloud, extract_wireframe and run_benchmark")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="a folder for clouds and wireframes")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "doc/Wireframe_extraction/fig",
                        help="the folder for the pictures; default: that of the manual")
    parser.add_argument("--only", nargs="+", choices=names, default=names, help="make these only")
    arguments = parser.parse_args()
    try:
        arguments.work.mkdir(parents=True, exist_ok=True)
        arguments.output.mkdir(parents=True, exist_ok=True)
        figures = Figures(arguments.programs.resolve(), arguments.work.resolve(), arguments.output.resolve())
        for name in arguments.only:
            print(f"making {name} ...", flush=True)
            getattr(figures, name)()
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"make_figures.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
