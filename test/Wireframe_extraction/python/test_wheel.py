"""The wheel, in an environment of its own, used from another folder."""

import os
import subprocess
import sys
import tarfile
import zipfile

import pytest

USER = '''
import sys, time
import numpy
start = time.perf_counter()
import wireframe_extraction
seconds = time.perf_counter() - start
assert wireframe_extraction.__file__.startswith(sys.prefix), wireframe_extraction.__file__
assert seconds < 2, seconds
for name in ("pandas", "networkx", "matplotlib", "h5py", "scipy", "pyvista", "concurrent.futures.process"):
    assert name not in sys.modules, name
assert "wireframe_extraction._cad" not in sys.modules
wireframe = wireframe_extraction.extract(sys.argv[1])
wireframe.write("wireframe.json")
print(wireframe)
'''


@pytest.fixture(scope="module")
def wheel(root, tmp_path_factory):
    build_folder = os.environ.get("WIREFRAME_EXTRACTION_BUILD_FOLDER")
    if not build_folder:
        pytest.skip("WIREFRAME_EXTRACTION_BUILD_FOLDER names no build that can be packed")
    pytest.importorskip("build")
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, root]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout
    return next(folder.glob("*.whl"))


def test_source_archive(root, tmp_path):
    pytest.importorskip("build")
    command = [sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", tmp_path, root]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout
    with tarfile.open(next(tmp_path.glob("*.tar.gz"))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert {"CMakeLists.txt", "LICENSE", "README.md", "pyproject.toml"} <= names
    # what is compiled, and what CMake reads
    for folder in ("Wireframe_extraction", "benchmark/Wireframe_extraction/include"):
        files = {path.relative_to(root).as_posix() for path in (root / folder).rglob("*") if path.is_file()}
        assert {name for name in files if "__pycache__" not in name and not name.endswith(".so")} <= names
    assert not any(name.startswith(("build", "test")) for name in names)


def test_content(wheel, root):
    names = set(zipfile.ZipFile(wheel).namelist())
    folder = root / "Wireframe_extraction/python/wireframe_extraction"
    sources = {path.name for path in folder.iterdir() if path.is_file()}
    assert {f"wireframe_extraction/{name}" for name in sources} <= names
    assert any(name.startswith("wireframe_extraction/_core.") and not name.endswith(".pyi") for name in names)
    assert wheel.stat().st_size < 10e6


def test_clean_environment(wheel, data, tmp_path):
    # NumPy comes from the system, and nothing else
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv"], check=True)
    python = tmp_path / "venv/bin/python"
    install = [python, "-m", "pip", "install", "--no-index", "--no-deps", "--quiet", wheel]
    subprocess.run(install, check=True)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run([python, "-c", USER, data / "box_with_hole.ply"], cwd=elsewhere, env=environment, check=True,
                          stdout=subprocess.PIPE, encoding="utf-8")
    assert done.stdout.strip() == "<Wireframe: 8 vertices, 14 curves>" and (elsewhere / "wireframe.json").exists()
