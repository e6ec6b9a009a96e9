"""What the tests of the Python module share. CMake tells where things are in variables of the environment."""

import os
import pathlib
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, os.environ.get("WIREFRAME_EXTRACTION_PACKAGE_FOLDER",
                                  str(ROOT / "build/Wireframe_extraction/python")))

import wireframe_extraction  # noqa: E402


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def data():
    return ROOT / "examples/Wireframe_extraction/data"


def program(name):
    """Return the path of a program that was built, or skip the test."""
    path = pathlib.Path(os.environ.get("WIREFRAME_EXTRACTION_PROGRAMS_FOLDER", ROOT / "build/bin")) / name
    if not path.exists():
        pytest.skip(f"{name} is not built")
    return str(path)


@pytest.fixture(scope="session")
def tool():
    return program("extract_wireframe")


@pytest.fixture(scope="session")
def evaluator():
    return program("evaluate_wireframe")


def make_cylinder(number_of_points, seed=1):
    """Return points of a closed cylinder with radius 1 and height 2, and their exact distances to its two circles."""
    random = np.random.default_rng(seed)
    angles = random.uniform(0, 2 * np.pi, number_of_points)
    half = number_of_points // 2
    radii, heights = np.ones(number_of_points), random.uniform(-1, 1, number_of_points)
    radii[half:] = np.sqrt(random.uniform(0, 1, number_of_points - half))
    heights[half:] = random.choice([-1.0, 1.0], number_of_points - half)
    points = np.column_stack([radii * np.cos(angles), radii * np.sin(angles), heights])
    return points, np.hypot(radii - 1, np.abs(heights) - 1)


@pytest.fixture(scope="session")
def cylinder():
    return make_cylinder(5000)


@pytest.fixture(scope="session")
def box(data):
    return wireframe_extraction.read_cloud(data / "box_with_hole.ply")


@pytest.fixture(scope="session")
def box_wireframe(box):
    return wireframe_extraction.extract(*box)


def json_of(wireframe):
    """Return what stands in the file of a wireframe, to compare all bits."""
    return wireframe_extraction._core.to_json(wireframe._core)


@pytest.fixture(scope="session")
def cylinder_json(cylinder):
    return json_of(wireframe_extraction.extract(*cylinder))


@pytest.fixture(scope="session")
def raw_cylinder():
    """Return points without distances, and the wireframe of them."""
    points = make_cylinder(1500)[0]
    wireframe = wireframe_extraction.extract(points)
    assert len(wireframe.curves) == 2
    return points, json_of(wireframe)
