"""The examples, and the one of the README, as they stand there."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import wireframe_extraction


def run(code, folder, *arguments):
    """Run a program in a folder, and return what it prints."""
    package = pathlib.Path(wireframe_extraction.__file__).parent.parent
    environment = {**os.environ, "PYTHONPATH": str(package)}
    done = subprocess.run([sys.executable, *code, *map(str, arguments)], cwd=folder, check=False, encoding="utf-8",
                          env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("name, text", [("one_call_example", "14 curves"), ("holes_example", "diameter"),
                                        ("stages_example", "of one cluster")])
def test_example(root, tmp_path, name, text):
    if name == "holes_example":
        pytest.importorskip("pandas")
    assert text in run([root / f"examples/Wireframe_extraction/python/{name}.py"], tmp_path)


def test_readme(root, data, tmp_path):
    pytest.importorskip("pandas")
    code = re.search(r"```python\n(.*?)```", (root / "README.md").read_text(encoding="utf-8"), re.S)[1]
    shutil.copy(data / "box_with_hole.ply", tmp_path / "cloud.ply")
    if not list(pathlib.Path(wireframe_extraction.__file__).parent.glob("_cad.*.so")):
        code = code.replace("part.step", "part.json")
    assert "circle" in run(["-c", code], tmp_path)


def test_dask(root, data, tmp_path):
    pytest.importorskip("distributed")
    (tmp_path / "clouds").mkdir()
    for number in range(3):
        shutil.copy(data / "box_with_hole.ply", tmp_path / f"clouds/{number}.ply")
    (tmp_path / "clouds/bad.ply").write_text("no cloud")
    command = [root / "examples/Wireframe_extraction/python/dask_example.py"]
    printed = run(command, tmp_path, "clouds", "wireframes")
    assert printed.count("14 curves") == 3 and "bad.ply: failed" in printed
    assert sorted(os.listdir(tmp_path / "wireframes")) == ["0.json", "1.json", "2.json"]
    assert "3 of them done before" in run(command, tmp_path, "clouds", "wireframes")
