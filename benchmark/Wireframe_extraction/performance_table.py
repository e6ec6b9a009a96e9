#!/usr/bin/env python3
"""Runs wireframe_extraction_benchmark and makes a table of ratios to the floor that is measured in the same run.

The floor is what hardly any method can do without: reading the cloud, a kd-tree of the points that some stage uses,
and a ball query around each point of the skeleton. Seconds depend on the machine and on what else it does; ratios hardly do.
"""

import argparse
import collections
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

STAGES = ["read", "sampling_distance", "skeleton", "contraction", "refinement", "corners", "segmentation", "graph",
          "splines", "types", "all"]
TITLES = {"sampling_distance": "r", "contraction": "contract", "refinement": "refine", "segmentation": "segment"}


class Failure(Exception):
    """What is said in one line."""


def run(arguments):
    """Runs the program and returns its results by case, stage and number of threads."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "results.json")
        command = [arguments.program, f"--most_points={arguments.most_points}",
                   f"--least_points={arguments.least_points}", f"--benchmark_min_time={arguments.seconds}",
                   f"--benchmark_out={file}", "--benchmark_out_format=json"]
        command.append(f"--benchmark_filter=^({'|'.join(arguments.shape or ['[a-z_]+'])})"
                       f"/({'|'.join(arguments.field or ['[a-z]+'])})/[0-9]+/[a-z_]+/[1-{arguments.threads}]/")
        try:
            code = subprocess.run(command, stdout=sys.stderr if arguments.verbose else subprocess.DEVNULL,
                                  check=False).returncode
        except OSError as error:
            raise Failure(f"cannot run {arguments.program}: {error.strerror}") from error
        if code != 0 or not file.exists():
            raise Failure(f"{arguments.program} ended with {code}; it says why")
        results = json.loads(file.read_text(encoding="utf-8"))["benchmarks"]
    measured = collections.defaultdict(dict)
    for result in results:
        if result.get("error_occurred"):
            raise Failure(f"{result['name']}: {result['error_message']}")
        shape, field, points, stage, threads = result["name"].split("/")[:5]
        measured[shape, field, int(points)][stage, int(threads)] = result
    if not measured:
        raise Failure("nothing was measured; is there a cloud with that shape and number of points?")
    return measured


def exponent(points, seconds):
    """Returns the slope of the logarithms; None if there is but one size."""
    if len(points) < 2:
        return None
    x, y = [math.log(n) for n in points], [math.log(max(t, 1e-9)) for t in seconds]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x))


def number(value):
    """Returns a number with two digits, or more if it is large."""
    if value is None:
        return "-"
    return f"{value:.2g}" if abs(value) < 100 else f"{value:.0f}"


def rows(measured):
    """Yields for each case and stage what the tables tell."""
    for (shape, field, points), stages in measured.items():
        floor = stages["floor", 1]
        for stage in ["floor"] + STAGES:
            one, two = stages[stage, 1], stages.get((stage, 2))
            growth = exponent(*zip(*[(other[2], results[stage, 1]["cpu_time"]) for other, results in measured.items()
                                     if other[:2] == (shape, field)]))
            # a stage that has nothing to do has noise only
            ratio = one["cpu_time"] / floor["cpu_time"]
            is_idle = ratio < 0.01
            yield {"shape": shape, "field": field, "points": points, "skeleton": int(one["skeleton"]),
                   "curves": int(one["curves"]), "stage": stage, "ratio": None if is_idle else ratio,
                   "exponent": None if is_idle else growth, "points_per_second": points / (one["cpu_time"] / 1e3),
                   "speedup_with_2_threads": one["real_time"] / two["real_time"] if two and not is_idle else None,
                   "peak_bytes_per_point": one["peak_bytes"] / points if "peak_bytes" in one else None,
                   "peak_bytes_per_skeleton_point":
                       one["peak_bytes"] / max(1, one["skeleton"]) if "peak_bytes" in one else None}


def growth(table):
    """Returns a table with a row for each shape and field."""
    groups = collections.defaultdict(dict)
    for row in table:
        groups[row["shape"], row["field"]][row["stage"]] = row["exponent"]
    lines = ["Exponent of the growth of CPU time with the number of points, one thread:", "",
             "| Shape | Field | " + " | ".join(TITLES.get(s, s) for s in ["floor"] + STAGES) + " |",
             "|---|---|" + "---:|" * (1 + len(STAGES))]
    for group, exponents in groups.items():
        if exponents["floor"] is not None:
            lines.append("| " + " | ".join(group) + " | "
                         + " | ".join(number(exponents[s]) for s in ["floor"] + STAGES) + " |")
    return "\n".join(lines) + "\n" if len(lines) > 4 else ""


def markdown(table, value, caption):
    """Returns a table with a row for each cloud and a column for each stage."""
    clouds = collections.defaultdict(dict)
    for row in table:
        clouds[row["shape"], row["field"], row["points"], row["skeleton"], row["curves"]][row["stage"]] = row
    lines = [caption, "", "| Shape | Field | Points | Skeleton | Curves | "
             + " | ".join(TITLES.get(s, s) for s in STAGES) + " |", "|---|---|" + "---:|" * (3 + len(STAGES))]
    for cloud, stages in clouds.items():
        lines.append("| " + " | ".join(str(x) for x in cloud) + " | "
                     + " | ".join(number(stages[s][value]) for s in STAGES) + " |")
    return "\n".join(lines) + "\n"


def main():
    """Makes the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="wireframe_extraction_benchmark")
    parser.add_argument("--least-points", type=int, default=10000, metavar="N", help="size of the smallest clouds")
    parser.add_argument("--most-points", type=int, default=1000000, metavar="N",
                        help="size of the largest clouds, up to 10000000 [%(default)s]")
    parser.add_argument("--shape", action="append", help="only this shape, as often as needed")
    parser.add_argument("--field", action="append", choices=["exact", "def"], help="only this field")
    parser.add_argument("--threads", type=int, default=2, choices=[1, 2],
                        help="1 leaves out what is measured with two threads [%(default)s]")
    parser.add_argument("--seconds", type=float, default=0.5, help="least time for each figure [%(default)s]")
    parser.add_argument("--csv", type=pathlib.Path, metavar="FILE", help="where all figures go")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="where the tables go, besides the screen")
    parser.add_argument("--verbose", action="store_true", help="show what the program prints")
    arguments = parser.parse_args()
    try:
        table = list(rows(run(arguments)))
        parts = [markdown(table, "ratio", "CPU time over that of the floor, one thread:"), growth(table),
                 markdown(table, "peak_bytes_per_point",
                          "Peak of memory, beyond what there was before, in bytes per point of the cloud:"),
                 markdown(table, "peak_bytes_per_skeleton_point", "The same in bytes per point of the skeleton:")]
        if arguments.threads > 1:
            parts.append(markdown(table, "speedup_with_2_threads", "Speed-up with two threads:"))
        text = "\n".join(part for part in parts if part)
        print(text)
        if arguments.markdown:
            arguments.markdown.write_text(text, encoding="utf-8")
        if arguments.csv:
            with arguments.csv.open("w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, list(table[0]))
                writer.writeheader()
                writer.writerows(table)
    except (Failure, OSError) as error:
        print(f"performance_table.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
