from os import PathLike
from typing import Callable, Literal, NamedTuple, Sequence

import numpy.typing as npt

from ._curve import Array
from ._wireframe import Wireframe

_Path = str | PathLike[str]
_Progress = Callable[[float], object] | None

class Field(NamedTuple):
    distances: Array
    deviations: Array

def extract(
    points: npt.ArrayLike | _Path | Sequence[_Path],
    distances: npt.ArrayLike | _Path | None = ...,
    *,
    faces: npt.ArrayLike | None = ...,
    normals: npt.ArrayLike | None = ...,
    threads: int = ...,
    progress: _Progress = ...,
    sampling_distance: float | None = ...,
    minimum_fold: float | None = ...,
    noise_level: float | None = ...,
    skeleton_distance: float | None = ...,
    support_distance: float | None = ...,
    fitting_radius: float | None = ...,
    use_creases: bool | None = ...,
    corner_measure: Literal["field-residual", "variance"] | None = ...,
    corner_sampling_ratio: float | None = ...,
    corner_radius: float | None = ...,
    corner_variance: float | None = ...,
    corner_residual: float | None = ...,
    connection_radius: float | None = ...,
    connection_angle: float | None = ...,
    use_tangents: bool | None = ...,
    graph_method: Literal["traced", "subdivided"] | None = ...,
    end_detection: Literal["graph-distance", "main-axis"] | None = ...,
    split_threshold: float | None = ...,
    corner_reach: float | None = ...,
    maximum_gap: float | None = ...,
    smooth_angle: float | None = ...,
    minimum_evidence: float | None = ...,
    use_robust_loss: bool | None = ...,
    move_corners: bool | None = ...,
    adapt_knots: bool | None = ...,
    number_of_rounds: int | None = ...,
    recognize_types: bool | None = ...,
    type_significance: float | None = ...,
    regularize: bool | None = ...,
    skip_invalid: bool | None = ...,
    points_in_memory: int | None = ...,
    # of meshes
    mesh: Literal["auto", "cad", "scan"] | None = ...,
    maximum_facet_fold: float | None = ...,
    maximum_number_of_points: int | None = ...,
    use_boundaries: bool | None = ...,
    # of files
    field: Literal["auto", "given", "estimated"] | None = ...,
    distance_property: str | None = ...,
    points_dataset: str | None = ...,
    distances_dataset: str | None = ...,
    indices_dataset: str | None = ...,
    use_indices: bool | None = ...,
    patches: bool | None = ...,
    fusion: Literal["minimum", "median"] | None = ...,
) -> Wireframe: ...
def estimate_distances(
    points: npt.ArrayLike,
    *,
    threads: int = ...,
    progress: _Progress = ...,
    sampling_distance: float | None = ...,
    minimum_fold: float | None = ...,
    skip_invalid: bool = ...,
) -> Field: ...
