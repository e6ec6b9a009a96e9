"""Files of wireframes."""

from __future__ import annotations

import errno
import os
from typing import TYPE_CHECKING, Any

from . import _core
from ._curve import checked_step

if TYPE_CHECKING:
    from ._wireframe import Wireframe

_CAD = (".step", ".stp", ".iges", ".igs", ".brep")
_OTHERS = (".json", ".dxf", ".obj", ".ply", ".vtp", ".gltf", ".glb", ".svg", ".csv", ".txt", ".cgal")
_UNITS = ("um", "mm", "cm", "m", "in", "ft")


def existing(path: Any) -> bytes:
    """Return the name of a file that there is.

    Raises
    ------
    FileNotFoundError
        If there is none.
    """
    name = os.fspath(path)
    if not os.path.exists(name):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), name)
    return os.fsencode(name)


def read(path: Any) -> Wireframe:
    """Read a wireframe.

    Parameters
    ----------
    path : path-like
        The name of a file of wireframe JSON, as `Wireframe.write()` and the tool write it.

    Returns
    -------
    Wireframe
        The wireframe. It has no report.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If it is no valid wireframe; the message says where, and why.
    """
    from ._wireframe import Wireframe

    return Wireframe(_core.read(existing(path)))


def _write_cad(wireframe: Wireframe, path: bytes, extension: str, unit: str, schema: str) -> None:
    try:
        from . import _cad
    except ImportError as error:
        raise ImportError(f"{extension} needs OpenCASCADE, without which this module was built or which cannot be "
                          f"loaded (Debian: libocct-data-exchange-dev): {error}") from None
    _cad.write(wireframe._core, path, extension, unit, schema)


def _write_text(name: str, text: str) -> None:
    """Write a file as a whole, or not at all."""
    beside = f"{name}.{os.getpid()}.tmp"
    try:
        with open(beside, "w", encoding="utf-8") as stream:
            stream.write(text)
        os.replace(beside, name)
    except OSError:
        if os.path.exists(beside):
            os.remove(beside)
        raise


def write(wireframe: Wireframe, path: Any, unit: str, step: float | None, obj_splines: bool, schema: str) -> None:
    """Write a wireframe into a file. See `Wireframe.write()`."""
    name = os.fspath(path)
    extension = os.path.splitext(os.fsdecode(name))[1].lower()
    if extension not in (*_CAD, *_OTHERS, ".html"):
        raise ValueError(f"{name}: unknown extension {extension!r} of a wireframe; known are "
                         f"{', '.join((*_CAD, *_OTHERS, '.html'))}")
    if unit not in _UNITS:
        raise ValueError(f"unit is {unit!r}; it has to be one of {', '.join(_UNITS)}")
    if schema not in ("ap214", "ap242"):
        raise ValueError(f"schema is {schema!r}; it has to be 'ap214' or 'ap242'")
    problem = wireframe._core.problem()
    if problem:
        raise ValueError(f"the wireframe is not valid: {problem}")
    if extension == ".html":
        text = wireframe.to_html(title=os.path.basename(os.fsdecode(name)), unit=unit)
        _write_text(os.fsdecode(name), text)
        return
    length = sum(curve.length for curve in wireframe.curves)
    checked = 0.0 if step is None else checked_step(step, length)
    try:
        if extension in _CAD:
            _write_cad(wireframe, os.fsencode(name), extension, unit, schema)
        else:
            _core.write(wireframe._core, os.fsencode(name), unit, checked, bool(obj_splines))
    except ValueError as error:   # all that could be wrong with the arguments is looked at above
        raise OSError(str(error)) from None
