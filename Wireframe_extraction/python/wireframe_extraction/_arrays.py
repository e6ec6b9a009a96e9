"""Checks what is given as arrays, and copies only what cannot be read as it is."""

from __future__ import annotations

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
        raise TypeError(f"{name} has the dtype {array.dtype}; it has to be real numbers, such as float32 or float64")
    return array


def _as_floats(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return the array as it is if it has native float32 or float64, else as float64."""
    is_float = array.dtype in (np.float32, np.float64) and array.dtype.isnative
    return array if is_float else array.astype(np.float64)


def _shape_hint(shape: tuple[int, ...]) -> str:
    """Return what may have been meant by an array that is no list of points."""
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
    array = _as_numbers(name, values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}; it has to be (n, 3){_shape_hint(array.shape)}")
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
    array = points(values, "normals")
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
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError(f"faces has the dtype {array.dtype}; it has to be integers, the indices of points. Faces with "
                        f"different numbers of corners have to be cut into triangles")
    if array.ndim != 2 or array.shape[1] < 3:
        raise ValueError(f"faces has the shape {array.shape}; it has to be (m, 3), three indices of points for each "
                         f"face")
    is_bad = ((array < 0) | (array >= number_of_vertices)).any(axis=1)
    if is_bad.any():
        face = int(np.argmax(is_bad))
        raise ValueError(f"faces[{face}] is {array[face].tolist()}; there are only the points 0 to "
                         f"{number_of_vertices - 1}")
    return np.ascontiguousarray(array, dtype=np.int64)
