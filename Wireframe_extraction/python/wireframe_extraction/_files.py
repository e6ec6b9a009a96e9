"""Files of wireframes."""

from __future__ import annotations

import errno
import os
import stat
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core, _numbers
from ._curve import checked_step
from ._messages import as_text

if TYPE_CHECKING:
    from ._types import Path
    from ._wireframe import Wireframe

_CAD = (".step", ".stp", ".iges", ".igs", ".brep")
_OTHERS = (".json", ".dxf", ".obj", ".ply", ".vtp", ".gltf", ".glb", ".svg", ".csv", ".txt", ".cgal")
_POLYLINES = (".obj", ".ply", ".vtp", ".gltf", ".glb", ".txt", ".cgal")
_UNITS = ("um", "mm", "cm", "m", "in", "ft")


def existing(path: Any) -> bytes:
    """Return the name of a file that there is, and that may be read.

    Raises
    ------
    OSError
        As of `open()`: FileNotFoundError, PermissionError, IsADirectoryError.
    """
    name = os.fspath(path)
    try:
        mode = os.stat(name).st_mode
    except ValueError:   # a null character
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), name) from None
    if stat.S_ISREG(mode) or stat.S_ISDIR(mode):   # what a pipe has can be read once only
        open(name, "rb").close()
    return os.fsencode(name)


def read(path: Path) -> Wireframe:
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
    OSError
        If there is no such file (FileNotFoundError), or it may not be read.
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


def _write_text(name: Any, text: str) -> None:
    """Write a file as a whole, or not at all."""
    beside = f"{os.fsdecode(name)}.{os.getpid()}.tmp"
    try:
        with open(beside, "w", encoding="utf-8") as stream:
            stream.write(text)
        os.replace(beside, name)
    except OSError as error:
        if os.path.exists(beside):
            os.remove(beside)
        raise OSError(error.errno, error.strerror, name) from None   # of the file that was asked for


def _os_error(message: str, name: Any) -> OSError:
    """Return what the system says about a file that could not be written; it is in the message of the writer."""
    if os.path.isdir(name):
        return IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), name)
    for code in errno.errorcode:
        if message.endswith(os.strerror(code)):
            return OSError(code, os.strerror(code), name)
    return OSError(errno.EIO, message, name)


def _check_arguments(name: Any, extension: str, unit: Any, step: Any, chord_tolerance: Any, splines: dict[str, Any],
                     schema: Any) -> None:
    """Refuse what is wrong, and what has no effect on a format."""
    if extension not in (*_CAD, *_OTHERS, ".html"):
        raise ValueError(f"{as_text(name)}: unknown extension {extension!r} of a wireframe; known are "
                         f"{', '.join((*_CAD, *_OTHERS, '.html'))}")
    check_unit(unit)
    for what, value in splines.items():
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{what} is {value!r}; it has to be True or False")
    if schema not in ("ap214", "ap242"):
        raise ValueError(f"schema is {schema!r}; it has to be 'ap214' or 'ap242'")
    for what, is_given, formats in (("step", step is not None, _POLYLINES),
                                    ("chord_tolerance", chord_tolerance is not None, _POLYLINES),
                                    ("obj_splines", splines["obj_splines"], (".obj",)),
                                    ("dxf_splines", splines["dxf_splines"], (".dxf",)),
                                    ("schema", schema != "ap214", (".step", ".stp"))):
        if is_given and extension not in formats:
            raise ValueError(f"{what} has no effect on {extension}; it goes with {', '.join(formats)}")


def checked_tolerance(chord_tolerance: Any) -> float:
    """Return a positive tolerance, or raise ValueError."""
    number = _numbers.real("chord_tolerance", chord_tolerance)
    if not number > 0.0:
        raise ValueError(f"chord_tolerance is {number}; it has to be positive")
    return number


def check_unit(unit: Any) -> None:
    """Refuse what is no unit of length."""
    if unit not in _UNITS:
        raise ValueError(f"unit is {unit!r}; it has to be one of {', '.join(_UNITS)}")


def write(wireframe: Wireframe, path: Any, unit: Any, step: Any, chord_tolerance: Any, obj_splines: Any,
          dxf_splines: Any, schema: str) -> None:
    """Write a wireframe into a file. See `Wireframe.write()`."""
    name = os.fspath(path)
    extension = os.path.splitext(os.fsdecode(name))[1].lower()
    _check_arguments(name, extension, unit, step, chord_tolerance,
                     {"obj_splines": obj_splines, "dxf_splines": dxf_splines}, schema)
    problem = wireframe._core.problem()
    if problem:
        raise ValueError(f"the wireframe is not valid: {problem}")
    if extension in _CAD and not wireframe.curves:
        raise ValueError(f"the wireframe has no curve, of which {extension} could have something")
    if extension == ".html":
        _write_text(name, wireframe.to_html(title=as_text(os.path.basename(name)), unit=unit))
        return
    length = sum(curve.length for curve in wireframe.curves)
    checked = 0.0 if step is None else checked_step(step, length)
    tolerance = 0.0 if chord_tolerance is None else checked_tolerance(chord_tolerance)
    try:
        if extension in _CAD:
            _write_cad(wireframe, os.fsencode(name), extension, unit, schema)
        else:
            _core.write(wireframe._core, os.fsencode(name), unit, checked, tolerance, bool(obj_splines), bool(dxf_splines))
    except ValueError as error:   # all else that could be wrong with the arguments is looked at above
        if "give a larger chord_tolerance" in str(error):
            raise
        raise _os_error(str(error), name) from None
