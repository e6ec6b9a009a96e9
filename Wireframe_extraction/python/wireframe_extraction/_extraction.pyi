from typing import Any, Callable, Literal, NamedTuple, Sequence

import numpy.typing as npt

from ._curve import Array
from ._report import Report
from ._types import Flag, Integer, Path, Progress, Real
from ._wireframe import Wireframe

class Field(NamedTuple):
    distances: Array
    deviations: Array

def extract(
    points: npt.ArrayLike | Path | Sequence[Path],
    distances: npt.ArrayLike | Path | None = ...,
    *,
    faces: npt.ArrayLike | None = ...,
    normals: npt.ArrayLike | None = ...,
    threads: Integer | None = ...,
    progress: Progress | None = ...,
    # EXTRACTION
    sampling_distance: Real | None = ...,
    points_in_memory: Integer | None = ...,
    skip_invalid: Flag | None = ...,
    minimum_fold: Real | None = ...,
    noise_level: Real | None = ...,
    skeleton_distance: Real | None = ...,
    support_distance: Real | None = ...,
    fitting_radius: Real | None = ...,
    use_creases: Flag | None = ...,
    corner_measure: Literal["field-residual", "variance"] | None = ...,
    corner_sampling_ratio: Real | None = ...,
    corner_radius: Real | None = ...,
    corner_variance: Real | None = ...,
    corner_residual: Real | None = ...,
    connection_radius: Real | None = ...,
    connection_angle: Real | None = ...,
    use_tangents: Flag | None = ...,
    graph_method: Literal["traced", "subdivided"] | None = ...,
    end_detection: Literal["graph-distance", "main-axis"] | None = ...,
    split_threshold: Real | None = ...,
    corner_reach: Real | None = ...,
    maximum_gap: Real | None = ...,
    smooth_angle: Real | None = ...,
    minimum_evidence: Real | None = ...,
    use_robust_loss: Flag | None = ...,
    move_corners: Flag | None = ...,
    adapt_knots: Flag | None = ...,
    number_of_rounds: Integer | None = ...,
    recognize_types: Flag | None = ...,
    type_significance: Real | None = ...,
    regularize: Flag | None = ...,
    # MESH
    mesh: Literal["auto", "cad", "scan"] | None = ...,
    maximum_facet_fold: Real | None = ...,
    maximum_number_of_points: Integer | None = ...,
    use_boundaries: Flag | None = ...,
    # READING
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
) -> Wireframe: ...
def extracted(function: Callable[..., Any], points: Any, distances: Any, faces: Any, normals: Any, threads: Any,
              progress: Any, parameters: dict[str, Any]) -> tuple[Wireframe, Report]: ...
def estimate_distances(
    points: npt.ArrayLike,
    *,
    threads: Integer | None = ...,
    progress: Progress | None = ...,
    # SHARED
    sampling_distance: Real | None = ...,
    minimum_fold: Real | None = ...,
    skip_invalid: Flag | None = ...,
) -> Field: ...
