"""From a cloud to its wireframe."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy.typing as npt

from . import _arrays, _core, _parameters
from ._clouds import input_of
from ._curve import Array
from ._messages import in_python
from ._report import checked_report
from ._wireframe import Wireframe


class Field(NamedTuple):
    """Distances that were estimated from points alone.

    Attributes
    ----------
    distances : ndarray of shape (n,)
        For each point, the distance to the nearest sharp feature; nan for points that were left out.
    deviations : ndarray of shape (n,)
        Their standard deviations.
    """

    distances: Array
    deviations: Array


def extract(points: Any, distances: Any = None, *, faces: Any = None, normals: Any = None, threads: int = 0,
            progress: Any = None, **parameters: Any) -> Wireframe:
    """Extract the parametric wireframe of a shape from a dense point cloud of its surface.

    The result is that of the tool `extract_wireframe` for the same cloud and parameters, to the last bit, whatever the
    number of threads. While it is made, other Python threads go on, and Ctrl-C stops it.

    Parameters
    ----------
    points : array_like of shape (n, 3), or path-like
        The cloud, as it is scanned: arrays of float32 or float64 are not copied, whatever their strides. Or the name of
        a file in any format of the tool, also of a mesh; a large cloud stays in its file.
    distances : array_like of shape (n,), or path-like, optional
        The distance of each point to the nearest sharp feature, in the unit of the points, known at least up to 3
        sampling distances. If there are none, they are estimated from the points, and all points are copied once.
    faces : array_like of shape (m, 3), optional
        The faces of a mesh, whose vertices are `points`. A shape whose sharp edges are edges of the mesh, as CAD
        programs export them, is sampled; the vertices of a scan are the points.
    normals : array_like of shape (n, 3), optional
        The normals of the points, for clouds that come with them. They are checked and not used: the points tell where
        the surface is folded, and the result is the same without them.
    threads : int
        The largest number of threads; 0 for as many as there are.
    progress : callable, optional
        Called now and then with the share that is done, from 0 to 1. What it raises stops the extraction.
    **parameters
        All parameters of the tool, `sampling_distance`, `minimum_fold` and so on: ``help(default_parameters)`` says
        what they do, and ``default_parameters()`` has their defaults. Lengths are in multiples of the sampling
        distance, but for `sampling_distance` itself; angles are in degrees. None stands for the default. Of files,
        those of `read_cloud()`, too; of meshes, `mesh`, `maximum_facet_fold`, `maximum_number_of_points` and
        `use_boundaries`.

    Returns
    -------
    Wireframe
        The wireframe. It is empty if the cloud has no sharp feature; its report says why.

    Raises
    ------
    TypeError
        If an argument has a type that it cannot have, or there is no such parameter; the message has the nearest name.
    ValueError
        If the cloud or a parameter cannot be right; the message names it, and the remedy.

    Warns
    -----
    ExtractionWarning
        Of what looks odd, and if there is no sharp feature.
    """
    threads = _parameters.checked_threads(threads)
    progress = _parameters.checked_progress(progress)
    if isinstance(points, (str, bytes, os.PathLike)) or _are_paths(points):
        if faces is not None:
            raise ValueError("faces goes with points in an array; a file has its own faces")
        if normals is not None:
            raise ValueError("normals goes with points in an array; those of a file are passed over")
        return _of_file(points, distances, parameters, threads, progress)
    known = {**_parameters.EXTRACTION, **(_parameters.MESH if faces is not None else {})}
    for name in parameters:
        if name not in known and (name in _parameters.MESH or name in _parameters.READING):
            what = "faces, or the name of a file" if name in _parameters.MESH else "the name of a file"
            raise ValueError(f"{name} has no effect on points in an array; it goes with {what}")
    values = _parameters.checked("extract", parameters, known)
    points = _arrays.points(points)
    distances = _arrays.distances(distances, len(points))
    _arrays.check_normals(normals, len(points))
    if faces is not None:
        if distances is not None:
            raise ValueError("there are both distances and faces; leave out distances to have them from the mesh, or "
                             "faces")
        points, distances = _sampled(points, faces, values)
    core, report = _core.extract_arrays(points, distances, _only_of_extraction(values), threads, progress)
    return Wireframe(core, checked_report(report))


def estimate_distances(points: Any, *, threads: int = 0, progress: Any = None, sampling_distance: float | None = None,
                       minimum_fold: float | None = None, skip_invalid: bool = False) -> Field:
    """Estimate for each point of a cloud its distance to the nearest sharp feature, from the points alone.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        The cloud. It is copied once.
    threads, progress
        As of `extract()`.
    sampling_distance : float, optional
        The mean distance of a point to its nearest neighbor, in the unit of the points; estimated if it is not given.
    minimum_fold : float, optional
        The least angle by which the surface is folded at a sharp feature, in degrees; 20 if it is not given.
    skip_invalid : bool
        Whether points that are not finite are left out; otherwise they are an error.

    Returns
    -------
    Field
        The distances and their standard deviations. Far from all features, distances are cut off.

    Raises
    ------
    ValueError
        If the cloud or a parameter cannot be right.

    Warns
    -----
    ExtractionWarning
        If there is no sharp feature.
    """
    given = {"sampling_distance": sampling_distance, "minimum_fold": minimum_fold, "skip_invalid": skip_invalid}
    values = _parameters.checked("estimate_distances", given, _parameters.EXTRACTION)
    threads = _parameters.checked_threads(threads)
    progress = _parameters.checked_progress(progress)
    distances, deviations, report = _core.estimate_distances(_arrays.points(points), values, threads, progress)
    checked_report(report)
    return Field(distances, deviations)


def _are_paths(points: Any) -> bool:
    """Return whether it is a list of names of files, which are patches."""
    return isinstance(points, (list, tuple)) and len(points) > 0 and isinstance(points[0], (str, bytes, os.PathLike))


def _only_of_extraction(values: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in values.items() if name in _parameters.EXTRACTION}


def _sampled(points: npt.NDArray[Any], faces: Any, values: dict[str, Any]) -> tuple[npt.NDArray[Any], Array | None]:
    """Return the cloud of a mesh; the vertices, without distances, if it is a scan."""
    indices = _arrays.faces(faces, len(points))
    if values.get("mesh") == "scan":
        return points, None
    given = {name: value for name, value in values.items() if name in _parameters.MESH or name in _parameters.SHARED}
    try:
        samples, distances, is_scan = _core.sample_mesh(_arrays.finite_points(points), indices, given)
    except ValueError as error:
        raise ValueError(in_python(str(error))) from None
    return (points, None) if is_scan else (samples, distances)


def _of_file(path: Any, distances: Any, parameters: dict[str, Any], threads: int, progress: Any) -> Wireframe:
    known = {**_parameters.EXTRACTION, **_parameters.MESH, **_parameters.READING}
    values = _parameters.checked("extract", parameters, known)
    reading = {name: value for name, value in values.items()
               if name in _parameters.MESH or name in _parameters.READING or name in _parameters.SHARED}
    try:
        core, report, note, no_feature = _core.extract_file(input_of(path, distances, reading),
                                                            _only_of_extraction(values), threads, progress)
    except ValueError as error:
        raise ValueError(in_python(str(error))) from None
    if no_feature:
        report = {**report, "status": "no_feature", "message": no_feature}
    if report["status"] == "invalid_input":
        name = path if isinstance(path, (str, bytes, os.PathLike)) else path[0]
        report = {**report, "message": f"{os.fsdecode(os.fspath(name))}: {report['message']}"}
    return Wireframe(core, checked_report(report, note, stacklevel=4))
