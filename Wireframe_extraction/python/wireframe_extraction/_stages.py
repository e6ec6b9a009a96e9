"""The extraction stage by stage."""

from __future__ import annotations

import threading
from typing import Any, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _numbers, _parameters
from ._curve import Array
from ._report import Report, checked_report, texts_of_warnings, warn
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

    Nothing is done until it is asked for; then all stages up to there run, once. A stage that was stopped, by Ctrl-C or
    by `progress`, has left nothing, and runs again when it is asked for. Several threads may ask at the same time: one of
    them runs the stages, and the others wait.

    `clusters` and `corners` can be set to other ones, from which the later stages go on. By default, curves are traced
    through the field: clusters tell where traces start, and corners nothing, so that setting them is an error. With
    ``graph_method="subdivided"``, every cluster becomes a curve between corners.

    Parameters
    ----------
    points, distances, threads, progress, **parameters
        As of `extract()`, for arrays, which are copied: what becomes of them later makes no difference. `progress` is
        called for each stage; it must not ask for results.

    Examples
    --------
    >>> extractor = wireframe_extraction.Extractor(points, distances, graph_method="subdivided")
    >>> len(extractor.corners)
    >>> extractor.corners = [corner for corner in extractor.corners if corner.center[2] > 0]
    >>> wireframe = extractor.wireframe
    """

    @_parameters.listed(_parameters.EXTRACTION)
    def __init__(self, points: Any, distances: Any = None, *, threads: int | None = 0, progress: Any = None,
                 **parameters: Any) -> None:
        values = _parameters.checked(Extractor.__init__, parameters, _parameters.EXTRACTION)
        cloud = _arrays.points(points)
        given = _arrays.distances(distances, len(cloud))
        self._progress = _parameters.checked_progress(progress)
        self._number_of_points = len(cloud)
        self._has_distances = given is not None
        self._are_corners_used = values.get("graph_method", "traced") == "subdivided"
        self._core = _core.Stages(cloud.copy(), None if given is None else given.copy(), values,
                                  _parameters.checked_threads(threads))
        self._lock = threading.RLock()   # of the stages, and of what they have left
        self._is_running = False
        self._warned: set[str] = set()

    def __repr__(self) -> str:
        done = _STAGES[:self._core.number_of_done()]
        return (f"<Extractor: {self._number_of_points} points with{'' if self._has_distances else 'out'} distances; "
                f"done: {', '.join(done) or 'nothing'}>")

    def _run(self, stage: str) -> _core.Stages:
        """Run all stages up to one, as far as they have not been run; whoever calls holds the lock."""
        if self._is_running:
            raise RuntimeError("progress asks for results of the stages that it is called from; ask later")
        self._is_running = True
        try:
            texts = []
            while self._core.number_of_done() <= _STAGES.index(stage):
                name = _STAGES[self._core.number_of_done()]
                report = checked_report(getattr(self._core, name)(self._progress))
                # several stages look at the cloud, and may find the same
                texts += [text for text in texts_of_warnings(report) if text not in self._warned]
                self._warned.update(texts)
        finally:
            self._is_running = False
        warn(texts, stacklevel=5)
        return self._core

    def _result(self, stage: str, name: str) -> Any:
        """Return what a stage has left."""
        with self._lock:
            return getattr(self._run(stage), name)()

    @property
    def report(self) -> Report:
        """What happened in the stages that are done; all else is 0 or empty."""
        with self._lock:
            return checked_report(self._core.report())

    @property
    def sampling_distance(self) -> float:
        """Mean distance of a point to its nearest neighbor, r. That of the wireframe is larger if it is that of means."""
        return float(self._result("measure", "sampling_distance"))

    @property
    def distances(self) -> npt.NDArray[Any]:
        """The distances that were given, or else estimated, of shape (n,); a copy."""
        distances: npt.NDArray[Any] = self._result("estimate", "distances")
        return distances.copy() if self._has_distances else distances

    @property
    def skeleton(self) -> Skeleton:
        """The points near sharp features. Of a cloud with much noise they are means of its points."""
        return Skeleton(*self._result("select", "skeleton"))

    @property
    def feet(self) -> Feet:
        """These points, moved onto the curves that the field draws near them."""
        return Feet(*self._result("contract", "feet"))

    @property
    def corners(self) -> list[Corner]:
        """Where curves meet. With ``graph_method="subdivided"`` it can be set; `members` are points of the skeleton."""
        return [Corner(*values) for values in self._result("detect", "corners")]

    @corners.setter
    def corners(self, corners: Iterable[Corner]) -> None:
        if not self._are_corners_used:
            raise ValueError("corners have no effect where curves are traced; give graph_method=\"subdivided\"")
        given = list(corners)   # which may come from this extractor
        with self._lock:
            size = len(self._run("contract").skeleton()[0])
            places, members = [], []
            for i, (center, radius, indices) in enumerate(given):
                place = _arrays.finite_points(center, f"corners[{i}].center")[0]
                extent = _numbers.real(f"corners[{i}].radius", radius)
                if extent < 0.0:
                    raise ValueError(f"corners[{i}].radius is {extent}; it has to be at least 0")
                places.append((place.tolist(), extent))
                members.append(_checked_indices(indices, size, f"corners[{i}].members"))
            self._core.set_corners(places, members)

    @property
    def clusters(self) -> list[Indices]:
        """Groups of points that curves start from: indices of points of the skeleton. It can be set."""
        return list(self._result("segment", "clusters"))

    @clusters.setter
    def clusters(self, clusters: Iterable[npt.ArrayLike]) -> None:
        given = list(clusters)
        with self._lock:
            size = len(self._run("detect").skeleton()[0])
            self._core.set_clusters([_checked_indices(indices, size, f"clusters[{i}]")
                                     for i, indices in enumerate(given)])

    @property
    def graph(self) -> Graph:
        """The topological graph."""
        vertices, are_corners, edges, curves = self._result("build", "graph")
        return Graph(vertices, are_corners.astype(bool), edges, curves)

    @property
    def curves(self) -> Wireframe:
        """The splines that are fitted to the field, before lines, circles and ellipses are recognized."""
        return Wireframe(self._result("fit", "curves"))

    @property
    def wireframe(self) -> Wireframe:
        """The result. Without what was set, it is that of `extract()`, to the last bit."""
        with self._lock:
            return Wireframe(self._result("recognize", "typed"), self.report)


def _checked_indices(indices: npt.ArrayLike, size: int, name: str) -> list[int]:
    array = np.asarray(indices)
    if array.size == 0:
        return []
    if array.ndim != 1 or array.dtype.kind not in "iu":
        raise TypeError(f"{name} has to be a list of indices of points of the skeleton")
    if array.min() < 0 or array.max() >= size:
        raise ValueError(f"{name} has an index beyond the {size} points of the skeleton")
    return [int(index) for index in np.unique(array)]
