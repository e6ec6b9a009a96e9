from typing import Iterable, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from ._curve import Array
from ._report import Report
from ._types import Flag, Integer, Progress, Real
from ._wireframe import Wireframe

Indices = npt.NDArray[np.int64]

class Skeleton(NamedTuple):
    points: Array
    distances: Array
    indices: Indices

class Feet(NamedTuple):
    points: Array
    tangents: Array
    residuals: Array
    noise: float

class Corner(NamedTuple):
    center: Array
    radius: float
    members: Indices

class Graph(NamedTuple):
    vertices: Array
    are_corners: npt.NDArray[np.bool_]
    edges: Indices
    curves: Indices

class Extractor:
    def __init__(
        self,
        points: npt.ArrayLike,
        distances: npt.ArrayLike | None = ...,
        *,
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
    ) -> None: ...
    @property
    def report(self) -> Report: ...
    @property
    def sampling_distance(self) -> float: ...
    @property
    def distances(self) -> npt.NDArray[np.float32] | Array: ...
    @property
    def skeleton(self) -> Skeleton: ...
    @property
    def feet(self) -> Feet: ...
    @property
    def corners(self) -> list[Corner]: ...
    @corners.setter
    def corners(self, corners: Iterable[tuple[npt.ArrayLike, Real, npt.ArrayLike] | Corner]) -> None: ...
    @property
    def clusters(self) -> list[Indices]: ...
    @clusters.setter
    def clusters(self, clusters: Iterable[npt.ArrayLike]) -> None: ...
    @property
    def graph(self) -> Graph: ...
    @property
    def curves(self) -> Wireframe: ...
    @property
    def wireframe(self) -> Wireframe: ...
