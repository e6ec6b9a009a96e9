"""Wireframes for matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arrays, _core
from ._optional import import_optional

if TYPE_CHECKING:
    from ._wireframe import Wireframe

_MOST_POINTS = 5000


def plot(wireframe: Wireframe, ax: Any, points: Any) -> Any:
    """Draw the curves. See `Wireframe.plot()`."""
    cloud = None if points is None else _arrays.finite_points(points)
    if ax is None:
        pyplot = import_optional("matplotlib.pyplot", "plot()")
        ax = pyplot.figure().add_subplot(projection="3d")
    elif not hasattr(ax, "get_zlim"):
        raise TypeError(f"ax is {ax!r}; it has to be three-dimensional, made with projection='3d'")
    if cloud is not None:
        thinned = cloud[::max(1, len(cloud) // _MOST_POINTS)]
        ax.scatter(*thinned.T, s=1, color="#bbbbbb", linewidths=0, depthshade=False)
    samples, curves = wireframe.sample()
    colors = _core.colors()
    seen = set()
    for curve in wireframe.curves:
        label = None if curve.type in seen else curve.type
        seen.add(curve.type)
        ax.plot(*samples[curves == curve.index].T, color=colors[curve.type], label=label,
                linestyle=":" if curve.doubtful else "-")
    if len(wireframe.vertices):
        ax.scatter(*wireframe.vertices.T, s=8, color="black", depthshade=False)
    if seen:
        ax.legend(loc="upper left", frameon=False)
        ax.set_box_aspect(np.maximum(np.ptp(samples, axis=0), 1e-3 * np.ptp(samples)))
    return ax
