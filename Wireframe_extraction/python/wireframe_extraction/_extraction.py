"""From a cloud to its wireframe."""

from __future__ import annotations

import os
from typing import Any, Callable, NamedTuple

import numpy.typing as npt

from . import _arrays, _core, _parameters
from ._clouds import files_of, input_of
from ._curve import Array
from ._messages import as_text, in_python
from ._report import Report, checked_report, texts_of_warnings, warn
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


@_parameters.listed(_parameters.EXTRACTION, _parameters.MESH, _parameters.READING)
def extract(points: Any, distances: Any = None, *, faces: Any = None, normals: Any = None, threads: int | None = 0,
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
    OSError
        If there is no such file (FileNotFoundError), or it may not be read.

    Warns
    -----
    ExtractionWarning
        Of what looks odd, and if there is no sharp feature.
    """
    wireframe, report = extracted(extract, points, distances, faces, normals, threads, progress, parameters)
    warn(texts_of_warnings(report), stacklevel=3)
    return wireframe


def extracted(function: Callable[..., Any], points: Any, distances: Any, faces: Any, normals: Any, threads: Any,
              progress: Any, parameters: dict[str, Any]) -> tuple[Wireframe, Report]:
    """Do what `extract()` does, for whichever function was called; the warnings are in the report only."""
    threads = _parameters.checked_threads(threads)
    progress = _parameters.checked_progress(progress)
    if isinstance(points, (str, bytes, os.PathLike)) or _are_paths(points):
        if faces is not None:
            raise ValueError("faces goes with points in an array; a file has its own faces")
        if normals is not None:
            raise ValueError("normals goes with points in an array; those of a file are passed over")
        return _of_file(function, points, distances, parameters, threads, progress)
    known = {**_parameters.EXTRACTION, **(_parameters.MESH if faces is not None else {})}
    for name in parameters:
        if name not in known and (name in _parameters.MESH or name in _parameters.READING):
            what = "faces, or the name of a file" if name in _parameters.MESH else "the name of a file"
            raise ValueError(f"{name} has no effect on points in an array; it goes with {what}")
    values = _parameters.checked(function, parameters, known)
    points = _arrays.points(points)
    distances = _arrays.distances(distances, len(points))
    _arrays.check_normals(normals, len(points))
    if faces is not None:
        if distances is not None:
            raise ValueError("there are both distances and faces; leave out distances to have them from the mesh, or "
                             "faces")
        points = _arrays.finite_points(points)
        indices = _arrays.faces(faces, len(points))
        return _opened(lambda: _core.extract_mesh(points, indices, _of_reading(values), _of_extraction(values),
                                                   threads, progress))
    core, report = _core.extract_arrays(points, distances, values, threads, progress)
    checked = checked_report(report)
    return Wireframe(core, checked), checked


def _of_reading(values: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in values.items() if name in _parameters.OF_CLOUDS}


def _of_extraction(values: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in values.items() if name in _parameters.EXTRACTION}


@_parameters.listed(_parameters.SHARED)
def estimate_distances(points: Any, *, threads: int | None = 0, progress: Any = None, **parameters: Any) -> Field:
    """Estimate for each point of a cloud its distance to the nearest sharp feature, from the points alone.

    Parameters
    ----------
    points : array_like of shape (n, 3)
        The cloud. It is copied once.
    threads, progress
        As of `extract()`.
    **parameters
        Further ones, all with a default.
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
    values = _parameters.checked(estimate_distances, parameters, _parameters.SHARED)
    threads = _parameters.checked_threads(threads)
    progress = _parameters.checked_progress(progress)
    distances, deviations, report = _core.estimate_distances(_arrays.points(points), values, threads, progress)
    warn(texts_of_warnings(checked_report(report)), stacklevel=3)
    return Field(distances, deviations)


def _are_paths(points: Any) -> bool:
    """Return whether it is a list of names of files, which are patches."""
    return isinstance(points, (list, tuple)) and len(points) > 0 and isinstance(points[0], (str, bytes, os.PathLike))


def _opened(run: Callable[[], Any], *paths: Any) -> tuple[Wireframe, Report]:
    """Return the wireframe of what the compiled part opens, a mesh or another file."""
    try:
        core, report, note, no_feature = run()
    except ValueError as error:
        raise ValueError(in_python(str(error), *paths)) from None
    if no_feature:
        report = {**report, "status": "no_feature", "message": no_feature}
    if report["status"] == "invalid_input" and paths:
        report = {**report, "message": f"{as_text(paths[0])}: {report['message']}"}
    checked = checked_report(report, note, *paths)
    return Wireframe(core, checked), checked


def _of_file(function: Callable[..., Any], path: Any, distances: Any, parameters: dict[str, Any], threads: int,
             progress: Any) -> tuple[Wireframe, Report]:
    known = {**_parameters.EXTRACTION, **_parameters.OF_CLOUDS}
    values = _parameters.checked(function, parameters, known)
    given = input_of(path, distances, _of_reading(values))
    return _opened(lambda: _core.extract_file(given, _of_extraction(values), threads, progress), *files_of(given))
