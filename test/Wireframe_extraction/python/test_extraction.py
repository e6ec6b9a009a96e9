"""Extractions: the bits of the tool, whatever the arrays and the threads are; stopping; errors that help."""

import os
import re
import signal
import subprocess
import threading
import time
import warnings

import numpy as np
import pytest
from conftest import json_of, make_cylinder

import wireframe_extraction as we


def json_of_tool(tool, tmp_path, *arguments):
    subprocess.run([tool, *map(str, arguments), "-o", str(tmp_path / "tool.json"), "--quiet"], check=True)
    text = (tmp_path / "tool.json").read_text()
    return re.sub(r'(?m)^ "provenance":.*\n', "", text)   # which names the tool, and the file


@pytest.mark.parametrize("name", ["box_with_hole.ply", "crossing_cylinders.ply", "rounded_plate.stl"])
def test_same_as_tool(name, data, tool, tmp_path):
    assert json_of(we.extract(data / name)) == json_of_tool(tool, tmp_path, data / name)


def test_same_arrays_as_files(data, box_wireframe):
    assert json_of(we.extract(data / "box_with_hole.ply")) == json_of(box_wireframe)


def test_same_as_tool_with_parameters(data, box, tool, tmp_path):
    options = ["--minimum-evidence", 3, "--recognize-types", "false", "--corner-measure", "variance", "--threads", 1]
    expected = json_of_tool(tool, tmp_path, data / "box_with_hole.ply", *options)
    parameters = {"minimum_evidence": 3, "recognize_types": False, "corner_measure": "variance", "threads": 1}
    assert json_of(we.extract(*box, **parameters)) == expected
    assert json_of(we.extract(*box)) != expected


def test_paper(data, box, tool, tmp_path):
    expected = json_of_tool(tool, tmp_path, data / "box_with_hole.ply", "--paper")
    assert json_of(we.extract(*box, **we.paper_parameters())) == expected


def test_same_as_tool_without_distances(raw_cylinder, tool, tmp_path):
    points, json = raw_cylinder
    np.save(tmp_path / "raw.npy", points)
    assert json_of_tool(tool, tmp_path, tmp_path / "raw.npy") == json
    field = we.estimate_distances(points)
    assert field.distances.shape == field.deviations.shape == (len(points),)
    true = make_cylinder(len(points))[1]
    near = field.distances < field.distances.max()
    assert near.sum() > 100 and np.median(np.abs(field.distances - true)[near]) < 0.05


def test_mesh(data, tool, tmp_path):
    meshes = [(np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float),
               np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]))]
    for vertices, faces in meshes:
        wireframe = we.extract(vertices, faces=faces, maximum_number_of_points=20000)
        assert len(wireframe.vertices) == 8 and wireframe.types.tolist() == ["line"] * 12
        assert wireframe.distance(vertices).max() < 0.01
    with open(tmp_path / "cube.off", "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        file.writelines(" ".join(map(str, row)) + "\n" for row in [*vertices, *([4, *face] for face in faces)])
    expected = json_of_tool(tool, tmp_path, tmp_path / "cube.off", "--maximum-number-of-points", "20000")
    assert json_of(wireframe) == expected


CUBE = (np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float),
        np.array([(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6),
                  (0, 6, 4), (1, 5, 7), (1, 7, 3)]))


def sphere(steps=24):
    """Return the vertices and triangles of a smooth mesh."""
    angles = np.pi * np.arange(1, steps) / steps
    ring = np.column_stack([np.cos(2 * np.pi * np.arange(2 * steps) / (2 * steps)),
                            np.sin(2 * np.pi * np.arange(2 * steps) / (2 * steps))])
    rows = [np.column_stack([np.sin(a) * ring, np.full(2 * steps, np.cos(a))]) for a in angles]
    vertices = np.vstack([[(0, 0, 1)], *rows, [(0, 0, -1)]])
    faces, width, last = [], 2 * steps, len(vertices) - 1
    for i in range(width):
        j = (i + 1) % width
        faces.append((0, 1 + i, 1 + j))
        faces.append((last, last - width + j, last - width + i))
        for k in range(steps - 2):
            first = 1 + k * width
            faces += [(first + i, first + width + i, first + j), (first + j, first + width + i, first + width + j)]
    return vertices, np.array(faces)


@pytest.mark.parametrize("mesh, parameters, text", [
    (CUBE, {"maximum_number_of_points": 20000}, "taken for a shape"), (sphere(), {}, "no edge of the mesh is sharp"),
    (CUBE, {"minimum_fold": 100}, "no edge of the mesh is sharp"), ((np.eye(3), [[0, 1, 2]]), {}, "no edge"),
    ((make_cylinder(600)[0], [(i, i + 1, i + 2) for i in range(598)]), {"mesh": "scan"}, 'mesh="scan"')])
def test_mesh_of_arrays_is_that_of_a_file(mesh, parameters, text, tmp_path):
    vertices, faces = mesh
    with open(tmp_path / "mesh.off", "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        file.writelines(" ".join(map(repr, map(float, row))) + "\n" for row in vertices)
        file.writelines(" ".join(map(str, (len(row), *row))) + "\n" for row in faces)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        results = [we.extract(vertices, faces=faces, **parameters), we.extract(tmp_path / "mesh.off", **parameters)]
    texts = [str(warning.message) for warning in caught]
    assert texts == [] or texts[1] == texts[0].replace("faces: ", f"{tmp_path / 'mesh.off'}: ") and len(texts) == 2
    assert results[0]._core.problem() == "" and len(results[0].curves) == len(results[1].curves)
    assert [we._core.to_json(one._core) for one in results[:1]] == [we._core.to_json(one._core) for one in results[1:]]
    reports = [result.report for result in results]
    assert reports[0].status == reports[1].status
    assert reports[0].note == reports[1].note or "mesh" in parameters   # the vertices of a file are read as a cloud then
    assert any(text in told for told in (reports[0].note, reports[0].message))


def test_progress_of_a_mesh():
    shares = []
    we.extract(CUBE[0], faces=CUBE[1], progress=shares.append, maximum_number_of_points=20000)
    assert shares == sorted(set(shares)) and shares[-1] == 1


@pytest.mark.parametrize("change", [
    lambda p, d: (p.astype("f4"), d.astype("f4")),
    lambda p, d: (p.astype("f4"), d),
], ids=["both", "points"])
def test_single_precision(cylinder, change):
    points, distances = change(*cylinder)
    expected = json_of(we.extract(points.astype("f8"), distances.astype("f8")))
    assert json_of(we.extract(points, distances)) == expected


@pytest.mark.parametrize("change", [
    lambda p, d: (np.asfortranarray(p), d),
    lambda p, d: (np.hstack([p, p])[:, :3], np.repeat(d, 2)[::2]),
    lambda p, d: (p[::-1].copy()[::-1], d[::-1].copy()[::-1]),
    lambda p, d: (np.repeat(p, 3, axis=0)[::3], d[:, None]),
    lambda p, d: (p[:, ::-1].copy()[:, ::-1], d),
    lambda p, d: (p.tolist(), d.tolist()),
    lambda p, d: (p.astype(">f8"), d.astype(">f8")),
    lambda p, d: (records(p)["position"], records(p, d)["distance"]),
], ids=["columns", "part", "reversed", "every third", "mirrored", "lists", "big endian", "unaligned"])
def test_strides(cylinder, cylinder_json, change):
    points, distances = change(*cylinder)
    assert json_of(we.extract(points, distances)) == cylinder_json


def records(points, distances=0.0):
    """Return packed records, in which numbers are not aligned."""
    result = np.zeros(len(points), dtype=[("flag", "u1"), ("position", "f8", 3), ("distance", "f8")])
    result["position"], result["distance"] = points, distances
    return result


def test_arrays_are_left_alone(cylinder):
    points, distances = (array.copy() for array in cylinder)
    for array in (points, distances):
        array.setflags(write=False)
    we.extract(points, distances)
    assert np.array_equal(points, cylinder[0]) and np.array_equal(distances, cylinder[1])


def test_integers():
    axes = np.arange(40)
    points = np.array([(x, y, z) for x in axes for y in axes for z in (0, 39)])
    points = np.unique(np.vstack([points, points[:, [2, 0, 1]], points[:, [1, 2, 0]]]), axis=0)
    beyond = np.sort(np.minimum(points, 39 - points), axis=1)
    wireframe = we.extract(points, beyond[:, 1])
    assert len(wireframe.vertices) == 8 and wireframe.types.tolist() == ["line"] * 12


@pytest.mark.parametrize("threads", [1, 5])
def test_threads(box, box_wireframe, threads):
    assert json_of(we.extract(*box, threads=threads)) == json_of(box_wireframe)


def test_result(cylinder):
    wireframe = we.extract(*cylinder)
    assert wireframe.types.tolist() == ["circle"] * 2 and wireframe.edges.tolist() == [[-1, -1]] * 2
    assert wireframe.vertices.shape == (0, 3) and wireframe.is_valid()
    assert [curve.radius for curve in wireframe.curves] == pytest.approx([1, 1], abs=1e-3)
    report = wireframe.report
    assert report.status == "success" and report.number_of_points == len(cylinder[0]) and report.number_of_curves == 2
    assert report.sampling_distance == wireframe.sampling_distance > 0 and "contraction" in report.seconds
    assert not report.is_field_estimated and report.message == "" and report.warnings == []


def test_progress(box):
    shares = []
    we.extract(*box, progress=shares.append)
    assert shares[-1] == 1 and shares == sorted(set(shares)) and all(0 < share <= 1 for share in shares)


def test_progress_that_raises(box):
    def stop(share):
        raise KeyError("enough")
    with pytest.raises(KeyError, match="enough"):
        we.extract(*box, progress=stop)


@pytest.mark.skipif(os.name == "nt", reason="needs signals")
@pytest.mark.parametrize("work", [
    lambda: we.estimate_distances(make_cylinder(200000)[0]),
    lambda: we.extract(*make_cylinder(2000000)),
    lambda: we.Extractor(make_cylinder(200000)[0]).wireframe,
    lambda: we.extract_many([make_cylinder(200000)[0]] * 3),
    lambda: we.extract(*make_cylinder(5000)).distance(np.random.default_rng(7).normal(size=(3000000, 3))),
    lambda: we.extract(CUBE[0], faces=CUBE[1], sampling_distance=0.002),
    lambda: we.read_cloud("large.off", sampling_distance=0.002),
    lambda: we.extract(*make_cylinder(5000)).curves[0].sample(count=10000000),
], ids=["estimate", "extract", "stages", "many", "distance", "mesh", "mesh file", "sample"])
def test_interrupt(work, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with open("large.off", "w") as file:
        file.write("OFF\n8 12 0\n")
        file.writelines(" ".join(map(str, row)) + "\n" for row in [*CUBE[0], *([3, *face] for face in CUBE[1])])
    stopped_at = []

    def interrupt():
        stopped_at.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)
    timer = threading.Timer(0.5, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        work()
    # within a second where nothing else runs; here other tests may
    assert time.monotonic() - stopped_at[0] < 4


def test_other_threads_go_on(box):
    counts = []
    thread = threading.Thread(target=lambda: counts.append(we.extract(*box, threads=1)))
    thread.start()
    steps = 0
    while thread.is_alive():
        time.sleep(0.001)
        steps += 1
    assert steps > 20 and len(counts[0].curves) == 14


def test_no_feature():
    random = np.random.default_rng(5).normal(size=(4000, 3))
    sphere = random / np.linalg.norm(random, axis=1)[:, None]
    with pytest.warns(we.ExtractionWarning, match="no wireframe"):
        wireframe = we.extract(sphere)
    assert not wireframe.curves and wireframe.report.status == "no_feature" and "20 degrees" in wireframe.report.message
    assert wireframe.distance([0, 0, 0]).tolist() == [np.inf] and wireframe.sample()[0].shape == (0, 3)


def test_skip_invalid(cylinder, cylinder_json):
    points, distances = (np.concatenate([array[:1] * np.nan, array]) for array in cylinder)
    with pytest.raises(ValueError, match=r"1 points .* index 0 .* skip_invalid=True"):
        we.extract(points, distances)
    wireframe = we.extract(points, distances, skip_invalid=True)
    assert wireframe.report.number_of_skipped_points == 1
    assert json_of(wireframe) == cylinder_json


def test_library_warnings(cylinder):
    points, distances = cylinder
    with pytest.warns(we.ExtractionWarning, match="large errors or another unit") as caught:
        wireframe = we.extract(points, distances * 0.5)
    assert wireframe.report.warnings and caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        we.extract(points, distances)


P, D = make_cylinder(500)
PADDED = np.column_stack([np.full(12, 3), CUBE[1]])


class Frame:
    """What pandas has of a table."""

    def __init__(self, values):
        self.values, self.iloc = np.asarray(values), self

    def __array__(self, dtype=None, copy=None):
        return self.values.astype(dtype or self.values.dtype)

    def to_numpy(self, dtype):
        return self.values.astype(dtype)


@pytest.mark.parametrize("call, error, text", [
    (lambda: we.extract(P[:, :2]), ValueError, "(500, 2); it has to be (n, 3)"),
    (lambda: we.extract(P.T), ValueError, ".T"),
    (lambda: we.extract(np.column_stack([P, D])), ValueError, "[:, :3] and [:, 3]"),
    (lambda: we.extract(P[None]), ValueError, ".reshape(-1, 3)"),
    (lambda: we.extract(P[0]), ValueError, "(3,)"),
    (lambda: we.extract(3.0), ValueError, "()"),
    (lambda: we.extract([[1, 2, 3], [4, 5]]), ValueError, "points"),
    (lambda: we.extract(None), TypeError, "points is None"),
    (lambda: we.extract({"a": 1}), TypeError, "dtype object"),
    (lambda: we.extract([["a", "b", "c"]]), TypeError, "dtype <U1"),
    (lambda: we.extract(P * 1j), TypeError, "complex"),
    (lambda: we.extract(P > 0), TypeError, "bool"),
    (lambda: we.extract(records(P)), ValueError, "flag, position, distance"),
    (lambda: we.extract(np.ma.masked_less(P, 0)), ValueError, "masked"),
    (lambda: we.extract(np.empty((0, 3))), ValueError, "no points"),
    (lambda: we.extract(P[:1].repeat(9, 0)), ValueError, "all points coincide"),
    (lambda: we.extract(P + 1e13), ValueError, "subtract an offset"),
    (lambda: we.extract(P, D[:-1]), ValueError, "499 numbers for 500 points"),
    (lambda: we.extract(P, np.stack([D, D])), ValueError, "distances has the shape (2, 500)"),
    (lambda: we.extract(P, -D - 1), ValueError, "negative"),
    (lambda: we.extract(P, D * 0), ValueError, "all distances are 0"),
    (lambda: we.extract(P, D, faces=[[0, 1, 2]]), ValueError, "both distances and faces"),
    (lambda: we.extract(P, faces=[[0, 1, 500]]), ValueError, "faces[0] is [0, 1, 500]"),
    (lambda: we.extract(P, faces=[[0, 1, -1]]), ValueError, "faces[0]"),
    (lambda: we.extract(P, faces=[[0.0, 1, 2]]), TypeError, "integers"),
    (lambda: we.extract(P, faces=[[0, 1]]), ValueError, "(1, 2)"),
    (lambda: we.extract(CUBE[0], faces=PADDED), ValueError, "[:, 1:]"),
    (lambda: we.extract(CUBE[0], faces=PADDED.ravel()), ValueError, ".reshape(-1, 4)[:, 1:]"),
    (lambda: we.extract(P, faces=[[0, 1, 2], [0, 1, 2, 3]]), ValueError, "different numbers of corners"),
    (lambda: we.extract(P, faces=[]), ValueError, "faces is empty"),
    (lambda: we.extract(P, faces=np.ma.masked_equal([[0, 1, 2]], 0)), ValueError, "faces is a masked array"),
    (lambda: we.extract(P * np.nan, faces=[[0, 1, 2]]), ValueError, "points[0] is not finite"),
    (lambda: we.extract((P, D)), TypeError, "extract(*cloud)"),
    (lambda: we.Extractor((P, None)), TypeError, "extract(*cloud)"),
    (lambda: we.Extractor("scan.ply"), TypeError, "read_cloud('scan.ply')"),
    (lambda: we.estimate_distances("scan.ply"), TypeError, "read_cloud('scan.ply')"),
    (lambda: we.extract(Frame(P.astype(object))), TypeError, ".to_numpy(float)"),
    (lambda: we.extract(Frame(np.column_stack([P, D]))), ValueError, ".iloc[:, :3]"),
    (lambda: we.extract(P, D, normals=P * np.nan), ValueError, "normals[0] is not finite"),
    (lambda: we.extract(P, distance=D), TypeError, "did you mean 'distances'?"),
    (lambda: we.extract(P, thread=1), TypeError, "did you mean 'threads'?"),
    (lambda: we.extract(P, nthreads=1), TypeError, "did you mean 'threads'?"),
    (lambda: we.extract(P, normal=P), TypeError, "did you mean 'normals'?"),
    (lambda: we.extract(P, face=[]), TypeError, "did you mean 'faces'?"),
    (lambda: we.extract(P, Progress=print), TypeError, "did you mean 'progress'?"),
    (lambda: we.estimate_distances(P, min_fold=3), TypeError, "did you mean 'minimum_fold'?"),
    (lambda: we.extract_many([P], job=3), TypeError, "did you mean 'jobs'?"),
    (lambda: we.read_cloud("a.ply", distance="b.npy"), TypeError, "did you mean 'distances'?"),
    (lambda: we.extract(P, D, noise_level=-1), ValueError, "noise_level is -1.0; it has to be at least 0"),
    (lambda: we.extract(__file__, fusion="median"), ValueError, "patches=True"),
    (lambda: we.extract(P, D, corner_radus=4), TypeError, "did you mean 'corner_radius'?"),
    (lambda: we.extract(P, D, normals=P[:-1]), ValueError, "normals has 499 rows for 500 points"),
    (lambda: we.extract(P, D, normals=P[:, :2]), ValueError, "normals has the shape (500, 2)"),
    (lambda: we.extract("cloud.ply", normals=P), ValueError, "normals goes with points in an array"),
    (lambda: we.Extractor(P, D, normals=P), TypeError, "normals are not used"),
    (lambda: we.extract(P, D, qwertz=4), TypeError, "default_parameters()"),
    (lambda: we.extract(P, D, corner_radius="4"), TypeError, "corner_radius is '4'; it has to be a number"),
    (lambda: we.extract(P, D, corner_radius=True), TypeError, "corner_radius is True"),
    (lambda: we.extract(P, D, corner_radius=-4), ValueError, "corner_radius is -4; it must be finite, more than 0"),
    (lambda: we.extract(P, D, corner_radius=np.nan), ValueError, "corner_radius is nan"),
    (lambda: we.extract(P, D, corner_radius=10**400), ValueError, "corner_radius is inf"),
    (lambda: we.extract(P, D, number_of_rounds=10**30), ValueError, "number_of_rounds"),
    (lambda: we.extract(P, D, number_of_rounds=2.0), TypeError, "integer"),
    (lambda: we.extract(P, D, points_in_memory=-1), ValueError, "points_in_memory is -1"),
    (lambda: we.extract(P, D, use_creases=1), TypeError, "True or False"),
    (lambda: we.extract(P, D, graph_method="trace"), ValueError, "'traced', 'subdivided'"),
    (lambda: we.extract(P, D, mesh="cad"), ValueError, "mesh has no effect"),
    (lambda: we.extract(P, D, patches=True), ValueError, "the name of a file"),
    (lambda: we.extract(P, D, threads=-1), ValueError, "threads is -1"),
    (lambda: we.extract(P, D, threads=1.5), TypeError, "threads is 1.5"),
    (lambda: we.extract(P, D, progress=3), TypeError, "progress is 3"),
    (lambda: we.extract(P, D, sampling_distance=100), ValueError, "does not fit the points"),
    (lambda: we.extract("no such file.ply"), FileNotFoundError, "no such file.ply"),
    (lambda: we.extract(__file__), ValueError, "unknown extension"),
    (lambda: we.extract("a\0b.ply"), FileNotFoundError, "b.ply"),
    (lambda: we.estimate_distances(P, minimum_fold=200), ValueError, "minimum_fold is 200"),
    (lambda: we.estimate_distances(P[:, :2]), ValueError, "(500, 2)"),
    (lambda: we.Extractor(P, D, corner_radus=4), TypeError, "Extractor() got an unexpected keyword argument"),
    (lambda: we.Extractor(P * np.nan, D).skeleton, ValueError, "not finite"),
])
def test_bad_input(call, error, text):
    with pytest.raises(error) as raised:
        call()
    assert text in str(raised.value)
