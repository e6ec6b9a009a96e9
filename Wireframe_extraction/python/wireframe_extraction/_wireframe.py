"""A parametric wireframe."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from . import _arrays, _core, _files
from ._curve import Array, Curve, checked_step
from ._report import Report

if TYPE_CHECKING:
    import networkx
    import pandas
    import pyvista
    from mpl_toolkits.mplot3d import Axes3D

    from ._types import Flag, Path, Real, Unit


class Wireframe:
    """A parametric wireframe: vertices, and curves between them.

    Wireframes come from `extract()` and `read()`, and do not change. They can be pickled. Lengths are in the unit of
    the cloud. A wireframe is equal to itself only, and so are curves: `evaluate()` tells how well two agree.
    """

    def __init__(self, core: _core.Wireframe | None = None, report: Report | None = None) -> None:
        self._core = _core.Wireframe() if core is None else core
        self._report = report
        self._curves: tuple[Curve, ...] | None = None   # made when they are asked for

    def __repr__(self) -> str:
        return f"<Wireframe: {len(self.vertices)} vertices, {len(self.curves)} curves>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (_core.to_json(self._core), self._report)

    @property
    def vertices(self) -> Array:
        """Corners and ends of curves, of shape (v, 3); a copy."""
        return self._core.vertices

    @property
    def curves(self) -> tuple[Curve, ...]:
        """The curves, in the order in which files have them."""
        if self._curves is None:
            self._curves = tuple(Curve(core, index) for index, core in enumerate(self._core.curves()))
        return self._curves

    @property
    def edges(self) -> npt.NDArray[np.int64]:
        """The vertices at which each curve starts and ends, of shape (c, 2); -1 where a closed curve has none."""
        return self._core.edges()

    @property
    def types(self) -> npt.NDArray[np.str_]:
        """The type of each curve, of shape (c,): ``wireframe.types == "circle"``."""
        return np.array([curve.type for curve in self.curves], dtype="<U12")

    @property
    def doubtful(self) -> npt.NDArray[np.bool_]:
        """Whether each curve is doubtful, of shape (c,): ``(~wireframe.doubtful).sum()`` counts the others."""
        return np.array([curve.doubtful for curve in self.curves], dtype=bool)

    @property
    def sampling_distance(self) -> float:
        """Mean distance of a point of the cloud to its nearest neighbor, r."""
        return self._core.sampling_distance

    @property
    def report(self) -> Report | None:
        """What happened during the extraction; None of a wireframe that was read."""
        return self._report

    def is_valid(self) -> bool:
        """Return whether the wireframe can be written.

        Returns
        -------
        bool
            Whether all numbers are finite, curves start and end at their vertices, and so on.
        """
        return not self._core.problem()

    def sample(self, step: Real | None = None) -> tuple[Array, npt.NDArray[np.int64]]:
        """Return points along all curves, spaced evenly by length on each.

        Parameters
        ----------
        step : float, optional
            The largest length between two points of a curve; the sampling distance if it is not given.

        Returns
        -------
        points : ndarray of shape (n, 3)
            The points, curve by curve; each curve has its ends.
        curves : ndarray of shape (n,)
            The index of the curve of each point.
        """
        length = sum(curve.length for curve in self.curves)
        if step is None:
            step = self.sampling_distance or length / 1000 or 1.0
        step = checked_step(step, length)
        pieces = [curve.sample(step) for curve in self.curves]
        indices = np.repeat(np.arange(len(pieces)), [len(piece) for piece in pieces])
        return np.concatenate([np.empty((0, 3)), *pieces]), indices.astype(np.int64)

    def distance(self, points: npt.ArrayLike) -> Array:
        """Return how far points are from the nearest curve.

        Parameters
        ----------
        points : array_like of shape (n, 3) or (3,)
            The points.

        Returns
        -------
        ndarray of shape (n,)
            The distances; infinity if there is no curve.
        """
        return self._core.distances(_arrays.finite_points(points))

    def write(self, path: Path, *, unit: Unit = "mm", step: Real | None = None, chord_tolerance: Real | None = None,
              obj_splines: Flag = False, dxf_splines: Flag = False,
              schema: Literal["ap214", "ap242"] = "ap214") -> None:
        """Write the wireframe into a file, in the format that the extension names.

        All formats of the tool are there: .json (everything), .step .stp .iges .igs .brep .dxf (the curves), .obj .ply
        .vtp .gltf .glb .polylines.txt .txt .cgal (polylines), .svg (a drawing), .csv (a table), and .html (a page).

        Parameters
        ----------
        path : path-like
            The name of the file. It is replaced as a whole, or left as it is.
        unit : {"um", "mm", "cm", "m", "in", "ft"}
            What the coordinates are in, for formats that say so; nothing is converted.
        step : float, optional
            Of polylines, the largest length between two points; a quarter of the sampling distance if it is not given.
        chord_tolerance : float, optional
            Of polylines, how far they may be from their curves; a line is one piece then, unless `step` is given.
        obj_splines : bool
            Whether .obj has free-form curves instead of polylines.
        dxf_splines : bool
            Whether .dxf has splines instead of circles, ellipses and arcs that are tilted against the xy plane, for
            programs that flatten these or put them elsewhere.
        schema : {"ap214", "ap242"}
            The application protocol of .step and .stp.

        Raises
        ------
        ValueError
            If the extension is unknown, an argument is wrong or has no effect on the format, or the wireframe is not
            valid, or is empty where the format needs a curve.
        OSError
            If the file cannot be written: FileNotFoundError, PermissionError and so on, with `errno`.
        ImportError
            If the module was built without OpenCASCADE, which .step, .iges and .brep need.
        """
        _files.write(self, path, unit, step, chord_tolerance, obj_splines, dxf_splines, schema)

    def to_html(self, points: npt.ArrayLike | None = None, distances: npt.ArrayLike | None = None, *,
                title: str = "Wireframe", unit: Unit = "mm") -> str:
        """Return a page for a browser that shows the curves, and the cloud if it is given.

        Parameters
        ----------
        points : array_like of shape (n, 3), optional
            The cloud; at most a million of its points are shown.
        distances : array_like of shape (n,), optional
            The distances of the points, which color them.
        title : str
            The title of the page.
        unit : {"um", "mm", "cm", "m", "in", "ft"}
            What the coordinates are in.

        Returns
        -------
        str
            HTML that needs nothing else. If the module was built without the viewer, it is a drawing and a table.
        """
        from . import _html

        return _html.page(self, points, distances, title, unit)

    def _repr_html_(self) -> str:
        from . import _html

        return _html.frame(self)

    def to_networkx(self, *, plain: bool = False) -> networkx.MultiGraph:
        """Return the wireframe as a graph of NetworkX.

        Parameters
        ----------
        plain : bool
            Whether there are numbers and texts only, as files of graphs need them: ``networkx.write_graphml()`` and so
            on. Then nodes have `x`, `y` and `z` instead of `pos`, edges no `curve`, and `closed_curves` is a text.

        Returns
        -------
        networkx.MultiGraph
            Nodes are the indices of vertices, with their position `pos`; edges are curves, with their index as key, and
            with `curve`, `type`, `length` and `doubtful`. Closed curves without vertex are in
            ``graph.graph["closed_curves"]``.
        """
        from . import _convert

        return _convert.to_networkx(self, plain)

    def to_pandas(self) -> pandas.DataFrame:
        """Return a table of the curves for pandas, with the columns of the format .csv.

        Returns
        -------
        pandas.DataFrame
            A row per curve; what a curve does not have is missing.
        """
        from . import _convert

        return _convert.to_pandas(self)

    def to_pyvista(self, step: Real | None = None) -> pyvista.PolyData:
        """Return the curves as polylines for PyVista.

        Parameters
        ----------
        step : float, optional
            As of `sample()`.

        Returns
        -------
        pyvista.PolyData
            A line per curve, with the cell data `curve`, `type`, `length`, `radius`, `rms` and `doubtful`.
        """
        from . import _convert

        return _convert.to_pyvista(self, step)

    def plot(self, ax: Axes3D | None = None, *, points: npt.ArrayLike | None = None) -> Axes3D:
        """Draw the curves with matplotlib, in the colors of their types; those that are doubtful are dotted.

        Parameters
        ----------
        ax : Axes3D, optional
            Where to draw; a new figure if it is not given.
        points : array_like of shape (n, 3), optional
            A cloud that is drawn behind, thinned out to 5000 points.

        Returns
        -------
        Axes3D
            Where it was drawn.
        """
        from . import _plot

        return _plot.plot(self, ax, points)


def _restored(json: str, report: Report | None) -> Wireframe:
    return Wireframe(_core.from_json(json), report)
