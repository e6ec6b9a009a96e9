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
    assert str(results[1]).startswith("clouds[1]: distances")
    with pytest.raises(ValueError, match=r"clouds\[1\]: .*4999 numbers"):
        we.extract_many(clouds)


def test_warnings_name_the_cloud(cylinder):
    points, distances = cylinder
    with pytest.warns(we.ExtractionWarning) as caught:
        we.extract_many([cylinder, (points, distances * 0.5)])
    assert [str(warning.message)[:10] for warning in caught] == ["clouds[1]:"] and caught[0].filename == __file__


def test_generator(cylinder):
    taken, seen, shares = [], [], []

    def clouds():
        for number in range(8):
            taken.append(number)
            yield cylinder if number else (cylinder[0][:, :2], None)
    with pytest.raises(ValueError, match=r"clouds\[0\]"):
        we.extract_many(clouds(), jobs=1)
    seen += taken
    assert len(seen) <= 3   # one that runs, one that waits, and the next
    assert len(we.extract_many(iter([cylinder, cylinder]), jobs=1, progress=shares.append)) == 2 and shares == [1]


@pytest.mark.parametrize("arguments, error, text", [
    ({"jobs": 0}, ValueError, "jobs is 0"), ({"errors": "skip"}, ValueError, "'raise' or 'return'"),
    ({"corner_radus": 3}, TypeError, "corner_radius"), ({"progress": 5}, TypeError, "progress is 5"), ({"threads": -1}, ValueError, "threads is -1")])
def test_bad_arguments(cylinder, arguments, error, text):
    with pytest.raises(error, match=text):
        we.extract_many([cylinder], **arguments)
    for clouds, what in (("cloud.ply", "single name"), (cylinder[0], "single array"), (cylinder, "list of such pairs")):
        with pytest.raises(TypeError, match=what):
            we.extract_many(clouds)
