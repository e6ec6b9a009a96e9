"""One curve of a wireframe."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _numbers

if TYPE_CHECKING:
    from ._types import Integer, Real

Array = npt.NDArray[np.float64]

_MOST_SAMPLES = 100_000_000
_HIGHEST_ORDER = 20


class Closest(NamedTuple):
    """The points of a curve that are closest to others.

    Attributes
    ----------
    parameters : ndarray of shape (n,)
        Where they are on the curve: ``curve(parameters)`` are the points.
    points : ndarray of shape (n, 3)
        The closest points of the curve.
    distances : ndarray of shape (n,)
        How far they are.
    """

    parameters: Array
    points: Array
    distances: Array


class Curve:
    """One curve of a wireframe: its geometry, its vertices, and how well the cloud supports it.

    Whatever its type, a curve is a B-spline, which can be evaluated, differentiated and measured. Lengths are in the
    unit of the cloud, angles in radians. Curves are not made: a `Wireframe` has them. They can be pickled, also alone.
    """

    def __init__(self, core: _core.Curve, index: int, ends: tuple[int | None, int | None] | None = None) -> None:
        self._core = core
        self._index = index
        self._ends = (core.source, core.target) if ends is None else ends
        self._length: float | None = None   # measured when it is asked for

    def __repr__(self) -> str:
        radius = f", radius {self.radius:.6g}" if self.radius is not None else ""
        closed = ", closed" if self.closed else ""
        doubts = f", doubtful: {', '.join(self.doubts)}" if self.doubtful else ""
        return f"<Curve {self.index}: {self.type}, length {self.length:.6g}{radius}{closed}{doubts}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (_core.to_json(self._core.alone()), self._index, self._ends)

    @property
    def index(self) -> int:
        """Which curve of its wireframe it is, counted from 0."""
        return self._index

    @property
    def type(self) -> str:
        """"bspline", "line", "circle", "arc", "ellipse" or "elliptic_arc"."""
        return self._core.type

    @property
    def closed(self) -> bool:
        """Whether the curve ends where it starts."""
        return self._core.closed

    @property
    def source(self) -> int | None:
        """Index of the vertex at which the curve starts; None on a closed curve that passes through none."""
        return self._ends[0]

    @property
    def target(self) -> int | None:
        """Index of the vertex at which the curve ends; None on a closed curve that passes through none."""
        return self._ends[1]

    @property
    def length(self) -> float:
        """Length of the curve, in the unit of the cloud."""
        if self._length is None:
            self._length = self._core.length()
        return self._length

    @property
    def radius(self) -> float | None:
        """Radius of a circle or of an arc of one; None of other curves."""
        radii = self.radii
        return radii[0] if radii is not None and self.type in ("circle", "arc") else None

    @property
    def radii(self) -> tuple[float, float] | None:
        """Half the axes of a circle, an ellipse or an arc of one, the larger first; None of other curves."""
        return self._core.radii

    @property
    def center(self) -> Array | None:
        """Center of a circle, an ellipse or an arc of one, or the middle of a line, of shape (3,); None of splines."""
        if self.type == "line":
            middle: Array = self.control_points[[0, -1]].mean(axis=0)
            return middle
        return self._vector(self._core.center)

    @property
    def axis(self) -> Array | None:
        """Unit normal of the plane of a circle, an ellipse or an arc of one, of shape (3,); None of splines.

        Seen from its tip, the curve runs counterclockwise. Of a line, it is the unit direction from start to end.
        """
        if self.type == "line":
            return self.tangent(self.range[0])
        return self._vector(self._core.axis)

    @property
    def major_direction(self) -> Array | None:
        """Unit direction of the major axis, of shape (3,), from which angles count; None of lines and splines."""
        return self._vector(self._core.major_direction)

    @property
    def angles(self) -> tuple[float, float] | None:
        """Where a circle, an ellipse or an arc of one starts and ends, in radians; None of other curves."""
        return self._core.angles

    @property
    def uncertainty(self) -> dict[str, float] | None:
        """Standard deviations of the parameters of a line, circle, ellipse or arc; None of splines.

        Keys are "position", "direction" (in radians), "major_radius" and "minor_radius". 0 stands for what is not
        known.
        """
        return None if self.type == "bspline" else self._core.uncertainty

    @property
    def rms(self) -> float:
        """Root mean square of the residuals of the field on the curve."""
        return self._core.rms

    @property
    def max(self) -> float:
        """Largest residual of the points that support the curve."""
        return self._core.max

    @property
    def support(self) -> int:
        """Number of points of the cloud that support the curve."""
        return self._core.support

    @property
    def doubtful(self) -> bool:
        """Whether there are `doubts`."""
        return bool(self.doubts)

    @property
    def doubts(self) -> tuple[str, ...]:
        """Why the curve may be wrong; empty if nothing speaks against it.

        "free_end", "short", "little_support", "misfit", "no_fold", "beside_another" and "uncertain_type"; the manual
        has the threshold of each.
        """
        return self._core.doubts

    @property
    def degree(self) -> int:
        """Degree of the spline."""
        return self._core.degree

    @property
    def range(self) -> tuple[float, float]:
        """The smallest and the largest parameter."""
        return self._core.range

    @property
    def knots(self) -> Array:
        """Knots of the spline, of shape (k,); a copy."""
        return self._core.knots

    @property
    def control_points(self) -> Array:
        """Control points of the spline, of shape (c, 3); a copy."""
        return self._core.control_points

    @property
    def weights(self) -> Array | None:
        """Weights of the control points, of shape (c,), a copy; None of a spline that is not rational."""
        return self._core.weights

    def __call__(self, t: npt.ArrayLike) -> Array:
        """Return points of the curve.

        Parameters
        ----------
        t : array_like of any shape S
            Parameters, in `range`. Outside, an open curve continues with its ends, and a closed one goes round.

        Returns
        -------
        ndarray of shape S + (3,)
            The points.
        """
        flat, shape = self._parameters(t)
        return self._core.points(flat).reshape(*shape, 3)

    def derivative(self, t: npt.ArrayLike, order: Integer = 1) -> Array:
        """Return derivatives of the curve with respect to its parameter.

        Parameters
        ----------
        t : array_like of any shape S
            Parameters.
        order : int
            How often to differentiate, from 0 to 20.

        Returns
        -------
        ndarray of shape S + (3,)
            The derivatives.
        """
        order = _numbers.integer("order", order, 0, _HIGHEST_ORDER)
        flat, shape = self._parameters(t)
        return self._core.derivatives(flat, order).reshape(*shape, 3)

    def tangent(self, t: npt.ArrayLike) -> Array:
        """Return the unit vectors in the direction in which the curve is passed.

        Parameters
        ----------
        t : array_like of any shape S
            Parameters.

        Returns
        -------
        ndarray of shape S + (3,)
            The tangents.
        """
        flat, shape = self._parameters(t)
        return self._core.tangents(flat).reshape(*shape, 3)

    def curvature(self, t: npt.ArrayLike) -> Array:
        """Return the curvature, in one over the unit of the cloud.

        Parameters
        ----------
        t : array_like of any shape S
            Parameters.

        Returns
        -------
        ndarray of shape S
            The curvatures.
        """
        flat, shape = self._parameters(t)
        return self._core.curvatures(flat).reshape(shape)

    def sample(self, step: Real | None = None, *, count: Integer | None = None) -> Array:
        """Return points that are spaced evenly by length, from end to end.

        Parameters
        ----------
        step : float
            The largest length between two points.
        count : int
            Instead of it, the number of points.

        Returns
        -------
        ndarray of shape (n, 3)
            The points. The first and the last are exactly the ends; of a closed curve they are the same point.
        """
        if (step is None) == (count is None):
            raise TypeError("give either step or count")
        if count is not None:
            return self._core.sample(0.0, _numbers.integer("count", count, 2, _MOST_SAMPLES))
        return self._core.sample(checked_step(step, self.length), 0)

    def closest(self, points: npt.ArrayLike) -> Closest:
        """Return the points of the curve that are closest to others.

        Parameters
        ----------
        points : array_like of shape (n, 3) or (3,)
            The points to which they are to be close.

        Returns
        -------
        Closest
            Their parameters, the points, and the distances.
        """
        return Closest(*self._core.closest(_arrays.finite_points(points)))

    @staticmethod
    def _vector(values: tuple[float, float, float] | None) -> Array | None:
        return None if values is None else np.array(values)

    @staticmethod
    def _parameters(t: npt.ArrayLike) -> tuple[Array, tuple[int, ...]]:
        array = _arrays.finite_numbers(t, "t")
        return array.ravel(), array.shape


def _restored(json: str, index: int, ends: tuple[int | None, int | None]) -> Curve:
    return Curve(_core.from_json(json).curves()[0], index, ends)


def checked_step(step: Any, length: float) -> float:
    """Return a step along curves of some length.

    Raises
    ------
    ValueError
        If it is not positive, or so small that there were more points than anybody can mean.
    """
    number = _numbers.real("step", step)
    if not number > 0.0:
        raise ValueError(f"step is {number}; it has to be positive")
    if length > number * _MOST_SAMPLES:
        raise ValueError(f"step is {number}, which makes {length / number:.3g} points; give a larger one")
    return number
