"""The examples, and the one of the README, as they stand there."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys

import pytest

import wireframe_extraction


def start(code, folder, *arguments):
    """Start a program in a folder."""
    package = pathlib.Path(wireframe_extraction.__file__).parent.parent
    environment = {**os.environ, "PYTHONPATH": str(package)}
    return subprocess.Popen([sys.executable, *code, *map(str, arguments)], cwd=folder, encoding="utf-8", env=environment,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def run(code, folder, *arguments, status=0):
    """Run a program in a folder, and return what it prints."""
    with start(code, folder, *arguments) as process:
        printed, errors = process.communicate()
    assert process.returncode == status, errors
    return printed + (errors if status else "")


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


def workers_of(process):
    """Return the processes that a program of Dask has started for its work."""
    children = pathlib.Path(f"/proc/{process.pid}/task").glob("*/children")
    numbers = {int(number) for path in children for number in path.read_text().split()}
    return [number for number in numbers if b"spawn_main" in pathlib.Path(f"/proc/{number}/cmdline").read_bytes()]


@pytest.mark.skipif(not pathlib.Path("/proc/self/task").exists(), reason="needs Linux")
def test_dask(root, data, tmp_path):
    pytest.importorskip("distributed")
    (tmp_path / "clouds").mkdir()
    for name in ("0.ply", "1.ply", "2.ply", "2.off"):
        shutil.copy(data / "box_with_hole.ply", tmp_path / f"clouds/{name}")
    (tmp_path / "clouds/2.off").write_text("OFF\n")
    (tmp_path / "clouds/bad.ply").write_text("no cloud")
    command = [root / "examples/Wireframe_extraction/python/dask_example.py"]
    with start(command, tmp_path, "clouds", "wireframes", "--pattern", "*.*") as process:
        printed = [process.stdout.readline() for _ in range(2)]   # something is done, or failed
        for worker in workers_of(process)[:1]:   # its cloud goes to another one
            os.kill(worker, signal.SIGKILL)
        printed = "".join([*printed, process.communicate()[0]])
    assert printed.count("14 curves") == 3 and "bad.ply: failed" in printed and process.returncode == 1, printed
    assert sorted(os.listdir(tmp_path / "wireframes")) == ["0.json", "1.json", "2.ply.json"]
    (tmp_path / "clouds/bad.ply").unlink()
    (tmp_path / "clouds/2.off").unlink()
    (tmp_path / "wireframes/2.ply.json").rename(tmp_path / "wireframes/2.json")
    assert "3 of them done before" in run(command, tmp_path, "clouds", "wireframes")
    assert "no folder" in run(command, tmp_path, "missing", "wireframes", status=2)
