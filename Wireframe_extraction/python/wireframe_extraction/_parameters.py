"""The parameters of an extraction: their names, types and defaults."""

from __future__ import annotations

import difflib
import inspect
from typing import Any, Callable, Iterable, Mapping, TypeVar

import numpy as np

from . import _core, _numbers

_DEFAULTS: dict[str, Any] = _core.default_parameters()
_CHOICES: dict[str, list[str]] = {
    **_core.choices(),
    "mesh": ["auto", "cad", "scan"],
    "field": ["auto", "given", "estimated"],
    "fusion": ["minimum", "median"],
}
# these follow from the cloud unless they are given
_AUTOMATIC = ("sampling_distance", "noise_level", "corner_residual")
_INTEGER_RANGES = {
    "points_in_memory": (1, 2**31 - 1),
    "number_of_rounds": (1, 1000),
    "maximum_number_of_points": (100, 50000000),
}

#: of meshes, with the type of each
MESH = {"mesh": str, "maximum_facet_fold": float, "maximum_number_of_points": int, "use_boundaries": bool}
#: of files, with the type of each
READING = {
    "field": str,
    "input_format": str,
    "coordinate_properties": tuple,
    "distance_property": str,
    "points_dataset": str,
    "distances_dataset": str,
    "indices_dataset": str,
    "clamp_negative": bool,
    "use_indices": bool,
    "patches": bool,
    "fusion": str,
}
#: of the extraction, with the type of each
EXTRACTION = {name: type(value) for name, value in _DEFAULTS.items()}
#: of the extraction, as far as meshes and files have them, too
SHARED = {name: EXTRACTION[name] for name in ("sampling_distance", "minimum_fold", "skip_invalid")}

#: of files and meshes that are read as clouds
OF_CLOUDS = {**READING, **MESH, **SHARED}

_NO_NORMALS = "normals are not used: the points tell where the surface is folded"
_HINTS = {
    "normal": _NO_NORMALS,
    "normals": _NO_NORMALS,
    "verbose": "nothing is printed; progress takes a function of the share that is done",
    "n_jobs": "the number of threads is threads",
    "num_threads": "the number of threads is threads",
}

_Function = TypeVar("_Function", bound=Callable[..., Any])


def listed(*groups: Mapping[str, type]) -> Callable[[_Function], _Function]:
    """Return a decorator: the signature of a function gets the parameters that it takes as ``**parameters``.

    So notebooks and editors show them, and `checked()` knows all names that the function has.
    """
    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function)
        named = [parameter for parameter in signature.parameters.values()
                 if parameter.kind is not inspect.Parameter.VAR_KEYWORD]
        others = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None)
                  for name in dict.fromkeys(name for group in groups for name in group)]
        function.__signature__ = signature.replace(parameters=named + others)   # type: ignore[attr-defined]
        return function

    return decorate


def default_parameters() -> dict[str, Any]:
    """Return all parameters of an extraction with their defaults.

    Lengths are in multiples of the sampling distance r, but for `sampling_distance` itself; angles are in degrees.

    - Scale and field: `sampling_distance` is r, in the unit of the points; `minimum_fold`, where distances are
      estimated, the least angle by which the surface is folded at a sharp feature; `noise_level` the noise of the
      distances.
    - Skeleton: points with a distance below `skeleton_distance` form it, those below `support_distance` support the
      fits; `fitting_radius` is that of the balls in which curves are fitted to the field; `use_creases` tells whether
      creases of the surface correct the field.
    - Corners: `corner_measure` tells one, the residual of a fit to the field or the variance of the points;
      `corner_sampling_ratio` is the share of the skeleton at which corners are looked for, `corner_radius` the radius
      of the balls; above `corner_variance` or `corner_residual` a ball holds one.
    - Clusters: points closer than `connection_radius` may belong to one curve, if their tangents differ by less than
      `connection_angle`; `use_tangents` tells whether that counts.
    - Graph: `graph_method` traces curves through the field, or subdivides a polyline per cluster, whose ends
      `end_detection` finds, where the residual is above `split_threshold`. Curves that end within `corner_reach` of a
      corner are joined to it, gaps of up to `maximum_gap` are bridged, a curve that turns by less than `smooth_angle`
      goes on through a vertex, and `minimum_evidence` is the support of the field that a curve must have.
    - Fit: `use_robust_loss` tells whether outliers count less, `move_corners` whether corners move to where curves
      meet, `adapt_knots` whether knots are added where residuals ask for them; `number_of_rounds` is how often foot
      points are found anew.
    - Types: `recognize_types` tells whether lines, circles, ellipses and their arcs replace splines,
      `type_significance` is the share of true ones that may be taken for splines, and `regularize` makes radii equal,
      circles coaxial, and directions parallel or orthogonal, where the field agrees.
    - Input: `skip_invalid` leaves out points that are not finite or have a negative distance, which are an error
      otherwise; of a cloud with more points than `points_in_memory`, only what lies near features is kept in memory.

    Returns
    -------
    dict
        The value of each parameter under its name. None stands for what follows from the cloud.
    """
    return {name: None if name in _AUTOMATIC else value for name, value in _DEFAULTS.items()}


def paper_parameters() -> dict[str, Any]:
    """Return the parameters that give the published method, arXiv 2107.06165, to compare with.

    Returns
    -------
    dict
        What differs from the defaults: ``extract(points, distances, **paper_parameters())``.
    """
    return {name: value for name, value in _core.paper_parameters().items() if value != _DEFAULTS[name]}


def _unknown(function: str, name: str, named: Iterable[str]) -> TypeError:
    text = f"{function}() got an unexpected keyword argument '{name}'"
    near = difflib.get_close_matches(name.lower(), [other for other in named if other != "self"], 1, 0.6)
    if name in _HINTS and f"{name}s" not in near:
        return TypeError(f"{text}; {_HINTS[name]}")
    return TypeError(text + (f"; did you mean '{near[0]}'?" if near else "; default_parameters() has all parameters"))


def _as_integer(name: str, value: Any) -> int:
    return _numbers.integer(name, value, *_INTEGER_RANGES[name])


def _as_text(name: str, value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}; it has to be a text")
    if name in _CHOICES and value not in _CHOICES[name]:
        raise ValueError(f"{name} is {value!r}; it has to be one of {', '.join(map(repr, _CHOICES[name]))}")
    return value


def _as_boolean(name: str, value: Any) -> bool:
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {value!r}; it has to be True or False")
    return bool(value)


def _as_names(name: str, value: Any) -> list[str]:
    names = [] if isinstance(value, str) else list(value)
    if len(names) != 3 or not all(isinstance(text, str) and text for text in names) or len(set(names)) != 3:
        raise ValueError(f"{name} is {value!r}; it has to be three different names, of x, y and z")
    return names


_CONVERSIONS: dict[type, Callable[[str, Any], Any]] = {
    int: _as_integer,
    float: _numbers.real,
    str: _as_text,
    bool: _as_boolean,
    tuple: _as_names,
}


def checked(function: Callable[..., Any], given: Mapping[str, Any], known: Mapping[str, type]) -> dict[str, Any]:
    """Return the parameters that are given, as plain values.

    Parameters
    ----------
    function
        Who was called, for messages: its name, and its signature as `listed()` makes it.
    given
        The parameters. Those that are None have their defaults.
    known
        The type of each parameter that there is.

    Raises
    ------
    TypeError
        If there is no such parameter, or its type is another one.
    ValueError
        If it cannot have this value. Of numbers, the library looks at the ranges.
    """
    result = {}
    for name, value in given.items():
        if name not in known:
            who = function.__qualname__.replace(".__init__", "")
            raise _unknown(who, name, inspect.signature(function).parameters)
        if value is None:
            continue
        result[name] = _CONVERSIONS[known[name]](name, value)
        if name in _AUTOMATIC and result[name] < 0.0:
            raise ValueError(f"{name} is {result[name]}; it has to be at least 0, or None to follow from the cloud")
    return result


def checked_threads(threads: Any) -> int:
    """Return a number of threads; 0 and None stand for as many as there are."""
    return 0 if threads is None else _numbers.integer("threads", threads, 0, 1024)


def checked_progress(progress: Any) -> Any:
    """Return what is to be called with the share that is done, or None."""
    if progress is not None and not callable(progress):
        raise TypeError(f"progress is {progress!r}; it has to be a function of the share that is done, from 0 to 1")
    return progress
