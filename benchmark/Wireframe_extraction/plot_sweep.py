#!/usr/bin/env python3
"""Varies one parameter after the other, runs the benchmark for each value, and draws the scores as a PNG.

What was measured goes to a CSV file, and a value that is there already is not measured again. Needs numpy, scipy and
matplotlib (Debian: python3-scipy python3-matplotlib).
"""

import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

from plot_wireframe import np, plt

# option, its values with the default, the score, further options
SWEEPS = (("skeleton-distance", (0.75, 1, 1.5, 2, 2.5), 1.5, "curve_f1", ""),
          ("support-distance", (1.5, 2, 3, 4, 5), 3, "curve_f1", ""),
          ("fitting-radius", (2.5, 3, 4, 5, 6), 4, "curve_f1", ""),
          ("corner-reach", (2, 3, 5, 7, 10), 5, "curve_f1", ""),
          ("maximum-gap", (0, 6, 12, 18, 30), 18, "curve_f1", ""),
          ("minimum-evidence", (0, 1, 2, 4, 8), 2, "curve_f1", ""),
          ("smooth-angle", (5, 10, 20, 30, 40), 20, "curve_f1", ""),
          ("type-significance", (1e-6, 1e-4, 1e-3, 1e-2, 1e-1), 1e-3, "typed_recall", ""),
          ("corner-radius", (2, 3, 4, 6, 8), 4, "curve_f1", "--paper"))
UNITS = {"smooth-angle": "degrees", "type-significance": "", "minimum-evidence": "points"}
LABELS = {"curve_f1": "curve F1", "typed_recall": "typed recall"}
FIELDS = {"exact": "tab:green", "def": "tab:blue", "noisy": "tab:red"}
COLUMNS = ("options", "field", "cases", "failed", "curve_f1", "typed_recall")


def measure(arguments, options):
    """Returns one row per field: the means over the cases. Failed cases count as 0."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "rows.csv"
        tool = f'"{arguments.tool}" {{in}} -o {{out}} --quiet {options}'
        subprocess.run([arguments.benchmark, arguments.cases, "--tool", tool, "--csv", table, "--quiet", "-j",
                        str(arguments.jobs)], check=True, stdout=subprocess.DEVNULL)
        with open(table, newline="", encoding="utf-8") as stream:
            measured = list(csv.DictReader(stream))
    rows = []
    for field in FIELDS:
        of_field = [row for row in measured if row["field"] == field]
        if not of_field:
            raise ValueError(f"{arguments.cases}: there is no case with the field {field}")
        row = {"options": options, "field": field, "cases": len(of_field),
               "failed": sum(1 for case in of_field if case["failure"])}
        for score in LABELS:
            values = [0. if case["failure"] else float(case[score])
                      for case in of_field if case["failure"] or case[score]]
            row[score] = f"{np.mean(values):.4f}" if values else ""  # no types, no score for them
        rows.append(row)
    return rows


def options_of(option, value, default, more):
    """The default needs no option, so that it is measured once for all."""
    return " ".join(filter(None, [more, "" if value == default else f"--{option}={value:g}"]))


def sweep(arguments):
    """Returns all rows by options and field; what is measured is written at once."""
    rows = {}
    if arguments.csv.exists():
        with open(arguments.csv, newline="", encoding="utf-8") as stream:
            rows = {(row["options"], row["field"]): row for row in csv.DictReader(stream)}
    for option, values, default, _, more in SWEEPS:
        for value in values:
            options = options_of(option, value, default, more)
            if (options, "exact") in rows:
                continue
            print(f"measuring {options or 'the defaults'} ...", flush=True)
            for row in measure(arguments, options):
                rows[options, row["field"]] = row
            with open(arguments.csv, "w", newline="", encoding="utf-8") as stream:
                writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
                writer.writeheader()
                writer.writerows(rows.values())
    return rows


def draw(rows, output):
    columns = 3
    lines = (len(SWEEPS) + columns - 1) // columns
    figure, panels = plt.subplots(lines, columns, figsize=(8.4, 7.2), dpi=90, squeeze=False)
    for axes, (option, values, default, score, more) in zip(panels.flat, SWEEPS):
        for field, color in FIELDS.items():
            scores = [float(rows[options_of(option, value, default, more), field][score]) for value in values]
            axes.plot(values, scores, "o-", color=color, markersize=3, linewidth=1.2, label=field)
        axes.axvline(default, color="0.4", linewidth=1, linestyle="dashed", zorder=1.5)
        if option == "type-significance":
            axes.set_xscale("log")
        unit = UNITS.get(option, "r")
        title = option.replace("-", "_") + (f" ({unit})" if unit else "") + (f", {more}" if more else "")
        axes.set_title(title, fontsize=9)
        axes.set_ylabel(LABELS[score], fontsize=8)
        axes.set_ylim(0, 1.05)
        axes.tick_params(labelsize=8)
        axes.grid(True, color="0.92")
    panels.flat[0].legend(fontsize=8, loc="lower right")
    figure.tight_layout()
    figure.savefig(output, metadata={"Software": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", help="a folder with cases that have the fields exact, def and noisy")
    parser.add_argument("--benchmark", required=True, help="the program run_benchmark")
    parser.add_argument("--tool", required=True, help="the program extract_wireframe")
    parser.add_argument("--csv", required=True, type=pathlib.Path,
                        help="the table with what was measured, read if it is there")
    parser.add_argument("-o", "--output", required=True, help="the picture, a .png file")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="number of cases that run at once; default 1")
    arguments = parser.parse_args()
    try:
        draw(sweep(arguments), arguments.output)
    except (OSError, ValueError, KeyError, subprocess.CalledProcessError) as error:
        print(f"plot_sweep.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
