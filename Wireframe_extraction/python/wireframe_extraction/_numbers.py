"""Checks single numbers."""

from __future__ import annotations

import math
import operator
from typing import Any

import numpy as np


def integer(name: str, value: Any, least: int, most: int) -> int:
    """Return an integer.

    Raises
    ------
    TypeError
        If it is none.
    ValueError
        If it is out of its range.
    """
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {value!r}; it has to be an integer")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; it has to be an integer") from None
    if not least <= number <= most:
        raise ValueError(f"{name} is {number}; it has to be from {least} to {most}")
    return number


def real(name: str, value: Any) -> float:
    """Return a finite number.

    Raises
    ------
    TypeError
        If it is no number.
    ValueError
        If it is not finite.
    """
    if isinstance(value, (bool, np.bool_, str, bytes)):
        raise TypeError(f"{name} is {value!r}; it has to be a number")
    try:
        number = float(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; it has to be a number") from None
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise ValueError(f"{name} is {number}; it has to be finite")
    return number
