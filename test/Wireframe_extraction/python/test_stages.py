"""The extraction stage by stage."""

import numpy as np
import pytest
from conftest import make_cylinder

import wireframe_extraction as we


def json_of(wireframe, tmp_path):
    wireframe.write(tmp_path / "written.json")
    return (tmp_path / "written.json").read_bytes()


def test_same_as_extract(box, box_wireframe, tmp_path):
    extractor = we.Extractor(*box)
    assert json_of(extractor.wireframe, tmp_path) == json_of(box_wireframe, tmp_path)


def test_same_as_extract_without_distances(tmp_path):
    points = make_cylinder(2500)[0]
    extractor = we.Extractor(points)
    assert json_of(extractor.wireframe, tmp_path) == json_of(we.extract(points), tmp_path)
    assert np.array_equal(extractor.distances, we.estimate_distances(points).distances)


def test_what_is_in_between(box, box_wireframe):
    extractor = we.Extractor(*box)
    assert extractor.sampling_distance == box_wireframe.sampling_distance
    assert np.array_equal(extractor.distances, box.distances)
    skeleton, feet = extractor.skeleton, extractor.feet
    count = len(skeleton.points)
    assert count == box_wireframe.report.skeleton_size
    assert np.allclose(skeleton.points, box.points[skeleton.indices])
    assert np.allclose(skeleton.distances, box.distances[skeleton.indices])
    assert skeleton.distances.max() < 1.5 * extractor.sampling_distance
    assert feet.points.shape == feet.tangents.shape == (count, 3) and feet.residuals.shape == (count,)
    assert np.allclose(np.linalg.norm(feet.tangents, axis=1), 1)
    assert np.median(box_wireframe.distance(feet.points)) < 0.1 * extractor.sampling_distance
    assert len(extractor.corners) == 8
    assert all(box_wireframe.distance(corner.center) < 2 * extractor.sampling_distance for corner in extractor.corners)
    assert all(0 <= index < count for cluster in extractor.clusters for index in cluster)
    graph = extractor.graph
    assert graph.are_corners.shape == (len(graph.vertices),) and graph.edges.shape == (len(graph.curves), 2)
    assert graph.edges.max() < len(graph.vertices)
    assert set(extractor.curves.types) == {"bspline"} and len(extractor.wireframe.curves) == 14


def test_nothing_runs_twice(box):
    calls = []
    extractor = we.Extractor(*box, progress=calls.append)
    assert not calls
    extractor.clusters
    number = len(calls)
    extractor.clusters, extractor.skeleton, extractor.sampling_distance
    assert len(calls) == number > 0


def test_parameters(box):
    assert set(we.Extractor(*box, recognize_types=False).wireframe.types) == {"bspline"}
    assert len(we.Extractor(*box, skeleton_distance=1.0).skeleton.points) < len(we.Extractor(*box).skeleton.points)


def test_warnings_come_once(cylinder):
    points, distances = cylinder
    with pytest.warns(we.ExtractionWarning) as caught:
        we.Extractor(points, distances * 5).wireframe
    assert ["large errors" in str(warning.message) for warning in caught] == [True] and caught[0].filename == __file__


def test_own_results_in_the_middle(box, box_wireframe, tmp_path):
    extractor = we.Extractor(*box)
    extractor.corners = extractor.corners
    extractor.clusters = extractor.clusters
    assert json_of(extractor.wireframe, tmp_path) == json_of(box_wireframe, tmp_path)
    extractor.corners = extractor.corners[:4]
    assert len(extractor.corners) == 4 and len(extractor.wireframe.curves) > 0
    extractor.clusters = [extractor.clusters[0]]
    assert len(extractor.clusters) == 1


@pytest.mark.parametrize("call, error, text", [
    (lambda e: setattr(e, "clusters", [[0, 10**9]]), ValueError, "clusters[0] has an index beyond"),
    (lambda e: setattr(e, "clusters", [[-1]]), ValueError, "clusters[0]"),
    (lambda e: setattr(e, "clusters", [[0.5]]), TypeError, "clusters[0]"),
    (lambda e: setattr(e, "corners", [([0, 0], 1.0, [0])]), ValueError, "corners[0].center"),
    (lambda e: setattr(e, "corners", [([0, 0, 0], 1.0, [10**9])]), ValueError, "corners[0].members"),
    (lambda e: setattr(e, "corners", [([0, 0, np.nan], 1.0, [0])]), ValueError, "not finite"),
    (lambda e: setattr(e, "corners", [([0, 0, 0], -1.0, [0])]), ValueError, "corners[0].radius"),
])
def test_bad_results(cylinder, call, error, text):
    with pytest.raises(error) as raised:
        call(we.Extractor(*cylinder))
    assert text in str(raised.value)


@pytest.mark.parametrize("change, text", [
    (lambda p, d: (p * 0, d), "coincide"), (lambda p, d: (p * [1, 0, 0], d), "one line"),
    (lambda p, d: (p, d * 0), "all distances are 0"), (lambda p, d: (p, d * 1e3), "another unit"),
    (lambda p, d: (p, np.minimum(d, 0.01)), "cut off"), (lambda p, d: (p * np.nan, d), "not finite")])
def test_bad_clouds(cylinder, change, text):
    cloud = change(*cylinder)
    for call in (lambda: we.Extractor(*cloud).sampling_distance, lambda: we.extract(*cloud)):
        with pytest.raises(ValueError, match=text):
            call()
    with pytest.raises(ValueError, match="corner_radius is -1"):
        we.Extractor(*cylinder, corner_radius=-1).sampling_distance
