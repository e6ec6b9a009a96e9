"""The extraction stage by stage."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _numbers, _parameters
from ._curve import Array
from ._report import checked_report
from ._wireframe import Wireframe

Indices = npt.NDArray[np.int64]


class Skeleton(NamedTuple):
    """The points near sharp features.

    Attributes
    ----------
    points : ndarray of shape (s, 3)
        The points.
    distances : ndarray of shape (s,)
        Their distances.
    indices : ndarray of shape (s,)
        Which points of the cloud they are.
    """

    points: Array
    distances: Array
    indices: Indices


class Feet(NamedTuple):
    """The points of the skeleton, moved onto the curves that the field draws near them.

    Attributes
    ----------
    points : ndarray of shape (s, 3)
        The feet, in the order of the skeleton.
    tangents : ndarray of shape (s, 3)
        Unit tangents of these curves; their signs have no meaning.
    residuals : ndarray of shape (s,)
        Root mean square of the residuals of the field near each foot.
    noise : float
        Noise level of the field.
    """

    points: Array
    tangents: Array
    residuals: Array
    noise: float


class Corner(NamedTuple):
    """A place in which curves meet.

    Attributes
    ----------
    center : ndarray of shape (3,)
        Where it is.
    radius : float
        How far from the center its points lie.
    members : ndarray of shape (m,)
        Which points of the skeleton belong to it.
    """

    center: Array
    radius: float
    members: Indices


class Graph(NamedTuple):
    """The topological graph: polylines from corner to corner.

    Attributes
    ----------
    vertices : ndarray of shape (v, 3)
        Positions of the vertices.
    are_corners : ndarray of shape (v,)
        Whether curves end in a vertex; the others lie inside a curve.
    edges : ndarray of shape (e, 2)
        The vertices of each edge.
    curves : ndarray of shape (e,)
        The curve that each edge is a part of.
    """

    vertices: Array
    are_corners: npt.NDArray[np.bool_]
    edges: Indices
    curves: Indices


# the stages in their order; each is a function of the compiled part
_STAGES = ("measure", "estimate", "select", "contract", "detect", "segment", "build", "fit", "recognize")


class Extractor:
    """The extraction stage by stage, for a look at what is in between, and to put something else there.

    Nothing is done until it is asked for; then all stages up to there run, once. `corners` and `clusters` can be set to
    other ones, from which the later stages go on.

    Parameters
    ----------
    points, distances, threads, progress, **parameters
        As of `extract()`, for arrays. `progress` is called for each stage.

    Examples
    --------
    >>> extractor = wireframe_extraction.Extractor(points, distances)
    >>> len(extractor.corners)
    >>> extractor.corners = [corner for corner in extractor.corners if corner.center[2] > 0]
    >>> wireframe = extractor.wireframe
    """

    def __init__(self, points: Any, distances: Any = None, *, threads: int = 0, progress: Any = None,
                 **parameters: Any) -> None:
        values = _parameters.checked("Extractor", parameters, _parameters.EXTRACTION)
        self._points = _arrays.points(points)
        given = _arrays.distances(distances, len(self._points))
        self._progress = _parameters.checked_progress(progress)
        self._core = _core.Stages(self._points, given, values, _parameters.checked_threads(threads))
        self._skipped = ("estimate",) if given is not None else ()
        self._number_of_done = 0
        self._warnings: list[str] = []

    def _run(self, stage: str) -> _core.Stages:
        """Run all stages up to one, as far as they have not been run."""
        last = _STAGES.index(stage)
        while self._number_of_done <= last:
            name = _STAGES[self._number_of_done]
            if name not in self._skipped:
                report = getattr(self._core, name)(self._progress)
                # several stages look at the cloud, and may find the same
                report["warnings"] = [text for text in report["warnings"] if text not in self._warnings]
                self._warnings += report["warnings"]
                checked_report(report, stacklevel=4)
            self._number_of_done += 1
        return self._core

    @property
    def sampling_distance(self) -> float:
        """Mean distance of a point to its nearest neighbor, r."""
        return self._run("measure").sampling_distance()

    @property
    def distances(self) -> npt.NDArray[Any]:
        """The distances that were given, or else estimated, of shape (n,)."""
        return self._run("estimate").distances()

    @property
    def skeleton(self) -> Skeleton:
        """The points near sharp features."""
        return Skeleton(*self._run("select").skeleton())

    @property
    def feet(self) -> Feet:
        """These points, moved onto the curves that the field draws near them."""
        return Feet(*self._run("contract").feet())

    @property
    def corners(self) -> list[Corner]:
        """Where curves meet. It can be set, to corners of which `members` are points of the skeleton."""
        return [Corner(*values) for values in self._run("detect").corners()]

    @corners.setter
    def corners(self, corners: Iterable[Corner]) -> None:
        size = len(self._run("contract").skeleton()[0])
        places, members = [], []
        for i, (center, radius, indices) in enumerate(corners):
            place = _arrays.finite_points(center, f"corners[{i}].center")[0]
            extent = _numbers.real(f"corners[{i}].radius", radius)
            if extent < 0.0:
                raise ValueError(f"corners[{i}].radius is {extent}; it has to be at least 0")
            places.append((place.tolist(), extent))
            members.append(_checked_indices(indices, size, f"corners[{i}].members"))
        self._core.set_corners(places, members)
        self._number_of_done = _STAGES.index("detect") + 1

    @property
    def clusters(self) -> list[Indices]:
        """Groups of points that curves start from: indices of points of the skeleton. It can be set."""
        return list(self._run("segment").clusters())

    @clusters.setter
    def clusters(self, clusters: Iterable[npt.ArrayLike]) -> None:
        size = len(self._run("detect").skeleton()[0])
        self._core.set_clusters([_checked_indices(indices, size, f"clusters[{i}]")
                                 for i, indices in enumerate(clusters)])
        self._number_of_done = _STAGES.index("segment") + 1

    @property
    def graph(self) -> Graph:
        """The topological graph."""
        vertices, are_corners, edges, curves = self._run("build").graph()
        return Graph(vertices, are_corners.astype(bool), edges, curves)

    @property
    def curves(self) -> Wireframe:
        """The splines that are fitted to the field, before lines, circles and ellipses are recognized."""
        return Wireframe(self._run("fit").curves())

    @property
    def wireframe(self) -> Wireframe:
        """The result. Without what was set, it is that of `extract()`, but for the report."""
        return Wireframe(self._run("recognize").typed())


def _checked_indices(indices: npt.ArrayLike, size: int, name: str) -> list[int]:
    array = np.asarray(indices)
    if array.size == 0:
        return []
    if array.ndim != 1 or array.dtype.kind not in "iu":
        raise TypeError(f"{name} has to be a list of indices of points of the skeleton")
    if array.min() < 0 or array.max() >= size:
        raise ValueError(f"{name} has an index beyond the {size} points of the skeleton")
    return [int(index) for index in np.unique(array)]
