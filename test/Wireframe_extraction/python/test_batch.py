"""Many clouds at once."""

import pytest

import wireframe_extraction as we


def test_paths_and_arrays(data, cylinder, box_wireframe):
    results = we.extract_many([data / "box_with_hole.ply", cylinder, str(data / "box_with_hole.ply")], jobs=2)
    assert [len(wireframe.curves) for wireframe in results] == [14, 2, 14]
    assert (results[0].vertices == box_wireframe.vertices).all()


def test_parameters_and_progress(cylinder):
    shares = []
    results = we.extract_many([cylinder] * 4, jobs=3, recognize_types=False, progress=shares.append)
    assert all(set(wireframe.types) == {"bspline"} for wireframe in results) and shares == [0.25, 0.5, 0.75, 1]
    assert we.extract_many([]) == []


def test_errors(cylinder):
    clouds = [cylinder, (cylinder[0], cylinder[1][1:]), "missing.ply", cylinder]
    results = we.extract_many(clouds, errors="return")
    assert isinstance(results[1], ValueError) and isinstance(results[2], FileNotFoundError)
    assert len(results[0].curves) == len(results[3].curves) == 2
    with pytest.raises(ValueError, match="4999 numbers"):
        we.extract_many(clouds)


@pytest.mark.parametrize("arguments, error, text", [
    ({"jobs": 0}, ValueError, "jobs is 0"), ({"errors": "skip"}, ValueError, "'raise' or 'return'"),
    ({"corner_radus": 3}, TypeError, "corner_radius"), ({"threads": -1}, ValueError, "threads is -1")])
def test_bad_arguments(cylinder, arguments, error, text):
    with pytest.raises(error, match=text):
        we.extract_many([cylinder], **arguments)
    with pytest.raises(TypeError, match="list of them"):
        we.extract_many("cloud.ply")
