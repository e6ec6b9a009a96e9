"""What happened during an extraction."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from typing import Iterable

from ._messages import in_python


class ExtractionWarning(UserWarning):
    """What looks odd but did no harm, and that a cloud has no sharp feature."""


@dataclass(frozen=True)
class Report:
    """What happened during an extraction. Lengths are in the unit of the points.

    Attributes
    ----------
    status : str
        "success" or "no_feature".
    message : str
        Why there is no wireframe; empty if there is one.
    warnings : list of str
        What looks odd but did no harm. They were given as `ExtractionWarning`, too.
    note : str
        How a file was taken, where it does not say it; empty otherwise.
    number_of_points, number_of_skipped_points : int
        Points of the cloud, and those left out since they are invalid.
    number_of_duplicates, number_of_strays : int
        Points near features that were left out since they repeat others, or lie far away from all others.
    skeleton_size : int
        Points near features.
    number_of_corners, number_of_free_ends : int
        Vertices of the wireframe in which curves meet, and in which a single curve ends.
    number_of_clusters, number_of_curves, number_of_doubtful_curves : int
        Groups of points that curves start from, curves, and those of them that are doubtful.
    regularities : list of str
        What the parameter `regularize` made equal, coaxial, parallel or orthogonal.
    is_field_estimated : bool
        Whether the distances come from the points alone.
    number_of_near_points : int
        If so, the points that see a feature.
    point_noise : float
        If so, the standard deviation of the points across the surface.
    sampling_distance : float
        The mean distance of a point to its nearest neighbor, r.
    noise : float
        Noise of the distances.
    rms, max : float
        Of the residuals of all curves, the root mean square and the largest.
    seconds : dict of str to float
        Duration of the stages, in their order.
    """

    status: str = "success"
    message: str = ""
    warnings: list[str] = field(default_factory=list)
    note: str = ""
    number_of_points: int = 0
    number_of_skipped_points: int = 0
    number_of_duplicates: int = 0
    number_of_strays: int = 0
    skeleton_size: int = 0
    number_of_corners: int = 0
    number_of_free_ends: int = 0
    number_of_clusters: int = 0
    number_of_curves: int = 0
    number_of_doubtful_curves: int = 0
    regularities: list[str] = field(default_factory=list)
    is_field_estimated: bool = False
    number_of_near_points: int = 0
    point_noise: float = 0.0
    sampling_distance: float = 0.0
    noise: float = 0.0
    rms: float = 0.0
    max: float = 0.0
    seconds: dict[str, float] = field(default_factory=dict)


def checked_report(values: dict[str, object], note: str = "", *paths: object) -> Report:
    """Return a report; `paths` are the files that messages name.

    Raises
    ------
    ValueError
        If the cloud or a parameter cannot be right.
    """
    message = in_python(str(values["message"]), *paths)
    if values["status"] == "invalid_input":
        raise ValueError(message)
    texts = [in_python(text, *paths) for text in values["warnings"]]   # type: ignore[attr-defined]
    changed = {"message": message, "warnings": texts, "note": in_python(note, *paths)}
    return Report(**{**values, **changed})   # type: ignore[arg-type]


def texts_of_warnings(report: Report) -> list[str]:
    """Return what is to be warned of: what looks odd, and that there is no feature."""
    texts = list(report.warnings)
    return texts + [f"there is no wireframe: {report.message}"] if report.status == "no_feature" else texts


def warn(texts: Iterable[str], stacklevel: int) -> None:
    """Warn, in the line of who called the function that calls this one, for 3; for more, farther out."""
    for text in texts:
        warnings.warn(text, ExtractionWarning, stacklevel=stacklevel)
