from os import PathLike
from typing import Any, Literal, NamedTuple, Sequence

from ._curve import Array

_Path = str | PathLike[str]

class Cloud(NamedTuple):
    points: Array
    distances: Array | None

def input_of(paths: Any, distances: Any, reading: dict[str, Any]) -> dict[str, Any]: ...
def read_cloud(
    path: _Path | Sequence[_Path],
    distances: _Path | None = ...,
    *,
    field: Literal["auto", "given", "estimated"] | None = ...,
    distance_property: str | None = ...,
    points_dataset: str | None = ...,
    distances_dataset: str | None = ...,
    indices_dataset: str | None = ...,
    use_indices: bool | None = ...,
    patches: bool | None = ...,
    fusion: Literal["minimum", "median"] | None = ...,
    mesh: Literal["auto", "cad", "scan"] | None = ...,
    maximum_facet_fold: float | None = ...,
    maximum_number_of_points: int | None = ...,
    use_boundaries: bool | None = ...,
    sampling_distance: float | None = ...,
    minimum_fold: float | None = ...,
    skip_invalid: bool | None = ...,
) -> Cloud: ...
