"""What functions take, for type checkers only."""

from os import PathLike
from typing import Callable, Literal, SupportsFloat, SupportsIndex

import numpy as np

Path = str | bytes | PathLike[str] | PathLike[bytes]
Real = SupportsFloat
Integer = SupportsIndex
Flag = bool | np.bool_
Progress = Callable[[float], object]
Unit = Literal["um", "mm", "cm", "m", "in", "ft"]
