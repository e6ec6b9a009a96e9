"""Clouds in files."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from . import _core, _parameters
from ._curve import Array
from ._files import existing
from ._messages import in_python


class _Pair(NamedTuple):
    points: Array
    distances: Array | None


class Cloud(_Pair):
    """A cloud that was read: a pair, so that ``extract(*cloud)`` takes it.

    Attributes
    ----------
    points : ndarray of shape (n, 3)
        The points.
    distances : ndarray of shape (n,) or None
        Their distances to the nearest sharp feature; None if the file has none.
    note : str
        How the file was taken, where it does not say it; empty otherwise.
    number_of_skipped_points : int
        Points that were left out since they are invalid.
    """

    note: str = ""
    number_of_skipped_points: int = 0


def input_of(paths: Any, distances: Any, reading: dict[str, Any]) -> dict[str, Any]:
    """Return what the compiled part reads: the files, and how."""
    files = list(paths) if isinstance(paths, (list, tuple)) else [paths]
    if not files:
        raise ValueError("there is no file; give the name of one")
    if len(files) > 1 and not reading.get("patches", False):
        raise ValueError("several files are read as patches of one cloud only: give patches=True, or use "
                         "extract_many()")
    if distances is not None and not isinstance(distances, (str, bytes, os.PathLike)):
        raise TypeError("distances has to be the name of a file, as points is; or read the cloud with read_cloud()")
    if "fusion" in reading and not reading.get("patches", False):
        raise ValueError("fusion is about patches: it goes with patches=True")
    if distances is not None and reading.get("patches", False):
        raise ValueError("patches have their distances with them; leave distances out")
    values = {**reading, "files": [existing(path) for path in files]}
    return values if distances is None else {**values, "distances": existing(distances)}


@_parameters.listed(_parameters.OF_CLOUDS)
def read_cloud(path: Any, distances: Any = None, **parameters: Any) -> Cloud:
    """Read a cloud, in any format of the tool; a mesh is sampled, with the distances to its sharp edges.

    Parameters
    ----------
    path : path-like, or a list of them with `patches`
        The name of the file.
    distances : path-like, optional
        The name of a file with the distances, if they are not with the points.
    **parameters
        How to read it; all have a default.
    field : {"auto", "given", "estimated"}
        Where distances have to come from: "given" makes it an error if there are none, and with "estimated" they are
        not looked at.
    input_format : str
        The extension that stands for the format, if the name of the file has another one.
    coordinate_properties : three of str
        Names of the properties or columns with x, y and z, or of columns without names their numbers as text.
    distance_property, points_dataset, distances_dataset, indices_dataset : str
        Names of what is to be read, if they are not the usual ones.
    patches : bool
        Whether the file, or each of several ones, has overlapping patches of a cloud.
    fusion : {"minimum", "median"}
        What becomes of the distances of a point in several patches.
    use_indices : bool
        Whether points of patches are the same by their indices, or else by their positions.
    skip_invalid : bool
        Whether points that are not finite or have a negative distance are left out; otherwise they are an error.
    clamp_negative : bool
        Whether distances a little below zero, as regressors predict them, count as zero.
    mesh : {"auto", "cad", "scan"}
        What a mesh is taken for: a shape, whose surface is sampled, or a scan, whose vertices are the points.
    sampling_distance, minimum_fold, maximum_facet_fold, maximum_number_of_points, use_boundaries
        How a mesh is sampled, as of the tool.

    Returns
    -------
    Cloud
        The points and the distances, as float64.

    Raises
    ------
    OSError
        If there is no such file (FileNotFoundError), or it may not be read.
    ValueError
        If it cannot be read; the message says where, why, and what helps.
    """
    values = input_of(path, distances, _parameters.checked(read_cloud, parameters, _parameters.OF_CLOUDS))
    try:
        points, known_distances, note, skipped = _core.read_cloud(values)
    except ValueError as error:
        raise ValueError(in_python(str(error), *files_of(values))) from None
    cloud = Cloud(points, None if values.get("field") == "estimated" else known_distances)
    cloud.note = in_python(note, *files_of(values))
    cloud.number_of_skipped_points = skipped
    return cloud


def files_of(values: dict[str, Any]) -> list[bytes]:
    """Return the names of all files that `input_of()` returned."""
    return [*values["files"], *([values["distances"]] if "distances" in values else [])]
