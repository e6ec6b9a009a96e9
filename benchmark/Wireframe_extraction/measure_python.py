#!/usr/bin/env python3
"""Measures the Python module: how long it takes to import, and how long an extraction takes in it and in the tool.
 CPU seconds of all threads, median of several runs in turns, so that what else the machine does counts little. The tool
reads a cloud and writes wireframe JSON; the module does the same, in a process in which it was imported before. The
extraction has one thread in both. The module has to be installed, or PYTHONPATH has to name the folder in which it was
built.
"""

import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/Wireframe_extraction/data"

IMPORT = """
import time
start = time.perf_counter()
import numpy
between = time.perf_counter()
import wireframe_extraction
print(between - start, time.perf_counter() - between)
"""


def cpu_seconds(who):
    usage = resource.getrusage(who)
    return usage.ru_utime + usage.ru_stime


def seconds_of(work, who):
    before = cpu_seconds(who)
    work()
    return cpu_seconds(who) - before


def import_seconds(runs):
    """Returns wall seconds of importing NumPy, and then the module: the least of several fresh interpreters."""
    rows = [list(map(float, subprocess.run([sys.executable, "-c", IMPORT], stdout=subprocess.PIPE, check=True,
                                           encoding="utf-8").stdout.split())) for _ in range(runs)]
    return [min(column) for column in zip(*rows)]


def compare(tool, cloud, runs):
    """Returns the CPU seconds of the tool and of the module."""
    import wireframe_extraction

    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "wireframe.json")

        def by_tool():
            subprocess.run([tool, cloud, "-o", output, "--threads", "1", "--quiet"], check=True)

        def by_module():
            wireframe_extraction.extract(cloud, threads=1).write(output)

        by_module()
        pairs = [(seconds_of(by_tool, resource.RUSAGE_CHILDREN), seconds_of(by_module, resource.RUSAGE_SELF))
                 for _ in range(runs)]
    return [statistics.median(column) for column in zip(*pairs)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tool", required=True, help="the program extract_wireframe")
    parser.add_argument("--runs", type=int, default=7, help="(default %(default)s)")
    parser.add_argument("clouds", nargs="*", default=[DATA / "slotted_plate.ply", DATA / "l_bracket_scan.ply"])
    arguments = parser.parse_args()

    numpy_seconds, own_seconds = import_seconds(arguments.runs)
    print(f"import        {own_seconds:.3f} s, after NumPy, which takes {numpy_seconds:.3f} s")
    for cloud in arguments.clouds:
        tool, module = compare(arguments.tool, cloud, arguments.runs)
        print(f"{pathlib.Path(cloud).name:20} tool {tool:.3f} s, module {module:.3f} s, ratio {module / tool:.3f}")


if __name__ == "__main__":
    main()
