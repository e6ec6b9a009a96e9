"""Builds the compiled parts of the Python package by CMake. All else is in pyproject.toml.
 WIREFRAME_EXTRACTION_BUILD_FOLDER names a folder that was configured with CMake before; then what is there is taken,
and only what is missing is built. WIREFRAME_EXTRACTION_CMAKE_ARGUMENTS has further arguments for the configuration of a
new one.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.egg_info import manifest_maker

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version():
    """Return the version, which stands in CMakeLists.txt only."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(Wireframe_extraction\s+VERSION\s+([\d.]+)", text)[1]


class Cmake_build(build_ext):
    """Builds the target of the module, and takes its compiled parts."""

    def run(self):
        folder = os.environ.get("WIREFRAME_EXTRACTION_BUILD_FOLDER")
        if folder:
            folder = pathlib.Path(folder).resolve()
        else:
            folder = pathlib.Path(self.build_temp).resolve()
            self.configure(folder)
        subprocess.run(["cmake", "--build", folder, "--config", "Release", "--parallel", str(self.number_of_jobs()),
                        "--target", "wireframe_extraction_python"], check=True)
        self.take(folder / "Wireframe_extraction/python/wireframe_extraction")

    def configure(self, folder):
        """Configure a folder for the module alone."""
        folder.mkdir(parents=True, exist_ok=True)
        off = ("BUILD_TESTING", "WIREFRAME_EXTRACTION_BUILD_EXAMPLES", "WIREFRAME_EXTRACTION_BUILD_BENCHMARKS")
        arguments = ["-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}",
                     "-DWIREFRAME_EXTRACTION_BUILD_PYTHON=ON", *(f"-D{name}=OFF" for name in off),
                     *shlex.split(os.environ.get("WIREFRAME_EXTRACTION_CMAKE_ARGUMENTS", ""))]
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, *arguments], check=True)

    def number_of_jobs(self):
        """Return what was given, or at most two: a compilation of this library takes more than a gigabyte."""
        given = self.parallel or os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL")
        return given or min(2, os.cpu_count() or 1)

    def take(self, folder):
        """Copy the compiled parts to where setuptools wants them."""
        files = [path for path in folder.iterdir() if path.suffix in (".so", ".pyd")] if folder.is_dir() else []
        if not files:
            sys.exit("CMake did not build the Python module; its messages above say what is missing")
        target = pathlib.Path(self.get_ext_fullpath("wireframe_extraction._core")).parent
        target.mkdir(parents=True, exist_ok=True)
        for path in files:
            shutil.copy2(path, target)


# what source archives have, named beside this file; setuptools lists the template itself, and refuses absolute paths
manifest_maker.template = os.path.relpath(pathlib.Path(__file__).resolve().with_name("MANIFEST.in"))

# not build/, which is that of CMake
setup(version=version(), ext_modules=[Extension("wireframe_extraction._core", [])], cmdclass={"build_ext": Cmake_build},
      options={"build": {"build_base": "build-python"}})
