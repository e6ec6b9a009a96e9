"""Wireframes in a browser: the page of the tool, or else a drawing and a table."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _files

if TYPE_CHECKING:
    from ._wireframe import Wireframe

_MOST_POINTS = 1_000_000
_HEIGHT = 480


def _samples(points: Any, distances: Any) -> npt.NDArray[np.float64]:
    """Return the cloud that is shown, as rows of three coordinates and a distance."""
    if points is None:
        if distances is not None:
            raise ValueError("distances goes with points; give both, or none")
        return np.empty((0, 4))
    cloud = _arrays.finite_points(points)
    values = _arrays.distances(distances, len(cloud))
    step = -(-len(cloud) // _MOST_POINTS) or 1
    values = np.zeros(len(cloud)) if values is None else values
    return np.column_stack([cloud, values])[::step].astype(np.float64)


def _summary(wireframe: Wireframe) -> list[tuple[str, str]]:
    types, counts = np.unique(wireframe.types, return_counts=True)
    rows = [("Vertices", str(len(wireframe.vertices))),
            ("Curves", ", ".join(f"{count} {name}" for name, count in zip(types, counts)) or "none"),
            ("Doubtful", f"{int(wireframe.doubtful.sum())} of {len(wireframe.curves)} curves"),
            ("Length", f"{sum(curve.length for curve in wireframe.curves):.6g}"),
            ("r", f"{wireframe.sampling_distance:.4g}")]
    if wireframe.report is not None:
        rows += [("Points", str(wireframe.report.number_of_points)), ("Residuals", f"rms {wireframe.report.rms:.4g}")]
    return rows


def _table(wireframe: Wireframe) -> str:
    rows = [f"<tr><th>{html.escape(name)}</th><td>{html.escape(text)}</td></tr>" for name, text in _summary(wireframe)]
    return f"<table>{''.join(rows)}</table>"


def _drawing(wireframe: Wireframe) -> str:
    svg = _core.to_svg(wireframe._core) if wireframe.curves else ""
    return svg[svg.find("<svg"):] if "<svg" in svg else ""


def page(wireframe: Wireframe, points: Any, distances: Any, title: str, unit: str) -> str:
    """Return a page. See `Wireframe.to_html()`."""
    if not isinstance(title, str):
        raise TypeError(f"title is {title!r}; it has to be a text")
    _files.check_unit(unit)
    title = title.encode("utf-8", "backslashreplace").decode("utf-8")   # names of files may have what is no UTF-8
    samples = _samples(points, distances)
    if _core.has_viewer() and wireframe.curves:
        texts = wireframe.report.warnings if wireframe.report is not None else []
        return _core.page(wireframe._core, samples, title, unit, _summary(wireframe), texts)
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title></head>'
            f"<body>{_table(wireframe)}{_drawing(wireframe)}</body></html>")


def frame(wireframe: Wireframe) -> str:
    """Return what a notebook shows: the page in a frame of its own, so that its style and scripts stay there."""
    if not (_core.has_viewer() and wireframe.curves):
        return _table(wireframe) + _drawing(wireframe)
    text = html.escape(page(wireframe, None, None, "Wireframe", "mm"))
    return (f'<iframe srcdoc="{text}" sandbox="allow-scripts" style="width:100%;height:{_HEIGHT}px;border:0"></iframe>')
