"""Checks what is given as arrays, and copies only what cannot be read as it is."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import numpy.typing as npt


def _as_numbers(name: str, values: Any) -> npt.NDArray[Any]:
    """Return an array of real numbers, without a copy if it is one."""
    if values is None:
        raise TypeError(f"{name} is None; give an array of numbers")
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        raise ValueError(f"{name} is a masked array, and some of it is masked; leave these rows out, or fill them with "
                         f"nan and give skip_invalid=True")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} is no array of numbers: {error}") from None
    if array.dtype.names:
        fields = ", ".join(array.dtype.names)
        raise ValueError(f"{name} is a structured array with the fields {fields}; put its columns side by side with "
                         f"numpy.column_stack")
    if array.dtype.kind not in "fiu":
        remedy = "; give .to_numpy(float)" if hasattr(values, "to_numpy") else ""
        raise TypeError(f"{name} has the dtype {array.dtype}; it has to be real numbers, such as float32 or "
                        f"float64{remedy}")
    return array


def _as_floats(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return the array as it is if it has native float32 or float64, else as float64."""
    is_float = array.dtype in (np.float32, np.float64) and array.dtype.isnative
    return array if is_float else array.astype(np.float64)


def is_pair(values: Any) -> bool:
    """Return whether it is a tuple of points, and of distances or None, as `read_cloud()` returns it."""
    if not isinstance(values, tuple) or len(values) != 2 or values[0] is None:
        return False
    points, distances = values
    return len(np.shape(points)) == 2 and (distances is None or np.shape(distances) == np.shape(points)[:1])


def _shape_hint(values: Any, shape: tuple[int, ...]) -> str:
    """Return what may have been meant by an array that is no list of points."""
    if len(shape) == 2 and shape[1] > 3 and hasattr(values, "iloc"):
        return "; give the columns with x, y and z, perhaps .iloc[:, :3]"
    if len(shape) == 2 and shape[0] == 3:
        return "; give its transpose, .T"
    if len(shape) == 2 and shape[1] == 4:
        return "; if the last column has the distances, give [:, :3] and [:, 3]"
    if len(shape) == 2 and shape[1] > 4:
        return "; give the columns with x, y and z, perhaps [:, :3]"
    if len(shape) == 3 and shape[2] == 3:
        return "; give .reshape(-1, 3)"
    return ""


def points(values: Any, name: str = "points") -> npt.NDArray[Any]:
    """Return points as an (n, 3) array of float32 or float64, without a copy if it is one."""
    if isinstance(values, (str, bytes, os.PathLike)):
        raise TypeError(f"{name} is {values!r}; give an array of numbers, of a file that of read_cloud({values!r})")
    if is_pair(values):
        raise TypeError(f"{name} is a pair of points and distances; give both, for instance by a star: extract(*cloud)")
    array = _as_numbers(name, values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}; it has to be (n, 3){_shape_hint(values, array.shape)}")
    return _as_floats(array)


def distances(values: Any, number_of_points: int) -> npt.NDArray[Any] | None:
    """Return distances as an (n,) array of float32 or float64, without a copy if it is one; None stays None."""
    if values is None:
        return None
    array = _as_numbers("distances", values)
    if array.ndim == 2 and array.shape[1] == 1:
        array = array[:, 0]
    if array.ndim != 1:
        raise ValueError(f"distances has the shape {array.shape}; it has to be (n,), a number for each point")
    if len(array) != number_of_points:
        raise ValueError(f"distances has {len(array)} numbers for {number_of_points} points; give one for each point")
    return _as_floats(array)


def check_normals(values: Any, number_of_points: int) -> None:
    """Refuse normals that are none: a mistake in a call is one, too, where what is given is not used."""
    if values is None:
        return
    array = finite_points(values, "normals")
    if len(array) != number_of_points:
        raise ValueError(f"normals has {len(array)} rows for {number_of_points} points; give one for each point")


def finite_points(values: Any, name: str = "points") -> npt.NDArray[Any]:
    """Return points that are all finite; a single point of shape (3,) becomes a row."""
    array = _as_numbers(name, values)
    if array.shape == (3,):
        array = array[np.newaxis]
    array = points(array, name)
    is_bad = ~np.isfinite(array).all(axis=1)
    if is_bad.any():
        raise ValueError(f"{name}[{int(np.argmax(is_bad))}] is not finite; leave such points out")
    return array


def finite_numbers(values: Any, name: str) -> npt.NDArray[np.float64]:
    """Return numbers of any shape as float64."""
    array = _as_numbers(name, values).astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{name} has a number that is not finite")
    return array


def faces(values: Any, number_of_vertices: int) -> npt.NDArray[np.int64]:
    """Return the faces of a mesh as an (m, k) array of indices."""
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        raise ValueError("faces is a masked array, and some of it is masked; leave these faces out")
    try:
        array = np.asarray(values)
    except ValueError:   # lists of different lengths
        array = np.empty(0, dtype=object)
    if array.dtype.kind == "O":
        raise ValueError("faces have different numbers of corners; cut them into triangles")
    if array.size == 0:
        raise ValueError("faces is empty; a mesh has faces")
    if array.dtype.kind not in "iu":
        raise TypeError(f"faces has the dtype {array.dtype}; it has to be integers, the indices of points")
    if array.ndim != 2 or array.shape[1] < 3:
        raise ValueError(f"faces has the shape {array.shape}; it has to be (m, 3), three indices of points for each "
                         f"face{_flat_hint(array)}")
    is_bad = ((array < 0) | (array >= number_of_vertices)).any(axis=1)
    if is_bad.any():
        face = int(np.argmax(is_bad))
        raise ValueError(f"faces[{face}] is {array[face].tolist()}; there are only the points 0 to "
                         f"{number_of_vertices - 1}")
    if _are_counted(array):
        raise ValueError(f"faces has the number of corners, {array.shape[1] - 1}, in its first column, as PyVista and "
                         f"VTK have it; give [:, 1:]")
    return np.ascontiguousarray(array, dtype=np.int64)


def _are_counted(array: npt.NDArray[Any]) -> bool:
    """Return whether the first column has the number of the others.

    Faces around one vertex may have its index there. But no face has a vertex twice: then it is nowhere else.
    """
    count = array.shape[1] - 1
    return bool(count >= 3 and (array[:, 0] == count).all() and (array[:, 1:] == count).any())


def _flat_hint(array: npt.NDArray[Any]) -> str:
    """Return what is to be done with the list of PyVista: the number of corners and the corners of each face."""
    width = int(array[0]) + 1 if array.ndim == 1 else 0
    is_list = width > 3 and array.size % width == 0 and (array[::width] == width - 1).all()
    return f"; give .reshape(-1, {width})[:, 1:]" if is_list else ""
