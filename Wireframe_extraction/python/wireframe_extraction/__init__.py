"""Parametric wireframes from point clouds: arrays in, lines, circles, ellipses and B-splines out.

>>> import wireframe_extraction
>>> points, distances = wireframe_extraction.read_cloud("cloud.ply")
>>> wireframe = wireframe_extraction.extract(points, distances)
>>> wireframe.write("part.step")

Everything is in the unit of the points. The page "Python" of the manual has recipes.
"""

from ._batch import extract_many
from ._clouds import Cloud, read_cloud
from ._core import __version__
from ._curve import Closest, Curve
from ._evaluation import evaluate
from ._extraction import Field, estimate_distances, extract
from ._files import read
from ._parameters import default_parameters, paper_parameters
from ._report import ExtractionWarning, Report
from ._stages import Corner, Extractor, Feet, Graph, Skeleton
from ._wireframe import Wireframe

__all__ = [
    "Closest",
    "Cloud",
    "Corner",
    "Curve",
    "ExtractionWarning",
    "Extractor",
    "Feet",
    "Field",
    "Graph",
    "Report",
    "Skeleton",
    "Wireframe",
    "__version__",
    "default_parameters",
    "estimate_distances",
    "evaluate",
    "extract",
    "extract_many",
    "paper_parameters",
    "read",
    "read_cloud",
]
