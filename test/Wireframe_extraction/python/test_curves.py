"""Curves against closed forms, and against the splines of SciPy."""

import pickle

import numpy as np
import pytest
import shapes

import wireframe_extraction

interpolate = pytest.importorskip("scipy.interpolate")

KNOTS = [0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4]
POINTS = np.random.default_rng(3).normal(size=(7, 3))
WEIGHTS = [1, 0.5, 2, 1, 3, 0.7, 1]
T = np.linspace(0, 4, 57)


def read_curve(tmp_path, curve, vertices):
    return wireframe_extraction.read(shapes.write(tmp_path / "curve.json", vertices, [curve])).curves[0]


@pytest.fixture
def spline(tmp_path):
    return read_curve(tmp_path, shapes.spline(KNOTS, POINTS), POINTS[[0, -1]])


@pytest.fixture
def rational(tmp_path):
    return read_curve(tmp_path, shapes.spline(KNOTS, POINTS, WEIGHTS), POINTS[[0, -1]])


@pytest.fixture
def circle(tmp_path):
    return read_curve(tmp_path, shapes.circle([1.0, 2.0, 3.0], 2.0), [])


def test_spline(spline):
    expected = interpolate.BSpline(KNOTS, POINTS, 3)
    assert np.allclose(spline(T), expected(T), atol=1e-13)
    inside = T[(T != 1) & (T != 2.5)]
    for order in range(4):
        assert np.allclose(spline.derivative(inside, order), expected(inside, order), atol=1e-11)
    first, second = expected(inside, 1), expected(inside, 2)
    speed = np.linalg.norm(first, axis=1)
    assert np.allclose(spline.tangent(inside), first / speed[:, None], atol=1e-12)
    assert np.allclose(spline.curvature(inside), np.linalg.norm(np.cross(first, second), axis=1) / speed**3, rtol=1e-9)


def test_rational_spline(rational):
    homogeneous = interpolate.BSpline(KNOTS, np.column_stack([POINTS * np.array(WEIGHTS)[:, None], WEIGHTS]), 3)(T)
    assert np.allclose(rational(T), homogeneous[:, :3] / homogeneous[:, 3:], atol=1e-13)
    assert rational.weights.tolist() == WEIGHTS


def test_length(spline):
    integrate = pytest.importorskip("scipy.integrate")
    expected = sum(integrate.quad(lambda t: np.linalg.norm(spline.derivative(t)), *ends, epsabs=1e-12)[0]
                   for ends in ((0, 1), (1, 2.5), (2.5, 4)))
    assert spline.length == pytest.approx(expected, rel=1e-9)


def test_values(spline, circle):
    assert spline.type == "bspline" and not spline.closed and (spline.source, spline.target) == (0, 1)
    assert spline.degree == 3 and spline.range == (0, 4) and spline.index == 0
    assert spline.knots.tolist() == KNOTS and np.array_equal(spline.control_points, POINTS) and spline.weights is None
    nothing = ("radius", "radii", "center", "axis", "major_direction", "angles", "uncertainty")
    assert all(getattr(spline, name) is None for name in nothing)
    assert circle.type == "circle" and circle.closed and circle.source is None and circle.target is None
    assert circle.radius == 2 and circle.radii == (2, 2) and circle.center.tolist() == [1, 2, 3]
    assert circle.axis.tolist() == [0, 0, 1] and circle.major_direction.tolist() == [1, 0, 0]
    assert circle.angles == (0, 2 * np.pi) and (circle.rms, circle.max, circle.support) == (0.5, 0.75, 7)
    assert circle.uncertainty == {"position": 0.1, "direction": 0.2, "major_radius": 0.3, "minor_radius": 0.4}
    assert "circle" in repr(circle) and "radius 2" in repr(circle)
    assert not spline.doubtful and spline.doubts == () and "doubtful" not in repr(spline)
    assert circle.doubtful and circle.doubts == ("short", "misfit") and "doubtful: short, misfit" in repr(circle)


def test_pickle(tmp_path, circle):
    corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 3.0, 4.0)]
    curves = [shapes.line(corners[0], corners[1], 0, 1), shapes.line(corners[2], corners[1], 2, 1)]
    line = wireframe_extraction.read(shapes.write(tmp_path / "lines.json", corners, curves)).curves[1]
    for curve in (line, circle):
        copy = pickle.loads(pickle.dumps(curve))
        assert repr(copy) == repr(curve) and (copy.source, copy.target) == (curve.source, curve.target)
        assert np.array_equal(copy.control_points, curve.control_points) and copy.doubts == curve.doubts
        assert repr(pickle.loads(pickle.dumps(copy))) == repr(curve)
    assert len(pickle.dumps(line)) < 1000


def test_line(tmp_path):
    line = read_curve(tmp_path, shapes.line((0, 0, 0), (0, 3, 4)), [(0, 0, 0), (0, 3, 4)])
    assert line.length == pytest.approx(5) and line.radius is None and line.angles is None
    assert line.center.tolist() == [0, 1.5, 2] and np.allclose(line.axis, [0, 0.6, 0.8], atol=1e-15)


def test_circle(circle):
    assert circle.length == pytest.approx(4 * np.pi, rel=1e-12)
    assert np.allclose(circle.curvature(np.linspace(*circle.range, 40)), 0.5)
    samples = circle.sample(0.1)
    assert np.allclose(np.hypot(*(samples[:, :2] - [1, 2]).T), 2, atol=1e-14)
    assert np.array_equal(samples[0], samples[-1]) and len(samples) == np.ceil(4 * np.pi / 0.1) + 1
    chords = np.linalg.norm(np.diff(samples, axis=0), axis=1)
    assert np.allclose(chords, chords[0], rtol=1e-8)
    assert circle(circle.range[0] - 1).tolist() == circle(circle.range[1] - 1).tolist()   # it goes round


def test_closest(circle):
    queries = np.random.default_rng(4).normal(size=(200, 3)) * 3 + [1, 2, 3]
    found = circle.closest(queries)
    planar = np.hypot(*(queries[:, :2] - [1, 2]).T)
    assert np.allclose(found.distances, np.hypot(planar - 2, queries[:, 2] - 3), atol=1e-12)
    assert np.allclose(circle(found.parameters), found.points, atol=1e-14)
    assert circle.closest([1, 2, 3]).distances == pytest.approx([2])


def test_shapes_of_arrays(spline):
    assert spline(1.5).shape == (3,) and spline([[0, 1], [2, 3]]).shape == (2, 2, 3) and spline([]).shape == (0, 3)
    assert spline.curvature(1).shape == () and spline.curvature([[1, 2]]).shape == (1, 2)
    assert spline.sample(count=5).shape == (5, 3) and spline.closest(np.empty((0, 3))).points.shape == (0, 3)
    assert spline.sample(count=2).tolist() == POINTS[[0, -1]].tolist()


def test_arrays_are_copies(circle, spline):
    for name in ("knots", "control_points", "weights"):
        array = getattr(circle, name)
        array[0] = 7   # what cannot be written to, SciPy and PyTorch do not take
        assert not np.array_equal(getattr(circle, name), array)
    same = interpolate.BSpline(spline.knots, spline.control_points, spline.degree)
    assert np.allclose(same(T), spline(T), atol=1e-13)


@pytest.mark.parametrize("call, error, text", [
    (lambda c: c(np.nan), ValueError, "t has a number that is not finite"),
    (lambda c: c("a"), TypeError, "t has the dtype"),
    (lambda c: c.derivative(0, -1), ValueError, "order is -1"),
    (lambda c: c.derivative(0, 10**12), ValueError, "order is"),
    (lambda c: c.derivative(0, 1.5), TypeError, "order is 1.5"),
    (lambda c: c.sample(0), ValueError, "step is 0.0"),
    (lambda c: c.sample(-1), ValueError, "positive"),
    (lambda c: c.sample(np.nan), ValueError, "finite"),
    (lambda c: c.sample(1e-300), ValueError, "larger"),
    (lambda c: c.sample(), TypeError, "step or count"),
    (lambda c: c.sample(1, count=3), TypeError, "step or count"),
    (lambda c: c.sample(count=1), ValueError, "from 2"),
    (lambda c: c.closest([[0, 0]]), ValueError, "(1, 2)"),
    (lambda c: c.closest([[0, 0, 0], [0, np.inf, 0]]), ValueError, r"points[1] is not finite"),
])
def test_bad_arguments(spline, call, error, text):
    with pytest.raises(error) as raised:
        call(spline)
    assert text in str(raised.value)
