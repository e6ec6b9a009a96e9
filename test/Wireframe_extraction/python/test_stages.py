"""The extraction stage by stage."""

import signal
import threading

import numpy as np
import pytest
from conftest import json_of, make_cylinder

import wireframe_extraction as we


def test_same_as_extract(box, box_wireframe):
    extractor = we.Extractor(*box)
    assert json_of(extractor.wireframe) == json_of(box_wireframe)


def test_same_as_extract_without_distances(raw_cylinder):
    points, expected = raw_cylinder
    extractor = we.Extractor(points)
    assert json_of(extractor.wireframe) == expected
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
        we.Extractor(points, distances * 0.5).wireframe
    assert ["large errors" in str(warning.message) for warning in caught] == [True] and caught[0].filename == __file__


def test_own_results_in_the_middle(cylinder):
    extractor = we.Extractor(*cylinder, graph_method="subdivided")
    expected = json_of(we.extract(*cylinder, graph_method="subdivided"))
    extractor.corners = extractor.corners
    extractor.clusters = extractor.clusters
    assert json_of(extractor.wireframe) == expected and len(extractor.wireframe.curves) == 2
    extractor.clusters = [extractor.clusters[0]]
    assert len(extractor.clusters) == extractor.report.number_of_clusters == len(extractor.wireframe.curves) == 1
    extractor.corners = [we.Corner([1, 0, 1], 0.1, [])]
    assert len(extractor.corners) == 1 and len(extractor.clusters) == 2


def test_corners_without_effect(cylinder):
    extractor = we.Extractor(*cylinder)
    with pytest.raises(ValueError, match="subdivided"):
        extractor.corners = extractor.corners


def noisy_cylinder():
    """Return so much noise that the wireframe is that of means."""
    points = make_cylinder(800)[0]
    return points + np.random.default_rng(1).normal(scale=0.085, size=points.shape)


def test_same_as_extract_with_noise():
    points = noisy_cylinder()
    with pytest.warns(we.ExtractionWarning, match="their means"):
        expected = we.extract(points)
    extractor = we.Extractor(points)
    with pytest.warns(we.ExtractionWarning, match="their means") as caught:
        wireframe = extractor.wireframe
    assert json_of(wireframe) == json_of(expected)
    assert len(caught) == 1 and caught[0].filename == __file__
    assert wireframe.sampling_distance > extractor.sampling_distance
    with pytest.warns(we.ExtractionWarning, match="their means"):
        field = we.estimate_distances(points)
    assert np.array_equal(extractor.distances, field.distances) and len(field.distances) == len(points)


def test_same_report_as_extract(cylinder):
    expected, report = we.extract(*cylinder).report, we.Extractor(*cylinder).wireframe.report
    different = {name for name in vars(report) if getattr(report, name) != getattr(expected, name)}
    assert different == {"seconds"} and report.seconds


def test_large_cloud_without_distances(raw_cylinder):
    points, expected = raw_cylinder
    extractor = we.Extractor(points, points_in_memory=500)
    assert extractor.sampling_distance == we.Extractor(points).sampling_distance
    assert json_of(extractor.wireframe) == expected


def test_stopped_stages_leave_nothing(raw_cylinder):
    points, expected = raw_cylinder
    stopped = []

    def progress(share):
        stage = repr(extractor)
        if share == 1 and stage not in stopped:   # each of the nine once, at its end
            stopped.append(stage)
            raise KeyError("enough")

    extractor = we.Extractor(points, progress=progress)
    for _ in range(9):
        with pytest.raises(KeyError, match="enough"):
            extractor.wireframe
    assert len(stopped) == 9 and json_of(extractor.wireframe) == expected


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs signals")
def test_interrupted_stages_leave_nothing(raw_cylinder):
    points, expected = raw_cylinder
    extractor = we.Extractor(points, threads=1)

    def stop(number, frame):
        raise KeyError("enough")
    previous = signal.signal(signal.SIGALRM, stop)
    try:   # within the estimate, which takes most of the time
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyError, match="enough"):
            extractor.wireframe
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
    assert json_of(extractor.wireframe) == expected


def test_many_threads(cylinder, cylinder_json):
    for _ in range(5):
        extractor = we.Extractor(*cylinder, threads=1)
        failures = []

        def ask(name):
            try:
                getattr(extractor, name)
            except BaseException as error:
                failures.append(error)
        threads = [threading.Thread(target=ask, args=[name]) for name in ("wireframe", "feet", "graph", "corners")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert not failures and json_of(extractor.wireframe) == cylinder_json


def test_progress_that_asks(cylinder):
    extractor = we.Extractor(*cylinder, progress=lambda share: extractor.wireframe)
    with pytest.raises(RuntimeError, match="ask later"):
        extractor.wireframe


def test_own_copy_of_the_cloud(cylinder, cylinder_json):
    points, distances = (array.copy() for array in cylinder)
    extractor = we.Extractor(points, distances)
    assert "done: nothing" in repr(extractor) and extractor.report == we.Report()
    extractor.sampling_distance
    assert repr(extractor) == "<Extractor: 5000 points with distances; done: measure>"
    points *= 2
    distances[:] = 0
    assert json_of(extractor.wireframe) == cylinder_json


def test_smooth_surface():
    points = np.random.default_rng(5).normal(size=(2000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    with pytest.warns(we.ExtractionWarning, match="no wireframe") as caught:
        wireframe = we.Extractor(points).wireframe
    assert len(caught) == 1 and not wireframe.curves and "20 degrees" in wireframe.report.message


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
        call(we.Extractor(*cylinder, graph_method="subdivided"))
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
