#!/usr/bin/env python3
"""Tests the batches of the command line tool extract_wireframe from the outside.

usage: test_wireframe_batch.py EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
import urllib.parse

from program_test import BAD_INPUT, BUSY, NO_FEATURE, SOME_FAILED, SUCCESS, TIME_LIMIT, USAGE_ERROR, Program_test, main

COLUMNS = ["cloud", "status", "exit_code", "error", "seconds", "processor_seconds", "peak_megabytes", "points", "r",
           "curves", "corners", "types", "doubtful", "rms", "mesh", "warnings", "outputs"]


def children_of(process):
    """The ids of the processes that a process has started, on Linux."""
    result = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            words = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue   # it has ended meanwhile
        if int(words[1]) == process and words[0] != "Z":
            result.append(int(path.parent.name))
    return result


def is_alive(process):
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def wait_until(condition, what):
    end = time.monotonic() + TIME_LIMIT
    while not condition():
        assert time.monotonic() < end, f"it takes too long until {what}"
        time.sleep(0.02)


class Batch_test(Program_test):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for shape in ("box", "cylinder"):
            cls.make_cloud(f"{shape}.ply", shape, "--points", 2000)

    # ---- pages and pictures ----

    def test_index(self):
        """All clouds are on one page, with their pictures and pages beside it."""
        version = self.execute(self.folder, "--version").stdout
        formats = [name for name in ("html", "png") if not re.search(rf"--{name} +not built in", version)]
        if not formats:
            self.skipTest("the tool is built without --html and --png")
        for name in ("a.ply", "b/größe & co.ply", "broken.ply"):
            self.put(name)
        (self.folder / "broken.ply").write_text("ply <b>\n")
        self.put_list("a.ply", "b/größe & co.ply", "broken.ply")
        arguments = ["--format", "json", *sum((["--format", name] for name in formats), [])]
        for _ in range(2):   # the second time, what is there is shown
            done = self.run_batch(*arguments, code=SOME_FAILED)
            self.assertIn("index.html", done.stdout)
            page = (self.folder / "out/index.html").read_text()
            self.assertEqual(page.count("<tr class="), 3)
            self.assertIn('<tr class="failed">', page)
            self.assertNotIn("<b>", page)
            self.assertIn("größe &amp; co.ply", page)
            self.assertNotIn("http", page)   # it needs no network
            self.assertEqual(page.count("<td>12 lines</td>"), 2)
            addresses = [urllib.parse.unquote(name) for name in re.findall(r'(?:src|href)="([^"]+)"', page)]
            self.assertGreaterEqual(len(addresses), 2 * (1 + 2 * len(formats)))
            for name in addresses:
                self.assertGreater((self.folder / "out" / name).stat().st_size, 100)
        with open(self.folder / "out/summary.csv", newline="", encoding="utf-8") as file:
            row = next(csv.DictReader(file))
        self.assertEqual((row["types"], row["doubtful"]), ("12 lines", "0"))
        self.assertTrue(0 < float(row["rms"]) < float(row["r"]))
        self.run_batch(*arguments, "--part", "1/2", output="parts")   # the first two
        page = (self.folder / "parts/index-1-of-2.html").read_text()
        self.assertEqual((page.count("<tr class="), page.count("<td>12 lines</td>")), (2, 2))
        (self.folder / "out/index.html").write_text("mine")
        self.assertIn("index.html", self.run_batch(*arguments, code=USAGE_ERROR).stderr)
        self.assertEqual((self.folder / "out/index.html").read_text(), "mine")
        self.put("index.ply")
        self.put_list("index.ply")
        if "html" in formats:
            self.run_batch(*arguments, code=BAD_INPUT, output="other")
        self.put_list("a.ply")
        self.run_batch(output="plain")
        self.assertFalse((self.folder / "plain/index.html").exists())

    # ---- tools ----

    def put(self, name, source="box.ply"):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(self.shared / source, path)

    def put_list(self, *lines, name="list.txt"):
        (self.folder / name).write_text("".join(line + "\n" for line in lines))

    def put_endless_cloud(self, name):
        """Whoever reads it waits for ever, as nobody writes to this pipe."""
        os.mkfifo(self.folder / name)

    def run_batch(self, *arguments, code=SUCCESS, list_name="list.txt", output="out", stdin=""):
        done = self.execute(self.folder, "--batch", list_name, "--output-dir", output, *arguments, input=stdin)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def refuse(self, code, words, *arguments):
        """The batch must not start; it says why in one line, and makes nothing."""
        before = self.files(".")
        done = self.run_batch(*arguments, code=code)
        self.assertRegex(done.stderr, r"\Aextract_wireframe: error: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(self.files("."), before)

    def start_batch(self, *arguments):
        process = subprocess.Popen([self.tool, "--batch", "list.txt", "--output-dir", "out", *map(str, arguments)],
                                   cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, encoding="utf-8")
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def summary(self, name="out/summary.csv"):
        with open(self.folder / name, newline="", encoding="utf-8", errors="surrogateescape") as stream:
            rows = list(csv.reader(stream))
        self.assertEqual(rows[0], COLUMNS)
        self.assertEqual({len(row) for row in rows}, {len(COLUMNS)})
        return [dict(zip(COLUMNS, row)) for row in rows[1:]]

    def statuses(self, name="out/summary.csv"):
        return [(row["cloud"], row["status"]) for row in self.summary(name)]

    def files(self, name="out"):
        """All but what the batch keeps for itself."""
        folder = self.folder / name
        return sorted(str(path.relative_to(folder)) for path in folder.rglob("*")
                      if path.is_file() and ".batch" not in path.parts)

    def read_bytes(self, name):
        return (self.folder / name).read_bytes()

    def changed_time(self, name):
        return (self.folder / name).stat().st_mtime_ns

    # ---- what works ----

    def test_meshes(self):
        """The summary tells what each mesh was taken for, also where that is why nothing was found."""
        corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
        for name, some in (("box.obj", faces), ("flat.obj", faces[:1])):
            (self.folder / name).write_text("".join("v %g %g %g\n" % p for p in corners) + "".join(
                "f " + " ".join(str(v + 1) for v in face) + "\n" for face in some))
        self.put("cloud.ply")
        self.put_list("box.obj", "flat.obj", "cloud.ply", "none.obj")
        self.run_batch("--maximum-number-of-points", 5000, code=SOME_FAILED)
        self.assertEqual([(row["status"], row["exit_code"], row["mesh"]) for row in self.summary()],
                         [("ok", "0", "cad"), ("failed", str(NO_FEATURE), "cad"), ("ok", "0", ""),
                          ("failed", str(BAD_INPUT), "")])
        self.run_batch("--mesh", "scan", code=SOME_FAILED)
        self.assertEqual([row["mesh"] for row in self.summary()], ["scan", "scan", "", ""])

    def test_good_and_bad_clouds(self):
        self.put("in/a/part.ply")
        self.put("in/b/part.ply", "cylinder.ply")
        self.put("in/bad.ply")
        os.truncate(self.folder / "in/bad.ply", 500)
        (self.folder / "in/flat.xyz").write_text("".join(f"{x * 0.1} {y * 0.1} 0 {x * 0.1 + 1}\n"
                                                           for x in range(20) for y in range(20)))
        (self.folder / "in/list.txt").write_text("\ufeff# clouds\r\n\r\n  a/part.ply\t\r\nmissing.ply\nbad.ply\n"
                                                 "flat.xyz\n"
                                                 f"{self.folder.resolve()}/in/b/part.ply", encoding="utf-8")
        done = self.run_batch("--format", "json", "--format", "polylines.txt", list_name="in/list.txt",
                              code=SOME_FAILED)
        self.assertIn("3 of 5 clouds failed", done.stderr)
        for name in ("missing.ply", "bad.ply", "flat.xyz"):   # each is told by its name, and by that once
            line, = [line for line in done.stderr.splitlines() if name in line]
            self.assertRegex(line, f"\\Afailed: in/{name}: ")
            self.assertEqual(line.count(name), 1)
        self.assertEqual(self.files(), ["a/part.json", "a/part.polylines.txt", "b/part.json", "b/part.polylines.txt",
                                        "summary.csv"])
        box, missing, bad, flat, cylinder = self.summary()
        self.assertEqual([box["cloud"], box["status"], box["exit_code"], box["error"], box["points"], box["curves"],
                          box["corners"], box["outputs"]],
                         ["a/part.ply", "ok", "0", "", "2000", "12", "8", "a/part.json;a/part.polylines.txt"])
        self.assertEqual((cylinder["status"], cylinder["curves"], cylinder["corners"]), ("ok", "2", "0"))
        wireframe = json.loads((self.folder / "out/a/part.json").read_text())
        self.assertEqual(len(wireframe["curves"]), 12)
        self.assertAlmostEqual(float(box["r"]), wireframe["sampling_distance"])
        for row in (box, cylinder):
            self.assertGreater(float(row["seconds"]), 0)
            self.assertGreater(float(row["processor_seconds"]), 0)
            self.assertGreater(float(row["peak_megabytes"]), 1)
        for row, code, word in ((missing, BAD_INPUT, "missing.ply"), (bad, BAD_INPUT, "truncated"),
                                (flat, NO_FEATURE, "plane")):
            self.assertEqual((row["status"], row["exit_code"], row["points"], row["outputs"]),
                             ("failed", str(code), "", ""))
            self.assertIn(word, row["error"])

    def test_same_as_single_clouds(self):
        self.put("a.ply")
        self.put_list("a.ply")
        self.run_batch("--splines-only")
        self.run_tool("a.ply", "-o", "a.json", "--splines-only")
        self.assertEqual(self.read_bytes("out/a.json"), self.read_bytes("a.json"))

    def test_output(self):
        self.put("a.ply")
        self.put_list("a.ply", "missing.ply")
        loud = self.run_batch(code=SOME_FAILED)
        self.assertRegex(loud.stdout,
                         r"Clouds +2: 1 ok, 0 done before, 1 failed, 0 pending\nSummary +out/summary.csv\n")
        self.assertIn("failed: missing.ply: ", loud.stderr)
        quiet = self.run_batch("--quiet", code=SOME_FAILED)
        self.assertEqual(quiet.stdout, "")
        self.assertRegex(quiet.stderr, r"\Aextract_wireframe: error: 1 of 2 clouds failed; out/summary.csv [^\n]+\n\Z")

    def test_names_from_standard_input(self):
        self.put("sub/a.ply")
        self.put("sub/deep/b.ply")
        self.run_batch("--summary", "table.csv", list_name="-", stdin="sub/a.ply\nsub/deep/../deep/b.ply\n")
        self.assertEqual(self.files(), ["sub/a.json", "sub/deep/b.json"])
        self.assertEqual(self.statuses("table.csv"), [("sub/a.ply", "ok"), ("sub/deep/../deep/b.ply", "ok")])
        self.run_batch("--input-dir", "sub", list_name="-", output="other", stdin="a.ply\n../sub/deep/b.ply\n")
        self.assertEqual(self.files("other"), ["a.json", "deep/b.json", "summary.csv"])

    def test_clouds_from_elsewhere(self):
        """What is not below the folder of the list keeps its whole path."""
        self.put("clouds/a.ply")
        (self.folder / "lists").mkdir()
        self.put_list("../clouds/a.ply", name="lists/list.txt")
        self.run_batch(list_name="lists/list.txt")
        name = (self.folder.resolve() / "clouds/a.json").relative_to("/")
        self.assertEqual(self.files(), sorted([str(name), "summary.csv"]))

    @unittest.skipUnless(sys.platform == "linux", "file names are bytes")
    def test_any_name(self):
        names = ["a b.ply", 'say "a, b".ply', "-o.ply", "\u00e9.ply", os.fsdecode(b"\xe9.ply"), "a;b.x.ply",
                 "a.record.ply", "a.ply"]
        for name in names:
            self.put(name)
        (self.folder / "list.txt").write_bytes(b"".join(os.fsencode(name) + b"\n" for name in names))
        self.run_batch("--format", "obj", "--format", ".json")
        self.assertEqual(self.statuses(), [(name, "ok") for name in names])
        self.assertEqual(len(self.files()), 2 * len(names) + 1)
        self.run_batch("--format", "json", "--format", "obj")
        self.assertEqual(self.statuses(), [(name, "skipped") for name in names])

    def test_names_that_cannot_be(self):
        """A cloud whose outputs have no place does not stop the others."""
        self.put("a.ply")
        self.put("a.json/b.ply")   # a folder where a file is to be
        self.put("c.ply")
        self.put("a.record/d.ply")
        self.put_list("a.ply", "a.json/b.ply", "a.record/d.ply", "c.ply")
        self.run_batch("--jobs", 1, code=SOME_FAILED)
        self.assertEqual(self.statuses(), [("a.ply", "ok"), ("a.json/b.ply", "failed"), ("a.record/d.ply", "failed"),
                                           ("c.ply", "ok")])
        self.assertEqual(self.files(), ["a.json", "c.json", "summary.csv"])

    # ---- going on ----

    def test_finished_clouds_are_skipped(self):
        self.put("a.ply")
        self.put("b.ply", "cylinder.ply")
        self.put_list("a.ply", "missing.ply")
        self.run_batch(code=SOME_FAILED)
        before = self.changed_time("out/a.json")
        first = self.summary()[0]
        self.put("missing.ply")
        self.put_list("b.ply", "a.ply", "missing.ply")
        self.run_batch()
        self.assertEqual(self.statuses(), [("b.ply", "ok"), ("a.ply", "skipped"), ("missing.ply", "ok")])
        self.assertEqual(self.changed_time("out/a.json"), before)
        self.assertEqual(dict(self.summary()[1], status="ok"), first)

    def test_failed_clouds(self):
        self.put_list("missing.ply")
        self.run_batch("--keep-failed", code=SOME_FAILED)
        first = self.summary()
        (record,) = (self.folder / "out/.batch/records").iterdir()
        before = self.changed_time(record)
        self.run_batch("--keep-failed", code=SOME_FAILED)
        self.assertEqual(self.summary(), first)   # with the seconds of then
        self.assertEqual(self.changed_time(record), before)
        self.run_batch(code=SOME_FAILED)
        self.assertNotEqual(self.changed_time(record), before)
        self.put("missing.ply")
        self.run_batch("--keep-failed")
        self.assertEqual(self.statuses(), [("missing.ply", "ok")])

    def test_changed_cloud(self):
        for name in ("a.ply", "b.ply"):
            self.put(name)
        self.put_list("a.ply", "b.ply")
        self.run_batch()
        self.put("a.ply", "cylinder.ply")
        done = self.run_batch()
        self.assertIn("changed since", done.stderr)
        self.assertEqual(self.statuses(), [("a.ply", "ok"), ("b.ply", "skipped")])
        self.assertEqual(self.summary()[0]["curves"], "2")
        (self.folder / "b.ply").unlink()
        self.run_batch(code=SOME_FAILED)
        self.assertEqual(self.statuses(), [("a.ply", "skipped"), ("b.ply", "failed")])
        self.assertEqual(self.files(), ["a.json", "summary.csv"])   # nothing of what is no more

    def test_changed_options(self):
        self.put("a.ply")
        self.put_list("a.ply")
        self.run_batch("--smooth-angle", 20)
        self.run_batch("--jobs", 1, "--threads", 1, "--timeout", 100, "--quiet")   # 20 is the default
        self.assertEqual(self.statuses(), [("a.ply", "skipped")])
        done = self.run_batch("--splines-only", "--smooth-angle", 25)
        self.assertIn("other options", done.stderr)
        self.assertIn("--smooth-angle 25", done.stderr)
        self.assertEqual(self.statuses(), [("a.ply", "ok")])
        self.assertNotIn('"line"', (self.folder / "out/a.json").read_text())
        self.run_batch("--format", "obj", "--splines-only", "--smooth-angle", 25)
        self.assertEqual((self.statuses(), self.files()), ([("a.ply", "ok")], ["a.obj", "summary.csv"]))

    def test_lost_output(self):
        self.put("a.ply")
        self.put_list("a.ply")
        self.run_batch("--format", "json", "--format", "obj")
        good = self.read_bytes("out/a.obj")
        for spoil in (lambda path: path.unlink(), lambda path: os.truncate(path, 10)):
            spoil(self.folder / "out/a.obj")
            self.run_batch("--format", "json", "--format", "obj")
            self.assertEqual((self.statuses(), self.read_bytes("out/a.obj")), ([("a.ply", "ok")], good))

    def test_spoilt_record(self):
        self.put("a.ply")
        self.put_list("a.ply")
        self.run_batch()
        (self.folder / "out/.batch/records/a.record").write_text('{"state": 2, "sett')
        self.run_batch()
        self.assertEqual(self.statuses(), [("a.ply", "ok")])

    @unittest.skipUnless(sys.platform == "linux", "needs to know when its parent dies")
    def test_killed(self):
        self.put("a.ply")
        self.put_endless_cloud("b.ply")
        self.put("c.ply", "cylinder.ply")
        self.put_list("a.ply", "b.ply", "c.ply")
        process = self.start_batch("--jobs", 1)
        wait_until((self.folder / "out/.batch/records/b.record").exists, "the second cloud is started")
        wait_until(lambda: children_of(process.pid), "it has a process")
        children = children_of(process.pid)
        process.kill()
        process.wait()
        wait_until(lambda: not any(map(is_alive, children)), "its process is gone")
        self.assertEqual(self.files(), ["a.json"])
        before = self.changed_time("out/a.json")
        (self.folder / "b.ply").unlink()
        self.put("b.ply", "cylinder.ply")
        self.run_batch()
        self.assertEqual(self.statuses(), [("a.ply", "skipped"), ("b.ply", "ok"), ("c.ply", "ok")])
        self.assertEqual(self.changed_time("out/a.json"), before)
        self.assertEqual(self.files(), ["a.json", "b.json", "c.json", "summary.csv"])
        self.assertEqual(sorted(path.name for path in (self.folder / "out/.batch").iterdir()),
                         ["lock", "lock-all", "records"])

    def test_killed_between_output_and_record(self):
        """A file that stands there without its record being complete is ours still."""
        self.put("a.ply")
        self.put_list("a.ply")
        self.run_batch()
        path = self.folder / "out/.batch/records/a.record"
        record = json.loads(path.read_text())
        record["state"] = 1
        path.write_text(json.dumps(record))
        self.run_batch()
        self.assertEqual(self.statuses(), [("a.ply", "ok")])

    @unittest.skipUnless(sys.platform == "linux", "looks for processes in /proc")
    def test_interrupted(self):
        self.put("a.ply")
        self.put_endless_cloud("b.ply")
        self.put_list("a.ply", "b.ply", "missing.ply")
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start_batch("--jobs", 1)
            wait_until((self.folder / "out/.batch/records/b.record").exists, "the second cloud is started")
            wait_until(lambda: children_of(process.pid), "it has a process")
            children = children_of(process.pid)
            process.send_signal(number)
            self.assertEqual(process.wait(TIME_LIMIT), 128 + number)
            self.assertFalse(any(map(is_alive, children)))
            self.assertEqual(self.statuses(), [("a.ply", "ok"), ("b.ply", "pending"), ("missing.ply", "pending")])
            self.assertEqual(self.files(), ["a.json", "summary.csv"])
            self.assertFalse((self.folder / "out/.batch/records/b.record").exists())
            shutil.rmtree(self.folder / "out")

    # ---- limits ----

    def test_time_out(self):
        self.put_endless_cloud("a.ply")
        self.put_list("a.ply", "missing.ply")
        self.run_batch("--timeout", 1.5, "--jobs", 1, code=SOME_FAILED)
        late, missing = self.summary()
        self.assertEqual((late["status"], late["exit_code"], missing["exit_code"]), ("failed", "124", str(BAD_INPUT)))
        self.assertIn("took longer than 1.5 seconds (--timeout)", late["error"])
        self.assertTrue(1.5 <= float(late["seconds"]) < 10, late)

    def test_memory_limit(self):
        (self.folder / "a.xyz").write_text("".join(f"{i} {i % 7} {i % 5} {i % 3}\n" for i in range(300000)))
        self.put_list("a.xyz")
        self.run_batch("--memory-limit", 10, code=SOME_FAILED)
        row, = self.summary()
        self.assertEqual(row["status"], "failed")
        self.assertIn("memory", row["error"])

    @unittest.skipUnless(sys.platform == "linux", "looks for processes in /proc")
    def test_crash(self):
        self.put_endless_cloud("a.ply")
        self.put("b.ply")
        self.put_list("a.ply", "b.ply")
        process = self.start_batch("--jobs", 1)
        wait_until(lambda: children_of(process.pid), "there is a process")
        time.sleep(0.2)   # until it waits for its cloud
        os.kill(children_of(process.pid)[0], signal.SIGKILL)
        self.assertEqual(process.wait(TIME_LIMIT), SOME_FAILED)
        crashed, good = self.summary()
        self.assertEqual((crashed["status"], crashed["exit_code"], good["status"]), ("failed", "137", "ok"))
        self.assertIn("crashed: signal 9", crashed["error"])

    # ---- several at once ----

    @unittest.skipUnless(sys.platform == "linux", "looks for processes in /proc")
    def test_two_at_once(self):
        self.put_endless_cloud("a.ply")
        self.put("b.ply")
        self.put_list("a.ply", "b.ply")
        process = self.start_batch("--part", "1/2")
        wait_until((self.folder / "out/.batch/records/a.record").exists, "the first batch is at work")
        for arguments in ([], ["--part", "1/2"], ["--part", "2/3"], ["--part", "2/2", "--splines-only"]):
            done = self.run_batch(*arguments, code=BUSY)
            self.assertIn("another batch is at work there", done.stderr)
        self.run_batch("--part", "2/2")   # which shares no cloud with the other part
        self.assertEqual(self.statuses("out/summary-2-of-2.csv"), [("b.ply", "ok")])
        process.terminate()
        self.assertEqual(process.wait(TIME_LIMIT), 128 + signal.SIGTERM)
        (self.folder / "a.ply").unlink()
        self.put("a.ply")
        self.run_batch()
        self.assertEqual(self.statuses(), [("a.ply", "ok"), ("b.ply", "skipped")])

    def test_parts(self):
        names = [f"{i}.ply" for i in range(7)]
        self.put_list(*names)
        for part in range(1, 4):
            self.run_batch("--part", f"{part}/3", code=SOME_FAILED)
        rows = sum((self.summary(f"out/summary-{part}-of-3.csv") for part in range(1, 4)), [])
        self.assertEqual([row["cloud"] for row in rows], names)
        self.run_batch("--part", "9/9")   # there may be more parts than clouds
        self.assertEqual(self.summary("out/summary-9-of-9.csv"), [])

    # ---- what is refused ----

    def test_clouds_with_one_output(self):
        for first, second, words in (("a.ply", "a.xyz", ["list.txt:3", "a.ply of line 1", "a.*"]),
                                     ("sub/a.ply", "sub/a.ply", ["list.txt:3", "stands already in line 1"]),
                                     ("sub/a.ply", "sub/../sub/a.ply", ["list.txt:3", "line 1"])):
            self.put_list(first, "b.ply", second)
            self.refuse(BAD_INPUT, words)

    def test_bad_lists(self):
        self.refuse(BAD_INPUT, ["list.txt"])
        for text, words in ((b"", ["names no cloud"]), (b"# none\n\n", ["names no cloud"]),
                            (b"a.ply\nb\0c\n", ["list.txt:2", "zero byte"]),
                            (b"a.ply\nsub/\n", ["list.txt:2", "folder"]),
                            (b".batch/a.ply\n", ["list.txt:1", "batch itself"])):
            (self.folder / "list.txt").write_bytes(text)
            done = self.run_batch(code=BAD_INPUT)
            for word in words:
                self.assertIn(word, done.stderr)
            self.assertNotIn("summary.csv", self.files("."))

    def test_usage(self):
        self.put("a.ply")
        self.put_list("a.ply")
        for words, arguments in ((["--batch", "--output"], ["-o", "x.json"]), (["CLOUD"], ["a.ply"]),
                                 (["--stages"], ["--stages", "x"]), (["--distances"], ["--distances", "x"]),
                                 ([".xyz", "known are"], ["--format", "xyz"]), (["0/2"], ["--part", "0/2"]),
                                 (["3/2"], ["--part", "3/2"]), (["twice"], ["--format", "obj", "--format", ".obj"]),
                                 (["1/x"], ["--part", "1/x"]), (["\"0\""], ["--jobs", 0]),
                                 (["-1"], ["--timeout", -1]), (["\"x\""], ["--memory-limit", "x"]),
                                 (["list.txt", "summary"], ["--summary", "list.txt"]),
                                 (["nowhere", "--input-dir"], ["--input-dir", "nowhere"]),
                                 (["--view", "--png"], ["--view", "top"]),
                                 (["--obj-splines", ".obj"], ["--format", "polylines.txt", "--obj-splines"])):
            self.refuse(USAGE_ERROR, words, *arguments)
        for arguments in (["--batch", "list.txt"], ["--jobs", "2", "a.ply", "-o", "a.json"]):
            self.run_tool(*arguments, code=USAGE_ERROR)

    def test_foreign_files_stay(self):
        self.put("a.ply")
        self.put("b.ply")
        self.put_list("a.ply", "b.ply")
        cloud = self.read_bytes("a.ply")
        self.run_batch("--format", "ply", output=".", code=SOME_FAILED)
        for row in self.summary("summary.csv"):
            self.assertEqual(row["status"], "failed")
            self.assertIn("no batch has made it", row["error"])
        self.assertEqual(self.read_bytes("a.ply"), cloud)

    def test_output_that_became_a_cloud(self):
        self.put("in/a.ply")
        (self.folder / "list.txt").write_text("in/a.ply\n")
        self.run_batch("--format", "ply", "--input-dir", "in", code=SOME_FAILED)
        (self.folder / "list.txt").write_text("a.ply\n")
        self.run_batch("--format", "ply", "--input-dir", "in")
        made = self.read_bytes("out/a.ply")
        self.run_batch("--input-dir", "out", code=SOME_FAILED)
        self.assertIn("is a cloud now", self.summary()[0]["error"])
        self.assertEqual(self.read_bytes("out/a.ply"), made)

    def test_summary_is_no_output(self):
        self.put("summary.ply")
        self.put_list("summary.ply")
        done = self.run_batch("--format", "csv", code=BAD_INPUT)
        self.assertIn("--summary", done.stderr)
        self.run_batch("--format", "csv", "--summary", "table.csv")
        self.assertEqual(self.statuses("table.csv"), [("summary.ply", "ok")])


if __name__ == "__main__":
    main("tool", "cloud_maker")
