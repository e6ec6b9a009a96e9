"""Wireframes for networkx, pandas and PyVista."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._optional import import_optional

if TYPE_CHECKING:
    from ._curve import Curve
    from ._wireframe import Wireframe

_COLUMNS = ("index type closed source target length center_x center_y center_z axis_x axis_y axis_z major_direction_x "
            "major_direction_y major_direction_z major_radius minor_radius start_angle end_angle position_uncertainty "
            "direction_uncertainty major_radius_uncertainty minor_radius_uncertainty rms max support doubtful doubts").split()


def to_networkx(wireframe: Wireframe, plain: bool) -> Any:
    """Return a networkx.MultiGraph. See `Wireframe.to_networkx()`."""
    networkx = import_optional("networkx", "to_networkx()")
    closed = [curve.index for curve in wireframe.curves if curve.source is None]
    graph = networkx.MultiGraph(closed_curves=" ".join(map(str, closed)) if plain else closed)
    for index, position in enumerate(wireframe.vertices):
        place = tuple(map(float, position))
        attributes: dict[str, Any] = dict(zip("xyz", place)) if plain else {"pos": place}
        graph.add_node(index, **attributes)
    for curve in wireframe.curves:
        if curve.source is not None:
            graph.add_edge(curve.source, curve.target, key=curve.index, type=curve.type, length=curve.length,
                           doubtful=curve.doubtful, **({} if plain else {"curve": curve}))
    return graph


def _coordinates(name: str, vector: Any) -> dict[str, float]:
    values = [math.nan] * 3 if vector is None else vector
    return {f"{name}_{axis}": float(value) for axis, value in zip("xyz", values)}


def _row(curve: Curve) -> dict[str, Any]:
    major_radius, minor_radius = curve.radii or (math.nan, math.nan)
    start_angle, end_angle = curve.angles or (math.nan, math.nan)
    uncertainty = curve.uncertainty or {}
    is_conic = curve.radii is not None
    return {
        "index": curve.index,
        "type": curve.type,
        "closed": curve.closed,
        "source": curve.source,
        "target": curve.target,
        "length": curve.length,
        **_coordinates("center", curve.center),
        **_coordinates("axis", curve.axis),
        **_coordinates("major_direction", curve.major_direction),
        "major_radius": major_radius,
        "minor_radius": minor_radius,
        "start_angle": start_angle,
        "end_angle": end_angle,
        "position_uncertainty": uncertainty.get("position", math.nan),
        "direction_uncertainty": uncertainty.get("direction", math.nan),
        "major_radius_uncertainty": uncertainty["major_radius"] if is_conic else math.nan,
        "minor_radius_uncertainty": uncertainty["minor_radius"] if is_conic else math.nan,
        "rms": curve.rms,
        "max": curve.max,
        "support": curve.support,
        "doubtful": curve.doubtful,
        "doubts": " ".join(curve.doubts),
    }


def to_pandas(wireframe: Wireframe) -> Any:
    """Return a pandas.DataFrame. See `Wireframe.to_pandas()`."""
    pandas = import_optional("pandas", "to_pandas()")
    table = pandas.DataFrame([_row(curve) for curve in wireframe.curves], columns=_COLUMNS)
    for name in ("source", "target"):
        table[name] = table[name].astype("Int64")
    return table.set_index("index")


def to_pyvista(wireframe: Wireframe, step: Any) -> Any:
    """Return a pyvista.PolyData. See `Wireframe.to_pyvista()`."""
    pyvista = import_optional("pyvista", "to_pyvista()")
    points, curves = wireframe.sample(step)
    counts = np.bincount(curves, minlength=len(wireframe.curves))
    ends = np.cumsum(counts)
    # of each line, the number of its points and then their indices
    lines = np.insert(np.arange(len(points)), ends - counts, counts)
    data = pyvista.PolyData(points, lines=lines)
    data.cell_data["curve"] = np.arange(len(wireframe.curves))
    data.cell_data["type"] = wireframe.types
    data.cell_data["length"] = np.array([curve.length for curve in wireframe.curves])
    radii = [math.nan if curve.radius is None else curve.radius for curve in wireframe.curves]
    data.cell_data["radius"] = np.array(radii)
    data.cell_data["rms"] = np.array([curve.rms for curve in wireframe.curves])
    data.cell_data["doubtful"] = wireframe.doubtful
    return data
