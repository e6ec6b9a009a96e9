#!/usr/bin/env python3
"""Tests the programs run_benchmark and evaluate_wireframe from the outside.

usage: test_wireframe_benchmark.py RUN_BENCHMARK EVALUATE_WIREFRAME MAKE_CLOUD [EXTRACT_WIREFRAME] [options of unittest]

The tools that are run are scripts made here, but for one test that needs extract_wireframe beside run_benchmark.
"""

import csv
import json
import math
import os
import pathlib
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest

from program_test import BAD_INPUT, SUCCESS, TIME_LIMIT, USAGE_ERROR, Program_test, header_and_points

RUN_BENCHMARK = EVALUATE_WIREFRAME = EXTRACT_WIREFRAME = None
FAILED_CASE, STOPPED = 4, 130   # exit codes of these programs alone

# A tool that knows the truth: it reads what stands beside the cloud, and writes it as wireframe JSON.
PERFECT_TOOL = """
import json, pathlib, sys
cloud, result = sys.argv[1], sys.argv[sys.argv.index("-o") + 1]
truth = json.loads((pathlib.Path(cloud).parent / "truth.json").read_text())
vertices, curves = [], []
def vertex(point):
    if point not in vertices:
        vertices.append(point)
    return vertices.index(point)
for curve in truth["segments"]:
    points = curve["points"]
    n = len(points)
    closed = curve["closed"]
    curves.append({"type": curve["kind"] if curve["kind"] != "spline" else "bspline", "closed": closed,
                   "source": None if closed else vertex(points[0]),
                   "target": None if closed else vertex(points[-1]),
                   "degree": 1, "knots": [0, *range(n), n - 1], "control_points": points})
pathlib.Path(result).write_text(json.dumps({"format": "wireframe", "version": 1, "vertices": vertices,
                                            "curves": curves}))
"""


def script(text, *arguments):
    """A command of the tool that runs a Python script with the cloud and the result."""
    return " ".join(shlex.quote(word) for word in [sys.executable, "-c", text, *(arguments or ("{in}", "-o", "{out}"))])


def shell(text):
    return "sh -c %s sh {in} {out}" % shlex.quote(text)


def remaining_processes(text):
    """The processes with the text in their command line that are still there when killed ones must be gone."""
    deadline = time.monotonic() + 10
    while processes_with(text) and time.monotonic() < deadline:
        time.sleep(0.02)   # who is killed does not end at once
    return processes_with(text)


def processes_with(text):
    result = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if text.encode() in path.read_bytes():
                result.append(path.parent.name)
        except OSError:
            pass
    return result


class Benchmark_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.cases = cls.shared / "cases"
        for family, solid in (("round", "cylinder"), ("flat", "box")):
            cls.make_cloud(cls.cases / family / solid, solid, "--points", 3000, "--fields", "exact,def")

    def run_program(self, program, *arguments, environment=None):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=TIME_LIMIT,
                              cwd=self.folder, env={**os.environ, "TMPDIR": str(self.folder), **(environment or {})})

    def benchmark(self, *arguments, folder=None, code=SUCCESS):
        """Runs the benchmark; returns the finished process, and its rows by (case, field)."""
        table = self.folder / "rows.csv"
        process = self.run_program(RUN_BENCHMARK, folder or self.cases, "--csv", table, *arguments)
        self.assertEqual(process.returncode, code, process.stderr)
        self.assertEqual(list(self.folder.glob("run_benchmark_*")), [])
        with open(table, newline="") as file:
            self.rows = list(csv.DictReader(file))
        return process, {(row["case"], row["field"]): row for row in self.rows}

    def test_raw(self):
        """The tool gets the same points, and nothing else."""
        seen = self.folder / "seen.ply"
        tool = script("import shutil, sys; shutil.copy(sys.argv[1], sys.argv[2])", "{in}", str(seen), "{out}")
        self.benchmark("--raw", "--match", "box", "--fields", "def", "--tool", tool)
        header, points = header_and_points(self.cases / "flat/box/def.ply")
        self.assertIn(b"distance", header)
        data = seen.read_bytes()
        end = data.index(b"end_header\n") + len(b"end_header\n")
        self.assertEqual(data[:end].decode().splitlines(),
                         ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}",
                          "property float x", "property float y", "property float z", "end_header"])
        self.assertEqual(list(struct.iter_unpack("<3f", data[end:])), [p[:3] for p in points])
        cloud = self.cases / "flat/box/def.ply"
        good = cloud.read_bytes()
        for bad, word in ((good.replace(b"binary_little_endian", b"ascii"), "binary PLY files"),
                          (good.replace(b"float z", b"float h"), "no floating point number z"),
                          (good.replace(b"end_header", b"element face 0\nend_header"), "of vertices only"),
                          (good[:-3], "is truncated"), (b"solid", "starts with the line")):
            cloud.write_bytes(bad)
            done = self.run_program(RUN_BENCHMARK, self.cases, "--raw", "--match", "box", "--fields", "def", "--tool", tool)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(word, done.stderr)
        cloud.write_bytes(good)
        if EXTRACT_WIREFRAME:
            _, rows = self.benchmark("--raw", "--match", "box", "--fields", "exact")
            self.assertEqual(rows["box", "exact"]["failure"], "")

    def check_error(self, process, code, *texts):
        self.assertEqual(process.returncode, code, process.stderr)
        self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        for text in texts:
            self.assertIn(text, process.stderr)

    def check_failed(self, row, reason):
        self.assertIn(reason, row["failure"])
        truth = json.loads((self.cases / row["family"] / row["case"] / "truth.json").read_text())
        points = [point for curve in truth["curves"] for point in curve["points"]]
        lower, upper = ([bound(p[k] for p in points) for k in range(3)] for bound in (min, max))
        diagonal = math.dist(lower, upper)
        for name in ("chamfer_distance_r", "hausdorff_distance_r"):
            self.assertAlmostEqual(float(row[name]), diagonal / truth["r"], delta=1e-6 * diagonal / truth["r"])
        for name in ("f1_at_1r", "f1_at_2r", "curve_f1", "long_curve_recall", "corner_recall", "corner_precision"):
            self.assertEqual(float(row[name]), 0)

    # run_benchmark

    def test_perfect_tool(self):
        report = self.folder / "report.md"
        process, rows = self.benchmark("--tool", script(PERFECT_TOOL), "-j", 2, "--markdown", report)
        self.assertEqual(set(rows), {(case, field) for case in ("box", "cylinder") for field in ("exact", "def")})
        for row in rows.values():
            self.assertEqual(row["failure"], "")
            self.assertLess(float(row["chamfer_distance_r"]), 1e-6)
            for name in ("f1_at_1r", "curve_f1", "long_curve_recall", "corner_recall", "corner_precision",
                         "typed_recall", "typed_precision", "curve_count_ratio"):
                self.assertEqual(float(row[name]), 1, name)
            self.assertGreater(float(row["seconds"]), 0.005)
            self.assertTrue(3 < float(row["peak_megabytes"]) < 200)
            self.assertGreater(int(row["points"]), 2000)
        self.assertEqual(rows["box", "exact"]["family"], "flat")
        lines = process.stdout.splitlines()
        self.assertEqual(lines[0].split()[:4], ["family", "field", "n", "fail"])
        self.assertEqual([line.split()[:4] for line in lines[1:]],
                         [["flat", "def", "1", "0"], ["flat", "exact", "1", "0"], ["round", "def", "1", "0"],
                          ["round", "exact", "1", "0"], ["(all)", "def", "2", "0"], ["(all)", "exact", "2", "0"]])
        self.assertEqual(process.stderr.count("\n"), 4)
        self.assertIn("| box ", report.read_text())

    def test_real_tool(self):
        if EXTRACT_WIREFRAME is None:
            self.skipTest("extract_wireframe is not given")
        _, rows = self.benchmark("--fields", "exact", "--timeout", 250, "-j", 2)
        for row in rows.values():
            self.assertEqual(row["failure"], "")
            self.assertLess(float(row["chamfer_distance_r"]), 0.5)

    def test_choice(self):
        tool = ("--tool", script(PERFECT_TOOL), "--quiet")
        process, rows = self.benchmark(*tool, "--fields", "def", "--match", "flat/")
        self.assertEqual(set(rows), {("box", "def")})
        self.assertEqual(process.stderr, "")
        process = self.run_program(RUN_BENCHMARK, *tool, "--fields", "def,exact", self.cases)   # the folder comes last
        self.assertEqual(process.returncode, SUCCESS, process.stderr)
        # a folder of families, a family, and a single case
        for folder in (self.cases / "flat", self.cases / "flat" / "box"):
            _, rows = self.benchmark(*tool, folder=folder)
            self.assertEqual(set(rows), {("box", "exact"), ("box", "def")})
            self.assertEqual({row["family"] for row in rows.values()}, {"flat"})
        # links count as what they lead to, and may lead in circles
        linked = self.folder / "linked"
        linked.mkdir()
        (linked / "case").symlink_to(self.cases / "flat" / "box")
        (linked / "around").symlink_to(linked)
        (linked / "nowhere").symlink_to(self.folder / "missing")
        _, rows = self.benchmark(*tool, folder=linked)
        self.assertEqual(set(rows), {("case", "exact"), ("case", "def")})

    def test_tools_that_fail(self):
        for command, reason in (("false", "exit 1"),
                                (shell("echo first >&2; echo out; echo 'what is wrong' >&2; exit 7"),
                                 "exit 7: what is wrong"),
                                (shell("kill -SEGV $$"), "killed by signal 11"),
                                ("true", "no result was written"),
                                (shell(": > $2"), "is empty"),
                                (shell("echo '{\"curves\": [' > $2"), "is not JSON"),
                                (shell("echo '{\"curves\": []}' > $2"), "there is no curve"),
                                (shell("mkdir $2"), "cannot be")):
            with self.subTest(command=command):
                process, rows = self.benchmark("--tool", command, "-j", 2)
                self.assertEqual(len(rows), 4)
                for row in rows.values():
                    self.check_failed(row, reason)
                self.assertEqual(process.stdout.count("FAIL"), 4)

    def test_one_case_fails(self):
        tool = script("import sys\nif '/box/def' in sys.argv[1]: sys.exit('not this one')\n" + PERFECT_TOOL)
        _, rows = self.benchmark("--tool", tool)
        self.assertEqual((self.rows[0]["case"], self.rows[0]["field"]), ("box", "def"))   # the worst one comes first
        self.check_failed(rows["box", "def"], "exit 1: not this one")
        self.assertEqual([row["failure"] for row in self.rows[1:]], ["", "", ""])

    def test_timeout(self):
        mark = "98765.%d" % os.getpid()
        begin = time.monotonic()
        _, rows = self.benchmark("--tool", shell("sleep %s & sleep %s" % (mark, mark)), "--timeout", 1, "-j", 4)
        self.assertLess(time.monotonic() - begin, 30)
        for row in rows.values():
            self.check_failed(row, "timeout: killed after 1 s")
            self.assertGreaterEqual(float(row["seconds"]), 1)
        self.assertEqual(remaining_processes(mark), [])   # not even children of the tool

    def test_memory(self):
        hungry = script("x = bytearray(700 << 20)\n" + PERFECT_TOOL)
        _, rows = self.benchmark("--tool", hungry, "--memory", 400, "--match", "box", "--fields", "exact")
        self.check_failed(rows["box", "exact"], "exit 1: MemoryError")
        _, rows = self.benchmark("--tool", hungry, "--match", "box", "--fields", "exact")
        self.assertEqual(rows["box", "exact"]["failure"], "")
        self.assertGreater(float(rows["box", "exact"]["peak_megabytes"]), 700)

    def test_sampling_distance(self):
        truth = json.loads((self.cases / "flat" / "box" / "truth.json").read_text())
        tool = script("import sys\nr = float(sys.argv.pop())\nassert abs(r - %r) < 1e-12\n" % truth["r"] + PERFECT_TOOL,
                      "{in}", "-o", "{out}", "{r}")
        _, rows = self.benchmark("--tool", tool, "--match", "box")
        self.assertEqual({row["failure"] for row in rows.values()}, {""})

    def test_compare(self):
        perfect, bad = self.folder / "perfect.csv", self.folder / "bad.csv"
        self.benchmark("--tool", script(PERFECT_TOOL))
        shutil.move(self.folder / "rows.csv", perfect)
        process, _ = self.benchmark("--tool", "false", "--compare", perfect)
        shutil.move(self.folder / "rows.csv", bad)
        self.assertIn("Of 4 cases in both runs: 0 better, 4 worse, 0 mixed, 0 the same.", process.stdout)
        self.assertEqual(process.stdout.count("\nworse "), 4)
        self.assertIn("1.000 -> 0.000", process.stdout)
        report = self.folder / "report.md"
        process, _ = self.benchmark("--tool", script(PERFECT_TOOL), "--compare", bad, "--markdown", report,
                                    "--fields", "exact")
        self.assertIn("Of 2 cases in both runs: 2 better, 0 worse, 0 mixed, 0 the same; 2 only before, 0 only now.",
                      process.stdout)
        self.assertIn("fail -> ok", process.stdout)
        self.assertIn("## Compared with before", report.read_text())
        process, _ = self.benchmark("--tool", script(PERFECT_TOOL), "--compare", perfect)
        self.assertIn("0 better, 0 worse, 0 mixed, 4 the same.", process.stdout)
        # what is compared with may be what is written
        process, _ = self.benchmark("--tool", "false", "--compare", self.folder / "rows.csv")
        self.assertIn("4 worse", process.stdout)

    def test_broken_truth(self):
        cases = self.folder / "cases"
        shutil.copytree(self.cases, cases)
        truth = cases / "flat" / "box" / "truth.json"
        truth.write_text("{")
        process, rows = self.benchmark("--tool", script(PERFECT_TOOL), "--quiet", "--fields", "def", folder=cases,
                                       code=BAD_INPUT)
        self.assertIn(f"error: {truth}: is not JSON", process.stderr)
        self.assertEqual(set(rows), {("cylinder", "def")})   # the other case was run

    def test_wrong_usage(self):
        tool = ("--tool", "false")
        empty = self.folder / "empty"
        empty.mkdir()
        table = self.folder / "table.csv"
        table.write_text("no table\n")
        for arguments, code, texts in (
                ((), USAGE_ERROR, ["DIR"]),
                ((self.cases, "--what"), USAGE_ERROR, ["--what"]),
                ((self.cases, *tool, "-j", 0), USAGE_ERROR, ["-j"]),
                ((self.cases, *tool, "--timeout", -1), USAGE_ERROR, ["--timeout"]),
                ((self.cases, "--tool", "no_such_program"), USAGE_ERROR, ["no_such_program"]),
                ((self.cases, "--tool", "./no/such/program"), USAGE_ERROR, ["./no/such/program"]),
                ((self.cases, "--tool", "sh -c 'open"), USAGE_ERROR, ["quote"]),
                ((self.cases, "--tool", " "), USAGE_ERROR, ["empty"]),
                ((self.cases, *tool, "--csv", "no/such/folder.csv"), USAGE_ERROR, ["no/such/folder.csv"]),
                ((self.cases, *tool, "--markdown", "no/such/folder.md"), USAGE_ERROR, ["no/such/folder.md"]),
                ((self.folder / "missing", *tool), BAD_INPUT, ["missing", "is not a folder"]),
                ((empty, *tool), BAD_INPUT, ["empty", "there is no case"]),
                ((self.cases, *tool, "--fields", "exact,blurred"), BAD_INPUT, ["blurred"]),
                ((self.cases, *tool, "--match", "sphere"), BAD_INPUT, ["sphere"]),
                ((self.cases, *tool, "--compare", "missing.csv"), BAD_INPUT, ["missing.csv"]),
                ((self.cases, *tool, "--compare", table), BAD_INPUT, ["table.csv", "is not a table"])):
            with self.subTest(arguments=arguments):
                self.check_error(self.run_program(RUN_BENCHMARK, *arguments), code, "run_benchmark: error: ", *texts)
        self.assertEqual(self.run_program(RUN_BENCHMARK, "--help").returncode, SUCCESS)

    def test_interrupt(self):
        mark = "87654.%d" % os.getpid()
        tool = shell("sleep %s & sleep %s" % (mark, mark))
        process = subprocess.Popen([RUN_BENCHMARK, self.cases, "--tool", tool, "-j", "2"], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True, env={**os.environ, "TMPDIR": str(self.folder)})
        deadline = time.monotonic() + 30
        while len(list(self.folder.glob("run_benchmark_*/*.txt"))) < 2 and time.monotonic() < deadline:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=30)
        self.assertEqual(process.returncode, STOPPED, errors)
        self.assertIn("stopped", errors)
        self.assertEqual(remaining_processes(mark), [])
        self.assertEqual(list(self.folder.glob("run_benchmark_*")), [])

    # evaluate_wireframe

    def test_evaluation(self):
        truth, result = self.cases / "round" / "cylinder" / "truth.json", self.folder / "result.json"
        subprocess.run([sys.executable, "-c", PERFECT_TOOL, truth.parent / "def.ply", "-o", result], check=True)
        process = self.run_program(EVALUATE_WIREFRAME, truth, result)
        self.assertEqual((process.returncode, process.stderr), (SUCCESS, ""))
        self.assertIn("chamfer_distance", process.stdout)
        process = self.run_program(EVALUATE_WIREFRAME, truth, result, "--json")
        self.assertEqual((process.returncode, process.stderr), (SUCCESS, ""))
        scores = json.loads(process.stdout)
        self.assertIsNone(scores["failure"])
        self.assertEqual((scores["curve_f1"], scores["true_curves"], scores["predicted_chains"]), (1, 2, 2))
        self.assertEqual((scores["true_corners"], scores["corner_precision"]), (0, 1))
        self.assertEqual(scores["sampling_distance"], json.loads(truth.read_text())["r"])

    def test_evaluation_of_nothing_usable(self):
        truth, result = self.cases / "flat" / "box" / "truth.json", self.folder / "result.json"
        for text, reason in ((None, "cannot be opened"), ("{", "is not JSON"), ("{}", "there is no \"curves\""),
                             ('{"curves": []}', "there is no curve")):
            with self.subTest(text=text):
                if text is not None:
                    result.write_text(text)
                process = self.run_program(EVALUATE_WIREFRAME, truth, result, "--json")
                self.check_error(process, FAILED_CASE, "evaluate_wireframe: error: ", str(result), reason)
                scores = json.loads(process.stdout)
                self.assertIn(reason, scores["failure"])
                self.assertEqual(scores["chamfer_distance"], scores["diagonal"])
                self.assertEqual(scores["curve_f1"], 0)

    def test_evaluation_used_wrongly(self):
        truth = self.cases / "flat" / "box" / "truth.json"
        process = self.run_program(EVALUATE_WIREFRAME, "missing.json", truth)
        self.check_error(process, BAD_INPUT, "missing.json: cannot be opened")
        self.assertEqual(process.stdout, "")
        process = self.run_program(EVALUATE_WIREFRAME, truth.parent / "def.ply", truth)
        self.check_error(process, BAD_INPUT, "def.ply: is not JSON")
        self.check_error(self.run_program(EVALUATE_WIREFRAME, truth), USAGE_ERROR, "PREDICTION")
        self.check_error(self.run_program(EVALUATE_WIREFRAME, truth, truth, "--what"), USAGE_ERROR, "--what")
        self.assertEqual(self.run_program(EVALUATE_WIREFRAME, "--help").returncode, SUCCESS)


if __name__ == "__main__":
    programs = [argument for argument in sys.argv[1:5] if os.path.isabs(argument)]
    RUN_BENCHMARK, EVALUATE_WIREFRAME, Program_test.cloud_maker = programs[:3]
    EXTRACT_WIREFRAME = programs[3] if len(programs) > 3 else None
    unittest.main(argv=sys.argv[:1] + sys.argv[1 + len(programs):])
