#!/usr/bin/env python3
"""Tests the Snakemake workflow over many clouds.

usage: test_wireframe_snakemake.py SNAKEMAKE EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]
"""

import csv
import os
import pathlib
import shutil
import subprocess

from program_test import TIME_LIMIT, Program_test, main

WORKFLOW = pathlib.Path(__file__).resolve().parents[2] / "examples/Wireframe_extraction/snakemake"


class Snakemake_test(Program_test):
    def setUp(self):
        super().setUp()
        (self.folder / "clouds/a").mkdir(parents=True)
        (self.folder / "clouds/b").mkdir()
        for path in ("box.ply", "clouds/a/part.ply", "clouds/b/part.ply"):
            self.make_cloud(self.folder / path, "box", "--points", 2000)
        (self.folder / "clouds/bad.xyz").write_text("1 2\n")

    def run_workflow(self, *config, is_well=True, options=()):
        settings = {"tool": self.tool, "clouds_per_job": 2, "threads": 1, **dict(word.split("=", 1) for word in config)}
        done = subprocess.run([self.snakemake, "-s", str(WORKFLOW / "Snakefile"),
                               "--profile", str(WORKFLOW / "profiles/local"), *options, "--config",
                               *(f"{key}={value}" for key, value in settings.items())],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8",
                              env={**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache")}, timeout=TIME_LIMIT)
        self.assertEqual(done.returncode == 0, is_well, done.stdout)
        return done.stdout

    def statuses(self):
        with open(self.folder / "results/summary.csv", newline="") as stream:
            return [(row["cloud"], row["status"]) for row in csv.DictReader(stream)]

    def wireframes(self):
        folder = self.folder / "results/wireframes"
        return sorted(str(path.relative_to(folder)) for path in folder.rglob("*.*") if ".batch" not in path.parts)

    def test_folder(self):
        said = self.run_workflow()
        self.assertIn("3 clouds, 1 of them failed", said)
        self.assertEqual(self.statuses(), [("a/part.ply", "ok"), ("b/part.ply", "ok"), ("bad.xyz", "failed")])
        self.assertEqual(self.wireframes(), ["a/part.json", "b/part.json"])
        self.assertEqual(len(list((self.folder / "results/parts").iterdir())), 2)
        self.assertIn("Nothing to be done", self.run_workflow())
        shutil.copy(self.folder / "box.ply", self.folder / "clouds/c.ply")   # one more, and one that is good now
        (self.folder / "clouds/bad.xyz").write_text("".join(f"{x * 0.1} {y * 0.1} 0 {abs(x * 0.1 - 1)}\n"
                                                            for x in range(20) for y in range(20)))
        self.run_workflow(options=["--forcerun", "list_clouds"])
        self.assertEqual(self.statuses(), [("a/part.ply", "skipped"), ("b/part.ply", "skipped"), ("bad.xyz", "ok"),
                                           ("c.ply", "ok")])

    def test_list(self):
        (self.folder / "clouds/list.txt").write_text("# two\nb/part.ply\n\na/part.ply\n")
        self.run_workflow("clouds=clouds/list.txt", "options=--splines-only", "formats=[obj,json]")
        self.assertEqual(self.statuses(), [("b/part.ply", "ok"), ("a/part.ply", "ok")])
        self.assertEqual(self.wireframes(), ["a/part.json", "a/part.obj", "b/part.json", "b/part.obj"])
        self.assertNotIn('"line"', (self.folder / "results/wireframes/a/part.json").read_text())

    def test_killed_job(self):
        os.mkfifo(self.folder / "clouds/b/endless.ply")   # whoever reads it waits for ever
        tool = self.folder / "tool.sh"
        tool.write_text(f"""#!/bin/sh
[ -e killed ] && exec '{self.tool}' "$@"
touch killed
'{self.tool}' "$@" &
while [ ! -e results/wireframes/.batch/records/b/endless.record ]; do sleep 0.1; done
kill -9 $!
rm clouds/b/endless.ply
cp box.ply clouds/b/endless.ply
exit 137
""")
        tool.chmod(0o755)
        said = self.run_workflow(f"tool={tool}", "clouds_per_job=10")
        self.assertIn("Trying to restart job", said)
        self.assertEqual(self.statuses(), [("a/part.ply", "skipped"), ("b/endless.ply", "ok"), ("b/part.ply", "ok"),
                                           ("bad.xyz", "failed")])

    def test_what_is_refused(self):
        self.assertIn("there is no such folder or list", self.run_workflow("clouds=nowhere", is_well=False))
        self.assertIn("there is no cloud in this folder", self.run_workflow("extensions=[pcd]", is_well=False))
        self.run_workflow("options=--no-such-option", "retries=0", is_well=False)
        self.assertFalse((self.folder / "results/summary.csv").exists())


if __name__ == "__main__":
    main("snakemake", "tool", "cloud_maker")
