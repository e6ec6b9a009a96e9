from typing import Any, Literal, NamedTuple, Sequence

from ._curve import Array
from ._types import Flag, Integer, Path, Real

class _Pair(NamedTuple):
    points: Array
    distances: Array | None

class Cloud(_Pair):
    note: str
    number_of_skipped_points: int

def input_of(paths: Any, distances: Any, reading: dict[str, Any]) -> dict[str, Any]: ...
def files_of(values: dict[str, Any]) -> list[bytes]: ...
def read_cloud(
    path: Path | Sequence[Path],
    distances: Path | None = ...,
    *,
    # OF_CLOUDS
    field: Literal["auto", "given", "estimated"] | None = ...,
    input_format: str | None = ...,
    coordinate_properties: Sequence[str] | None = ...,
    distance_property: str | None = ...,
    points_dataset: str | None = ...,
    distances_dataset: str | None = ...,
    indices_dataset: str | None = ...,
    clamp_negative: Flag | None = ...,
    use_indices: Flag | None = ...,
    patches: Flag | None = ...,
    fusion: Literal["minimum", "median"] | None = ...,
    mesh: Literal["auto", "cad", "scan"] | None = ...,
    maximum_facet_fold: Real | None = ...,
    maximum_number_of_points: Integer | None = ...,
    use_boundaries: Flag | None = ...,
    sampling_distance: Real | None = ...,
    minimum_fold: Real | None = ...,
    skip_invalid: Flag | None = ...,
) -> Cloud: ...
