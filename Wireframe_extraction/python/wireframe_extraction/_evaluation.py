"""How well a wireframe agrees with the true one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core, _files
from ._wireframe import Wireframe

if TYPE_CHECKING:
    from ._types import Path


def evaluate(truth: Wireframe | Path, wireframe: Wireframe) -> dict[str, Any]:
    """Compare a wireframe with the true one, or with another one.

    Parameters
    ----------
    truth : Wireframe or path-like
        The true wireframe, or the name of a file: `truth.json` as the generators of this project write it, or a
        wireframe in JSON. A wireframe needs a positive `sampling_distance`, which is the unit of all tolerances.
    wireframe : Wireframe
        The wireframe that is judged.

    Returns
    -------
    dict
        The scores of the program `evaluate_wireframe`, `chamfer_distance`, `curve_f1` and so on, under their names:
        lengths in the unit of the cloud, shares from 0 to 1, nan where a score does not apply. `failure` says why the
        wireframe is no usable result, and is None if it is one.

    Raises
    ------
    OSError
        If there is no such file (FileNotFoundError), or it may not be read.
    ValueError
        If the truth is none.
    """
    if not isinstance(wireframe, Wireframe):
        raise TypeError(f"wireframe is {type(wireframe).__name__}; it has to be a Wireframe, as extract() gives it")
    prediction = _core.to_json(wireframe._core)
    if not isinstance(truth, Wireframe):
        path = _files.existing(truth)
        try:
            return _core.evaluate(path, False, prediction)
        except ValueError as error:
            try:
                truth = _files.read(truth)   # it may be the file of a wireframe
            except ValueError:
                raise error from None
    if not truth.curves:
        raise ValueError("truth has no curve; there is nothing to compare with")
    if not truth.sampling_distance > 0.0:
        raise ValueError("truth has no sampling_distance, which is the unit of the tolerances")
    return _core.evaluate(_core.to_json(truth._core), True, prediction)
